// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/options.hpp"
#include "abut/contact/side_choice.hpp"
#include "abut/contact/site_start.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace abut::contact {

enum class PenaltySource {
  given,  ///< eps itself
  factor, ///< eps = f E_n A / V of each face
};

/// What one interface does, with nothing left to choose: every automatic choice made, every
/// "not asked" a value that is never reached. Read by kernels as it is, printed by `abut check`.
struct Settings {
  std::string name, primary, secondary;
  SideComparison sides; ///< in the order of primary and secondary here
  Window window;
  Formulation formulation = Formulation::facet_on_facet;
  Enforcement enforcement = Enforcement::penalty;
  Tangent tangent = Tangent::analytic;
  Multipliers multipliers = Multipliers::per_point; ///< never automatic
  WeightedGap weighted_gap = WeightedGap::dual;     ///< of a nodal law
  Uzawa uzawa = Uzawa::nested;
  bool anderson = false; ///< the next multipliers are made of several solves

  PenaltySource penalty_source = PenaltySource::factor;
  double penalty = 0.0;            ///< eps, when given [pressure/length]
  double penalty_factor = 0.0;     ///< f, when by factor [1]
  bool factor_by_pressure = false; ///< f is chosen again after the first step in contact
  double modulus = 0.0;            ///< E_n of the softer body; 0: both are rigid [pressure]
  bool update_penalty = false;

  double friction = 0.0;
  FrictionMap friction_map = FrictionMap::incremental; ///< never automatic
  FrictionSwitching friction_switching = FrictionSwitching::primal_dual;

  bool two_pass = false, tension = false, tied = false, sticky = false;
  TieGap tie_gap = TieGap::keep;
  double tie_distance = 0.1;
  double stick_within = 0.0;                                       ///< [length]
  double stick_strength = std::numeric_limits<double>::infinity(); ///< [pressure]
  double offset = 0.0;                                             ///< [length]
  InitialOverlap initial_overlap = InitialOverlap::keep;
  InitialGap initial_gap = InitialGap::mesh;   ///< never automatic
  bool fits = false;                           ///< the interference counts
  double interference = 0.0, fit_within = 0.0; ///< [length]

  std::optional<int> points; ///< per direction; none: 2 on linear faces, 3 on quadratic ones
  double reach = 3.0;
  double projection_margin = 0.01;
  int segment_updates = std::numeric_limits<int>::max();

  // An augmentation has converged when all of these hold; infinity: not asked.
  double change_tolerance = std::numeric_limits<double>::infinity(); ///< [1]
  double gap_tolerance = std::numeric_limits<double>::infinity();    ///< in face sizes [1]
  double length_tolerance = std::numeric_limits<double>::infinity(); ///< [length]
  double error_tolerance = std::numeric_limits<double>::infinity();  ///< of the penalty: softness
                                                                     ///< over energy [1]
  int min_augmentations = 0, max_augmentations = 20;

  /// Where gaps count from at a site where the meshes have this one at the start [length].
  SiteStart start_of(double gap) const {
    const double closed = initial_overlap == InitialOverlap::resolve ? offset : 0.0;
    const double open = gap - offset;
    SiteStart start;
    start.overlap = gap < closed ? closed - gap : 0.0;
    start.fit = fits && std::fabs(open) <= fit_within ? 1.0 : 0.0;
    const bool closes = initial_gap == InitialGap::close && open > 0.0 && open <= fit_within;
    start.shift = start.fit > 0.0 || closes ? open : 0.0;
    return start;
  }
  /// By how much the gap of the meshes is more than what counts from the start on [length].
  double shift_of(const SiteStart& start) const {
    return start.shift - (initial_overlap == InitialOverlap::adjust ? start.overlap : 0.0);
  }
  bool ray() const { return formulation == Formulation::sliding_elastic; }
  bool augmented() const { return enforcement == Enforcement::augmented_lagrangian; }
  bool nodal_law() const { return multipliers == Multipliers::dual; } ///< the law holds at nodes
  /// Gaps and forces of the nodes do not go by the same functions.
  bool nonsymmetric_nodes() const { return nodal_law() && weighted_gap == WeightedGap::hat; }
  bool anchors() const { return tied || sticky; } ///< points stay with one place without friction
  /// Points hold an anchor of the secondary, with or without friction.
  bool anchored_map() const { return anchors() || friction_map != FrictionMap::incremental; }
  bool augments_at_end() const { return augmented() && uzawa == Uzawa::end_of_step; }
  /// The tractions at the end of a step are the multipliers that the next one starts from.
  bool carries_tractions() const { return augments_at_end() || (augmented() && nodal_law()); }
};

/// Makes every automatic choice of the options and refuses, in this one place, what does not go
/// together: throws OptionError, which knows the key's path. `sides` compares the surfaces in
/// the order of options.primary and options.secondary; where the automatic side swaps them, the
/// settings name them the other way round.
Settings resolve(const ContactOptions& options, const SideComparison& sides);

/// One line for each choice that the deck left open or that a user would ask after: what, value and
/// why, as `abut check` prints it.
std::string explain(const ContactOptions& options, const Settings& settings);

} // namespace abut::contact
