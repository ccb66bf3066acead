// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/facet_gap.hpp"
#include "abut/search/closest_point.hpp"
#include "abut/search/ray.hpp"
#include "kinematics/facing_surface.hpp"
#include "kinematics/primary_surface.hpp"
#include "kinematics/through_body.hpp"
#include "law/constants.hpp"

/// Which secondary face is the partner of a point: the nearest one that the point projects on, or
/// that a ray meets. Device code.
namespace abut::contact {

/// What a point looks for: its closest point, or where a line meets the secondary surface.
struct Query {
  Local point = -1;
  Local face = -1;             ///< primary face of the point
  Vec3 x, normal;              ///< of the primary at the point
  Vec3 x_previous;             ///< at the last converged step
  bool was_in_contact = false; ///< then: it has come in by the side that it meets
  bool line = false;
  Vec3 origin, direction; ///< of the line
  double reach = 0.0;     ///< of the point; a large secondary face may reach further [length]
  Local last = -1;        ///< where the search starts, -1: nowhere
  double last_xi[2] = {0.0, 0.0};
  double hold = 0.0; ///< margin within which the last partner is kept; 0: it is not
};

struct Partner {
  Local face = -1;
  double distance = 0.0, gap = 0.0, xi[2] = {0.0, 0.0};
  Vec3 normal{{0, 0, 0}}; ///< of the face
};

/// The search of one interface in one configuration. Copied by value.
struct PartnerSearch {
  PrimaryView primary;
  FacingView facing;
  bool self = false;   ///< primary and secondary are one surface
  bool line = false;   ///< rays along the primary normal
  double reach = 0.0;  ///< in sizes of the larger face [1]
  double margin = 0.0; ///< how far outside a face a projection still counts [1]
  double motion = 0.0; ///< of points that may have passed through a face since the last step; 0:
                       ///< within the reach [length]

  /// Whether two faces of one surface share a node.
  KOKKOS_INLINE_FUNCTION bool own_neighbour(Local face, Local candidate) const {
    if (!self)
      return false;
    for (Local a = primary.first_node(face); a < primary.first_node(face + 1); ++a)
      if (facing.has_node(candidate, primary.global_node(a)))
        return true;
    return false;
  }

  /// The formulation's own query of a point, starting from a face.
  KOKKOS_INLINE_FUNCTION Query query(Local point, const PrimaryPoint<double>& at, Local last,
                                     const double* last_xi) const {
    Query q;
    q.point = point;
    q.face = primary.face(point);
    q.x = q.origin = at.x;
    q.normal = at.normal;
    q.direction = -at.normal;
    q.line = line;
    q.x_previous = primary_point(primary.shape(point), primary.before(q.face)).x;
    q.reach = reach * primary.size(q.face);
    q.last = last;
    q.last_xi[0] = last_xi[0];
    q.last_xi[1] = last_xi[1];
    return q;
  }

  /// Normals jump from face to face, so that a balance right at an edge would be missed from both
  /// sides: a point that swings between two faces is held on one.
  KOKKOS_INLINE_FUNCTION Partner find(const Query& q) const {
    double limit = fmax(q.reach, fmax(reach * facing.largest_size, motion));
    if (q.line)
      limit += norm(q.origin - q.x);
    Partner inner, beside;
    if (q.last >= 0)
      visit(q, q.last, limit, inner, beside); // most likely still the nearest: bounds the search
    const bool is_held = q.hold > 0.0 && inner.face == q.last;
    const double line_reach = 2.0 * limit / (q.line ? norm(q.direction) : 1.0);
    if (!is_held)
      facing.tree.traverse(
          [&](const search::Box<3>& box) {
            return q.line ? box.meets_line(q.origin.v, q.direction.v, line_reach)
                          : box.distance2(q.x.v) <= limit * limit;
          },
          [&](Local candidate) {
            if (candidate != q.last)
              visit(q, candidate, limit, inner, beside);
          });
    const bool prefer_inner =
        inner.face >= 0 &&
        (beside.face < 0 ||
         inner.distance <= 2.0 * beside.distance + as_near * primary.size(q.face));
    return prefer_inner ? inner : beside;
  }

  /// Whether the point lies close above or below the surface that goes on from its last face, but
  /// past an edge where the surface ends.
  KOKKOS_INLINE_FUNCTION bool past_rim(Local last, const double* last_xi, const Vec3& x) const {
    const fem::FaceType type = facing.type(last);
    Vec3 y[fem::max_face_nodes];
    facing.coordinates(last, y);
    const auto found = search::project(type, y, x, last_xi);
    if (!found.converged ||
        std::fabs(facet_gap<double>(type, y, x, found.xi).gap) > rim_depth * facing.size(last))
      return false;
    for (int e = 0; e < fem::face_corners(type); ++e)
      if (beyond_edge(type, found.xi, e) && on_rim(last, e))
        return true;
    return false;
  }

private:
  /// Projection of the query's point on a face, or the hit of its line.
  KOKKOS_INLINE_FUNCTION static search::Projection meet_face(const Query& q, fem::FaceType type,
                                                             const Vec3* y, const double start[2]) {
    if (!q.line)
      return search::project(type, y, q.x, start);
    const search::RayHit hit = search::intersect(type, y, q.origin, q.direction, start);
    return {{hit.xi[0], hit.xi[1]}, hit.converged};
  }

