// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/gmsh/model.hpp"
#include "abut/mesh/mesh_data.hpp"
#include "abut/translation/report.hpp"

namespace abut::gmsh {

/// The mesh of a model, see translate(); the report tells what became of each group. With elements
/// that abut lacks it has none.
mesh::MeshData make_mesh(const Model& model, translation::Report& report);

} // namespace abut::gmsh
