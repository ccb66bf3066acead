// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace abut::solid {

/// Results of one block's elements on this rank. Points with det F <= 0 are left out.
struct ElementFields {
  std::vector<double> stress;    ///< (E, 6) Cauchy, averaged over the element; xx yy zz xy yz xz
  std::vector<double> von_mises; ///< (E) of the averaged stress
  std::vector<double> energy;    ///< (E) strain energy of the element [force length]

  double total_energy() const; ///< over this rank's elements
};

/// Von Mises stress of a stress in the order xx yy zz xy yz xz.
double von_mises(const double stress[6]);

} // namespace abut::solid
