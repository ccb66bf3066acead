// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/sides.hpp"

#include <algorithm>
#include <tuple>

namespace abut::mesh {

bool operator<(const SideData& a, const SideData& b) {
  return std::tie(a.block, a.element, a.side) < std::tie(b.block, b.element, b.side);
}

bool operator==(const SideData& a, const SideData& b) {
  return std::tie(a.block, a.element, a.side) == std::tie(b.block, b.element, b.side);
}

const fem::CellSide& cell_side(const MeshData& mesh, const SideData& side) {
  return fem::side(mesh.blocks[std::size_t(side.block)].type, side.side);
}

std::vector<Global> side_nodes(const MeshData& mesh, const SideData& side) {
  const BlockData& block = mesh.blocks[std::size_t(side.block)];
  const fem::CellSide& face = fem::side(block.type, side.side);
  const Global first = side.element * fem::info(block.type).nodes;
  std::vector<Global> nodes;
  for (int a = 0; a < fem::face_nodes(face.type); ++a)
    nodes.push_back(block.nodes[std::size_t(first + face.nodes[a])]);
  return nodes;
}

std::vector<Vec3> side_points(const MeshData& mesh, const SideData& side) {
  std::vector<Vec3> points;
  for (const Global n : side_nodes(mesh, side)) {
    const double* x = &mesh.x[3 * std::size_t(n)];
    points.push_back({{x[0], x[1], x[2]}});
  }
  return points;
}

std::vector<Global> nodes_of_sides(const MeshData& mesh, const std::vector<SideData>& sides) {
  std::vector<Global> nodes;
  for (const SideData& side : sides)
    for (const Global n : side_nodes(mesh, side))
      nodes.push_back(n);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

SideIndex::Corners SideIndex::key(const Global* corners, int count) {
  Corners key{-1, -1, -1, -1};
  std::copy(corners, corners + count, key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

SideIndex::SideIndex(const MeshData& mesh) {
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const fem::CellInfo& cell = fem::info(mesh.blocks[b].type);
    const Global elements = Global(mesh.blocks[b].nodes.size()) / cell.nodes;
    sides_.reserve(sides_.size() + std::size_t(elements) * std::size_t(cell.sides));
    for (Global e = 0; e < elements; ++e)
      for (int s = 0; s < cell.sides; ++s) {
        const SideData side{int(b), e, s};
        const fem::CellSide& face = cell_side(mesh, side);
        const int count = fem::face_corners(face.type);
        Global corners[4];
        for (int a = 0; a < count; ++a)
          corners[a] = mesh.blocks[b].nodes[std::size_t(e * cell.nodes + face.nodes[a])];
        sides_.emplace_back(key(corners, count), side);
      }
  }
  std::sort(sides_.begin(), sides_.end());
}

std::vector<SideData> SideIndex::find(const Global* corners, int count) const {
  if (std::any_of(corners, corners + count, [](Global n) { return n < 0; }))
    return {};
  const Corners wanted = key(corners, count);
  auto at = std::lower_bound(sides_.begin(), sides_.end(), wanted,
                             [](const auto& entry, const Corners& k) { return entry.first < k; });
  std::vector<SideData> found;
  for (; at != sides_.end() && at->first == wanted; ++at)
    found.push_back(at->second);
  return found;
}

std::vector<SideData> SideIndex::outer() const {
  std::vector<SideData> outer;
  for (auto at = sides_.begin(); at != sides_.end();) {
    const auto next =
        std::find_if(at, sides_.end(), [&](const auto& entry) { return entry.first != at->first; });
    if (next - at == 1)
      outer.push_back(at->second);
    at = next;
  }
  std::sort(outer.begin(), outer.end());
  return outer;
}

} // namespace abut::mesh
