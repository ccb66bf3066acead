// SPDX-License-Identifier: BSD-3-Clause
#include "fine_matrix.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>

namespace abut::multigrid {

template <int N> FineMatrix<N>::FineMatrix(const Comm& comm, const Matrix& matrix) {
  const Map& row_map = *matrix.getRowMap();
  ABUT_REQUIRE(local_size(row_map) % N == 0, "rows of a block lie on two ranks");
  const auto first = first_rows(comm, static_cast<Local>(local_size(row_map)) / N);
  const Distribution owned(comm, first, {});
  GhostList numbers(owned, false);
  const Map& columns = *matrix.getColMap();
  for (Local j = 0; j < static_cast<Local>(local_size(columns)); ++j) {
    const Global id = columns.getGlobalElement(j) - row_map.getIndexBase();
    block_column_.push_back(numbers.local(id / N));
    component_.push_back(static_cast<char>(id % N));
  }
  rows_.emplace(comm, first, numbers.ghosts());

  const auto local = matrix.getLocalMatrixHost();
  offset_.push_back(0);
  for (Local i = 0; i < owned.owned(); ++i) {
    const auto begin = column_.size();
    for (Local r = N * i; r < N * i + N; ++r)
      for (auto k = local.graph.row_map(r); k < local.graph.row_map(r + 1); ++k)
        if (local.graph.entries(k) == r || component_[std::size_t(local.graph.entries(k))] == 0)
          column_.push_back(block_column_[std::size_t(local.graph.entries(k))]);
    std::sort(column_.begin() + std::ptrdiff_t(begin), column_.end());
    column_.erase(std::unique(column_.begin() + std::ptrdiff_t(begin), column_.end()),
                  column_.end());
    offset_.push_back(static_cast<Local>(column_.size()));
  }
}

template <int N> BlockMatrix<float, N, N> FineMatrix<N>::blocks(const Matrix& matrix) const {
  auto a = make_block_matrix<float, N, N>(offset_, column_);
  const auto local = matrix.getLocalMatrixHost();
  std::vector<Local> place(static_cast<std::size_t>(rows_->size()), -1);
  for (Local i = 0; i < a.rows; ++i) {
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      place[std::size_t(a.column(k))] = k;
    for (Local r = 0; r < N; ++r)
      for (auto k = local.graph.row_map(N * i + r); k < local.graph.row_map(N * i + r + 1); ++k) {
        const auto j = static_cast<std::size_t>(local.graph.entries(k));
        const int c = component_[j];
        a.block(place[std::size_t(block_column_[j])])[c * N + r] =
            static_cast<float>(local.values(k));
      }
  }
  return a;
}

template <int N> std::vector<char> FineMatrix<N>::constrained(const BlockMatrix<float, N, N>& a) {
  std::vector<char> result(static_cast<std::size_t>(a.rows) * N, 1);
  for (Local i = 0; i < a.rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      for (int c = 0; c < N; ++c)
        for (int r = 0; r < N; ++r)
          if (a.block(k)[c * N + r] != 0.0F && !(a.column(k) == i && r == c))
            result[static_cast<std::size_t>(i) * N + std::size_t(r)] = 0;
  return result;
}

template class FineMatrix<1>;
template class FineMatrix<2>;
template class FineMatrix<3>;
template class FineMatrix<4>;

} // namespace abut::multigrid
