// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

#include <functional>
#include <string>

namespace abut::meshgen {

/// Adds the nodes, blocks and sets of `part` to `whole`, without joining nodes. Sets of one name
/// become one; block ids are numbered on from the largest one of `whole`. Both meshes must be
/// without number maps.
void append(mesh::MeshData& whole, const mesh::MeshData& part);

/// Adds all element sides whose corner nodes satisfy `chosen` to the side set `name`.
void add_side_set(mesh::MeshData& mesh, const std::string& name,
                  const std::function<bool(Global node)>& chosen);

/// For every side set a node set of the same name with its nodes in ascending order.
void node_sets_from_side_sets(mesh::MeshData& mesh);

} // namespace abut::meshgen
