// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/make.hpp"

#include <algorithm>

namespace abut::rigid {

namespace {

/// Components of Joint that a kind leaves free.
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

Joint::Function history(const std::vector<Curve>& curves, const std::optional<Amount>& amount,
                        const std::string& curve, const Vec3& position) {
  if (!amount)
    return {};
  return [amount = *amount, factor = given_curve(curves, curve), position](double t) {
    return amount.at(position, t, factor);
  };
}

std::function<Vec3(double)> history(const std::vector<Curve>& curves,
                                    const std::optional<std::array<Amount, 3>>& amounts,
                                    const std::string& curve, const Vec3& position) {
  if (!amounts)
    return {};
  std::array<Joint::Function, 3> each;
  for (std::size_t i = 0; i < 3; ++i)
    each[i] = history(curves, std::optional<Amount>((*amounts)[i]), curve, position);
  return [each](double t) { return Vec3{{each[0](t), each[1](t), each[2](t)}}; };
}

Joint make_joint(const std::vector<Curve>& curves, const JointOptions& o) {
  Joint joint;
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
  joint.motion = {history(curves, o.translation, o.curve, joint.origin),
                  history(curves, o.rotation, o.curve, joint.origin)};
  joint.load = {history(curves, o.force, o.load_curve, joint.origin),
                history(curves, o.moment, o.load_curve, joint.origin)};
  joint.turn = history(curves, o.rotation_vector, o.curve, joint.origin);
  joint.couple = history(curves, o.moment_vector, o.load_curve, joint.origin);
  const std::array<bool, 6> free = free_components(o.kind);
  for (std::size_t i = 0; i < 6; ++i)
    joint.held[i] = !free[i] || joint.turn || (i % 3 == 2 && joint.motion[i / 3]);
  return joint;
}

Mass point_mass(const MotionOptions& motion) {
  Mass mass;
  mass.mass = *motion.mass;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    mass.inertia[i][i] = motion.moments_of_inertia[std::size_t(i)];
    mass.inertia[i][j] = mass.inertia[j][i] = motion.products_of_inertia[std::size_t(i)];
  }
  return mass;
}

} // namespace

Body make_body(const std::string& name, const MotionOptions& motion,
               const std::vector<Curve>& curves) {
  Body body;
  body.name = name;
  const auto times = [&](double value, const std::string& curve) -> Body::Function {
    return [value, curve = curve_named(curves, curve)](double t) { return value * curve(t); };
  };
  for (std::size_t i = 0; i < 6; ++i)
    if (!motion.free[i])
      body.prescribed[i] = times(i < 3 ? motion.displacement[i] : motion.rotation[i - 3],
                                 motion.curves[i].empty() ? motion.curve : motion.curves[i]);
  for (const HoldOptions& hold : motion.holds)
    for (std::size_t i = 0; i < 6; ++i)
      if (hold.components[i])
        body.holds.push_back(
            {static_cast<int>(i), times(hold.values[i], hold.curve), hold.window, hold.relative});
  body.center = vector(motion.center);
  body.force = vector(motion.force);
  body.moment = vector(motion.moment);
  for (std::size_t i = 0; i < 6; ++i)
    body.load_factor[i] = curve_named(
        curves, motion.load_curves[i].empty() ? motion.load_curve : motion.load_curves[i]);
  body.follower = motion.follower;
  if (motion.mass)
    body.mass = point_mass(motion);
  return body;
}

std::vector<Joint> make_joints(const std::vector<JointOptions>& all,
                               const std::vector<Body>& bodies, const std::vector<Curve>& curves) {
  std::vector<Joint> result;
  for (const JointOptions& options : all) {
    Joint& joint = result.emplace_back(make_joint(curves, options));
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

std::vector<unknowns::RigidLink> links_of(const std::vector<Joint>& joints) {
  std::vector<unknowns::RigidLink> result;
  for (const Joint& joint : joints)
    result.push_back({joint.body, !joint.is_spring()});
  return result;
}

} // namespace abut::rigid
