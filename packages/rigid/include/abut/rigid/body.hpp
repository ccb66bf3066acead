// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/window.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace abut::rigid {

/// A component of a rigid body that is an unknown but for a part of the run.
struct Hold {
  int component = 0; ///< 0..5
  std::function<double(double)> value;
  Window window;
  bool relative = false; ///< the value counts from where the body is before the window
};

/// How the mass of a rigid body is spread, in the reference configuration.
struct Mass {
  double mass = 0.0;
  Vec3 arm = Vec3::zero();     ///< from the body's center to its center of mass [length]
  Mat3 inertia = Mat3::zero(); ///< moments of inertia about the center of mass [mass length^2]
};

/// A set of nodes that moves as one: translation of a center and rotation about it. Each of the six
/// components (translation along x, y, z [length], rotation vector [rad]) is an unknown or follows
/// a function of the load parameter t. docs/theory/rigid_bodies.md
struct Body {
  using Function = std::function<double(double)>;

  std::string name;
  Vec3 center = Vec3::zero();            ///< reference configuration [length]
  std::array<Function, 6> prescribed{};  ///< empty: an unknown
  std::vector<Hold> holds;               ///< of unknowns
  Vec3 force = Vec3::zero();             ///< on the center [force]
  Vec3 moment = Vec3::zero();            ///< about the center [force length]
  std::array<Function, 6> load_factor{}; ///< of components of force and moment; empty: 1
  bool follower = false;                 ///< force and moment turn with the body
  Mass mass;                             ///< for dynamics
  Vec3 velocity = Vec3::zero();          ///< of the center at the start [length/time]
  Vec3 spin = Vec3::zero();              ///< angular velocity at the start [rad/time]

  bool has_unknowns() const {
    for (const Function& f : prescribed)
      if (!f)
        return true;
    return false;
  }
};

/// How a body with mass moves.
struct BodyMotion {
  Vec3 velocity = Vec3::zero(); ///< of the center [length/time]
  Vec3 spin = Vec3::zero();     ///< angular velocity [rad/time]
  double kinetic_energy = 0.0;
  Vec3 linear_momentum = Vec3::zero();
  Vec3 angular_momentum = Vec3::zero(); ///< about the origin
};

/// Where a body is, and what its prescribed components exert on it.
struct BodyState {
  Vec3 displacement = Vec3::zero(); ///< of the center [length]
  Vec3 rotation = Vec3::zero();     ///< rotation vector, whole turns counted [rad]
  Vec3 force = Vec3::zero();        ///< zero in components that are unknowns [force]
  Vec3 moment = Vec3::zero();       ///< about the current center [force length]
};

template <class V> void list_state(V& v, BodyState& s) {
  v(s.displacement, s.rotation, s.force, s.moment);
}

} // namespace abut::rigid
