// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "history/point_arrays.hpp"
#include "kinematics/partner_search.hpp"

namespace abut::contact {

/// What the state of a site leaves to the evaluations after the iterate.
KOKKOS_INLINE_FUNCTION void leave(const SiteState& s, bool new_step, SiteIterate& iterate) {
  SiteState before;
  before.rule = iterate.rule;
  before.touching = iterate.touching;
  iterate.flips = new_step ? 0 : iterate.flips + (s.status() != before.status());
  iterate.last = {s.pressed(), s.status() == Status::slip, s.line};
  if (s.rule == PointRule::inclined_slip) {
    const double size = norm(s.shear);
    iterate.last.line = {size > 0.0 ? (1.0 / size) * s.shear : Vec3::zero(), 0.0};
  }
  iterate.frozen = false;
  iterate.rule = s.rule;
  iterate.touching = s.touching;
}

/// Newton goes on from this iterate: the next searches start at its partners, and points that swing
/// between two faces or over a rim are counted.
struct TakePoints {
  PartnerSearch search;
  PointArrays points;
  bool new_step = false; ///< it is the first iterate of a step

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    PointIterate& iterate = points.iterate(i);
    const PointState& s = points.state(i);
    if (s.searched && iterate.losses < swings)
      take_partner(i, s, iterate);
    leave(s.site, new_step, iterate.site);
  }

private:
  /// Past a rim a force ends at once, and what springs back takes it up again: there is no balance
  /// between.
  KOKKOS_INLINE_FUNCTION bool lost_over_rim(Local i, const PointIterate& iterate) const {
    if (iterate.near < 0 || iterate.site.rule == PointRule::open || iterate.site.touching)
      return false;
    const Local last = search.facing.find(iterate.near);
    return last >= 0 && search.past_rim(last, iterate.near_xi, search.primary.at(i).x);
  }

  KOKKOS_INLINE_FUNCTION void take_partner(Local i, const PointState& s,
                                           PointIterate& iterate) const {
    const Global near = s.near >= 0 ? search.facing.face_id(s.near) : -1;
    if (near < 0 && lost_over_rim(i, iterate))
      ++iterate.losses;
    if (s.by_site && iterate.near >= 0 && near >= 0 && near != iterate.near) {
      iterate.returns += near == iterate.left;
      iterate.left = iterate.near;
    }
    iterate.near = near;
    iterate.near_xi[0] = s.near_xi[0];
    iterate.near_xi[1] = s.near_xi[1];
  }
};

} // namespace abut::contact
