// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/interaction.hpp"
#include "abut/mesh/mesh.hpp"

#include <memory>
#include <vector>

namespace abut::scene {

/// Averages of contact pressure, gap, traction and status at owned nodes.
struct ContactFields {
  std::vector<double> pressure, gap, status; ///< (owned nodes)
  std::vector<double> traction;              ///< (owned nodes, 3), on the primary surface
};

/// Over all interfaces that have the node on their primary side. Collective.
ContactFields contact_fields(const mesh::Mesh& mesh,
                             const std::vector<std::shared_ptr<contact::Interaction>>& contacts);

} // namespace abut::scene
