// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh.hpp"
#include "abut/solid/cell_arrays.hpp"

namespace abut::solid {

/// Collects cells of a mesh: mesh nodes for the scatter, arrays for kernels.
class CellList {
public:
  explicit CellList(const mesh::Mesh& mesh) : mesh_(mesh) {}

  /// nodes: local ones.
  void add(const Local* nodes, int count);
  void add(const mesh::Block& block); ///< all elements of a block

  Local size() const { return connectivity_.cells(); }
  const Connectivity& connectivity() const { return connectivity_; }
  CellArrays arrays() const;
  View<const fem::CellType> types() const; ///< (cells) when all are elements of blocks

private:
  const mesh::Mesh& mesh_;
  Connectivity connectivity_;
  std::vector<Local> node_;
  std::vector<Vec3> x_;
  std::vector<fem::CellType> type_;
};

} // namespace abut::solid
