// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/site.hpp"
#include "law/constants.hpp"

/// Signorini's and Coulomb's laws at a site, whatever the site is. docs/theory/friction.md and
/// multipliers.md
namespace abut::contact {

/// What the law reads beside the site.
struct LawTerms {
  double friction = 0.0;   ///< mu at the present time [1]
  bool predicting = false; ///< see SolveKind::prediction
  double hair = 0.0;       ///< gap up to which sites that nothing presses count as touching [length]
  double hair_share = 1.0; ///< part of their stiffness that these have [1]
  bool literal = false;    ///< slip by the printed theory: the shear is not decided here
};

/// What was open on its own stays so while a step is predicted: bodies that move toward it alone
/// would close it, but what it stands on mostly moves along. Held shut by mistake it pulls faces
/// into place that never touch.
KOKKOS_INLINE_FUNCTION bool stays_open(const SitePast& past, double size) {
  return !past.in_contact && past.gap > touching_gap * size;
}

/// The status that a site has to keep in Coulomb's law: that of the last iterate while a step is
/// predicted, for what slipped lies right on the cone, where rounding would decide whether it moves
/// along; and that of its rule when it is frozen. The return map by itself has no last iterate to
/// go on from.
KOKKOS_INLINE_FUNCTION Keep kept_status(const SiteReading& r, const SiteIterate& iterate,
                                        const LawTerms& law) {
  if (law.predicting && r.soft > 0.0)
    return iterate.last.slips ? Keep::slip : Keep::stick;
  if (!iterate.frozen || iterate.rule == PointRule::open || iterate.rule == PointRule::frictionless)
    return Keep::nothing;
  const bool sticks =
      iterate.rule == PointRule::incremental_stick || iterate.rule == PointRule::anchored;
  return sticks ? Keep::stick : Keep::slip;
}

/// Stick or slip under a trial shear in the plane of the normal.
KOKKOS_INLINE_FUNCTION ShearChoice choose_status(const SiteReading& r, const SiteIterate& iterate,
                                                 const LawTerms& law, const Vec3& trial,
                                                 const Vec3& normal, double pressure) {
  const double share = r.soft > 0.0 && r.soft < r.penalty ? r.soft / r.penalty : 1.0;
  return choose_shear(iterate.last, trial, normal, law.friction * (pressure > 0.0 ? pressure : 0.0),
                      share, kept_status(r, iterate, law));
}

/// Shear of a site that presses, by radial return of the trial w = P (lambda_T - eps theta r).
KOKKOS_INLINE_FUNCTION void set_shear(const SiteReading& r, const SitePast& past,
                                      const SiteIterate& iterate, const LawTerms& law,
                                      SiteState& s) {
  ContactPoint first; // what contact_share asks of a point
  first.first = !past.in_contact;
  first.previous_gap = past.gap;
  first.multiplier = r.multiplier;
  first.penalty = r.penalty;
  s.share = contact_share(first, r.gap);
  s.share_slope = contact_share_slope(first, r.gap);
  const Vec3 z = r.carried - (r.penalty * s.share) * r.slip;
  s.out_of_plane = dot(r.normal, z);
  s.trial = z - s.out_of_plane * r.normal;
  s.rule = PointRule::incremental_stick;
  if (s.touching)
    return;
  const ShearChoice choice = choose_status(r, iterate, law, s.trial, r.normal, s.pressure);
  s.rule = choice.slips ? PointRule::incremental_slip : PointRule::incremental_stick;
  s.line = choice.line;
  s.shear = choice.traction;
  s.settled = choice.settled;
}

/// The state of a site. With `literal` friction a pressed site comes back as
/// PointRule::literal_slip and without its shear.
KOKKOS_INLINE_FUNCTION SiteState decide(const SiteReading& r, const SitePast& past,
                                        const SiteIterate& iterate, const LawTerms& law) {
  SiteState s;
  const bool was_open = iterate.rule == PointRule::open;
  if (!r.covered || (iterate.frozen && was_open) || (law.predicting && stays_open(past, r.size)))
    return s;
  const double pressure = r.multiplier - r.penalty * r.gap;
  // At the kink itself the stiff side of the derivative is taken: bodies that just touch hold.
  const double touches = touching_gap * r.size > law.hair ? touching_gap * r.size : law.hair;
  if (pressure <= -r.penalty * touches && !r.pulls)
    return s;
  s.touching = pressure <= 0.0 && !r.pulls;
  s.pressure = s.touching ? 0.0 : pressure;
  s.rule = PointRule::frictionless;
  if (law.friction == 0.0)
    return s;
  if (law.literal && !s.touching && pressure > 0.0 && r.slides)
    s.rule = PointRule::literal_slip;
  else if (s.touching || (pressure > 0.0 && r.slides))
    set_shear(r, past, iterate, law, s);
  return s;
}

} // namespace abut::contact
