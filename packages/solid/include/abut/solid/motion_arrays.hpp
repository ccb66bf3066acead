// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/core/views.hpp"

namespace abut::solid {

/// What moves a number.
enum class Lead : char {
  free,       ///< its own equation
  prescribed, ///< a function of time
  rigid,      ///< the unknowns of a rigid body that turns
};

/// Displacements, velocities and accelerations of numbers (nodes times directions) at one time.
struct MotionState {
  View<double> u, velocity, acceleration;
};

/// Derivatives of accelerations by displacements.
struct MotionSlopes {
  View<const Lead> lead;
  double free = 1.0, led = 1.0;

  KOKKOS_INLINE_FUNCTION double operator()(Local number) const {
    return lead(number) == Lead::free ? free : led;
  }
};

} // namespace abut::solid
