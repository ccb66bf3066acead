// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/element_kernel.hpp"

/// Elements of one cell type and one material: gather, evaluate at the points, integrate, scatter.
namespace abut::solid {

/// What kernels read of the elements of a block. Copied by value; the arrays are shared.
template <fem::CellType C, class M> struct Elements {
  static constexpr int nodes = ReferenceCell<C>::nodes;

  CellArrays cells;
  View<const ReferenceCell<C>> table; ///< one
  M material;
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

template <fem::CellType C, class M> struct ElementResidual {
  Elements<C, M> elements;
  NodalFields fields;
  ResidualScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local e, SmallestDet::value_type& least) const {
    constexpr int n = Elements<C, M>::nodes;
    double x[3][n], u[3][n], r[3][n], out[3 * n];
    elements.cells.reference(e, x);
    elements.cells.displacements(e, fields, u);
    const double det = element_residual<C>(elements.table(0), elements.material, x, u, r);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        out[3 * a + i] = r[i][a];
    scatter.add(e, out, 3);
    keep_smallest(det, e, least);
  }
};

/// Elements that are turned over are left out.
template <fem::CellType C, class M> struct ElementTangent {
  Elements<C, M> elements;
  NodalFields fields;
  TangentScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local e, SmallestDet::value_type& least) const {
    constexpr int n = Elements<C, M>::nodes;
    double x[3][n], u[3][n], k[9 * n * n];
    elements.cells.reference(e, x);
    elements.cells.displacements(e, fields, u);
    const double det = element_tangent<C>(elements.table(0), elements.material, x, u, k);
    if (det > 0.0)
      scatter.add(e, k, 3);
    keep_smallest(det, e, least);
  }
};

template <fem::CellType C, class M> struct ElementAverages {
  Elements<C, M> elements;
  NodalFields fields;
  View<double> stress; ///< (elements, 6)
  View<double> energy; ///< (elements)

  KOKKOS_INLINE_FUNCTION void operator()(Local e) const {
    constexpr int n = Elements<C, M>::nodes;
    double x[3][n], u[3][n];
    elements.cells.reference(e, x);
    elements.cells.displacements(e, fields, u);
    element_averages<C>(elements.table(0), elements.material, x, u, &stress(voigt_size * e),
                        energy(e));
  }
};

} // namespace abut::solid
