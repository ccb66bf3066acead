// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cursor.hpp"

#include "abut/translation/report.hpp"

#include <map>
#include <vector>

/// Readers of the sections of a file, from behind $NAME to $EndNAME. All throw InputError as
/// read_model does.
namespace abut::gmsh {

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
