// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

namespace abut::app {

/// The joints of the deck in its order, as equations know them.
std::vector<assembly::RigidJoint> rigid_joints(const deck::Deck& deck,
                                               const std::vector<assembly::RigidBody>& bodies);

/// What they couple.
std::vector<assembly::RigidLink> rigid_links(const std::vector<assembly::RigidJoint>& joints);

} // namespace abut::app
