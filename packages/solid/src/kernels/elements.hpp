// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/element_kernel.hpp"
#include "abut/solid/enhanced_tangent.hpp"
#include "abut/solid/mean_dilatation.hpp"

/// Elements of one cell type, formulation and material: gather, evaluate, scatter.
///
/// Each kind of elements holds what kernels read of the elements of a block, and gives element e's
/// residual, tangent and averages as element_kernel.hpp says. Copied by value; arrays are shared.
namespace abut::solid {

/// Elements of the shape functions; dilated: with a mean dilatation.
template <fem::CellType C, class M, bool dilated> struct PointElements {
  static constexpr int nodes = ReferenceCell<C>::nodes;

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
};
template <fem::CellType C, class M> using DisplacementElements = PointElements<C, M, false>;
template <fem::CellType C, class M> using DilatedElements = PointElements<C, M, true>;

template <class M> struct EnhancedElements {
  static constexpr int nodes = EnhancedReference::nodes;

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

} // namespace abut::solid
