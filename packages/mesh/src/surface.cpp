// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/surface.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace abut::mesh {

namespace {

constexpr Global sides_per_element = 8; // more than any cell has

Global face_id(const Mesh& mesh, const Side& side) {
  const Block& block = mesh.blocks[std::size_t(side.block)];
  return block.element[std::size_t(side.element)] * sides_per_element + side.side;
}

/// Corner nodes of a side in ascending order: sides that have the same ones are one face.
using Corners = std::array<Global, 4>;

struct CorneredSide {
  Corners corners;
  Side side;
  bool operator<(const CorneredSide& o) const { return corners < o.corners; }
};

/// A face on its way to the rank that knows whether others have it too.
struct FaceNotice {
  Corners corners;
  int rank;
  Local place; ///< among those that the rank has once
  bool operator<(const FaceNotice& o) const { return corners < o.corners; }
};

/// Sorts, and keeps what has corners that nothing else in the list has.
template <class T> void keep_single(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  auto kept = list.begin();
  for (auto first = list.begin(), last = first; first != list.end(); first = last) {
    last = std::find_if(first, list.end(), [&](const T& t) { return *first < t; });
    if (last - first == 1)
      *kept++ = *first;
  }
  list.erase(kept, list.end());
}

Corners corners_of(const Mesh& mesh, const Side& s) {
  const Block& block = mesh.blocks[std::size_t(s.block)];
  const fem::CellSide& side = fem::side(block.type, s.side);
  const Local* cell = &block.nodes[std::size_t(s.element) * fem::info(block.type).nodes];
  Corners corners{-1, -1, -1, -1};
  for (int a = 0; a < fem::face_corners(side.type); ++a)
    corners[std::size_t(a)] = mesh.node[std::size_t(cell[side.nodes[a]])];
  std::sort(corners.begin(), corners.end());
  return corners;
}

std::vector<CorneredSide> all_sides(const Mesh& mesh) {
  std::vector<CorneredSide> sides;
  for (int b = 0; b < int(mesh.blocks.size()); ++b)
    for (Local e = 0; e < mesh.blocks[std::size_t(b)].size(); ++e)
      for (int k = 0; k < fem::info(mesh.blocks[std::size_t(b)].type).sides; ++k)
        sides.push_back({corners_of(mesh, {b, e, k}), {b, e, k}});
  return sides;
}

void sort_sides(const Mesh& mesh, std::vector<Side>& sides) {
  std::sort(sides.begin(), sides.end(),
            [&](const Side& a, const Side& b) { return face_id(mesh, a) < face_id(mesh, b); });
}

Surface make_surface(const Mesh& mesh, const std::vector<Side>& sides, const std::string& name) {
  Surface s;
  s.name = name;
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

} // namespace

std::vector<Side> sorted_sides(const Mesh& mesh, const std::string& side_set) {
  const auto found = mesh.side_sets.find(side_set);
  ABUT_REQUIRE(found != mesh.side_sets.end(), "no side set '" + side_set + "'");
  std::vector<Side> sides = found->second;
  sort_sides(mesh, sides);
  return sides;
}

Surface extract_surface(const Mesh& mesh, const std::string& side_set) {
  return make_surface(mesh, sorted_sides(mesh, side_set), side_set);
}

Surface outer_surface(const Mesh& mesh) {
  std::vector<CorneredSide> here = all_sides(mesh);
  keep_single(here);
  const auto ranks = static_cast<std::size_t>(mesh.comm.size());
  std::vector<std::vector<FaceNotice>> send(ranks);
  for (std::size_t k = 0; k < here.size(); ++k)
    send[std::size_t(here[k].corners[3]) % ranks].push_back(
        {here[k].corners, mesh.comm.rank(), static_cast<Local>(k)});
  std::vector<FaceNotice> notices;
  for (const auto& part : mesh.comm.exchange(send))
    notices.insert(notices.end(), part.begin(), part.end());
  keep_single(notices);
  std::vector<std::vector<Local>> answers(ranks);
  for (const FaceNotice& n : notices)
    answers[std::size_t(n.rank)].push_back(n.place);
  std::vector<Side> sides;
  for (const auto& part : mesh.comm.exchange(answers))
    for (const Local k : part)
      sides.push_back(here[std::size_t(k)].side);
  sort_sides(mesh, sides);
  return make_surface(mesh, sides, "outer surface");
}

} // namespace abut::mesh
