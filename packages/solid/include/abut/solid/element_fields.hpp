// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace abut::solid {

/// Results of one block's elements on this rank. Points with det F <= 0 are left out.
struct ElementFields {
  std::vector<double> stress;    ///< (E, 6) Cauchy, averaged over the element; xx yy zz xy yz xz
  std::vector<double> von_mises; ///< (E) of the averaged stress
  std::vector<double> energy;    ///< (E) strain energy of the element [force length]

  double total_energy() const; ///< over this rank's elements
};

/// What further fields of results need of one block's elements on this rank.
struct RecoveredFields {
  std::vector<double> volume; ///< (E) reference volume [length^3]
  std::vector<double> strain; ///< (E, 6) averaged over it: Green-Lagrange, or small where the
                              ///< material is linear elastic; components of the tensor
  /// (E, nodes of the element, 6) Cauchy, at the nodes, of the field a + b X that is closest to the
  /// stress at the element's points; of one point its stress.
  std::vector<double> stress;
};

/// Principal values of a stress in the order xx yy zz xy yz xz, the largest first.
std::array<double, 3> principal_values(const double stress[6]);

/// Von Mises stress of a stress in the order xx yy zz xy yz xz.
double von_mises(const double stress[6]);

} // namespace abut::solid
