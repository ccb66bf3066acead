// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/core/vector_units.hpp"
#include "abut/core/views.hpp"

#include <cstddef>
#include <vector>

/// Sparse matrices of small dense blocks, and the kernels of the multigrid cycle on them.
namespace abut::multigrid {

/// Entries that a block row of n unknowns takes in a vector: a register's width, which makes a
/// product of a block one multiply-add per column. What lies beyond the unknowns means nothing.
constexpr int padded(int n) {
  return n <= 2 ? n : n <= 4 ? 4 : 8;
}

/// The unknowns of one block row, or a column of a block. Loads go a register's width, and so
/// beyond a column into the next one.
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
  /// As a column of a block, which ends with its last unknown.
  KOKKOS_INLINE_FUNCTION void store_column(T* to) const {
    for (int r = 0; r < N; ++r)
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

/// sum += block (R x C, by columns) times x.
template <class T, int R, int C>
KOKKOS_INLINE_FUNCTION void add_product(const T* block, const T* x, Pack<T, R>& sum) {
  for (int c = 0; c < C; ++c)
    sum.add(x[c], block + c * R);
}

/// The products of a block row with a sum for each column: none waits for another, and so they hide
/// the latency of the additions.
template <class T, int R, int C> struct ColumnSums {
  Pack<T, R> sum[C];

  KOKKOS_INLINE_FUNCTION void add(const T* block, const T* x) {
    for (int c = 0; c < C; ++c)
      sum[c].add(x[c], block + c * R);
  }
  KOKKOS_INLINE_FUNCTION Pack<T, R> total() const {
    Pack<T, R> all = sum[0];
    for (int c = 1; c < C; ++c)
      all = all + sum[c];
    return all;
  }
};

/// Zeros for the entries of blocks with R rows, and for what a load reads beyond the last one.
template <int R, class T> View<T> block_values(const std::string& label, std::size_t entries) {
  return View<T>(label, entries + static_cast<std::size_t>(padded(R) - R));
}

/// Block compressed sparse rows: row i has the blocks offset[i] .. offset[i+1]-1.
template <class T, int R, int C> struct BlockMatrix {
  static constexpr int block_size = R * C;

  Local rows = 0;
  View<Local> offset; ///< (rows+1)
  View<Local> column; ///< (blocks)
  View<T> value;      ///< (blocks, C, R), see block_values

  KOKKOS_INLINE_FUNCTION T* block(Local k) const {
    return value.data() + static_cast<std::size_t>(k) * block_size;
  }
  Local blocks() const { return static_cast<Local>(column.size()); }
  std::size_t bytes() const {
    return value.size() * sizeof(T) + (column.size() + offset.size()) * sizeof(Local);
  }

  /// Row i of the matrix times x, (columns, padded(C)).
  KOKKOS_INLINE_FUNCTION Pack<T, R> row_product(Local i, const T* x) const {
    ColumnSums<T, R, C> even, odd;
    const Local end = offset(i + 1);
    Local k = offset(i);
    for (; k + 1 < end; k += 2) {
      even.add(block(k), x + static_cast<std::size_t>(column(k)) * padded(C));
      odd.add(block(k + 1), x + static_cast<std::size_t>(column(k + 1)) * padded(C));
    }
    if (k < end)
      even.add(block(k), x + static_cast<std::size_t>(column(k)) * padded(C));
    return even.total() + odd.total();
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
  a.value = block_values<R, T>("multigrid: value", column.size() * a.block_size);
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

/// Calls `run` with a kernel compiled for registers that hold a block row, where the processor has
/// them; wider ones would be no faster.
template <class Kernel, class Run> void with_row_registers(const Kernel& kernel, Run run) {
  if (vector_unit() == VectorUnit::plain)
    run(kernel);
  else
    run(Wide<VectorUnit::avx2, Kernel>{kernel});
}

template <class T, int R, int C>
void multiply(const BlockMatrix<T, R, C>& a, const T* x, T* y, bool add = false) {
  with_row_registers(Multiply<T, R, C>{a, x, y, add}, [&](const auto& kernel) {
    Kokkos::parallel_for("abut::multigrid::product", Range(0, a.rows), kernel);
  });
}

} // namespace abut::multigrid
