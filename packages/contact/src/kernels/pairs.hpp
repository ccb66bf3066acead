// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "history/point_arrays.hpp"
#include "kinematics/primary_surface.hpp"
#include "kinematics/facing_surface.hpp"

#include "abut/core/contribution.hpp"

namespace abut::contact {

/// Active points grouped by primary face, the face that carries the force and the anchor's face, in
/// CRS form. Copied by value; the arrays are shared.
struct PairArrays {
  View<Local> face, facing; ///< (pairs)
  View<Local> anchor;       ///< (pairs) -1 unless its nodes take part beside those of facing
  View<Local> first_point;  ///< (pairs+1) into point
  View<Local> point;        ///< (active points)
  View<Local> first_column; ///< (pairs+1) nodes of the pairs, one after the other

  KOKKOS_INLINE_FUNCTION Local size() const { return static_cast<Local>(face.extent(0)); }
  KOKKOS_INLINE_FUNCTION int columns(Local i) const { return first_column(i + 1) - first_column(i); }
};

/// Groups the active points; adds the mesh nodes of each pair to `cells`: primary, facing, anchor.
PairArrays make_pairs(const PrimaryView& primary, const FacingView& facing,
                      const PointArrays& points, Connectivity& cells);

} // namespace abut::contact
