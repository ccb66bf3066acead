// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/deck.hpp"
#include "rule.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

/// The deck, declared once. Filler reads by it, Documenter explains by it, Writer prints by it.
/// Defaults are the initial values of the option structs.
namespace abut::deck {

/// When something holds; `beginning` says what happens first.
template <class V> void describe_window(V& v, Window& o, const std::string& beginning) {
  v.optional("from", o.from,
             ("holds in steps that end after this value of the load parameter" + beginning).c_str(),
             at_least(0.0, "1"));
  v.number_or("until", o.until, "end", "and not after this one", positive("1"));
  v.check("until", !o.until || *o.until > o.from, "expected more than from");
}

template <class V> void describe(V& v, solid::MaterialOptions& o) {
  using solid::MaterialModel;
  v.choice("model", o.model,
           {{"neo_hookean", MaterialModel::neo_hookean, "compressible, finite strain"},
            {"linear_elastic", MaterialModel::linear_elastic, "small strain"},
            {"saint_venant_kirchhoff", MaterialModel::saint_venant_kirchhoff,
             "large rotations, moderate strain; weak in compression"},
            {"holmes_mow", MaterialModel::holmes_mow, "stiffens exponentially"},
            {"mooney_rivlin", MaterialModel::mooney_rivlin, "rubber; hex8 does not lock"},
            {"ogden", MaterialModel::ogden, "rubber, powers of stretches; hex8 does not lock"},
            {"ogden_unconstrained", MaterialModel::ogden_unconstrained,
             "powers of stretches, compressible"}},
           "stress-strain law");
  v.when(o.has_young(), "neo_hookean, linear_elastic, saint_venant_kirchhoff, holmes_mow", [&] {
    v.required("young", o.young, "Young's modulus", positive("pressure"));
    Rule poisson{-1.0, 0.5, true, "1",
                 "at 0.5 the material is incompressible and its bulk modulus infinite, at -1 its "
                 "shear modulus is: come close to a limit, 0.49 say, but do not reach it"};
    v.required("poisson", o.poisson, "Poisson's ratio", poisson);
  });
  v.when(o.model == MaterialModel::holmes_mow, "holmes_mow",
         [&] { v.required("beta", o.beta, "how fast it stiffens", positive("1")); });
  v.when(o.model == MaterialModel::mooney_rivlin, "mooney_rivlin", [&] {
    v.required("c1", o.c1, "of I1 - 3; G = 2 (c1 + c2)", unit("pressure"));
    v.optional("c2", o.c2, "of I2 - 3", unit("pressure"));
    v.check("c1", o.c1 + o.c2 > 0.0, "expected c1 + c2 > 0, which is half the shear modulus");
  });
  v.when(o.has_ogden_terms(), "ogden, ogden_unconstrained", [&] {
    v.required("coefficients", o.coefficients, "c of the terms c/m^2 (l^m - 1); 2 G is their sum",
               unit("pressure"));
    v.required("exponents", o.exponents, "m of the terms, as many and not zero", unit("1"));
    v.check("coefficients", o.coefficients.size() <= o.max_ogden_terms,
            "expected at most " + std::to_string(o.max_ogden_terms) + " terms");
    v.check("exponents", o.exponents.size() == o.coefficients.size(),
            "expected as many as coefficients, which are " + std::to_string(o.coefficients.size()));
    v.check("exponents", std::count(o.exponents.begin(), o.exponents.end(), 0.0) == 0,
            "an exponent must not be zero");
    v.check("coefficients", o.coefficients.empty() || o.shear_modulus() > 0.0,
            "expected a sum > 0, which is twice the shear modulus");
  });
  v.when(o.model == MaterialModel::ogden_unconstrained, "ogden_unconstrained", [&] {
    v.required("lambda", o.lambda, "Lame's constant, of lambda/2 (J - 1)^2",
               at_least(0.0, "pressure"));
  });
  v.when(o.is_uncoupled(), "mooney_rivlin, ogden", [&] {
    v.required("bulk", o.bulk, "K of K/2 (ln J)^2, a thousand times G for rubber",
               positive("pressure"));
  });
  v.optional("density", o.density, "mass per reference volume, for dynamics",
             positive("mass/length^3"));
}

constexpr const char* rigid_components[] = {"x", "y", "z", "rx", "ry", "rz"};

template <class V> void describe(V& v, rigid::HoldOptions& o) {
  std::array<std::optional<double>, 6> given;
  for (std::size_t i = 0; i < 6; ++i)
    if (o.components[i])
      given[i] = o.values[i];
  for (std::size_t i = 0; i < 6; ++i)
    v.optional(rigid_components[i], given[i], "at curve value 1", unit(i < 3 ? "length" : "rad"));
  std::vector<std::string> fixed;
  v.words("fix", fixed, {"x", "y", "z", "rx", "ry", "rz"},
          "components held at zero: 'fix: [x]' means 'x: 0'");
  v.optional("curve", o.curve, "factor over the load parameter; without one, t itself");
  describe_window(v, o.window, "");
  v.optional("relative", o.relative, "counts from where the body is when it begins");
  v.at_least_one({"x", "y", "z", "rx", "ry", "rz", "fix"});

  for (std::size_t i = 0; i < 6; ++i) {
    const bool is_fixed = std::find(fixed.begin(), fixed.end(), rigid_components[i]) != fixed.end();
    v.check("fix", !is_fixed || !given[i],
            std::string("component '") + rigid_components[i] + "' is prescribed twice");
    o.components[i] = is_fixed || given[i].has_value();
    o.values[i] = given[i].value_or(0.0);
  }
}

template <class V> void describe(V& v, rigid::MotionOptions& o) {
  constexpr auto& components = rigid_components;
  v.optional("displacement", o.displacement, "at curve value 1", unit("length"));
  v.optional("rotation", o.rotation, "rotation vector at curve value 1", unit("rad"));
  v.optional("center", o.center, "point of the reference configuration to rotate about",
             unit("length"));
  v.optional("curve", o.curve, "factor over the load parameter; without one, t itself");
  v.group("curves", "of single components, instead of 'curve'", [&](auto& w) {
    for (std::size_t i = 0; i < 6; ++i)
      w.optional(components[i], o.curves[i], "factor over the load parameter");
  });
  std::vector<std::string> free;
  for (std::size_t i = 0; i < 6; ++i)
    if (o.free[i])
      free.push_back(components[i]);
  v.words("free", free, {"x", "y", "z", "rx", "ry", "rz"},
          "components of displacement and rotation that are unknowns; the others are prescribed");
  v.named_map("holds", o.holds, "when free components are prescribed all the same, by name");
  v.optional("force", o.force, "on the center, where components are free", unit("force"));
  v.optional("moment", o.moment, "about the center, where components are free",
             unit("force length"));
  v.optional("follower", o.follower, "force and moment turn with the body");
  v.optional("load_curve", o.load_curve,
             "factor of force and moment over the load parameter; without one, t itself");
  v.group("load_curves", "of single components of force and moment, instead of 'load_curve'",
          [&](auto& w) {
            for (std::size_t i = 0; i < 6; ++i)
              w.optional(components[i], o.load_curves[i], "factor over the load parameter");
          });
  v.optional("density", o.density, "of its blocks, for dynamics", positive("mass/length^3"));
  v.optional("mass", o.mass, "at the center, instead of density", positive("mass"));
  v.optional("moments_of_inertia", o.moments_of_inertia,
             "about axes x, y, z through the center, beside mass", unit("mass length^2"));
  v.optional("products_of_inertia", o.products_of_inertia,
             "minus the integrals of xy, yz, zx over the mass", unit("mass length^2"));
  v.check("mass", !o.mass || !o.density, "only one of the keys mass, density is allowed");

  for (std::size_t i = 0; i < 6; ++i)
    o.free[i] = std::find(free.begin(), free.end(), components[i]) != free.end();
  for (std::size_t i = 0; i < 6; ++i) {
    const bool turns = i >= 3;
    v.check(turns ? "rotation" : "displacement",
            !o.free[i] || (turns ? o.rotation[i - 3] : o.displacement[i]) == 0.0,
            std::string("component '") + components[i] + "' is prescribed here and listed as free");
  }
  for (const rigid::HoldOptions& hold : o.holds)
    for (std::size_t i = 0; i < 6; ++i)
      v.check("holds", !hold.components[i] || o.free[i],
              "'" + hold.name + "' holds component '" + components[i] +
                  "', which is prescribed always; list it under 'free'");
  constexpr std::array<double, 3> none{};
  for (const char* key : {"force", "moment"})
    v.check(key, o.has_unknowns() || (key[0] == 'f' ? o.force : o.moment) == none,
            "the motion is prescribed, so a load moves nothing; list what may move under 'free'");
}

template <class V> void describe(V& v, rigid::JointOptions& o) {
  using rigid::JointKind;
  v.required_choice(
      "kind", o.kind,
      {{"revolute", JointKind::revolute, "turns about its axis"},
       {"prismatic", JointKind::prismatic, "slides along its axis"},
       {"cylindrical", JointKind::cylindrical, "turns about and slides along its axis"},
       {"spherical", JointKind::spherical, "turns about its origin"},
       {"lock", JointKind::lock, "the bodies move as one"},
       {"spring", JointKind::spring, "linear, between a point of each body"}},
      "what the bodies may do against each other");
  v.required("bodies", o.bodies, "two rigid bodies, or one and 'ground', which never moves");
  v.when(o.kind != JointKind::spring, "revolute, prismatic, cylindrical, spherical, lock", [&] {
    v.required("origin", o.origin, "point of both bodies in the reference configuration",
               unit("length"));
  });
  v.when(o.turns() || o.slides(), "revolute, prismatic, cylindrical", [&] {
    v.required("axis", o.axis, "in the reference configuration; its length does not matter",
               unit("1"));
  });
  v.when(o.turns(), "revolute, cylindrical", [&] {
    v.optional("rotation", o.rotation,
               "of the second body against the first about the axis; free when not given",
               unit("rad"));
    v.optional("moment", o.moment, "on the second body about the axis, minus it on the first",
               unit("force length"));
  });
  v.when(o.slides(), "prismatic, cylindrical", [&] {
    v.optional("translation", o.translation,
               "of the second body against the first along the axis; free when not given",
               unit("length"));
    v.optional("force", o.force, "on the second body along the axis, minus it on the first",
               unit("force"));
  });
  v.when(o.kind == JointKind::spherical, "spherical", [&] {
    v.optional("rotation_vector", o.rotation_vector,
               "of the second body against the first, in directions that turn with the first; free "
               "when not given",
               unit("rad"));
    v.optional("moment_vector", o.moment_vector,
               "on the second body, minus it on the first; fixed in space", unit("force length"));
  });
  v.when(o.turns() || o.slides() || o.kind == JointKind::spherical,
         "revolute, prismatic, cylindrical, spherical", [&] {
           v.optional(
               "curve", o.curve,
               "factor of rotation and translation over the load parameter; without one, t itself");
           v.optional("load_curve", o.load_curve,
                      "factor of moment and force over the load parameter; without one, t itself");
         });
  v.when(o.kind == JointKind::spring, "spring", [&] {
    v.required("from", o.from, "point of the first body in the reference configuration",
               unit("length"));
    v.required("to", o.to, "point of the second body in the reference configuration",
               unit("length"));
    v.required("stiffness", o.stiffness, "force over elongation", positive("force/length"));
    v.optional("free_length", o.free_length, "without force; when not given, from 'from' to 'to'",
               at_least(0.0, "length"));
  });
  v.check("moment_vector", !o.rotation_vector || !o.moment_vector,
          "the rotation is prescribed, so a moment moves nothing");
  v.check("moment", !o.rotation || !o.moment,
          "the rotation is prescribed, so a moment moves nothing");
  v.check("force", !o.translation || !o.force,
          "the translation is prescribed, so a force moves nothing");
}

template <class V> void describe(V& v, scene::BodyOptions& o) {
  v.optional("blocks", o.blocks, "element blocks of the mesh, by name or number");
  v.optional("node_sets", o.node_sets,
             "nodes that move with a rigid body, of other bodies' elements too");
  v.at_least_one({"blocks", "node_sets"});
  v.alternative("material", !o.rigid,
                [&] { v.required("material", o.material, "name under materials"); });
  v.alternative("rigid", o.rigid, [&] {
    o.rigid = true;
    v.group("rigid", "nodes that move as one, and how they move; {} stands still",
            [&](auto& w) { describe(w, o.motion); });
  });
  v.optional("initial_velocity", o.initial_velocity, "for dynamics; of a rigid body, of its center",
             unit("length/time"));
  v.optional("initial_angular_velocity", o.initial_angular_velocity,
             "for dynamics, about its center of mass; of a rigid body, about its center",
             unit("rad/time"));
  v.check("node_sets", o.rigid || o.node_sets.empty(),
          "only a rigid body takes nodes; a deformable one consists of blocks");
}

template <class V> void describe(V& v, scene::DisplacementOptions& o) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::array<std::optional<Amount>, 3> given;
  for (std::size_t i = 0; i < 3; ++i)
    if (o.components[i])
      given[i] = o.values[i];

