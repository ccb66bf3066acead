// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/fem/cell.hpp"
#include "abut/solid/mass_arrays.hpp"
#include "abut/solid/motion_arrays.hpp"

/// Rates of momentum of cells with mass matrices. Arrays of nodes are (N,3).
namespace abut::solid {

struct InertiaResidual {
  MassArrays mass;
  View<const double> acceleration;
  ResidualScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local c) const {
    const Local first = mass.cells.first(c);
    const int n = mass.cells.nodes(c);
    double r[3 * fem::max_cell_nodes] = {};
    for (int b = 0; b < n; ++b) {
      const double* of = &acceleration(3 * mass.cells.node(first + b));
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i)
          r[3 * a + i] += mass(c, a, b) * of[i];
    }
    scatter.add(c, r, 3);
  }
};

struct InertiaTangent {
  MassArrays mass;
  MotionSlopes slopes;
  TangentScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local c) const {
    const Local first = mass.cells.first(c);
    const int n = mass.cells.nodes(c);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        double block[9] = {};
        for (int i = 0; i < 3; ++i)
          block[4 * i] = mass(c, a, b) * slopes(3 * mass.cells.node(first + b) + i);
        scatter.add_block(c, a, b, block, 3, 3);
      }
  }
};

/// Sums of kinetic energy, linear and angular momentum about the origin.
struct CellMomentum {
  using value_type = double[];
  static constexpr unsigned value_count = 7;

  MassArrays mass;
  View<const double> velocity;
  NodalFields fields;

  KOKKOS_INLINE_FUNCTION void operator()(Local c, double* sums) const {
    const Local first = mass.cells.first(c);
    const int n = mass.cells.nodes(c);
    for (int a = 0; a < n; ++a) {
      const Vec3 of_a = velocity_of(first + a);
      Vec3 of_all = Vec3::zero(); // momentum of the node's share
      for (int b = 0; b < n; ++b)
        of_all += mass(c, a, b) * velocity_of(first + b);
      const Vec3 x = mass.cells.x(first + a) + mass.cells.displacement(first + a, fields);
      const Vec3 turning = cross(x, of_all);
      sums[0] += 0.5 * dot(of_a, of_all);
      for (int i = 0; i < 3; ++i) {
        sums[1 + i] += of_all[i];
        sums[4 + i] += turning[i];
      }
    }
  }

private:
  KOKKOS_INLINE_FUNCTION Vec3 velocity_of(Local entry) const {
    const double* v = &velocity(3 * mass.cells.node(entry));
    return {{v[0], v[1], v[2]}};
  }
};

} // namespace abut::solid
