// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/multigrid/block_matrix.hpp"

#include <algorithm>

namespace abut::multigrid {

/// c += a b, dense blocks by columns.
template <class T, int R, int K, int C>
KOKKOS_INLINE_FUNCTION void add_block_product(const T* a, const T* b, T* c) {
  for (int j = 0; j < C; ++j, b += K, c += R) {
    auto sum = Pack<T, R>::load(c);
    add_product<T, R, K>(a, b, sum);
    sum.store_column(c);
  }
}

/// Adds a row of A B to C, which has its places. To be run on one thread.
template <class T, int R, int K, int C> struct ProductRow {
  BlockMatrix<T, R, K> a;
  BlockMatrix<T, K, C> b;
  BlockMatrix<T, R, C> c;
  Local* place; ///< (columns) room for the blocks of a row

  void operator()(Local i) const {
    for (Local k = c.offset(i); k < c.offset(i + 1); ++k)
      place[c.column(k)] = k;
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      for (Local e = b.offset(a.column(k)); e < b.offset(a.column(k) + 1); ++e)
        add_block_product<T, R, K, C>(a.block(k), b.block(e), c.block(place[b.column(e)]));
  }
};

/// C = A B. columns: of B.
template <class T, int R, int K, int C>
BlockMatrix<T, R, C> product(const BlockMatrix<T, R, K>& a, const BlockMatrix<T, K, C>& b,
                             Local columns) {
  std::vector<Local> place(static_cast<std::size_t>(columns), -1), offset{0}, column;
  for (Local i = 0; i < a.rows; ++i) {
    const Local first = offset.back();
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      for (Local e = b.offset(a.column(k)); e < b.offset(a.column(k) + 1); ++e)
        if (Local& at = place[std::size_t(b.column(e))]; at < first) {
          at = static_cast<Local>(column.size());
          column.push_back(b.column(e));
        }
    std::sort(column.begin() + first, column.end());
    for (auto k = static_cast<std::size_t>(first); k < column.size(); ++k)
      place[std::size_t(column[k])] = static_cast<Local>(k);
    offset.push_back(static_cast<Local>(column.size()));
  }
  auto c = make_block_matrix<T, R, C>(offset, column);
  with_row_registers(ProductRow<T, R, K, C>{a, b, c, place.data()}, [&](const auto& row) {
    for (Local i = 0; i < a.rows; ++i)
      row(i);
  });
  return c;
}

/// columns: of A.
template <class T, int R, int C>
BlockMatrix<T, C, R> transpose(const BlockMatrix<T, R, C>& a, Local columns) {
  std::vector<Local> offset(static_cast<std::size_t>(columns) + 1, 0);
  for (Local k = 0; k < a.blocks(); ++k)
    ++offset[std::size_t(a.column(k)) + 1];
  for (std::size_t j = 1; j < offset.size(); ++j)
    offset[j] += offset[j - 1];
  auto t = make_block_matrix<T, C, R>(offset, std::vector<Local>(std::size_t(a.blocks())));
  for (Local i = 0; i < a.rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k) {
      const Local to = offset[std::size_t(a.column(k))]++;
      t.column(to) = i;
      for (int c = 0; c < C; ++c)
        for (int r = 0; r < R; ++r)
          t.block(to)[r * C + c] = a.block(k)[c * R + r];
    }
  return t;
}

} // namespace abut::multigrid
