// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/side_choice.hpp"

#include "kinematics/primary_surface.hpp"

#include <algorithm>

#include <cmath>
#include <limits>

namespace abut::contact {

SideComparison compare_sides(const Comm& comm, const mesh::Surface& primary,
                             const mesh::Surface& secondary) {
  enum { area, count, modulus, length, columns };
  double softest = std::numeric_limits<double>::max();
  double sums[2 * columns] = {};
  const mesh::Surface* sides[2] = {&primary, &secondary};
  for (int s = 0; s < 2; ++s) {
    const std::vector<double> size = face_sizes(*sides[s]);
    for (std::size_t f = 0; f < size.size(); ++f) {
      sums[columns * s + area] += size[f] * size[f];
      sums[columns * s + count] += 1.0;
      sums[columns * s + length] += size[f];
      if (sides[s]->modulus[f] > 0.0)
        softest = std::min(softest, sides[s]->modulus[f]);
      sums[columns * s + modulus] += size[f] * size[f] * sides[s]->modulus[f];
    }
  }
  comm.sum(sums, 2 * columns);
  const double *p = sums, *q = sums + columns;
  SideComparison result;
  softest = comm.min(softest);
  result.softest = softest == std::numeric_limits<double>::max() ? 0.0 : softest;
  result.face_size = (p[length] + q[length]) / (p[count] + q[count]);
  result.size = std::sqrt(p[area] / p[count] * q[count] / q[area]);
  if (q[modulus] == 0.0)
    result.stiffness = 0.0;
  else if (p[modulus] == 0.0)
    result.stiffness = std::numeric_limits<double>::infinity();
  else
    result.stiffness = p[modulus] / p[area] * q[area] / q[modulus];
  return result;
}

} // namespace abut::contact
