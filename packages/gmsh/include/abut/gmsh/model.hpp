// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// A Gmsh mesh (MSH 2.2 or 4.1) as plain data, in the numbers of its file. `at` is where an item
/// stands: a line, counted from 1, or in a binary file a byte, counted from 0.
namespace abut::gmsh {

/// Dimension (0 point, 1 curve, 2 surface, 3 volume) and tag.
using Entity = std::pair<int, int>;

/// Elements of one type on one entity.
struct Elements {
  int type = 0; ///< Gmsh's number, one of element_type()
  Entity entity{};
  std::vector<int> physical;   ///< tags of the physical groups, > 0; empty: in none
  std::vector<Global> id;      ///< (elements)
  std::vector<std::size_t> at; ///< (elements)
  std::vector<Global> nodes;   ///< (elements, nodes) node numbers in Gmsh's order
};

struct Model {
  std::string file;
  bool binary = false;
  std::size_t nodes_at = 0, elements_at = 0; ///< of the sections
  std::vector<Global> node_id;
  std::vector<double> x; ///< (nodes, 3)
  std::vector<Elements> elements;
  std::map<Entity, std::string> names; ///< of physical groups that have one

  /// "FILE:LINE" or "FILE: byte N" to begin a message.
  std::string where(std::size_t at) const {
    return file + (binary ? ": byte " : ":") + std::to_string(at);
  }
};

} // namespace abut::gmsh
