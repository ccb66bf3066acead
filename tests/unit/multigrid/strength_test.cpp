// SPDX-License-Identifier: BSD-3-Clause
// Strength of couplings, and what becomes of the weak ones, against plain dense algebra.
#include "../../../packages/multigrid/src/fine_matrix.hpp"
#include "../../../packages/multigrid/src/prolongator.hpp"
#include "lattice.hpp"

#include <gtest/gtest.h>

namespace {

using namespace abut;
using namespace abut::multigrid;
using Dense = std::vector<std::vector<double>>;
using Scalars = BlockMatrix<float, 1, 1>;

Distribution rows_of_this_rank(const Comm& comm, Local rows) {
  return Distribution(comm, {0, rows}, {});
}

template <int R, int C> BlockMatrix<float, R, C> full(Local rows, Local columns) {
  std::vector<Local> offset{0}, column;
  for (Local i = 0; i < rows; ++i) {
    for (Local j = 0; j < columns; ++j)
      column.push_back(j);
    offset.push_back(static_cast<Local>(column.size()));
  }
  return make_block_matrix<float, R, C>(offset, column);
}

/// Heat conduction between any two of n points, each pair with another conductivity.
Scalars conduction(Local n) {
  Scalars s = full<1, 1>(n, n);
  for (Local i = 0; i < n; ++i)
    for (Local j = 0; j < i; ++j) {
      const auto value = static_cast<float>(std::exp(3.0 * std::sin(1.7 * i + 3.1 * j)));
      s.value(i * n + j) = s.value(j * n + i) = -value;
      s.value(i * n + i) += value;
      s.value(j * n + j) += value;
    }
  return s;
}

TEST(Strength, IsThatOfTheFourthPowerOfTheStep) {
  const Local n = 9;
  const auto at = [&](Local i, Local j) { return static_cast<std::size_t>(i * n + j); };
  const Scalars s = conduction(n);
  const std::vector<double> zeros(static_cast<std::size_t>(n), 0.0);
  Dense step(static_cast<std::size_t>(n), zeros), heat = step;
  for (Local j = 0; j < n; ++j) {
    double size = 0.0;
    for (Local k = 0; k < n; ++k)
      size += std::fabs(s.value(at(j, k)));
    for (Local k = 0; k < n; ++k)
      step[std::size_t(j)][std::size_t(k)] = (j == k ? 1.0 : 0.0) - s.value(at(j, k)) / size;
  }
  for (std::size_t i = 0; i < std::size_t(n); ++i) { // heat[i]: what spreads from i
    heat[i][i] = 1.0;
    for (int times = 0; times < 4; ++times) {
      const auto before = heat[i];
      for (std::size_t j = 0; j < std::size_t(n); ++j) {
        heat[i][j] = 0.0;
        for (std::size_t k = 0; k < std::size_t(n); ++k)
          heat[i][j] += step[j][k] * before[k];
      }
    }
  }
  const auto measure = [&](std::size_t i, std::size_t j) {
    return std::fabs(1.0 - heat[i][i] / heat[i][j]);
  };
  const auto least = [&](std::size_t i) {
    double smallest = 1e300;
    for (std::size_t j = 0; j < std::size_t(n); ++j)
      if (j != i)
        smallest = std::min(smallest, measure(i, j));
    return smallest;
  };
  const Comm self(MPI_COMM_SELF);
  const auto strong = evolution_strength(s, rows_of_this_rank(self, n), 4.0);
  int weak = 0;
  for (std::size_t i = 0; i < std::size_t(n); ++i)
    for (std::size_t j = 0; j < std::size_t(n); ++j) {
      const bool expected =
          i == j || measure(i, j) <= 4.0 * least(i) || measure(j, i) <= 4.0 * least(j);
      EXPECT_EQ(bool(strong[i * std::size_t(n) + j]), expected) << i << ", " << j;
      weak += expected ? 0 : 1;
    }
  EXPECT_GT(weak, n);
  EXPECT_LT(weak, n * (n - 2));
}

TEST(Strength, RowsWithoutEnergiesHoldAllCouplingsStrong) {
  Scalars s = conduction(6);
  for (std::size_t j = 0; j < 6; ++j)
    s.value(2 * 6 + j) = s.value(j * 6 + 2) = 0.0F;
  const Comm self(MPI_COMM_SELF);
  const auto strong = evolution_strength(s, rows_of_this_rank(self, 6), 4.0);
  for (std::size_t j = 0; j < 6; ++j) {
    EXPECT_TRUE(strong[2 * 6 + j]);
    EXPECT_TRUE(strong[j * 6 + 2]);
  }
}

/// Strong couplings of an elastic lattice, counted over all ranks by the direction of the edge.
struct Count {
  double upright = 0.0, others = 0.0;
};
Count strong_of(const Comm& comm, const test::Lattice& lattice) {
  const auto matrix = test::stiffness(comm, lattice);
  const FineMatrix<3> fine(comm, *matrix);
  const auto a = fine.blocks(*matrix);
  const Distribution& rows = fine.rows();
  auto modes = rigid_motions(comm, 3, test::row_places(*matrix->getRowMap(), lattice)).values;
  const auto constrained = FineMatrix<3>::constrained(a);
  for (std::size_t i = 0; i < modes.size(); ++i)
    if (constrained[i / 6])
      modes[i] = 0.0;
  modes.resize(std::size_t(rows.size()) * 18);
  rows.exchange().to_ghosts(modes.data(), 18);
  const auto strong = strong_couplings<3, 6>(a, modes, rows, 4.0);
  Count count;
  for (Local i = 0; i < a.rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k) {
      const auto p = lattice.place(rows.global(i)), q = lattice.place(rows.global(a.column(k)));
      if (p != q && strong[std::size_t(k)])
        (p[0] == q[0] && p[1] == q[1] ? count.upright : count.others) += 1.0;
    }
  return {comm.sum(count.upright), comm.sum(count.others)};
}

TEST(Strength, IsThatOfTheShortEdges) {
  const Comm world(MPI_COMM_WORLD);
  test::Lattice lattice{3, 6, 8};
  lattice.flatness = 10.0;
  const Count count = strong_of(world, lattice);
  EXPECT_EQ(count.others, 0.0);
  EXPECT_EQ(count.upright, 7.0 * 7.0 * 2.0 * 7.0); // seven free edges above each other, both ways
}

TEST(Strength, IsTheSameOnAnyNumberOfRanks) {
  test::Lattice lattice{3, 7, 9};
  lattice.growth = 0.7;
  const Count parts = strong_of(Comm(MPI_COMM_WORLD), lattice);
  const Count whole = strong_of(Comm(MPI_COMM_SELF), lattice);
  EXPECT_GT(whole.upright, 0.0);
  EXPECT_GT(whole.others, 0.0);
  EXPECT_EQ(parts.upright, whole.upright);
  EXPECT_EQ(parts.others, whole.others);
}

TEST(Prolongator, LumpingTakesTheNearNullSpaceAlong) {
  constexpr int N = 3, M = 6;
  const Local rows = 8;
  auto a = full<N, N>(rows, rows);
  for (std::size_t v = 0; v < a.value.size(); ++v)
    a.value(v) = std::sin(1.3F * float(v));
  std::vector<double> modes(std::size_t(rows) * N * M);
  for (std::size_t v = 0; v < modes.size(); ++v)
    modes[v] = std::cos(2.1 * double(v) + 0.1 * double(v) * double(v));
  std::vector<char> strong(std::size_t(rows * rows), 0);
  for (Local i = 0; i < rows; ++i)
    for (Local j = 0; j < rows; ++j)
      strong[std::size_t(i * rows + j)] = i == j || (i + j) % 3 == 0;
  Aggregates aggregates;
  aggregates.count = 2;
  for (Local i = 0; i < rows; ++i)
    aggregates.of_row.push_back(i / 4);
  const auto tentative = tentative_prolongator<N, M>(aggregates, modes);
  const auto product = filtered_times_tentative<N, M>(
      a, strong, modes, tentative, tentative.aggregates.of_row, InverseDiagonal<N>(a), 0.0);
  for (Local i = 0; i < rows; ++i)
    for (int r = 0; r < N; ++r)
      for (int m = 0; m < M; ++m) {
        double filtered = 0.0, whole = 0.0;
        for (Local k = product.offset(i); k < product.offset(i + 1); ++k)
          for (int s = 0; s < M; ++s)
            filtered += product.block(k)[s * N + r] *
                        tentative.modes[std::size_t((product.column(k) * M + s) * M + m)];
        for (Local j = 0; j < rows; ++j)
          for (int c = 0; c < N; ++c)
            whole += a.block(i * rows + j)[c * N + r] * modes[std::size_t((j * N + c) * M + m)];
        EXPECT_NEAR(filtered, whole, 1e-4) << i << ", " << r << ", " << m;
      }
}

/// Twenty nodes almost in a line and one beside it, weakly coupled: it must not follow the turn of
/// the line about itself, which would throw it a thousand times as far as any node of the line.
TEST(Prolongator, LumpingLeavesOutTurnsThatTakeNeighboursFar) {
  constexpr int N = 3, M = 6;
  const Local rows = 21;
  auto a = full<N, N>(rows, rows);
  for (Local i = 0; i < rows; ++i)
    for (int c = 0; c < N; ++c)
      a.block(i * rows + i)[c * N + c] = 1.0F;
  for (int c = 0; c < N; ++c)
    for (int r = 0; r < N; ++r)
      a.block(rows - 1)[c * N + r] = -0.1F;
  std::vector<RowPlace> places(static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    places[i].point = {double(i), 1e-3 * std::sin(double(i)), 0.0};
  places.back().point = {0.0, 5.0, 0.0};
  const Comm self(MPI_COMM_SELF);
  const auto modes = rigid_motions(self, N, places).values;
  std::vector<char> strong(static_cast<std::size_t>(rows * rows), 1);
  strong[std::size_t(rows - 1)] = 0; // of the first node with the last
  Aggregates aggregates;
  aggregates.count = 2;
  aggregates.of_row.assign(static_cast<std::size_t>(rows), 0);
  aggregates.of_row.back() = 1;
  const auto tentative = tentative_prolongator<N, M>(aggregates, modes);
  const auto largest = [&](double weight) {
    const auto product = filtered_times_tentative<N, M>(
        a, strong, modes, tentative, tentative.aggregates.of_row, InverseDiagonal<N>(a), weight);
    float most = 0.0F;
    for (int v = 0; v < product.block_size; ++v)
      most = std::max(most, std::fabs(product.block(0)[v]));
    return most;
  };
  EXPECT_GT(largest(0.0), 10.0F) << "nothing takes the neighbour far";
  EXPECT_LE(largest(1.0), 1.0F + 4.0F / 3.0F);
}

} // namespace
