// SPDX-License-Identifier: BSD-3-Clause
#include "structured.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <random>
#include <sstream>

namespace abut::meshgen {

void require_cells(double cells, double most) {
  if (cells <= most)
    return;
  std::ostringstream text;
  text << "the mesh would have " << cells << " cells in a block, and generators make at most "
       << most << ": make it coarser, or give a mesh file";
  throw InputError(text.str());
}

mesh::MeshData structured_block(const std::vector<double>& x, const std::vector<double>& y,
                                const std::vector<double>& z, const std::string& name,
                                const SideNames& sides) {
  require_cells(static_cast<double>(x.size()) * static_cast<double>(y.size()) *
                static_cast<double>(z.size()));
  mesh::MeshData mesh;
  for (double c : z)
    for (double b : y)
      for (double a : x)
        mesh.x.insert(mesh.x.end(), {a, b, c});

  const Global nx = static_cast<Global>(x.size()), ny = static_cast<Global>(y.size());
  const Global cells[3] = {nx - 1, ny - 1, static_cast<Global>(z.size()) - 1};
  const Global corner[8] = {0, 1, 1 + nx, nx, nx * ny, nx * ny + 1, nx * ny + 1 + nx, nx * ny + nx};
  mesh::BlockData block;
  block.id = 1;
  block.name = name;
  for (Global k = 0; k < cells[2]; ++k)
    for (Global j = 0; j < cells[1]; ++j)
      for (Global i = 0; i < cells[0]; ++i)
        for (Global c : corner)
          block.nodes.push_back((k * ny + j) * nx + i + c);

  // Exodus side (0-based) of -x, +x, -y, +y, -z, +z.
  const int side_of[6] = {3, 1, 0, 2, 4, 5};
  const std::string* names[6] = {&sides.x0, &sides.x1, &sides.y0, &sides.y1, &sides.z0, &sides.z1};
  for (int s = 0; s < 6; ++s) {
    if (names[s]->empty())
      continue;
    auto& out = mesh.side_sets[*names[s]];
    const int axis = s / 2;
    const Global plane = s % 2 == 0 ? 0 : cells[axis] - 1;
    Global element = 0, index[3];
    for (index[2] = 0; index[2] < cells[2]; ++index[2])
      for (index[1] = 0; index[1] < cells[1]; ++index[1])
        for (index[0] = 0; index[0] < cells[0]; ++index[0], ++element)
          if (index[axis] == plane)
            out.push_back({0, element, side_of[s]});
  }
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

void distort(mesh::MeshData& mesh, const std::vector<double>& x, const std::vector<double>& y,
             const std::vector<double>& z, double fraction, unsigned seed) {
  if (fraction == 0.0)
    return;
  if (!(fraction > 0.0) || fraction > 0.3)
    throw InputError("distortion must lie between 0 and 0.3");
  std::mt19937 random(seed);
  const std::vector<double>* axes[3] = {&x, &y, &z};
  std::size_t index[3], node = 0;
  for (index[2] = 0; index[2] < z.size(); ++index[2])
    for (index[1] = 0; index[1] < y.size(); ++index[1])
      for (index[0] = 0; index[0] < x.size(); ++index[0], ++node)
        for (int d = 0; d < 3; ++d) {
          const std::vector<double>& axis = *axes[d];
          const std::size_t i = index[d];
          if (i == 0 || i + 1 == axis.size())
            continue;
          const double cell = std::min(axis[i + 1] - axis[i], axis[i] - axis[i - 1]);
          const double unit = 2.0 * (random() / 4294967295.0) - 1.0;
          mesh.x[3 * node + d] += fraction * cell * unit;
        }
}

} // namespace abut::meshgen
