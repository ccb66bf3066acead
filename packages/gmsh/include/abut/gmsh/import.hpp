// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/gmsh/model.hpp"
#include "abut/mesh/mesh_data.hpp"
#include "abut/translation/report.hpp"

#include <string>

namespace abut::gmsh {

/// What a Gmsh file means to abut.
struct Scene {
  mesh::MeshData mesh; ///< node and element numbers are Gmsh's
  std::string deck;    ///< YAML to start from, with marks where the user must fill in
  translation::Report report;
};

/// Whether the text begins like an MSH file.
bool is_msh(const std::string& text);

/// Reads an MSH file, version 2.2 or 4.1, ASCII or binary. `file` is its name in messages. Throws
/// InputError "FILE:LINE: ..." or "FILE: byte N: ..." for text that is not such a file, ends too
/// early or contradicts itself. What is merely left out is in `report`.
Model read_model(const std::string& text, const std::string& file, translation::Report& report);

/// Mesh and deck for a model; the deck names the mesh NAME.exo and its results
/// NAME_results. A block for each physical volume and
/// cell type, a side set and a node set for each physical surface, a node set for each physical
/// curve and point. Volumes in no group are blocks of their own, and so are surfaces side sets
/// where no surface is in a group. `report` is that of read_model and gets the refusals that only
/// show here. Throws InputError for an inverted element, unknown or repeated nodes.
Scene translate(const Model& model, const std::string& name, translation::Report report);

/// Both. Throws InputError when anything is refused.
Scene import(const std::string& text, const std::string& file, const std::string& name);

} // namespace abut::gmsh
