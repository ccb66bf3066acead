// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/mesh_data.hpp"

namespace abut::mesh {

Global MeshData::num_elements() const {
  Global count = 0;
  for (const BlockData& b : blocks)
    count += static_cast<Global>(b.nodes.size()) / fem::info(b.type).nodes;
  return count;
}

} // namespace abut::mesh
