// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"

#include <optional>

namespace abut::gmsh {

struct ElementType {
  int number; ///< Gmsh's
  const char* name;
  int dim, nodes, corners;
  std::optional<fem::CellType> cell; ///< none: abut has no such cell
  const int* order; ///< (nodes) place in Gmsh's order of each node of Exodus II; null: the same
};

/// nullptr for a number that MSH files of any version leave out.
const ElementType* element_type(int number);

} // namespace abut::gmsh
