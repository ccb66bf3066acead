// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/abaqus/model.hpp"
#include "abut/mesh/mesh_data.hpp"
#include "abut/translation/report.hpp"

#include <functional>
#include <string>

namespace abut::abaqus {

/// What an input file means to abut.
struct Scene {
  mesh::MeshData mesh; ///< node and element numbers are the file's, anew where some come twice
  std::string deck;    ///< YAML
  translation::Report report;
};

/// The text of a file that *INCLUDE names; throws InputError when there is none.
using ReadFile = std::function<std::string(const std::string& path)>;

/// Reads an input file of Abaqus or CalculiX. `file` is its name in messages; files that it
/// includes are sought from its folder. Throws InputError "FILE:LINE: *KEYWORD: ..." for text that
/// is not such a file (unknown sets, wrong numbers, ...). What is merely not supported is refused
/// in `report`.
Model read_model(const std::string& text, const std::string& file, const ReadFile& read,
                 translation::Report& report);

/// Mesh and deck for a model; the deck names the mesh NAME.exo and its results NAME_results.
/// `report` is that of read_model and gets the refusals that only show here. Throws InputError for
/// contradictions: unknown materials, an inverted element, ...
Scene translate(const Model& model, const std::string& name, translation::Report report);

/// Both, without included files. Throws InputError when anything is refused.
Scene import(const std::string& text, const std::string& file, const std::string& name);

} // namespace abut::abaqus
