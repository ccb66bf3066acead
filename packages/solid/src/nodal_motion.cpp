// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/nodal_motion.hpp"

#include "abut/core/error.hpp"

namespace abut::solid {

NodalMotion::NodalMotion(const TimeIntegration& rule, std::vector<Lead> lead)
    : rule_(rule), lead_(std::move(lead)) {
  start(0.0, std::vector<double>(size(), 0.0), std::vector<double>(size(), 0.0));
}

void NodalMotion::start(double t, std::vector<double> u, std::vector<double> velocity) {
  ABUT_REQUIRE(u.size() == size() && velocity.size() == size(), "one number for each");
  time_ = trial_time_ = t;
  before_ = 0.0;
  free_slope_ = led_slope_ = 1.0;
  u_ = trial_u_ = std::move(u);
  velocity_ = trial_velocity_ = std::move(velocity);
  acceleration_.assign(size(), 0.0);
  trial_acceleration_ = acceleration_;
  u_before_ = u_;
  velocity_before_ = velocity_;
}

void NodalMotion::set_acceleration(std::vector<double> acceleration) {
  ABUT_REQUIRE(acceleration.size() == size(), "one number for each");
  acceleration_ = trial_acceleration_ = std::move(acceleration);
}

void NodalMotion::move(double t, const double* u) {
  const double dt = t - time_;
  trial_time_ = t;
  trial_u_.assign(u, u + size());
  if (!(dt > 0.0)) {
    trial_velocity_ = velocity_;
    trial_acceleration_ = acceleration_;
    free_slope_ = led_slope_ = 1.0;
    return;
  }
  free_slope_ = rule_.acceleration_slope(dt);
  const double before = before_ > 0.0 ? before_ : dt;
  const double led_rate = backward_slope_slope(dt, before);
  led_slope_ = led_rate * led_rate;
  for (std::size_t i = 0; i < size(); ++i) {
    if (lead_[i] == Lead::free) {
      const Rates r = rule_.newmark(dt, u[i] - u_[i], {velocity_[i], acceleration_[i]});
      trial_velocity_[i] = r.velocity;
      trial_acceleration_[i] = r.acceleration;
      continue;
    }
    const bool first = before_ == 0.0; // the history that a uniform acceleration would have left
    const double u0 =
        first ? u_[i] - dt * velocity_[i] + 0.5 * dt * dt * acceleration_[i] : u_before_[i];
    const double v0 = first ? velocity_[i] - dt * acceleration_[i] : velocity_before_[i];
    trial_velocity_[i] = backward_slope(dt, before, u[i], u_[i], u0);
    trial_acceleration_[i] = backward_slope(dt, before, trial_velocity_[i], velocity_[i], v0);
  }
}

void NodalMotion::accept() {
  if (!(trial_time_ > time_))
    return;
  before_ = trial_time_ - time_;
  time_ = trial_time_;
  u_before_.swap(u_);
  velocity_before_.swap(velocity_);
  u_ = trial_u_;
  velocity_ = trial_velocity_;
  acceleration_ = trial_acceleration_;
}

} // namespace abut::solid
