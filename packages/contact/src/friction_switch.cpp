// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/friction_switch.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

constexpr double law_tolerance = 1e-8; ///< of mu p, within which a traction is the return map's

Vec3 within(const Vec3& t, double limit) {
  const double size = norm(t);
  return size > limit ? (limit / size) * t : t;
}

/// The present traction by the law of the last iterate, in the plane and within the cone.
Vec3 predicted(const ShearIterate& last, const Vec3& trial, const Vec3& normal, double limit) {
  const Vec3 t = last.slips ? slip_traction(last.line, limit, trial) : trial;
  return within(t - dot(normal, t) * normal, limit);
}

} // namespace

ShearChoice choose_shear(const ShearIterate& last, const Vec3& trial, const Vec3& normal,
                         double limit, double share, std::optional<bool> held_slip) {
  if (!last.pressed) // nothing to go on from
    share = 1.0;
  const Vec3 mixed = (1.0 - share) * predicted(last, trial, normal, limit) + share * trial;
  const double size = norm(mixed);
  ShearChoice choice;
  choice.slips = held_slip.value_or(size > limit) && size > 0.0;
  if (choice.slips) {
    const double ratio = std::min(1.0, limit / size);
    choice.line.direction = (1.0 / size) * mixed;
    choice.line.turning = share * ratio / (1.0 - (1.0 - share) * ratio);
    choice.traction = slip_traction(choice.line, limit, trial);
  } else {
    choice.traction = trial;
  }
  choice.settled = norm(choice.traction - within(trial, limit)) <= law_tolerance * limit;
  return choice;
}

} // namespace abut::contact
