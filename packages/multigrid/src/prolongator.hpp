// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "aggregates.hpp"
#include "gauss_seidel.hpp"
#include "products.hpp"
#include "row_messages.hpp"
#include "strength.hpp"

#include <cmath>

namespace abut::multigrid {

/// Prolongator that is the near-null space on each aggregate: one block to a row.
template <int N, int M> struct Tentative {
  static constexpr int block_size = N * M;
  Aggregates aggregates;
  std::vector<float> block;  ///< (rows, M, N)
  std::vector<double> modes; ///< (aggregates, M, M) near-null space of the coarse rows
};

/// Makes the M columns of q (rows, M) orthonormal by modified Gram-Schmidt, twice; a column that
/// depends on those before it becomes zero. Adds to upper the factor with q_old = q upper.
template <int M> void orthonormalise(std::vector<double>& q, double* upper) {
  constexpr double dependent = 1e-6; // of what a column was; its modes come from single precision
  const std::size_t rows = q.size() / M;
  const auto dot = [&](int s, int t) {
    double sum = 0.0;
    for (std::size_t r = 0; r < rows; ++r)
      sum += q[r * M + std::size_t(s)] * q[r * M + std::size_t(t)];
    return sum;
  };
  for (int s = 0; s < M; ++s) {
    const double before = std::sqrt(dot(s, s));
    for (int pass = 0; pass < 2; ++pass)
      for (int t = 0; t < s; ++t) {
        const double share = dot(s, t);
        upper[t * M + s] += share;
        for (std::size_t r = 0; r < rows; ++r)
          q[r * M + std::size_t(s)] -= share * q[r * M + std::size_t(t)];
      }
    const double size = std::sqrt(dot(s, s));
    const bool keep = size > dependent * before;
    upper[s * M + s] = keep ? size : 0.0;
    for (std::size_t r = 0; r < rows; ++r)
      q[r * M + std::size_t(s)] *= keep ? 1.0 / size : 0.0;
  }
}

/// modes: (rows, N, M).
template <int N, int M>
Tentative<N, M> tentative_prolongator(Aggregates aggregates, const std::vector<double>& modes) {
  const std::size_t rows = aggregates.of_row.size();
  std::vector<std::vector<std::size_t>> members(std::size_t(aggregates.count));
  for (std::size_t i = 0; i < rows; ++i)
    if (aggregates.of_row[i] >= 0)
      members[std::size_t(aggregates.of_row[i])].push_back(i);
  Tentative<N, M> p;
  p.block.assign(rows * p.block_size, 0.0F);
  p.modes.assign(members.size() * M * M, 0.0);
  std::vector<double> q;
  for (std::size_t a = 0; a < members.size(); ++a) {
    q.clear();
    for (const std::size_t i : members[a])
      q.insert(q.end(), modes.begin() + std::ptrdiff_t(i * N * M),
               modes.begin() + std::ptrdiff_t((i + 1) * N * M));
    orthonormalise<M>(q, p.modes.data() + a * M * M);
    for (std::size_t n = 0; n < members[a].size(); ++n)
      for (int r = 0; r < N; ++r)
        for (int m = 0; m < M; ++m)
          p.block[members[a][n] * p.block_size + std::size_t(m * N + r)] =
              static_cast<float>(q[(n * N + std::size_t(r)) * M + std::size_t(m)]);
  }
  p.aggregates = std::move(aggregates);
  return p;
}

/// Largest eigenvalue of D^-1 A by the power method, from below. Collective.
template <int N>
double largest_eigenvalue(const BlockMatrix<float, N, N>& a, const InverseDiagonal<N>& inverse,
                          const Distribution& rows) {
  constexpr int iterations = 10;
  const auto size = static_cast<std::size_t>(rows.size()) * padded(N);
  std::vector<float> x(size, 0.0F), y(size, 0.0F);
  unsigned random = 1;
  for (Local i = 0; i < rows.owned(); ++i)
    for (int c = 0; c < N; ++c) {
      random = random * 1664525U + 1013904223U;
      x[static_cast<std::size_t>(i) * padded(N) + std::size_t(c)] =
          static_cast<float>(random >> 8) / float(1 << 24) - 0.5F;
    }
  double size_before = 0.0, value = 1.0;
  const auto squared = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows.owned()); ++i)
      for (std::size_t c = 0; c < N; ++c)
        sum += double(x[i * padded(N) + c]) * x[i * padded(N) + c];
    return rows.comm().sum(sum);
  };
  size_before = squared();
  for (int n = 0; n < iterations && size_before > 0.0; ++n) {
    const auto scale = static_cast<float>(1.0 / std::sqrt(size_before));
    for (float& entry : x)
      entry *= scale;
    rows.exchange().to_ghosts(x.data(), padded(N));
    multiply(a, x.data(), y.data());
    for (Local i = 0; i < rows.owned(); ++i) {
      const std::size_t at = static_cast<std::size_t>(i) * padded(N);
      inverse.times(i, Pack<float, N>::load(y.data() + at)).store(x.data() + at);
    }
    size_before = squared();
    value = std::sqrt(size_before);
  }
  return value;
}

