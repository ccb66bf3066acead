// SPDX-License-Identifier: BSD-3-Clause
// Points that slide over the rim of the secondary surface.
#include "abut/contact/facet_gap.hpp"
#include "abut/search/closest_point.hpp"
#include "constants.hpp"
#include "point_search.hpp"

#include <algorithm>

namespace abut::contact {

namespace {

/// Whether xi lies beyond the edge from corner e to the next.
bool beyond_edge(fem::FaceType type, const double* xi, int e) {
  if (fem::is_triangle(type)) {
    const double inside[] = {xi[1], 1.0 - xi[0] - xi[1], xi[0]};
    return inside[e] < 0.0;
  }
  const double out[] = {-xi[1], xi[0], xi[1], -xi[0]};
  return out[e] > 1.0;
}

} // namespace

/// Whether no other secondary face has the edge from corner e of a face to the next.
bool Interaction::on_rim(Local face, int e) const {
  const int corners = fem::is_triangle(facing_.type(face)) ? 3 : 4;
  Global own[fem::max_face_nodes];
  Vec3 y[fem::max_face_nodes];
  facing_.global_nodes(face, own);
  facing_.coordinates(face, y);
  const int next = (e + 1) % corners;
  const Vec3 middle = 0.5 * (y[e] + y[next]);
  const double reach = norm(y[next] - y[e]);
  bool shared = false;
  facing_.tree().traverse(
      [&](const search::Box<3>& box) { return box.distance2(middle.v) <= reach * reach; },
      [&](Local other) {
        Global nodes[fem::max_face_nodes];
        facing_.global_nodes(other, nodes);
        const auto has = [&](Global node) {
          return std::count(nodes, nodes + facing_.nodes(other), node) > 0;
        };
        shared = shared || (other != face && has(own[e]) && has(own[next]));
      });
  return !shared;
}

/// Whether the point lies close above or below the surface that goes on from its last face, but
/// past an edge where the surface ends.
bool Interaction::past_rim(Local last, const double* last_xi, const Vec3& x) const {
  const fem::FaceType type = facing_.type(last);
  Vec3 y[fem::max_face_nodes];
  facing_.coordinates(last, y);
  const auto found = search::project(type, y, x, last_xi);
  if (!found.converged ||
      std::fabs(facet_gap<double>(type, y, x, found.xi).gap) > rim_depth * facing_.size(last))
    return false;
  for (int e = 0; e < (fem::is_triangle(type) ? 3 : 4); ++e)
    if (beyond_edge(type, found.xi, e) && on_rim(last, e))
      return true;
  return false;
}

/// Past a rim a force ends at once, and what springs back takes it up again: there is no balance
/// between. A pressed point that goes over the rim again and again has no partner for this solve.
Interaction::Partner Interaction::lasting_partner(Local face, int point,
                                                  const PrimaryPoint<double>& at) {
  PointState& state = points_[point_index(face, point)];
  if (state.losses >= swings)
    return {};
  const Local last = state.near;
  const double last_xi[] = {state.near_xi[0], state.near_xi[1]};
  const Partner best = nearest(face, point, at);
  if (state.pressed() && best.face < 0 && last >= 0 && past_rim(last, last_xi, at.x) &&
      ++state.losses == swings)
    state.history.multiplier = 0.0, state.history.carried = StoredTraction();
  return best;
}

} // namespace abut::contact
