// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/mesh.hpp"

#include <algorithm>
#include <tuple>

namespace abut::mesh {

namespace {

/// Blocks of `mesh` without elements.
std::vector<BlockData> empty_blocks(const Mesh& mesh) {
  std::vector<BlockData> blocks;
  for (const Block& b : mesh.blocks)
    blocks.push_back({b.id, b.name, b.type, {}, {}});
  return blocks;
}

/// Elements of all ranks in the order of the input.
void gather_block(const Mesh& mesh, const Block& block, BlockData& out) {
  const std::size_t width = static_cast<std::size_t>(fem::info(block.type).nodes);
  std::vector<Global> mine;
  for (Local n : block.nodes)
    mine.push_back(mesh.node_input[n]);
  const std::vector<Global> nodes = mesh.comm.gather(mine);
  const std::vector<Global> element = mesh.comm.gather(block.element);
  const std::vector<Global> id = mesh.comm.gather(block.element_id);
  if (element.empty())
    return;
  const Global first = *std::min_element(element.begin(), element.end());
  out.nodes.resize(nodes.size());
  out.element_id.resize(id.size());
  for (std::size_t e = 0; e < element.size(); ++e) {
    const std::size_t to = static_cast<std::size_t>(element[e] - first);
    out.element_id[to] = id[e];
    std::copy_n(nodes.begin() + width * e, width, out.nodes.begin() + width * to);
  }
}

void gather_sets(const Mesh& mesh, MeshData& out) {
  for (const auto& [name, set] : mesh.node_sets) {
    std::vector<Global> nodes;
    for (Local n : set)
      if (n < mesh.num_owned)
        nodes.push_back(mesh.node_input[n]);
    nodes = mesh.comm.gather(nodes);
    std::sort(nodes.begin(), nodes.end());
    if (mesh.comm.is_root())
      out.node_sets[name] = nodes;
  }
  std::vector<Global> first; // element of each block in the input
  for (const Block& b : mesh.blocks)
    first.push_back(-mesh.comm.max(b.element.empty() ? -mesh.num_elements : -b.element.front()));
  for (const auto& [name, set] : mesh.side_sets) {
    std::vector<SideData> sides;
    for (const Side& s : set)
      sides.push_back({s.block, mesh.blocks[s.block].element[s.element] - first[s.block], s.side});
    sides = mesh.comm.gather(sides);
    std::sort(sides.begin(), sides.end(), [](const SideData& a, const SideData& b) {
      return std::tie(a.block, a.element, a.side) < std::tie(b.block, b.element, b.side);
    });
    if (mesh.comm.is_root())
      out.side_sets[name] = sides;
  }
}

} // namespace

MeshData gather(const Mesh& mesh) {
  MeshData out;
  out.dim = mesh.dim;
  const std::size_t owned = static_cast<std::size_t>(mesh.num_owned);
  const auto x = mesh.comm.gather(
      std::vector<double>(mesh.x.begin(), mesh.x.begin() + mesh.dim * mesh.num_owned));
  const auto input = mesh.comm.gather(
      std::vector<Global>(mesh.node_input.begin(), mesh.node_input.begin() + owned));
  const auto id =
      mesh.comm.gather(std::vector<Global>(mesh.node_id.begin(), mesh.node_id.begin() + owned));
  out.x.resize(x.size());
  out.node_id.resize(id.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    out.node_id[input[i]] = id[i];
    std::copy_n(x.begin() + mesh.dim * i, mesh.dim, out.x.begin() + mesh.dim * input[i]);
  }
  std::vector<BlockData> blocks = empty_blocks(mesh);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    gather_block(mesh, mesh.blocks[b], blocks[b]);
  gather_sets(mesh, out);
  if (mesh.comm.is_root())
    out.blocks = std::move(blocks);
  return out;
}

MeshData local_part(const Mesh& mesh) {
  MeshData out;
  out.dim = mesh.dim;
  out.x = mesh.x;
  out.node_id = mesh.node_id;
  out.blocks = empty_blocks(mesh);
  for (std::size_t b = 0; b < out.blocks.size(); ++b) {
    const Block& block = mesh.blocks[b];
    out.blocks[b].nodes.assign(block.nodes.begin(), block.nodes.end());
    out.blocks[b].element_id = block.element_id;
  }
  for (const auto& [name, set] : mesh.node_sets)
    out.node_sets[name].assign(set.begin(), set.end());
  for (const auto& [name, set] : mesh.side_sets) {
    auto& sides = out.side_sets[name];
    for (const Side& s : set)
      sides.push_back({s.block, s.element, s.side});
  }
  return out;
}

} // namespace abut::mesh