/// Places of A^F times the tentative prolongator: the aggregates of a row and of those that are
/// strongly coupled with it. aggregate: (rows with ghosts) column, or -1.
template <int N, int M>
BlockMatrix<float, N, M> places_of_prolongator(const BlockMatrix<float, N, N>& a,
                                               const std::vector<char>& strong,
                                               const std::vector<Local>& aggregate) {
  std::vector<Local> offset{0}, columns, found;
  for (Local i = 0; i < a.rows; ++i) {
    found.clear();
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      if (const Local j = aggregate[std::size_t(a.column(k))]; j >= 0 && strong[std::size_t(k)])
        found.push_back(j);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    columns.insert(columns.end(), found.begin(), found.end());
    offset.push_back(static_cast<Local>(columns.size()));
  }
  return make_block_matrix<float, N, M>(offset, columns);
}

/// What the weak couplings of one row do to the near-null space: (N, M), a sum of A_ij B_j.
template <int N, int M> struct WeakSum {
  double value[N * M] = {};
  bool any = false;

  void add(const float* block, const double* modes) {
    any = true;
    for (int c = 0; c < N; ++c)
      for (int r = 0; r < N; ++r) {
        const double entry = block[c * N + r];
        for (int m = 0; m < M; ++m)
          value[r * M + m] += entry * modes[c * M + m];
      }
  }
  /// Adds value R^-1 to a block, R the upper triangle of an aggregate's modes. Left out are modes
  /// that the aggregate does not have, and hardly has: `accepts` tells of a column.
  template <class Accepts>
  void add_to(float* block, const double* upper, const Accepts& accepts) const {
    double y[M][N] = {};
    for (int m = 0; m < M; ++m) {
      const double own = upper[m * M + m];
      if (own == 0.0)
        continue;
      Pack<float, N> column;
      for (int r = 0; r < N; ++r) {
        double rest = value[r * M + m];
        for (int t = 0; t < m; ++t)
          rest -= y[t][r] * upper[t * M + m];
        y[m][r] = rest / own;
        column.value[r] = static_cast<float>(y[m][r]);
      }
      if (accepts(column))
        for (int r = 0; r < N; ++r)
          block[m * N + r] += column.value[r];
      else
        std::fill_n(y[m], N, 0.0);
    }
  }
};

/// Whether a change of the prolongator, D^-1 times the column times the weight, is one that
/// smooths: that of a whole matrix is at most 4/3 in size, as the mode is 1. Lumping exceeds it
/// for a turn about an axis on which the aggregate almost lies, which takes its neighbours far.
template <int N>
bool smooths(const InverseDiagonal<N>& inverse, Local row, double weight,
             const Pack<float, N>& column) {
  constexpr double most = 4.0 / 3.0;
  const auto change = inverse.times(row, column);
  double sum = 0.0;
  for (int r = 0; r < N; ++r)
    sum += double(change.value[r]) * change.value[r];
  return weight * std::sqrt(sum) <= most;
}

