// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/components.hpp"

#include "abut/fem/cell.hpp"

#include <algorithm>

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
  std::vector<Global> label(mesh.node.size(), -1);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (counts[b])
      for (Local n : mesh.blocks[b].nodes)
        label[n] = mesh.node_input[n];
  struct Entry {
    Global node, label;
  };
  const auto ranks = static_cast<std::size_t>(mesh.comm.size());
  const Global first = mesh.first_node[static_cast<std::size_t>(mesh.comm.rank())];
  for (bool changed = true; changed;) {
    const std::vector<Global> before = label;
    settle_locally(mesh, counts, label);
    // Ghosts tell their owners, owners answer with the least.
    std::vector<std::vector<Entry>> up(ranks);
    for (Local n = mesh.num_owned; n < mesh.num_local(); ++n)
      up[static_cast<std::size_t>(mesh.owner(mesh.node[n]))].push_back({mesh.node[n], label[n]});
    auto arrived = mesh.comm.exchange(up);
    for (const auto& list : arrived)
      for (const Entry& e : list) {
        Global& mine = label[static_cast<std::size_t>(e.node - first)];
        mine = mine < 0 ? e.label : e.label < 0 ? mine : std::min(mine, e.label);
      }
    for (auto& list : arrived)
      for (Entry& e : list)
        e.label = label[static_cast<std::size_t>(e.node - first)];
    std::vector<std::size_t> next(ranks, 0);
    const auto answers = mesh.comm.exchange(arrived);
    for (Local n = mesh.num_owned; n < mesh.num_local(); ++n) {
      const auto r = static_cast<std::size_t>(mesh.owner(mesh.node[n]));
      const Global answer = answers[r][next[r]++].label;
      if (label[n] >= 0 && answer >= 0)
        label[n] = std::min(label[n], answer);
    }
    changed = mesh.comm.any(label != before);
  }
  return label;
}

} // namespace abut::mesh
