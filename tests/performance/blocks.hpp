// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/equation_system.hpp"
#include "abut/contact/interaction.hpp"
#include "abut/mesh/surface.hpp"
#include "abut/meshgen/generate.hpp"
#include "abut/solid/solid_contribution.hpp"

namespace abut::bench {

/// Two stacked blocks of hex8 with a non-matching interface.
struct Blocks {
  mesh::Mesh mesh;
  PhaseTimers timers;
  assembly::EquationSystem system;
  std::shared_ptr<contact::Interaction> contact;

  explicit Blocks(int n)
      : mesh(make_mesh(n)), system(unknowns::DofMap(mesh, {"x", "y", "z"}), timers) {
    solid::MaterialOptions material;
    material.young = 1.0;
    material.poisson = 0.3;
    for (int b = 0; b < 2; ++b)
      system.add(
          std::make_shared<solid::SolidContribution>(mesh, b, solid::make_material(material)));
    contact::ContactOptions options;
    options.name = "pair";
    options.penalty = 100.0;
    contact = std::make_shared<contact::Interaction>(
        mesh.comm, mesh::extract_surface(mesh, "upper_bottom"),
        mesh::extract_surface(mesh, "lower_top"), options, timers);
    system.add(contact);
  }

  static mesh::Mesh make_mesh(int n) {
    const auto cells = [](int k) { return std::to_string(k); };
    return mesh::distribute(meshgen::generate("blocks", {{"lower_divisions", cells(n)},
                                                         {"upper_divisions", cells(n + n / 2)},
                                                         {"gap", "-0.001"}}),
                            Comm(MPI_COMM_WORLD));
  }
};

} // namespace abut::bench