  KOKKOS_INLINE_FUNCTION static bool within(fem::FaceType type, const double* xi, double margin) {
    const double unit = fem::is_triangle(type) ? 1.0 : 2.0; // length of a side in parameters
    return fem::dispatch_face(type, [&](auto s) { return decltype(s)::inside(xi, margin * unit); });
  }

  /// Whether the point has passed through the face since the last converged step: a fast point must
  /// not leave its partner behind by more than the reach and go free.
  KOKKOS_INLINE_FUNCTION bool crossed(const Query& q, Local candidate, const double xi[2],
                                      double gap) const {
    if (gap >= 0.0 || motion == 0.0)
      return false;
    Vec3 y[fem::max_face_nodes];
    facing.previous_coordinates(candidate, y);
    fem::FacePoint<double> then;
    fem::face_point(facing.type(candidate), y, xi, then);
    return dot(cross(then.tangent[0], then.tangent[1]), q.x_previous - then.x) >= 0.0;
  }

  /// Whether what the point sees of the face, this deep behind it, is its back.
  KOKKOS_INLINE_FUNCTION bool through_body(const Query& q, Local candidate, const double xi[2],
                                           double depth) const {
    const BodySight sight{primary, facing, q.point, candidate, xi};
    return (!q.was_in_contact && sight.beyond_middle(depth, q.x_previous)) ||
           (self && sight.through_own(depth));
  }

  /// Whether a face is a partner at a projection at all; its gap along the query's measure and its
  /// normal.
  KOKKOS_INLINE_FUNCTION bool faces(const Query& q, Local candidate, const Vec3* y,
                                    const double xi[2], double& gap, Vec3& normal) const {
    const auto at = facet_gap<double>(facing.type(candidate), y, q.x, xi);
    gap = at.gap;
    normal = at.normal;
    if (q.line) {
      Vec3 hit = Vec3::zero();
      for (int b = 0; b < facing.nodes(candidate); ++b)
        hit += at.N[b] * y[b];
      gap = dot(q.normal, hit - q.x);
    }
    if (dot(at.normal, q.normal) > outward_share ||
        (q.line && std::fabs(dot(at.normal, q.direction)) < lock_share * norm(q.direction)))
      return false;
    if (std::fabs(gap) > fmax(q.reach, reach * facing.size(candidate)) &&
        !crossed(q, candidate, xi, gap))
      return false;
    return gap >= 0.0 || !through_body(q, candidate, xi, -gap);
  }

  /// A projection within the margin beside a face (the point lies above a concave edge, or just off
  /// the rim) counts only when no face with a projection inside is about as near.
  KOKKOS_INLINE_FUNCTION void visit(const Query& q, Local candidate, double& limit, Partner& inner,
                                    Partner& beside) const {
    if (own_neighbour(q.face, candidate))
      return;
    const fem::FaceType type = facing.type(candidate);
    Vec3 y[fem::max_face_nodes];
    facing.coordinates(candidate, y);
    double start[2];
    fem::dispatch_face(type, [&](auto s) { decltype(s)::center(start); });
    if (candidate == q.last)
      start[0] = q.last_xi[0], start[1] = q.last_xi[1];
    const auto found = meet_face(q, type, y, start);
    const bool hold = q.hold > 0.0 && candidate == q.last;
    double gap = 0.0;
    Vec3 normal;
    if (!found.converged || !within(type, found.xi, hold ? q.hold : margin) ||
        !faces(q, candidate, y, found.xi, gap, normal))
      return;
    const double distance = std::fabs(gap);
    const bool is_inner = hold || within(type, found.xi, round_off);
    Partner& partner = is_inner ? inner : beside;
    const bool tie = partner.face >= 0 &&
                     std::fabs(distance - partner.distance) <= round_off * primary.size(q.face);
    if (tie ? facing.goes_before(candidate, partner.face)
            : partner.face < 0 || distance < partner.distance)
      partner = {candidate, distance, gap, {found.xi[0], found.xi[1]}, normal};
    if (is_inner)
      limit = fmin(limit, fmax(distance, q.line ? norm(q.origin - q.x) : 0.0));
  }

  /// Whether xi lies beyond the edge from corner e to the next.
  KOKKOS_INLINE_FUNCTION static bool beyond_edge(fem::FaceType type, const double* xi, int e) {
    if (fem::is_triangle(type)) {
      const double inside[] = {xi[1], 1.0 - xi[0] - xi[1], xi[0]};
      return inside[e] < 0.0;
    }
    const double out[] = {-xi[1], xi[0], xi[1], -xi[0]};
    return out[e] > 1.0;
  }

  /// Whether no other secondary face has the edge from corner e of a face to the next.
  KOKKOS_INLINE_FUNCTION bool on_rim(Local face, int e) const {
    const int next = (e + 1) % fem::face_corners(facing.type(face));
    Vec3 y[fem::max_face_nodes];
    facing.coordinates(face, y);
    const Vec3 middle = 0.5 * (y[e] + y[next]);
    const double length = norm(y[next] - y[e]);
    const Global from = facing.mesh_node(face, e), to = facing.mesh_node(face, next);
    bool shared = false;
    facing.tree.traverse(
        [&](const search::Box<3>& box) { return box.distance2(middle.v) <= length * length; },
        [&](Local other) {
          shared = shared ||
                   (other != face && facing.has_node(other, from) && facing.has_node(other, to));
        });
    return !shared;
  }
};

} // namespace abut::contact
