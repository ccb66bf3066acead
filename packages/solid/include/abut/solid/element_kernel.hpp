// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/fem/cell_shape.hpp"
#include "abut/fem/quadrature.hpp"
#include "abut/solid/material.hpp"

/// One element: from nodal numbers to residual, tangent and averages. No mesh, no allocation.
///
/// Arrays of an element are stored by component first, (3, nodes): the inner loops run over nodes.
/// Finite strain: r_a = int tau grad N_a dV, k_ab = int (B_a^T c B_b + grad N_a . tau grad N_b I)
/// dV with spatial gradients over the reference volume V (Bonet and Wood, chapter 9). Small strain:
/// the same with gradients by X and without the second, geometric term.
namespace abut::solid {

/// Shape functions of a cell at its stiffness points.
template <fem::CellType C> struct ReferenceCell {
  static constexpr int nodes = fem::CellShape<C>::nodes;
  static constexpr int points = C == fem::CellType::hex8     ? 8
                                : C == fem::CellType::tet4   ? 1
                                : C == fem::CellType::tet10  ? 4
                                : C == fem::CellType::wedge6 ? 6
                                                             : 27;
  double weight[points];
  double N[points][nodes];
  double dN[points][3][nodes]; ///< by the reference cell's coordinates

  ReferenceCell() {
    const fem::Rule<3> rule = fem::cell_rule(C, fem::default_points(C));
    for (int p = 0; p < points; ++p) {
      double d[nodes][3];
      weight[p] = rule.weight[p];
      fem::CellShape<C>::values(rule.xi[p].data(), N[p]);
      fem::CellShape<C>::derivatives(rule.xi[p].data(), d);
      for (int i = 0; i < 3; ++i)
        for (int a = 0; a < nodes; ++a)
          dN[p][i][a] = d[a][i];
    }
  }
};

/// The one table of a cell type (host).
template <fem::CellType C> const ReferenceCell<C>& reference_cell() {
  static const ReferenceCell<C> cell;
  return cell;
}

/// Sum over nodes of v_a times grad N_a: m[i][k] = dv_i/dxi_k.
template <int n, class T>
KOKKOS_INLINE_FUNCTION Mat<T, 3> nodal_gradient(const T (&v)[3][n], const double (&dN)[3][n]) {
  Mat<T, 3> m;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      T s = v[i][0] * dN[k][0];
      for (int a = 1; a < n; ++a)
        s += v[i][a] * dN[k][a];
      m[i][k] = s;
    }
  return m;
}

/// Product of a plain matrix and one of any scalar.
template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> product(const Mat<T, 3>& a, const Mat3& b) {
  Mat<T, 3> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      r[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return r;
}

/// Kinematics of one integration point.
template <class T> struct SolidPoint {
  double volume = 0.0; ///< weight times the determinant of the reference Jacobian
  Deformation<T> deformation{Mat<T, 3>::zero()};
  Mat<T, 3> map; ///< [k][i] = dxi_k/dx_i (finite strain) or dxi_k/dX_i

  /// x: reference coordinates, u: displacements. Returns false when det F <= 0 at finite strain.
  template <int n>
  KOKKOS_INLINE_FUNCTION bool set(bool finite_strain, double weight, const double (&dN)[3][n],
                                  const double (&x)[3][n], const T (&u)[3][n]) {
    const Mat3 jacobian = nodal_gradient(x, dN);
    const double reference_det = det(jacobian);
    const Mat3 to_reference = inverse(jacobian, reference_det);
    volume = weight * reference_det;
    deformation = Deformation<T>(product(nodal_gradient(u, dN), to_reference));
    if (!finite_strain) {
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          map[k][i] = T(to_reference[k][i]);
      return true;
    }
    const T J = deformation.jacobian();
    if (!(J > 0.0))
      return false;
    Mat<T, 3> F = deformation.H;
    for (int i = 0; i < 3; ++i)
      F[i][i] += 1.0;
    const Mat<T, 3> back = inverse(F, J);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i)
        map[k][i] = to_reference[k][0] * back[0][i] + to_reference[k][1] * back[1][i] +
                    to_reference[k][2] * back[2][i];
    return true;
  }
};

