// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/resolve.hpp"
#include "kinematics/facing_surface.hpp"
#include "kinematics/primary_surface.hpp"
#include "law/signorini_coulomb.hpp"

namespace abut::contact {

/// The settings as kernels read them, at the present time.
struct PointTerms {
  LawTerms law;
  bool ray = false;
  bool at_nodes = false;     ///< the law holds at nodes now
  bool anchors = false;      ///< tied or sticky: points stay with one place without friction
  bool anchored_map = false; ///< points have anchors now
  bool inclined = false;     ///< slip along the inclined ray
  bool tied = false, sticky = false, tension = false;
  bool user_law = false;     ///< a normal law of the host's own decides the pressure
  double penalty = 0.0;      ///< eps; 0: stiffness A/V [pressure/length]
  double stiffness = 0.0;    ///< f E [pressure]
  double soft_modulus = 0.0; ///< of the spring that decides between stick and slip; 0: the return
                             ///< map decides [pressure]
  double softest = 0.0;      ///< E while springs are no stiffer than the bodies, else 0 [pressure]
  double offset = 0.0;       ///< gap that counts as closed [length]
  double rise = 0.0;         ///< part of the points' rise that closes their gap: 0 or 1
  StartTerms start;
  double stick_within = 0.0; ///< [length]
  double reach = 0.0;        ///< gap of points without a partner, in face sizes
  double share = 1.0;        ///< part of the traction that this pass carries
  double search_hold = 0.0;  ///< margin within which every point keeps its partner; 0: none does

  /// A/V of the primary element, or of the secondary one when the primary is rigid [1/length].
  KOKKOS_INLINE_FUNCTION static double
  inverse_depth(const PrimaryView& primary, const FacingView& facing, Local face, Local other) {
    return primary.modulus(face) > 0.0 ? primary.inverse_depth(face) : facing.inverse_depth(other);
  }
  /// eps = f E A/V with E of the softer body (theory: eq. 595, 596).
  KOKKOS_INLINE_FUNCTION double penalty_of(const PrimaryView& primary, const FacingView& facing,
                                           Local face, Local other) const {
    const double given = penalty > 0.0 ? penalty
                                       : stiffness * inverse_depth(primary, facing, face, other) *
                                             primary.stretch(face);
    if (softest == 0.0)
      return given;
    const double soft = softest * inverse_depth(primary, facing, face, other);
    return soft > 0.0 && soft < given ? soft : given;
  }
};

} // namespace abut::contact
