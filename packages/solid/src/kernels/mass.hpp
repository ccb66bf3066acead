// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/mass_kernel.hpp"

/// Integrals over cells of mixed types in their reference configuration.
namespace abut::solid {

/// What kernels read of cells with a mass. Copied by value; the arrays are shared.
struct MassiveCells {
  CellArrays cells;
  View<const fem::CellType> type; ///< (cells)
  View<const MassCells> tables;   ///< one
};

/// Mass matrices.
struct CellMass {
  MassiveCells massive;
  View<const double> density;     ///< (cells) [mass/length^3]
  View<const std::int64_t> first; ///< (cells+1) into mass
  View<double> mass;              ///< packed, see mass_index

  KOKKOS_INLINE_FUNCTION void operator()(Local c) const {
    fem::dispatch_cell(massive.type(c), [&](auto shape) {
      const MassCell<decltype(shape)::type>& table = massive.tables(0);
      double x[3][decltype(shape)::nodes];
      massive.cells.reference(c, x);
      element_mass(table, x, density(c), &mass(first(c)));
    });
  }
};

/// Sums of volume, int x and int x x^T (xx, yy, zz, xy, yz, zx).
struct VolumeMoments {
  using value_type = double[];
  static constexpr unsigned value_count = 10;

  MassiveCells massive;

  KOKKOS_INLINE_FUNCTION void operator()(Local c, double* sums) const {
    fem::dispatch_cell(massive.type(c), [&](auto shape) {
      constexpr int n = decltype(shape)::nodes;
      const MassCell<decltype(shape)::type>& table = massive.tables(0);
      double nodes[3][n];
      massive.cells.reference(c, nodes);
      for (int p = 0; p < table.points; ++p) {
        const double volume = table.weight[p] * det(nodal_gradient(nodes, table.dN[p]));
        Vec3 x = Vec3::zero();
        for (int a = 0; a < n; ++a)
          for (int i = 0; i < 3; ++i)
            x[i] += table.N[p][a] * nodes[i][a];
        sums[0] += volume;
        for (int i = 0; i < 3; ++i) {
          sums[1 + i] += volume * x[i];
          sums[4 + i] += volume * x[i] * x[i];
          sums[7 + i] += volume * x[i] * x[(i + 1) % 3];
        }
      }
    });
  }
};

} // namespace abut::solid
