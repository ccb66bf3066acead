// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"
#include "abut/core/trilinos_fwd.hpp"
#include "abut/core/window.hpp"
#include "abut/unknowns/dof_map.hpp"
#include "abut/unknowns/row_constraint.hpp"

#include <functional>
#include <vector>

namespace abut::assembly {

/// An unknown of an owned node that is prescribed: value(t) [unit of the field].
struct Constraint {
  Local node = 0; ///< owned mesh node
  int field = 0;
  std::function<double(double)> value;
  Window window{};       ///< outside of it the unknown is free
  bool relative = false; ///< the value counts from that of the last state before the window
  int group = 0;         ///< of constraints that count as one in reports
};

/// The scalar rows that are prescribed, when and how: of nodes, and of what has rows of its own.
class Constraints {
public:
  /// rows: owned scalar rows.
  Constraints(std::size_t rows, std::vector<unknowns::RowConstraint> others)
      : others_(std::move(others)), holds_(rows, 0) {}

  void set_nodes(const unknowns::DofMap& dofs, std::vector<Constraint> constraints);

  /// Those that hold at t from now on; relative ones that begin count from last (owned scalar
  /// rows), which is zero where it is empty. True: on this rank one began or ended.
  bool follow(double t, const std::vector<double>& last);
  /// (owned scalar rows) whether the row is prescribed at the present time.
  const std::vector<char>& holds() const { return holds_; }
  void apply(Vector& x, double t) const;
  /// The present state is converged.
  void accept();
  /// What relative values count from, at the last converged state, which was at t. rows: keys of
  /// the owned block rows.
  void exchange_state(StateArchive& archive, const std::vector<Global>& rows, double t);

private:
  std::vector<unknowns::RowConstraint> nodes_, others_;
  std::vector<char> holds_;
};

} // namespace abut::assembly
