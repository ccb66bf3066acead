// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/types.hpp"

#include <array>
#include <string>
#include <vector>

/// What an interface says of itself, and what it is held against.
namespace abut::audit {

/// An interface as the deck has it: two side sets of the mesh, which may be the same one.
struct Interface {
  std::string name, primary, secondary;
};

/// A point at which an interface holds its law.
struct BelievedPoint {
  Global face;           ///< id of its primary face, see mesh::Surface
  Vec3 x;                ///< present position [length]
  bool paired = false;   ///< it has a partner
  bool held = false;     ///< tied to it, whatever the gap
  double gap = 0.0;      ///< between the faces of the meshes, > 0 open [length]
  double pressure = 0.0; ///< [pressure]
  double shear = 0.0;    ///< size of the tangential traction [pressure]
};

/// Force that an interface exerts on a node that this rank owns.
struct NodalForce {
  Local node;
  Vec3 force;
};

/// All that an interface believes of a step, of this rank's points and nodes.
struct Belief {
  bool acts = true;              ///< now
  bool may_pull = false;         ///< tension is meant
  bool has_cone = true;          ///< the shear is bound by Coulomb's law
  double friction = 0.0;         ///< its coefficient now [1]
  std::array<double, 3> force{}; ///< on the primary surface, over all ranks [force]
  std::vector<BelievedPoint> points;
  std::vector<NodalForce> forces; ///< on both sides
};

} // namespace abut::audit
