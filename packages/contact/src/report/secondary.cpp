// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/face_map.hpp"
#include "abut/fem/quadrature.hpp"
#include "report/report.hpp"

#include <algorithm>

namespace abut::contact {

namespace {

enum Column { seen, gap, slip, pressed, status, pressure, traction, columns = traction + 3 };

/// The place of a partner without the margin beside the face, so that no share is negative.
void clamp(fem::FaceType type, const double xi[2], double* inside) {
  if (!fem::is_triangle(type)) {
    for (int k = 0; k < 2; ++k)
      inside[k] = std::clamp(xi[k], -1.0, 1.0);
    return;
  }
  for (int k = 0; k < 2; ++k)
    inside[k] = std::max(xi[k], 0.0);
  const double scale = std::max(1.0, inside[0] + inside[1]);
  for (int k = 0; k < 2; ++k)
    inside[k] /= scale;
}

double pressure_at(const InterfaceData& data, Local i) {
  return data.nodal ? data.nodal->interpolate(data.primary().face(i), i,
                                              [](const NodeState& n) { return n.site.pressure; })
                    : data.points.state(i).site.pressure;
}

/// What a point adds, in equal measure, to the columns of the nodes of the face that it meets.
void put_columns(const InterfaceData& data, Local i, double* value) {
  const PointState& state = data.points.state(i);
  const double area = data.primary().current_area(i), measure = data.measure(i);
  value[seen] = area;
  value[gap] = area * state.gap;
  value[slip] = area * data.points.history(i).path;
  value[pressed] = state.site.pressed() ? area : 0.0;
  value[status] = area * double(state.site.status());
  value[pressure] = measure * pressure_at(data, i);
  for (int k = 0; k < 3; ++k)
    value[traction + k] = -measure * state.traction[k];
}

/// (collected nodes, columns)
std::vector<double> sums_of_points(const InterfaceData& data) {
  const FacingView& facing = data.facing();
  std::vector<double> sums(facing.node.extent(0) * columns, 0.0);
  for (Local i = 0; i < data.points.size(); ++i) {
    const Local face = data.points.state(i).facing;
    if (face < 0)
      continue;
    double value[columns], xi[2], N[max_corners];
    put_columns(data, i, value);
    clamp(facing.type(face), data.points.state(i).xi, xi);
    corner_values(facing.type(face), xi, N);
    for (int a = 0; a < facing.nodes(face); ++a) {
      const double share = corner_share(N, fem::face_corners(facing.type(face)), a);
      double* sum = &sums[std::size_t(facing.face_node(facing.offset(face) + a)) * columns];
      for (int c = 0; c < columns; ++c)
        sum[c] += share * value[c];
    }
  }
  return sums;
}

/// Adds the present area of the face in each of its nodes.
void add_areas(const InterfaceData& data, Local face, NodalSums& s) {
  const mesh::Surface& surface = data.place.secondary();
  const fem::FaceType type = surface.type[face];
  const int nodes = fem::face_nodes(type), corners = fem::face_corners(type);
  const fem::Rule<2> rule = fem::face_rule(type, nodes == corners ? 2 : 3);
  Vec3 y[fem::max_face_nodes];
  for (int a = 0; a < nodes; ++a)
    y[a] = data.place.secondary_position(face, a);
  for (int q = 0; q < rule.size(); ++q) {
    fem::FacePoint<double> p;
    double N[max_corners];
    fem::face_point(type, y, rule.xi[q].data(), p);
    corner_values(type, rule.xi[q].data(), N);
    const double area = rule.weight[q] * norm(cross(p.tangent[0], p.tangent[1]));
    for (int a = 0; a < nodes; ++a) {
      const double part = area * corner_share(N, corners, a);
      const auto place = static_cast<std::size_t>(surface.offset[face] + a);
      s.area[place] += part;
      s.weight[std::size_t(surface.nodes[place])] += part;
    }
  }
}

} // namespace

NodalSums secondary_sums(const InterfaceData& data) {
  const mesh::Surface& surface = data.place.secondary();
  const std::vector<double> sums =
      data.place.facing_surface().give_back(sums_of_points(data), columns);
  NodalSums s(surface, data.terms.share);
  for (Local face = 0; face < surface.num_faces(); ++face)
    add_areas(data, face, s);
  for (std::size_t n = 0; n < surface.node.size(); ++n) {
    const double* sum = &sums[n * columns];
    s.seen[n] = sum[seen];
    s.gap[n] = sum[gap];
    s.slip[n] = sum[slip];
    s.pressed[n] = sum[pressed];
    s.status[n] = sum[status];
    s.pressure[n] = sum[pressure];
    std::copy_n(sum + traction, 3, &s.traction[3 * n]);
  }
  return s;
}

} // namespace abut::contact
