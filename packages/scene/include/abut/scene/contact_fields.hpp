// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/interaction.hpp"
#include "abut/mesh/mesh.hpp"

#include <memory>
#include <vector>

namespace abut::scene {

/// Contact at owned nodes. Every interface counts, on both of its sides: their forces at the node
/// are added and divided by the area around it of the faces of those that press there, each face
/// once. An interface that presses nowhere changes nothing.
struct ContactFields {
  std::vector<double> pressure; ///< (owned nodes)
  std::vector<double> traction; ///< (owned nodes, 3) on the body that the node belongs to
  std::vector<double> gap;      ///< (owned nodes) smallest of the interfaces' averages; 0: no face
  std::vector<double> status;   ///< (owned nodes) largest: 0 open, 1 slip, 2 stick
};

/// Collective.
ContactFields contact_fields(const mesh::Mesh& mesh,
                             const std::vector<std::shared_ptr<contact::Interaction>>& contacts);

} // namespace abut::scene