/// Internal force r (3, n) of an element. Returns the smallest det F of its points; when that is
/// not positive, r is not usable. At small strain det F does not matter and 1 is returned.
template <fem::CellType C, class M, class T>
KOKKOS_INLINE_FUNCTION double element_residual(const ReferenceCell<C>& cell, const M& material,
                                               const double (&x)[3][ReferenceCell<C>::nodes],
                                               const T (&u)[3][ReferenceCell<C>::nodes],
                                               T (&r)[3][ReferenceCell<C>::nodes]) {
  constexpr int n = ReferenceCell<C>::nodes;
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < n; ++a)
      r[i][a] = T(0.0);
  double smallest = 1.0;
  SolidPoint<T> point;
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    if (!point.set(M::finite_strain, cell.weight[p], cell.dN[p], x, u))
      return value_of(point.deformation.jacobian());
    if (M::finite_strain) {
      const double J = value_of(point.deformation.jacobian());
      smallest = J < smallest ? J : smallest;
    }
    const Mat<T, 3> stress = material.stress(point.deformation);
    for (int i = 0; i < 3; ++i) {
      T q[3];
      for (int k = 0; k < 3; ++k)
        q[k] = point.volume * (stress[i][0] * point.map[k][0] + stress[i][1] * point.map[k][1] +
                               stress[i][2] * point.map[k][2]);
      for (int a = 0; a < n; ++a)
        r[i][a] += q[0] * cell.dN[p][0][a] + q[1] * cell.dN[p][1][a] + q[2] * cell.dN[p][2][a];
    }
  }
  return smallest;
}

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
      for (int b = 0; b < n; ++b)
        geometric[a][b] += g0 * sg[0][b] + g1 * sg[1][b] + g2 * sg[2][b];
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

/// Tangent k (n*3, n*3), node first, of an element. Returns as element_residual does.
template <fem::CellType C, class M>
KOKKOS_INLINE_FUNCTION double element_tangent(const ReferenceCell<C>& cell, const M& material,
                                              const double (&x)[3][ReferenceCell<C>::nodes],
                                              const double (&u)[3][ReferenceCell<C>::nodes],
                                              double* k) {
  constexpr int n = ReferenceCell<C>::nodes;
  TangentBlocks<n> blocks;
  blocks.clear();
  double smallest = 1.0;
  SolidPoint<double> point;
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    if (!point.set(M::finite_strain, cell.weight[p], cell.dN[p], x, u))
      return point.deformation.jacobian();
    if (M::finite_strain) {
      const double J = point.deformation.jacobian();
      smallest = J < smallest ? J : smallest;
    }
    double g[3][n];
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < n; ++a)
        g[i][a] = cell.dN[p][0][a] * point.map[0][i] + cell.dN[p][1][a] * point.map[1][i] +
                  cell.dN[p][2][a] * point.map[2][i];
    Mat3 stress;
    double c[6][6];
    material.tangent(point.deformation, stress, c);
    for (auto& row : c)
      for (double& value : row)
        value *= point.volume;
    blocks.add_material(g, c);
    if (M::finite_strain) {
      for (auto& row : stress.m)
        for (double& value : row)
          value *= point.volume;
      blocks.add_geometric(g, stress);
    }
  }
  blocks.write(k);
  return smallest;
}

/// Cauchy stress (Voigt) averaged over the current volume (small strain: the reference volume), and
/// the strain energy of an element. Where det F <= 0 the point is left out.
template <fem::CellType C, class M>
KOKKOS_INLINE_FUNCTION void element_averages(const ReferenceCell<C>& cell, const M& material,
                                             const double (&x)[3][ReferenceCell<C>::nodes],
                                             const double (&u)[3][ReferenceCell<C>::nodes],
                                             double stress[6], double& energy) {
  double volume = 0.0;
  energy = 0.0;
  for (int v = 0; v < voigt_size; ++v)
    stress[v] = 0.0;
  SolidPoint<double> point;
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    if (!point.set(M::finite_strain, cell.weight[p], cell.dN[p], x, u))
      continue;
    const Mat3 s = material.stress(point.deformation); // times dV is the Cauchy stress times dv
    for (int v = 0; v < voigt_size; ++v)
      stress[v] += point.volume * s[voigt_row[v]][voigt_column[v]];
    energy += point.volume * material.energy(point.deformation);
    volume += M::finite_strain ? point.volume * point.deformation.jacobian() : point.volume;
  }
  if (volume > 0.0)
    for (int v = 0; v < voigt_size; ++v)
      stress[v] /= volume;
}

} // namespace abut::solid
