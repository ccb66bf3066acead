// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/contact_point.hpp"
#include "kinematics/partner_search.hpp"

namespace abut::contact {

/// Finds the partner of each point and what the law wants to know there. Points that hold an anchor
/// are decided on the way: whether the search is needed depends on it.
struct ReadPoints {
  PartnerSearch search;
  PointArrays points;
  PointTerms terms;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    points.reading(i) = {};
    PointState& s = points.state(i);
    s = {};
    const PointHistory& history = points.history(i);
    const auto at = search.primary.at(i);
    s.offset = terms.offset + terms.rise * history.rise - terms.start.eased(history.start);
    s.anchor = history.anchor >= 0 ? search.facing.find(history.anchor) : -1;
    if (terms.anchored_map && s.anchor >= 0 && anchored(i, at, s))
      return;
    s.site = {};
    if (terms.tied || (terms.sticky && history.anchor >= 0))
      return stay_open(i, s);
    read_partner(i, at, s);
  }

private:
  KOKKOS_INLINE_FUNCTION void stay_open(Local i, PointState& s) const {
    s.facing = -1;
    s.gap = terms.reach * search.primary.size(search.primary.face(i));
    s.site = {};
    s.traction = Vec3::zero();
  }

  /// The search from where the last iterate ended.
  KOKKOS_INLINE_FUNCTION Query start(Local i, const PrimaryPoint<double>& at) const {
    const PointIterate& iterate = points.iterate(i);
    const Local last = iterate.near >= 0 ? search.facing.find(iterate.near) : -1;
    Query q = search.query(i, at, last, iterate.near_xi);
    q.was_in_contact = points.converged(i).in_contact;
    if (terms.search_hold > 0.0)
      q.hold = terms.search_hold;
    else if (!q.line && iterate.returns >= swings)
      q.hold = hold_margin;
    return q;
  }

  /// What the law of sites reads besides what every point has.
  KOKKOS_INLINE_FUNCTION SiteReading reading(Local i, Local other, double penalty) const {
    const Local face = search.primary.face(i);
    SiteReading r;
    r.size = search.primary.size(face);
    r.penalty = penalty;
    r.multiplier = points.history(i).multiplier;
    if (terms.soft_modulus > 0.0)
      r.soft = terms.soft_modulus *
               PointTerms::inverse_depth(search.primary, search.facing, face, other);
    return r;
  }

  /// Traction of a rule with an anchor.
  KOKKOS_INLINE_FUNCTION void apply(Local i, PointRule rule, PointState& s) const {
    s.site.rule = rule;
    if (rule == PointRule::open) {
      s.traction = Vec3::zero();
      return;
    }
    Vec3 y[fem::max_face_nodes], z[fem::max_face_nodes];
    search.facing.coordinates(s.facing, y);
    search.facing.coordinates(s.anchor, z);
    const ContactPoint c = contact_point(search.primary, search.facing, points, terms, i, nullptr);
    const auto t = point_traction<double>(c, search.primary.now(search.primary.face(i)), y, z);
    s.traction = t.traction;
    s.gap = t.gap;
    s.normal = t.c;
    s.site.pressure = t.pressure;
    s.site.shear = t.traction - t.pressure * t.c;
  }

  /// Stick against the anchor, or slip along the inclined ray. False: the formulation's own search
  /// must decide.
  KOKKOS_INLINE_FUNCTION bool anchored(Local i, const PrimaryPoint<double>& at,
                                       PointState& s) const {
    const Local face = search.primary.face(i);
    s.penalty = terms.penalty_of(search.primary, search.facing, face, s.anchor);
    s.multiplier = points.history(i).multiplier;
    const ContactPoint c = contact_point(search.primary, search.facing, points, terms, i, nullptr);
    Vec3 z[fem::max_face_nodes];
    search.facing.coordinates(s.anchor, z);
    const Vec3 trial = anchored_trial(c, at, z);
    const double pressure = -dot(at.normal, trial);
    const Vec3 w = trial - dot(at.normal, trial) * at.normal;
    const bool sticks =
        terms.anchors || !choose_status(reading(i, s.anchor, s.penalty), points.iterate(i).site,
                                        terms.law, w, at.normal, pressure)
                              .slips;
    const bool beyond = norm(w) > terms.law.friction * pressure;
    s.site.settled = terms.anchors || sticks != beyond;
    if (sticks && (terms.anchors || pressure > 0.0 || terms.tension)) {
      s.facing = s.anchor;
      s.xi[0] = points.history(i).anchor_xi[0];
      s.xi[1] = points.history(i).anchor_xi[1];
      apply(i, PointRule::anchored, s);
      return true;
    }
    return terms.inclined && norm(w) > 0.0 && inclined(i, c, at, trial, s);
  }

