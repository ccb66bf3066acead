// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/enhanced.hpp"
#include "abut/solid/mean_dilatation.hpp"

/// Stress and strain at the integration points of an element, as output wants them.
namespace abut::solid {

/// In the order xx yy zz xy yz xz, shear strains as components of the tensor.
template <int P> struct PointValues {
  double volume[P];    ///< reference volume of the point; 0: turned over, and left out
  double stress[P][6]; ///< Cauchy
  double strain[P][6]; ///< Green-Lagrange at finite strain, else the small one
};

/// (H + H^T) / 2 and, at finite strain, H^T H / 2.
template <bool finite_strain>
KOKKOS_INLINE_FUNCTION void put_strain(const Deformation<double>& d, double strain[6]) {
  for (int v = 0; v < voigt_size; ++v) {
    const int i = voigt_row[v], j = voigt_column[v];
    double sum = d.H[i][j] + d.H[j][i];
    for (int k = 0; finite_strain && k < 3; ++k)
      sum += d.H[k][i] * d.H[k][j];
    strain[v] = 0.5 * sum;
  }
}

/// A Kirchhoff stress (small strain: J = 1) and a mean stress that is Cauchy's already.
KOKKOS_INLINE_FUNCTION void put_stress(const Mat3& tau, double J, double mean_stress,
                                       double stress[6]) {
  for (int v = 0; v < voigt_size; ++v)
    stress[v] = tau[voigt_row[v]][voigt_column[v]] / J + (v < 3 ? mean_stress : 0.0);
}

template <fem::CellType C, class M>
KOKKOS_INLINE_FUNCTION void element_points(const ReferenceCell<C>& cell, const M& material,
                                           const double (&x)[3][ReferenceCell<C>::nodes],
                                           const double (&u)[3][ReferenceCell<C>::nodes],
                                           PointValues<ReferenceCell<C>::points>& values) {
  SolidPoint<double> point;
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    const bool upright = point.set(M::finite_strain, cell.weight[p], cell.dN[p], x, u);
    values.volume[p] = upright ? point.volume : 0.0;
    if (!upright)
      continue;
    const double J = M::finite_strain ? point.deformation.jacobian() : 1.0;
    put_stress(material.stress(point.deformation), J, 0.0, values.stress[p]);
    put_strain<M::finite_strain>(point.deformation, values.strain[p]);
  }
}

template <fem::CellType C, class M>
KOKKOS_INLINE_FUNCTION void mean_dilatation_points(const ReferenceCell<C>& cell, const M& material,
                                                   const double (&x)[3][ReferenceCell<C>::nodes],
                                                   const double (&u)[3][ReferenceCell<C>::nodes],
                                                   PointValues<ReferenceCell<C>::points>& values) {
  DilatedElement<C, double> element;
  const bool upright = element.set(cell, x, u);
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    const SolidPoint<double>& point = element.point[p];
    values.volume[p] = upright ? point.volume : 0.0;
    if (!upright)
      continue;
    put_stress(material.isochoric_stress(point.deformation), point.deformation.jacobian(),
               material.mean_stress(element.change), values.stress[p]);
    put_strain<true>(point.deformation, values.strain[p]);
  }
}

/// Of the points of an enhanced element the mean deformation, which stands for the whole volume.
template <class M>
KOKKOS_INLINE_FUNCTION void enhanced_points(const EnhancedReference& reference, const M& material,
                                            const double (&u)[3][8], PointValues<1>& values) {
  EnhancedState<double> state;
  const bool upright = state.set(M::finite_strain, reference, u);
  values.volume[0] = upright ? reference.volume : 0.0;
  if (!upright)
    return;
  const double J = M::finite_strain ? state.deformation.jacobian() : 1.0;
  put_stress(material.stress(state.deformation), J, 0.0, values.stress[0]);
  put_strain<M::finite_strain>(state.deformation, values.strain[0]);
}

} // namespace abut::solid
