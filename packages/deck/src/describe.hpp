// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/deck.hpp"
#include "describe/audit.hpp"
#include "describe/bodies.hpp"
#include "describe/contact.hpp"
#include "describe/joints.hpp"
#include "describe/loads.hpp"
#include "describe/material.hpp"
#include "describe/results.hpp"
#include "describe/solution.hpp"
#include "describe/supports.hpp"
#include "describe/surfaces.hpp"

/// The deck, declared once, a header for each kind of section. Filler reads by it, Documenter
/// explains by it, Writer prints by it. Defaults are the initial values of the option structs.
namespace abut::deck {

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
  v.named_map("surfaces", o.surfaces,
              "surfaces that the mesh has no side set of; each is a side set and a node set to the "
              "rest of the deck");
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
  section("audit", o.audit, "a look at converged steps by other means than those of contact");
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
