// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/face_map.hpp"

namespace abut::search {

/// Where a line meets a face: y(xi) = origin + distance * direction.
struct RayHit {
  double xi[2];
  double distance; ///< in lengths of the direction; negative behind the origin
  bool converged;  ///< xi lies on the line; it may lie outside the face
};

/// Sine of the angle between line and face below which they count as parallel.
constexpr double parallel_line = 1e-6;

/// One Newton step of y(xi) = origin + distance * direction on any scalar, from the face point p.
/// With an AD scalar and xi, distance at the solution, the step carries their derivatives. False,
/// and no step, when the line is parallel to the face.
template <class T>
KOKKOS_INLINE_FUNCTION bool ray_step(const fem::FacePoint<T>& p, const Vec<T, 3>& origin,
                                     const Vec<T, 3>& direction, const T& distance, T step[3]) {
  const Vec<T, 3> area = cross(p.tangent[0], p.tangent[1]);
  const T slope = dot(area, direction);
  const double size = std::sqrt(value_of(dot(area, area)) * value_of(dot(direction, direction)));
  if (!(std::fabs(value_of(slope)) > parallel_line * size))
    return false;
  const Vec<T, 3> miss = p.x - origin - distance * direction;
  step[0] = -dot(cross(p.tangent[1], direction), miss) / slope;
  step[1] = -dot(cross(direction, p.tangent[0]), miss) / slope;
  step[2] = dot(area, miss) / slope;
  return true;
}

/// Intersects the line with a face that `face(xi, point)` evaluates, starting from xi. Not
/// converged when Newton does not settle or leaves the neighbourhood of the face.
template <class Face>
KOKKOS_INLINE_FUNCTION RayHit intersect_with(const Face& face, const Vec3& origin,
                                             const Vec3& direction, const double start[2]) {
  constexpr double far = 3.0;
  RayHit hit{{start[0], start[1]}, 0.0, false};
  fem::FacePoint<double> p;
  for (int iteration = 0; iteration < 40; ++iteration) {
    face(hit.xi, p);
    if (iteration == 0)
      hit.distance = dot(direction, p.x - origin) / dot(direction, direction);
    double step[3];
    if (!ray_step(p, origin, direction, hit.distance, step))
      return hit;
    const double size = std::sqrt(step[0] * step[0] + step[1] * step[1]);
    if (!(size < 1e300) || (iteration == 0 && size > far))
      return hit;
    const double scale = size > 0.7 ? 0.7 / size : 1.0;
    hit.xi[0] += scale * step[0];
    hit.xi[1] += scale * step[1];
    hit.distance += scale * step[2];
    if (std::fabs(hit.xi[0]) > far || std::fabs(hit.xi[1]) > far)
      return hit;
    if (size < 1e-9) { // the next step would be of the order of its square
      hit.converged = true;
      return hit;
    }
  }
  return hit;
}

/// The same with the face of nodes y.
KOKKOS_INLINE_FUNCTION RayHit intersect(fem::FaceType type, const Vec3* y, const Vec3& origin,
                                        const Vec3& direction, const double start[2]) {
  return intersect_with(
      [&](const double* xi, fem::FacePoint<double>& p) { fem::face_point(type, y, xi, p); }, origin,
      direction, start);
}

} // namespace abut::search
