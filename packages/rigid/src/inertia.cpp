// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/inertia.hpp"

#include "abut/rigid/rotation.hpp"

namespace abut::rigid {

namespace {

Mat3 sum(double p, const Mat3& a, double q, const Mat3& b) {
  Mat3 r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      r[i][j] = p * a[i][j] + q * b[i][j];
  return r;
}

} // namespace

Inertia::Inertia(const Mass& mass, const TimeIntegration& rule, std::array<bool, 3> led,
                 bool turns_led)
    : mass_(mass), rule_(rule), led_(led), turns_led_(turns_led) {}

void Inertia::set_momenta() {
  now_.swing = cross(angular_velocity(), arm());
  now_.momentum = now_.rotation * (mass_.inertia * now_.spin);
}

void Inertia::start(const Vec3& displacement, const Mat3& rotation, const Vec3& velocity,
                    const Vec3& spin) {
  now_ = State();
  now_.displacement = displacement;
  now_.velocity = velocity;
  now_.rotation = rotation;
  now_.spin = transpose(rotation) * spin;
  set_momenta();
  now_.swing_rate = cross(spin, now_.swing);
  now_.moment = cross(spin, now_.momentum);
  last_ = now_;
  dt_ = before_ = 0.0;
}

void Inertia::accelerate(const Vec3& center, const Vec3& angular) {
  const Mat3 back = transpose(now_.rotation);
  now_.acceleration += center;
  now_.spin_rate += back * angular;
  now_.swing_rate += cross(angular, arm());
  now_.moment += now_.rotation * (mass_.inertia * (back * angular));
  last_ = now_;
}

void Inertia::move_center(double dt, const Vec3& displacement) {
  now_.displacement = displacement;
  const bool first = before_ == 0.0;
  const double before = first ? dt : before_;
  for (int i = 0; i < 3; ++i) {
    const double u = last_.displacement[i], v = last_.velocity[i], a = last_.acceleration[i];
    if (!led_[std::size_t(i)]) {
      const Rates r = rule_.newmark(dt, displacement[i] - u, {v, a});
      now_.velocity[i] = r.velocity;
      now_.acceleration[i] = r.acceleration;
      continue;
    }
    const double u0 = first ? u - dt * v + 0.5 * dt * dt * a : displacement_before_[i];
    const double v0 = first ? v - dt * a : velocity_before_[i];
    now_.velocity[i] = backward_slope(dt, before, displacement[i], u, u0);
    now_.acceleration[i] = backward_slope(dt, before, now_.velocity[i], v, v0);
  }
}

void Inertia::turn(double dt, const Mat3& rotation, const Vec3& step_rotation) {
  now_.rotation = rotation;
  step_rotation_ = step_rotation;
  const Vec3 increment = transpose(last_.rotation) * step_rotation;
  for (int i = 0; i < 3; ++i) {
    const Rates r = turns_led_
                        ? Rates{increment[i] / dt, 0.0}
                        : rule_.newmark(dt, increment[i], {last_.spin[i], last_.spin_rate[i]});
    now_.spin[i] = r.velocity;
    now_.spin_rate[i] = r.acceleration;
  }
  set_momenta();
  const auto rate = [&](double change, double last) {
    return turns_led_ ? change / dt : rule_.rate(dt, change, last);
  };
  for (int i = 0; i < 3; ++i) {
    now_.swing_rate[i] = rate(now_.swing[i] - last_.swing[i], last_.swing_rate[i]);
    now_.moment[i] = rate(now_.momentum[i] - last_.momentum[i], last_.moment[i]);
  }
}

void Inertia::move(double dt, const Vec3& displacement, const Mat3& rotation,
                   const Vec3& step_rotation) {
  dt_ = dt > 0.0 ? dt : 0.0;
  if (dt_ == 0.0) {
    now_ = last_;
    step_rotation_ = Vec3::zero();
    return;
  }
  move_center(dt_, displacement);
  turn(dt_, rotation, step_rotation);
}

void Inertia::accept() {
  if (dt_ == 0.0)
    return;
  before_ = dt_;
  displacement_before_ = last_.displacement;
  velocity_before_ = last_.velocity;
  last_ = now_;
  dt_ = 0.0;
}

Vec3 Inertia::force() const {
  return mass_.mass * (now_.acceleration + now_.swing_rate);
}

Vec3 Inertia::moment() const {
  return now_.moment + cross(arm(), force());
}

Inertia::Tangent Inertia::tangent() const {
  const double m = mass_.mass;
  const Vec3 c = arm(), w = angular_velocity();
  const Mat3 lever = skew(c), turned = now_.rotation * mass_.inertia;
  Tangent k;
  Mat3 slope = Mat3::zero(); // of the acceleration of the center
  if (dt_ == 0.0) {
    k.force_by_displacement = sum(m, Mat3::identity(), 0.0, slope);
    k.force_by_rotation = sum(-m, lever, 0.0, slope);
    k.moment_by_displacement = sum(m, lever, 0.0, slope);
    k.moment_by_rotation = sum(1.0, turned * transpose(now_.rotation), -m, lever * lever);
    return k;
  }
  const double led = backward_slope_slope(dt_, before_ == 0.0 ? dt_ : before_);
  for (int i = 0; i < 3; ++i)
    slope[i][i] = led_[std::size_t(i)] ? led * led : rule_.acceleration_slope(dt_);
  const double by_increment = turns_led_ ? 1.0 / dt_ : rule_.velocity_slope(dt_);
  const double rate = turns_led_ ? 1.0 / dt_ : rule_.rate_slope(dt_);
  const Mat3 t = rotation_tangent(step_rotation_), back = transpose(last_.rotation);
  const Mat3 spin = sum(by_increment, now_.rotation * back, -1.0, skew(w) * t);
  const Mat3 arm_by = sum(-1.0, lever * t, 0.0, t);
  const Mat3 swing = sum(-1.0, lever * spin, 1.0, skew(w) * arm_by);
  const Mat3 momentum = sum(by_increment, turned * back, -1.0, skew(now_.momentum) * t);
  k.force_by_displacement = sum(m, slope, 0.0, slope);
  k.force_by_rotation = sum(m * rate, swing, 0.0, t);
  k.moment_by_displacement = sum(m, lever * slope, 0.0, t);
  k.moment_by_rotation = sum(rate, momentum, 1.0, lever * k.force_by_rotation);
  k.moment_by_rotation = sum(1.0, k.moment_by_rotation, -1.0, skew(force()) * arm_by);
  return k;
}

double Inertia::kinetic_energy() const {
  const Vec3 v = now_.velocity + now_.swing;
  return 0.5 * (mass_.mass * dot(v, v) + dot(now_.spin, mass_.inertia * now_.spin));
}

Vec3 Inertia::angular_momentum(const Vec3& center) const {
  return now_.momentum + cross(center + arm(), linear_momentum());
}

} // namespace abut::rigid
