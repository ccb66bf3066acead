// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/core/tensor.hpp"
#include "abut/fem/cell_shape.hpp"
#include "abut/fem/quadrature.hpp"
#include "abut/solid/deformation.hpp"

/// Kinematics of an element's integration points.
namespace abut::solid {

/// Shape functions of a cell at P points.
template <fem::CellType C, int P> struct CellTable {
  static constexpr int nodes = fem::CellShape<C>::nodes;
  static constexpr int points = P;
  double weight[points];
  double N[points][nodes];
  double dN[points][3][nodes]; ///< by the reference cell's coordinates

  /// The rule with so many points per direction; it has P of them (else Defect).
  explicit CellTable(int per_direction) {
    const fem::Rule<3> rule = fem::cell_rule(C, per_direction);
    ABUT_REQUIRE(rule.size() == points, "points of a table");
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

constexpr int stiffness_points(fem::CellType type) {
  return type == fem::CellType::hex8     ? 8
         : type == fem::CellType::tet4   ? 1
         : type == fem::CellType::tet10  ? 4
         : type == fem::CellType::wedge6 ? 6
                                         : 27;
}

/// At the points that integrate stiffness.
template <fem::CellType C> struct ReferenceCell : CellTable<C, stiffness_points(C)> {
  ReferenceCell() : CellTable<C, stiffness_points(C)>(fem::default_points(C)) {}
};

/// The one table of a cell type (host).
template <fem::CellType C> const ReferenceCell<C>& reference_cell() {
  static const ReferenceCell<C> cell;
  return cell;
}

/// Sum over nodes of v_a d_a. In four parts: one after the other they would wait for each other.
template <int n, class T>
KOKKOS_INLINE_FUNCTION T nodal_sum(const T (&v)[n], const double (&d)[n]) {
  constexpr int parts = 4, whole = n / parts * parts;
  T part[parts] = {};
  for (int a = 0; a < whole; a += parts)
    for (int p = 0; p < parts; ++p)
      part[p] += v[a + p] * d[a + p];
  for (int a = whole; a < n; ++a)
    part[a - whole] += v[a] * d[a];
  return (part[0] + part[1]) + (part[2] + part[3]);
}

/// Sum over nodes of v_a times grad N_a: m[i][k] = dv_i/dxi_k.
template <int n, class T>
KOKKOS_INLINE_FUNCTION Mat<T, 3> nodal_gradient(const T (&v)[3][n], const double (&dN)[3][n]) {
  Mat<T, 3> m;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      m[i][k] = nodal_sum(v[i], dN[k]);
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
    if (!(deformation.jacobian() > 0.0))
      return false;
    const Mat<T, 3> back = inverse_gradient(deformation);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i)
        map[k][i] = to_reference[k][0] * back[0][i] + to_reference[k][1] * back[1][i] +
                    to_reference[k][2] * back[2][i];
    return true;
  }
};

/// Adds the nodal forces (3, nodes) of the stress at a point. dN: by the reference coordinates.
template <int nodes, class T>
KOKKOS_INLINE_FUNCTION void add_internal_force(const double (&dN)[3][nodes],
                                               const SolidPoint<T>& point, const Mat<T, 3>& stress,
                                               T (&r)[3][nodes]) {
  for (int i = 0; i < 3; ++i) {
    T q[3];
    for (int k = 0; k < 3; ++k)
      q[k] = point.volume * (stress[i][0] * point.map[k][0] + stress[i][1] * point.map[k][1] +
                             stress[i][2] * point.map[k][2]);
    for (int a = 0; a < nodes; ++a)
      r[i][a] += q[0] * dN[0][a] + q[1] * dN[1][a] + q[2] * dN[2][a];
  }
}

} // namespace abut::solid
