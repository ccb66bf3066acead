// SPDX-License-Identifier: BSD-3-Clause
#include "stiff_elements.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace abut::scene {

std::vector<std::string>
warnings_of_elements(const Options& options, const mesh::Mesh& mesh,
                     const std::vector<int>& body_of_block,
                     const std::vector<std::optional<solid::Material>>& material,
                     const std::vector<std::optional<solid::ElementFormulation>>& formulation) {
  std::vector<std::string> result;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    if (!material[b])
      continue;
    const BodyOptions& body = options.bodies[std::size_t(body_of_block[b])];
    const fem::CellType cell = mesh.blocks[b].type;
    const solid::Locking locking = solid::locking(*formulation[b], cell, *material[b]);
    const bool named = body.element != solid::ElementFormulation::automatic;
    const char* instead = cell == fem::CellType::hex8 ? "'element: enhanced'" : "hex8 or tet10";
    std::string warning;
    if (locking.volume)
      warning = fmt::format("bodies.{}: {} elements lock in a material that hardly changes its "
                            "volume; forces may be too large by a multiple: take {}",
                            body.name, fem::info(cell).name, instead);
    else if (locking.bending && !named)
      warning = fmt::format("bodies.{}: {} elements are too stiff where bodies bend, with one or "
                            "two across by a multiple: take {}",
                            body.name, fem::info(cell).name, instead);
    if (!warning.empty() && std::find(result.begin(), result.end(), warning) == result.end())
      result.push_back(warning);
  }
  return result;
}

} // namespace abut::scene
