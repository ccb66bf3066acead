// SPDX-License-Identifier: BSD-3-Clause
#include "symmetric_eigen.hpp"

#include <cmath>

namespace abut::scene {

std::vector<double> symmetric_eigen(std::vector<double>& a, std::size_t n) {
  constexpr double negligible = 1e-15;
  std::vector<double> vectors(n * n, 0.0);
  double trace = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    vectors[(n + 1) * i] = 1.0;
    trace += a[(n + 1) * i];
  }
  bool changed = true;
  for (int sweep = 0; changed && sweep < 60; ++sweep) {
    changed = false;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        if (std::fabs(a[n * p + q]) <= negligible * trace)
          continue;
        changed = true;
        const double theta = 0.5 * std::atan2(2.0 * a[n * p + q], a[(n + 1) * q] - a[(n + 1) * p]);
        const double c = std::cos(theta), s = std::sin(theta);
        for (std::size_t k = 0; k < n; ++k) {
          const double kp = a[n * k + p], kq = a[n * k + q];
          a[n * k + p] = c * kp - s * kq;
          a[n * k + q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double pk = a[n * p + k], qk = a[n * q + k];
          a[n * p + k] = c * pk - s * qk;
          a[n * q + k] = s * pk + c * qk;
          const double vp = vectors[n * k + p], vq = vectors[n * k + q];
          vectors[n * k + p] = c * vp - s * vq;
          vectors[n * k + q] = s * vp + c * vq;
        }
      }
  }
  return vectors;
}

} // namespace abut::scene
