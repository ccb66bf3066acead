// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/site.hpp"
#include "abut/contact/site_start.hpp"
#include "abut/core/types.hpp"
#include "abut/core/views.hpp"

namespace abut::contact {

/// What a point remembers. Only augmentations and the ends of steps write it.
struct PointHistory {
  double multiplier = 0.0; ///< of the pressure; negative in tension of tied points [pressure]
  StoredTraction carried;  ///< tangential multiplier or converged traction
  Global anchor = -1;      ///< id of the secondary face that holds the anchor; -1: none
  double anchor_xi[2] = {0.0, 0.0};
  StoredTraction rest;     ///< way to the anchor that strains nothing, offset taken off [length]
  bool in_contact = false; ///< at the last converged step
  bool torn = false;       ///< a sticky point that has come off in this step
  double gap = 0.0;        ///< at the last converged step, offset not taken off [length]
  double rise = 0.0;       ///< of the round surfaces over the faces at the start [length]
  SiteStart start;
  double path = 0.0;       ///< length of the way slipped in contact so far [length]
  double sliding = 0.0;    ///< shear force of the last step if it slipped then, else 0 [force]
  double dissipated = 0.0; ///< friction work so far [energy]
};

/// What the iterates of this solve have left of a point's search and law.
struct PointIterate {
  SiteIterate site;
  Global near = -1; ///< id of the face of the nearest partner: where the next search starts
  double near_xi[2] = {0.0, 0.0};
  Global left = -1; ///< id of the face that was the nearest before
  int returns = 0;  ///< times the point went back to it
  int losses = 0;   ///< times it was pressed and went over the rim
};

/// A point in the present configuration: written whole by every evaluation.
struct PointState {
  Local facing = -1;         ///< face in FacingView that carries the force, -1: none
  Local anchor = -1;         ///< face of the anchor in FacingView, when there is one
  double xi[2] = {0.0, 0.0}; ///< partner on the face
  Local near = -1;           ///< face of the nearest partner
  double near_xi[2] = {0.0, 0.0};
  double gap = 0.0;         ///< > 0 open, offset not taken off [length]
  double offset = 0.0;      ///< gap that counts as zero now [length]
  double penalty = 0.0;     ///< [pressure/length]
  double multiplier = 0.0;  ///< so that pressure = multiplier - penalty (gap - offset)
  Vec3 normal{{0, 0, 0}};   ///< contact normal, from the secondary to the primary
  Vec3 traction{{0, 0, 0}}; ///< on the primary, per area of the formulation's measure [pressure]
  bool searched = false;    ///< its partner was sought; else an anchor is all it needs
  bool by_site = false;     ///< the law of sites decides it; else a friction map with anchors has
  SiteState site;
};

/// All points of an interface, (I,P). Copied by value; the arrays are shared.
struct PointArrays {
  View<PointHistory> history;   ///< trial
  View<PointHistory> converged; ///< at the last converged step
  View<PointIterate> iterate;
  View<PointState> state;
  View<SiteReading> reading; ///< of those that the law of sites decides

  KOKKOS_INLINE_FUNCTION Local size() const { return static_cast<Local>(state.extent(0)); }
  /// Gap less offset and what is taken off at the start of a tie [length].
  KOKKOS_INLINE_FUNCTION double net_gap(Local i) const {
    return state(i).gap - state(i).offset - history(i).rest.component[2];
  }
  KOKKOS_INLINE_FUNCTION SitePast past(Local i) const {
    return {converged(i).in_contact, converged(i).gap - state(i).offset};
  }
};

inline PointArrays make_point_arrays(Local points) {
  const auto n = static_cast<std::size_t>(points);
  return {make_view<PointHistory>("abut::contact::history", n),
          make_view<PointHistory>("abut::contact::converged", n),
          make_view<PointIterate>("abut::contact::iterate", n),
          make_view<PointState>("abut::contact::state", n),
          make_view<SiteReading>("abut::contact::reading", n)};
}

} // namespace abut::contact