  KOKKOS_INLINE_FUNCTION bool inclined(Local i, const ContactPoint& c,
                                       const PrimaryPoint<double>& at, const Vec3& trial,
                                       PointState& s) const {
    Query q = start(i, at);
    q.line = true;
    inclined_ray(c, at, trial, q.origin, q.direction);
    if (q.last < 0) {
      q.last = s.anchor;
      q.last_xi[0] = points.history(i).anchor_xi[0];
      q.last_xi[1] = points.history(i).anchor_xi[1];
    }
    const Partner hit = search.find(q);
    if (hit.face < 0)
      return false;
    Vec3 y[fem::max_face_nodes];
    search.facing.coordinates(hit.face, y);
    fem::FacePoint<double> on;
    fem::face_point(search.facing.type(hit.face), y, hit.xi, on);
    take(hit, s);
    const bool presses = dot(on.x - q.origin, q.direction) > 0.0;
    apply(i, presses ? PointRule::inclined_slip : PointRule::open, s);
    return true;
  }

  KOKKOS_INLINE_FUNCTION static void take(const Partner& best, PointState& s) {
    s.searched = true;
    s.near = s.facing = best.face;
    for (int k = 0; k < 2; ++k)
      s.near_xi[k] = s.xi[k] = best.xi[k];
    s.gap = best.gap;
  }

  /// Partner, gap and slip of a point that the law of sites decides. A point that has slid over the
  /// rim again and again has no partner for this solve.
  KOKKOS_INLINE_FUNCTION void read_partner(Local i, const PrimaryPoint<double>& at,
                                           PointState& s) const {
    s.by_site = s.searched = true;
    const Partner best = points.iterate(i).losses >= swings ? Partner() : search.find(start(i, at));
    if (best.face < 0)
      return stay_open(i, s);
    take(best, s);
    s.normal = terms.ray ? -at.normal : best.normal;
    s.penalty = terms.penalty_of(search.primary, search.facing, search.primary.face(i), best.face);
    s.multiplier = points.history(i).multiplier;
    SiteReading r = reading(i, best.face, s.penalty);
    r.covered = true;
    read_gap(i, s, r);
    // Open without friction: as near as the search comes will do. Friction remembers the gap.
    if (terms.law.friction > 0.0 || may_press(r))
      meet_partner(i, at, s, r);
    points.reading(i) = r;
  }

  KOKKOS_INLINE_FUNCTION void read_gap(Local i, const PointState& s, SiteReading& r) const {
    r.gap = points.net_gap(i);
    r.eased = terms.start.eased(points.history(i).start);
    r.normal = s.normal;
    r.pulls = (terms.tension && points.converged(i).in_contact) ||
              (terms.sticky && !points.history(i).torn && r.gap < terms.stick_within);
  }

  KOKKOS_INLINE_FUNCTION bool may_press(const SiteReading& r) const {
    return terms.at_nodes || terms.user_law || r.pulls ||
           r.multiplier - r.penalty * (r.gap - touching_gap * r.size) > 0.0;
  }

  /// The partner to rounding, where the search stops before, and the slip.
  KOKKOS_INLINE_FUNCTION void meet_partner(Local i, const PrimaryPoint<double>& at, PointState& s,
                                           SiteReading& r) const {
    Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes];
    search.facing.coordinates(s.facing, y);
    search.facing.previous_coordinates(s.facing, y_previous);
    const ContactPoint c =
        contact_point(search.primary, search.facing, points, terms, i, y_previous);
    const auto partner = contact_partner<double>(c, at, y);
    s.xi[0] = partner.xi[0];
    s.xi[1] = partner.xi[1];
    s.gap = partner.gap;
    s.normal = partner.c;
    read_gap(i, s, r);
    if (terms.law.friction > 0.0 && !terms.law.literal && may_press(r)) {
      r.slip = objective_slip(c, partner);
      if (!terms.at_nodes) // nodes carry a shear for each of their points
        r.carried = turned_traction(points.history(i).carried, at);
    }
  }
};

/// The law at the points, for those that hold it themselves.
struct DecidePoints {
  PrimaryView primary;
  FacingView facing;
  PointArrays points;
  PointTerms terms;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    PointState& s = points.state(i);
    if (!s.by_site)
      return;
    const SiteReading& r = points.reading(i);
    s.site = decide(r, points.past(i), points.iterate(i).site, terms.law);
    if (s.facing >= 0) {
      s.penalty = r.penalty; // a law of the host's own has another stiffness
      s.multiplier = r.multiplier;
      if (s.site.touching && terms.law.hair > 0.0)
        s.penalty *= terms.law.hair_share;
    }
    s.traction = s.site.pressure * s.normal + s.site.shear;
    if (s.site.rule != PointRule::literal_slip)
      return;
    Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes];
    facing.coordinates(s.facing, y);
    facing.previous_coordinates(s.facing, y_previous);
    const ContactPoint c = contact_point(primary, facing, points, terms, i, y_previous);
    const auto t = point_traction<double>(c, primary.now(primary.face(i)), y, y);
    s.traction = t.traction;
    s.site.shear = t.traction - s.site.pressure * s.normal;
  }
};

} // namespace abut::contact
