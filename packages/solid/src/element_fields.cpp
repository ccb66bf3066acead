// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/element_fields.hpp"

#include "abut/solid/principal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace abut::solid {

double ElementFields::total_energy() const {
  return std::accumulate(energy.begin(), energy.end(), 0.0);
}

double von_mises(const double s[6]) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
}

std::array<double, 3> principal_values(const double s[6]) {
  Mat3 a;
  for (int v = 0; v < voigt_size; ++v)
    a[voigt_row[v]][voigt_column[v]] = a[voigt_column[v]][voigt_row[v]] = s[v];
  const PrincipalAxes<double> axes(a);
  std::array<double, 3> values{axes.strain[0], axes.strain[1], axes.strain[2]};
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

} // namespace abut::solid
