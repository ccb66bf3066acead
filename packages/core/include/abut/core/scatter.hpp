// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <Kokkos_Macros.hpp>
#include <cstdint>

namespace abut {

/// Adds cell vectors to the residual through precomputed rows. Plain pointers: usable in kernels.
struct ResidualScatter {
  int fields = 0;
  const Local* cell_offset = nullptr; ///< (cells+1) into row
  const Local* row = nullptr;         ///< block row of each node of each cell, or -1: no unknowns
  double* values = nullptr;           ///< (rows, fields)

  /// r: (n, fields) of the cell.
  KOKKOS_INLINE_FUNCTION void add(Local cell, const double* r) const {
    for (Local s = cell_offset[cell]; s < cell_offset[cell + 1]; ++s, r += fields) {
      if (row[s] < 0)
        continue;
      double* out = values + static_cast<std::int64_t>(row[s]) * fields;
      for (int f = 0; f < fields; ++f)
        out[f] += r[f];
    }
  }
};

/// Adds cell matrices to the operator through precomputed positions: no search, no allocation.
struct TangentScatter {
  int fields = 0;
  const Local* cell_offset = nullptr;           ///< (cells+1) into row
  const Local* row = nullptr;                   ///< block row of each node of each cell, or -1
  const std::int64_t* block_offset = nullptr;   ///< (cells+1) into block_position
  const std::int64_t* block_position = nullptr; ///< first value of block (a, b), or -1
  const Local* row_length = nullptr;            ///< values in one scalar row of a block row
  double* values = nullptr;

  /// k: (n*fields, n*fields) of the cell, row by row.
  KOKKOS_INLINE_FUNCTION void add(Local cell, const double* k) const {
    const Local first = cell_offset[cell], n = cell_offset[cell + 1] - first;
    const std::int64_t* position = block_position + block_offset[cell];
    const int stride = n * fields;
    for (Local a = 0; a < n; ++a, k += static_cast<std::int64_t>(fields) * stride) {
      const Local r = row[first + a];
      if (r < 0)
        continue;
      const Local length = row_length[r];
      for (Local b = 0; b < n; ++b) {
        const std::int64_t p = position[a * n + b];
        if (p < 0)
          continue;
        for (int f = 0; f < fields; ++f) {
          double* out = values + p + static_cast<std::int64_t>(f) * length;
          const double* in = k + f * stride + b * fields;
          for (int g = 0; g < fields; ++g)
            out[g] += in[g];
        }
      }
    }
  }
};

} // namespace abut
