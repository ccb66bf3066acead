// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/fem/cell.hpp"
#include "abut/mesh/mesh.hpp"

namespace abut::solid {

constexpr int mass_size(int nodes) {
  return nodes * (nodes + 1) / 2;
}
/// Place of the entry a, b in a packed symmetric matrix.
constexpr int mass_index(int a, int b) {
  return a < b ? b * (b + 1) / 2 + a : a * (a + 1) / 2 + b;
}

/// Consistent mass m_ab = density int N_a N_b dV of a cell with reference coordinates x (n,3),
/// packed. Exact for all linear cells, and for quadratic ones with plane faces and straight edges
/// (tet10: as well, hexahedra: any trilinear form). [mass]
void element_mass(fem::CellType type, const double* x, double density, double* m);

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
