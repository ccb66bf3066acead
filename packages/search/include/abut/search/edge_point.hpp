// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <initializer_list>

namespace abut::search {

/// Root in [low, high] of the cubic c0 + c1 t + c2 t^2 + c3 t^3, which is monotone there and has
/// values of different signs at the ends: Newton's method, halving where it would leave.
KOKKOS_INLINE_FUNCTION double monotone_root(const double c[4], double low, double high) {
  const auto value = [c](double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); };
  const bool rising = value(low) < value(high);
  double t = 0.5 * (low + high);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double v = value(t);
    ((v < 0.0) == rising ? low : high) = t;
    double next = t - v / (c[1] + t * (2.0 * c[2] + t * 3.0 * c[3]));
    if (!(next > low && next < high))
      next = 0.5 * (low + high);
    if (std::fabs(next - t) < 1e-15)
      return next;
    t = next;
  }
  return t;
}

/// The parameter in [-1, 1] at which the edge from a (t = -1) over the middle node m to b (t = 1)
/// is closest to x: the least of all stationary points and ends, not of one near a start. A
/// straight edge has m = (a + b) / 2, to the bit.
KOKKOS_INLINE_FUNCTION double closest_on_edge(const Vec3& a, const Vec3& m, const Vec3& b,
                                              const Vec3& x) {
  const Vec3 r = m - x, h = 0.5 * (b - a), q = 0.5 * (a + b) - m; // r + h t + q t^2
  if (q[0] == 0.0 && q[1] == 0.0 && q[2] == 0.0)
    return fmin(1.0, fmax(-1.0, -dot(r, h) / dot(h, h)));
  const auto distance2 = [&](double t) {
    const Vec3 d = r + t * h + (t * t) * q;
    return dot(d, d);
  };
  const double slope[4] = {dot(r, h), dot(h, h) + 2.0 * dot(r, q), 3.0 * dot(h, q),
                           2.0 * dot(q, q)};
  // The slope is monotone between these.
  double ends[4] = {-1.0, 1.0, 1.0, 1.0};
  int pieces = 1;
  const double p = 3.0 * slope[3], d = slope[2] * slope[2] - p * slope[1];
  if (p > 0.0 && d > 0.0) {
    const double s = std::sqrt(d);
    for (const double t : {(-slope[2] - s) / p, (-slope[2] + s) / p})
      if (t > ends[pieces - 1] && t < 1.0)
        ends[pieces++] = t;
    ends[pieces] = 1.0;
  }
  double best = distance2(1.0) < distance2(-1.0) ? 1.0 : -1.0;
  const auto value = [&slope](double t) {
    return slope[0] + t * (slope[1] + t * (slope[2] + t * slope[3]));
  };
  for (int k = 0; k < pieces; ++k) {
    if (!(value(ends[k]) < 0.0 && value(ends[k + 1]) > 0.0))
      continue; // no minimum within
    const double t = monotone_root(slope, ends[k], ends[k + 1]);
    if (distance2(t) < distance2(best))
      best = t;
  }
  return best;
}

} // namespace abut::search
