// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/fem/cell.hpp"

#include <map>
#include <string>
#include <vector>

namespace abut::mesh {

/// One element block of a whole mesh.
struct BlockData {
  int id = 0;
  std::string name;
  fem::CellType type = fem::CellType::hex8;
  std::vector<Global> nodes;      ///< (elements, nodes per cell), 0-based node indices
  std::vector<Global> element_id; ///< (elements) number map of the file; empty: 1, 2, ...
};

/// A face of an element: block index, element index within the block, side (0-based).
struct SideData {
  int block = 0;
  Global element = 0;
  int side = 0;
};

/// A whole mesh in one place, as a file or a generator gives it.
struct MeshData {
  int dim = 3;
  std::string title;
  std::vector<double> x;       ///< (nodes, dim) coordinates [length]
  std::vector<Global> node_id; ///< (nodes) number map of the file; empty: 1, 2, ...
  std::vector<BlockData> blocks;
  std::map<std::string, std::vector<Global>> node_sets; ///< name -> 0-based node indices
  std::map<std::string, std::vector<SideData>> side_sets;

  Global num_nodes() const { return static_cast<Global>(x.size()) / dim; }
  Global num_elements() const;
};

} // namespace abut::mesh
