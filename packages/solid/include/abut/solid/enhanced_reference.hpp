// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/material.hpp"
#include "abut/solid/solid_point.hpp"

/// What the enhanced hex8 (enhanced.hpp) knows of its undeformed state.
namespace abut::solid {

using HexTable = ReferenceCell<fem::CellType::hex8>;

/// The twelve hourglass displacements are a vector for each of h = eta zeta, zeta xi, xi eta and
/// xi eta zeta.
constexpr int hourglasses = 4;
constexpr int hourglass_numbers = 3 * hourglasses; ///< of modes: x, y, z of the first, ...

/// Share of the volume at the points beside the mean; strains there are those of the points of
/// HexTable divided by its square root, so that their squares keep their integral. With a third,
/// strains that are linear in the cell are those at its corners.
constexpr double corner_share = 1.0 / 3.0;

struct EnhancedReference {
  static constexpr int nodes = HexTable::nodes;
  static constexpr int points = HexTable::points;

  double volume;
  double gradient[3][nodes];            ///< means of dN_a/dX_i over the volume
  double hourglass[hourglasses][nodes]; ///< sum over nodes of these times u is q, the amplitudes
  double share[points];                 ///< volume at the points beside the mean
  double strain[points][voigt_size][hourglass_numbers]; ///< components of E (not doubled) by c
};

/// Modes of strain without a mean: hourglass ones, three incompatible displacements 1 - xi_k^2 and
/// four changes of volume, h.
struct EnhancedModes {
  static constexpr int fields = hourglasses + 3;
  static constexpr int compatible = 3 * hourglasses;
  static constexpr int size = 3 * fields + hourglasses;

  double k[size][size]; ///< stiffness, field by field, components x, y, z; then changes of volume

  /// Adds a point of weight v: gradients of the fields and changes of volume.
  KOKKOS_INLINE_FUNCTION void add(double v, const LameConstants& law, const double (&g)[fields][3],
                                  const double (&dilatation)[hourglasses]) {
    for (int m = 0; m < fields; ++m)
      for (int n = 0; n < fields; ++n) {
        const double dot = g[m][0] * g[n][0] + g[m][1] * g[n][1] + g[m][2] * g[n][2];
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j)
            k[3 * m + i][3 * n + j] +=
                v * (law.lambda * g[m][i] * g[n][j] + law.shear * g[m][j] * g[n][i]);
          k[3 * m + i][3 * n + i] += v * law.shear * dot;
        }
      }
    const double bulk = v * (3.0 * law.lambda + 2.0 * law.shear);
    for (int s = 0; s < hourglasses; ++s) {
      const int row = 3 * fields + s;
      for (int m = 0; m < 3 * fields; ++m) {
        const double coupling = bulk * dilatation[s] * g[m / 3][m % 3];
        k[row][m] += coupling;
        k[m][row] += coupling;
      }
      for (int t = 0; t < hourglasses; ++t)
        k[row][3 * fields + t] += 3.0 * bulk * dilatation[s] * dilatation[t];
    }
  }

  /// Component v of the strain of all modes for one of the hourglass modes.
  KOKKOS_INLINE_FUNCTION static double strain(int v, int mode, const double (&g)[fields][3],
                                              const double (&dilatation)[hourglasses],
                                              const double (&amplitude)[size][compatible]) {
    const int i = voigt_row[v], j = voigt_column[v];
    double e = 0.0;
    for (int m = 0; m < fields; ++m)
      e += 0.5 * (amplitude[3 * m + i][mode] * g[m][j] + amplitude[3 * m + j][mode] * g[m][i]);
    for (int s = 0; i == j && s < hourglasses; ++s)
      e += amplitude[3 * fields + s][mode] * dilatation[s];
    return e;
  }

  /// All modes' amplitudes by those of the hourglass modes when the others are free.
  KOKKOS_INLINE_FUNCTION void relax(double (&amplitude)[size][compatible]) {
    for (int last = size - 1; last >= compatible; --last)
      for (int m = compatible; m < last; ++m) {
        const double factor = k[m][last] / k[last][last];
        for (int n = 0; n < last; ++n)
          k[m][n] -= factor * k[last][n];
      }
    for (int m = 0; m < size; ++m)
      for (int c = 0; c < compatible; ++c) {
        amplitude[m][c] = m == c ? 1.0 : 0.0;
        for (int n = 0; m >= compatible && n < m; ++n)
          amplitude[m][c] -= k[m][n] * amplitude[n][c] / k[m][m];
      }
  }
};

/// h at the nodes of the reference cell.
KOKKOS_INLINE_FUNCTION void hourglass_patterns(double (&xi)[3][8], double (&h)[hourglasses][8]) {
  for (int a = 0; a < 8; ++a) {
    double at[3];
    fem::CellShape<fem::CellType::hex8>::node(a, at);
    for (int i = 0; i < 3; ++i) {
      xi[i][a] = at[i];
      h[i][a] = at[(i + 1) % 3] * at[(i + 2) % 3];
    }
    h[3][a] = at[0] * at[1] * at[2];
  }
}

