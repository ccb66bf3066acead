// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"
#include "exodus_file.hpp"

namespace abut::io {

/// Writes sizes, coordinates, blocks, number maps and sets into a new file whose names may have up
/// to `name_length` characters.
void put_mesh(const ExodusFile& file, const mesh::MeshData& mesh, int name_length);

/// Longest name of a block or set, at least 32.
int longest_name(const mesh::MeshData& mesh);

} // namespace abut::io
