// SPDX-License-Identifier: BSD-3-Clause
#include "abut/meshgen/merge.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <set>

namespace abut::meshgen {

void append(mesh::MeshData& whole, const mesh::MeshData& part) {
  ABUT_REQUIRE(whole.dim == part.dim, "meshes of different dimension");
  ABUT_REQUIRE(whole.node_id.empty() && part.node_id.empty(), "meshes with number maps");
  const Global first_node = whole.num_nodes();
  const int first_block = static_cast<int>(whole.blocks.size());
  int id = 0;
  for (const mesh::BlockData& b : whole.blocks)
    id = std::max(id, b.id);

  whole.x.insert(whole.x.end(), part.x.begin(), part.x.end());
  for (mesh::BlockData b : part.blocks) {
    ABUT_REQUIRE(b.element_id.empty(), "meshes with number maps");
    b.id = ++id;
    for (Global& n : b.nodes)
      n += first_node;
    whole.blocks.push_back(std::move(b));
  }
  for (const auto& [name, nodes] : part.node_sets) {
    auto& out = whole.node_sets[name];
    for (Global n : nodes)
      out.push_back(n + first_node);
  }
  for (const auto& [name, sides] : part.side_sets) {
    auto& out = whole.side_sets[name];
    for (mesh::SideData s : sides) {
      s.block += first_block;
      out.push_back(s);
    }
  }
}

void add_side_set(mesh::MeshData& mesh, const std::string& name,
                  const std::function<bool(Global node)>& chosen) {
  auto& out = mesh.side_sets[name];
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::BlockData& block = mesh.blocks[b];
    const fem::CellInfo& cell = fem::info(block.type);
    const Global count = static_cast<Global>(block.nodes.size()) / cell.nodes;
    for (Global e = 0; e < count; ++e)
      for (int s = 0; s < cell.sides; ++s) {
        const fem::CellSide& side = fem::side(block.type, s);
        const int* first = side.nodes;
        const Global* nodes = &block.nodes[e * cell.nodes];
        if (std::all_of(first, first + fem::face_corners(side.type),
                        [&](int n) { return chosen(nodes[n]); }))
          out.push_back({static_cast<int>(b), e, s});
      }
  }
}

void node_sets_from_side_sets(mesh::MeshData& mesh) {
  for (const auto& [name, sides] : mesh.side_sets) {
    std::set<Global> nodes;
    for (const mesh::SideData& s : sides) {
      const mesh::BlockData& block = mesh.blocks[s.block];
      const fem::CellSide& side = fem::side(block.type, s.side);
      const Global* cell = &block.nodes[s.element * fem::info(block.type).nodes];
      for (int i = 0; i < fem::face_nodes(side.type); ++i)
        nodes.insert(cell[side.nodes[i]]);
    }
    mesh.node_sets[name].assign(nodes.begin(), nodes.end());
  }
}

} // namespace abut::meshgen
