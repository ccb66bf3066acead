// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/multigrid/block_matrix.hpp"
#include "distribution.hpp"

#include <optional>
#include <vector>

namespace abut::multigrid {

/// The coarsest system: gathered to all ranks and factored there by LAPACK, in double precision.
class Coarsest {
public:
  Coarsest() = default;
  /// a: owned rows; a zero row of the whole gets a unit diagonal. Collective.
  template <int N> Coarsest(const BlockMatrix<float, N, N>& a, const Distribution& rows);

  /// b, x: (rows, padded) of this rank. Collective.
  void solve(const float* b, float* x) const;
  std::size_t bytes() const { return factors_.size() * sizeof(double); }

private:
  void factor();

  std::optional<Comm> comm_;
  int width_ = 1, stride_ = 1;                   ///< unknowns of a row, and its length in vectors
  std::size_t begin_ = 0, owned_ = 0, size_ = 0; ///< unknowns
  std::vector<double> factors_;                  ///< (size, size) by columns
  std::vector<int> pivots_;
};

} // namespace abut::multigrid
