// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/core/tensor.hpp"
#include "abut/core/views.hpp"

namespace abut::solid {

/// The cells of a contribution as kernels read them, in CRS form. Copied by value; the arrays are
/// shared.
struct CellArrays {
  View<const Local> first; ///< (cells+1) into node and x
  View<const Local> node;  ///< (entries) local mesh nodes
  View<const Vec3> x;      ///< (entries) reference positions [length]

  Local size() const { return static_cast<Local>(first.extent(0)) - 1; }
  KOKKOS_INLINE_FUNCTION int nodes(Local cell) const { return first(cell + 1) - first(cell); }

  KOKKOS_INLINE_FUNCTION Vec3 displacement(Local entry, const NodalFields& fields) const {
    const double* u = fields.u + static_cast<std::int64_t>(node(entry)) * fields.fields;
    return {{u[0], u[1], u[2]}};
  }
  /// Present positions of a cell's nodes.
  KOKKOS_INLINE_FUNCTION void positions(Local cell, const NodalFields& fields, Vec3* now) const {
    for (Local k = first(cell); k < first(cell + 1); ++k)
      now[k - first(cell)] = x(k) + displacement(k, fields);
  }
  /// Reference positions of a cell of n nodes, by component first.
  template <int n> KOKKOS_INLINE_FUNCTION void reference(Local cell, double (&at)[3][n]) const {
    const Local begin = first(cell);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        at[i][a] = x(begin + a)[i];
  }
  /// Displacements of a cell of n nodes, by component first.
  template <int n>
  KOKKOS_INLINE_FUNCTION void displacements(Local cell, const NodalFields& fields,
                                            double (&u)[3][n]) const {
    const Local begin = first(cell);
    for (int a = 0; a < n; ++a) {
      const Vec3 of = displacement(begin + a, fields);
      for (int i = 0; i < 3; ++i)
        u[i][a] = of[i];
    }
  }
};

} // namespace abut::solid
