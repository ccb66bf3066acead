// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"
#include "abut/unknowns/block_pattern.hpp"

#include <vector>

namespace abut::assembly {

/// The tangent twice: its raw values, and the matrix in which constrained rows and columns hold
/// only their diagonal.
class TangentMatrix {
public:
  explicit TangentMatrix(const unknowns::BlockPattern& pattern) : pattern_(pattern) {}

  /// Raw values of the pattern, zero: to be summed up, shared rows added to their owners.
  std::vector<double>& clear();
  std::vector<double>& raw() { return raw_; }

  /// The pattern, or which rows are constrained, has changed.
  void reset() { matrix_ = Teuchos::null; }
  /// The matrix of the raw values. constrained: (owned scalar rows). Collective.
  RCP<const Matrix> make(const unknowns::DofMap& dofs, const std::vector<char>& constrained);

  /// Raw values times a vector, owned rows. Collective.
  std::vector<double> raw_times(const Vector& x) const;
  /// (owned rows) diagonal of the raw values of the last make; empty before.
  const std::vector<double>& raw_diagonal() const { return raw_diagonal_; }
  /// Diagonal entry of the last matrix.
  double diagonal(Local row) const;

private:
  void mark_columns(const std::vector<char>& constrained, const unknowns::DofMap& dofs);
  void copy(const std::vector<char>& constrained, Local node_rows);

  const unknowns::BlockPattern& pattern_;
  std::vector<double> raw_; ///< owned and shared rows
  std::vector<double> raw_diagonal_;
  std::vector<char> constrained_column_; ///< (columns of the graph)
  RCP<Matrix> matrix_;
};

} // namespace abut::assembly
