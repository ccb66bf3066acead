// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

namespace abut::search {

/// Axis-aligned box. Empty when low > high.
template <int D> struct Box {
  double low[D], high[D];

  KOKKOS_INLINE_FUNCTION static Box empty() {
    Box b;
    for (int i = 0; i < D; ++i)
      b.low[i] = 1e300, b.high[i] = -1e300;
    return b;
  }
  KOKKOS_INLINE_FUNCTION void add(const double* x) {
    for (int i = 0; i < D; ++i) {
      low[i] = x[i] < low[i] ? x[i] : low[i];
      high[i] = x[i] > high[i] ? x[i] : high[i];
    }
  }
  KOKKOS_INLINE_FUNCTION void add(const Box& b) {
    for (int i = 0; i < D; ++i) {
      low[i] = b.low[i] < low[i] ? b.low[i] : low[i];
      high[i] = b.high[i] > high[i] ? b.high[i] : high[i];
    }
  }
  KOKKOS_INLINE_FUNCTION void inflate(double r) {
    for (int i = 0; i < D; ++i)
      low[i] -= r, high[i] += r;
  }
  KOKKOS_INLINE_FUNCTION bool overlaps(const Box& b) const {
    for (int i = 0; i < D; ++i)
      if (low[i] > b.high[i] || b.low[i] > high[i])
        return false;
    return true;
  }
  /// Square of the distance from a point, 0 inside.
  KOKKOS_INLINE_FUNCTION double distance2(const double* x) const {
    double s = 0.0;
    for (int i = 0; i < D; ++i) {
      const double d = x[i] < low[i] ? low[i] - x[i] : x[i] > high[i] ? x[i] - high[i] : 0.0;
      s += d * d;
    }
    return s;
  }
  /// Whether the ray origin + t*direction meets the box for some |t| <= reach (both ways).
  KOKKOS_INLINE_FUNCTION bool meets_line(const double* origin, const double* direction,
                                         double reach) const {
    double t0 = -reach, t1 = reach;
    for (int i = 0; i < D; ++i) {
      if (direction[i] == 0.0) {
        if (origin[i] < low[i] || origin[i] > high[i])
          return false;
        continue;
      }
      const double a = (low[i] - origin[i]) / direction[i];
      const double b = (high[i] - origin[i]) / direction[i];
      t0 = (a < b ? a : b) > t0 ? (a < b ? a : b) : t0;
      t1 = (a < b ? b : a) < t1 ? (a < b ? b : a) : t1;
    }
    return t0 <= t1;
  }
};

} // namespace abut::search
