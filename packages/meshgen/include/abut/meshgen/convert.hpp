// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <functional>

namespace abut::meshgen {

/// Moves a new node from the centre of an edge or face onto the true geometry.
/// corners: (count) positions of the corners that the node lies between.
using Projection = std::function<Vec3(const Vec3& centre, const Vec3* corners, int count)>;

/// Makes another mesh out of one of hex8 cells, keeping blocks and side sets:
/// hex20 and hex27 by adding nodes, tet4 and tet10 by six tetrahedra per cell, wedge6 by halving
/// each cell along its first two directions. Neighbours fit: a face is cut from its node of the
/// smallest number (Dompierre et al., How to subdivide pyramids, prisms and hexahedra into
/// tetrahedra, 1999). Node sets keep their corner nodes only (see node_sets_from_side_sets).
/// Throws InputError when wedges of neighbouring cells cannot fit.
mesh::MeshData convert(const mesh::MeshData& hex8, fem::CellType type,
                       const Projection& project = {});

} // namespace abut::meshgen
