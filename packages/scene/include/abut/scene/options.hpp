// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/options.hpp"
#include "abut/core/amount.hpp"
#include "abut/core/curve.hpp"
#include "abut/core/window.hpp"
#include "abut/mesh/options.hpp"
#include "abut/rigid/options.hpp"
#include "abut/solid/options.hpp"
#include "abut/solver/options.hpp"

#include <array>
#include <string>
#include <vector>

namespace abut::scene {

struct BodyOptions {
  std::string name;
  std::vector<std::string> blocks;
  std::vector<std::string> node_sets; ///< a rigid body's, of other bodies' elements too
  std::string material;               ///< empty for a rigid body
  solid::ElementFormulation element = solid::ElementFormulation::automatic; ///< of deformable ones
  bool rigid = false;
  rigid::MotionOptions motion;              ///< of a rigid body
  std::array<double, 3> initial_velocity{}; ///< for dynamics [length/time]
  std::array<double, 3>
      initial_angular_velocity{}; ///< about its center of mass or center [rad/time]
};

/// Faces that the mesh has no side set of. Those of the blocks or the body that the selection
/// leaves (all outer ones where nothing is named), those of `join`, without those of `subtract`.
struct SurfaceOptions {
  std::string name;
  std::vector<std::string> blocks; ///< by name or number
  std::string body;                ///< its blocks
  std::string part_of;             ///< side set or surface: its faces instead of outer ones
  mesh::FaceSelection selection;
  std::vector<std::string> join, subtract; ///< side sets or surfaces

  bool selects() const {
    return !blocks.empty() || !body.empty() || !part_of.empty() || !selection.is_empty();
  }
};

/// Displacement of the nodes of a set. components[i]: whether direction i is prescribed.
struct DisplacementOptions {
  std::string name;
  std::string set; ///< node set, or side set (all its nodes)
  std::array<bool, 3> components{};
  std::array<Amount, 3> values{}; ///< [length]
  std::string curve;
  Window window;         ///< when the nodes are held
  bool relative = false; ///< values count from where the nodes are at the beginning of the window
};

/// What is on a mesh, how it moves and what is done to it. Names of blocks and sets are those of
/// the mesh; names of curves, materials and rigid bodies must be given here.
struct Options {
  std::vector<SurfaceOptions> surfaces;
  std::vector<solid::MaterialOptions> materials;
  std::vector<BodyOptions> bodies;
  std::vector<rigid::JointOptions> joints;
  std::vector<DisplacementOptions> displacements;
  std::vector<solid::LoadOptions> loads;
  std::vector<Curve> curves;
  std::vector<contact::ContactOptions> contact;
  solver::TimeOptions time;
  solver::DynamicsOptions dynamics;
};

} // namespace abut::scene
