// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/mass_kernel.hpp"

namespace abut::solid {

/// Cells and their mass matrices. Copied by value; the arrays are shared.
struct MassArrays {
  CellArrays cells;
  View<const std::int64_t> first; ///< (cells+1) into packed
  View<const double> packed;      ///< see mass_index [mass]

  KOKKOS_INLINE_FUNCTION double operator()(Local cell, int a, int b) const {
    return packed(first(cell) + mass_index(a, b));
  }
};

} // namespace abut::solid