  v.required("set", o.set, "node set, or side set (all its nodes)");
  for (std::size_t i = 0; i < 3; ++i)
    v.optional(axes[i], given[i], "displacement in this direction; free when not given",
               unit("length"));
  std::vector<std::string> fixed;
  v.words("fix", fixed, {"x", "y", "z"}, "directions held at zero: 'fix: [x]' means 'x: 0'");
  v.optional("curve", o.curve, "factor over the load parameter; without one, t itself");
  describe_window(v, o.window, "; else the nodes are free, unless another entry holds them");
  v.optional("relative", o.relative, "counts from where the nodes are when it begins");
  v.at_least_one({"x", "y", "z", "fix"});

  for (const std::string& axis : fixed) {
    std::optional<Amount>& component = given[static_cast<std::size_t>(axis[0] - 'x')];
    v.check("fix", !component, "direction '" + axis + "' is prescribed twice");
    component = 0.0;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    o.components[i] = given[i].has_value();
    o.values[i] = given[i].value_or(Amount());
  }
}

template <class V> void describe(V& v, solid::LoadOptions& o) {
  using solid::LoadKind;
  const auto kind = [&](const char* key, LoadKind kind, auto fields) {
    v.alternative(key, o.kind == kind, [&, kind] {
      o.kind = kind;
      fields();
    });
  };
  kind("traction", LoadKind::traction, [&] {
    v.required("traction", o.vector, "dead force per reference area", unit("pressure"));
    v.required("side_set", o.place, "where a traction or a pressure acts");
    v.optional("current_area", o.current_area, "the traction is per current area instead");
  });
  kind("pressure", LoadKind::pressure, [&] {
    v.required("pressure", o.pressure, "per current area, follows the surface; > 0 pushes inwards",
               unit("pressure"));
    v.required("side_set", o.place, "where a traction or a pressure acts");
  });
  kind("body_force", LoadKind::body_force, [&] {
    v.required("body_force", o.vector, "dead force per reference volume", unit("force/length^3"));
    v.required("block", o.place, "where a body force acts");
  });
  kind("force", LoadKind::force, [&] {
    v.required("force", o.vector, "dead force on each node of the set", unit("force"));
    v.required("node_set", o.place, "where a force acts");
  });
  v.optional("curve", o.curve, "factor over the load parameter; without one, t itself");
}

