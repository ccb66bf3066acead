// SPDX-License-Identifier: BSD-3-Clause
#include "history/steps.hpp"

#include "kernels/contact_point.hpp"
#include "kernels/read_points.hpp"
#include "kernels/take_iterate.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

/// The distance of a tie at the start strains nothing: lambda cancels it.
void rest_tie(InterfaceData& data, Local i, const PrimaryPoint<double>& at, const Partner& best) {
  PointHistory& history = data.points.history(i);
  Vec3 y[fem::max_face_nodes];
  data.facing().coordinates(best.face, y);
  fem::FacePoint<double> on;
  fem::face_point(data.facing().type(best.face), y, best.xi, on);
  const double offset = data.settings.offset + data.terms.rise * history.rise;
  history.rest = store_traction(at, on.x - at.x - offset * at.normal);
  const double penalty =
      data.terms.penalty_of(data.primary(), data.facing(), data.primary().face(i), best.face);
  const Vec3 lambda = -penalty * turned_traction(history.rest, at);
  history.multiplier = -dot(at.normal, lambda);
  history.carried = store_traction(at, lambda + history.multiplier * at.normal);
}

void begin_point(InterfaceData& data, const PartnerSearch& search, Local i) {
  const Settings& o = data.settings;
  const auto at = data.primary().at(i);
  const double nowhere[2] = {0.0, 0.0};
  const Partner best = search.find(search.query(i, at, -1, nowhere));
  data.points.history(i).rise = data.place.rise_between(i, best);
  if (best.face < 0)
    return;
  PointIterate& iterate = data.points.iterate(i);
  iterate.near = data.facing().face_id(best.face);
  std::copy_n(best.xi, 2, iterate.near_xi);
  PointHistory& history = data.points.history(i);
  history.gap = best.gap;
  const double start = best.gap - data.terms.rise * history.rise;
  history.start = o.start_of(start);
  const double gap = start - o.offset - history.start.shift,
               size = data.primary().size(data.primary().face(i));
  const double touching = touching_gap * size;
  history.in_contact = o.tied     ? std::fabs(gap) <= o.tie_distance * size
                       : o.sticky ? gap < o.stick_within - touching
                                  : gap <= touching;
  if (!history.in_contact)
    return;
  history.anchor = iterate.near;
  std::copy_n(best.xi, 2, history.anchor_xi);
  if (o.tied && o.tie_gap == TieGap::keep)
    rest_tie(data, i, at, best);
}

/// Part of the step's slip that no spring stores, tangent to the contact [length].
Vec3 plastic_slip(const InterfaceData& data, Local i) {
  const PointState& state = data.points.state(i);
  Vec3 y[fem::max_face_nodes], z[fem::max_face_nodes];
  data.facing().coordinates(state.facing, y);
  if (state.site.rule == PointRule::inclined_slip) {
    data.facing().coordinates(state.anchor, z);
    const ContactPoint c =
        contact_point(data.primary(), data.facing(), data.points, data.terms, i, nullptr);
    fem::FacePoint<double> anchor, hit;
    fem::face_point(c.anchor_face, z, c.anchor_xi, anchor);
    fem::face_point(c.face, y, c.xi, hit);
    return anchor.x - hit.x;
  }
  data.facing().previous_coordinates(state.facing, z);
  const ContactPoint c =
      contact_point(data.primary(), data.facing(), data.points, data.terms, i, z);
  const auto at = data.primary().at(i);
  const Vec3 slip =
      contact_share(c, data.points.net_gap(i)) * objective_slip(c, contact_partner(c, at, y));
  return slip + (1.0 / state.penalty) *
                    (state.site.shear - turned_traction(data.points.history(i).carried, at));
}

/// Way slipped, and what it has cost.
void add_slip(InterfaceData& data, Local i, double slid) {
  PointHistory& history = data.points.history(i);
  const PointState& state = data.points.state(i);
  const Vec3 slip = plastic_slip(data, i);
  const double way = norm(slip - dot(state.normal, slip) * state.normal);
  history.path += way;
  history.sliding = data.terms.share * data.measure(i) * norm(state.site.shear);
  history.dissipated += way * (slid > 0.0 ? 0.5 * (slid + history.sliding) : history.sliding);
}

void end_point(InterfaceData& data, Local i) {
  const Settings& o = data.settings;
  const PointState& state = data.points.state(i);
  const SiteState& site = state.site;
  PointHistory& history = data.points.history(i);
  history.gap = state.gap;
  history.in_contact = site.active();
  if (!site.active()) {
    if (!o.anchors() || history.anchor < 0) {
      history.anchor = -1;
      history.carried = {};
    }
    return;
  }
  const double slid = history.sliding;
  history.sliding = 0.0;
  if (site.rule == PointRule::anchored)
    return;
  const bool has_friction = site.rule != PointRule::frictionless;
  if (has_friction && site.status() == Status::slip)
    add_slip(data, i, slid);
  if (o.sticky ? site.pressed() && !history.torn : o.friction_map != FrictionMap::incremental) {
    history.anchor = data.facing().face_id(state.facing);
    std::copy_n(state.xi, 2, history.anchor_xi);
  }
  if (!has_friction)
    history.carried = {};
  else if (site.rule == PointRule::incremental_stick || site.rule == PointRule::incremental_slip)
    history.carried = store_traction(data.primary().at(i), site.shear);
}

