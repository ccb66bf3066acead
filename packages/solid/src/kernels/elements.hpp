// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/element_kernel.hpp"
#include "abut/solid/enhanced_tangent.hpp"
#include "abut/solid/linear_fit.hpp"
#include "abut/solid/mean_dilatation.hpp"

/// Elements of one cell type, formulation and material: gather, evaluate, scatter.
///
/// Each kind of elements holds what kernels read of the elements of a block, and gives element e's
/// residual, tangent and averages as element_kernel.hpp says, its points as point_values.hpp does.
/// Copied by value; arrays are shared.
namespace abut::solid {

/// Elements of the shape functions; dilated: with a mean dilatation.
template <fem::CellType C, class M, bool dilated> struct PointElements {
  static constexpr int nodes = ReferenceCell<C>::nodes, points = ReferenceCell<C>::points;

  CellArrays cells;
  View<const ReferenceCell<C>> table; ///< one
  M material;

  template <class U> KOKKOS_INLINE_FUNCTION double residual(Local e, const U& u, U& r) const {
    double x[3][nodes];
    cells.reference(e, x);
    if constexpr (dilated)
      return mean_dilatation_residual<C>(table(0), material, x, u, r);
    else
      return element_residual<C>(table(0), material, x, u, r);
  }
  template <class U> KOKKOS_INLINE_FUNCTION double tangent(Local e, const U& u, double* k) const {
    double x[3][nodes];
    cells.reference(e, x);
    if constexpr (dilated)
      return mean_dilatation_tangent<C>(table(0), material, x, u, k);
    else
      return element_tangent<C>(table(0), material, x, u, k);
  }
  template <class U>
  KOKKOS_INLINE_FUNCTION void averages(Local e, const U& u, double* stress, double& energy) const {
    double x[3][nodes];
    cells.reference(e, x);
    if constexpr (dilated)
      mean_dilatation_averages<C>(table(0), material, x, u, stress, energy);
    else
      element_averages<C>(table(0), material, x, u, stress, energy);
  }
  /// at: their reference positions.
  KOKKOS_INLINE_FUNCTION void values(const double (&x)[3][nodes], const double (&u)[3][nodes],
                                     Local, PointValues<points>& values, Vec3 (&at)[points]) const {
    if constexpr (dilated)
      mean_dilatation_points<C>(table(0), material, x, u, values);
    else
      element_points<C>(table(0), material, x, u, values);
    for (int p = 0; p < points; ++p)
      for (int i = 0; i < 3; ++i)
        at[p][i] = nodal_sum(x[i], table(0).N[p]);
  }
};
template <fem::CellType C, class M> using DisplacementElements = PointElements<C, M, false>;
template <fem::CellType C, class M> using DilatedElements = PointElements<C, M, true>;

template <class M> struct EnhancedElements {
  static constexpr int nodes = EnhancedReference::nodes, points = 1;

  CellArrays cells;
  View<const EnhancedReference> reference; ///< (elements)
  M material;

  template <class U> KOKKOS_INLINE_FUNCTION double residual(Local e, const U& u, U& r) const {
    return enhanced_residual(reference(e), material, u, r);
  }
  template <class U> KOKKOS_INLINE_FUNCTION double tangent(Local e, const U& u, double* k) const {
    return enhanced_tangent(reference(e), material, u, k);
  }
  template <class U>
  KOKKOS_INLINE_FUNCTION void averages(Local e, const U& u, double* stress, double& energy) const {
    enhanced_averages(reference(e), material, u, stress, energy);
  }
  KOKKOS_INLINE_FUNCTION void values(const double (&)[3][nodes], const double (&u)[3][nodes],
                                     Local e, PointValues<1>& values, Vec3 (&at)[1]) const {
    enhanced_points(reference(e), material, u, values);
    at[0] = Vec3::zero();
  }
};

/// What enhanced elements know of their undeformed state.
struct EnhancedReferences {
  CellArrays cells;
  View<const HexTable> table; ///< one
  LameConstants law;          ///< at rest
  View<EnhancedReference> reference;

  KOKKOS_INLINE_FUNCTION void operator()(Local e) const {
    double x[3][EnhancedReference::nodes];
    cells.reference(e, x);
    reference(e) = enhanced_reference(table(0), x, law);
  }
};

/// The smallest det F of a loop and its element.
using SmallestDet = Kokkos::MinLoc<double, Local, Kokkos::HostSpace>;

/// Keeps the smaller one; what is not a number is the smallest of all.
KOKKOS_INLINE_FUNCTION void keep_smallest(double det, Local element,
                                          SmallestDet::value_type& least) {
  if (det >= least.val)
    return;
  least.val = det != det ? -HUGE_VAL : det;
  least.loc = element;
}

template <class E> struct ElementResidual {
  E elements;
  NodalFields fields;
  ResidualScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local e, SmallestDet::value_type& least) const {
    constexpr int n = E::nodes;
    double u[3][n], r[3][n], out[3 * n];
    elements.cells.displacements(e, fields, u);
    const double det = elements.residual(e, u, r);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        out[3 * a + i] = r[i][a];
    scatter.add(e, out, 3);
    keep_smallest(det, e, least);
  }
};

/// Elements that are turned over are left out.
template <class E> struct ElementTangent {
  E elements;
  NodalFields fields;
  TangentScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local e, SmallestDet::value_type& least) const {
    constexpr int n = E::nodes;
    double u[3][n], k[9 * n * n];
    elements.cells.displacements(e, fields, u);
    const double det = elements.tangent(e, u, k);
    if (det > 0.0)
      scatter.add(e, k, 3);
    keep_smallest(det, e, least);
  }
};

template <class E> struct ElementAverages {
  E elements;
  NodalFields fields;
  View<double> stress; ///< (elements, 6)
  View<double> energy; ///< (elements)

  KOKKOS_INLINE_FUNCTION void operator()(Local e) const {
    double u[3][E::nodes];
    elements.cells.displacements(e, fields, u);
    elements.averages(e, u, &stress(voigt_size * e), energy(e));
  }
};

template <class E> struct ElementRecovery {
  E elements;
  NodalFields fields;
  View<double> volume; ///< (elements) reference
  View<double> strain; ///< (elements, 6) averaged over it
  View<double> stress; ///< (elements, nodes, 6) of the linear fit

  KOKKOS_INLINE_FUNCTION void operator()(Local e) const {
    double x[3][E::nodes], u[3][E::nodes];
    elements.cells.reference(e, x);
    elements.cells.displacements(e, fields, u);
    PointValues<E::points> values;
    Vec3 at[E::points];
    elements.values(x, u, e, values, at);
    const LinearFit fit(values, at);
    volume(e) = fit.volume();
    fit.at_nodes(values, at, values.stress, x, &stress(voigt_size * E::nodes * e));
    for (int v = 0; v < voigt_size; ++v) {
      double& mean = strain(voigt_size * e + v) = 0.0;
      for (int p = 0; p < E::points; ++p)
        if (values.volume[p] > 0.0)
          mean += values.volume[p] / fit.volume() * values.strain[p][v];
    }
  }
};

} // namespace abut::solid
