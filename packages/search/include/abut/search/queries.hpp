// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/search/bvh.hpp"
#include "abut/search/faces.hpp"
#include "abut/search/meet_face.hpp"

/// The nearest of many faces, for one query in a kernel and for many queries at once.
///
/// Ties. Above an edge or a corner several faces are equally near. Of all faces whose distance is
/// that of the nearest, up to `same_distance` lengths of the face, the one with the lowest number
/// is the answer: a query has exactly one, whatever the order in which the tree is walked.
namespace abut::search {

constexpr double same_distance = 1e-10;

/// The answer to one query.
struct Nearest {
  Local face = -1; ///< -1: none within reach
  double xi[2] = {0.0, 0.0};
  double distance = 0.0; ///< as in FaceMeeting
};

struct Line {
  Vec3 origin, direction; ///< direction of length 1
};

/// What is asked of a face, for a point.
struct PointQuery {
  Vec3 x;
  double reach; ///< [length]

  KOKKOS_INLINE_FUNCTION const double* from() const { return x.v; }
  KOKKOS_INLINE_FUNCTION bool meets(const Box<3>& box, double limit) const {
    return box.distance2(x.v) <= limit * limit;
  }
  KOKKOS_INLINE_FUNCTION FaceMeeting meet(fem::FaceType type, const Vec3* y) const {
    FaceMeeting m = closest_on_face(type, y, x);
    m.found = m.found && m.distance <= reach;
    return m;
  }
};

/// What is asked of a face, for a line.
struct LineQuery {
  Line line;
  double reach; ///< ahead and behind [length]

  KOKKOS_INLINE_FUNCTION const double* from() const { return line.origin.v; }
  KOKKOS_INLINE_FUNCTION bool meets(const Box<3>& box, double limit) const {
    Box<3> wide = box; // hits count up to edge_margin outside the face
    wide.inflate(2.0 * edge_margin * diagonal(box));
    return wide.meets_line(line.origin.v, line.direction.v, limit);
  }
  KOKKOS_INLINE_FUNCTION FaceMeeting meet(fem::FaceType type, const Vec3* y) const {
    return hit_on_face(type, y, line.origin, line.direction, reach);
  }
};

/// The nearest face to a query, by the tree over the faces' boxes (face_box).
template <class Query>
KOKKOS_INLINE_FUNCTION Nearest nearest(const Faces& faces, const Tree<3>& tree, const Query& q) {
  const auto meet = [&](Local face, double& size) {
    Vec3 y[fem::max_face_nodes];
    faces.coordinates(face, y);
    size = diagonal(face_box(faces.type(face), y));
    return q.meet(faces.type(face), y);
  };
  double least = q.reach, size = 0.0;
  bool any = false;
  tree.traverse(
      [&](const Box<3>& box) { return q.meets(box, least + same_distance * diagonal(box)); },
      [&](Local face) {
        const FaceMeeting m = meet(face, size);
        if (m.found && std::fabs(m.distance) <= least) {
          least = std::fabs(m.distance);
          any = true;
        }
      },
      [&](const Box<3>& a, const Box<3>& b) { // what is near soon shuts out what is far
        return a.distance2(q.from()) <= b.distance2(q.from());
      });
  Nearest best;
  if (!any)
    return best;
  tree.traverse(
      [&](const Box<3>& box) { return q.meets(box, least + 2.0 * same_distance * diagonal(box)); },
      [&](Local face) {
        if (best.face >= 0 && face > best.face)
          return;
        const FaceMeeting m = meet(face, size);
        if (m.found && std::fabs(m.distance) <= least + same_distance * size)
          best = {face, {m.xi[0], m.xi[1]}, m.distance};
      });
  return best;
}

/// The closest point of the faces to each of the points, at most `reach` away.
View<Nearest> closest_points(const Faces& faces, const Tree<3>& tree,
                             const View<const Vec3>& points, double reach);

/// The hit of each line with the faces that is nearest to its origin, ahead or behind, at most
/// `reach` away. A line within parallel_line of a face's tangent plane does not hit it.
View<Nearest> line_hits(const Faces& faces, const Tree<3>& tree, const View<const Line>& lines,
                        double reach);

} // namespace abut::search
