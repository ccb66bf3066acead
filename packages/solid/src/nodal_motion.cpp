// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/nodal_motion.hpp"

#include "abut/core/error.hpp"
#include "kernels/motion.hpp"

#include <algorithm>
#include <utility>

namespace abut::solid {
namespace {

MotionState make_state(std::size_t n) {
  return {make_view<double>("abut::solid::displacement", n),
          make_view<double>("abut::solid::velocity", n),
          make_view<double>("abut::solid::acceleration", n)};
}

void copy(const MotionState& to, const MotionState& from) {
  Kokkos::deep_copy(to.u, from.u);
  Kokkos::deep_copy(to.velocity, from.velocity);
  Kokkos::deep_copy(to.acceleration, from.acceleration);
}

} // namespace

NodalMotion::NodalMotion(const TimeIntegration& rule, const std::vector<Lead>& lead)
    : rule_(rule), slopes_{make_view("abut::solid::lead", lead)}, last_(make_state(size())),
      trial_(make_state(size())),
      u_before_(make_view<double>("abut::solid::displacement_before", size())),
      velocity_before_(make_view<double>("abut::solid::velocity_before", size())) {}

void NodalMotion::start(double t, const std::vector<double>& u,
                        const std::vector<double>& velocity) {
  ABUT_REQUIRE(u.size() == size() && velocity.size() == size(), "one number for each");
  time_ = trial_time_ = t;
  before_ = 0.0;
  slopes_.free = slopes_.led = 1.0;
  std::copy(u.begin(), u.end(), last_.u.data());
  std::copy(velocity.begin(), velocity.end(), last_.velocity.data());
  Kokkos::deep_copy(last_.acceleration, 0.0);
  copy(trial_, last_);
  Kokkos::deep_copy(u_before_, last_.u);
  Kokkos::deep_copy(velocity_before_, last_.velocity);
}

void NodalMotion::set_acceleration(const std::vector<double>& acceleration) {
  ABUT_REQUIRE(acceleration.size() == size(), "one number for each");
  std::copy(acceleration.begin(), acceleration.end(), last_.acceleration.data());
  Kokkos::deep_copy(trial_.acceleration, last_.acceleration);
}

void NodalMotion::move(double t, const double* u) {
  const double dt = t - time_;
  trial_time_ = t;
  std::copy_n(u, size(), trial_.u.data());
  if (!(dt > 0.0)) {
    Kokkos::deep_copy(trial_.velocity, last_.velocity);
    Kokkos::deep_copy(trial_.acceleration, last_.acceleration);
    slopes_.free = slopes_.led = 1.0;
    return;
  }
  slopes_.free = rule_.acceleration_slope(dt);
  const double led_rate = backward_slope_slope(dt, before_ > 0.0 ? before_ : dt);
  slopes_.led = led_rate * led_rate;
  Kokkos::parallel_for(
      "abut::solid::trial_rates", Range(0, size()),
      TrialRates{rule_, dt, before_, slopes_.lead, last_, u_before_, velocity_before_, trial_});
}

void NodalMotion::exchange_state(StateArchive& archive, const std::vector<Global>& keys) {
  ABUT_REQUIRE(3 * keys.size() == size(), "three numbers for each node");
  archive.numbers("motion.time", [&](auto& v) { v(time_, before_); });
  archive.rows("motion.displacement", keys, 3, last_.u.data());
  archive.rows("motion.velocity", keys, 3, last_.velocity.data());
  archive.rows("motion.acceleration", keys, 3, last_.acceleration.data());
  archive.rows("motion.displacement_before", keys, 3, u_before_.data());
  archive.rows("motion.velocity_before", keys, 3, velocity_before_.data());
  if (!archive.takes())
    return;
  trial_time_ = time_;
  slopes_.free = slopes_.led = 1.0;
  copy(trial_, last_);
}

void NodalMotion::accept() {
  if (!(trial_time_ > time_))
    return;
  before_ = trial_time_ - time_;
  time_ = trial_time_;
  std::swap(u_before_, last_.u);
  std::swap(velocity_before_, last_.velocity);
  copy(last_, trial_);
}

} // namespace abut::solid
