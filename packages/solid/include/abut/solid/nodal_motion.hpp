// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"
#include "abut/core/time_integration.hpp"
#include "abut/solid/motion_arrays.hpp"

#include <vector>

namespace abut::solid {

/// Velocity and acceleration of numbers (nodes times directions) whose displacements are known.
/// Free numbers move by Newmark's rule, the others by backward differences.
class NodalMotion {
public:
  NodalMotion(const TimeIntegration& rule, const std::vector<Lead>& lead);
  NodalMotion(const NodalMotion&) = delete; // a copy would share the arrays
  NodalMotion& operator=(const NodalMotion&) = delete;

  std::size_t size() const { return slopes_.lead.extent(0); }
  const TimeIntegration& rule() const { return rule_; }

  /// Displacements and velocities at t; accelerations zero.
  void start(double t, const std::vector<double>& u, const std::vector<double>& velocity);
  /// Of the start, before the first step.
  void set_acceleration(const std::vector<double>& acceleration);

  /// Trial state at displacements u and time t >= that of the last accepted state; there it is that
  /// state itself.
  void move(double t, const double* u);
  void accept(); ///< the trial state becomes history

  /// The last accepted state and what the next one is made of. keys: of the nodes, three numbers
  /// each.
  void exchange_state(StateArchive& archive, const std::vector<Global>& keys);

  /// Of the trial state; the views follow it.
  View<const double> velocity() const { return trial_.velocity; }
  View<const double> acceleration() const { return trial_.acceleration; }
  /// Derivative of the acceleration by the displacement in the trial state; 1 where no time has
  /// gone by.
  const MotionSlopes& slopes() const { return slopes_; }

private:
  TimeIntegration rule_;
  double time_ = 0.0, trial_time_ = 0.0;
  double before_ = 0.0; ///< length of the last step; 0: there was none
  MotionSlopes slopes_;
  MotionState last_, trial_;
  View<double> u_before_, velocity_before_; ///< of led numbers, one step earlier
};

} // namespace abut::solid
