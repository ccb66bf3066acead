// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/options.hpp"
#include "describe/window.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abut::deck {

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

template <class V> void describe(V& v, scene::BodyOptions& o) {
  v.optional("blocks", o.blocks, "element blocks of the mesh, by name or number");
  v.optional("node_sets", o.node_sets,
             "nodes that move with a rigid body, of other bodies' elements too");
  v.at_least_one({"blocks", "node_sets"});
  v.alternative("material", !o.rigid,
                [&] { v.required("material", o.material, "name under materials"); });
  using solid::ElementFormulation;
  v.choice("element", o.element,
           {{"automatic", ElementFormulation::automatic,
             "hex8 and wedge6 of mooney_rivlin or ogden: mean_dilatation; hex8 of other materials "
             "where Poisson's ratio is 0.49 or more: enhanced; others: displacement"},
            {"displacement", ElementFormulation::displacement,
             "shape functions as they are: hex8, tet4 and wedge6 lock in bending and where "
             "Poisson's ratio comes near a half"},
            {"mean_dilatation", ElementFormulation::mean_dilatation,
             "hex8 and wedge6 of mooney_rivlin or ogden: the volume changes by its mean, and does "
             "not lock in hex8; bending does"},
            {"enhanced", ElementFormulation::enhanced, "hex8 that does not lock"}},
           "how elements of a deformable body follow its nodes");
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
  v.check("element", !o.rigid || o.element == ElementFormulation::automatic,
          "the elements of a rigid body do not deform");
  v.check("node_sets", o.rigid || o.node_sets.empty(),
          "only a rigid body takes nodes; a deformable one consists of blocks");
}

} // namespace abut::deck
