// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/interaction.hpp"

#include "dual_law.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

double Interaction::current_area(Local face, int point) const {
  return weight_[point_index(face, point)] *
         primary_point(shape(face, point), primary_nodes(face)).area;
}

double Interaction::measure(Local face, int point) const {
  return options_.uses_ray() ? current_area(face, point) : area_[point_index(face, point)];
}

/// Averages weighted with the corner functions, which stay positive on quadratic faces; a middle
/// node takes the functions of the corners it stands between.
NodalSums Interaction::nodal_sums() const {
  const auto n = static_cast<std::size_t>(primary_.num_nodes());
  NodalSums s;
  s.weight.assign(n, 0.0);
  s.pressure = s.gap = s.slip = s.status = s.weight;
  s.traction.assign(3 * n, 0.0);
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    const fem::FaceType type = primary_.type[f];
    const int corners = fem::face_corners(type), nodes = fem::face_nodes(type);
    for (int p = 0; p < face_points(f); ++p) {
      const PointState& state = points_[point_index(f, p)];
      const double area = current_area(f, p);
      const double cauchy = measure(f, p) / area;
      double N[fem::max_face_nodes];
      fem::dispatch_face(fem::is_triangle(type) ? fem::FaceType::tri3 : fem::FaceType::quad4,
                         [&](auto shape) {
                           decltype(shape)::values(table_[f]->rule.xi[std::size_t(p)].data(), N);
                         });
      for (int a = 0; a < nodes; ++a) {
        double share = a < corners       ? N[a]
                       : a < 2 * corners ? 0.5 * (N[a - corners] + N[(a - corners + 1) % corners])
                                         : 0.25;
        share *= area;
        const auto node = static_cast<std::size_t>(primary_.nodes[primary_.offset[f] + a]);
        s.weight[node] += share;
        const double pressure = dual_ ? node_pressure(f, a) : state.pressure;
        const Vec3 traction = dual_ ? pressure * state.normal + node_shear(f, a) : state.traction;
        s.pressure[node] += share * cauchy * pressure;
        s.gap[node] += share * state.gap;
        s.slip[node] += share * state.history.path;
        s.status[node] += share * double(state.status());
        for (int i = 0; i < 3; ++i)
          s.traction[3 * node + std::size_t(i)] += share * cauchy * traction[i];
      }
    }
  }
  return s;
}

std::vector<PointRecord> Interaction::records() const {
  std::vector<PointRecord> list;
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const PointState& state = points_[point_index(f, p)];
      const double cauchy = measure(f, p) / current_area(f, p);
      const double pressure = dual_ ? field_pressure(f, p) : state.pressure;
      const Vec3 shear = dual_ ? field_shear(f, p) : state.traction - state.pressure * state.normal;
      list.push_back({primary_.face_id[f], p,
                      origin_ + primary_point(shape(f, p), primary_nodes(f)).x, state.status(),
                      state.gap, state.history.path, cauchy * pressure, cauchy * norm(shear),
                      cauchy * (pressure * state.normal + shear), state.flips});
    }
  return list;
}

namespace {

/// Sums and extremes over the points of one rank.
struct Tally {
  enum { force, area = 3, tangential, energy, dissipation, sums };
  enum { pressure, penetration, relative, gap, slip, overlap, extremes };
  double sum[sums] = {};
  double largest[extremes] = {0.0, 0.0, 0.0, -1e300, 0.0, 0.0};
  double least_gap = 1e300;

  void raise(int which, double value) { largest[which] = std::max(largest[which], value); }
};

} // namespace

