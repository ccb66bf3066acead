// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh.hpp"
#include "abut/solid/material.hpp"

#include <vector>

namespace abut::solid {

/// Material of each block of the mesh; null for blocks of rigid bodies.
using BlockMaterials = std::vector<const Material*>;

/// What automatic contact penalties are made of, per face.
struct FaceStiffness {
  std::vector<double> modulus;       ///< E_n along the mean face normal [pressure]; 0: rigid
  std::vector<double> inverse_depth; ///< face area / element volume, reference [1/length]
};

FaceStiffness face_stiffness(const mesh::Mesh& mesh, const std::vector<mesh::Side>& sides,
                             const BlockMaterials& materials);

/// E_n A / V per face [pressure/length]; 0 for faces of rigid blocks.
std::vector<double> penalty_base(const mesh::Mesh& mesh, const std::vector<mesh::Side>& sides,
                                 const BlockMaterials& materials);

} // namespace abut::solid
