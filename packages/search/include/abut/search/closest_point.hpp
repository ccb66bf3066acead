// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/face_map.hpp"

namespace abut::search {

/// Orthogonal projection of a point on a face.
struct Projection {
  double xi[2];
  bool converged; ///< xi is a stationary point of the distance; it may lie outside the face
};

/// One Newton step of (x - y(xi)) . y,a = 0 on any scalar; returns the step. Without `curvature` it
/// is a Gauss-Newton step, which is safe far from the solution. With an AD scalar and xi at the
/// solution, the step carries the derivatives of the projection.
template <class T>
KOKKOS_INLINE_FUNCTION void projection_step(const fem::FacePoint<T>& p, const Vec<T, 3>& x,
                                            T step[2], bool curvature = true) {
  const Vec<T, 3> d = x - p.x;
  const T r0 = dot(d, p.tangent[0]), r1 = dot(d, p.tangent[1]);
  const T m00 = dot(p.tangent[0], p.tangent[0]), m11 = dot(p.tangent[1], p.tangent[1]),
          m01 = dot(p.tangent[0], p.tangent[1]);
  T a = m00 - dot(d, p.second[0]), b = m01 - dot(d, p.second[2]), c = m11 - dot(d, p.second[1]);
  T determinant = a * c - b * b;
  const T metric = m00 * m11 - m01 * m01;
  if (!curvature || value_of(determinant) < 1e-3 * value_of(metric) || value_of(a) <= 0.0) {
    a = m00, b = m01, c = m11, determinant = metric; // far from convex: Gauss-Newton
  }
  step[0] = (c * r0 - b * r1) / determinant;
  step[1] = (a * r1 - b * r0) / determinant;
}

/// Projects x on a face that `face(xi, point)` evaluates, starting from xi. Not converged when
/// Newton does not settle or leaves the neighbourhood of the face.
template <class Face>
KOKKOS_INLINE_FUNCTION Projection project_on(const Face& face, const Vec3& x,
                                             const double start[2]) {
  constexpr double far = 3.0;
  Projection result{{start[0], start[1]}, false};
  fem::FacePoint<double> p;
  for (int iteration = 0; iteration < 40; ++iteration) {
    face(result.xi, p);
    double step[2];
    projection_step(p, x, step, iteration > 0);
    const double size = std::sqrt(step[0] * step[0] + step[1] * step[1]);
    if (iteration == 0 && size > far)
      return result; // well beside the face: not worth a search
    const double scale = size > 0.7 ? 0.7 / size : 1.0;
    result.xi[0] += scale * step[0];
    result.xi[1] += scale * step[1];
    if (!(size < 1e300) || std::fabs(result.xi[0]) > far || std::fabs(result.xi[1]) > far)
      return result;
    if (size < 1e-9) { // the next step would be of the order of its square
      result.converged = true;
      return result;
    }
  }
  return result;
}

/// The same on the face with nodes y.
KOKKOS_INLINE_FUNCTION Projection project(fem::FaceType type, const Vec3* y, const Vec3& x,
                                          const double start[2]) {
  return project_on(
      [&](const double* xi, fem::FacePoint<double>& p) { fem::face_point(type, y, xi, p); }, x,
      start);
}

} // namespace abut::search
