// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh.hpp"

namespace abut::solid {

/// Mass, its center and its moments of inertia about that center.
struct MassProperties {
  double mass = 0.0;
  Vec3 center = Vec3::zero();  ///< [length]
  Mat3 inertia = Mat3::zero(); ///< [mass length^2]
};

/// Of the elements of the blocks given, from their reference configuration. Collective.
MassProperties mass_properties(const mesh::Mesh& mesh, const std::vector<int>& blocks,
                               double density);

} // namespace abut::solid
