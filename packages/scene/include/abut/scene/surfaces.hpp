// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/mesh/mesh_data.hpp"
#include "abut/scene/options.hpp"

namespace abut::scene {

/// Adds the surfaces of the options to a whole mesh, before it is distributed: each as a side set
/// and as the node set of its nodes. Serial. Throws InputError with where(key) for names that are
/// taken or that nothing has, surfaces made of themselves, and empty ones.
void add_surfaces(const Options& options, mesh::MeshData& mesh, const Where& where);

} // namespace abut::scene
