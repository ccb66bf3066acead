// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

#include <cstdint>

namespace abut::mesh {

/// A number that tells this mesh from others: coordinates, elements, number maps and sets. Serial.
std::uint64_t fingerprint(const MeshData& mesh);

} // namespace abut::mesh
