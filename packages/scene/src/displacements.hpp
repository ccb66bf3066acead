// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/constraints.hpp"
#include "abut/core/error.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/scene/options.hpp"

#include <vector>

namespace abut::scene {

/// Two entries that prescribe one unknown differently would silently drop one of them: throws
/// InputError. Collective.
void check_conflicts(const Options& options, const mesh::Mesh& mesh, const Where& where);

/// Throws InputError for a prescribed node that moves with a rigid body. body_of_node: (N) index of
/// the rigid body among those of the options, or -1. Collective.
void check_rigid_nodes(const Options& options, const mesh::Mesh& mesh,
                       const std::vector<int>& body_of_node, const Where& where);

/// The prescribed unknowns of owned nodes; their groups are the entries.
std::vector<assembly::Constraint> make_constraints(const Options& options, const mesh::Mesh& mesh);

} // namespace abut::scene
