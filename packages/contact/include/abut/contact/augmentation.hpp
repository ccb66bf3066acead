// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/site.hpp"

#include <functional>

namespace abut::contact {

/// Why augmentations do not bring what they should.
enum class PlateauCause {
  none,           ///< they do
  held_nodes,     ///< where it is largest the primary cannot move along the normal
  partly_covered, ///< where it is largest faces are covered in part
  changing_set,   ///< points or nodes open and close in turns
  stiff_primary, ///< the multipliers change by more than half of their last change, and the primary
                 ///< is stiff and fine or nodes hold the law: what presses hardly moves gaps
  short_waves,   ///< they do, and they live at points or are smoothed: what differs from one to the
                 ///< next moves nodes little
  unknown,
};

/// What holds augmentations up and what to do, in plain words; empty for none.
const char* describe(PlateauCause cause);

/// Energy of the host's bodies where they were last evaluated, of strain and of motion; collective
/// [energy].
using EnergyOfBodies = std::function<double()>;

/// What the next augmentation would do.
struct Augmentation {
  double change = 0.0; ///< relative change of the multipliers, L2 [1]
  /// Largest violation over face size: penetration and motion in stick, at sites, or averaged at
  /// those corners whose faces are closed when the multipliers are smoothed; with increments of
  /// averages and with accelerated multipliers also a gap across which they press [1].
  double gap = 0.0;
  double length = 0.0;    ///< the same [length]
  bool converged = false; ///< the tolerances hold
  bool stalled = false;   ///< what is beyond its tolerance has not fallen for several augmentations
  /// Why it has hardly fallen, when it has stalled or with springs as stiff as f = 10.
  PlateauCause cause = PlateauCause::none;
};

/// A site as an update of its multipliers sees it.
struct Site {
  double area = 0.0;    ///< that it stands for; 0: it takes no part, or another rank speaks for it
                        ///< [length^2]
  double size = 0.0;    ///< of its faces [length]
  double gap = 0.0;     ///< > 0 open, less the offset [length]
  double penalty = 0.0; ///< [pressure/length]
  double multiplier = 0.0;          ///< of the pressure, in the last solve [pressure]
  Vec3 carried = {{0.0, 0.0, 0.0}}; ///< of the shear, turned to the present [pressure]
  Vec3 spring = {{0.0, 0.0, 0.0}};  ///< shear that the spring carries beside it [pressure]
  Vec3 normal = {{0.0, 0.0, 0.0}};  ///< from the secondary to the primary
  bool was_in_contact = false;      ///< at the last converged step
  bool anchored = false;            ///< tied or sticky, and its anchor is there
  SiteState state;

  Vec3 traction() const { return state.pressure * normal + state.shear; }
};

/// New multipliers of a site after a solve: changes `pressure` and `shear` (tangent, on the
/// primary) from those that the interface's own update gives, with which they come in, to the
/// multipliers of the next solve.
using MultiplierUpdate = std::function<void(const Site& site, double& pressure, Vec3& shear)>;

} // namespace abut::contact
