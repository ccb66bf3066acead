// SPDX-License-Identifier: BSD-3-Clause
#include "multipliers/sites.hpp"

#include <cmath>

namespace abut::contact {

Vec3 tied_rest(const InterfaceData& data, Local point, const PrimaryPoint<double>& at) {
  return -data.points.state(point).penalty * turned_traction(data.points.history(point).rest, at);
}

Global Sites::key(Local i) const {
  if (data_.nodal)
    return data_.surface().node[i] + 1;
  return data_.point_key(i) + 1;
}

bool Sites::held(Local i) const {
  if (data_.held.empty())
    return false;
  if (data_.nodal)
    return data_.held[std::size_t(i)] != 0;
  const Local face = data_.primary().face(i);
  int held = 0;
  for (int a = 0; a < data_.corners.corners(face); ++a)
    held += data_.held[std::size_t(data_.corners.nodes(face)[a])] != 0;
  return 2 * held >= data_.corners.corners(face);
}

bool Sites::partly_covered(Local i) const {
  if (data_.nodal) {
    const NodeState& n = data_.nodal->arrays().state(i);
    const double full = data_.nodal->arrays().full(i);
    return std::max(std::fabs(n.area - full), std::fabs(n.covered - full)) > round_off * full;
  }
  const PrimaryView& p = data_.primary();
  const Local face = p.face(i);
  for (Local q = p.first_point(face); q < p.first_point(face + 1); ++q)
    if (data_.points.state(q).facing < 0)
      return true;
  return false;
}

Site Sites::point(Local i) const {
  const PointState& s = data_.points.state(i);
  const PointHistory& history = data_.points.history(i);
  const auto at = data_.primary().at(i);
  Site site;
  site.area = data_.primary().area(i);
  site.size = data_.primary().size(data_.primary().face(i));
  site.gap = s.facing >= 0 ? data_.points.net_gap(i) : s.gap;
  site.penalty = s.penalty;
  site.multiplier = history.multiplier;
  site.carried = turned_traction(history.carried, at);
  const Vec3 rest = tied_rest(data_, i, at);
  site.spring = s.site.shear - site.carried + rest - dot(at.normal, rest) * at.normal;
  site.normal = s.normal;
  site.was_in_contact = data_.points.converged(i).in_contact;
  site.anchored = data_.settings.anchors() && s.anchor >= 0;
  site.state = s.site;
  return site;
}

Site Sites::node(Local i) const {
  const NodeState& n = data_.nodal->arrays().state(i);
  Site site;
  site.area = data_.nodal->counts(i) ? n.area : 0.0;
  site.size = n.reading.size;
  site.gap = n.reading.gap;
  site.penalty = n.reading.penalty;
  site.multiplier = data_.nodal->arrays().history(i).multiplier;
  site.carried = n.reading.carried - dot(n.reading.normal, n.reading.carried) * n.reading.normal;
  site.spring = n.site.shear - site.carried;
  site.normal = n.reading.normal;
  site.was_in_contact = data_.nodal->arrays().converged(i).in_contact;
  site.state = n.site;
  return site;
}

} // namespace abut::contact
