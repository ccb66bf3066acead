// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"
#include "abut/core/views.hpp"
#include "abut/unknowns/block_pattern.hpp"

#include <vector>

namespace abut::assembly {

/// The tangent's values, and the matrix on them in which constrained rows and columns hold only
/// their diagonal.
class TangentMatrix {
public:
  explicit TangentMatrix(const unknowns::BlockPattern& pattern) : pattern_(pattern) {}

  /// Values of the pattern, zero: to be summed up, shared rows added to their owners. The matrix
  /// made before has lost its own.
  const View<double>& clear();
  const View<double>& values() const { return values_; }
  /// The values times a vector, owned rows; before the matrix is made of them. Collective.
  std::vector<double> times(const Vector& x) const;

  /// The pattern, or which rows are constrained, has changed.
  void reset() { matrix_ = Teuchos::null; }
  /// The matrix of the values, which it takes over. constrained: (owned scalar rows). Collective.
  RCP<const Matrix> make(const unknowns::DofMap& dofs, const std::vector<char>& constrained);

  /// (owned rows) diagonal of the values that the last make took over; empty before.
  const std::vector<double>& raw_diagonal() const { return raw_diagonal_; }
  /// Diagonal entry of the last matrix.
  double diagonal(Local row) const { return values_[diagonal_place_[std::size_t(row)]]; }

private:
  void find_places(const std::vector<char>& constrained, const unknowns::DofMap& dofs);
  void constrain(const std::vector<char>& constrained, std::size_t node_rows);

  const unknowns::BlockPattern& pattern_;
  View<double> values_; ///< of owned rows, which are the matrix's, and of shared rows
  std::vector<double> raw_diagonal_;
  std::vector<std::size_t> diagonal_place_; ///< (owned rows) in the values
  std::vector<std::size_t> cleared_;        ///< values of constrained rows and columns
  RCP<Matrix> matrix_;
};

} // namespace abut::assembly
