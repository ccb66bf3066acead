// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/options.hpp"
#include "describe/window.hpp"

namespace abut::deck {

/// Sides, and how partners are found on them.
template <class V> void describe_surfaces(V& v, contact::ContactOptions& o) {
  v.required("primary", o.primary, "side set that carries the integration points");
  v.required("secondary", o.secondary, "side set that is projected on");
  using contact::PrimarySide;
  v.choice("primary_side", o.primary_side,
           {{"as_given", PrimarySide::as_given, "primary and secondary as the deck names them"},
            {"automatic", PrimarySide::automatic,
             "the softer surface becomes the primary, whichever way they are named"}},
           "which surface carries the points; check tells how the sides compare");
  using contact::Formulation;
  v.choice("formulation", o.formulation,
           {{"node_on_facet", Formulation::node_on_facet,
             "points at the primary nodes, closest point on the secondary faces"},
            {"facet_on_facet", Formulation::facet_on_facet,
             "Gauss points, closest point on the secondary faces, along their normal"},
            {"sliding_elastic", Formulation::sliding_elastic,
             "Gauss points, ray along the primary normal, current area"}},
           "how partners are found and the gap is measured");
}

/// Penalty and multipliers.
template <class V> void describe_enforcement(V& v, contact::ContactOptions& o) {
  using contact::Enforcement;
  v.choice("enforcement", o.enforcement,
           {{"penalty", Enforcement::penalty, "pressure grows with penetration"},
            {"augmented_lagrangian", Enforcement::augmented_lagrangian,
             "penalty plus multipliers, updated outside Newton"}},
           "how penetration is resisted");
  using contact::Multipliers;
  v.choice("multipliers", o.multipliers,
           {{"automatic", Multipliers::automatic,
             "dual; smoothed with a primary that is stiff and fine, or more than 10 times as "
             "stiff, and where dual does not go"},
            {"per_point", Multipliers::per_point,
             "one at each integration point: the theory; its pressures oscillate"},
            {"smoothed", Multipliers::smoothed,
             "at the corner nodes of the primary, read by its points"},
            {"dual", Multipliers::dual,
             "at the corner nodes of the primary, which hold the law of weighted gaps"}},
           "where the multipliers of augmented_lagrangian live");
  using contact::WeightedGap;
  v.choice("weighted_gap", o.weighted_gap,
           {{"dual", WeightedGap::dual,
             "the functions of the tractions, partly negative: symmetric without friction"},
            {"hat", WeightedGap::hat,
             "never negative: no open gap presses, first steps onto round bodies converge; the "
             "edge of contact is softer"}},
           "what gap and slip of a node are averaged with, multipliers: dual only");
  using contact::AugmentationRule;
  v.choice("augmentation", o.augmentation,
           {{"automatic", AugmentationRule::automatic,
             "anderson for smoothed and dual multipliers, plain at points"},
            {"plain", AugmentationRule::plain, "of the last solve"},
            {"anderson", AugmentationRule::anderson,
             "of the last few solves, so that what they leave cancels best; without friction"}},
           "what the next multipliers are made of");
  using contact::Uzawa;
  v.choice(
      "uzawa", o.uzawa,
      {{"nested", Uzawa::nested, "after each solve of a step, until the tolerances hold"},
       {"end_of_step", Uzawa::end_of_step, "once, at the end of each step, without another solve"}},
      "when multipliers change");
  v.number_or("penalty_factor", o.penalty_factor, "automatic",
              "f in eps = f E_n A / V, without penalty; automatic: 10; augmented_lagrangian with "
              "dual multipliers 30, with smoothed ones 3 or what gap_tolerance asks for between 1 "
              "and 10",
              positive("1"));
  v.number_or("penalty", o.penalty, "automatic", "eps itself; automatic: by penalty_factor",
              positive("pressure/length"));
  v.optional("penalty_curve", o.penalty_curve, "factor on the penalty over the load parameter");
  v.optional("update_penalty", o.update_penalty,
             "take A of the automatic penalty from the last converged step");
}

/// Coulomb's law.
template <class V> void describe_friction(V& v, contact::ContactOptions& o) {
  v.optional("friction", o.friction, "Coulomb's coefficient mu", at_least(0.0, "1"));
  v.optional("friction_curve", o.friction_curve, "factor on mu over the load parameter");
  using contact::FrictionMap;
  v.choice("friction_map", o.friction_map,
           {{"automatic", FrictionMap::automatic,
             "inclined_ray for sliding_elastic, incremental for the others"},
            {"inclined_ray", FrictionMap::inclined_ray,
             "stick against an anchor, slip along a ray inclined by the friction angle"},
            {"incremental", FrictionMap::incremental,
             "radial return of the last traction plus the step's slip"},
            {"literal", FrictionMap::literal, "the printed theory, for comparison"}},
           "how the tangential traction follows from the motion");
  using contact::FrictionSwitching;
  v.choice("friction_switching", o.friction_switching,
           {{"primal_dual", FrictionSwitching::primal_dual,
             "by the last iterate's traction and a soft spring: does not cycle"},
            {"return_map", FrictionSwitching::return_map, "as stiff as the penalty"}},
           "how Newton decides between stick and slip; where it ends is the same");
}

/// The second pass and ties.
template <class V> void describe_ties(V& v, contact::ContactOptions& o) {
  v.optional("two_pass", o.two_pass,
             "both sides carry points, each half of the traction; the other side's numbers are "
             "those of NAME_second_pass");
  v.optional("tension", o.tension, "points in contact may pull");
  v.optional("tied", o.tied, "points close to their partner at the start stay there");
  v.optional("tie_distance", o.tie_distance, "what is close for tied, in face sizes",
             positive("1"));
  using contact::TieGap;
  v.choice("tie_gap", o.tie_gap,
           {{"keep", TieGap::keep, "it strains nothing"},
            {"close", TieGap::close, "the point is pulled on its partner"}},
           "what becomes of the distance between tied surfaces");
  v.optional("sticky", o.sticky, "points that overlap are tied from the end of the step on");
  v.optional("stick_within", o.stick_within, "gap up to which sticky points get hold too",
             at_least(0.0, "length"));
  v.number_or("stick_strength", o.stick_strength, "unlimited",
              "tension along the normal beyond which sticky points come off", positive("pressure"));
}

/// What the gap at the start counts from.
template <class V> void describe_start(V& v, contact::ContactOptions& o) {
  v.optional("offset", o.offset, "gap that counts as closed: half a shell", unit("length"));
  using contact::InitialOverlap;
  v.choice("initial_overlap", o.initial_overlap,
           {{"keep", InitialOverlap::keep, "resolved at once, as an offset is"},
            {"resolve", InitialOverlap::resolve,
             "pushed out while t rises to its end, and an offset with it"},
            {"adjust", InitialOverlap::adjust,
             "counts as no overlap: strain free; an offset presses at once"}},
           "what becomes of an overlap of the meshes");
  using contact::InitialGap;
  v.choice("initial_gap", o.initial_gap,
           {{"automatic", InitialGap::automatic, "round, but mesh with initial_overlap: keep"},
            {"mesh", InitialGap::mesh, "of the faces as they are"},
            {"round", InitialGap::round,
             "of the round surfaces that four-cornered flat faces stand for; for fits that slide "
             "little"},
            {"close", InitialGap::close,
             "of the faces, but what is open by no more than fit_within counts as touching: strain "
             "free"}},
           "what gaps and overlaps at the start are measured between");
  v.number_or("interference", o.interference, "none",
              "by how much the surfaces press into each other where they are near at the start, "
              "whatever gap or overlap the meshes have there; grows with t; < 0: a clearance",
              unit("length"));
  v.optional("interference_curve", o.interference_curve,
             "factor on the interference over the load parameter, in place of the growth with t");
  v.number_or(
      "fit_within", o.fit_within, "automatic",
      "gap or overlap at the start up to which surfaces are near, for interference and "
      "initial_gap: close, which wants it given; automatic: the interference and a tenth of "
      "the faces of both sides",
      positive("length"));
}

/// When and where the law is evaluated.
template <class V> void describe_evaluation(V& v, contact::ContactOptions& o) {
  using contact::Tangent;
  v.choice("tangent", o.tangent,
           {{"analytic", Tangent::analytic, "closed form"},
            {"automatic", Tangent::automatic, "automatic differentiation; slow"},
            {"symmetric", Tangent::symmetric, "symmetric part, for a symmetric solver"}},
           "derivative of the contact forces");
  describe_window(v, o.window, "; its first partners are those of the step before");
  v.number_or("points", o.points, "automatic",
              "integration points per direction; automatic: 2 on linear faces, 3 on quadratic ones",
              Rule{1.0, 6.0, false, "1", ""});
  v.optional("reach", o.reach, "how far a partner is sought, in sizes of the larger face",
             positive("1"));
  v.optional("projection_margin", o.projection_margin,
             "how far outside a face a projection still counts, in face coordinates",
             at_least(0.0, "1"));
  v.number_or("segment_updates", o.segment_updates, "unlimited",
              "searches in a step after which partners stay", at_least(1.0, "1"));
}

/// When augmentation stops.
template <class V> void describe_augmentation(V& v, contact::ContactOptions& o) {
  v.number_or("multiplier_tolerance", o.multiplier_tolerance, "automatic",
              "augmentation stops at this relative change of the multipliers; automatic: 1e-2, not "
              "asked of dual ones",
              positive("1"));
  v.number_or("gap_tolerance", o.gap_tolerance, "automatic",
              "augmentation also asks for this largest penetration, in face sizes; automatic: not "
              "asked, but 1e-3 of dual multipliers without another tolerance, and then no more "
              "than costs 1e-3 of the bodies' energy",
              positive("1"));
  v.number_or("gap_limit", o.gap_limit, "none",
              "augmentation also asks for this largest penetration", positive("length"));
  v.optional("min_augmentations", o.min_augmentations, "at least so many, each step",
             at_least(0.0, "1"));
  v.optional("max_augmentations", o.max_augmentations, "at most so many, each step",
             Rule{1.0, Rule::infinity, false, "1",
                  "for multipliers that change once, at the end of each step, write 'uzawa: "
                  "end_of_step'"});
}

template <class V> void describe(V& v, contact::ContactOptions& o) {
  describe_surfaces(v, o);
  describe_enforcement(v, o);
  describe_friction(v, o);
  describe_ties(v, o);
  describe_start(v, o);
  describe_evaluation(v, o);
  describe_augmentation(v, o);
}

} // namespace abut::deck
