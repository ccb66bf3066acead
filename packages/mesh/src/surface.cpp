// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/surface.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <unordered_map>

namespace abut::mesh {

namespace {

constexpr Global sides_per_element = 8; // more than any cell has

Global face_id(const Mesh& mesh, const Side& side) {
  const Block& block = mesh.blocks[std::size_t(side.block)];
  return block.element[std::size_t(side.element)] * sides_per_element + side.side;
}

} // namespace

std::vector<Side> sorted_sides(const Mesh& mesh, const std::string& side_set) {
  const auto found = mesh.side_sets.find(side_set);
  ABUT_REQUIRE(found != mesh.side_sets.end(), "no side set '" + side_set + "'");
  std::vector<Side> sides = found->second;
  std::sort(sides.begin(), sides.end(),
            [&](const Side& a, const Side& b) { return face_id(mesh, a) < face_id(mesh, b); });
  return sides;
}

Surface extract_surface(const Mesh& mesh, const std::string& side_set) {
  const std::vector<Side> sides = sorted_sides(mesh, side_set);
  Surface s;
  s.name = side_set;
  s.dim = mesh.dim;
  std::unordered_map<Local, Local> surface_node;
  for (const Side& side : sides) {
    const Block& block = mesh.blocks[side.block];
    const fem::CellSide& face = fem::side(block.type, side.side);
    const Local* cell = &block.nodes[std::size_t(side.element) * fem::info(block.type).nodes];
    for (int a = 0; a < fem::face_nodes(face.type); ++a) {
      const Local n = cell[face.nodes[a]];
      const auto [it, is_new] = surface_node.try_emplace(n, s.num_nodes());
      s.nodes.push_back(it->second);
      if (!is_new)
        continue;
      s.node.push_back(mesh.node[n]);
      s.field_index.push_back(n);
      for (int i = 0; i < mesh.dim; ++i)
        s.x.push_back(mesh.x[std::size_t(n) * mesh.dim + i]);
    }
    s.type.push_back(face.type);
    s.face_id.push_back(face_id(mesh, side));
    s.offset.push_back(static_cast<Local>(s.nodes.size()));
  }
  s.modulus.assign(s.type.size(), 0.0);
  s.inverse_depth.assign(s.type.size(), 0.0);
  return s;
}

} // namespace abut::mesh
