// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/core/tensor.hpp"
#include "abut/unknowns/dof_map.hpp"

#include <Tpetra_CrsGraph_fwd.hpp>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace abut::unknowns {

/// Where the blocks of a set of cells go. Valid for one pattern and one connectivity.
struct CellPositions {
  std::vector<Local> row;                   ///< (slots) block row, owned then shared; -1; -2 - node
  std::vector<std::int64_t> block_offset;   ///< (cells+1)
  std::vector<std::int64_t> block_position; ///< first value of block (a, b); -1; -2 - rigid block
  std::vector<std::int64_t> rigid_block;    ///< (rigid blocks,2,2) first value, or -1
};

/// The nodes of the cells given that move with rigid bodies, in the numbering of CellPositions.
struct PatternRigidNodes {
  std::vector<Local> body;
  std::vector<double> x; ///< (rigid nodes,3) reference coordinates [length]
};

/// Sparsity of the operator in blocks of fields x fields. A rank holds its owned rows in full and,
/// behind them, the shared rows: those that its cells touch but another rank owns. Shared values
/// are sent to their owners and added there.
class BlockPattern {
public:
  explicit BlockPattern(const DofMap& dofs) : dofs_(dofs) {}

  /// Builds the pattern of all cells given. Collective.
  void build(const std::vector<const Connectivity*>& cells);
  long version() const { return version_; } ///< grows with every build

  /// Positions of the cells' blocks; false when a block lies outside the pattern (rebuild then).
  bool locate(const Connectivity& cells, CellPositions& positions) const;

  Local num_rows() const { return static_cast<Local>(row_offset_.size()) - 1; } ///< owned + shared
  std::int64_t num_values() const;       ///< scalar values of owned and shared rows
  std::int64_t num_owned_values() const; ///< scalar values of owned rows: they come first
  const std::vector<Local>& row_length() const { return row_length_; } ///< scalar row length

  const PatternRigidNodes& rigid_nodes() const { return rigid_nodes_; }
  /// (bodies,2) local block rows of translation and rotation, -1 where no cell of this rank has
  /// any.
  const std::vector<Local>& body_rows() const { return body_row_; }
  /// First value of block (i, j) of an owned body's own rows, 0: translation, 1: rotation.
  std::int64_t body_block(int body, int i, int j) const;

  /// Adds factor * m to the block of an owned global block row and any global column; for rows of
  /// bodies and links, three fields.
  void add(Global row, Global column, double factor, const Mat3& m, double* values) const;
  /// Values of the diagonal of the owned scalar rows.
  std::vector<double> diagonal(const double* values) const;

  /// Sends the shared part of values / residual to the owners and adds it there. Collective.
  void add_shared_values(double* values) const;
  void add_shared_residual(double* residual) const;

  /// Scalar graph of the owned rows; its values lie in the order of the owned values here.
  RCP<const Tpetra::CrsGraph<Local, Global, Node>> graph() const { return graph_; }

private:
  struct Blocks; // (row, column) pairs in global block rows while building
  void number_columns(const Blocks& blocks);
  void number_rigid_nodes(const Blocks& blocks);
  bool locate_block(Local row, Local column, CellPositions& out) const;
  Local local_row(Global row) const;
  void build_graph();
  void plan_exchange();
  std::int64_t position(Local row, Local column) const;

  const DofMap& dofs_;
  long version_ = 0;
  std::vector<std::int64_t> row_offset_; ///< (rows+1) in blocks
  std::vector<Local> columns_;           ///< local column of each block, ascending in a row
  std::vector<Global> column_row_;       ///< (columns) global block row of a local column
  std::vector<Global> shared_row_;       ///< global block row of each shared row, ascending
  std::vector<Local> row_length_;
  /// Mesh node -> local column; -1: no unknowns; -2 - i: rigid node i.
  std::unordered_map<Global, Local> column_of_node_;
  std::unordered_map<Global, Local> row_of_shared_;
  PatternRigidNodes rigid_nodes_;
  std::vector<Local> body_row_, body_column_; ///< (bodies,2), -1: none here
  struct Received {
    std::vector<Local> row;             ///< owned block rows in the order they arrive
    std::vector<std::int64_t> position; ///< of each arriving block
    std::vector<Local> count;           ///< blocks in each arriving row
  };
  std::vector<Received> received_; ///< per rank
  std::vector<Local> send_first_;  ///< (ranks+1) first shared row that goes to each rank
  RCP<const Tpetra::CrsGraph<Local, Global, Node>> graph_;
};

} // namespace abut::unknowns
