// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/fingerprint.hpp"

#include "abut/core/checksum.hpp"

namespace abut::mesh {

std::uint64_t fingerprint(const MeshData& mesh) {
  Checksum sum;
  sum.add(mesh.x);
  sum.add(mesh.node_id);
  for (const BlockData& block : mesh.blocks) {
    const int facts[2] = {block.id, static_cast<int>(block.type)};
    sum.add(facts, sizeof facts);
    sum.add(block.name);
    sum.add(block.nodes);
    sum.add(block.element_id);
  }
  for (const auto& [name, nodes] : mesh.node_sets) {
    sum.add(name);
    sum.add(nodes);
  }
  for (const auto& [name, sides] : mesh.side_sets) {
    sum.add(name);
    for (const SideData& side : sides) {
      const Global facts[3] = {side.block, side.element, side.side};
      sum.add(facts, sizeof facts);
    }
  }
  return sum.value();
}

} // namespace abut::mesh
