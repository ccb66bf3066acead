// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/deck.hpp"
#include "rule.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace abut::deck {

template <class V> void describe(V& v, io::CheckpointOptions& o) {
  v.optional("every", o.every, "after every n-th converged step", at_least(1.0, "1"));
  v.optional("minutes", o.minutes, "after so much wall time, at the end of a step",
             positive("minutes"));
  v.at_least_one({"every", "minutes"});
}

constexpr std::pair<const char*, bool io::FieldOptions::*> words_of_fields[] = {
    {"stress_tensor", &io::FieldOptions::stress_tensor},
    {"principal_stress", &io::FieldOptions::principal_stress},
    {"strain", &io::FieldOptions::strain},
    {"nodal_stress", &io::FieldOptions::nodal_stress}};

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
  std::vector<std::string> fields;
  for (const auto& [word, wanted] : words_of_fields)
    if (o.fields.*wanted)
      fields.push_back(word);
  v.words("fields", fields, {"stress_tensor", "principal_stress", "strain", "nodal_stress"},
          "further fields, beside those of every run (docs/user/output.md)");
  for (const auto& [word, wanted] : words_of_fields)
    o.fields.*wanted = std::find(fields.begin(), fields.end(), word) != fields.end();
  v.optional("history", o.history,
             "write a table of forces, energies and the like with a row for each converged step, "
             "NAME.history.csv");
  v.optional("points", o.points, "write a table of all contact points, NAME.points.csv");
  v.optional("every", o.every, "write every n-th converged step; the last one always",
             at_least(1.0, "1"));
  v.optional_group(
      "checkpoint", o.checkpoint.active,
      "write NAME.checkpoint, from which 'abut run DECK --restart NAME.checkpoint' goes "
      "on; the last converged step always, also of a run that stops",
      [&](auto& w) { describe(w, o.checkpoint); });
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

} // namespace abut::deck
