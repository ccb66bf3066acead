// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "history/point_arrays.hpp"
#include "law/point_terms.hpp"

namespace abut::contact {

/// A point as the point physics takes it, gathered from the arrays. y_previous: nodes of its face
/// at the last converged step; it must live as long as the result.
KOKKOS_INLINE_FUNCTION ContactPoint contact_point(const PrimaryView& primary,
                                                  const FacingView& facing,
                                                  const PointArrays& points,
                                                  const PointTerms& terms, Local i,
                                                  const Vec3* y_previous) {
  const PointState& state = points.state(i);
  const PointHistory& history = points.history(i);
  const SitePast past = points.past(i);
  ContactPoint c;
  c.rule = state.site.rule;
  c.ray = terms.ray;
  c.shape = primary.shape(i);
  c.weight = terms.share * (c.ray ? primary.weight(i) : primary.area(i));
  c.penalty = state.penalty;
  c.friction = terms.law.friction;
  c.offset = state.offset;
  c.multiplier = state.multiplier;
  c.carried = history.carried;
  c.line = state.site.line;
  c.face = state.facing >= 0 ? facing.type(state.facing) : fem::FaceType::quad4;
  c.xi[0] = state.xi[0];
  c.xi[1] = state.xi[1];
  c.anchor_face = state.anchor >= 0 ? facing.type(state.anchor) : c.face;
  c.anchor_xi[0] = history.anchor_xi[0];
  c.anchor_xi[1] = history.anchor_xi[1];
  c.first = !past.in_contact;
  c.previous_gap = past.gap;
  c.x_previous = primary.before(primary.face(i));
  c.y_previous = y_previous;
  return c;
}

/// The same with the traction that the nodes of the law give it: t = pressure c + shear, constant.
KOKKOS_INLINE_FUNCTION ContactPoint given_point(const PrimaryView& primary,
                                                const FacingView& facing,
                                                const PointArrays& points,
                                                const PointTerms& terms, Local i,
                                                const Vec3* y_previous) {
  ContactPoint c = contact_point(primary, facing, points, terms, i, y_previous);
  c.rule = PointRule::frictionless;
  c.multiplier = points.state(i).site.pressure;
  c.penalty = c.offset = 0.0;
  return c;
}

} // namespace abut::contact
