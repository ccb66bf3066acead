// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include <algorithm>
#include <iterator>

namespace abut::abaqus {

namespace {

using fem::CellType;

// Middles of the vertical edges come before those of the upper ones in Exodus II.
const int hex20[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15};

constexpr const char* reduced8 =
    "one integration point and hourglass control; abut takes "
    "'element: enhanced', which locks as little and has no hourglasses";
constexpr const char* reduced20 =
    "reduced integration; abut integrates hex20 with 27 points, which is a little stiffer";
constexpr const char* hybrid = "a hybrid element; abut has displacements alone";
constexpr const char* modified = "modified for contact; abut's tet10 is the plain one";
constexpr const char* no_wedge15 = "abut has no prism of 15 nodes: take C3D6, C3D10 or C3D20";

const ElementType types[] = {
    {"C3D4", 4, CellType::tet4, nullptr, nullptr, nullptr},
    {"C3D4H", 4, CellType::tet4, nullptr, nullptr, hybrid},
    {"C3D6", 6, CellType::wedge6, nullptr, nullptr, nullptr},
    {"C3D8", 8, CellType::hex8, nullptr, nullptr, nullptr},
    {"C3D8H", 8, CellType::hex8, nullptr, nullptr, hybrid},
    {"C3D8I", 8, CellType::hex8, nullptr, "enhanced", nullptr},
    {"C3D8IH", 8, CellType::hex8, nullptr, "enhanced", hybrid},
    {"C3D8R", 8, CellType::hex8, nullptr, "enhanced", reduced8},
    {"C3D8RH", 8, CellType::hex8, nullptr, "enhanced", reduced8},
    {"C3D10", 10, CellType::tet10, nullptr, nullptr, nullptr},
    {"C3D10H", 10, CellType::tet10, nullptr, nullptr, hybrid},
    {"C3D10M", 10, CellType::tet10, nullptr, nullptr, modified},
    {"C3D10MH", 10, CellType::tet10, nullptr, nullptr, modified},
    {"C3D15", 0, {}, nullptr, nullptr, no_wedge15},
    {"C3D20", 20, CellType::hex20, hex20, nullptr, nullptr},
    {"C3D20H", 20, CellType::hex20, hex20, nullptr, hybrid},
    {"C3D20R", 20, CellType::hex20, hex20, nullptr, reduced20},
    {"C3D20RH", 20, CellType::hex20, hex20, nullptr, reduced20},
    {"R3D3", 3, {}, nullptr, nullptr, nullptr},
    {"R3D4", 4, {}, nullptr, nullptr, nullptr},
};

} // namespace

const ElementType* element_type(const std::string& name) {
  const std::string key = key_of(name);
  const auto found = std::find_if(std::begin(types), std::end(types),
                                  [&](const ElementType& t) { return key == t.name; });
  return found == std::end(types) ? nullptr : &*found;
}

int exodus_side(CellType cell, int face) {
  static constexpr int hex[] = {4, 5, 0, 1, 2, 3}, tet[] = {3, 0, 1, 2}, wedge[] = {3, 4, 0, 1, 2};
  if (face < 0 || face >= fem::info(cell).sides)
    return -1;
  if (fem::info(cell).corners == 8)
    return hex[face];
  return fem::info(cell).corners == 4 ? tet[face] : wedge[face];
}

} // namespace abut::abaqus
