// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <array>
#include <utility>
#include <vector>

namespace abut::mesh {

/// In the order of blocks, elements and sides.
bool operator<(const SideData& a, const SideData& b);
bool operator==(const SideData& a, const SideData& b);

const fem::CellSide& cell_side(const MeshData& mesh, const SideData& side);
/// Nodes of a side: corners first, in the order in which its normal points out of the element.
std::vector<Global> side_nodes(const MeshData& mesh, const SideData& side);
/// Node positions of a side, in that order.
std::vector<Vec3> side_points(const MeshData& mesh, const SideData& side);
/// Nodes of all sides, ascending, each once.
std::vector<Global> nodes_of_sides(const MeshData& mesh, const std::vector<SideData>& sides);

/// All sides of all elements, by their corners.
class SideIndex {
public:
  explicit SideIndex(const MeshData& mesh);

  /// The sides with these corners, in whatever order they are given; more than one between
  /// elements that share them. count: 3 or 4. None has a corner < 0, which stands for no node.
  std::vector<SideData> find(const Global* corners, int count) const;
  /// Sides that no other element has, ordered. Faces between elements that share their corners are
  /// inside, whatever their blocks.
  std::vector<SideData> outer() const;

private:
  using Corners = std::array<Global, 4>; ///< ascending; the first is -1 for a triangle
  static Corners key(const Global* corners, int count);

  std::vector<std::pair<Corners, SideData>> sides_; ///< ascending
};

} // namespace abut::mesh