ContactSummary Interaction::summary() const {
  ContactSummary s;
  Tally tally;
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const Local i = point_index(f, p);
      const PointState& state = points_[i];
      const double weight = share_ * measure(f, p);
      ++s.points;
      s.flips += state.flips;
      tally.sum[Tally::dissipation] += state.history.dissipated;
      tally.raise(Tally::slip, state.history.path);
      tally.raise(Tally::overlap, state.overlap);
      if (state.facing < 0)
        continue;
      ++s.paired_points;
      tally.least_gap = std::min(tally.least_gap, state.gap);
      tally.raise(Tally::gap, state.gap);
      if (!state.pressed())
        continue;
      ++s.active_points;
      (state.status() == Status::stick ? s.stick_points : s.slip_points) += 1;
      for (int k = 0; k < 3; ++k)
        tally.sum[k] += weight * state.traction[k];
      tally.sum[Tally::area] += area_[i];
      const Vec3 shear = state.traction - state.pressure * state.normal;
      tally.sum[Tally::tangential] += weight * norm(shear);
      const bool augmented = options_.enforcement == Enforcement::augmented_lagrangian;
      const double normal = state.pressure - state.multiplier;
      const double square = normal * normal + (augmented ? 0.0 : dot(shear, shear));
      tally.sum[Tally::energy] += dual_                 ? 0.5 * weight * node_spring(f, p)
                                  : state.penalty > 0.0 ? 0.5 * weight * square / state.penalty
                                                        : 0.0;
      tally.raise(Tally::pressure, state.pressure * measure(f, p) / current_area(f, p));
      tally.raise(Tally::penetration, -effective_gap(state));
      tally.raise(Tally::relative, -effective_gap(state) / size_[f]);
    }
  comm_.sum(tally.sum, Tally::sums);
  for (std::size_t k = 0; k < 3; ++k)
    s.force[k] = tally.sum[k];
  s.area = tally.sum[Tally::area];
  s.tangential = tally.sum[Tally::tangential];
  s.penalty_energy = tally.sum[Tally::energy];
  s.dissipation = tally.sum[Tally::dissipation];
  for (Global* count :
       {&s.active_points, &s.stick_points, &s.slip_points, &s.flips, &s.points, &s.paired_points})
    *count = comm_.sum(*count);
  s.max_point_pressure = comm_.max(tally.largest[Tally::pressure]);
  s.max_penetration = comm_.max(tally.largest[Tally::penetration]);
  s.max_penetration_over_face_size = comm_.max(tally.largest[Tally::relative]);
  s.max_gap = comm_.max(tally.largest[Tally::gap]);
  s.max_slip = comm_.max(tally.largest[Tally::slip]);
  s.initial_overlap = comm_.max(tally.largest[Tally::overlap]);
  s.min_gap = comm_.min(tally.least_gap);
  NodalSums nodes = nodal_sums();
  corners_.sum(nodes.weight);
  corners_.sum(nodes.pressure);
  for (std::size_t n = 0; n < nodes.weight.size(); ++n)
    if (nodes.weight[n] > 0.0)
      s.max_pressure = std::max(s.max_pressure, nodes.pressure[n] / nodes.weight[n]);
  s.max_pressure = comm_.max(s.max_pressure);
  return s;
}

std::vector<ClosedPoint> Interaction::closed_points() const {
  std::vector<ClosedPoint> result;
  for (const Pair& pair : pair_list_) {
    Global nodes[fem::max_face_nodes];
    facing_.global_nodes(pair.facing, nodes);
    for (Local p : pair.points) {
      const PointState& state = points_[point_index(pair.face, p)];
      const Vec3 x = primary_point(shape(pair.face, p), primary_nodes(pair.face)).x;
      const bool holds = state.rule == PointRule::anchored ||
                         state.rule == PointRule::incremental_stick || friction_ > 0.0;
      const Local node = primary_.nodes[primary_.offset[pair.face]];
      result.push_back({node, nodes[0], origin_ + x, state.normal});
      if (!holds)
        continue;
      const Vec3& n = state.normal;
      const int i = std::fabs(n[0]) < 0.6 ? 0 : std::fabs(n[1]) < 0.6 ? 1 : 2;
      Vec3 axis = Vec3::zero();
      axis[i] = 1.0;
      const Vec3 side = cross(n, axis);
      result.push_back({node, nodes[0], origin_ + x, (1.0 / norm(side)) * side});
      result.push_back({node, nodes[0], origin_ + x, (1.0 / norm(side)) * cross(n, side)});
    }
  }
  return result;
}

} // namespace abut::contact