/// Stiffness against hourglass modes: strains of the trilinear displacement less their mean, and
/// beside them incompatible modes (Taylor, Beresford and Wilson, Int. J. Numer. Methods Eng. 10
/// (1976) 1211), which relieve bending, and changes of volume, so that none is left but the mean.
/// to_center: derivatives dX/dxi at the center; mean: of the gradients of h.
KOKKOS_INLINE_FUNCTION void set_hourglass_strains(const HexTable& cell, const double (&x)[3][8],
                                                  const LameConstants& law, const Mat3& to_center,
                                                  const double (&mean)[hourglasses][3],
                                                  EnhancedReference& reference) {
  constexpr int points = HexTable::points;
  double xi[3][8], h[hourglasses][8];
  hourglass_patterns(xi, h);
  EnhancedModes modes = {};
  double gradient[points][EnhancedModes::fields][3], dilatations[points][hourglasses];
  for (int p = 0; p < points; ++p) {
    auto& g = gradient[p];
    auto& dilatation = dilatations[p];
    const Mat3 jacobian = nodal_gradient(x, cell.dN[p]);
    const double reference_det = det(jacobian);
    const Mat3 to_reference = inverse(jacobian, reference_det);
    for (int s = 0; s < hourglasses; ++s) {
      dilatation[s] = nodal_sum(h[s], cell.N[p]) / reference_det;
      double by_xi[3];
      for (int k = 0; k < 3; ++k)
        by_xi[k] = nodal_sum(h[s], cell.dN[p][k]);
      for (int i = 0; i < 3; ++i)
        g[s][i] = by_xi[0] * to_reference[0][i] + by_xi[1] * to_reference[1][i] +
                  by_xi[2] * to_reference[2][i] - mean[s][i];
    }
    for (int k = 0; k < 3; ++k) { // with the center's map over the point's volume, without a mean
      const int m = (k + 1) % 3, n = (k + 2) % 3;
      const double slope = -2.0 * nodal_sum(xi[k], cell.N[p]) / reference_det;
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        g[hourglasses + k][i] =
            slope * (to_center[j][m] * to_center[l][n] - to_center[l][m] * to_center[j][n]);
      }
    }
    modes.add(cell.weight[p] * reference_det, law, g, dilatation);
    reference.share[p] = corner_share * cell.weight[p] * reference_det;
  }
  double amplitude[EnhancedModes::size][EnhancedModes::compatible];
  modes.relax(amplitude);
  const double scale = 1.0 / std::sqrt(corner_share);
  for (int p = 0; p < points; ++p)
    for (int v = 0; v < voigt_size; ++v)
      for (int c = 0; c < hourglass_numbers; ++c)
        reference.strain[p][v][c] =
            scale * EnhancedModes::strain(v, c, gradient[p], dilatations[p], amplitude);
}

/// x: reference positions; law: at rest.
KOKKOS_INLINE_FUNCTION EnhancedReference enhanced_reference(const HexTable& cell,
                                                            const double (&x)[3][8],
                                                            const LameConstants& law) {
  EnhancedReference r = {};
  double xi[3][8], h[hourglasses][8], mean[hourglasses][3];
  hourglass_patterns(xi, h);
  for (int p = 0; p < HexTable::points; ++p) {
    const Mat3 jacobian = nodal_gradient(x, cell.dN[p]);
    const double reference_det = det(jacobian);
    const Mat3 to_reference = inverse(jacobian, reference_det);
    const double v = cell.weight[p] * reference_det;
    r.volume += v;
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < 8; ++a)
        r.gradient[i][a] +=
            v * (cell.dN[p][0][a] * to_reference[0][i] + cell.dN[p][1][a] * to_reference[1][i] +
                 cell.dN[p][2][a] * to_reference[2][i]);
  }
  for (auto& row : r.gradient)
    for (double& value : row)
      value /= r.volume;

  const Mat3 eightfold = nodal_gradient(x, xi);
  Mat3 to_center;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      to_center[i][k] = eightfold[i][k] / 8.0;
  const Mat3 from_center = inverse(to_center, det(to_center));
  for (int s = 0; s < hourglasses; ++s) {
    double share[3]; // of xi_k in what is linear in X
    for (int k = 0; k < 3; ++k)
      share[k] = from_center[k][0] * nodal_sum(x[0], h[s]) +
                 from_center[k][1] * nodal_sum(x[1], h[s]) +
                 from_center[k][2] * nodal_sum(x[2], h[s]);
    for (int a = 0; a < 8; ++a)
      r.hourglass[s][a] =
          (h[s][a] - (share[0] * xi[0][a] + share[1] * xi[1][a] + share[2] * xi[2][a]) / 8.0) / 8.0;
    for (int i = 0; i < 3; ++i)
      mean[s][i] = nodal_sum(h[s], r.gradient[i]);
  }

  set_hourglass_strains(cell, x, law, to_center, mean, r);
  return r;
}

} // namespace abut::solid
