// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

#include <string>
#include <vector>

namespace abut::meshgen {

/// Names of the six sides of a structured block.
struct SideNames {
  std::string x0 = "x0", x1 = "x1", y0 = "y0", y1 = "y1", z0 = "z0", z1 = "z1";
};

/// Throws InputError when a generated block would have more than `most` cells.
void require_cells(double cells, double most = 2e7);

/// Block of hex8 cells over the products of three axes; x runs fastest. Sides without name have no
/// side set.
mesh::MeshData structured_block(const std::vector<double>& x, const std::vector<double>& y,
                                const std::vector<double>& z, const std::string& name,
                                const SideNames& sides);

/// Moves the nodes of a structured box by up to `fraction` of the neighbouring cell, within the
/// faces, edges and corners that they lie on. The same seed gives the same mesh everywhere.
void distort(mesh::MeshData& mesh, const std::vector<double>& x, const std::vector<double>& y,
             const std::vector<double>& z, double fraction, unsigned seed);

} // namespace abut::meshgen
