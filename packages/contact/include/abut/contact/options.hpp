// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/window.hpp"

#include <optional>
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
  keep,    ///< an overlap of the meshes is resolved at once, as an offset is
  resolve, ///< pushed out while t rises to its end, and an offset with it
  adjust,  ///< taken as no overlap: strain free; an offset presses at once
};

/// Which surfaces the gaps at the start are measured between.
enum class InitialGap {
  automatic, ///< round where an overlap is resolved or adjusted, mesh where it is kept
  mesh,      ///< the faces of the meshes
  round,     ///< the round surfaces that flat faces stand for, while bodies slide little
  close,     ///< the faces, but what is open by no more than fit_within counts as touching
};

/// What becomes of the distance that a tied point has from its partner at the start.
enum class TieGap {
  keep,  ///< it strains nothing
  close, ///< the point is pulled on its partner
};

enum class Tangent {
  analytic,  ///< closed form
  automatic, ///< by automatic differentiation of the residual; slow
  symmetric, ///< symmetric part of the closed form: half the solver's work, more iterations
};

/// Where the multipliers of augmented Lagrangian live. docs/theory/multipliers.md
enum class Multipliers {
  automatic, ///< dual, or smoothed where a dual law does not go: resolve
  per_point, ///< one at each integration point: the theory; its pressures oscillate
  smoothed,  ///< at the corner nodes, read by the points: law and tangent of the theory
  dual,      ///< at the corner nodes, which hold the law: weighted gaps go to zero
};

/// What gap and slip of a node of `dual` multipliers are averaged with. docs/theory/multipliers.md
enum class WeightedGap {
  dual, ///< psi, as tractions are: symmetric; where the gap is curved it closes before it has to
  hat,  ///< N, never negative: no open gap presses, cold steps converge; nonsymmetric
};

/// When multipliers change.
enum class Uzawa {
  nested,      ///< after each solve of a step, until the tolerances hold
  end_of_step, ///< once, at the end of each step, without another solve
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
  Window window;         ///< when there is contact; partners of ties are those at its beginning
  PrimarySide primary_side = PrimarySide::as_given;
  Formulation formulation = Formulation::facet_on_facet;
  Enforcement enforcement = Enforcement::penalty;
  Tangent tangent = Tangent::analytic;
  Multipliers multipliers = Multipliers::automatic;
  WeightedGap weighted_gap = WeightedGap::dual;
  AugmentationRule augmentation = AugmentationRule::automatic;
  Uzawa uzawa = Uzawa::nested;

  std::optional<double> penalty_factor; ///< f in eps = f E_n A / V; none: by the multipliers [1]
  std::optional<double> penalty;        ///< eps itself; none: by penalty_factor [pressure/length]
  std::string penalty_curve;            ///< factor on the penalty over t
  bool update_penalty = false;          ///< A of the automatic penalty is the area of the last step

  double friction = 0.0;      ///< coefficient mu [1]
  std::string friction_curve; ///< factor on mu over t
  FrictionMap friction_map = FrictionMap::automatic;
  FrictionSwitching friction_switching = FrictionSwitching::primal_dual;

  bool two_pass = false; ///< both sides carry points, each half of the traction
  bool tension = false;  ///< a point that is in contact may pull
  bool tied = false;     ///< points close to their partner at the start stay there
  TieGap tie_gap = TieGap::keep;
  double tie_distance = 0.1;            ///< what is close, in face sizes [1]
  bool sticky = false;                  ///< points that touch or overlap are tied from then on
  double stick_within = 0.0;            ///< gap up to which a sticky point touches [length]
  std::optional<double> stick_strength; ///< normal tension that it stands; none: any [pressure]
  double offset = 0.0;                  ///< gap that counts as closed: half a shell [length]
  InitialOverlap initial_overlap = InitialOverlap::keep;
  InitialGap initial_gap = InitialGap::automatic;
  /// By how much surfaces press into each other that the meshes have near each other, whatever gap
  /// or overlap they have there; grows with t. < 0: how far apart they are [length]
  std::optional<double> interference;
  std::string interference_curve;   ///< factor on it over t, in place of the growth with t
  std::optional<double> fit_within; ///< what is near; none: of an interference its size and a tenth
                                    ///< of the faces on each side [length]

  std::optional<int> points; ///< per direction; none: 2 on linear faces, 3 on quadratic ones

  double reach = 3.0;              ///< how far a partner is sought, in sizes of the larger face [1]
  double projection_margin = 0.01; ///< how far outside a face a projection still counts [1]
  std::optional<int> segment_updates; ///< searches in a step after which partners stay; none: all

  // Augmented Lagrangian: stop when the tolerances hold, at the plateau, or at the maximum.
  std::optional<double> multiplier_tolerance; ///< relative change of the multipliers; none: 1e-2,
                                              ///< not asked of dual ones [1]
  std::optional<double> gap_tolerance; ///< largest penetration in face sizes; none: not asked, but
                                       ///< 1e-3 of dual multipliers without a tolerance, whose
                                       ///< gaps may then cost 1e-3 of the bodies' energy [1]
  std::optional<double> gap_limit;     ///< largest penetration; none: not asked [length]
  int min_augmentations = 0;
  int max_augmentations = 20; ///< at least 1
};

} // namespace abut::contact
