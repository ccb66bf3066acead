// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/element_fields.hpp"

#include <cmath>
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

} // namespace abut::solid
