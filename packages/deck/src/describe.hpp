// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/deck.hpp"
#include "rule.hpp"

#include <array>
#include <optional>
#include <string>

/// The deck, declared once. Filler reads by it, Documenter explains by it, Writer prints by it.
/// Defaults are the initial values of the option structs.
namespace abut::deck {

template <class V> void describe(V& v, solid::MaterialOptions& o) {
  using solid::MaterialModel;
  v.choice("model", o.model,
           {{"neo_hookean", MaterialModel::neo_hookean, "compressible, finite strain"},
            {"linear_elastic", MaterialModel::linear_elastic, "small strain"}},
           "stress-strain law");
  v.required("young", o.young, "Young's modulus", positive("pressure"));
  Rule poisson{-1.0, 0.5, true, "1",
               "at 0.5 the material is incompressible and its bulk modulus infinite, at -1 its "
               "shear modulus is: come close to a limit, 0.49 say, but do not reach it"};
  v.required("poisson", o.poisson, "Poisson's ratio", poisson);
}

template <class V> void describe(V& v, solid::RigidMotion& o) {
  v.optional("displacement", o.displacement, "at curve value 1", unit("length"));
  v.optional("rotation", o.rotation, "rotation vector at curve value 1", unit("rad"));
  v.optional("center", o.center, "point of the reference configuration to rotate about",
             unit("length"));
  v.optional("curve", o.curve, "factor over the load parameter; without one, t itself");
}

template <class V> void describe(V& v, solid::BodyOptions& o) {
  v.required("blocks", o.blocks, "element blocks of the mesh, by name or number");
  v.alternative("material", !o.rigid,
                [&] { v.required("material", o.material, "name under materials"); });
  v.alternative("rigid", o.rigid, [&] {
    o.rigid = true;
    v.group("rigid", "an obstacle without unknowns, and how it moves; {} stands still",
            [&](auto& w) { describe(w, o.motion); });
  });
}

template <class V> void describe(V& v, solid::DisplacementOptions& o) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::array<std::optional<double>, 3> given;
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
  v.at_least_one({"x", "y", "z", "fix"});

  for (const std::string& axis : fixed) {
    std::optional<double>& component = given[static_cast<std::size_t>(axis[0] - 'x')];
    v.check("fix", !component, "direction '" + axis + "' is prescribed twice");
    component = 0.0;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    o.components[i] = given[i].has_value();
    o.values[i] = given[i].value_or(0.0);
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
  v.choice("formulation", o.formulation,
           {{"facet_on_facet", Formulation::facet_on_facet,
             "closest point on the secondary faces, along their normal"}},
           "how partners are found and the gap is measured");
  v.choice("enforcement", o.enforcement,
           {{"penalty", Enforcement::penalty, "pressure grows with penetration"},
            {"augmented_lagrangian", Enforcement::augmented_lagrangian,
             "penalty plus multipliers, updated outside Newton"}},
           "how penetration is resisted");
  v.optional("penalty_factor", o.penalty_factor, "f in eps = f E_n A / V, when penalty is 0",
             positive("1"));
  v.optional("penalty", o.penalty, "eps itself; 0: automatic", at_least(0.0, "pressure/length"));
  v.optional("points", o.points,
             "integration points per direction; 0: 2 on linear faces, 3 on quadratic ones",
             Rule{0.0, 6.0, false, "1", ""});
  v.optional("reach", o.reach, "how far a partner is sought, in sizes of the larger face",
             positive("1"));
  v.optional("projection_margin", o.projection_margin,
             "how far outside a face a projection still counts, in face coordinates",
             at_least(0.0, "1"));
  v.optional("multiplier_tolerance", o.multiplier_tolerance,
             "augmentation stops at this relative change of the multipliers", positive("1"));
  v.optional("gap_tolerance", o.gap_tolerance,
             "augmentation also asks for this largest penetration, in face sizes; 0: it does not",
             at_least(0.0, "1"));
  v.optional("min_augmentations", o.min_augmentations, "at least so many, each step",
             at_least(0.0, "1"));
  v.optional("max_augmentations", o.max_augmentations, "at most so many, each step",
             at_least(0.0, "1"));
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

template <class V> void describe(V& v, solver::NewtonOptions& o) {
  using solver::LineSearch;
  v.optional("tolerance", o.tolerance, "residual over reference force", positive("1"));
  v.optional("max_iterations", o.max_iterations, "of one solve", at_least(1.0, "1"));
  v.choice("line_search", o.line_search,
           {{"automatic", LineSearch::automatic, "shorten a step that makes things worse"},
            {"none", LineSearch::none, "full Newton steps"}},
           "of the Newton step");
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
  v.optional("every", o.every, "write every n-th converged step; the last one always",
             at_least(1.0, "1"));
}

template <class V> void describe(V& v, VerifyOptions& o) {
  v.required_choice("quantity", o.quantity,
                    {{"force_x", Quantity::force_x, "contact force on the primary side"},
                     {"force_y", Quantity::force_y},
                     {"force_z", Quantity::force_z},
                     {"max_pressure", Quantity::max_pressure, "of a contact interface"},
                     {"max_penetration", Quantity::max_penetration, "of a contact interface"},
                     {"active_points", Quantity::active_points, "of a contact interface"},
                     {"contact_radius", Quantity::contact_radius,
                      "of a contact interface round the z axis, by regression of p^2 over r^2"},
                     {"displacement_x", Quantity::displacement_x, "at a point or mean over a set"},
                     {"displacement_y", Quantity::displacement_y},
                     {"displacement_z", Quantity::displacement_z},
                     {"reaction_x", Quantity::reaction_x, "sum over a set"},
                     {"reaction_y", Quantity::reaction_y},
                     {"reaction_z", Quantity::reaction_z},
                     {"newton_iterations", Quantity::newton_iterations, "of the whole run"}},
                    "what is compared, at the end of the run");
  v.optional("place", o.place, "contact interface, node set or side set");
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
  v.named_map("bodies", o.bodies, "what the blocks of the mesh are made of", true);
  v.named_map("displacements", o.displacements, "prescribed displacements");
  v.named_map("loads", o.loads, "external loads");
  v.curve_map("curves", o.curves,
              "factors over the load parameter, linear between points, constant beyond the ends");
  v.named_map("contact", o.contact, "contact interfaces");
  section("time", o.time, "load steps");
  section("newton", o.newton, "nonlinear solves");
  section("linear_solver", o.linear, "linear solves");
  section("output", o.output, "results on disk");
  v.group("trilinos", "Trilinos parameter lists, merged over abut's own", [&](auto& w) {
    w.trilinos_list("NOX", o.newton.nox, "nonlinear solver");
    w.trilinos_list("Belos", o.linear.belos, "Krylov solver");
    w.trilinos_list("MueLu", o.linear.muelu, "algebraic multigrid");
    w.trilinos_list("Ifpack2", o.linear.ifpack2, "incomplete factors");
  });
  v.named_map("verify", o.verify, "what the deck expects of its own results");
}

} // namespace abut::deck
