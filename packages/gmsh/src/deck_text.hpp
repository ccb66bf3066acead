// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

#include <string>

namespace abut::gmsh {

/// A deck to start from: the mesh NAME.exo, results in NAME_results, a body for each block, the
/// names of its surfaces, and marks where a user must fill in.
std::string deck_text(const mesh::MeshData& mesh, const std::string& name);

} // namespace abut::gmsh
