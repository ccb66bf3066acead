// SPDX-License-Identifier: BSD-3-Clause
#include "rigid_joints.hpp"

#include <algorithm>

namespace abut::app {

namespace {

using assembly::RigidJoint;
using solid::JointKind;

/// Components of RigidJoint that a kind leaves free.
std::array<bool, 6> free_components(JointKind kind) {
  switch (kind) {
  case JointKind::revolute:
    return {false, false, false, false, false, true};
  case JointKind::prismatic:
    return {false, false, true, false, false, false};
  case JointKind::cylindrical:
    return {false, false, true, false, false, true};
  case JointKind::spherical:
    return {false, false, false, true, true, true};
  case JointKind::lock:
    return {};
  case JointKind::spring:
    break;
  }
  return {true, true, true, true, true, true};
}

Vec3 vector(const std::array<double, 3>& v) {
  return {{v[0], v[1], v[2]}};
}

RigidJoint::Function history(const deck::Deck& deck, const std::optional<solid::Amount>& amount,
                             const std::string& curve, const Vec3& position) {
  if (!amount)
    return {};
  std::function<double(double)> factor;
  if (!curve.empty())
    factor = deck.curve(curve);
  return [amount = *amount, factor, position](double t) { return amount.at(position, t, factor); };
}

std::function<Vec3(double)> history(const deck::Deck& deck,
                                    const std::optional<std::array<solid::Amount, 3>>& amounts,
                                    const std::string& curve, const Vec3& position) {
  if (!amounts)
    return {};
  std::array<RigidJoint::Function, 3> each;
  for (std::size_t i = 0; i < 3; ++i)
    each[i] = history(deck, std::optional<solid::Amount>((*amounts)[i]), curve, position);
  return [each](double t) { return Vec3{{each[0](t), each[1](t), each[2](t)}}; };
}

RigidJoint make_joint(const deck::Deck& deck, const solid::JointOptions& o) {
  RigidJoint joint;
  joint.name = o.name;
  if (o.kind == JointKind::spring) {
    joint.origin = vector(o.from);
    joint.end = vector(o.to);
    joint.stiffness = o.stiffness;
    joint.free_length = o.free_length.value_or(norm(joint.end - joint.origin));
    return joint;
  }
  joint.origin = vector(o.origin);
  if (o.turns() || o.slides())
    joint.axis = vector(o.axis);
  joint.motion = {history(deck, o.translation, o.curve, joint.origin),
                  history(deck, o.rotation, o.curve, joint.origin)};
  joint.load = {history(deck, o.force, o.load_curve, joint.origin),
                history(deck, o.moment, o.load_curve, joint.origin)};
  joint.turn = history(deck, o.rotation_vector, o.curve, joint.origin);
  joint.couple = history(deck, o.moment_vector, o.load_curve, joint.origin);
  const std::array<bool, 6> free = free_components(o.kind);
  for (std::size_t i = 0; i < 6; ++i)
    joint.held[i] = !free[i] || joint.turn || (i % 3 == 2 && joint.motion[i / 3]);
  return joint;
}

} // namespace

std::vector<RigidJoint> rigid_joints(const deck::Deck& deck,
                                     const std::vector<assembly::RigidBody>& bodies) {
  std::vector<RigidJoint> result;
  for (const solid::JointOptions& options : deck.joints) {
    RigidJoint& joint = result.emplace_back(make_joint(deck, options));
    for (std::size_t k = 0; k < 2; ++k) {
      const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const auto& body) {
        return body.name == options.bodies[k];
      });
      if (found != bodies.end())
        joint.body[k] = static_cast<int>(found - bodies.begin());
    }
  }
  return result;
}

std::vector<assembly::RigidLink> rigid_links(const std::vector<RigidJoint>& joints) {
  std::vector<assembly::RigidLink> result;
  for (const RigidJoint& joint : joints)
    result.push_back({joint.body, !joint.is_spring()});
  return result;
}

} // namespace abut::app
