// SPDX-License-Identifier: BSD-3-Clause
#include "abut/multigrid/multigrid.hpp"
#include "lattice.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace abut;
using multigrid::Multigrid;
using test::Lattice;

std::vector<double> random_values(const Map& map, unsigned seed) {
  std::vector<double> x(local_size(map));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto id = static_cast<unsigned>(map.getGlobalElement(Local(i)));
    x[i] = std::sin(12.9898 * (id + 1) + 78.233 * seed);
  }
  return x;
}

double dot(const Comm& comm, const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return comm.sum(sum);
}

struct Problem {
  explicit Problem(const Lattice& given, multigrid::Options options = {})
      : lattice(given), matrix(test::stiffness(comm, given)), map(*matrix->getRowMap()),
        cycle(comm, multigrid::rigid_motions(comm, given.fields, test::row_places(map, given)),
              options) {
    cycle.setup(*matrix);
  }

  std::vector<double> times(const std::vector<double>& x) const {
    Vector from(matrix->getRowMap()), to(matrix->getRowMap());
    for (std::size_t i = 0; i < x.size(); ++i)
      from.replaceLocalValue(Local(i), x[i]);
    matrix->apply(from, to);
    const auto view = to.getLocalViewHost(Tpetra::Access::ReadOnly);
    std::vector<double> y(x.size());
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = view(i, 0);
    return y;
  }
  std::vector<double> preconditioned(const std::vector<double>& b) const {
    std::vector<double> x(b.size());
    cycle.apply(b.data(), x.data());
    return x;
  }

  /// Iterations of conjugate gradients to a residual of 1e-8.
  int iterations() const {
    std::vector<double> r = random_values(map, 1), x(r.size(), 0.0), p;
    const double first = std::sqrt(dot(comm, r, r));
    double before = 0.0;
    for (int n = 0; n < 200; ++n) {
      if (std::sqrt(dot(comm, r, r)) <= 1e-8 * first)
        return n;
      const auto z = preconditioned(r);
      const double now = dot(comm, r, z);
      if (n == 0)
        p = z;
      for (std::size_t i = 0; i < p.size() && n > 0; ++i)
        p[i] = z[i] + now / before * p[i];
      before = now;
      const auto q = times(p);
      const double step = now / dot(comm, p, q);
      for (std::size_t i = 0; i < r.size(); ++i)
        x[i] += step * p[i], r[i] -= step * q[i];
    }
    return 200;
  }

  Comm comm{MPI_COMM_WORLD};
  Lattice lattice;
  RCP<Matrix> matrix;
  const Map& map;
  Multigrid cycle;
};

class Fields : public testing::TestWithParam<int> {};

TEST_P(Fields, IterationsDoNotGrowWithTheMesh) {
  const int fields = GetParam();
  const int coarse = fields == 2 ? 24 : 8, fine = 2 * coarse;
  multigrid::Options options;
  options.coarsest_unknowns = 100;
  const Problem small({fields, coarse, coarse}, options), large({fields, fine, fine}, options);
  EXPECT_GE(small.cycle.levels().size(), 2U);
  EXPECT_GE(large.cycle.levels().size(), 3U);
  const int before = small.iterations(), after = large.iterations();
  RecordProperty("small", before);
  RecordProperty("large", after);
  std::printf("fields %d: %d and %d iterations, complexity %.2f\n", fields, before, after,
              large.cycle.operator_complexity());
  EXPECT_GE(before, 5) << "the cycle was no multigrid";
  EXPECT_LE(after, 20);
  EXPECT_LE(after, 1.5 * before);
}

TEST_P(Fields, CycleIsSymmetric) {
  const Problem problem({GetParam(), 8, 10});
  const auto u = random_values(problem.map, 2), v = random_values(problem.map, 3);
  const auto bu = problem.preconditioned(u), bv = problem.preconditioned(v);
  const double size = std::sqrt(dot(problem.comm, bu, bu) * dot(problem.comm, v, v));
  EXPECT_GT(size, 0.0);
  EXPECT_NEAR(dot(problem.comm, bu, v), dot(problem.comm, u, bv), 2e-6 * size);
}

TEST_P(Fields, RefreshOfTheSameValuesIsSetup) {
  Problem problem({GetParam(), 8, 10});
  const auto b = random_values(problem.map, 4);
  const auto before = problem.preconditioned(b);
  for (const bool same_places : {true, false}) {
    problem.cycle.refresh(*problem.matrix, same_places);
    EXPECT_EQ(problem.preconditioned(b), before);
  }
}

