// SPDX-License-Identifier: BSD-3-Clause
#include "coarsest.hpp"

#include <Teuchos_LAPACK.hpp>

namespace abut::multigrid {

template <int N>
Coarsest::Coarsest(const BlockMatrix<float, N, N>& a, const Distribution& rows)
    : comm_(rows.comm()), width_(N), stride_(padded(N)),
      begin_(static_cast<std::size_t>(rows.first()[std::size_t(rows.comm().rank())]) * N),
      owned_(static_cast<std::size_t>(a.rows) * N),
      size_(static_cast<std::size_t>(rows.total()) * N) {
  std::vector<double> mine(owned_ * size_, 0.0);
  for (Local i = 0; i < a.rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      for (int c = 0; c < N; ++c)
        for (int r = 0; r < N; ++r)
          mine[(static_cast<std::size_t>(i) * N + std::size_t(r)) * size_ +
               static_cast<std::size_t>(rows.global(a.column(k))) * N + std::size_t(c)] =
              a.block(k)[c * N + r];
  const std::vector<double> by_rows = comm_->all_gather(mine);
  factors_.resize(size_ * size_);
  for (std::size_t r = 0; r < size_; ++r)
    for (std::size_t c = 0; c < size_; ++c)
      factors_[c * size_ + r] = by_rows[r * size_ + c];
  factor();
}

void Coarsest::factor() {
  const int n = static_cast<int>(size_);
  pivots_.resize(size_);
  int info = 0;
  if (n > 0)
    Teuchos::LAPACK<int, double>().GETRF(n, n, factors_.data(), n, pivots_.data(), &info);
  for (std::size_t i = 0; i < size_; ++i)
    if (factors_[i * size_ + i] == 0.0) // a direction that no coarse vector has
      factors_[i * size_ + i] = 1.0;
}

void Coarsest::solve(const float* b, float* x) const {
  std::vector<double> mine(owned_);
  const auto at = [&](std::size_t i) {
    return i / std::size_t(width_) * std::size_t(stride_) + i % std::size_t(width_);
  };
  for (std::size_t i = 0; i < owned_; ++i)
    mine[i] = b[at(i)];
  std::vector<double> all = comm_->all_gather(mine);
  const int n = static_cast<int>(size_);
  int info = 0;
  if (n > 0)
    Teuchos::LAPACK<int, double>().GETRS('N', n, 1, factors_.data(), n, pivots_.data(), all.data(),
                                         n, &info);
  for (std::size_t i = 0; i < owned_; ++i)
    x[at(i)] = static_cast<float>(all[begin_ + i]);
}

template Coarsest::Coarsest(const BlockMatrix<float, 1, 1>&, const Distribution&);
template Coarsest::Coarsest(const BlockMatrix<float, 2, 2>&, const Distribution&);
template Coarsest::Coarsest(const BlockMatrix<float, 3, 3>&, const Distribution&);
template Coarsest::Coarsest(const BlockMatrix<float, 4, 4>&, const Distribution&);
template Coarsest::Coarsest(const BlockMatrix<float, 6, 6>&, const Distribution&);
template Coarsest::Coarsest(const BlockMatrix<float, 7, 7>&, const Distribution&);

} // namespace abut::multigrid
