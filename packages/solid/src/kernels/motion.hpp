// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/time_integration.hpp"
#include "abut/solid/motion_arrays.hpp"

namespace abut::solid {

/// Rates of the trial state at its displacements, a step dt > 0 after the last state. Free numbers
/// move by Newmark's rule, the others by backward differences.
struct TrialRates {
  TimeIntegration rule;
  double dt;
  double before; ///< length of the last step; 0: there was none
  View<const Lead> lead;
  MotionState last;
  View<const double> u_before, velocity_before; ///< one step earlier
  MotionState trial;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    const double u = trial.u(i), v = last.velocity(i), a = last.acceleration(i);
    if (lead(i) == Lead::free) {
      const Rates r = rule.newmark(dt, u - last.u(i), {v, a});
      trial.velocity(i) = r.velocity;
      trial.acceleration(i) = r.acceleration;
      return;
    }
    const bool first = before == 0.0; // the history that a uniform acceleration would have left
    const double interval = first ? dt : before;
    const double u0 = first ? last.u(i) - dt * v + 0.5 * dt * dt * a : u_before(i);
    const double v0 = first ? v - dt * a : velocity_before(i);
    trial.velocity(i) = backward_slope(dt, interval, u, last.u(i), u0);
    trial.acceleration(i) = backward_slope(dt, interval, trial.velocity(i), v, v0);
  }
};

} // namespace abut::solid