/// The matrix with zeros in the columns of a node far away, that is on another rank.
RCP<const Matrix> with_far_couplings(const Matrix& matrix, int fields) {
  const auto rows = matrix.getRowMap();
  const Global size = static_cast<Global>(rows->getGlobalNumElements());
  const Global half = size / fields / 2 * fields;
  auto wide = rcp(new Matrix(rows, matrix.getGlobalMaxNumRowEntries() + std::size_t(fields)));
  for (std::size_t i = 0; i < local_size(*rows); ++i) {
    const Global row = rows->getGlobalElement(Local(i)), node = row / fields * fields;
    Matrix::nonconst_global_inds_host_view_type columns("columns",
                                                        matrix.getNumEntriesInLocalRow(Local(i)));
    Matrix::nonconst_values_host_view_type values("values", columns.size());
    std::size_t count = 0;
    matrix.getGlobalRowCopy(row, columns, values, count);
    wide->insertGlobalValues(row, Local(count), values.data(), columns.data());
    for (int c = 0; c < fields; ++c) {
      const Global column = (node + half) % size + c;
      const double zero = 0.0;
      wide->insertGlobalValues(row, 1, &zero, &column);
    }
  }
  wide->fillComplete();
  return wide;
}

TEST_P(Fields, RefreshTakesOtherPlaces) {
  Problem problem({GetParam(), 8, 10});
  const auto b = random_values(problem.map, 4);
  const auto before = problem.preconditioned(b);
  const Global blocks = problem.cycle.levels().front().blocks;
  problem.cycle.refresh(*with_far_couplings(*problem.matrix, GetParam()), false);
  EXPECT_GT(problem.cycle.levels().front().blocks, blocks);
  const auto after = problem.preconditioned(b);
  for (std::size_t i = 0; i < b.size(); ++i)
    EXPECT_NEAR(after[i], before[i], 1e-5 * (1.0 + std::fabs(before[i])));
  problem.cycle.refresh(*problem.matrix, false);
  EXPECT_EQ(problem.preconditioned(b), before);
}

TEST_P(Fields, RefreshFollowsTheMatrix) {
  Problem problem({GetParam(), 8, 10});
  const auto b = random_values(problem.map, 4);
  const auto before = problem.preconditioned(b);
  problem.matrix->resumeFill();
  problem.matrix->scale(4.0);
  problem.matrix->fillComplete();
  problem.cycle.refresh(*problem.matrix, true);
  const auto after = problem.preconditioned(b);
  for (std::size_t i = 0; i < b.size(); ++i)
    EXPECT_NEAR(4.0 * after[i], before[i], 1e-5 * (1.0 + std::fabs(before[i])));
}

INSTANTIATE_TEST_SUITE_P(One, Fields, testing::Values(1, 2, 3, 4));

TEST(Cycle, SolvesASmallSystemOutright) {
  const Problem problem({3, 2, 2});
  EXPECT_EQ(problem.cycle.levels().size(), 1U);
  EXPECT_LE(problem.iterations(), 3);
}

TEST(Cycle, TakesFlatBricks) {
  Lattice lattice{3, 12, 12};
  const int cubes = Problem(lattice).iterations();
  lattice.flatness = 8.0;
  const int flat = Problem(lattice).iterations();
  std::printf("cubes %d, flat bricks %d iterations\n", cubes, flat);
  EXPECT_LE(flat, 25);
}

TEST(Cycle, TakesGradedBricksOfAnyFlatness) {
  Lattice lattice{3, 16, 16};
  lattice.growth = 0.75; // plates and needles, edges up to 75 to 1
  multigrid::Options all_strong;
  all_strong.drop_tolerance = std::numeric_limits<double>::infinity();
  const int graded = Problem(lattice).iterations();
  const int blind = Problem(lattice, all_strong).iterations();
  std::printf("graded bricks %d, with all couplings strong %d iterations\n", graded, blind);
  EXPECT_LE(graded, 32);
  EXPECT_GE(blind, 2 * graded) << "the bricks are no hard case";
}

TEST(Cycle, TakesContactOfAnyStiffness) {
  Lattice lattice{3, 12, 11};
  for (const double penalty : {1.0, 40.0, 1000.0}) {
    lattice.penalty = penalty;
    const int iterations = Problem(lattice).iterations();
    std::printf("penalty %g: %d iterations\n", penalty, iterations);
    EXPECT_LE(iterations, 30) << "penalty " << penalty;
  }
}

TEST(Cycle, TakesANearlyIncompressibleBody) {
  Lattice lattice{3, 10, 10};
  lattice.poisson = 0.45;
  EXPECT_LE(Problem(lattice).iterations(), 30);
  lattice.poisson = 0.49;
  lattice.mean_dilatation = true;
  const int iterations = Problem(lattice).iterations();
  std::printf("mean dilatation at 0.49: %d iterations\n", iterations);
  EXPECT_LE(iterations, 75);
}

} // namespace
