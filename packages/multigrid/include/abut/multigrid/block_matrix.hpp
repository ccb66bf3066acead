// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/core/views.hpp"

#include <cstddef>
#include <vector>

/// Sparse matrices of small dense blocks, and the kernels of the multigrid cycle on them.
namespace abut::multigrid {

/// Entries that a block row of n unknowns takes in a vector or in a column of a block: padded with
/// zeros to a register's width, which makes a product of a block one multiply-add per column.
constexpr int padded(int n) {
  return n <= 2 ? n : n <= 4 ? 4 : 8;
}

/// The unknowns of one block row.
template <class T, int N> struct Pack {
  static constexpr int width = padded(N);
  T value[width] = {};

  KOKKOS_INLINE_FUNCTION static Pack load(const T* from) {
    Pack p;
    for (int r = 0; r < width; ++r)
      p.value[r] = from[r];
    return p;
  }
  KOKKOS_INLINE_FUNCTION void store(T* to) const {
    for (int r = 0; r < width; ++r)
      to[r] = value[r];
  }
  /// this += factor * column, a column of a block.
  KOKKOS_INLINE_FUNCTION void add(T factor, const T* column) {
    for (int r = 0; r < width; ++r)
      value[r] += factor * column[r];
  }
  KOKKOS_INLINE_FUNCTION Pack operator-(const Pack& other) const {
    Pack p;
    for (int r = 0; r < width; ++r)
      p.value[r] = value[r] - other.value[r];
    return p;
  }
  KOKKOS_INLINE_FUNCTION Pack operator+(const Pack& other) const {
    Pack p;
    for (int r = 0; r < width; ++r)
      p.value[r] = value[r] + other.value[r];
    return p;
  }
};

/// block (R x C, by columns, each padded) times x.
template <class T, int R, int C>
KOKKOS_INLINE_FUNCTION void add_product(const T* block, const T* x, Pack<T, R>& sum) {
  for (int c = 0; c < C; ++c)
    sum.add(x[c], block + c * padded(R));
}

/// Block compressed sparse rows: row i has the blocks offset[i] .. offset[i+1]-1.
template <class T, int R, int C> struct BlockMatrix {
  static constexpr int block_size = padded(R) * C;

  Local rows = 0;
  View<Local> offset; ///< (rows+1)
  View<Local> column; ///< (blocks)
  View<T> value;      ///< (blocks, C, padded(R))

  KOKKOS_INLINE_FUNCTION T* block(Local k) const {
    return value.data() + static_cast<std::size_t>(k) * block_size;
  }
  Local blocks() const { return static_cast<Local>(column.size()); }
  std::size_t bytes() const {
    return value.size() * sizeof(T) + (column.size() + offset.size()) * sizeof(Local);
  }

  /// Row i of the matrix times x, (columns, padded(C)).
  KOKKOS_INLINE_FUNCTION Pack<T, R> row_product(Local i, const T* x) const {
    Pack<T, R> even, odd; // two sums hide the latency of the additions
    const Local end = offset(i + 1);
    Local k = offset(i);
    for (; k + 1 < end; k += 2) {
      add_product<T, R, C>(block(k), x + static_cast<std::size_t>(column(k)) * padded(C), even);
      add_product<T, R, C>(block(k + 1), x + static_cast<std::size_t>(column(k + 1)) * padded(C),
                           odd);
    }
    if (k < end)
      add_product<T, R, C>(block(k), x + static_cast<std::size_t>(column(k)) * padded(C), even);
    return even + odd;
  }
};

/// Zero blocks at the places given.
template <class T, int R, int C>
BlockMatrix<T, R, C> make_block_matrix(const std::vector<Local>& offset,
                                       const std::vector<Local>& column) {
  BlockMatrix<T, R, C> a;
  a.rows = static_cast<Local>(offset.size()) - 1;
  a.offset = make_view("multigrid: offset", offset);
  a.column = make_view("multigrid: column", column);
  a.value = View<T>("multigrid: value", column.size() * a.block_size);
  return a;
}

/// y = A x, or y += A x. x (columns, padded(C)), y (rows, padded(R)).
template <class T, int R, int C> struct Multiply {
  BlockMatrix<T, R, C> a;
  const T* x;
  T* y;
  bool add;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    T* to = y + static_cast<std::size_t>(i) * padded(R);
    const auto product = a.row_product(i, x);
    (add ? Pack<T, R>::load(to) + product : product).store(to);
  }
};

template <class T, int R, int C>
void multiply(const BlockMatrix<T, R, C>& a, const T* x, T* y, bool add = false) {
  Kokkos::parallel_for("abut::multigrid::product", Range(0, a.rows),
                       Multiply<T, R, C>{a, x, y, add});
}

} // namespace abut::multigrid
