// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// Reference cells and faces; node and side numbering are those of Exodus II.
namespace abut::fem {

enum class CellType { hex8, hex20, hex27, tet4, tet10, wedge6 };
enum class FaceType { quad4, quad8, quad9, tri3, tri6 };

constexpr int max_cell_nodes = 27;
constexpr int max_face_nodes = 9;

struct CellInfo {
  const char* name; ///< Exodus element type, e.g. "HEX8"
  int nodes;
  int corners;
  int sides;
};

struct CellSide {
  FaceType type;
  int nodes[max_face_nodes]; ///< cell-local, 0-based; the face normal points out of the cell
};

const CellInfo& info(CellType type);
/// Side 0 .. sides-1 (Exodus side number minus one).
const CellSide& side(CellType type, int side);
/// From an Exodus element type with its node count ("HEX", 8), ("HEX8", 8), ("TETRA", 10), ...
/// Returns false when abut has no such cell.
bool cell_type_from_exodus(const std::string& name, int nodes, CellType& type);

constexpr int face_nodes(FaceType t) {
  return t == FaceType::quad4   ? 4
         : t == FaceType::quad8 ? 8
         : t == FaceType::quad9 ? 9
         : t == FaceType::tri3  ? 3
                                : 6;
}
constexpr int face_corners(FaceType t) {
  return t == FaceType::tri3 || t == FaceType::tri6 ? 3 : 4;
}
constexpr bool is_triangle(FaceType t) {
  return face_corners(t) == 3;
}

} // namespace abut::fem
