// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh.hpp"
#include "abut/scene/options.hpp"
#include "abut/solid/element_formulation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace abut::scene {

/// Says which bodies consist of elements that lock, and what to take instead. formulation:
/// (blocks), none for rigid ones. A formulation that the deck names is taken as known but for
/// materials that hardly change their volume.
std::vector<std::string>
warnings_of_elements(const Options& options, const mesh::Mesh& mesh,
                     const std::vector<int>& body_of_block,
                     const std::vector<std::optional<solid::Material>>& material,
                     const std::vector<std::optional<solid::ElementFormulation>>& formulation);

} // namespace abut::scene
