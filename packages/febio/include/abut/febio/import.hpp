// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/febio/model.hpp"
#include "abut/febio/report.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <string>

namespace abut::febio {

/// What a FEBio file means to abut.
struct Scene {
  mesh::MeshData mesh; ///< node and element numbers are FEBio's ids
  std::string deck;    ///< YAML
  Report report;
};

/// Reads a FEBio file of specification 2.0 to 4.0, solid mechanics. `file` is its name in messages.
/// Throws InputError "FILE:LINE: <element>: ..." for text that is not such a file (not XML, an
/// unknown or repeated id, a wrong number of nodes, ...). What is merely not supported is refused
/// in `report`.
Model read_model(const std::string& text, const std::string& file, Report& report);

/// Mesh and deck for a model; the deck names the mesh NAME.exo and its results NAME_results.
/// `report` is that of read_model and gets the refusals that only show here. Throws InputError for
/// contradictions: unknown names, an inverted element, faces that belong to no element, ...
Scene translate(const Model& model, const std::string& name, Report report);

/// Both. Throws InputError when anything is refused.
Scene import(const std::string& text, const std::string& file, const std::string& name);

} // namespace abut::febio
