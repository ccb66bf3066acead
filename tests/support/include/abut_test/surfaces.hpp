// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/surface.hpp"

#include <functional>
#include <vector>

namespace abut_test {

/// nx x ny quad4 faces over [x0,x1] x [y0,y1] mapped by `place`; the normal is that of x cross y,
/// or its opposite when `flip`. Nodes are numbered from first_node, faces from first_face.
inline abut::mesh::Surface grid_surface(int nx, int ny, double x0, double x1, double y0, double y1,
                                        bool flip, abut::Global first_node,
                                        const std::function<void(double*)>& place = {},
                                        abut::Global first_face = 0) {
  abut::mesh::Surface s;
  s.name = flip ? "lower_facing" : "upper_facing";
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      double x[3] = {x0 + (x1 - x0) * i / nx, y0 + (y1 - y0) * j / ny, 0.0};
      if (place)
        place(x);
      s.x.insert(s.x.end(), x, x + 3);
      s.field_index.push_back(static_cast<abut::Local>(first_node) + s.num_nodes());
      s.node.push_back(first_node + s.num_nodes());
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      const std::vector<int> corner =
          flip ? std::vector<int>{a, d, c, b} : std::vector<int>{a, b, c, d};
      s.nodes.insert(s.nodes.end(), corner.begin(), corner.end());
      s.offset.push_back(static_cast<abut::Local>(s.nodes.size()));
      s.type.push_back(abut::fem::FaceType::quad4);
      s.face_id.push_back(first_face + static_cast<abut::Global>(s.face_id.size()));
    }
  s.modulus.assign(s.type.size(), 0.0);
  s.inverse_depth.assign(s.type.size(), 0.0);
  return s;
}

} // namespace abut_test
