// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/constraints.hpp"
#include "abut/contact/interaction.hpp"
#include "abut/core/error.hpp"
#include "abut/scene/options.hpp"
#include "abut/solid/face_stiffness.hpp"

#include <memory>
#include <string>
#include <vector>

namespace abut::scene {

/// The interfaces of all contact options, two for those in two passes. materials: of the blocks,
/// null for rigid ones. Adds to the warnings what a user should know of the sides. Throws
/// InputError. Collective.
std::vector<std::shared_ptr<contact::Interaction>>
make_contacts(const Options& options, const mesh::Mesh& mesh,
              const solid::BlockMaterials& materials,
              const std::vector<assembly::Constraint>& constraints, PhaseTimers& timers,
              const Where& where, std::vector<std::string>& warnings);

} // namespace abut::scene
