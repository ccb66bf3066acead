// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <array>

/// Equations of one joint or spring between two bodies a and b, free of the unknowns that move
/// them. Variations of the two bodies come as (translation of a's center, spatial rotation of a,
/// the same of b); forces that work on them as (force, moment about its center, on a; the same on
/// b). Formulas: docs/theory/rigid_bodies.md.
namespace abut::rigid {

using PairVector = std::array<Vec3, 4>;
using PairMatrix = std::array<std::array<Mat3, 4>, 4>; ///< d forces / d variations

/// One body's side of a joint in the current configuration.
struct JointSide {
  Vec3 center = Vec3::zero();
  Vec3 point = Vec3::zero();   ///< of the joint on this body
  std::array<Vec3, 3> frame{}; ///< that turns with the body

  Vec3 arm() const { return point - center; }
};

/// Value and slope of a component (see Joint) between the two sides. Translations are measured
/// along a's directions; rotations across the axis by sines, so that they are zero at half a turn
/// too, and the rotation about the axis by its angle in (-pi, pi].
double joint_value(const JointSide& a, const JointSide& b, std::size_t component);
PairVector joint_slope(const JointSide& a, const JointSide& b, std::size_t component);
/// Derivative of the sum of factor[i] times the slopes; components with factor 0 are not evaluated.
PairMatrix joint_curvature(const JointSide& a, const JointSide& b,
                           const std::array<double, 6>& factor);

/// A linear spring from a's point to b's. Throws SolveError where it has no length though its free
/// length is not zero.
struct Spring {
  double stiffness, free_length;

  /// Internal forces: those that resist the motion.
  PairVector force(const JointSide& a, const JointSide& b) const;
  PairMatrix tangent(const JointSide& a, const JointSide& b) const;
  double elongation(const JointSide& a, const JointSide& b) const;
};

} // namespace abut::rigid
