// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/corner_space.hpp"
#include "abut/contact/dual_columns.hpp"
#include "abut/core/contribution.hpp"

#include <functional>

namespace abut::contact {

/// The mesh nodes that every rank joins to a surface node, put together on its owner (ascending,
/// each once) and removed elsewhere; columns: (surface nodes). Collective.
void join_columns(const Comm& comm, const mesh::Surface& surface, const CornerSpace& space,
                  std::vector<std::vector<Global>>& columns);

/// One dense block of the tangent for each active node of the dual law, on the rank that owns the
/// node. It holds the mesh nodes of all the faces around the node and of the faces that they meet;
/// what other ranks have of them is sent when the cells are made, so that the tangent needs no
/// communication.
class NodeCells {
public:
  using Add = std::function<void(Local node, Global column, const NodeRow& row)>;
  using Wanted = std::function<bool(Local node)>;
  /// Calls the second for each row of this rank's points, of nodes for which the first is true.
  using Rows = std::function<void(const Wanted&, const Add&)>;

  /// columns: (surface nodes) the mesh nodes that this rank's points join to each; empty: none.
  /// Collective.
  void build(const Comm& comm, const mesh::Surface& surface, const CornerSpace& space,
             std::vector<std::vector<Global>> columns, const Rows& rows);
  /// Adds up the rows that need no other rank.
  void fill(const Rows& rows);

  Local size() const { return static_cast<Local>(cells_.size()); }
  Local node(Local cell) const { return cells_[cell].node; }
  const std::vector<Global>& columns(Local cell) const { return cells_[cell].columns; }
  const std::vector<NodeRow>& rows(Local cell) const { return cells_[cell].rows; }

private:
  struct Cell {
    Local node;
    bool shared;
    std::vector<Global> columns;
    std::vector<NodeRow> rows;
  };
  void add_to(Local node, Global column, const NodeRow& row);

  std::vector<Cell> cells_;
  std::vector<Local> cell_of_; ///< (surface nodes), -1: none here
};

} // namespace abut::contact
