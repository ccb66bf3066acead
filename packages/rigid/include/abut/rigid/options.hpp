// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/amount.hpp"
#include "abut/core/window.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abut::rigid {

/// Components of a rigid body's motion that are prescribed for a part of the run.
struct HoldOptions {
  std::string name;
  std::array<bool, 6> components{}; ///< x, y, z, rx, ry, rz
  std::array<double, 6> values{};   ///< [length, rad]
  std::string curve;                ///< empty: the load parameter itself
  Window window;
  bool relative = false; ///< values count from where the body is at the beginning of the window
};

/// Motion of a rigid body: displacement of its center and rotation vector about it, each times a
/// curve, but for the components that are free; and loads on the center, for free components.
struct MotionOptions {
  std::array<double, 3> displacement{};       ///< [length]
  std::array<double, 3> rotation{};           ///< rotation vector [rad]
  std::array<double, 3> center{};             ///< of rotation, reference configuration [length]
  std::string curve;                          ///< empty: the load parameter itself
  std::array<std::string, 6> curves{};        ///< of single components; empty: curve
  std::array<bool, 6> free{};                 ///< components that are unknowns: x, y, z, rx, ry, rz
  std::vector<HoldOptions> holds;             ///< of free components
  std::array<double, 3> force{};              ///< on the center [force]
  std::array<double, 3> moment{};             ///< about the center [force length]
  bool follower = false;                      ///< force and moment turn with the body
  std::string load_curve;                     ///< empty: the load parameter itself
  std::array<std::string, 6> load_curves{};   ///< of single components; empty: load_curve
  std::optional<double> density;              ///< of its blocks, for dynamics [mass/length^3]
  std::optional<double> mass;                 ///< at the center, instead of density
  std::array<double, 3> moments_of_inertia{}; ///< xx, yy, zz about the center, beside mass
  std::array<double, 3> products_of_inertia{}; ///< - int x y dm, y z, z x

  bool has_unknowns() const {
    for (const bool f : free)
      if (f)
        return true;
    return false;
  }
};

enum class JointKind {
  revolute,    ///< turns about its axis
  prismatic,   ///< slides along its axis
  cylindrical, ///< does both
  spherical,   ///< turns about its origin
  lock,        ///< neither turns nor slides
  spring,      ///< linear, between a point of each body
};

/// What connects two rigid bodies.
struct JointOptions {
  static constexpr const char* ground = "ground"; ///< what never moves, but for a body of this name

  std::string name;
  JointKind kind = JointKind::revolute;
  std::vector<std::string> bodies;     ///< two names of rigid bodies, or ground
  std::array<double, 3> origin{};      ///< reference configuration [length]
  std::array<double, 3> axis{};        ///< reference configuration, any length but zero
  std::optional<Amount> rotation;      ///< about the axis; free when not given [rad]
  std::optional<Amount> translation;   ///< along the axis; free when not given [length]
  std::string curve;                   ///< of rotation and translation
  std::optional<Amount> moment, force; ///< of the first body on the second, about and along it
  std::string load_curve;              ///< of moment and force
  std::optional<std::array<Amount, 3>>
      rotation_vector;                                ///< of a spherical joint; free without [rad]
  std::optional<std::array<Amount, 3>> moment_vector; ///< of a spherical joint, fixed in space
  std::array<double, 3> from{}, to{}; ///< of a spring: its points on the bodies [length]
  double stiffness = 0.0;             ///< of a spring [force/length]
  std::optional<double> free_length;  ///< of a spring; that of the reference configuration

  bool turns() const { return kind == JointKind::revolute || kind == JointKind::cylindrical; }
  bool slides() const { return kind == JointKind::prismatic || kind == JointKind::cylindrical; }
};

} // namespace abut::rigid
