// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/face_map.hpp"

/// Faces of straight edges, on which a query has one answer more often than not: what it costs to
/// look for others is saved where it can be shown that there are none.
namespace abut::search {

KOKKOS_INLINE_FUNCTION constexpr bool is_straight(fem::FaceType type) {
  return type == fem::FaceType::quad4 || type == fem::FaceType::tri3;
}

/// quad4 or tri3 as a polynomial: x = c + a xi + b eta + w xi eta, with w = 0 of a triangle.
struct StraightFace {
  Vec3 c, a, b, w;

  KOKKOS_INLINE_FUNCTION StraightFace(fem::FaceType type, const Vec3* y) {
    if (type == fem::FaceType::tri3) {
      c = y[0];
      a = y[1] - y[0];
      b = y[2] - y[0];
      w = Vec3::zero();
    } else {
      c = 0.25 * ((y[0] + y[1]) + (y[2] + y[3]));
      a = 0.25 * ((y[1] - y[0]) + (y[2] - y[3]));
      b = 0.25 * ((y[3] - y[0]) + (y[2] - y[1]));
      w = 0.25 * ((y[0] - y[1]) + (y[2] - y[3]));
    }
  }

  KOKKOS_INLINE_FUNCTION Vec3 place(const double xi[2]) const {
    return c + xi[0] * a + xi[1] * (b + xi[0] * w);
  }
  /// Place, tangents and second derivatives; shape functions are left as they are.
  KOKKOS_INLINE_FUNCTION void operator()(const double xi[2], fem::FacePoint<double>& p) const {
    p.tangent[0] = a + xi[1] * w;
    p.tangent[1] = b + xi[0] * w;
    p.x = c + xi[0] * a + xi[1] * p.tangent[1];
    p.second[0] = p.second[1] = Vec3::zero();
    p.second[2] = w;
  }

  /// Whether the squared distance from x has a positive definite Hessian all over the face, by
  /// bounds of its terms: |y,xi|^2, |y,eta|^2 and y,xi . y,eta - (x - y) . w. It then has one
  /// minimum, within the face where it is stationary there, else on the boundary; and the face is
  /// so nearly flat that Newton's method gets there from the middle.
  KOKKOS_INLINE_FUNCTION bool has_one_closest_point(const Vec3& x) const {
    constexpr double skew = 0.9, nearly_flat = 0.1;
    const double nw = norm(w);
    if (nw == 0.0)
      return true;
    const double na = norm(a), nb = norm(b), shorter = fmin(na, nb);
    const double warp = nw * (2.0 * (na + nb + nw) + norm(x - c));
    return nw < shorter && std::fabs(dot(a, b)) + warp < skew * (na - nw) * (nb - nw) &&
           warp < nearly_flat * shorter * shorter;
  }
};

/// What a line sees of a face of straight edges.
enum class Sight {
  beside, ///< it misses it
  once,   ///< it may hit it, and then in one point
  unclear ///< warped in its direction, or nearly parallel to it
};

/// Looks along the line at the polygon of the corners: where it is convex, the bilinear map onto it
/// has a Jacobian of one sign at the corners, hence all over, and is one to one.
KOKKOS_INLINE_FUNCTION Sight sight_of(fem::FaceType type, const Vec3* y, const Vec3& origin,
                                      const Vec3& direction) {
  constexpr double margin = 1e-6; // beside by more than hits outside a face may be, over the area
  constexpr double convex = 1e-3; // least corner over the area
  const int n = fem::face_corners(type);
  double across[4], area = 0.0, least = 0.0;
  Vec3 r[4];
  for (int k = 0; k < n; ++k)
    r[k] = y[k] - origin;
  for (int k = 0; k < n; ++k) { // twice the triangle of the line's point and an edge
    across[k] = dot(direction, cross(r[k], r[(k + 1) % n]));
    area += across[k];
  }
  const double sign = area < 0.0 ? -1.0 : 1.0;
  double size = 0.0;
  least = sign * area;
  for (int k = 0; k < n; ++k) {
    const Vec3 ahead = y[(k + 1) % n] - y[k], back = y[(k + n - 1) % n] - y[k];
    least = fmin(least, sign * dot(direction, cross(ahead, back)));
    size = fmax(size, dot(ahead, ahead));
  }
  if (!(least > convex * sign * area) || !(sign * area > convex * size))
    return Sight::unclear;
  for (int k = 0; k < n; ++k)
    if (sign * across[k] < -margin * sign * area)
      return Sight::beside;
  return Sight::once;
}

} // namespace abut::search
