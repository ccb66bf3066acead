// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/rigid/options.hpp"
#include "rule.hpp"

namespace abut::deck {

/// What a joint prescribes of the motion that it leaves free, and what loads it.
template <class V> void describe_drive(V& v, rigid::JointOptions& o) {
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
  v.when(o.kind == rigid::JointKind::spherical, "spherical", [&] {
    v.optional("rotation_vector", o.rotation_vector,
               "of the second body against the first, in directions that turn with the first; free "
               "when not given",
               unit("rad"));
    v.optional("moment_vector", o.moment_vector,
               "on the second body, minus it on the first; fixed in space", unit("force length"));
  });
  v.when(o.turns() || o.slides() || o.kind == rigid::JointKind::spherical,
         "revolute, prismatic, cylindrical, spherical", [&] {
           v.optional(
               "curve", o.curve,
               "factor of rotation and translation over the load parameter; without one, t itself");
           v.optional("load_curve", o.load_curve,
                      "factor of moment and force over the load parameter; without one, t itself");
         });
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
  describe_drive(v, o);
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

} // namespace abut::deck
