// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/resolve.hpp"
#include "abut/core/error.hpp"
#include <utility>
namespace abut::contact {
Settings resolve(const ContactOptions& o, const SideComparison& sides) {
  Settings s;
  s.name = o.name; s.primary = o.primary; s.secondary = o.secondary;
  if (o.primary_side == PrimarySide::automatic && sides.prefers_swap()) std::swap(s.primary, s.secondary);
  s.window = o.window; s.formulation = o.formulation; s.enforcement = o.enforcement; s.tangent = o.tangent;
  const bool goes = !o.tied && !o.sticky && !o.tension && o.tangent != Tangent::automatic && o.friction_map != FrictionMap::inclined_ray && o.friction_map != FrictionMap::literal;
  s.multipliers = o.multipliers;
  if (o.multipliers == Multipliers::automatic)
    s.multipliers = o.enforcement == Enforcement::augmented_lagrangian && goes && sides.suits_dual() ? Multipliers::dual : Multipliers::smoothed;
  const auto refuse = [&](bool r, const char* w) { if (r && s.multipliers == Multipliers::dual) throw InputError("contact." + o.name + ": 'multipliers: dual' does not go with '" + w + "'"); };
  refuse(o.tied, "tied"); refuse(o.sticky, "sticky"); refuse(o.tension, "tension"); refuse(o.tangent == Tangent::automatic, "tangent: automatic");
  refuse(o.friction_map == FrictionMap::inclined_ray, "friction_map: inclined_ray"); refuse(o.friction_map == FrictionMap::literal, "friction_map: literal");
  if (!s.ray() && (o.friction_map == FrictionMap::inclined_ray || o.friction_map == FrictionMap::literal))
    throw InputError("contact." + o.name + ": this friction_map works along rays: it needs 'formulation: sliding_elastic'");
  s.uzawa = o.uzawa;
  s.anderson = o.friction == 0.0 && !o.tied && !o.sticky && !o.tension && (o.augmentation == AugmentationRule::anderson || (o.augmentation == AugmentationRule::automatic && s.multipliers != Multipliers::per_point));
  s.penalty_source = o.penalty ? PenaltySource::given : PenaltySource::factor;
  s.penalty = o.penalty.value_or(0.0);
  s.penalty_factor = o.penalty_factor ? *o.penalty_factor : (!s.augmented() || s.multipliers == Multipliers::per_point) ? 10.0 : s.multipliers == Multipliers::smoothed ? 3.0 : 30.0;
  s.modulus = sides.softest;
  if (s.modulus == 0.0 && !o.penalty) throw InputError("contact." + o.name + ": both surfaces are rigid: give 'penalty' [pressure/length]");
  s.factor_by_pressure = !o.penalty_factor && o.gap_tolerance && s.multipliers == Multipliers::smoothed && s.modulus > 0.0 && s.augmented();
  s.update_penalty = o.update_penalty; s.friction = o.friction;
  s.friction_map = s.multipliers == Multipliers::dual ? FrictionMap::incremental : o.friction_map != FrictionMap::automatic ? o.friction_map : s.ray() ? FrictionMap::inclined_ray : FrictionMap::incremental;
  s.friction_switching = o.friction_switching; s.two_pass = o.two_pass; s.tension = o.tension; s.tied = o.tied; s.sticky = o.sticky;
  s.tie_gap = o.tie_gap; s.tie_distance = o.tie_distance; s.stick_within = o.stick_within;
  if (o.stick_strength) s.stick_strength = *o.stick_strength;
  s.offset = o.offset; s.initial_overlap = o.initial_overlap; s.points = o.points; s.reach = o.reach; s.projection_margin = o.projection_margin;
  if (o.segment_updates) s.segment_updates = *o.segment_updates;
  if (o.gap_tolerance) s.gap_tolerance = *o.gap_tolerance;
  if (o.gap_limit) s.length_tolerance = *o.gap_limit;
  if (o.multiplier_tolerance) s.change_tolerance = *o.multiplier_tolerance;
  else if (s.multipliers != Multipliers::dual) s.change_tolerance = 1e-2;
  else if (!o.gap_tolerance && !o.gap_limit) s.gap_tolerance = 1e-3;
  s.min_augmentations = o.min_augmentations; s.max_augmentations = o.max_augmentations;
  return s;
}
std::string explain(const ContactOptions&, const Settings&) { return {}; }
} // namespace abut::contact
