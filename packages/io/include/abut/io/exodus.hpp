// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

#include <string>

namespace abut::io {

/// Reads a mesh from an Exodus II file of any integer width. Blocks and sets without a name are
/// called block_ID, nodeset_ID, sideset_ID; number maps equal to 1, 2, ... are left empty. Serial.
/// Throws InputError, naming the file, when it is missing, not Exodus, truncated or damaged, when a
/// block has a cell type that abut lacks, an element a repeated or unknown node, a set an unknown
/// node or side, or when two blocks or sets have one name.
mesh::MeshData read_exodus(const std::string& path);

/// Writes a mesh as an Exodus II file, replacing what is there. Sets called nodeset_ID, sideset_ID
/// keep that id, others are numbered from 1. Throws InputError when the file cannot be written.
void write_mesh(const std::string& path, const mesh::MeshData& mesh);

} // namespace abut::io
