// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <array>
#include <functional>
#include <string>

namespace abut::rigid {

/// What connects two rigid bodies: constraints of their relative motion, or a linear spring between
/// a point of each. A joint's frame has its axis as third direction; its components are the
/// translations of the second body against the first along the three directions, then the rotations
/// about them. docs/theory/rigid_bodies.md
struct Joint {
  using Function = std::function<double(double)>;
  static constexpr std::size_t along = 2, about = 5; ///< components of the axis

  std::string name;
  std::array<int, 2> body{-1, -1}; ///< indices of rigid bodies; -1: the ground, which never moves
  Vec3 origin = Vec3::zero();      ///< reference configuration, of both bodies [length]
  Vec3 axis{{0.0, 0.0, 1.0}};      ///< reference configuration, any length but zero
  std::array<bool, 6> held{};      ///< components that are not free
  /// Of `along` [length] and `about` [rad]: held components follow them; empty: they stay at zero.
  std::array<Function, 2> motion;
  /// Of `along` [force] and `about` [force length], where free: what the first body exerts on the
  /// second along and about the axis, which turns with the first; empty: nothing.
  std::array<Function, 2> load;

  /// Rotation vector of the second body against the first, in directions that turn with the first
  /// [rad]; all components are held then, the rotations where it says.
  std::function<Vec3(double)> turn;
  /// Moment of the first body on the second, fixed in space [force length].
  std::function<Vec3(double)> couple;

  /// A spring from origin on the first body to `end` on the second, when > 0 [force/length]; then
  /// nothing is held.
  double stiffness = 0.0;
  Vec3 end = Vec3::zero();
  double free_length = 0.0;

  bool is_spring() const { return stiffness > 0.0; }
};

/// Directions of a joint's frame, orthonormal and right-handed: two across the axis, then the axis.
std::array<Vec3, 3> joint_frame(const Vec3& axis);

/// What a joint transmits and how far its bodies have moved against each other.
struct JointState {
  Vec3 force = Vec3::zero();  ///< of the first body on the second [force]
  Vec3 moment = Vec3::zero(); ///< the same, about the joint's point on the second [force length]
  /// Along the axis; of a spring what it is longer than its free length [length]
  double translation = 0.0;
  /// About the axis, whole turns counted; the angle of the whole rotation where those across the
  /// axis are free or prescribed [rad]
  double rotation = 0.0;
  std::array<double, 2> axial{}; ///< components of force and moment of the axis
  double energy = 0.0;           ///< of a spring
  /// Rotation of the second body against the first since the last accepted state, in space [rad]
  Vec3 step_rotation = Vec3::zero();
};

template <class V> void list_state(V& v, JointState& s) {
  v(s.force, s.moment, s.translation, s.rotation, s.axial, s.energy, s.step_rotation);
}

} // namespace abut::rigid
