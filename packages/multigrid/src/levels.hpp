// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/multigrid/multigrid.hpp"
#include "coarsest.hpp"
#include "prolongator.hpp"

namespace abut::multigrid {

/// One level with N unknowns to a row, and its way to the next with M.
template <int N, int M> struct Level {
  Distribution rows;
  GaussSeidel<N> smoother;
  BlockMatrix<float, N, M> prolongator;
  BlockMatrix<float, M, N> restriction; ///< the transpose, for its owned and ghost columns
  Distribution aggregates;              ///< columns of the prolongator
  std::vector<float> b, x, work;        ///< (rows, padded(N))
  Global blocks = 0;

  /// Takes a matrix of other places, over the same prolongator. Collective.
  void take(const BlockMatrix<float, N, N>& a, const Distribution& rows_of_a) {
    rows = rows_of_a;
    smoother = GaussSeidel<N>(a);
    blocks = rows.comm().sum(static_cast<Global>(a.blocks()));
    make_vectors();
  }
  void make_vectors() {
    for (auto* vector : {&b, &x, &work})
      vector->assign(static_cast<std::size_t>(rows.size()) * padded(N), 0.0F);
  }

  std::size_t bytes() const {
    return smoother.bytes() + prolongator.bytes() + restriction.bytes() +
           3 * b.size() * sizeof(float);
  }
};

/// The Galerkin product P' A P. The ghosts of `aggregates` come first among its columns'.
/// Collective.
template <int N, int M>
DistributedRows<float, M, M>
galerkin_product(const BlockMatrix<float, N, N>& a, const Distribution& rows,
                 const BlockMatrix<float, N, M>& prolongator,
                 const BlockMatrix<float, M, N>& restriction, const Distribution& aggregates) {
  const auto extended = with_ghost_rows(prolongator, rows, aggregates);
  const auto right = product<float, N, N, M>(a, extended.matrix, extended.columns.size());
  const auto parts = product<float, M, N, M>(restriction, right, extended.columns.size());
  auto coarse = sum_to_owners(parts, aggregates, extended.columns);
  for (Local i = 0; i < coarse.matrix.rows; ++i)
    for (Local k = coarse.matrix.offset(i); k < coarse.matrix.offset(i + 1); ++k)
      for (int m = 0; m < M && coarse.matrix.column(k) == i; ++m)
        if (float& entry = coarse.matrix.block(k)[m * M + m]; entry == 0.0F)
          entry = 1.0F; // a mode that this aggregate does not have
  return coarse;
}

/// Aggregates and prolongator of `a`; modes become those of the aggregates. Nothing where the rows
/// do not grow fewer. Collective.
template <int N, int M>
std::optional<Level<N, M>> coarsen(const BlockMatrix<float, N, N>& a, const Distribution& rows,
                                   std::vector<double>& modes, const Options& options) {
  constexpr double worthwhile = 0.7; // rows of the next level over those of this one
  modes.resize(static_cast<std::size_t>(rows.size()) * N * M);
  rows.exchange().to_ghosts(modes.data(), N * M);
  const auto strong = strong_couplings<N, M>(a, modes, rows, options.drop_tolerance);
  auto tentative = tentative_prolongator<N, M>(aggregate(strength_graph<N>(a, strong)), modes);
  const Global coarse_rows = rows.comm().sum(static_cast<Global>(tentative.aggregates.count));
  if (coarse_rows == 0 || double(coarse_rows) > worthwhile * double(rows.total()))
    return std::nullopt;
  GaussSeidel<N> smoother(a);
  const InverseDiagonal<N>& inverse = smoother.inverse_diagonal();
  constexpr double safety = 1.1; // the power method comes from below
  const double weight =
      options.prolongator_damping / (safety * largest_eigenvalue<N>(a, inverse, rows));
  auto p = smoothed_prolongator<N, M>(a, inverse, strong, modes, tentative, rows, weight);
  modes = std::move(tentative.modes);
  Level<N, M> level{rows,
                    std::move(smoother),
                    p.matrix,
                    transpose(p.matrix, p.columns.size()),
                    p.columns,
                    {},
                    {},
                    {},
                    rows.comm().sum(static_cast<Global>(a.blocks()))};
  level.make_vectors();
  return level;
}

} // namespace abut::multigrid
