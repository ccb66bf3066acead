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

/// Sum of a box's edges: no less than its diagonal, without a root.
KOKKOS_INLINE_FUNCTION double span(const Box<3>& box) {
  return (box.high[0] - box.low[0]) + (box.high[1] - box.low[1]) + (box.high[2] - box.low[2]);
}

/// What is asked of a face, for a point.
struct PointQuery {
  Vec3 x;
  double reach; ///< [length]

  /// Square of the least distance that a face within the box can have.
  KOKKOS_INLINE_FUNCTION double bound(const Box<3>& box) const { return box.distance2(x.v); }
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
  Vec3 inverse; ///< of the direction's components that are not 0

  KOKKOS_INLINE_FUNCTION LineQuery(const Line& along, double far) : line(along), reach(far) {
    for (int i = 0; i < 3; ++i)
      inverse[i] = line.direction[i] == 0.0 ? 0.0 : 1.0 / line.direction[i];
  }

  /// Square of the least distance at which the line may hit a face within the box, ahead or behind;
  /// negative: nowhere. Hits count up to edge_margin outside a face.
  KOKKOS_INLINE_FUNCTION double bound(const Box<3>& box) const {
    const double margin = 2.0 * edge_margin * span(box);
    double t0 = -reach, t1 = reach;
    for (int i = 0; i < 3; ++i) {
      const double low = box.low[i] - margin - line.origin[i];
      const double high = box.high[i] + margin - line.origin[i];
      if (line.direction[i] == 0.0) {
        if (low > 0.0 || high < 0.0)
          return -1.0;
        continue;
      }
      const double a = low * inverse[i], b = high * inverse[i];
      t0 = (a < b ? a : b) > t0 ? (a < b ? a : b) : t0;
      t1 = (a < b ? b : a) < t1 ? (a < b ? b : a) : t1;
    }
    if (t0 > t1)
      return -1.0;
    return t0 > 0.0 ? t0 * t0 : t1 < 0.0 ? t1 * t1 : 0.0;
  }
  KOKKOS_INLINE_FUNCTION bool meets(const Box<3>& box, double limit) const {
    const double b = bound(box);
    return b >= 0.0 && b <= limit * limit;
  }
  KOKKOS_INLINE_FUNCTION FaceMeeting meet(fem::FaceType type, const Vec3* y) const {
    return hit_on_face(type, y, line.origin, line.direction, reach);
  }
};

/// Faces met that are as near as the nearest so far, up to ties.
struct NearestFaces {
  static constexpr int most = 16; ///< that are kept; more share a corner in meshes gone wild
  struct Met {
    Nearest at;
    double tie; ///< distances differ by no more than this [length]
  };
  Met met[most];
  int count = 0;
  double least;      ///< distance of the nearest, or the reach
  bool lost = false; ///< there were more

  KOKKOS_INLINE_FUNCTION explicit NearestFaces(double reach) : least(reach) {}

  KOKKOS_INLINE_FUNCTION bool is_nearest(const Met& m) const {
    return std::fabs(m.at.distance) <= least + m.tie;
  }
  KOKKOS_INLINE_FUNCTION void add(const Met& m) {
    if (!is_nearest(m))
      return;
    least = fmin(least, std::fabs(m.at.distance));
    if (count == most)
      drop_far();
    if (count < most)
      met[count++] = m;
    else
      lost = true;
  }
  /// The one with the lowest number.
  KOKKOS_INLINE_FUNCTION Nearest lowest() const {
    Nearest best;
    for (int i = 0; i < count; ++i)
      if (is_nearest(met[i]) && (best.face < 0 || met[i].at.face < best.face))
        best = met[i].at;
    return best;
  }

private:
  KOKKOS_INLINE_FUNCTION void drop_far() {
    int kept = 0;
    for (int i = 0; i < count; ++i)
      if (is_nearest(met[i]))
        met[kept++] = met[i];
    count = kept;
  }
};

/// The nearest face to a query, by the tree over the faces' boxes (face_box).
template <class Query>
KOKKOS_INLINE_FUNCTION Nearest nearest(const Faces& faces, const Tree<3>& tree, const Query& q) {
  const auto bound = [&](const Box<3>& box) { return q.bound(box); };
  const auto meet = [&](Local face) -> NearestFaces::Met {
    Vec3 y[fem::max_face_nodes];
    faces.coordinates(face, y);
    const FaceMeeting m = q.meet(faces.type(face), y);
    if (!m.found)
      return {{-1, {0.0, 0.0}, 1e300}, 0.0};
    return {{face, {m.xi[0], m.xi[1]}, m.distance},
            same_distance * diagonal(face_box(faces.type(face), y))};
  };
  NearestFaces near(q.reach);
  tree.traverse_nearest_first(
      bound,
      [&](const Box<3>& box, double b) {
        const double limit = near.least + same_distance * span(box);
        return b <= limit * limit;
      },
      [&](Local face) { near.add(meet(face)); });
  Nearest best = near.lowest();
  if (!near.lost)
    return best;
  const double least = near.least; // more ties than could be kept: once more, for the lowest
  tree.traverse_nearest_first(
      bound,
      [&](const Box<3>& box, double b) {
        const double limit = least + 2.0 * same_distance * span(box);
        return b <= limit * limit;
      },
      [&](Local face) {
        if (face >= best.face)
          return;
        const NearestFaces::Met m = meet(face);
        if (near.is_nearest(m))
          best = m.at;
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
