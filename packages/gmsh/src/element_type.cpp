// SPDX-License-Identifier: BSD-3-Clause
#include "element_type.hpp"

#include <algorithm>
#include <iterator>

namespace abut::gmsh {

namespace {

// Gmsh's order of edges and faces: its reference manual, "Node ordering".
const int tet10[] = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
const int hex20[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 10, 12, 14, 15, 16, 18, 19, 17};
const int hex27[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  10, 12,
                     14, 15, 16, 18, 19, 17, 26, 20, 25, 22, 23, 21, 24};

using fem::CellType;

const ElementType types[] = {
    {1, "line of 2 nodes", 1, 2, 2, {}, nullptr},
    {2, "triangle of 3 nodes", 2, 3, 3, {}, nullptr},
    {3, "quadrangle of 4 nodes", 2, 4, 4, {}, nullptr},
    {4, "tetrahedron of 4 nodes", 3, 4, 4, CellType::tet4, nullptr},
    {5, "hexahedron of 8 nodes", 3, 8, 8, CellType::hex8, nullptr},
    {6, "prism of 6 nodes", 3, 6, 6, CellType::wedge6, nullptr},
    {7, "pyramid of 5 nodes", 3, 5, 5, {}, nullptr},
    {8, "line of 3 nodes", 1, 3, 2, {}, nullptr},
    {9, "triangle of 6 nodes", 2, 6, 3, {}, nullptr},
    {10, "quadrangle of 9 nodes", 2, 9, 4, {}, nullptr},
    {11, "tetrahedron of 10 nodes", 3, 10, 4, CellType::tet10, tet10},
    {12, "hexahedron of 27 nodes", 3, 27, 8, CellType::hex27, hex27},
    {13, "prism of 18 nodes", 3, 18, 6, {}, nullptr},
    {14, "pyramid of 14 nodes", 3, 14, 5, {}, nullptr},
    {15, "point", 0, 1, 1, {}, nullptr},
    {16, "quadrangle of 8 nodes", 2, 8, 4, {}, nullptr},
    {17, "hexahedron of 20 nodes", 3, 20, 8, CellType::hex20, hex20},
    {18, "prism of 15 nodes", 3, 15, 6, {}, nullptr},
    {19, "pyramid of 13 nodes", 3, 13, 5, {}, nullptr},
    {20, "triangle of 9 nodes", 2, 9, 3, {}, nullptr},
    {21, "triangle of 10 nodes", 2, 10, 3, {}, nullptr},
    {26, "line of 4 nodes", 1, 4, 2, {}, nullptr},
    {29, "tetrahedron of 20 nodes", 3, 20, 4, {}, nullptr},
    {36, "quadrangle of 16 nodes", 2, 16, 4, {}, nullptr},
    {92, "hexahedron of 64 nodes", 3, 64, 8, {}, nullptr},
};

} // namespace

const ElementType* element_type(int number) {
  const auto found = std::find_if(std::begin(types), std::end(types),
                                  [=](const ElementType& t) { return t.number == number; });
  return found == std::end(types) ? nullptr : &*found;
}

} // namespace abut::gmsh
