// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

#include <string>
#include <vector>

namespace abut::mesh {

/// Takes out nodes and faces that a set lists again: a face would be integrated twice. Says of
/// each such set how many, in one sentence.
std::vector<std::string> drop_duplicates(MeshData& mesh);

} // namespace abut::mesh
