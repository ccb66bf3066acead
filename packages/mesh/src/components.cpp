// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/components.hpp"

#include "abut/fem/cell.hpp"

#include <algorithm>
#include <limits>

namespace abut::mesh {

namespace {

/// Lowers labels to the least of each element until nothing changes on this rank.
void settle_locally(const Mesh& mesh, const std::vector<char>& counts, std::vector<Global>& label) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      if (!counts[b])
        continue;
      const Block& block = mesh.blocks[b];
      const auto n = static_cast<std::size_t>(fem::info(block.type).nodes);
      for (std::size_t e = 0; e + n <= block.nodes.size(); e += n) {
        Global least = label[block.nodes[e]];
        for (std::size_t a = e; a < e + n; ++a)
          least = std::min(least, label[block.nodes[a]]);
        for (std::size_t a = e; a < e + n; ++a) {
          changed = changed || label[block.nodes[a]] != least;
          label[block.nodes[a]] = least;
        }
      }
    }
  }
}

} // namespace

std::vector<Global> connected_pieces(const Mesh& mesh, const std::vector<char>& counts) {
  constexpr Global none = std::numeric_limits<Global>::max();
  std::vector<Global> label(mesh.node.size(), none);
  std::vector<char> here(mesh.node.size(), 0); // of a block that counts, on this rank
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (counts[b])
      for (Local n : mesh.blocks[b].nodes) {
        label[n] = mesh.node_input[n];
        here[n] = 1;
      }
  const NodeExchange ghosts = node_exchange(mesh);
  for (bool changed = true; changed;) {
    const std::vector<Global> before = label;
    settle_locally(mesh, counts, label);
    ghosts.min_to_owners(label.data());
    ghosts.to_ghosts(label.data());
    changed = mesh.comm.any(label != before);
  }
  for (Local n = 0; n < mesh.num_local(); ++n)
    if (label[n] == none || (n >= mesh.num_owned && !here[n]))
      label[n] = -1;
  return label;
}

} // namespace abut::mesh
