// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "abut/core/node_exchange.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <map>
#include <string>
#include <vector>

namespace abut::mesh {

/// This rank's elements of one block. Every rank has every block, perhaps without elements.
struct Block {
  int id = 0;
  std::string name;
  fem::CellType type = fem::CellType::hex8;
  std::vector<Local> nodes;       ///< (elements, nodes per cell) local node indices
  std::vector<Global> element;    ///< (elements) 0-based index in the input, over all blocks
  std::vector<Global> element_id; ///< (elements) number map of the input
  Local size() const { return static_cast<Local>(element.size()); }
};

struct Side {
  int block = 0;
  Local element = 0; ///< within the block, on this rank
  int side = 0;
};

/// The part of a mesh that one rank holds: its own elements and all their nodes. An element is
/// owned by one rank; a node by the lowest rank with an element on it. Global node numbers are
/// contiguous per rank; on one rank they equal the input's order.
struct Mesh {
  explicit Mesh(const Comm& c) : comm(c) {}

  Comm comm;
  int dim = 3;
  Global num_nodes = 0;           ///< over all ranks
  Global num_elements = 0;        ///< over all ranks
  Local num_owned = 0;            ///< owned nodes come first, then ghosts
  std::vector<double> x;          ///< (N, dim) reference coordinates [length]
  std::vector<Global> node;       ///< (N) global number
  std::vector<Global> node_input; ///< (N) 0-based index in the input
  std::vector<Global> node_id;    ///< (N) number map of the input
  std::vector<Global> first_node; ///< (ranks+1) first global number of each rank
  std::vector<Block> blocks;
  std::map<std::string, std::vector<Local>>
      node_sets; ///< owned and ghost nodes; all names on all ranks
  std::map<std::string, std::vector<Side>>
      side_sets; ///< owned elements' sides; all names on all ranks

  Local num_local() const { return static_cast<Local>(node.size()); }
  int owner(Global node_number) const;
};

/// Spreads a mesh that the root holds (others pass an empty one) over the ranks with Zoltan2
/// recursive coordinate bisection of the element centres. Collective. Nodes that belong to no
/// element stay with the root.
Mesh distribute(const MeshData& data, const Comm& comm);

/// The whole mesh on the root in the order of the input, with number maps and sorted sets; an
/// empty one on the other ranks. Collective.
MeshData gather(const Mesh& mesh);

/// This rank's part as a mesh of its own: local nodes, blocks (perhaps empty), number maps, sets.
MeshData local_part(const Mesh& mesh);

/// Exchange of values (N, width) of this rank's nodes between owners and ghosts. Collective.
NodeExchange node_exchange(const Mesh& mesh);

} // namespace abut::mesh
