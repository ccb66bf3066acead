// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/penalty_error.hpp"

#include <algorithm>
#include <cmath>

namespace abut::scene {

namespace {

/// Bodies that hold less than this part of the energy are as good as rigid: the penalty is all the
/// stiffness there is.
constexpr double least_share = 1e-6;

} // namespace

void PenaltyWatch::look(const State& state) {
  double soft = 0.0;
  for (const auto& c : state.contacts)
    soft += c.softness;
  const double of_bodies = std::max(state.energy.stored, 0.0) + state.energy.kinetic;
  const double energy = of_bodies + std::max(soft, 0.0);
  if (last_.size() == 3)
    last_.erase(last_.begin());
  last_.push_back({state.time, energy});
  error_ = {};
  const bool has_elastic = of_bodies > least_share * std::fabs(soft);
  const double scale = has_elastic ? stiffening() / energy : 0.0;
  error_.whole = scale * std::fabs(soft);
  for (const auto& c : state.contacts) {
    error_.contacts.push_back(scale * std::fabs(c.softness));
    const double pressed = c.normal > 0.0 ? c.max_penetration * c.normal : 0.0;
    error_.penetration_over_approach.push_back(has_elastic ? pressed / (2.0 * energy) : 0.0);
  }
}

/// 2 E E''/E'^2: 1 where E grows with the square of the load, from whenever on.
double PenaltyWatch::stiffening() const {
  if (last_.size() < 3)
    return 1.0;
  const Stored &a = last_[0], &b = last_[1], &c = last_[2];
  const double before = (b.energy - a.energy) / (b.t - a.t),
               after = (c.energy - b.energy) / (c.t - b.t);
  const double curvature = 2.0 * (after - before) / (c.t - a.t);
  const double slope = after + 0.5 * curvature * (c.t - b.t);
  const bool is_pressed_on = slope * c.t > c.energy; // else it is held, slides or is let go
  return is_pressed_on ? std::clamp(2.0 * c.energy * curvature / (slope * slope), 1.0, 2.0) : 1.0;
}

} // namespace abut::scene
