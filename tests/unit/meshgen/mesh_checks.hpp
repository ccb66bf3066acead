// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace abut_test {

using abut::Global;
using abut::Vec3;
using abut::fem::CellType;
using abut::mesh::MeshData;
using abut::mesh::SideData;

inline const CellType all_types[] = {CellType::hex8, CellType::hex20, CellType::hex27,
                                     CellType::tet4, CellType::tet10, CellType::wedge6};

inline Vec3 point(const MeshData& m, Global n) {
  return {{m.x[3 * n], m.x[3 * n + 1], m.x[3 * n + 2]}};
}

/// Nodes of a side, in order; corners first.
inline std::vector<Global> side_nodes(const MeshData& m, const SideData& s) {
  const auto& block = m.blocks[s.block];
  const auto& side = abut::fem::side(block.type, s.side);
  std::vector<Global> nodes;
  for (int i = 0; i < abut::fem::face_nodes(side.type); ++i)
    nodes.push_back(block.nodes[s.element * abut::fem::info(block.type).nodes + side.nodes[i]]);
  return nodes;
}

/// Sides that no other element shares. Fails the mesh (returns false) when more than two share one.
inline bool boundary(const MeshData& m, std::vector<SideData>& out) {
  std::map<std::vector<Global>, std::vector<SideData>> faces;
  for (int b = 0; b < static_cast<int>(m.blocks.size()); ++b) {
    const auto& cell = abut::fem::info(m.blocks[b].type);
    for (Global e = 0; e < static_cast<Global>(m.blocks[b].nodes.size()) / cell.nodes; ++e)
      for (int s = 0; s < cell.sides; ++s) {
        auto key = side_nodes(m, {b, e, s});
        std::sort(key.begin(), key.end());
        faces[key].push_back({b, e, s});
      }
  }
  for (const auto& [key, sides] : faces) {
    if (sides.size() > 2)
      return false;
    if (sides.size() == 1)
      out.push_back(sides[0]);
  }
  return true;
}

/// Sides in these sets together.
inline std::size_t faces_in(const MeshData& m, const std::vector<std::string>& sets) {
  std::size_t sum = 0;
  for (const std::string& set : sets)
    sum += m.side_sets.at(set).size();
  return sum;
}

/// Area vector of a side from its corners.
inline Vec3 area(const MeshData& m, const SideData& s) {
  const auto n = side_nodes(m, s);
  const int corners = abut::fem::face_corners(abut::fem::side(m.blocks[s.block].type, s.side).type);
  Vec3 sum = Vec3::zero();
  for (int i = 1; i + 1 < corners; ++i)
    sum += 0.5 * cross(point(m, n[i]) - point(m, n[0]), point(m, n[i + 1]) - point(m, n[0]));
  return sum;
}

inline double total_area(const MeshData& m, const std::vector<SideData>& sides) {
  double sum = 0.0;
  for (const SideData& s : sides)
    sum += norm(area(m, s));
  return sum;
}

/// Volume inside the boundary by the divergence theorem over the corners of the faces.
inline double volume(const MeshData& m) {
  std::vector<SideData> sides;
  if (!boundary(m, sides))
    return std::nan("");
  double sum = 0.0;
  for (const SideData& s : sides) {
    const auto n = side_nodes(m, s);
    const int corners =
        abut::fem::face_corners(abut::fem::side(m.blocks[s.block].type, s.side).type);
    for (int i = 1; i + 1 < corners; ++i)
      sum += dot(point(m, n[0]), cross(point(m, n[i]), point(m, n[i + 1]))) / 6.0;
  }
  return sum;
}

} // namespace abut_test
