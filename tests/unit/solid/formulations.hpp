// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/element_kernel.hpp"
#include "abut/solid/enhanced_tangent.hpp"
#include "abut/solid/mean_dilatation.hpp"

/// Elements of each formulation from nodal positions and displacements alone.
namespace abut::solid {

struct Displacement {
  template <fem::CellType C, class M, class X, class U>
  static double residual(const M& law, const X& x, const U& u, U& r) {
    return element_residual<C>(reference_cell<C>(), law, x, u, r);
  }
  template <fem::CellType C, class M, class X>
  static double tangent(const M& law, const X& x, const X& u, double* k) {
    return element_tangent<C>(reference_cell<C>(), law, x, u, k);
  }
  template <fem::CellType C, class M, class X>
  static void averages(const M& law, const X& x, const X& u, double stress[6], double& energy) {
    element_averages<C>(reference_cell<C>(), law, x, u, stress, energy);
  }
};

struct MeanDilatation {
  template <fem::CellType C, class M, class X, class U>
  static double residual(const M& law, const X& x, const U& u, U& r) {
    return mean_dilatation_residual<C>(reference_cell<C>(), law, x, u, r);
  }
  template <fem::CellType C, class M, class X>
  static double tangent(const M& law, const X& x, const X& u, double* k) {
    return mean_dilatation_tangent<C>(reference_cell<C>(), law, x, u, k);
  }
  template <fem::CellType C, class M, class X>
  static void averages(const M& law, const X& x, const X& u, double stress[6], double& energy) {
    mean_dilatation_averages<C>(reference_cell<C>(), law, x, u, stress, energy);
  }
};

struct Enhanced {
  template <class M, class X> static EnhancedReference reference(const M& law, const X& x) {
    return enhanced_reference(reference_cell<fem::CellType::hex8>(), x, at_rest(law));
  }
  template <fem::CellType C, class M, class X, class U>
  static double residual(const M& law, const X& x, const U& u, U& r) {
    return enhanced_residual(reference(law, x), law, u, r);
  }
  template <fem::CellType C, class M, class X>
  static double tangent(const M& law, const X& x, const X& u, double* k) {
    return enhanced_tangent(reference(law, x), law, u, k);
  }
  template <fem::CellType C, class M, class X>
  static void averages(const M& law, const X& x, const X& u, double stress[6], double& energy) {
    enhanced_averages(reference(law, x), law, u, stress, energy);
  }
};

} // namespace abut::solid
