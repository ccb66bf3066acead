// SPDX-License-Identifier: BSD-3-Clause
#include "report/report.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

/// Sums and extremes over the points of one rank.
struct Tally {
  enum { force, moment = 3, area = 6, current, sunk, seen, open, integrals };
  enum { normal = integrals, tangential, energy, softness, dissipation, sums };
  enum { pressure, penetration, relative, gap, slip, overlap, rise, shift, nearness, extremes };
  enum { points, paired, active, stick, slipping, flips, shifted, counts };
  double sum[sums] = {};
  double largest[extremes] = {0.0, 0.0, 0.0, -1e300, 0.0, 0.0, 0.0, 0.0, -1e300};
  double count[counts] = {};

  void raise(int which, double value) { largest[which] = std::max(largest[which], value); }
};

/// Per area at a point.
struct Springs {
  double energy = 0.0;   ///< twice that in them
  double softness = 0.0; ///< twice the work of the whole traction over their stretch
};

/// push: of the normal spring alone; pressure: that and the multiplier. A point that slides has the
/// shear of its pressure, whatever the spring.
Springs springs(double penalty, double push, double pressure, const SiteState& site,
                bool augmented) {
  const double shear2 = augmented ? 0.0 : dot(site.shear, site.shear);
  return {(push * push + shear2) / penalty,
          (pressure * push + (site.sticks() ? shear2 : 0.0)) / penalty};
}

/// The springs of the nodes.
Springs node_springs(const InterfaceData& data, Local i) {
  const NodalArrays& nodes = data.nodal->arrays();
  const Local face = data.primary().face(i);
  Springs sum;
  for (int a = 0; a < nodes.corners(face); ++a) {
    const NodeState& n = nodes.state(nodes.node(face, a));
    if (!n.site.active() || !(n.reading.penalty > 0.0))
      continue;
    const Springs s = springs(n.reading.penalty, -n.reading.penalty * n.reading.gap,
                              n.site.pressure, n.site, data.settings.augmented());
    sum.energy += nodes.field_at(i, a) * s.energy;
    sum.softness += nodes.field_at(i, a) * s.softness;
  }
  return sum;
}

/// The same of a point that holds the law itself.
Springs point_springs(const InterfaceData& data, const PointState& s) {
  if (!(s.penalty > 0.0))
    return {};
  return springs(s.penalty, s.site.pressure - s.multiplier, s.site.pressure, s.site,
                 data.settings.augmented());
}

void add_pressed(const InterfaceData& data, Local i, Tally& t) {
  const PointState& s = data.points.state(i);
  const double measure = data.measure(i), weight = data.terms.share * measure;
  t.count[Tally::active] += 1.0;
  t.count[s.site.status() == Status::stick ? Tally::stick : Tally::slipping] += 1.0;
  const Vec3 force = weight * s.traction;
  const Vec3 moment = cross(data.place.origin() + data.primary().at(i).x, force);
  for (int k = 0; k < 3; ++k) {
    t.sum[Tally::force + k] += force[k];
    t.sum[Tally::moment + k] += moment[k];
  }
  const double current = data.primary().current_area(i);
  t.sum[Tally::area] += data.primary().area(i);
  t.sum[Tally::current] += current;
  t.sum[Tally::tangential] += weight * norm(s.site.shear);
  t.sum[Tally::normal] += weight * s.site.pressure;
  const Springs stretched = data.nodal ? node_springs(data, i) : point_springs(data, s);
  t.sum[Tally::energy] += 0.5 * weight * stretched.energy;
  if (data.settings.modulus > 0.0)
    t.sum[Tally::softness] += 0.5 * weight * stretched.softness;
  t.raise(Tally::pressure, s.site.pressure * measure / current);
  const double penetration = -data.points.net_gap(i);
  t.sum[Tally::sunk] += current * penetration;
  t.raise(Tally::penetration, penetration);
  t.raise(Tally::relative, penetration / data.primary().size(data.primary().face(i)));
}

void add_start(const InterfaceData& data, Local i, Tally& t) {
  const SiteStart& start = data.points.history(i).start;
  const double shift = std::fabs(data.settings.shift_of(start));
  const double none = touching_gap * data.primary().size(data.primary().face(i));
  t.count[Tally::shifted] += start.fit > 0.0 || shift > none ? 1.0 : 0.0;
  t.raise(Tally::shift, shift);
  t.raise(Tally::overlap, start.overlap);
}

