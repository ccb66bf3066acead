// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/scene/options.hpp"

#include <string>
#include <vector>

namespace abut::scene {

/// A set of nodes by the name of a node set or a side set. Ghost nodes included. Collective.
std::vector<Local> nodes_of_set(const mesh::Mesh& mesh, const std::string& name);

/// Names of node sets and side sets.
std::vector<std::string> set_names(const mesh::Mesh& mesh);

/// Throws InputError with where(path) unless `name` is one of `valid`. what: e.g. "side set".
void require_name(const Where& where, const std::string& path, const std::string& what,
                  const std::string& name, const std::vector<std::string>& valid);

/// Index of the block of this name or, where none has it, of this number; -1: there is none.
template <class Blocks> int block_called(const Blocks& blocks, const std::string& word) {
  int numbered = -1;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].name == word)
      return static_cast<int>(b);
    if (std::to_string(blocks[b].id) == word)
      numbered = static_cast<int>(b);
  }
  return numbered;
}

/// Blocks that the options call by their number get their names, unless one is called so.
void name_blocks(Options& options, const mesh::Mesh& mesh);

/// Throws InputError with where(path) when no node is in a set of the mesh. Collective.
void require_nodes(const Where& where, const std::string& path, const std::string& set,
                   const mesh::Mesh& mesh);

/// Throws InputError where displacements, loads or rigid bodies name a set, or loads a block, that
/// is empty. The names must be those of the mesh. Collective.
void check_not_empty(const Options& options, const mesh::Mesh& mesh, const Where& where);

/// Throws InputError where options name a block or a set that the mesh does not have.
void check_names(const Options& options, const mesh::Mesh& mesh, const Where& where);

} // namespace abut::scene
