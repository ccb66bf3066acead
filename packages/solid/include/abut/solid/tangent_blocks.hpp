// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/solid/deformation.hpp"

namespace abut::solid {

/// Upper triangle by components of an element's tangent while points are summed.
template <int n> struct TangentBlocks {
  double block[6][n][n];  ///< component pairs (0,0), (1,1), (2,2), (0,1), (1,2), (0,2)
  double geometric[n][n]; ///< times the identity

  KOKKOS_INLINE_FUNCTION void clear() {
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        for (int v = 0; v < 6; ++v)
          block[v][a][b] = 0.0;
        geometric[a][b] = 0.0;
      }
  }

  /// Adds B^T c B; g: (3, n) gradients; c already times the volume.
  KOKKOS_INLINE_FUNCTION void add_material(const double (&g)[3][n], const double (&c)[6][6]) {
    // Voigt rows that hold gradient component x, y, z of a displacement component i.
    constexpr int voigt[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    double cb[3][6][n]; // column j of c B_b
    for (int j = 0; j < 3; ++j)
      for (int v = 0; v < 6; ++v) {
        const double c0 = c[v][voigt[j][0]], c1 = c[v][voigt[j][1]], c2 = c[v][voigt[j][2]];
#pragma omp simd
        for (int b = 0; b < n; ++b)
          cb[j][v][b] = c0 * g[0][b] + c1 * g[1][b] + c2 * g[2][b];
      }
    for (int pair = 0; pair < 6; ++pair) {
      const int i = voigt_row[pair], j = voigt_column[pair];
      const double(&b0)[n] = cb[j][voigt[i][0]];
      const double(&b1)[n] = cb[j][voigt[i][1]];
      const double(&b2)[n] = cb[j][voigt[i][2]];
      for (int a = 0; a < n; ++a) {
        const double g0 = g[0][a], g1 = g[1][a], g2 = g[2][a];
#pragma omp simd
        for (int b = 0; b < n; ++b)
          block[pair][a][b] += g0 * b0[b] + g1 * b1[b] + g2 * b2[b];
      }
    }
  }

  /// Adds grad N_a . s grad N_b; s already times the volume.
  KOKKOS_INLINE_FUNCTION void add_geometric(const double (&g)[3][n], const Mat3& s) {
    double sg[3][n];
    for (int i = 0; i < 3; ++i)
      for (int b = 0; b < n; ++b)
        sg[i][b] = s[i][0] * g[0][b] + s[i][1] * g[1][b] + s[i][2] * g[2][b];
    for (int a = 0; a < n; ++a) {
      const double g0 = g[0][a], g1 = g[1][a], g2 = g[2][a];
#pragma omp simd
      for (int b = 0; b < n; ++b)
        geometric[a][b] += g0 * sg[0][b] + g1 * sg[1][b] + g2 * sg[2][b];
    }
  }

  /// Adds factor b_a (x) b_b; b: (3, n).
  KOKKOS_INLINE_FUNCTION void add_dyad(double factor, const double (&b)[3][n]) {
    for (int pair = 0; pair < 6; ++pair) {
      const int i = voigt_row[pair], j = voigt_column[pair];
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < n; ++c)
          block[pair][a][c] += factor * b[i][a] * b[j][c];
    }
  }

  /// k: (n*3, n*3), node first, row by row; exactly symmetric.
  KOKKOS_INLINE_FUNCTION void write(double* k) const {
    constexpr int row = 3 * n;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        const int lo = a < b ? a : b, hi = a < b ? b : a;
        double* out = k + (3 * a) * row + 3 * b;
        for (int i = 0; i < 3; ++i)
          out[i * row + i] = block[i][lo][hi] + geometric[lo][hi];
        for (int pair = 3; pair < 6; ++pair) {
          const int i = voigt_row[pair], j = voigt_column[pair];
          out[i * row + j] = block[pair][a][b];
          out[j * row + i] = block[pair][b][a];
        }
      }
  }
};

} // namespace abut::solid
