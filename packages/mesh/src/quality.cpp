// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/quality.hpp"

#include "abut/fem/cell_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::mesh {

namespace {

/// The three neighbours of each corner, right-handed.
const int hex_neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                  {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
const int tet_neighbours[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}};
const int wedge_neighbours[6][3] = {{1, 2, 3}, {2, 0, 4}, {0, 1, 5},
                                    {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};

struct Corners {
  const int (*neighbours)[3];
  double regular; ///< triple product of the unit edges in the regular cell
};

Corners corners_of(fem::CellType type) {
  switch (fem::info(type).corners) {
  case 4:
    return {tet_neighbours, std::sqrt(0.5)};
  case 6:
    return {wedge_neighbours, std::sqrt(0.75)};
  default:
    return {hex_neighbours, 1.0};
  }
}

} // namespace

double scaled_jacobian(fem::CellType type, const Vec3* x) {
  const Corners corners = corners_of(type);
  double smallest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < fem::info(type).corners; ++a) {
    Vec3 tangent[3];
    for (int i = 0; i < 3; ++i) {
      const int b = corners.neighbours[a][i], m = fem::edge_node(type, a, b);
      tangent[i] = x[b] - x[a];
      // End tangent of the parabola through corner, middle node and far corner.
      if (m >= 0)
        tangent[i] = 4.0 * x[m] - 3.0 * x[a] - x[b];
      const double length = norm(tangent[i]);
      if (length > 0.0)
        tangent[i] *= 1.0 / length;
    }
    smallest = std::min(smallest, dot(cross(tangent[0], tangent[1]), tangent[2]) / corners.regular);
  }
  return smallest;
}

double min_scaled_jacobian(const MeshData& mesh) {
  double smallest = 1.0;
  for (const BlockData& block : mesh.blocks) {
    const auto n = static_cast<std::size_t>(fem::info(block.type).nodes);
    for (std::size_t first = 0; first < block.nodes.size(); first += n) {
      Vec3 x[fem::max_cell_nodes];
      for (std::size_t a = 0; a < n; ++a) {
        const double* at = &mesh.x[3 * static_cast<std::size_t>(block.nodes[first + a])];
        x[a] = {{at[0], at[1], at[2]}};
      }
      smallest = std::min(smallest, scaled_jacobian(block.type, x));
    }
  }
  return smallest;
}

} // namespace abut::mesh
