// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/solid_point.hpp"

/// One massive element: from nodal coordinates to its mass matrix.
namespace abut::solid {

constexpr int mass_size(int nodes) {
  return nodes * (nodes + 1) / 2;
}
/// Place of the entry a, b in a packed symmetric matrix.
constexpr int mass_index(int a, int b) {
  return a < b ? b * (b + 1) / 2 + a : a * (a + 1) / 2 + b;
}

constexpr bool is_quadratic_hex(fem::CellType type) {
  return type == fem::CellType::hex20 || type == fem::CellType::hex27;
}
constexpr int mass_points(fem::CellType type) {
  return is_quadratic_hex(type)          ? 64
         : type == fem::CellType::hex8   ? 27
         : type == fem::CellType::tet4   ? 4
         : type == fem::CellType::wedge6 ? 18
                                         : 15;
}

/// At the points that integrate N_a N_b det J.
template <fem::CellType C> struct MassCell : CellTable<C, mass_points(C)> {
  MassCell()
      : CellTable<C, mass_points(C)>(is_quadratic_hex(C)        ? 4
                                     : C == fem::CellType::tet4 ? 2
                                                                : 3) {}
};

/// The tables of all cell types, for loops over mixed ones: a base for each.
struct MassCells : MassCell<fem::CellType::hex8>,
                   MassCell<fem::CellType::hex20>,
                   MassCell<fem::CellType::hex27>,
                   MassCell<fem::CellType::tet4>,
                   MassCell<fem::CellType::tet10>,
                   MassCell<fem::CellType::wedge6> {};

/// Consistent mass m_ab = density int N_a N_b dV of a cell with reference coordinates x, packed.
/// Exact for all linear cells, and for quadratic ones with plane faces and straight edges (tet10:
/// as well, hexahedra: any trilinear form). [mass]
template <fem::CellType C>
KOKKOS_INLINE_FUNCTION void element_mass(const MassCell<C>& cell,
                                         const double (&x)[3][MassCell<C>::nodes], double density,
                                         double* m) {
  constexpr int n = MassCell<C>::nodes;
  for (int k = 0; k < mass_size(n); ++k)
    m[k] = 0.0;
  for (int p = 0; p < MassCell<C>::points; ++p) {
    const double volume = cell.weight[p] * det(nodal_gradient(x, cell.dN[p]));
    for (int a = 0; a < n; ++a)
      for (int b = 0; b <= a; ++b)
        m[mass_index(a, b)] += density * volume * cell.N[p][a] * cell.N[p][b];
  }
}

} // namespace abut::solid
