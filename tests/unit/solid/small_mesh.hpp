// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/fem/cell_shape.hpp"
#include "abut/mesh/mesh.hpp"

#include <random>
#include <vector>

/// Meshes of a few elements on one rank.
namespace abut::test {

inline constexpr fem::CellType all_cells[] = {fem::CellType::hex8,  fem::CellType::hex20,
                                              fem::CellType::hex27, fem::CellType::tet4,
                                              fem::CellType::tet10, fem::CellType::wedge6};

/// Corner positions of a cell, moved at random by up to `amount`.
inline std::vector<Vec3> distorted_corners(fem::CellType type, double amount,
                                           std::mt19937& engine) {
  std::uniform_real_distribution<double> random(-amount, amount);
  std::vector<Vec3> x(fem::info(type).corners);
  for (std::size_t a = 0; a < x.size(); ++a) {
    fem::dispatch_cell(type, [&](auto s) { decltype(s)::node(static_cast<int>(a), x[a].v); });
    for (int i = 0; i < 3; ++i)
      x[a][i] += random(engine);
  }
  return x;
}

/// All nodes of a cell with straight edges between the given corners.
inline std::vector<Vec3> straight_nodes(fem::CellType type, const std::vector<Vec3>& corners) {
  const int n = fem::info(type).nodes;
  const fem::CellType linear = corners.size() == 8   ? fem::CellType::hex8
                               : corners.size() == 4 ? fem::CellType::tet4
                                                     : fem::CellType::wedge6;
  std::vector<Vec3> x(n, Vec3::zero());
  for (int a = 0; a < n; ++a) {
    double xi[3], N[fem::max_cell_nodes];
    fem::dispatch_cell(type, [&](auto s) { decltype(s)::node(a, xi); });
    fem::dispatch_cell(linear, [&](auto s) { decltype(s)::values(xi, N); });
    for (std::size_t c = 0; c < corners.size(); ++c)
      x[a] += N[c] * corners[c];
  }
  return x;
}

/// A mesh of separate elements, one block; element ids 101, 102, ...
inline mesh::Mesh separate_elements(fem::CellType type, const std::vector<std::vector<Vec3>>& cells,
                                    MPI_Comm comm = MPI_COMM_SELF) {
  mesh::Mesh m{Comm(comm)};
  mesh::Block block;
  block.id = 1;
  block.name = "body";
  block.type = type;
  for (const auto& cell : cells) {
    block.element.push_back(block.size());
    block.element_id.push_back(100 + block.size());
    for (const Vec3& p : cell) {
      const Local node = m.num_local();
      block.nodes.push_back(node);
      m.node.push_back(node);
      m.node_input.push_back(node);
      m.node_id.push_back(node + 1);
      m.x.insert(m.x.end(), p.v, p.v + 3);
    }
  }
  m.num_owned = m.num_local();
  m.num_nodes = m.num_owned;
  m.num_elements = block.size();
  m.first_node = {0, m.num_nodes};
  m.blocks.push_back(block);
  return m;
}

inline std::vector<double> random_vector(std::size_t n, double amount, std::mt19937& engine) {
  std::uniform_real_distribution<double> random(-amount, amount);
  std::vector<double> v(n);
  for (double& x : v)
    x = random(engine);
  return v;
}

} // namespace abut::test