/// Points of a nodal law take what their nodes have.
void end_point_of_nodes(InterfaceData& data, Local i) {
  const PointState& state = data.points.state(i);
  PointHistory& history = data.points.history(i);
  history.gap = state.gap;
  history.in_contact = state.site.active();
  const NodalArrays& nodes = data.nodal->arrays();
  const Local face = data.primary().face(i);
  for (int a = 0; state.facing >= 0 && a < nodes.corners(face); ++a) {
    const Local n = nodes.node(face, a);
    const double weight = nodes.field_at(i, a);
    history.path += weight * data.nodal->slipped(n);
    history.dissipated += weight * data.terms.share * data.measure(i) * data.nodal->dissipated(n);
  }
}

} // namespace

void begin_history(InterfaceData& data) {
  data.place.at_last_step([&] {
    const PartnerSearch search = data.place.search();
    for (Local i = 0; i < data.points.size(); ++i) {
      begin_point(data, search, i);
      data.points.converged(i) = data.points.history(i);
    }
    if (!data.nodal)
      return;
    Kokkos::parallel_for("abut::contact::read_points", Range(0, data.points.size()),
                         ReadPoints{search, data.points, data.terms});
    data.nodal->start(data.primary(), data.points, data.settings, data.terms.start);
    for (Local i = 0; i < data.points.size(); ++i)
      data.points.history(i).start = data.points.converged(i).start =
          data.nodal->start_at(data.primary().face(i), i);
  });
}

void end_step(InterfaceData& data) {
  for (Local i = 0; i < data.points.size(); ++i) {
    if (data.points.iterate(i).losses >= swings) { // it has gone over the rim for good
      data.points.history(i).multiplier = 0.0;
      data.points.history(i).carried = {};
    }
    if (data.nodal)
      end_point_of_nodes(data, i);
    else
      end_point(data, i);
  }
}

void keep_history(InterfaceData& data) {
  for (Local i = 0; i < data.points.size(); ++i) {
    data.points.history(i).torn = false;
    data.points.converged(i) = data.points.history(i);
  }
  if (data.nodal)
    data.nodal->accept();
}

void drop_step(InterfaceData& data) {
  Kokkos::deep_copy(data.points.history, data.points.converged);
  for (Local i = 0; i < data.points.size(); ++i) {
    data.points.iterate(i) = {};
    data.points.iterate(i).site.last.pressed = data.points.converged(i).in_contact;
  }
  if (data.nodal)
    data.nodal->reject();
}

void forget_history(InterfaceData& data) {
  for (Local i = 0; i < data.points.size(); ++i) {
    PointHistory fresh;
    fresh.path = data.points.converged(i).path;
    fresh.dissipated = data.points.converged(i).dissipated;
    data.points.history(i) = data.points.converged(i) = fresh;
    data.points.iterate(i) = {};
    data.points.state(i) = {};
  }
  data.place.primary().reset_stretch();
  data.nodal = make_nodal_space(data);
}

bool tear(InterfaceData& data) {
  Global torn = 0;
  for (Local i = 0; data.settings.sticky && data.acts && i < data.points.size(); ++i) {
    const SiteState& site = data.points.state(i).site;
    if (site.rule != PointRule::anchored || -site.pressure <= data.settings.stick_strength)
      continue;
    PointHistory& history = data.points.history(i);
    history.anchor = -1;
    history.multiplier = 0.0;
    history.carried = {};
    history.torn = true;
    ++torn;
  }
  return data.comm.sum(torn) > 0;
}

void take_iterate(InterfaceData& data, bool new_step) {
  Kokkos::parallel_for("abut::contact::take_iterate", Range(0, data.points.size()),
                       TakePoints{data.place.search(), data.points, new_step});
  if (data.terms.at_nodes)
    data.nodal->take_iterate(new_step);
}

void freeze(InterfaceData& data) {
  for (Local i = 0; i < data.points.size(); ++i) {
    leave(data.points.state(i).site, false, data.points.iterate(i).site);
    data.points.iterate(i).site.frozen = true;
  }
  if (data.nodal)
    data.nodal->freeze();
  restart_search(data);
}

void restart_search(InterfaceData& data) {
  for (Local i = 0; i < data.points.size(); ++i) {
    PointIterate& iterate = data.points.iterate(i);
    iterate.returns = iterate.losses = 0;
    iterate.left = -1;
  }
}

} // namespace abut::contact
