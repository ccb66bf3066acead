// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"
#include "abut/mesh/mesh.hpp"

#include <string>
#include <vector>

namespace abut::assembly {

/// Numbers the unknowns: every owned mesh node with unknowns is one block row of `fields` scalar
/// rows. Block rows are contiguous per rank, in the order of the owned nodes.
class DofMap {
public:
  /// field_names: of the unknowns of a node, e.g. displacement_x, ..., in their order.
  /// without_unknowns: (N local nodes) nodes whose motion is prescribed (rigid obstacles).
  DofMap(const mesh::Mesh& mesh, std::vector<std::string> field_names,
         const std::vector<char>& without_unknowns);

  const mesh::Mesh& mesh() const { return mesh_; }
  int fields() const { return static_cast<int>(field_names_.size()); }
  const std::vector<std::string>& field_names() const { return field_names_; }

  Local num_rows() const { return static_cast<Local>(node_of_row_.size()); } ///< owned block rows
  Global first_row() const { return first_row_[mesh_.comm.rank()]; }
  Global num_global_rows() const { return first_row_.back(); }
  int owner_of_row(Global row) const;
  Local row_of_node(Local owned_node) const { return row_of_node_[owned_node]; } ///< or -1
  Local node_of_row(Local row) const { return node_of_row_[row]; }

  /// Map of the scalar unknowns: block row r holds r*fields .. r*fields + fields-1.
  RCP<const Map> map() const { return map_; }

  /// Global block rows of global mesh nodes, -1 where a node has no unknowns. Collective.
  std::vector<Global> resolve(const std::vector<Global>& nodes) const;

private:
  const mesh::Mesh& mesh_;
  std::vector<std::string> field_names_;
  std::vector<Global> first_row_; ///< (ranks+1)
  std::vector<Local> row_of_node_, node_of_row_;
  RCP<const Map> map_;
};

} // namespace abut::assembly
