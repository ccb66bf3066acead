// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"

#include <map>
#include <string>
#include <vector>

namespace abut::meshgen {

/// The kinds of mesh that generate knows.
const std::vector<std::string>& generator_kinds();

struct GeneratorKey {
  std::string name;
  std::string value; ///< what it is without being given
  std::string help;
};

/// The keys of a kind. Throws InputError for an unknown kind, naming the nearest one.
std::vector<GeneratorKey> generator_keys(const std::string& kind);

/// Makes a mesh of a kind from written options; see generators.hpp for what they mean. Lists are
/// written 1,2,3 or [1, 2, 3]; one number stands for all three. Throws InputError for an unknown
/// kind or key, naming the nearest one, and for values that cannot be read.
mesh::MeshData generate(const std::string& kind, const std::map<std::string, std::string>& options);

/// Cell type from hex8, hex20, hex27, tet4, tet10 or wedge6. Throws InputError.
fem::CellType cell_type_from_name(const std::string& name);

} // namespace abut::meshgen