/// A^F times the tentative prolongator. A^F is A without its weak couplings, which are lumped: j
/// moves as the aggregate of i would take it along, B_j R^-1, and so (A^F T) R = A B in all rows,
/// for the modes that the aggregate has. modes: B (rows with ghosts, N, M). aggregate: (rows with
/// ghosts) column, or -1.
template <int N, int M>
BlockMatrix<float, N, M>
filtered_times_tentative(const BlockMatrix<float, N, N>& a, const std::vector<char>& strong,
                         const std::vector<double>& modes, const Tentative<N, M>& tentative,
                         const std::vector<Local>& aggregate, const InverseDiagonal<N>& inverse,
                         double weight) {
  auto product = places_of_prolongator<N, M>(a, strong, aggregate);
  for (Local i = 0; i < a.rows; ++i) {
    const Local* first = product.column.data() + product.offset(i);
    const Local* last = product.column.data() + product.offset(i + 1);
    const auto block_of = [&](Local column) {
      return product.block(
          static_cast<Local>(std::lower_bound(first, last, column) - product.column.data()));
    };
    WeakSum<N, M> weak;
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k) {
      const auto j = static_cast<std::size_t>(a.column(k));
      if (!strong[std::size_t(k)])
        weak.add(a.block(k), modes.data() + j * N * M);
      else if (aggregate[j] >= 0)
        add_block_product<float, N, N, M>(
            a.block(k), tentative.block.data() + j * tentative.block_size, block_of(aggregate[j]));
    }
    if (const Local own = tentative.aggregates.of_row[std::size_t(i)]; weak.any && own >= 0)
      weak.add_to(block_of(aggregate[std::size_t(i)]),
                  tentative.modes.data() + static_cast<std::size_t>(own) * M * M,
                  [&](const auto& column) { return smooths<N>(inverse, i, weight, column); });
  }
  return product;
}

/// P = (I - weight D^-1 A^F) times the tentative prolongator. Columns: the aggregates of this rank,
/// and those of others that its rows reach. modes: (rows with ghosts, N, M). Collective.
template <int N, int M>
DistributedRows<float, N, M>
smoothed_prolongator(const BlockMatrix<float, N, N>& a, const InverseDiagonal<N>& inverse,
                     const std::vector<char>& strong, const std::vector<double>& modes,
                     Tentative<N, M>& tentative, const Distribution& rows, double weight) {
  constexpr int block_size = Tentative<N, M>::block_size;
  const auto first = first_rows(rows.comm(), tentative.aggregates.count);
  const Distribution coarse(rows.comm(), first, {});
  std::vector<Global> aggregate(static_cast<std::size_t>(rows.size()), -1);
  for (Local i = 0; i < rows.owned(); ++i)
    if (const Local own = tentative.aggregates.of_row[std::size_t(i)]; own >= 0)
      aggregate[std::size_t(i)] = coarse.global(own);
  tentative.block.resize(static_cast<std::size_t>(rows.size()) * block_size);
  rows.exchange().to_ghosts(aggregate.data());
  rows.exchange().to_ghosts(tentative.block.data(), block_size);

  GhostList numbers(coarse, false);
  std::vector<Local> column(aggregate.size(), -1);
  for (std::size_t i = 0; i < aggregate.size(); ++i)
    if (aggregate[i] >= 0)
      column[i] = numbers.local(aggregate[i]);

  BlockMatrix<float, N, M> product =
      filtered_times_tentative(a, strong, modes, tentative, column, inverse, weight);
  for (Local i = 0; i < product.rows; ++i)
    for (Local k = product.offset(i); k < product.offset(i + 1); ++k)
      for (int m = 0; m < M; ++m) {
        float* entry = product.block(k) + m * N;
        const auto change = inverse.times(i, Pack<float, N>::load(entry));
        const bool own = product.column(k) == column[std::size_t(i)];
        const float* old = tentative.block.data() + static_cast<std::size_t>(i) * block_size +
                           static_cast<std::size_t>(m * N);
        for (int r = 0; r < N; ++r)
          entry[r] = (own ? old[r] : 0.0F) - static_cast<float>(weight) * change.value[r];
      }
  return {product, Distribution(rows.comm(), first, numbers.ghosts())};
}

} // namespace abut::multigrid
