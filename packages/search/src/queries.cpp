// SPDX-License-Identifier: BSD-3-Clause
#include "abut/search/queries.hpp"

namespace abut::search {
namespace {

struct ClosestPoints {
  Faces faces;
  Tree<3> tree;
  View<const Vec3> points;
  double reach;
  View<Nearest> found;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    found(i) = nearest(faces, tree, PointQuery{points(i), reach});
  }
};

struct LineHits {
  Faces faces;
  Tree<3> tree;
  View<const Line> lines;
  double reach;
  View<Nearest> found;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    found(i) = nearest(faces, tree, LineQuery{lines(i), reach});
  }
};

} // namespace

View<Nearest> closest_points(const Faces& faces, const Tree<3>& tree,
                             const View<const Vec3>& points, double reach) {
  View<Nearest> found("abut::search::closest_points", points.extent(0));
  Kokkos::parallel_for("abut::search::closest_points", Range(0, points.extent(0)),
                       ClosestPoints{faces, tree, points, reach, found});
  return found;
}

View<Nearest> line_hits(const Faces& faces, const Tree<3>& tree, const View<const Line>& lines,
                        double reach) {
  View<Nearest> found("abut::search::line_hits", lines.extent(0));
  Kokkos::parallel_for("abut::search::line_hits", Range(0, lines.extent(0)),
                       LineHits{faces, tree, lines, reach, found});
  return found;
}

} // namespace abut::search
