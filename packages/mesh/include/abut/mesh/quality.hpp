// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

namespace abut::mesh {

/// Smallest scaled Jacobian over all corners of all elements: the triple product of the unit edge
/// tangents at a corner (with the middle nodes of quadratic cells), divided by its value in the
/// regular cell. 1 is best; 0 or less is an inverted corner. 1 for a mesh without elements.
double min_scaled_jacobian(const MeshData& mesh);

} // namespace abut::mesh
