// SPDX-License-Identifier: BSD-3-Clause
// Partners of points: the nearest facing face that a point projects on, or that a ray meets.
#include "point_search.hpp"

#include "abut/contact/facet_gap.hpp"
#include "abut/search/closest_point.hpp"
#include "abut/search/ray.hpp"
#include "constants.hpp"

#include <algorithm>

namespace abut::contact {

using search::Box;

bool Interaction::own_neighbour(Local face, Local candidate) const {
  if (!self_)
    return false;
  Global nodes[fem::max_face_nodes];
  facing_.global_nodes(candidate, nodes);
  for (Local a = primary_.offset[face]; a < primary_.offset[face + 1]; ++a)
    if (std::find(nodes, nodes + facing_.nodes(candidate), primary_.node[primary_.nodes[a]]) !=
        nodes + facing_.nodes(candidate))
      return true;
  return false;
}

namespace {

/// Projection of the query's point on a face, or the hit of its line.
search::Projection meet_face(bool line, fem::FaceType type, const Vec3* y, const Vec3& x,
                             const Vec3& origin, const Vec3& direction, const double start[2]) {
  if (!line)
    return search::project(type, y, x, start);
  const search::RayHit hit = search::intersect(type, y, origin, direction, start);
  return {{hit.xi[0], hit.xi[1]}, hit.converged};
}

} // namespace

/// Whether the point has passed through the face since the last converged step: a fast point must
/// not leave its partner behind by more than the reach and go free.
bool Interaction::crossed(const Query& q, Local candidate, const double xi[2], double gap) const {
  if (gap >= 0.0 || motion_ == 0.0)
    return false;
  Vec3 y[fem::max_face_nodes];
  facing_.previous_coordinates(candidate, y);
  fem::FacePoint<double> then;
  fem::face_point(facing_.type(candidate), y, xi, then);
  return dot(cross(then.tangent[0], then.tangent[1]), q.x_previous - then.x) >= 0.0;
}

/// A projection within the margin beside a face (the point lies above a concave edge, or just off
/// the rim) counts only when no face with a projection inside is about as near.
void Interaction::visit(const Query& q, Local candidate, double& limit, Partner& inner,
                        Partner& beside) const {
  if (own_neighbour(q.face, candidate))
    return;
  const fem::FaceType type = facing_.type(candidate);
  Vec3 y[fem::max_face_nodes];
  facing_.coordinates(candidate, y);
  double start[2];
  fem::dispatch_face(type, [&](auto s) { decltype(s)::center(start); });
  if (candidate == q.last)
    start[0] = q.last_xi[0], start[1] = q.last_xi[1];
  const auto found = meet_face(q.line, type, y, q.x, q.origin, q.direction, start);
  if (!found.converged)
    return;
  const double unit = fem::is_triangle(type) ? 1.0 : 2.0; // length of a side in parameters
  const auto within = [&](double margin) {
    return fem::dispatch_face(type,
                              [&](auto s) { return decltype(s)::inside(found.xi, margin * unit); });
  };
  const bool hold = q.hold > 0.0 && candidate == q.last;
  if (!within(hold ? q.hold : options_.projection_margin))
    return;
  const auto at = facet_gap<double>(type, y, q.x, found.xi);
  double gap = at.gap;
  if (q.line) {
    Vec3 hit = Vec3::zero();
    for (int b = 0; b < facing_.nodes(candidate); ++b)
      hit += at.N[b] * y[b];
    gap = dot(q.normal, hit - q.x);
  }
  const double distance = std::fabs(gap);
  if (dot(at.normal, q.normal) > outward_share ||
      (q.line && std::fabs(dot(at.normal, q.direction)) < lock_share * norm(q.direction)))
    return;
  if (distance > std::max(q.reach, options_.reach * facing_.size(candidate)) &&
      !crossed(q, candidate, found.xi, gap))
    return;
  if (self_ && gap < 0.0 && -gap * facing_.inverse_depth(candidate) > own_body_depth)
    return;
  const bool is_inner = hold || within(round_off);
  Partner& partner = is_inner ? inner : beside;
  const bool tie =
      partner.face >= 0 && std::fabs(distance - partner.distance) <= round_off * size_[q.face];
  if (tie ? facing_.goes_before(candidate, partner.face)
          : partner.face < 0 || distance < partner.distance)
    partner = {candidate, distance, gap, {found.xi[0], found.xi[1]}};
  if (is_inner)
    limit = std::min(limit, std::max(distance, q.line ? norm(q.origin - q.x) : 0.0));
}

/// Normals jump from face to face, so that a balance right at an edge would be missed from both
/// sides: a point that swings between two faces is held on one.
Interaction::Partner Interaction::find(const Query& q) const {
  double limit = std::max({q.reach, options_.reach * facing_.largest_size(), motion_});
  if (q.line)
    limit += norm(q.origin - q.x);
  Partner inner, beside;
  if (q.last >= 0)
    visit(q, q.last, limit, inner, beside); // most likely still the nearest: it bounds the search
  const bool is_held = q.hold > 0.0 && inner.face == q.last;
  const double line_reach = 2.0 * limit / (q.line ? norm(q.direction) : 1.0);
  if (!is_held)
    facing_.tree().traverse(
        [&](const Box<3>& box) {
          return (q.line ? box.meets_line(q.origin.v, q.direction.v, line_reach)
                         : box.distance2(q.x.v) <= limit * limit);
        },
        [&](Local candidate) {
          if (candidate != q.last)
            visit(q, candidate, limit, inner, beside);
        });
  const bool prefer_inner =
      inner.face >= 0 &&
      (beside.face < 0 || inner.distance <= 2.0 * beside.distance + as_near * size_[q.face]);
  return prefer_inner ? inner : beside;
}

/// A search from where the last one ended, for the closest point or along the primary normal.
Interaction::Query Interaction::query(Local face, int point, const PrimaryPoint<double>& at) const {
  const PointState& state = points_[point_index(face, point)];
  Query q;
  q.face = face;
  q.x = q.origin = at.x;
  q.normal = at.normal;
  q.direction = -at.normal;
  q.line = options_.uses_ray();
  q.x_previous = primary_point(shape(face, point), primary_nodes_previous(face)).x;
  q.reach = options_.reach * size_[face];
  q.last = state.near;
  std::copy_n(state.near_xi, 2, q.last_xi);
  if (options_.segment_updates > 0 && searches_ > options_.segment_updates)
    q.hold = frozen_margin;
  else if (!q.line && state.returns >= swings)
    q.hold = hold_margin;
  return q;
}

/// The nearest partner of a point by the formulation's own search; it is remembered for the next.
Interaction::Partner Interaction::nearest(Local face, int point, const PrimaryPoint<double>& at) {
  PointState& state = points_[point_index(face, point)];
  const Query q = query(face, point, at);
  const Partner best = find(q);
  if (state.near >= 0 && best.face >= 0 && best.face != state.near) {
    if (best.face == state.left)
      ++state.returns;
    state.left = state.near;
  }
  state.near = best.face;
  state.near_xi[0] = best.xi[0];
  state.near_xi[1] = best.xi[1];
  return best;
}

double Interaction::wrong_facing_share() const {
  double near[2] = {0.0, 0.0}; // points near a face of the other surface; those facing its back
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const auto at = primary_point(shape(f, p), primary_nodes(f));
      double best = size_[f] * size_[f];
      bool wrong = false, found = false;
      facing_.tree().traverse([&](const Box<3>& box) { return box.distance2(at.x.v) <= best; },
                              [&](Local candidate) {
                                if (own_neighbour(f, candidate))
                                  return;
                                Vec3 y[fem::max_face_nodes];
                                facing_.coordinates(candidate, y);
                                double center[2];
                                fem::dispatch_face(facing_.type(candidate),
                                                   [&](auto s) { decltype(s)::center(center); });
                                const auto q =
                                    facet_gap<double>(facing_.type(candidate), y, at.x, center);
                                if (std::fabs(q.gap) > size_[f])
                                  return;
                                found = true;
                                wrong = dot(q.normal, at.normal) > 0.5;
                              });
      near[0] += found;
      near[1] += found && wrong;
    }
  comm_.sum(near, 2);
  return near[0] > 0.0 ? near[1] / near[0] : 0.0;
}

} // namespace abut::contact