template <class V> void describe(V& v, contact::ContactOptions& o) {
  using contact::Enforcement;
  using contact::Formulation;
  v.required("primary", o.primary, "side set that carries the integration points");
  v.required("secondary", o.secondary, "side set that is projected on");
  using contact::PrimarySide;
  v.choice("primary_side", o.primary_side,
           {{"as_given", PrimarySide::as_given, "primary and secondary as the deck names them"},
            {"automatic", PrimarySide::automatic,
             "the softer surface becomes the primary, whichever way they are named"}},
           "which surface carries the points; check tells how the sides compare");
  v.choice("formulation", o.formulation,
           {{"node_on_facet", Formulation::node_on_facet,
             "points at the primary nodes, closest point on the secondary faces"},
            {"facet_on_facet", Formulation::facet_on_facet,
             "Gauss points, closest point on the secondary faces, along their normal"},
            {"sliding_elastic", Formulation::sliding_elastic,
             "Gauss points, ray along the primary normal, current area"}},
           "how partners are found and the gap is measured");
  v.choice("enforcement", o.enforcement,
           {{"penalty", Enforcement::penalty, "pressure grows with penetration"},
            {"augmented_lagrangian", Enforcement::augmented_lagrangian,
             "penalty plus multipliers, updated outside Newton"}},
           "how penetration is resisted");
  using contact::Multipliers;
  v.choice("multipliers", o.multipliers,
           {{"automatic", Multipliers::automatic,
             "dual; smoothed with a primary that is stiff and fine and where dual does not go"},
            {"per_point", Multipliers::per_point,
             "one at each integration point: the theory; its pressures oscillate"},
            {"smoothed", Multipliers::smoothed,
             "at the corner nodes of the primary, read by its points"},
            {"dual", Multipliers::dual,
             "at the corner nodes of the primary, which hold the law of weighted gaps"}},
           "where the multipliers of augmented_lagrangian live");
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
  v.optional("offset", o.offset, "gap that counts as closed", unit("length"));
  using contact::InitialOverlap;
  v.choice("initial_overlap", o.initial_overlap,
           {{"keep", InitialOverlap::keep, "resolved at once"},
            {"resolve", InitialOverlap::resolve, "pushed out while t rises to its end"},
            {"adjust", InitialOverlap::adjust, "counts as no overlap: strain free"}},
           "what becomes of an overlap of the meshes");
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
              "searches in a solve after which partners stay", at_least(1.0, "1"));
  v.number_or("multiplier_tolerance", o.multiplier_tolerance, "automatic",
              "augmentation stops at this relative change of the multipliers; automatic: 1e-2, not "
              "asked of dual ones",
              positive("1"));
  v.number_or("gap_tolerance", o.gap_tolerance, "automatic",
              "augmentation also asks for this largest penetration, in face sizes; automatic: not "
              "asked, but 1e-3 of dual multipliers without another tolerance",
              positive("1"));
  v.number_or("gap_limit", o.gap_limit, "none",
              "augmentation also asks for this largest penetration", positive("length"));
  v.optional("min_augmentations", o.min_augmentations, "at least so many, each step",
             at_least(0.0, "1"));
  v.optional("max_augmentations", o.max_augmentations, "at most so many, each step",
             Rule{1.0, Rule::infinity, false, "1",
                  "for multipliers that change once, at the end of each step, write 'uzawa: "
                  "end_of_step'"});
  v.check("min_augmentations", o.min_augmentations <= o.max_augmentations,
          "more than max_augmentations, which is " + std::to_string(o.max_augmentations));
}

