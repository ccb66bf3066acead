// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

namespace abut::app {

/// (N) local nodes that belong to a block of a rigid body on any rank: they carry no unknowns, and
/// deformable elements that share them are fixed to the obstacle. Collective.
std::vector<char> rigid_nodes(const Model& model);

/// Motion of all rigid bodies: u = R(curve rotation)(X - c) + c - X + curve displacement.
assembly::PrescribedMotion rigid_motion(const Model& model);

} // namespace abut::app
