// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh.hpp"

#include <vector>

namespace abut::solid {

/// An element whose reference Jacobian is not positive at some integration point.
struct BadElement {
  int block = 0;         ///< index of the block
  Global element_id = 0; ///< number in the input
  double det = 0.0;      ///< smallest determinant of dX/dxi over its points
};

/// This rank's bad elements.
std::vector<BadElement> bad_elements(const mesh::Mesh& mesh);

/// Collective. Throws InputError on all ranks when there is a bad element on any; the message names
/// block, element and determinant.
void check_elements(const mesh::Mesh& mesh);

/// Reference volume of an element of this rank.
double element_volume(const mesh::Mesh& mesh, int block, Local element);

} // namespace abut::solid