template <class V> void describe(V& v, solver::TimeOptions& o) {
  v.optional("end", o.end, "the load parameter t runs from 0 to here", positive("1"));
  v.optional("steps", o.steps, "equal steps to start with", at_least(1.0, "1"));
  v.optional("adaptive", o.adaptive, "cut a failed step and grow again after it");
  v.optional("min_fraction", o.min_fraction, "smallest step as a fraction of end/steps",
             Rule{1e-12, 1.0, false, "1", ""});
  v.optional("max_cuts", o.max_cuts, "in a row, on one step", at_least(0.0, "1"));
  v.optional("target_iterations", o.target_iterations,
             "Newton iterations of a step that keeps its size", at_least(1.0, "1"));
}

template <class V> void describe(V& v, solver::DynamicsOptions& o) {
  v.optional("spectral_radius", o.spectral_radius,
             "what a step leaves of vibrations too fast for it; 1: all of them, the trapezoidal "
             "rule; below 1: generalised-alpha",
             Rule{0.0, 1.0, false, "1", ""});
  v.optional("beta", o.beta, "Newmark's, instead of spectral_radius", positive("1"));
  v.optional("gamma", o.gamma, "Newmark's, at least 0.5 and at most 2 beta",
             Rule{0.5, 1.0, false, "1", ""});
  for (const char* key : {"beta", "gamma"})
    v.check(key, o.spectral_radius == 1.0 || !(key[0] == 'b' ? o.beta : o.gamma),
            "spectral_radius below 1 gives beta and gamma");
  v.check(o.beta ? "beta" : "gamma", 2.0 * o.beta.value_or(0.25) >= o.gamma.value_or(0.5),
          "steps of any length are stable with 2 beta >= gamma >= 0.5");
}

