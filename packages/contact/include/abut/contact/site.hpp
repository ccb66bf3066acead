// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/point_force.hpp"

/// A site is where the contact law holds: an integration point of the primary surface, or one of
/// its corner nodes. Four things are known of it, and each has one writer:
///
///   SiteReading   what the present configuration says of it     written by every evaluation
///   SiteState     what the law makes of that                    written by every evaluation
///   SiteIterate   what the way of Newton so far says of it      written by events of the iteration
///   SitePast      the last converged step                       written when a step is accepted
namespace abut::contact {

enum class Status : signed char { open, slip, stick };

/// Gap, slip and stiffness of a site in the present configuration.
struct SiteReading {
  bool covered = false;    ///< it has a partner
  bool pulls = false;      ///< it may carry tension
  bool slides = true;      ///< Coulomb's law acts where it presses
  double gap = 0.0;        ///< > 0 open, less the offset, with what is eased [length]
  double eased = 0.0;      ///< see StartTerms [length]
  double penalty = 0.0;    ///< [pressure/length]
  double multiplier = 0.0; ///< pressure = multiplier - penalty gap [pressure]
  double soft = 0.0;       ///< stiffness that decides between stick and slip; 0: the penalty's own
                           ///< [pressure/length]
  double size = 0.0;       ///< of the faces here [length]
  Vec3 normal = {{0.0, 0.0, 0.0}};  ///< from the secondary to the primary
  Vec3 slip = {{0.0, 0.0, 0.0}};    ///< of the primary in the step, objective [length]
  Vec3 carried = {{0.0, 0.0, 0.0}}; ///< shear multiplier or converged traction now [pressure]
};

/// Of the last converged step.
struct SitePast {
  bool in_contact = false;
  double gap = 0.0; ///< less the present offset [length]
};

/// What the iterates of this solve have left. A residual reads it, events of the iteration write
/// it.
struct SiteIterate {
  ShearIterate last;   ///< of the last iterate, from which the friction switching goes on
  bool frozen = false; ///< multipliers have changed: the status stays that of `rule` until the next
                       ///< iterate is taken
  PointRule rule = PointRule::open; ///< of the last iterate
  bool touching = false;            ///< then
  int flips = 0;                    ///< changes of status in this step
};

/// Pressure, shear and rule of a site.
struct SiteState {
  PointRule rule = PointRule::open;
  bool touching = false;    ///< no pressure, but stiff: bodies that just touch hold
  bool settled = true;      ///< the shear is the return map's
  double pressure = 0.0;    ///< per area of the formulation's measure; < 0 only in tension
  Vec3 shear = {{0, 0, 0}}; ///< tangential traction on the primary [pressure]
  SlipLine line;            ///< in slip, the law made linear
  double share = 1.0, share_slope = 0.0; ///< of the step's slip, contact_share
  Vec3 trial = {{0, 0, 0}};              ///< of the shear, tangential [pressure]
  double out_of_plane = 0.0;             ///< normal part of the trial before projection [pressure]

  /// Whether the site has a row in the tangent.
  KOKKOS_INLINE_FUNCTION bool active() const { return rule != PointRule::open; }
  /// Whether it exerts a force.
  KOKKOS_INLINE_FUNCTION bool pressed() const { return active() && !touching; }
  KOKKOS_INLINE_FUNCTION bool sticks() const {
    return rule == PointRule::incremental_stick || rule == PointRule::anchored;
  }
  KOKKOS_INLINE_FUNCTION Status status() const {
    return !pressed() ? Status::open : sticks() ? Status::stick : Status::slip;
  }
};

} // namespace abut::contact
