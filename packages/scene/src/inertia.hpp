// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/constraints.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/scene/options.hpp"
#include "abut/solid/inertia_contribution.hpp"

#include <memory>
#include <vector>

namespace abut::scene {

/// The inertia of the deformable bodies of options with dynamics. body_of_block: index in
/// Options::bodies; rigid_body_of_node: (N) index among the rigid ones, -1: none. Collective.
std::shared_ptr<solid::InertiaContribution>
make_inertia(const Options& options, const mesh::Mesh& mesh, const std::vector<int>& body_of_block,
             const std::vector<int>& rigid_body_of_node,
             const std::vector<assembly::Constraint>& constraints);

} // namespace abut::scene
