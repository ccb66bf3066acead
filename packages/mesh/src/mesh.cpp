// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/mesh.hpp"

#include "abut/core/error.hpp"

#include <algorithm>

namespace abut::mesh {

int Mesh::owner(Global node_number) const {
  ABUT_REQUIRE(node_number >= 0 && node_number < num_nodes, "no such node");
  return static_cast<int>(std::upper_bound(first_node.begin(), first_node.end(), node_number) -
                          first_node.begin() - 1);
}

NodeExchange node_exchange(const Mesh& mesh) {
  return {mesh.comm, mesh.first_node, {mesh.node.begin() + mesh.num_owned, mesh.node.end()}};
}

} // namespace abut::mesh
