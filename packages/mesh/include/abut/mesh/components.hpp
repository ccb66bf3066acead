// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh.hpp"

#include <vector>

namespace abut::mesh {

/// Connected pieces of the blocks whose flag is set: for each local node the lowest input node
/// index (0-based) of its piece, -1 for nodes of other blocks only. Collective.
std::vector<Global> connected_pieces(const Mesh& mesh, const std::vector<char>& block_counts);

} // namespace abut::mesh
