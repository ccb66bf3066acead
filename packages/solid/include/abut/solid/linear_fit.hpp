// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/solid/point_values.hpp"

/// What the points of an element know, carried to its nodes.
namespace abut::solid {

/// The field a + b (X - X_0) that is closest to values at points, weighted with their volumes: it
/// keeps their mean, and linear fields stay as they are. Where the points do not span space (one
/// point, or points left out) it is the mean.
class LinearFit {
public:
  /// at: (points) reference positions; values.volume are the weights.
  template <int P>
  KOKKOS_INLINE_FUNCTION LinearFit(const PointValues<P>& values, const Vec3 (&at)[P]) {
    for (int p = 0; p < P; ++p) {
      volume_ += values.volume[p];
      center_ += values.volume[p] * at[p];
    }
    if (!(volume_ > 0.0))
      return;
    center_ *= 1.0 / volume_;
    Mat3 spread = Mat3::zero();
    for (int p = 0; p < P; ++p) {
      const Vec3 d = at[p] - center_;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          spread[i][j] += values.volume[p] * d[i] * d[j];
    }
    const double size = trace(spread) / 3.0, determinant = det(spread);
    spans_ = determinant > flat * size * size * size;
    if (spans_)
      inverse_ = inverse(spread, determinant);
  }

  KOKKOS_INLINE_FUNCTION double volume() const { return volume_; } ///< of the points [length^3]

  /// field: (P, 6) the values to fit. (nodes, 6) at x (3, nodes).
  template <int P, int n>
  KOKKOS_INLINE_FUNCTION void at_nodes(const PointValues<P>& values, const Vec3 (&at)[P],
                                       const double (&field)[P][6], const double (&x)[3][n],
                                       double* out) const {
    for (int v = 0; v < voigt_size; ++v) {
      double mean = 0.0;
      Vec3 moment = Vec3::zero(), slope = Vec3::zero();
      for (int p = 0; p < P; ++p)
        if (values.volume[p] > 0.0) {
          mean += values.volume[p] * field[p][v];
          moment += values.volume[p] * field[p][v] * (at[p] - center_);
        }
      if (spans_)
        slope = inverse_ * moment;
      for (int a = 0; a < n; ++a)
        out[voigt_size * a + v] =
            volume_ > 0.0 ? mean / volume_ + dot(slope, Vec3{{x[0][a], x[1][a], x[2][a]}} - center_)
                          : 0.0;
    }
  }

private:
  static constexpr double flat = 1e-9; ///< of an element 1/50000 as thick as wide
  double volume_ = 0.0;
  Vec3 center_ = Vec3::zero();
  Mat3 inverse_ = Mat3::zero();
  bool spans_ = false;
};

} // namespace abut::solid
