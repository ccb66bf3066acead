// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/resolve.hpp"

#include "abut/contact/option_error.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace abut::contact {

namespace {

const char* word(FrictionMap map) {
  if (map == FrictionMap::inclined_ray)
    return "inclined_ray";
  return map == FrictionMap::literal ? "literal" : "incremental";
}

bool along_rays(FrictionMap map) {
  return map == FrictionMap::inclined_ray || map == FrictionMap::literal;
}

/// The key, with its value where it has several, that a law at nodes does not go with; null: none.
const char* against_dual(const ContactOptions& o) {
  if (o.tied)
    return "tied";
  if (o.sticky)
    return "sticky";
  if (o.tension)
    return "tension";
  if (o.tangent == Tangent::automatic)
    return "tangent: automatic";
  if (o.friction_map == FrictionMap::inclined_ray)
    return "friction_map: inclined_ray";
  return o.friction_map == FrictionMap::literal ? "friction_map: literal" : nullptr;
}

/// The key of those that sticky points do without; null: none.
const char* against_sticky(const ContactOptions& o) {
  if (o.tied)
    return "tied";
  if (o.tension)
    return "tension";
  return o.friction > 0.0 ? "friction" : nullptr;
}

/// An interference says all of the start; a distance belongs to a word that asks for it.
void refuse_fits(const ContactOptions& o) {
  const auto refuse = [&](bool refused, const char* key, const std::string& reason) {
    if (refused)
      throw OptionError("contact." + o.name + key, reason);
  };
  const bool closes = o.initial_gap == InitialGap::close;
  refuse(o.interference && o.initial_overlap != InitialOverlap::keep, ".interference",
         "does not go with 'initial_overlap': no overlap of the meshes counts where it is given");
  refuse(o.interference && o.initial_gap != InitialGap::automatic, ".interference",
         "does not go with 'initial_gap': no gap of the meshes counts where it is given");
  refuse((o.interference || closes) && o.tied, o.interference ? ".interference" : ".initial_gap",
         "does not go with 'tied', whose word for gaps is 'tie_gap'");
  refuse(closes && !o.fit_within, "",
         "missing key 'fit_within': up to which gap does 'initial_gap: close' close (expected a "
         "number > 0 [length])");
  refuse(o.fit_within && !closes && !o.interference, ".fit_within",
         "goes with 'interference' or 'initial_gap: close' only");
  refuse(!o.interference_curve.empty() && !o.interference, ".interference_curve",
         "missing key 'interference', on which it is a factor");
}

void refuse_contradictions(const ContactOptions& o, const SideComparison& sides) {
  const auto refuse = [&](bool refused, const char* key, const std::string& reason) {
    if (refused)
      throw OptionError("contact." + o.name + key, reason);
  };
  const auto quoted = [](const char* key) { return std::string("'") + (key ? key : "") + "'"; };
  refuse(o.primary == o.secondary && !o.primary.empty() && o.two_pass, ".two_pass",
         "expected false: self-contact of '" + o.primary + "' has points on both sides already");
  refuse(o.tied && o.tension, ".tension", "expected false: tied points pull already");
  const char* key = against_sticky(o);
  refuse(o.sticky && key, ".sticky", "does not go with " + quoted(key) + ": leave one of them out");
  key = against_dual(o);
  refuse(o.multipliers == Multipliers::dual && key, ".multipliers",
         "'dual' does not go with " + quoted(key) + "; valid here: automatic, smoothed, per_point");
  refuse(o.weighted_gap == WeightedGap::hat && o.multipliers != Multipliers::automatic &&
             o.multipliers != Multipliers::dual,
         ".weighted_gap", "'hat' goes with 'multipliers: dual' only");
  refuse(along_rays(o.friction_map) && o.formulation != Formulation::sliding_elastic,
         ".friction_map",
         quoted(word(o.friction_map)) +
             " needs the rays of 'formulation: sliding_elastic'; valid here: automatic, "
             "incremental");
  refuse_fits(o);
  refuse(sides.softest == 0.0 && !o.penalty, "",
         "missing key 'penalty' (both surfaces are rigid: expected a number > 0 "
         "[pressure/length])");
  refuse(o.max_augmentations < 1, ".max_augmentations",
         "expected a whole number >= 1; for multipliers that change once, at the end of each "
         "step, give 'uzawa: end_of_step'");
  refuse(o.min_augmentations > o.max_augmentations, ".min_augmentations",
         "expected at most max_augmentations, which is " + std::to_string(o.max_augmentations) +
             ", got " + std::to_string(o.min_augmentations));
}

Multipliers space(const ContactOptions& o, const SideComparison& sides) {
  if (o.multipliers != Multipliers::automatic)
    return o.multipliers;
  const bool dual =
      o.enforcement == Enforcement::augmented_lagrangian && !against_dual(o) && sides.suits_dual();
  return dual ? Multipliers::dual : Multipliers::smoothed;
}

/// f of the automatic penalty where the options give none: soft with smoothed multipliers, whose
/// points are as accurate as their springs are soft; stiff with dual ones, which it only brings in
/// faster.
double automatic_factor(const Settings& s) {
  if (!s.augmented() || s.multipliers == Multipliers::per_point)
    return 10.0;
  return s.multipliers == Multipliers::smoothed ? 3.0 : 30.0;
}

void set_penalty(Settings& s, const ContactOptions& o, const SideComparison& sides) {
  s.penalty_source = o.penalty ? PenaltySource::given : PenaltySource::factor;
  s.penalty = o.penalty.value_or(0.0);
  s.penalty_factor = o.penalty_factor.value_or(automatic_factor(s));
  s.modulus = sides.softest;
  s.factor_by_pressure = !o.penalty_factor && o.gap_tolerance && s.augmented() &&
                         s.multipliers == Multipliers::smoothed && s.modulus > 0.0;
  s.update_penalty = o.update_penalty;
}

void set_friction(Settings& s, const ContactOptions& o) {
  s.friction = o.friction;
  s.friction_switching = o.friction_switching;
  if (s.nodal_law())
    s.friction_map = FrictionMap::incremental;
  else if (o.friction_map != FrictionMap::automatic)
    s.friction_map = o.friction_map;
  else
    s.friction_map = s.ray() ? FrictionMap::inclined_ray : FrictionMap::incremental;
}

/// Smoothed multipliers are asked for their change, dual ones for the gap, which theirs closes, and
/// for what it costs where bodies are stiff.
void set_augmentation(Settings& s, const ContactOptions& o) {
  constexpr double change = 1e-2, gap = 1e-3, error = 1e-3;
  s.uzawa = o.uzawa;
  s.anderson =
      o.friction == 0.0 && !s.anchors() && !o.tension &&
      (o.augmentation == AugmentationRule::anderson ||
       (o.augmentation == AugmentationRule::automatic && s.multipliers != Multipliers::per_point));
  s.gap_tolerance = o.gap_tolerance.value_or(s.gap_tolerance);
  s.length_tolerance = o.gap_limit.value_or(s.length_tolerance);
  if (o.multiplier_tolerance)
    s.change_tolerance = *o.multiplier_tolerance;
  else if (!s.nodal_law())
    s.change_tolerance = change;
  else if (!o.gap_tolerance && !o.gap_limit) {
    s.gap_tolerance = gap;
    if (o.uzawa == Uzawa::nested)
      s.error_tolerance = error;
  }
  s.min_augmentations = o.min_augmentations;
  s.max_augmentations = o.max_augmentations;
}

InitialGap initial_gap(const ContactOptions& o) {
  if (o.initial_gap != InitialGap::automatic)
    return o.initial_gap;
  return o.initial_overlap == InitialOverlap::keep ? InitialGap::mesh : InitialGap::round;
}

/// Flat faces of both sides miss a round surface by a tenth of their size at most.
void set_start(Settings& s, const ContactOptions& o) {
  constexpr double rise = 0.1;
  s.offset = o.offset;
  s.initial_overlap = o.initial_overlap;
  s.initial_gap = initial_gap(o);
  s.fits = o.interference.has_value();
  s.interference = o.interference.value_or(0.0);
  s.fit_within = o.fit_within.value_or(std::fabs(s.interference) + 2.0 * rise * s.sides.face_size);
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

std::string explain_penalty(const ContactOptions& o, const Settings& s) {
  if (s.penalty_source == PenaltySource::given)
    return "penalty: eps = " + number(s.penalty) + ", given\n";
  std::string text = "penalty: eps = f E_n A / V of each face, f = " + number(s.penalty_factor);
  if (o.penalty_factor)
    text += ", given";
  else if (s.factor_by_pressure)
    text += " until the first step in contact, then what gap_tolerance asks for";
  else if (!s.augmented())
    text += ", automatic for a penalty alone";
  else if (s.multipliers == Multipliers::per_point)
    text += ", automatic for multipliers at points";
  else
    text +=
        s.nodal_law() ? ", automatic for dual multipliers" : ", automatic for smoothed multipliers";
  return text + "; softest modulus " + number(s.modulus) + "\n";
}

std::string explain_space(const ContactOptions& o, const Settings& s) {
  if (o.multipliers == Multipliers::per_point)
    return "multipliers: per_point, given\n";
  std::string text = s.nodal_law() ? "multipliers: dual" : "multipliers: smoothed";
  if (s.nonsymmetric_nodes())
    text += " with gaps weighted by hat functions";
  if (o.multipliers != Multipliers::automatic)
    return text + ", given\n";
  if (s.nodal_law())
    return text + ", automatic\n";
  const char* key = against_dual(o);
  const char* primary = s.sides.is_poor() ? "a primary so stiff and fine" : "a primary so stiff";
  return text + ", automatic: dual ones do not go with " +
         (key ? "'" + std::string(key) + "'" : primary) + "\n";
}

std::string explain_augmentation(const Settings& s) {
  if (s.augments_at_end())
    return "augmentation: once, at the end of each step\n";
  std::string asked;
  const auto ask = [&](const char* what, double tolerance, const char* unit) {
    if (std::isfinite(tolerance))
      asked += (asked.empty() ? "" : " and ") + (what + number(tolerance)) + unit;
  };
  ask("a change of ", s.change_tolerance, "");
  ask("a penetration of ", s.gap_tolerance, " face sizes");
  ask("a penetration of ", s.length_tolerance, "");
  ask("a penalty error of ", s.error_tolerance, "");
  return "augmentation: " + std::string(s.anderson ? "of several solves" : "of the last solve") +
         ", to " + asked + ", " + std::to_string(s.min_augmentations) + " to " +
         std::to_string(s.max_augmentations) + " times a step\n";
}

std::string explain_start(const ContactOptions& o, const Settings& s) {
  if (s.fits)
    return "fit: interference " + number(s.interference) +
           (o.interference_curve.empty() ? ", growing with t"
                                         : ", over '" + o.interference_curve + "'") +
           ", where the surfaces are within " + number(s.fit_within) + " at the start, " +
           (o.fit_within ? "given\n" : "automatic\n");
  if (s.initial_gap == InitialGap::close)
    return "initial gap: closed up to " + number(s.fit_within) + ", given\n";
  if (s.initial_overlap == InitialOverlap::keep)
    return "";
  return std::string("initial gap: ") +
         (s.initial_gap == InitialGap::round ? "of the round surfaces" : "of the meshes") +
         (o.initial_gap == InitialGap::automatic ? ", automatic\n" : ", given\n");
}

} // namespace

Settings resolve(const ContactOptions& o, const SideComparison& sides) {
  refuse_contradictions(o, sides);
  Settings s;
  s.sides = sides;
  s.name = o.name;
  s.primary = o.primary;
  s.secondary = o.secondary;
  if (o.primary_side == PrimarySide::automatic && sides.prefers_swap()) {
    std::swap(s.primary, s.secondary);
    s.sides.stiffness = 1.0 / sides.stiffness;
    s.sides.size = 1.0 / sides.size;
  }
  s.window = o.window;
  s.formulation = o.formulation;
  s.enforcement = o.enforcement;
  s.tangent = o.tangent;
  s.multipliers = space(o, s.sides);
  s.weighted_gap = o.weighted_gap;
  s.two_pass = o.two_pass;
  s.tension = o.tension;
  s.tied = o.tied;
  s.sticky = o.sticky;
  s.tie_gap = o.tie_gap;
  s.tie_distance = o.tie_distance;
  s.stick_within = o.stick_within;
  s.stick_strength = o.stick_strength.value_or(s.stick_strength);
  set_start(s, o);
  s.points = o.points;
  s.reach = o.reach;
  s.projection_margin = o.projection_margin;
  s.segment_updates = o.segment_updates.value_or(s.segment_updates);
  set_penalty(s, o, sides);
  set_friction(s, o);
  set_augmentation(s, o);
  return s;
}

std::string explain(const ContactOptions& o, const Settings& s) {
  std::string text = "sides: primary '" + s.primary + "', secondary '" + s.secondary + "', ";
  if (o.primary_side == PrimarySide::as_given)
    text += "as given";
  else
    text += s.primary == o.primary ? "automatic: as given" : "automatic: swapped, it is softer";
  text += s.two_pass ? "; both carry points, half the traction each" : "; one pass";
  text += "; the primary is " + number(s.sides.stiffness) + " times as stiff and its faces are " +
          number(s.sides.size) + " times as large\n";
  text += explain_penalty(o, s);
  if (s.augmented())
    text += explain_space(o, s) + explain_augmentation(s);
  text += explain_start(o, s);
  if (s.friction > 0.0)
    text += "friction: mu = " + number(s.friction) + ", map " + word(s.friction_map) +
            (o.friction_map == FrictionMap::automatic ? ", automatic\n" : ", given\n");
  return text;
}

} // namespace abut::contact