template <class V> void describe(V& v, solver::NewtonOptions& o) {
  using solver::LineSearch;
  v.optional("tolerance", o.tolerance, "residual over reference force", positive("1"));
  v.number_or("displacement_tolerance", o.displacement_tolerance, "none",
              "a solve also ends when the last correction is at most this share of the step's "
              "increment, and its energy within energy_tolerance",
              positive("1"));
  v.optional("energy_tolerance", o.energy_tolerance,
             "with displacement_tolerance: the work left over the largest of the step",
             positive("1"));
  v.optional("max_iterations", o.max_iterations, "of one solve", at_least(1.0, "1"));
  v.choice("line_search", o.line_search,
           {{"automatic", LineSearch::automatic, "shorten a step that makes things worse"},
            {"none", LineSearch::none, "full Newton steps"}},
           "of the Newton step");
  v.optional("inexact", o.inexact,
             "without friction, solves that an augmentation will follow stop early");
}

template <class V> void describe(V& v, solver::LinearOptions& o) {
  using solver::LinearMethod;
  using solver::Preconditioner;
  v.choice("method", o.method,
           {{"automatic", LinearMethod::automatic, "direct up to direct_limit, Krylov beyond"},
            {"direct", LinearMethod::direct, "MUMPS"},
            {"krylov", LinearMethod::krylov, "Belos: CG if symmetric, GMRES otherwise"}},
           "of the linear systems");
  v.optional("direct_limit", o.direct_limit, "unknowns up to which automatic means direct",
             at_least(0.0, "1"));
  v.choice("preconditioner", o.preconditioner,
           {{"automatic", Preconditioner::automatic, "abut's choice"},
            {"muelu", Preconditioner::muelu, "algebraic multigrid"},
            {"ilu", Preconditioner::ilu, "Ifpack2 incomplete factors"}},
           "of a Krylov solve");
  v.optional("tolerance", o.tolerance, "relative residual of a Krylov solve", positive("1"));
  v.optional("max_iterations", o.max_iterations, "of a Krylov solve", at_least(1.0, "1"));
}

