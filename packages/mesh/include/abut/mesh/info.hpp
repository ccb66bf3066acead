// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <string>
#include <vector>

namespace abut::mesh {

struct BlockInfo {
  int id = 0;
  std::string name;
  fem::CellType type = fem::CellType::hex8;
  Global elements = 0;
  double volume = 0.0; ///< [length^3]
};

struct SetInfo {
  std::string name;
  Global members = 0; ///< nodes or faces
  double area = 0.0;  ///< of a side set [length^2]
};

/// The element that is worst in some way, and where.
struct WorstElement {
  double value = 0.0;
  std::string block;
  Global id = 0;              ///< as the file numbers it
  Vec3 center = Vec3::zero(); ///< mean of its corners
};

/// What a mesh is, for a person to read.
struct MeshInfo {
  Global nodes = 0, elements = 0;
  Global loose_nodes = 0;                       ///< of no element
  Vec3 low = Vec3::zero(), high = Vec3::zero(); ///< bounding box of the nodes
  /// Distances of corners along the edges of elements; the mean over all edges of all elements.
  double min_edge = 0.0, mean_edge = 0.0, max_edge = 0.0;
  WorstElement aspect_ratio;    ///< longest over shortest edge, the largest
  WorstElement scaled_jacobian; ///< see quality.hpp, the smallest
  std::vector<BlockInfo> blocks;
  std::vector<SetInfo> node_sets, side_sets;
};

/// Serial.
MeshInfo info(const MeshData& mesh);

/// Several lines, each ending with a line feed.
std::string text(const MeshInfo& info);

} // namespace abut::mesh
