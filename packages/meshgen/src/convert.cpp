// SPDX-License-Identifier: BSD-3-Clause
#include "abut/meshgen/convert.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/cell_edges.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace abut::meshgen {

namespace {

using fem::CellType;

/// Cells that replace each hex8 of a block: (hexes, pieces, corners) nodes.
struct Split {
  int pieces = 1;
  std::vector<Global> nodes;
};

/// Cones from the node of smallest number to the halves of the three faces without it.
Split split_into_tets(const std::vector<Global>& hexes) {
  Split split;
  split.pieces = 6;
  for (std::size_t first = 0; first < hexes.size(); first += 8) {
    const Global* hex = &hexes[first];
    const Global apex = *std::min_element(hex, hex + 8);
    for (int s = 0; s < 6; ++s) {
      const int* face = fem::side(CellType::hex8, s).nodes;
      Global f[4];
      for (int i = 0; i < 4; ++i)
        f[i] = hex[face[i]];
      if (std::find(f, f + 4, apex) != f + 4)
        continue;
      std::rotate(f, std::min_element(f, f + 4), f + 4);
      // The face is counter-clockwise from outside, so its halves must be reversed for a
      // tetrahedron that has them as base and the apex on top.
      for (int i = 1; i < 3; ++i)
        split.nodes.insert(split.nodes.end(), {f[0], f[i + 1], f[i], apex});
    }
  }
  return split;
}

Split split_into_wedges(const std::vector<Global>& hexes) {
  Split split;
  split.pieces = 2;
  for (std::size_t first = 0; first < hexes.size(); first += 8) {
    const Global* h = &hexes[first];
    split.nodes.insert(split.nodes.end(), {h[0], h[1], h[2], h[4], h[5], h[6]});
    split.nodes.insert(split.nodes.end(), {h[0], h[2], h[3], h[4], h[6], h[7]});
  }
  return split;
}

/// Each face between two hexes must be cut in both along the same diagonal, or in neither.
void require_wedges_fit(const mesh::MeshData& hex8) {
  std::map<std::array<Global, 4>, std::array<Global, 2>> cut_of;
  for (const mesh::BlockData& block : hex8.blocks)
    for (std::size_t first = 0; first < block.nodes.size(); first += 8)
      for (int s = 0; s < 6; ++s) {
        const Global* h = &block.nodes[first];
        const int* face = fem::side(CellType::hex8, s).nodes;
        std::array<Global, 4> key;
        for (int i = 0; i < 4; ++i)
          key[i] = h[face[i]];
        std::sort(key.begin(), key.end());
        std::array<Global, 2> cut{-1, -1};
        if (s == 4)
          cut = {std::min(h[0], h[2]), std::max(h[0], h[2])};
        if (s == 5)
          cut = {std::min(h[4], h[6]), std::max(h[4], h[6])};
        const auto [other, is_new] = cut_of.emplace(key, cut);
        if (!is_new && other->second != cut)
          throw InputError("this mesh cannot be made of wedge6 cells: it is not a stack of layers; "
                           "use hex8, hex20, hex27, tet4 or tet10");
      }
}

void split_side_sets(mesh::MeshData& mesh, const mesh::MeshData& hex8, CellType type, int pieces) {
  const fem::CellInfo& cell = fem::info(type);
  for (auto& [name, sides] : mesh.side_sets) {
    std::vector<mesh::SideData> out;
    for (const mesh::SideData& s : sides) {
      const Global* hex = &hex8.blocks[s.block].nodes[8 * s.element];
      const int* face = fem::side(CellType::hex8, s.side).nodes;
      const auto on_face = [&](Global n) {
        return std::any_of(face, face + 4, [&](int f) { return hex[f] == n; });
      };
      for (Global e = s.element * pieces; e < (s.element + 1) * pieces; ++e)
        for (int t = 0; t < cell.sides; ++t) {
          const fem::CellSide& side = fem::side(type, t);
          const Global* nodes = &mesh.blocks[s.block].nodes[e * cell.nodes];
          if (std::all_of(side.nodes, side.nodes + fem::face_corners(side.type),
                          [&](int n) { return on_face(nodes[n]); }))
            out.push_back({s.block, e, t});
        }
    }
    sides = std::move(out);
  }
}

/// Nodes between corners, made once for all cells that share them.
class MidNodes {
public:
  MidNodes(mesh::MeshData& mesh, const Projection& project) : mesh_(mesh), project_(project) {}

