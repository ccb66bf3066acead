// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

namespace abut::app {

/// (N) the rigid body of each local node as an index into rigid_bodies(), -1: none. A node belongs
/// to it by a block on any rank or by a node set; deformable elements that share it are clamped to
/// the body. Throws InputError for a node of two bodies and for one that `displacements` prescribe.
/// Collective.
std::vector<int> rigid_nodes(const Model& model);

/// The rigid bodies of the deck in its order, as equations know them. Collective.
std::vector<assembly::RigidBody> rigid_bodies(const Model& model);

} // namespace abut::app
