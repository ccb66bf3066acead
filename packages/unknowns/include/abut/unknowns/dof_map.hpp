// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"
#include "abut/mesh/mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace abut::unknowns {

/// Two rigid bodies whose unknowns act on each other.
struct RigidLink {
  std::array<int, 2> body{-1, -1}; ///< indices, -1: none
  bool has_unknowns = false;       ///< of its own: two block rows
};

/// Which nodes move with rigid bodies.
struct RigidNodes {
  std::vector<int> body;          ///< (N local nodes) index of the body, -1: none; empty: no bodies
  std::vector<char> has_unknowns; ///< (bodies)
  std::vector<RigidLink> links;
};

/// Numbers the unknowns: every owned mesh node with unknowns is one block row of `fields` scalar
/// rows. Block rows are contiguous per rank, in the order of the owned nodes. A rigid body with
/// unknowns is two block rows behind the nodes of one rank, translation and rotation; its nodes
/// have none. Links with unknowns are two block rows behind the bodies.
class DofMap {
public:
  /// field_names: of the unknowns of a node, e.g. displacement_x, ..., in their order.
  /// rigid: nodes that move with rigid bodies. Collective.
  DofMap(const mesh::Mesh& mesh, std::vector<std::string> field_names, RigidNodes rigid = {});

  const mesh::Mesh& mesh() const { return mesh_; }
  int fields() const { return static_cast<int>(field_names_.size()); }
  const std::vector<std::string>& field_names() const { return field_names_; }

  Local num_rows() const { return num_rows_; } ///< owned block rows, of nodes first
  Local num_node_rows() const { return static_cast<Local>(node_of_row_.size()); }
  Global first_row() const { return first_row_[mesh_.comm.rank()]; }
  Global num_global_rows() const { return first_row_.back(); }
  int owner_of_row(Global row) const;
  Local row_of_node(Local owned_node) const { return row_of_node_[owned_node]; } ///< or -1
  Local node_of_row(Local node_row) const { return node_of_row_[node_row]; }

  int num_bodies() const { return static_cast<int>(rigid_.has_unknowns.size()); }
  int body_of_node(Local node) const { return rigid_.body.empty() ? -1 : rigid_.body[node]; }
  /// Global block row of a body's translation, on any rank; its rotation is the next. -1: none.
  Global row_of_body(int body) const { return row_of_body_[static_cast<std::size_t>(body)]; }

  int num_links() const { return static_cast<int>(rigid_.links.size()); }
  const RigidLink& link(int i) const { return rigid_.links[static_cast<std::size_t>(i)]; }
  /// First of a link's two global block rows, on any rank. -1: none.
  Global row_of_link(int i) const { return row_of_link_[static_cast<std::size_t>(i)]; }

  /// (owned block rows) numbers that name rows alike on any number of ranks: those of nodes in the
  /// input, behind them bodies and links. Not collective.
  std::vector<Global> row_keys() const;

  /// Map of the scalar unknowns: block row r holds r*fields .. r*fields + fields-1.
  RCP<const Map> map() const { return map_; }

  /// Global block rows of global mesh nodes, -1 where a node has no unknowns, -2 - body where it
  /// moves with a rigid body. Collective.
  std::vector<Global> resolve(const std::vector<Global>& nodes) const;
  /// (nodes,3) reference coordinates of global mesh nodes [length]. Collective.
  std::vector<double> coordinates(const std::vector<Global>& nodes) const;

private:
  const mesh::Mesh& mesh_;
  std::vector<std::string> field_names_;
  std::vector<Global> first_row_; ///< (ranks+1)
  std::vector<Local> row_of_node_, node_of_row_;
  RigidNodes rigid_;
  std::vector<Global> row_of_body_, row_of_link_;
  Local num_rows_ = 0;
  RCP<const Map> map_;
};

} // namespace abut::unknowns
