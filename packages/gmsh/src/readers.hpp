// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cursor.hpp"

#include "abut/translation/report.hpp"

#include <cstdlib>
#include <limits>
#include <map>
#include <vector>

/// Readers of the sections of a file, from behind $NAME to $EndNAME. All throw InputError as
/// read_model does.
namespace abut::gmsh {

inline constexpr const char* in_parts =
    "the mesh is cut into parts; save it whole, without partitions";

/// A group's number. Gmsh writes a minus where the orientation is turned round.
inline int tag_of(int tag) {
  return tag == std::numeric_limits<int>::min() ? 0 : std::abs(tag);
}

using Physical = std::map<Entity, std::vector<int>>; ///< tags of the physical groups of entities

void read_names(Cursor& cursor, Model& model);

// Version 4.1.
Physical read_entities(Cursor& cursor);
void read_nodes(Cursor& cursor, Model& model);
void read_elements(Cursor& cursor, const Physical& physical, Model& model);

// Version 2.2.
void read_nodes_2(Cursor& cursor, Model& model);
void read_elements_2(Cursor& cursor, Model& model);

} // namespace abut::gmsh
