// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/site.hpp"
#include "abut/contact/site_start.hpp"
#include "abut/core/types.hpp"
#include "abut/core/views.hpp"

namespace abut::contact {

constexpr int max_corners = 4; ///< of a face

/// What a node of the law remembers. Only augmentations and the ends of steps write it.
struct NodeHistory {
  double multiplier = 0.0; ///< [pressure]
  bool in_contact = false; ///< at the last converged step
  double gap = 0.0;        ///< then, less the offset, nothing eased [length]
  SiteStart start;         ///< of the averaged gap
  double sliding = 0.0;    ///< size of its shear if it slipped then, else 0 [pressure]
};

/// A node in the present configuration.
struct NodeState {
  double covered = 0.0;    ///< part of its function's integral that has a partner [length^2]
  double area = 0.0;       ///< A, weight of its function at covered points; 0: takes no part
  double normal_sum = 0.0; ///< length of sum w psi c [length^2]
  SiteReading reading;     ///< weighted means over the points
  SiteState site;
};

/// The corner nodes of the primary surface (N), the same on every rank that has them, and their
/// functions at the points (I,P,max_corners). Copied by value; the arrays are shared.
struct NodalArrays {
  View<Local> corner;          ///< (I,max_corners) nodes of each face; -1: none
  View<Local> first_incidence; ///< (N+1) into incidence
  View<Local> incidence;       ///< the places (point, corner) that a node has, ascending
  View<double> full;           ///< (N) integral of the corner function [length^2]
  View<double> size, soft;     ///< (N) see SiteReading
  View<char> prescribed;       ///< (N) it cannot move along the normal
  View<char> merged;           ///< (N) its function is handed on now
  View<double> hat, dual;      ///< corner functions N and psi of each face alone
  View<double> psi, field;     ///< the same now, with cover and merging: psi exerts, N interpolates
  View<double> average;        ///< one of the two: of gap and slip
  View<double> take;           ///< (I,max_corners,max_corners) share of N_a that b has now
  View<StoredTraction> carried, carried_converged; ///< shear multiplier of each corner on the axes
                                                   ///< of the point; empty without friction
  View<NodeHistory> history, converged;            ///< (N)
  View<SiteIterate> iterate;                       ///< (N)
  View<NodeState> state;                           ///< (N)

  KOKKOS_INLINE_FUNCTION Local nodes() const { return static_cast<Local>(state.extent(0)); }
  KOKKOS_INLINE_FUNCTION Local node(Local face, int a) const {
    return corner(face * max_corners + a);
  }
  KOKKOS_INLINE_FUNCTION int corners(Local face) const { return node(face, 3) < 0 ? 3 : 4; }
  KOKKOS_INLINE_FUNCTION const SiteState& site(Local n) const { return state(n).site; }
  /// Value of psi, or of the averaging or interpolating function, of a corner of the point's face.
  KOKKOS_INLINE_FUNCTION double psi_at(Local point, int a) const {
    return psi(point * max_corners + a);
  }
  KOKKOS_INLINE_FUNCTION double average_at(Local point, int a) const {
    return average(point * max_corners + a);
  }
  KOKKOS_INLINE_FUNCTION double field_at(Local point, int a) const {
    return field(point * max_corners + a);
  }
};

} // namespace abut::contact