template <class V> void describe(V& v, io::OutputOptions& o) {
  using io::Files;
  v.optional("name", o.name, "file name without folder and extension; empty: the deck's name");
  v.check("name", o.name.find('/') == std::string::npos,
          "expected a file name without folders; --output-dir gives the folder");
  v.choice("files", o.files,
           {{"automatic", Files::automatic, "one up to 200,000 nodes or on one rank"},
            {"one", Files::one, "one file"},
            {"per_rank", Files::per_rank, "one file for each rank"}},
           "how results are split into files");
  v.optional("points", o.points, "write a table of all contact points, NAME.points.csv");
  v.optional("every", o.every, "write every n-th converged step; the last one always",
             at_least(1.0, "1"));
}

template <class V> void describe(V& v, VerifyOptions& o) {
  v.required_choice(
      "quantity", o.quantity,
      {{"force_x", Quantity::force_x, "contact force on the primary side"},
       {"force_y", Quantity::force_y},
       {"force_z", Quantity::force_z},
       {"max_pressure", Quantity::max_pressure, "of a contact interface"},
       {"max_penetration", Quantity::max_penetration, "of a contact interface"},
       {"active_points", Quantity::active_points, "of a contact interface"},
       {"stick_points", Quantity::stick_points, "of a contact interface"},
       {"slip_points", Quantity::slip_points, "of a contact interface"},
       {"max_slip", Quantity::max_slip, "longest way slipped at a contact interface"},
       {"friction_dissipation", Quantity::friction_dissipation,
        "energy lost at a contact interface"},
       {"contact_radius", Quantity::contact_radius,
        "of a contact interface round the z axis, by regression of p^2 over r^2"},
       {"displacement_x", Quantity::displacement_x, "at a point or mean over a set"},
       {"displacement_y", Quantity::displacement_y},
       {"displacement_z", Quantity::displacement_z},
       {"reaction_x", Quantity::reaction_x, "sum over a set"},
       {"reaction_y", Quantity::reaction_y},
       {"reaction_z", Quantity::reaction_z},
       {"newton_iterations", Quantity::newton_iterations, "of the whole run"},
       {"rigid_displacement_x", Quantity::rigid_displacement_x, "of the center of a rigid body"},
       {"rigid_displacement_y", Quantity::rigid_displacement_y},
       {"rigid_displacement_z", Quantity::rigid_displacement_z},
       {"rigid_rotation_x", Quantity::rigid_rotation_x,
        "of the rotation vector of a rigid body, in rad, whole turns counted"},
       {"rigid_rotation_y", Quantity::rigid_rotation_y},
       {"rigid_rotation_z", Quantity::rigid_rotation_z},
       {"rigid_force_x", Quantity::rigid_force_x,
        "that holds the prescribed components of a rigid body; 0 for free ones"},
       {"rigid_force_y", Quantity::rigid_force_y},
       {"rigid_force_z", Quantity::rigid_force_z},
       {"rigid_moment_x", Quantity::rigid_moment_x, "about the current center, as rigid_force"},
       {"rigid_moment_y", Quantity::rigid_moment_y},
       {"rigid_moment_z", Quantity::rigid_moment_z},
       {"joint_force_x", Quantity::joint_force_x, "of a joint's first body on its second"},
       {"joint_force_y", Quantity::joint_force_y},
       {"joint_force_z", Quantity::joint_force_z},
       {"joint_moment_x", Quantity::joint_moment_x, "the same, about the joint"},
       {"joint_moment_y", Quantity::joint_moment_y},
       {"joint_moment_z", Quantity::joint_moment_z},
       {"joint_translation", Quantity::joint_translation,
        "along a joint's axis; of a spring, its elongation"},
       {"joint_rotation", Quantity::joint_rotation,
        "about a joint's axis, in rad, whole turns counted"}},
      "what is compared, at the end of the run");
  v.optional("place", o.place, "contact interface, rigid body, joint, node set or side set");
  v.optional("point", o.point, "reference coordinates", unit("length"));
  v.required("expected", o.expected, "the value");
  v.optional("tolerance", o.tolerance, "allowed error, absolute", at_least(0.0));
  v.optional("relative_tolerance", o.relative_tolerance, "allowed error over |expected|",
             at_least(0.0, "1"));
  v.at_least_one({"tolerance", "relative_tolerance"});
  v.optional("source", o.source, "where the expected value comes from");
}

