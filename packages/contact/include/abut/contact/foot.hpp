// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/face_map.hpp"

/// Closest points on edges and corners. Behind a re-entrant edge of the secondary, in the wedge
/// between the normals of its two faces, a point has no foot within either: the closest point of
/// the surface lies on the edge, or on a corner where edges meet. The contact normal is the
/// direction from the point to it, and turns from one face's normal to the other's; with the gap,
/// minus the distance, a spring's energy is eps/2 times the squared distance from the surface,
/// which has no jump anywhere behind it.
namespace abut::contact {

/// Where on its face a closest point lies.
struct Foot {
  enum class On : signed char { face, edge, corner };
  On on = On::face;
  signed char index = 0; ///< of the corner that the edge starts from, or of the corner
};

/// Half of the way in parameters along the edge of a face, from corner e to the next.
KOKKOS_INLINE_FUNCTION void edge_direction(fem::FaceType type, int e, double d[2]) {
  fem::dispatch_face(type, [&](auto shape) {
    using Shape = decltype(shape);
    double from[2], to[2];
    Shape::node(e, from);
    Shape::node((e + 1) % Shape::corners, to);
    for (int i = 0; i < 2; ++i)
      d[i] = 0.5 * (to[i] - from[i]);
  });
}

/// A face along a direction d of its parameters.
template <class T> struct EdgePoint {
  Vec<T, 3> tangent, second; ///< derivatives by the way along d

  KOKKOS_INLINE_FUNCTION EdgePoint(const fem::FacePoint<T>& p, const double d[2])
      : tangent(d[0] * p.tangent[0] + d[1] * p.tangent[1]),
        second((d[0] * d[0]) * p.second[0] + (d[1] * d[1]) * p.second[1] +
               (2.0 * d[0] * d[1]) * p.second[2]) {}
};

} // namespace abut::contact
