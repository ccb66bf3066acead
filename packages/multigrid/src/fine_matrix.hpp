// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"
#include "abut/multigrid/block_matrix.hpp"
#include "distribution.hpp"

#include <optional>
#include <vector>

namespace abut::multigrid {

/// Blocks of N x N over the scalar entries of a Tpetra matrix, made once for its graph.
template <int N> class FineMatrix {
public:
  /// Collective.
  FineMatrix(const Comm& comm, const Matrix& matrix);

  const Distribution& rows() const { return *rows_; }
  BlockMatrix<float, N, N> blocks(const Matrix& matrix) const;
  /// (owned rows, N) scalar rows that hold only their diagonal.
  static std::vector<char> constrained(const BlockMatrix<float, N, N>& blocks);

private:
  std::vector<Local> block_column_; ///< (scalar columns of the matrix) local block column
  std::vector<char> component_;     ///< (scalar columns of the matrix)
  std::vector<Local> offset_, column_;
  std::optional<Distribution> rows_;
};

extern template class FineMatrix<1>;
extern template class FineMatrix<2>;
extern template class FineMatrix<3>;
extern template class FineMatrix<4>;

} // namespace abut::multigrid
