// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/time_integration.hpp"

#include <vector>

namespace abut::solid {

/// What moves a number.
enum class Lead : char {
  free,       ///< its own equation
  prescribed, ///< a function of time
  rigid,      ///< the unknowns of a rigid body that turns
};

/// Velocity and acceleration of numbers (nodes times directions) whose displacements are known.
/// Free numbers move by Newmark's rule, the others by backward differences.
class NodalMotion {
public:
  NodalMotion(const TimeIntegration& rule, std::vector<Lead> lead);

  std::size_t size() const { return lead_.size(); }
  const TimeIntegration& rule() const { return rule_; }

  /// Displacements and velocities at t; accelerations zero.
  void start(double t, std::vector<double> u, std::vector<double> velocity);
  /// Of the start, before the first step.
  void set_acceleration(std::vector<double> acceleration);

  /// Trial state at displacements u and time t >= that of the last accepted state; there it is that
  /// state itself.
  void move(double t, const double* u);
  void accept(); ///< the trial state becomes history

  const std::vector<double>& velocity() const { return trial_velocity_; }
  const std::vector<double>& acceleration() const { return trial_acceleration_; }
  /// Derivative of the acceleration by the displacement in the trial state; 1 where no time has
  /// gone by.
  double slope(std::size_t number) const {
    return lead_[number] == Lead::free ? free_slope_ : led_slope_;
  }

private:
  TimeIntegration rule_;
  std::vector<Lead> lead_;
  double time_ = 0.0, trial_time_ = 0.0;
  double before_ = 0.0; ///< length of the last step; 0: there was none
  double free_slope_ = 1.0, led_slope_ = 1.0;
  std::vector<double> u_, velocity_, acceleration_;
  std::vector<double> u_before_, velocity_before_; ///< of led numbers, one step earlier
  std::vector<double> trial_u_, trial_velocity_, trial_acceleration_;
};

} // namespace abut::solid