Tally tally(const InterfaceData& data) {
  Tally t;
  for (Local i = 0; i < data.points.size(); ++i) {
    const PointState& s = data.points.state(i);
    const PointHistory& history = data.points.history(i);
    t.count[Tally::points] += 1.0;
    t.count[Tally::flips] += data.points.iterate(i).site.flips;
    t.sum[Tally::dissipation] += history.dissipated;
    t.raise(Tally::slip, history.path);
    add_start(data, i, t);
    if (s.facing < 0)
      continue;
    t.raise(Tally::rise, std::fabs(history.rise));
    t.count[Tally::paired] += 1.0;
    t.raise(Tally::nearness, -s.gap);
    t.raise(Tally::gap, s.gap);
    t.sum[Tally::seen] += data.primary().current_area(i);
    t.sum[Tally::open] += data.primary().current_area(i) * s.gap;
    if (s.site.pressed())
      add_pressed(data, i, t);
  }
  data.comm.sum(t.sum, Tally::sums);
  data.comm.sum(t.count, Tally::counts);
  return t;
}

/// In self-contact a node is pressed by the points around it and by those that meet its faces.
double largest_nodal_pressure(const InterfaceData& data) {
  NodalSums nodes = primary_sums(data);
  if (data.place.self_contact()) {
    const NodalSums met = secondary_sums(data);
    for (std::size_t n = 0; n < met.pressure.size(); ++n)
      nodes.pressure[n] += met.pressure[n];
  }
  data.corners.sum(nodes.weight);
  data.corners.sum(nodes.pressure);
  double most = 0.0;
  for (std::size_t n = 0; n < nodes.weight.size(); ++n)
    if (nodes.weight[n] > 0.0)
      most = std::max(most, nodes.pressure[n] / nodes.weight[n]);
  return most;
}

} // namespace

ContactSummary summarize(const InterfaceData& data) {
  const Tally t = tally(data);
  double largest[Tally::extremes + 1];
  std::copy_n(t.largest, int(Tally::extremes), largest);
  largest[Tally::extremes] = largest_nodal_pressure(data);
  data.comm.max(largest, Tally::extremes + 1);
  ContactSummary s;
  std::copy_n(t.sum + Tally::force, 3, s.force.begin());
  std::copy_n(t.sum + Tally::moment, 3, s.moment.begin());
  s.area = t.sum[Tally::area];
  s.current_area = t.sum[Tally::current];
  s.mean_penetration = s.current_area > 0.0 ? t.sum[Tally::sunk] / s.current_area : 0.0;
  s.mean_gap = t.sum[Tally::seen] > 0.0 ? t.sum[Tally::open] / t.sum[Tally::seen] : 0.0;
  s.tangential = t.sum[Tally::tangential];
  s.penalty_energy = t.sum[Tally::energy];
  s.normal = t.sum[Tally::normal];
  s.softness = t.sum[Tally::softness];
  s.dissipation = t.sum[Tally::dissipation];
  if (data.settings.penalty_source != PenaltySource::given)
    s.penalty_factor = data.factor;
  const auto count = [&](int which) { return static_cast<Global>(t.count[which]); };
  s.points = count(Tally::points);
  s.paired_points = count(Tally::paired);
  s.active_points = count(Tally::active);
  s.stick_points = count(Tally::stick);
  s.slip_points = count(Tally::slipping);
  s.flips = count(Tally::flips);
  s.max_point_pressure = largest[Tally::pressure];
  s.max_penetration = largest[Tally::penetration];
  s.max_penetration_over_face_size = largest[Tally::relative];
  s.max_gap = largest[Tally::gap];
  s.min_gap = -largest[Tally::nearness];
  s.max_slip = largest[Tally::slip];
  s.initial_overlap = largest[Tally::overlap];
  s.shifted_points = count(Tally::shifted);
  s.max_shift = largest[Tally::shift];
  s.facet_rise = largest[Tally::rise];
  s.max_pressure = largest[Tally::extremes];
  return s;
}

} // namespace abut::contact
