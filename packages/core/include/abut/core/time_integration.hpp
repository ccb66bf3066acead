// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

namespace abut {

/// Velocity and acceleration of one number.
struct Rates {
  double velocity = 0.0, acceleration = 0.0;
};

/// Coefficients of Newmark's rule and of the equation of motion that goes with it. With the forces
/// f (internal minus external) and the rate i of momentum at the end (') and at the start (n) of a
/// step, (1 - alpha_f) f' + alpha_f f_n + (1 - alpha_m) i' + alpha_m i_n = 0 (Chung and Hulbert,
/// J. Appl. Mech. 60, 1993, with the trapezoidal mean of forces). docs/theory/dynamics.md
struct TimeIntegration {
  double beta = 0.25, gamma = 0.5;
  double alpha_m = 0.0, alpha_f = 0.0;

  /// Of second order; an infinitely fast vibration shrinks by this factor in each step, 0 to 1. At
  /// 1 nothing is lost, and the equation is that of the end of the step: the trapezoidal rule.
  static TimeIntegration with_spectral_radius(double radius) {
    TimeIntegration c;
    if (radius >= 1.0)
      return c;
    c.alpha_m = (2.0 * radius - 1.0) / (radius + 1.0);
    c.alpha_f = radius / (radius + 1.0);
    const double shift = c.alpha_f - c.alpha_m;
    c.gamma = 0.5 + shift;
    c.beta = 0.25 * (1.0 + shift) * (1.0 + shift);
    return c;
  }

  // The equation over 1 - alpha_f: f' + past_force() f_n + inertia() i' + past_inertia() i_n = 0.
  double past_force() const { return alpha_f / (1.0 - alpha_f); }
  double inertia() const { return (1.0 - alpha_m) / (1.0 - alpha_f); }
  double past_inertia() const { return alpha_m / (1.0 - alpha_f); }
  bool has_past() const { return alpha_m != 0.0 || alpha_f != 0.0; }

  /// Rates after a step dt > 0 by `increment`.
  KOKKOS_INLINE_FUNCTION Rates newmark(double dt, double increment, const Rates& last) const {
    const double a =
        (increment / dt - last.velocity) / (beta * dt) - (0.5 / beta - 1.0) * last.acceleration;
    return {last.velocity + dt * ((1.0 - gamma) * last.acceleration + gamma * a), a};
  }
  double velocity_slope(double dt) const { return gamma / (beta * dt); } ///< by the increment
  double acceleration_slope(double dt) const { return 1.0 / (beta * dt * dt); }

  /// Rate after a step dt > 0 by `increment`, with the weights of Newmark's velocity.
  KOKKOS_INLINE_FUNCTION double rate(double dt, double increment, double last) const {
    return (increment / dt - (1.0 - gamma) * last) / gamma;
  }
  double rate_slope(double dt) const { return 1.0 / (gamma * dt); }
};

/// Slope at the end of the parabola through three values, the last two dt apart, the first two
/// dt_before (Gear's second formula). What is given from outside takes this one: Newmark's rule
/// would answer a kink by oscillations that do not end.
KOKKOS_INLINE_FUNCTION double backward_slope(double dt, double dt_before, double value, double last,
                                             double before) {
  const double ratio = dt / dt_before;
  return ((1.0 + 2.0 * ratio) * (value - last) / dt - ratio * ratio * (last - before) / dt) /
         (1.0 + ratio);
}
/// Its derivative by the value.
KOKKOS_INLINE_FUNCTION double backward_slope_slope(double dt, double dt_before) {
  return (dt_before + 2.0 * dt) / ((dt_before + dt) * dt);
}

} // namespace abut
