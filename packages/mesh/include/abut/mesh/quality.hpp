// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh_data.hpp"

namespace abut::mesh {

/// Smallest scaled Jacobian over the corners of an element with nodes x: the triple product of the
/// unit edge tangents at a corner (with the middle nodes of quadratic cells), divided by its value
/// in the regular cell. 1 is best; 0 or less is an inverted corner.
double scaled_jacobian(fem::CellType type, const Vec3* x);

/// The smallest of all elements; 1 for a mesh without elements.
double min_scaled_jacobian(const MeshData& mesh);

} // namespace abut::mesh
