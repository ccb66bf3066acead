// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/scene/options.hpp"

#include <string>
#include <vector>

namespace abut::scene {

/// A set of nodes by the name of a node set or a side set. Ghost nodes included.
std::vector<Local> nodes_of_set(const mesh::Mesh& mesh, const std::string& name);

/// Names of node sets and side sets.
std::vector<std::string> set_names(const mesh::Mesh& mesh);

/// Throws InputError with where(path) unless `name` is one of `valid`. what: e.g. "side set".
void require_name(const Where& where, const std::string& path, const std::string& what,
                  const std::string& name, const std::vector<std::string>& valid);

/// Throws InputError where options name a block or a set that the mesh does not have.
void check_names(const Options& options, const mesh::Mesh& mesh, const Where& where);

} // namespace abut::scene
