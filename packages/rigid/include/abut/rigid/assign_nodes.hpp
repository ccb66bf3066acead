// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/mesh/mesh.hpp"

#include <string>
#include <vector>

namespace abut::rigid {

/// The nodes of a rigid body: of whole blocks, and those of node sets.
struct BodyNodes {
  std::string name;
  std::vector<int> blocks; ///< indices of the mesh's blocks
  std::vector<std::string> node_sets;
};

/// (N) the rigid body of each local node as an index into `bodies`, -1: none. A node belongs to it
/// by a block on any rank or by a node set; deformable elements that share it are clamped to the
/// body. Throws InputError at `bodies.NAME` for a node of two bodies. Collective.
std::vector<int> assign_nodes(const mesh::Mesh& mesh, const std::vector<BodyNodes>& bodies,
                              const Where& where);

} // namespace abut::rigid
