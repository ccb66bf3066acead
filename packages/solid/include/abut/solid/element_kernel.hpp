// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/material.hpp"
#include "abut/solid/solid_point.hpp"
#include "abut/solid/tangent_blocks.hpp"

/// One displacement element: from nodal numbers to residual, tangent and averages. No mesh, no
/// allocation.
///
/// Arrays of an element are stored by component first, (3, nodes): the inner loops run over nodes.
/// Finite strain: r_a = int tau grad N_a dV, k_ab = int (B_a^T c B_b + grad N_a . tau grad N_b I)
/// dV with spatial gradients over the reference volume V (Bonet and Wood, chapter 9). Small strain:
/// the same with gradients by X and without the second, geometric term. Elements of other
/// formulations have headers of their own: mean_dilatation.hpp, enhanced.hpp.
namespace abut::solid {

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
    add_internal_force(cell.dN[p], point, stress, r);
  }
  return smallest;
}

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
