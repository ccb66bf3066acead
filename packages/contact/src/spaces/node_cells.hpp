// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/node_columns.hpp"
#include "abut/core/contribution.hpp"
#include "kernels/pairs.hpp"
#include "spaces/corner_space.hpp"
#include "spaces/nodal_arrays.hpp"

#include <functional>
#include <vector>

namespace abut::contact {

/// Rows of nodes in CRS form: node `node(c)` has the rows first(c) .. first(c+1)-1, one for each
/// mesh node in `column`. Copied by value; the arrays are shared.
struct NodeRowArrays {
  View<Local> node;     ///< (cells) surface node
  View<Local> first;    ///< (cells+1)
  View<Global> column;  ///< (rows) ascending within a cell
  View<NodeRow> row;    ///< (rows)
  View<char> from_ranks; ///< (cells) its rows come of several ranks and are complete
  /// (columns of all pairs, max_corners): row of a pair's column in the cell of a corner; -1: none.
  View<Local> position;

  KOKKOS_INLINE_FUNCTION Local size() const { return static_cast<Local>(node.extent(0)); }
};

/// The mesh nodes that every rank joins to a surface node, put together on its owner (ascending,
/// each once) and removed elsewhere; columns: (surface nodes). Collective.
void join_columns(const Comm& comm, const mesh::Surface& surface, const CornerSpace& space,
                  std::vector<std::vector<Global>>& columns);

/// One dense block of the tangent for each active node of the nodal law, on the rank that owns the
/// node. It holds the mesh nodes of all the faces around the node and of the faces that they meet;
/// what other ranks have of them is sent when the cells are made, so that the tangent needs no
/// communication.
class NodeCells {
public:
  /// Adds up the rows of this rank's points at their positions.
  using AddRows = std::function<void(const NodeRowArrays& rows)>;

  /// cells: of the pairs; the nodes' cells are put behind them. Collective.
  void build(const Comm& comm, const mesh::Surface& surface, const CornerSpace& space,
             const NodalArrays& nodes, const PairArrays& pairs, const AddRows& add,
             Connectivity& cells);
  /// Rows that need no other rank, anew.
  void refill(const AddRows& add);

  const NodeRowArrays& rows() const { return rows_; }

private:
  NodeRowArrays rows_;
};

} // namespace abut::contact
