// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/cell.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace abut::fem {
namespace {

constexpr CellInfo cells[] = {
    {"HEX8", 8, 8, 6},   {"HEX20", 20, 8, 6},   {"HEX27", 27, 8, 6},
    {"TETRA4", 4, 4, 4}, {"TETRA10", 10, 4, 4}, {"WEDGE6", 6, 6, 5},
};

// The first four nodes serve the 8-node brick, the first eight the 20-node one.
constexpr int hex_side[6][9] = {
    {0, 1, 5, 4, 8, 13, 16, 12, 25},  {1, 2, 6, 5, 9, 14, 17, 13, 24},
    {2, 3, 7, 6, 10, 15, 18, 14, 26}, {0, 4, 7, 3, 12, 19, 15, 11, 23},
    {0, 3, 2, 1, 11, 10, 9, 8, 21},   {4, 5, 6, 7, 16, 17, 18, 19, 22},
};
// The first three nodes serve the 4-node tetrahedron.
constexpr int tet_side[4][6] = {
    {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}, {0, 2, 1, 6, 5, 4}};
constexpr int wedge_side[5][4] = {
    {0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1, -1}, {3, 4, 5, -1}};

template <int Width> CellSide make_side(FaceType type, const int (&nodes)[Width]) {
  CellSide s;
  s.type = type;
  std::fill(std::begin(s.nodes), std::end(s.nodes), -1);
  std::copy_n(nodes, face_nodes(type), s.nodes);
  return s;
}

struct SideTable {
  CellSide side[6][6];

  SideTable() {
    const auto row = [this](CellType c) { return side[static_cast<int>(c)]; };
    for (int i = 0; i < 6; ++i) {
      row(CellType::hex8)[i] = make_side(FaceType::quad4, hex_side[i]);
      row(CellType::hex20)[i] = make_side(FaceType::quad8, hex_side[i]);
      row(CellType::hex27)[i] = make_side(FaceType::quad9, hex_side[i]);
    }
    for (int i = 0; i < 4; ++i) {
      row(CellType::tet4)[i] = make_side(FaceType::tri3, tet_side[i]);
      row(CellType::tet10)[i] = make_side(FaceType::tri6, tet_side[i]);
    }
    for (int i = 0; i < 5; ++i)
      row(CellType::wedge6)[i] = make_side(i < 3 ? FaceType::quad4 : FaceType::tri3, wedge_side[i]);
  }
};

/// Family of an Exodus element name without case and without the node count at its end.
std::string family(const std::string& name) {
  std::string f;
  for (const char c : name)
    if (!std::isspace(static_cast<unsigned char>(c)))
      f += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  while (!f.empty() && std::isdigit(static_cast<unsigned char>(f.back())))
    f.pop_back();
  if (f == "HEXAHEDRON")
    return "HEX";
  if (f == "TET" || f == "TETRAHEDRON")
    return "TETRA";
  if (f == "PENTA" || f == "PRISM")
    return "WEDGE";
  return f;
}

} // namespace

const CellInfo& info(CellType type) {
  return cells[static_cast<int>(type)];
}

const CellSide& side(CellType type, int side) {
  static const SideTable table;
  ABUT_REQUIRE(side >= 0 && side < info(type).sides, "no such side of the cell");
  return table.side[static_cast<int>(type)][side];
}

bool cell_type_from_exodus(const std::string& name, int nodes, CellType& type) {
  const std::string wanted = family(name);
  for (std::size_t c = 0; c < std::size(cells); ++c)
    if (cells[c].nodes == nodes && family(cells[c].name) == wanted) {
      type = static_cast<CellType>(c);
      return true;
    }
  return false;
}

} // namespace abut::fem
