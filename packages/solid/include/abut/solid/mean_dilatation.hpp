// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/solid_point.hpp"
#include "abut/solid/tangent_blocks.hpp"

/// Elements of an uncoupled material that take the energy of the volume change once, at the mean J
/// of the element, so that hex8 does not lock when the bulk modulus is large. With v the current
/// and V the reference volume, and W* the isochoric energy,
///   W_e = int W* dV + V U(v / V),      r_a = int (tau* + p J I) grad N_a dV,  p = U'(v / V)
/// Its tangent holds, besides the points' terms at this p, U''(v/V) / V b_a (x) b_b with
/// b_a = int grad N_a dv. Simo, Taylor and Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177,
/// with the pressure and the dilatation eliminated.
namespace abut::solid {

/// An element's points and its mean change of volume.
template <fem::CellType C, class T> struct DilatedElement {
  SolidPoint<T> point[ReferenceCell<C>::points];
  double volume = 0.0;   ///< reference
  T change = T(0.0);     ///< v / V - 1
  double smallest = 1.0; ///< det F of the points, or of the first one that is not positive

  KOKKOS_INLINE_FUNCTION bool set(const ReferenceCell<C>& cell,
                                  const double (&x)[3][ReferenceCell<C>::nodes],
                                  const T (&u)[3][ReferenceCell<C>::nodes]) {
    for (int p = 0; p < ReferenceCell<C>::points; ++p) {
      const bool upright = point[p].set(true, cell.weight[p], cell.dN[p], x, u);
      const double J = value_of(point[p].deformation.jacobian());
      smallest = upright && !(J < smallest) ? smallest : J;
      if (!upright)
        return false;
      volume += point[p].volume;
      change += point[p].volume * point[p].deformation.volume_change;
    }
    change *= 1.0 / volume;
    return true;
  }
};

/// As element_residual.
template <fem::CellType C, class M, class T>
KOKKOS_INLINE_FUNCTION double mean_dilatation_residual(
    const ReferenceCell<C>& cell, const M& material, const double (&x)[3][ReferenceCell<C>::nodes],
    const T (&u)[3][ReferenceCell<C>::nodes], T (&r)[3][ReferenceCell<C>::nodes]) {
  constexpr int n = ReferenceCell<C>::nodes;
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < n; ++a)
      r[i][a] = T(0.0);
  DilatedElement<C, T> element;
  if (!element.set(cell, x, u))
    return element.smallest;
  const T mean_stress = material.mean_stress(element.change);
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    const SolidPoint<T>& point = element.point[p];
    Mat<T, 3> stress = material.isochoric_stress(point.deformation);
    for (int i = 0; i < 3; ++i)
      stress[i][i] += mean_stress * point.deformation.jacobian();
    add_internal_force(cell.dN[p], point, stress, r);
  }
  return element.smallest;
}

/// As element_tangent.
template <fem::CellType C, class M>
KOKKOS_INLINE_FUNCTION double
mean_dilatation_tangent(const ReferenceCell<C>& cell, const M& material,
                        const double (&x)[3][ReferenceCell<C>::nodes],
                        const double (&u)[3][ReferenceCell<C>::nodes], double* k) {
  constexpr int n = ReferenceCell<C>::nodes;
  DilatedElement<C, double> element;
  if (!element.set(cell, x, u))
    return element.smallest;
  const double mean_stress = material.mean_stress(element.change);
  TangentBlocks<n> blocks;
  blocks.clear();
  double volume_gradient[3][n] = {};
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    const SolidPoint<double>& point = element.point[p];
    const double J = point.deformation.jacobian();
    double g[3][n];
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < n; ++a) {
        g[i][a] = cell.dN[p][0][a] * point.map[0][i] + cell.dN[p][1][a] * point.map[1][i] +
                  cell.dN[p][2][a] * point.map[2][i];
        volume_gradient[i][a] += point.volume * J * g[i][a];
      }
    Mat3 stress;
    double c[6][6];
    material.isochoric_tangent(point.deformation, stress, c);
    M::add_pressure(J * mean_stress, J * mean_stress, stress, c);
    for (auto& row : c)
      for (double& value : row)
        value *= point.volume;
    for (auto& row : stress.m)
      for (double& value : row)
        value *= point.volume;
    blocks.add_material(g, c);
    blocks.add_geometric(g, stress);
  }
  blocks.add_dyad(material.mean_stress_slope(element.change) / element.volume, volume_gradient);
  blocks.write(k);
  return element.smallest;
}

/// As element_averages, but nothing is left out: a turned-over element has zeros.
template <fem::CellType C, class M>
KOKKOS_INLINE_FUNCTION void mean_dilatation_averages(const ReferenceCell<C>& cell,
                                                     const M& material,
                                                     const double (&x)[3][ReferenceCell<C>::nodes],
                                                     const double (&u)[3][ReferenceCell<C>::nodes],
                                                     double stress[6], double& energy) {
  energy = 0.0;
  for (int v = 0; v < voigt_size; ++v)
    stress[v] = 0.0;
  DilatedElement<C, double> element;
  if (!element.set(cell, x, u))
    return;
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    const SolidPoint<double>& point = element.point[p];
    const Mat3 s = material.isochoric_stress(point.deformation);
    for (int v = 0; v < voigt_size; ++v)
      stress[v] += point.volume * s[voigt_row[v]][voigt_column[v]];
    energy += point.volume * material.isochoric_energy(point.deformation);
  }
  const double current = element.volume * (1.0 + element.change);
  for (int v = 0; v < voigt_size; ++v)
    stress[v] = stress[v] / current + (v < 3 ? material.mean_stress(element.change) : 0.0);
  energy += element.volume * material.volume_energy(element.change);
}

} // namespace abut::solid