template <class V> void describe(V& v, MeshOptions& o) {
  v.alternative("file", o.kind.empty(),
                [&] { v.required("file", o.file, "Exodus file, its path relative to the deck"); });
  v.alternative("generate", !o.kind.empty(), [&] {
    v.generator("generate", o, "'kind' and the options that 'abut mesh KIND' takes");
  });
}

template <class V> void describe(V& v, Deck& o) {
  const auto section = [&](const char* key, auto& options, const char* doc) {
    v.group(key, doc, [&](auto& w) { describe(w, options); });
  };
  v.optional("title", o.title, "free text");
  v.required_group("mesh", "where the mesh comes from", [&](auto& w) { describe(w, o.mesh); });
  v.named_map("materials", o.materials, "materials by name");
  v.named_map("bodies", o.bodies, "what the blocks of the mesh are made of, and rigid bodies",
              true);
  v.named_map("joints", o.joints, "what connects rigid bodies");
  v.named_map("displacements", o.displacements, "prescribed displacements");
  v.named_map("loads", o.loads, "external loads");
  v.curve_map("curves", o.curves,
              "factors over the load parameter, linear between points, constant beyond the ends");
  v.named_map("contact", o.contact, "contact interfaces");
  section("time", o.time, "load steps");
  v.optional_group("dynamics", o.dynamics.active,
                   "inertia, t being the time; {} is the trapezoidal rule; without this key the "
                   "scene is quasi-static",
                   [&](auto& w) { describe(w, o.dynamics); });
  section("newton", o.newton, "nonlinear solves");
  section("linear_solver", o.linear, "linear solves");
  section("output", o.output, "results on disk");
  v.group("trilinos", "Trilinos parameter lists, merged over abut's own", [&](auto& w) {
    w.trilinos_list("NOX", o.newton.nox, "nonlinear solver");
    w.trilinos_list("Belos", o.linear.belos, "Krylov solver");
    w.trilinos_list("MueLu", o.linear.muelu, "algebraic multigrid");
    w.trilinos_list("Ifpack2", o.linear.ifpack2, "incomplete factors");
  });
  v.choice("check", o.check,
           {{"none", ModelCheck::none},
            {"tangent", ModelCheck::tangent,
             "after every solve, each part's tangent against differences of its forces"}},
           "what a run tests of its own model");
  v.named_map("verify", o.verify, "what the deck expects of its own results");
}

} // namespace abut::deck