  /// corners: the 2 ends of an edge, 4 corners of a face or 8 of a cell.
  Global between(const Global* corners, int count) {
    std::array<Global, 8> key;
    key.fill(-1);
    std::copy(corners, corners + count, key.begin());
    std::sort(key.begin(), key.begin() + count);
    const auto [entry, is_new] = node_.emplace(key, mesh_.num_nodes());
    if (is_new) {
      Vec3 ends[8], centre = Vec3::zero();
      for (int i = 0; i < count; ++i) {
        for (int d = 0; d < 3; ++d)
          ends[i][d] = mesh_.x[3 * key[i] + d];
        centre += (1.0 / count) * ends[i];
      }
      if (project_)
        centre = project_(centre, ends, count);
      mesh_.x.insert(mesh_.x.end(), {centre[0], centre[1], centre[2]});
    }
    return entry->second;
  }

private:
  mesh::MeshData& mesh_;
  const Projection& project_;
  std::map<std::array<Global, 8>, Global> node_;
};

std::vector<Global> add_mid_nodes(const std::vector<Global>& cells, CellType type, MidNodes& mid) {
  const int corners = fem::info(type).corners;
  const fem::CellEdges edges = corners == 4 ? fem::tet_edges() : fem::hex_edges();
  std::vector<Global> out;
  for (std::size_t first = 0; first < cells.size(); first += corners) {
    const Global* c = &cells[first];
    std::vector<Global> nodes(c, c + corners);
    for (int e = 0; e < edges.count; ++e) {
      const Global ends[2] = {c[edges.ends[e][0]], c[edges.ends[e][1]]};
      nodes.push_back(mid.between(ends, 2));
    }
    if (type == CellType::hex27) {
      nodes.resize(27, -1);
      for (int s = 0; s < 6; ++s) {
        const int* face = fem::side(type, s).nodes;
        const Global f[4] = {c[face[0]], c[face[1]], c[face[2]], c[face[3]]};
        nodes[face[8]] = mid.between(f, 4);
      }
      *std::find(nodes.begin(), nodes.end(), -1) = mid.between(c, 8);
    }
    out.insert(out.end(), nodes.begin(), nodes.end());
  }
  return out;
}

} // namespace

mesh::MeshData convert(const mesh::MeshData& hex8, CellType type, const Projection& project) {
  mesh::MeshData mesh = hex8;
  if (type == CellType::hex8)
    return mesh;
  for (const mesh::BlockData& b : hex8.blocks)
    ABUT_REQUIRE(b.type == CellType::hex8 && b.element_id.empty(), "convert needs plain hex8");

  const int corners = fem::info(type).corners;
  if (corners < 8) {
    if (corners == 6)
      require_wedges_fit(hex8);
    int pieces = 1;
    for (mesh::BlockData& b : mesh.blocks) {
      Split split = corners == 4 ? split_into_tets(b.nodes) : split_into_wedges(b.nodes);
      b.nodes = std::move(split.nodes);
      b.type = corners == 4 ? CellType::tet4 : CellType::wedge6;
      pieces = split.pieces;
    }
    split_side_sets(mesh, hex8, corners == 4 ? CellType::tet4 : CellType::wedge6, pieces);
  }
  if (fem::info(type).nodes > corners) {
    MidNodes mid(mesh, project);
    for (mesh::BlockData& b : mesh.blocks) {
      b.nodes = add_mid_nodes(b.nodes, type, mid);
      b.type = type;
    }
  }
  return mesh;
}

} // namespace abut::meshgen
