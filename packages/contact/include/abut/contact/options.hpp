// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace abut::contact {

enum class Formulation {
  node_on_facet,   ///< points at the primary nodes, closest point, secondary normal
  facet_on_facet,  ///< Gauss points, closest point, secondary normal
  sliding_elastic, ///< Gauss points, ray along the primary normal, current area
};
enum class Enforcement { penalty, augmented_lagrangian };

/// How the tangential traction follows from the motion of the partners.
enum class FrictionMap {
  automatic,    ///< inclined_ray for sliding_elastic, incremental for closest points
  inclined_ray, ///< stick against an anchor; slip along the ray inclined by the friction angle
  incremental,  ///< radial return of the converged traction plus the step's objective slip
  literal,      ///< the printed theory; not continuous at the cone
};

/// How Newton decides between stick and slip on the way to the return map's answer.
enum class FrictionSwitching {
  primal_dual, ///< by the last iterate's traction and a soft spring: does not cycle
  return_map,  ///< by the return map itself, as stiff as the penalty
};

enum class InitialOverlap {
  keep,    ///< an overlap of the meshes is resolved at once
  resolve, ///< pushed out while t rises to its end
  adjust,  ///< taken as no overlap: strain free
};

enum class Tangent {
  analytic,  ///< closed form
  automatic, ///< by automatic differentiation of the residual; slow
  symmetric, ///< symmetric part of the closed form: half the solver's work, more iterations
};

/// Where the multipliers of augmented Lagrangian live. docs/theory/multipliers.md
enum class Multipliers {
  automatic, ///< dual, or smoothed where a dual law does not go: goes_dual,
             ///< SideComparison::suits_dual
  per_point, ///< one at each integration point: the theory; its pressures oscillate
  smoothed,  ///< at the corner nodes, read by the points: law and tangent of the theory
  dual,      ///< at the corner nodes, which hold the law: weighted gaps go to zero
};

/// What the next multipliers are made of.
enum class AugmentationRule {
  automatic, ///< anderson for smoothed and dual multipliers, plain at points
  plain,     ///< the last solve
  anderson,  ///< the last few solves, so that what they leave cancels best; without friction
};

/// Which of the two surfaces is the primary.
enum class PrimarySide {
  as_given,
  automatic, ///< the softer one
};

/// One contact interface. Lengths that a user would have to tune are fractions of face sizes.
struct ContactOptions {
  std::string name;
  std::string primary;   ///< side set that carries the integration points
  std::string secondary; ///< side set that is projected on; may be the same one: self-contact
  PrimarySide primary_side = PrimarySide::as_given;
  Formulation formulation = Formulation::facet_on_facet;
  Enforcement enforcement = Enforcement::penalty;
  Tangent tangent = Tangent::analytic;
  Multipliers multipliers = Multipliers::automatic;
  AugmentationRule augmentation = AugmentationRule::automatic;

  double penalty_factor = 0.0; ///< f in eps = f E_n A / V, when penalty is 0; 0: chosen [1]
  double penalty = 0.0;        ///< eps itself, 0 means automatic [pressure/length]
  std::string penalty_curve;   ///< factor on the penalty over t
  bool update_penalty = false; ///< A of the automatic penalty is the area of the last step

  double friction = 0.0;      ///< coefficient mu [1]
  std::string friction_curve; ///< factor on mu over t
  FrictionMap friction_map = FrictionMap::automatic;
  FrictionSwitching friction_switching = FrictionSwitching::primal_dual;

  bool two_pass = false;     ///< both sides carry points, each half of the traction
  bool tension = false;      ///< a point that is in contact may pull
  bool tied = false;         ///< points close to their partner at the start stay there
  double tie_distance = 0.1; ///< what is close, in face sizes [1]
  double offset = 0.0;       ///< gap that counts as closed, e.g. a shell's half thickness [length]
  InitialOverlap initial_overlap = InitialOverlap::keep;

  int points = 0; ///< integration points per direction; 0: 2 on linear faces, 3 on quadratic

  double reach = 3.0;              ///< how far a partner is sought, in sizes of the larger face [1]
  double projection_margin = 0.01; ///< how far outside a face a projection still counts [1]
  int segment_updates = 0;         ///< searches in a solve after which partners stay; 0: no limit

  // Augmented Lagrangian: stop when the tolerances hold, at the plateau, or at the maximum. With a
  // maximum of zero multipliers change once, at the end of each step.
  double multiplier_tolerance = 0.0; ///< relative change of the multipliers; 0: 1e-2, not asked
                                     ///< of dual ones [1]
  double gap_tolerance = 0.0; ///< largest penetration in face sizes; 0: not asked, but 1e-3 of dual
                              ///< multipliers where no tolerance is given [1]
  double gap_limit = 0.0;     ///< largest penetration; 0: not asked [length]
  int min_augmentations = 0;
  int max_augmentations = 20;

  /// Whether multipliers change at the end of a step only.
  bool augments_at_end() const {
    return enforcement == Enforcement::augmented_lagrangian && max_augmentations == 0;
  }
  /// Whether the tractions at the end of a step become the multipliers that the next one starts
  /// from.
  bool carries_tractions() const {
    return augments_at_end() ||
           (enforcement == Enforcement::augmented_lagrangian && multipliers == Multipliers::dual);
  }
  /// Whether the next multipliers are made of several solves.
  bool accelerates() const {
    return friction == 0.0 && !tied && !tension &&
           (augmentation == AugmentationRule::anderson ||
            (augmentation == AugmentationRule::automatic && multipliers != Multipliers::per_point));
  }
  bool uses_ray() const { return formulation == Formulation::sliding_elastic; }
  /// Whether these options go with dual multipliers.
  bool goes_dual() const {
    return !tied && !tension && tangent != Tangent::automatic &&
           friction_map != FrictionMap::inclined_ray && friction_map != FrictionMap::literal;
  }
  FrictionMap map() const {
    if (multipliers == Multipliers::dual)
      return FrictionMap::incremental;
    if (friction_map != FrictionMap::automatic)
      return friction_map;
    return uses_ray() ? FrictionMap::inclined_ray : FrictionMap::incremental;
  }
};

} // namespace abut::contact
