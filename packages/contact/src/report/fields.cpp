// SPDX-License-Identifier: BSD-3-Clause
#include "report/report.hpp"

#include <cmath>

namespace abut::contact {

namespace {

double pressure_of(const NodeState& n) {
  return n.site.pressure;
}
Vec3 shear_of(const NodeState& n) {
  return n.site.shear;
}

} // namespace

NodalSums primary_sums(const InterfaceData& data) {
  const PrimaryView& primary = data.primary();
  NodalSums s(data.surface(), data.terms.share);
  for (Local p = 0; p < primary.points(); ++p) {
    const PointState& state = data.points.state(p);
    const Local f = primary.face(p);
    const double area = primary.current_area(p), cauchy = data.measure(p) / area;
    double N[max_corners];
    data.corners.values(f, primary.xi(p), N);
    for (int a = 0; a < primary.nodes(f); ++a) {
      const double share = area * corner_share(N, data.corners.corners(f), a);
      const auto place = static_cast<std::size_t>(primary.first_node(f) + a);
      const auto node = static_cast<std::size_t>(primary.node(primary.first_node(f) + a));
      double pressure = state.site.pressure;
      Vec3 traction = state.traction;
      if (data.nodal) {
        pressure = data.nodal->face_value(f, a, pressure_of);
        traction = pressure * state.normal + data.nodal->face_value(f, a, shear_of);
      }
      s.area[place] += share;
      s.weight[node] += share;
      s.seen[node] += data.acts ? share : 0.0;
      s.pressure[node] += share * cauchy * pressure;
      s.gap[node] += share * state.gap;
      s.slip[node] += share * data.points.history(p).path;
      s.pressed[node] += state.site.pressed() ? share : 0.0;
      s.status[node] += share * double(state.site.status());
      for (int i = 0; i < 3; ++i)
        s.traction[3 * node + std::size_t(i)] += share * cauchy * traction[i];
    }
  }
  return s;
}

std::vector<PointRecord> records(const InterfaceData& data) {
  const PrimaryView& primary = data.primary();
  std::vector<PointRecord> list;
  for (Local p = 0; p < primary.points(); ++p) {
    const PointState& state = data.points.state(p);
    const Local f = primary.face(p);
    const double cauchy = data.measure(p) / primary.current_area(p);
    double pressure = state.site.pressure;
    Vec3 shear = state.site.shear;
    if (data.nodal) {
      pressure = data.nodal->interpolate(f, p, pressure_of);
      shear = data.nodal->interpolate(f, p, shear_of);
    }
    list.push_back({data.surface().face_id[f], p - primary.first_point(f),
                    data.place.origin() + primary.at(p).x, state.site.status(), state.gap,
                    data.points.history(p).path, cauchy * pressure, cauchy * norm(shear),
                    cauchy * (pressure * state.normal + shear), data.points.iterate(p).site.flips,
                    state.facing >= 0});
  }
  return list;
}

std::vector<ClosedPoint> closed_points(const InterfaceData& data, const PairArrays& pairs) {
  const PrimaryView& primary = data.primary();
  std::vector<ClosedPoint> result;
  for (Local i = 0; i < pairs.size(); ++i)
    for (Local k = pairs.first_point(i); k < pairs.first_point(i + 1); ++k) {
      const Local p = pairs.point(k);
      const PointState& state = data.points.state(p);
      const Vec3 x = data.place.origin() + primary.at(p).x;
      const Local node = primary.node(primary.first_node(pairs.face(i)));
      const Global other = data.facing().mesh_node(pairs.facing(i), 0);
      const Vec3& n = state.normal;
      result.push_back({node, other, x, n});
      if (!state.site.sticks() && data.terms.law.friction == 0.0)
        continue;
      const int j = std::fabs(n[0]) < 0.6 ? 0 : std::fabs(n[1]) < 0.6 ? 1 : 2;
      Vec3 axis = Vec3::zero();
      axis[j] = 1.0;
      const Vec3 side = cross(n, axis);
      result.push_back({node, other, x, (1.0 / norm(side)) * side});
      result.push_back({node, other, x, (1.0 / norm(side)) * cross(n, side)});
    }
  return result;
}

} // namespace abut::contact
