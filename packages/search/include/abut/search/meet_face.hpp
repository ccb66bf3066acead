// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/search/closest_point.hpp"
#include "abut/search/edge_point.hpp"
#include "abut/search/ray.hpp"
#include "abut/search/straight_face.hpp"

/// One face against one point or line, edges and corners included.
namespace abut::search {

/// A point of a face.
struct FaceMeeting {
  double xi[2] = {0.0, 0.0};
  double distance = 1e300; ///< of a point: >= 0; of a line: along it, negative behind [length]
  bool found = false;
};

/// How far outside its parameters a face still counts as met: rounding of a point on its edge.
constexpr double edge_margin = 1e-8;

KOKKOS_INLINE_FUNCTION Vec3 place_on_face(fem::FaceType type, const Vec3* y, const double xi[2]) {
  double N[fem::max_face_nodes];
  fem::dispatch_face(type, [&](auto face) { decltype(face)::values(xi, N); });
  Vec3 x = Vec3::zero();
  for (int a = 0; a < fem::face_nodes(type); ++a)
    x += N[a] * y[a];
  return x;
}

KOKKOS_INLINE_FUNCTION bool is_inside(fem::FaceType type, const double xi[2]) {
  return fem::dispatch_face(type,
                            [&](auto face) { return decltype(face)::inside(xi, edge_margin); });
}

/// Parameters of node a of a face.
KOKKOS_INLINE_FUNCTION void node_parameters(fem::FaceType type, int a, double xi[2]) {
  fem::dispatch_face(type, [&](auto face) { decltype(face)::node(a, xi); });
}

/// A point of the boundary of a face.
struct BoundaryPoint {
  FaceMeeting meeting;
  int edge = -1;   ///< from this corner to the next
  int corner = -1; ///< where it lies on one
};

/// The point of the boundary of the face with nodes y that is closest to x.
KOKKOS_INLINE_FUNCTION BoundaryPoint closest_boundary_point(fem::FaceType type, const Vec3* y,
                                                            const Vec3& x) {
  const int corners = fem::face_corners(type);
  BoundaryPoint best;
  for (int e = 0; e < corners; ++e) {
    const int next = (e + 1) % corners;
    const bool curved = fem::face_nodes(type) > corners;
    const Vec3 middle = curved ? y[corners + e] : 0.5 * (y[e] + y[next]);
    const double t = closest_on_edge(y[e], middle, y[next], x);
    double from[2], to[2], xi[2];
    node_parameters(type, e, from);
    node_parameters(type, next, to);
    for (int i = 0; i < 2; ++i)
      xi[i] = 0.5 * ((1.0 - t) * from[i] + (1.0 + t) * to[i]);
    const double distance = norm(place_on_face(type, y, xi) - x);
    if (distance < best.meeting.distance)
      best = {{{xi[0], xi[1]}, distance, true}, e, t == -1.0 ? e : t == 1.0 ? next : -1};
  }
  return best;
}

KOKKOS_INLINE_FUNCTION FaceMeeting closest_on_boundary(fem::FaceType type, const Vec3* y,
                                                       const Vec3& x) {
  return closest_boundary_point(type, y, x).meeting;
}

/// Where there can be but one: the closest point of the face, if it lies within.
KOKKOS_INLINE_FUNCTION FaceMeeting only_closest_within(fem::FaceType type, const StraightFace& face,
                                                       const Vec3& x) {
  double start[2];
  fem::dispatch_face(type, [&](auto shape) { decltype(shape)::center(start); });
  const Projection p = project_on(face, x, start);
  if (!p.converged || !is_inside(type, p.xi))
    return {};
  return {{p.xi[0], p.xi[1]}, norm(face.place(p.xi) - x), true};
}

/// The point of the face with nodes y that is closest to x. Within the face Newton's method starts
/// from the middle and from the closest point of the boundary; on a face so curved that there are
/// more minima within, another may be closer.
KOKKOS_INLINE_FUNCTION FaceMeeting closest_on_face(fem::FaceType type, const Vec3* y,
                                                   const Vec3& x) {
  if (is_straight(type)) {
    const StraightFace face(type, y);
    if (face.has_one_closest_point(x)) {
      const FaceMeeting within = only_closest_within(type, face, x);
      return within.found ? within : closest_on_boundary(type, y, x);
    }
  }
  FaceMeeting best = closest_on_boundary(type, y, x);
  double starts[2][2] = {{0.0, 0.0}, {best.xi[0], best.xi[1]}};
  fem::dispatch_face(type, [&](auto face) { decltype(face)::center(starts[0]); });
  for (const auto& start : starts) {
    const Projection p = project(type, y, x, start);
    if (!p.converged || !is_inside(type, p.xi))
      continue;
    const double distance = norm(place_on_face(type, y, p.xi) - x);
    if (distance < best.distance)
      best = {{p.xi[0], p.xi[1]}, distance, true};
  }
  return best;
}

/// The hit nearest to the origin of a line of unit direction with the face, at most `reach` away,
/// ahead or behind. Starts at the middle and, where the face may be hit twice, at the corners.
KOKKOS_INLINE_FUNCTION FaceMeeting hit_on_face(fem::FaceType type, const Vec3* y,
                                               const Vec3& origin, const Vec3& direction,
                                               double reach) {
  FaceMeeting best;
  const bool straight = is_straight(type);
  const Sight sight = straight ? sight_of(type, y, origin, direction) : Sight::unclear;
  if (sight == Sight::beside)
    return best;
  const int corners = type == fem::FaceType::tri3 ? 0 : fem::face_corners(type);
  for (int start = -1; start < corners; ++start) {
    double xi[2];
    if (start < 0)
      fem::dispatch_face(type, [&](auto face) { decltype(face)::center(xi); });
    else
      node_parameters(type, start, xi);
    const RayHit hit = straight ? intersect_with(StraightFace(type, y), origin, direction, xi)
                                : intersect(type, y, origin, direction, xi);
    if (!hit.converged || !is_inside(type, hit.xi))
      continue;
    if (std::fabs(hit.distance) <= reach && std::fabs(hit.distance) < std::fabs(best.distance))
      best = {{hit.xi[0], hit.xi[1]}, hit.distance, true};
    if (sight == Sight::once)
      break;
  }
  return best;
}

} // namespace abut::search
