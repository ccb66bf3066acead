// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh_data.hpp"
#include "abut/mesh/options.hpp"

#include <string>
#include <vector>

namespace abut::mesh {

struct SelectedSides {
  std::vector<SideData> sides;
  std::string story; ///< how many each criterion left: ", 12 near the plane, 0 with the normal"
};

/// Those of `sides`, in their order, for which all of the selection holds. A face is near a plane,
/// cylinder or sphere when all of its nodes are, and in a box when all of them are in it or near
/// it; its normal is the mean one of its corners. The node set must be one of the mesh.
SelectedSides select_sides(const MeshData& mesh, std::vector<SideData> sides,
                           const FaceSelection& selection);

} // namespace abut::mesh
