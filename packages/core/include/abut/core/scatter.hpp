// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <Kokkos_Core.hpp>
#include <cstdint>

/// Cells that are added at the same time may share a node, so every sum is atomic. Where Kokkos has
/// no parallel back end its atomic_add is a plain add, which the compiler vectorizes as such.
namespace abut {

/// How blocks of nodes that move with a rigid body reach its rows: the node's position is that of
/// the body's center plus an arm. A body with unknowns has two block rows, of the force and of the
/// moment about its center; a cell's block of two such nodes is mapped to four blocks. Only for
/// three fields, the displacement. docs/theory/rigid_bodies.md
struct RigidScatter {
  const Local* body = nullptr;         ///< (rigid nodes)
  const Local* row = nullptr;          ///< (bodies,2) block rows, or -1: no unknowns
  const double* arm = nullptr;         ///< (rigid nodes,3) position minus center [length]
  const double* lever = nullptr;       ///< (rigid nodes,3,3) force -> residual of the moment rows
  const double* turn = nullptr;        ///< (rigid nodes,3,3) d position / d rotation unknowns
  const std::int64_t* block = nullptr; ///< (rigid blocks,2,2) first value of each block, or -1
  double* force = nullptr;             ///< (bodies,12) sums of f (3) and of arm f^T (3,3)

  /// Adds the force f of a rigid node: to the sums of its body and to the body's rows.
  KOKKOS_INLINE_FUNCTION void add(Local node, const double* f, double* values) const {
    const Local b = body[node];
    double* sum = force + 12 * static_cast<std::int64_t>(b);
    for (int i = 0; i < 3; ++i) {
      Kokkos::atomic_add(sum + i, f[i]);
      for (int j = 0; j < 3; ++j)
        Kokkos::atomic_add(sum + 3 + 3 * i + j,
                           arm[3 * static_cast<std::int64_t>(node) + i] * f[j]);
    }
    if (row[2 * b] < 0)
      return;
    double* translation = values + 3 * static_cast<std::int64_t>(row[2 * b]);
    double* rotation = values + 3 * static_cast<std::int64_t>(row[2 * b + 1]);
    const double* m = lever + 9 * static_cast<std::int64_t>(node);
    for (int i = 0; i < 3; ++i) {
      Kokkos::atomic_add(translation + i, f[i]);
      Kokkos::atomic_add(rotation + i, m[3 * i] * f[0] + m[3 * i + 1] * f[1] + m[3 * i + 2] * f[2]);
    }
  }

  /// Adds the block k (rows `stride` apart) of slots with rows row_a, row_b, one at least rigid.
  KOKKOS_INLINE_FUNCTION void add(std::int64_t index, Local row_a, Local row_b, const double* k,
                                  int stride, const Local* row_length, double* values) const {
    const bool rigid_a = row_a < -1, rigid_b = row_b < -1;
    for (int i = 0; i < (rigid_a ? 2 : 1); ++i)
      for (int j = 0; j < (rigid_b ? 2 : 1); ++j) {
        const std::int64_t p = block[4 * index + 2 * i + j];
        if (p < 0)
          continue;
        const Local length = row_length[rigid_a ? row[2 * body[-2 - row_a] + i] : row_a];
        const double* l = i == 1 ? lever + 9 * static_cast<std::int64_t>(-2 - row_a) : nullptr;
        const double* t = j == 1 ? turn + 9 * static_cast<std::int64_t>(-2 - row_b) : nullptr;
        for (int f = 0; f < 3; ++f) {
          double left[3];
          for (int g = 0; g < 3; ++g)
            left[g] = l ? l[3 * f] * k[g] + l[3 * f + 1] * k[stride + g] +
                              l[3 * f + 2] * k[2 * stride + g]
                        : k[f * stride + g];
          double* out = values + p + static_cast<std::int64_t>(f) * length;
          for (int g = 0; g < 3; ++g)
            Kokkos::atomic_add(out + g, t ? left[0] * t[g] + left[1] * t[3 + g] + left[2] * t[6 + g]
                                          : left[g]);
        }
      }
  }
};

/// Adds cell vectors to the residual through precomputed rows. Plain pointers: usable in kernels.
struct ResidualScatter {
  int fields = 0;
  const Local* cell_offset = nullptr; ///< (cells+1) into row
  /// Block row of each node of each cell; -1: no unknowns; -2 - i: rigid node i.
  const Local* row = nullptr;
  double* values = nullptr; ///< (rows, fields)
  RigidScatter rigid = {};

  /// r: (n, fields) of the cell.
  KOKKOS_INLINE_FUNCTION void add(Local cell, const double* r) const { add(cell, r, fields); }
  /// r: (n, width), the first fields of each node; the others are not touched.
  KOKKOS_INLINE_FUNCTION void add(Local cell, const double* r, int width) const {
    for (Local s = cell_offset[cell]; s < cell_offset[cell + 1]; ++s, r += width) {
      if (row[s] < 0) {
        if (row[s] < -1)
          rigid.add(-2 - row[s], r, values);
        continue;
      }
      double* out = values + static_cast<std::int64_t>(row[s]) * fields;
      for (int f = 0; f < width; ++f)
        Kokkos::atomic_add(out + f, r[f]);
    }
  }
};

/// Adds cell matrices to the operator through precomputed positions: no search, no allocation.
struct TangentScatter {
  int fields = 0;
  const Local* cell_offset = nullptr;         ///< (cells+1) into row
  const Local* row = nullptr;                 ///< as in ResidualScatter
  const std::int64_t* block_offset = nullptr; ///< (cells+1) into block_position
  /// First value of block (a, b); -1: none; -2 - i: rigid block i.
  const std::int64_t* block_position = nullptr;
  const Local* row_length = nullptr; ///< values in one scalar row of a block row
  double* values = nullptr;
  RigidScatter rigid = {};

  /// k: (n*fields, n*fields) of the cell, row by row.
  KOKKOS_INLINE_FUNCTION void add(Local cell, const double* k) const { add(cell, k, fields); }
  /// k: (n*width, n*width), of the first fields of each node; the others are not touched.
  KOKKOS_INLINE_FUNCTION void add(Local cell, const double* k, int width) const {
    const Local n = cell_offset[cell + 1] - cell_offset[cell];
    const int stride = n * width;
    for (Local a = 0; a < n; ++a)
      for (Local b = 0; b < n; ++b)
        add_block(cell, a, b, k + static_cast<std::int64_t>(a) * width * stride + b * width, stride,
                  width);
  }
  /// The block (a, b) of the cell's nodes, width x width with rows `stride` apart.
  KOKKOS_INLINE_FUNCTION void add_block(Local cell, Local a, Local b, const double* k, int stride,
                                        int width) const {
    const Local first = cell_offset[cell], n = cell_offset[cell + 1] - first;
    const Local r = row[first + a];
    if (r == -1)
      return;
    const std::int64_t p = block_position[block_offset[cell] + a * n + b];
    if (p < 0) {
      if (p < -1)
        rigid.add(-2 - p, r, row[first + b], k, stride, row_length, values);
      return;
    }
    for (int f = 0; f < width; ++f) {
      double* out = values + p + static_cast<std::int64_t>(f) * row_length[r];
      for (int g = 0; g < width; ++g)
        Kokkos::atomic_add(out + g, k[f * stride + g]);
    }
  }
};

} // namespace abut
