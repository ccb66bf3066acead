// SPDX-License-Identifier: BSD-3-Clause
#include "deck_text.hpp"

#include "abut/translation/yaml_text.hpp"

namespace abut::gmsh {

using translation::quoted;

std::string deck_text(const mesh::MeshData& mesh, const std::string& name) {
  std::string out =
      "# A deck to start from, made by abut import. Fill in what is marked with FILL IN, then\n"
      "# `abut check` explains the scene and `abut run` solves it. docs/user/deck-reference.md has "
      "all\n"
      "# keys.\n";
  out += "title: " + quoted("The mesh " + name) + "\n";
  out += "mesh: {file: " + quoted(name + ".exo") + "}\n";
  out += "\n# Its side sets, each a node set too:\n";
  for (const auto& [set, sides] : mesh.side_sets)
    out += "#   " + quoted(set) + ": " + std::to_string(sides.size()) + " faces\n";
  if (mesh.side_sets.empty())
    out += "#   none. Select faces under `surfaces`, for example the upper ones of a body:\n"
           "# surfaces:\n"
           "#   lid: {body: NAME, normal: {direction: [0, 0, 1]}}\n";
  for (const auto& [set, nodes] : mesh.node_sets)
    if (!mesh.side_sets.count(set))
      out += "# node set " + quoted(set) + ": " + std::to_string(nodes.size()) + " nodes\n";
  out += "\nmaterials:\n"
         "  some_material: {model: linear_elastic, young: 1, poisson: 0.3} # FILL IN\n"
         "bodies:\n";
  translation::DeckNames names;
  for (const mesh::BlockData& block : mesh.blocks)
    out += "  " + names.make(block.name, "body") + ": {blocks: [" + quoted(block.name) +
           "], material: some_material}\n";
  out +=
      "\n# FILL IN what is held and what moves, what loads the bodies, and which surfaces touch:\n"
      "# displacements:\n"
      "#   foot: {set: NAME, fix: [x, y, z]}\n"
      "#   head: {set: NAME, fix: [x, y], z: -0.1}\n"
      "# loads:\n"
      "#   push: {side_set: NAME, pressure: 1}\n"
      "# contact:\n"
      "#   pair: {primary: NAME, secondary: NAME} # primary: the softer or finer side\n"
      "time: {steps: 5}\n"
      "output: {name: " +
      quoted(name + "_results") + "}\n";
  return out;
}

} // namespace abut::gmsh
