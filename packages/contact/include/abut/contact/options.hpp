// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace abut::contact {

enum class Formulation { facet_on_facet };
enum class Enforcement { penalty, augmented_lagrangian };

/// One contact interface. Lengths that a user would have to tune are fractions of face sizes.
struct ContactOptions {
  std::string name;
  std::string primary;   ///< side set that carries the integration points
  std::string secondary; ///< side set that is projected on
  Formulation formulation = Formulation::facet_on_facet;
  Enforcement enforcement = Enforcement::penalty;

  double penalty_factor = 10.0; ///< f in eps = f E_n A / V, when penalty is 0 [1]
  double penalty = 0.0;         ///< eps itself, 0 means automatic [pressure/length]
  int points = 0; ///< integration points per direction; 0: 2 on linear faces, 3 on quadratic

  double reach = 3.0;              ///< how far a partner is sought, in sizes of the larger face [1]
  double projection_margin = 0.01; ///< how far outside a face a projection still counts [1]

  // Augmented Lagrangian: stop when both tolerances hold, at the plateau, or at the maximum.
  double multiplier_tolerance = 1e-2; ///< relative change of the multipliers [1]
  double gap_tolerance = 0.0;         ///< largest penetration in face sizes; 0: not asked [1]
  int min_augmentations = 0;
  int max_augmentations = 20;
};

} // namespace abut::contact
