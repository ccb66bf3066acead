// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/rigid/joints.hpp"
#include "abut/rigid/rotation.hpp"

#include <cmath>

namespace abut::rigid {

namespace {

constexpr double closed_tolerance = 1e-9; ///< of lengths to the joint's size, of angles
constexpr double consistent_tolerance = 1e-4;

const char* const component_names[6] = {
    "translation across its axis", "translation across its axis", "translation along its axis",
    "rotation across its axis",    "rotation across its axis",    "rotation about its axis"};

} // namespace

bool Joints::closed() const {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; i < 6; ++i)
      if (role(j, i) == Role::held &&
          !(std::fabs(deviation_[6 * j + i]) <= closed_tolerance * (i < 3 ? length_[j] : 1.0)))
        return false;
  return true;
}

double Joints::rounding_force2() const {
  double sum = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; i < 6; ++i) {
      const Sides& s = sides_[j];
      const double size = norm(s.a.point) + norm(s.a.arm()) + norm(s.b.arm()) + length_[j];
      if (role(j, i) == Role::held)
        sum += stiffness_ * stiffness_ * size * size;
    }
  return sum;
}

std::vector<std::pair<std::string, std::string>> Joints::implied() const {
  std::vector<std::pair<std::string, std::string>> list;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; i < 6; ++i)
      if (role(j, i) == Role::implied)
        list.emplace_back(joints_[j].name, component_names[i]);
  return list;
}

void Joints::require_consistent() const {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; i < 6; ++i)
      if (role(j, i) == Role::implied &&
          !(std::fabs(deviation_[6 * j + i]) <= consistent_tolerance * (i < 3 ? length_[j] : 1.0)))
        throw SolveError("Joint '" + joints_[j].name + "' cannot hold its " + component_names[i] +
                         ": other joints and prescribed components hold these bodies otherwise.");
}

std::vector<JointState> Joints::states() const {
  std::vector<JointState> result(joints_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    JointState& state = result[j];
    const Joint& joint = joints_[j];
    const Sides& s = sides_[j];
    const PairVector f = pair_force(j);
    state.force = -f[2];
    state.moment = cross(s.b.arm(), f[2]) - f[3];
    if (joint.is_spring()) {
      state.translation = Spring{joint.stiffness, joint.free_length}.elongation(s.a, s.b);
      state.energy = 0.5 * joint.stiffness * state.translation * state.translation;
      continue;
    }
    state.translation = joint_value(s.a, s.b, Joint::along);
    state.rotation = angle_[j];
    state.axial = {-factor(j, Joint::along), -factor(j, Joint::about)};
    const Mat3 a = rotation_of(j, 0), b = rotation_of(j, 1);
    if (joint.turn || !joint.held[3]) {
      const Vec3 near = joint.turn ? joint.turn(time_) : Vec3::zero();
      state.rotation = norm(rotation_vector(transpose(a) * b, near));
    }
    const auto since = [&](const Mat3& r, int which) {
      return rotation_vector(r * transpose(accepted_rotation_[j][std::size_t(which)]),
                             Vec3::zero());
    };
    state.step_rotation = since(b, 1) - since(a, 0);
  }
  return result;
}

std::array<double, 2> Joints::work(const std::vector<JointState>& last,
                                   const std::vector<JointState>& now) const {
  std::array<double, 2> sums{};
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const JointState &a = last[j], &z = now[j];
    if (joints_[j].turn || joints_[j].couple) {
      sums[joints_[j].turn ? 1 : 0] += 0.5 * dot(a.moment + z.moment, z.step_rotation);
      continue;
    }
    const double moved[2] = {z.translation - a.translation, z.rotation - a.rotation};
    for (std::size_t k = 0; k < 2; ++k)
      sums[joints_[j].held[3 * k + 2] ? 1 : 0] += 0.5 * (a.axial[k] + z.axial[k]) * moved[k];
  }
  return sums;
}

} // namespace abut::rigid
