// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/bodies.hpp"

#include "abut/core/trilinos.hpp"
#include "abut/rigid/rotation.hpp"

namespace abut::rigid {

void Bodies::start(const TimeIntegration& rule) {
  inertia_.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies_[b];
    std::array<bool, 3> led{};
    bool turns_led = true;
    for (std::size_t i = 0; i < 3; ++i) {
      led[i] = static_cast<bool>(body.prescribed[i]);
      turns_led = turns_led && body.prescribed[3 + i];
    }
    inertia_.emplace_back(body.mass, rule, led, turns_led);
    inertia_.back().start(placements_[b].displacement, placements_[b].rotation, body.velocity,
                          body.spin);
  }
}

void Bodies::accelerate(const Vector& x) {
  const std::vector<double> a = all_unknowns(x);
  for (std::size_t b = 0; b < inertia_.size(); ++b) {
    const Vec3 angular{{a[6 * b + 3], a[6 * b + 4], a[6 * b + 5]}};
    inertia_[b].accelerate({{a[6 * b], a[6 * b + 1], a[6 * b + 2]}}, 1.0 / length_[b] * angular);
  }
}

void Bodies::move_masses(double dt) {
  for (std::size_t b = 0; b < inertia_.size(); ++b) {
    const Placement& p = placements_[b];
    const Vec3 step = bodies_[b].has_unknowns()
                          ? p.step_rotation
                          : rotation_vector(p.rotation * transpose(inertia_[b].accepted_rotation()),
                                            Vec3::zero());
    inertia_[b].move(dt, p.displacement, p.rotation, step);
  }
}

void Bodies::add_inertia(double* residual) const {
  for (std::size_t b = 0; b < inertia_.size(); ++b) {
    if (!owns(b))
      continue;
    const Vec3 force = inertia_[b].force(), moment = inertia_[b].moment();
    double* out = residual + first_owned_row(b);
    for (int i = 0; i < 3; ++i) {
      out[i] += force[i];
      out[3 + i] += moment[i] / length_[b];
    }
  }
}

void Bodies::add_inertia_tangent(double weight, const unknowns::BlockPattern& pattern,
                                 double* values) const {
  for (std::size_t b = 0; b < inertia_.size(); ++b) {
    if (!owns(b))
      continue;
    const Inertia::Tangent k = inertia_[b].tangent();
    add_block(pattern, b, 0, 0, weight, k.force_by_displacement, values);
    add_block(pattern, b, 0, 1, weight, k.force_by_rotation, values);
    add_block(pattern, b, 1, 0, weight, k.moment_by_displacement, values);
    add_block(pattern, b, 1, 1, weight, k.moment_by_rotation, values);
  }
}

void Bodies::put_rates(const Vector& x, double* rates) const {
  const std::vector<double> a = all_unknowns(x);
  for (Local n = 0; !bodies_.empty() && n < dofs_.mesh().num_local(); ++n) {
    if (dofs_.body_of_node(n) < 0)
      continue;
    const auto b = static_cast<std::size_t>(dofs_.body_of_node(n));
    const double* at = &dofs_.mesh().x[3 * static_cast<std::size_t>(n)];
    const Vec3 arm = placements_[b].rotation * (Vec3{{at[0], at[1], at[2]}} - bodies_[b].center);
    const Vec3 angular{{a[6 * b + 3], a[6 * b + 4], a[6 * b + 5]}};
    const Vec3 turning = 1.0 / length_[b] * cross(angular, arm);
    for (int i = 0; i < 3; ++i)
      rates[3 * std::size_t(n) + std::size_t(i)] = a[6 * b + std::size_t(i)] + turning[i];
  }
}

std::vector<BodyMotion> Bodies::motions() const {
  std::vector<BodyMotion> result;
  for (std::size_t b = 0; b < inertia_.size(); ++b) {
    const Inertia& inertia = inertia_[b];
    result.push_back({inertia.velocity(), inertia.angular_velocity(), inertia.kinetic_energy(),
                      inertia.linear_momentum(),
                      inertia.angular_momentum(bodies_[b].center + placements_[b].displacement)});
  }
  return result;
}

} // namespace abut::rigid
