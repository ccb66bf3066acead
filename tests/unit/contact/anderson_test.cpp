// SPDX-License-Identifier: BSD-3-Clause
// Anderson's acceleration on linear iterations, values spread over the ranks.
#include "multipliers/anderson.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <mpi.h>

using namespace abut;
using abut::contact::Anderson;

namespace {

/// x <- x + (b - A x) with A = diag; this rank has every size-th value.
struct Iteration {
  std::vector<double> eigenvalue, b, x, weight;

  Iteration(const Comm& comm, std::vector<double> eigenvalues) {
    for (std::size_t i = std::size_t(comm.rank()); i < eigenvalues.size();
         i += std::size_t(comm.size())) {
      eigenvalue.push_back(eigenvalues[i]);
      b.push_back(1.0 + 0.1 * double(i));
      x.push_back(0.0);
      weight.push_back(1.0 + double(i % 3));
    }
  }
  std::vector<double> next() const {
    std::vector<double> g = x;
    for (std::size_t i = 0; i < x.size(); ++i)
      g[i] += b[i] - eigenvalue[i] * x[i];
    return g;
  }
  double error(const Comm& comm) const {
    double most = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      most = std::max(most, std::fabs(x[i] - b[i] / eigenvalue[i]));
    return comm.max(most);
  }
};

const std::vector<double> spread = {0.2, 0.3, 0.5, 0.9};

} // namespace

// As many earlier pairs as eigenvalues: the next value is the solution.
TEST(AndersonTest, SolvesAsManyEigenvaluesAsItKeeps) {
  const Comm comm(MPI_COMM_WORLD);
  Iteration it(comm, spread);
  Anderson anderson(comm);
  for (int k = 0; k < 5; ++k)
    it.x = anderson.next(it.x, it.next(), it.weight, false);
  EXPECT_EQ(anderson.depth(), 4u);
  EXPECT_LT(it.error(comm), 1e-9);
}

TEST(AndersonTest, NeedsFewerSteps) {
  const Comm comm(MPI_COMM_WORLD);
  std::vector<double> many;
  for (int i = 0; i < 40; ++i)
    many.push_back(0.1 + 0.8 * i / 39.0);
  const auto steps = [&](bool accelerated) {
    Iteration it(comm, many);
    Anderson anderson(comm);
    int k = 0;
    for (; it.error(comm) > 1e-6; ++k)
      it.x = accelerated ? anderson.next(it.x, it.next(), it.weight, false) : it.next();
    return k;
  };
  const int plain = steps(false), accelerated = steps(true);
  std::printf("  %d steps, %d plain\n", accelerated, plain);
  EXPECT_LT(accelerated, plain / 3);
}

TEST(AndersonTest, StartsAfreshOnChangeOrDoubling) {
  const Comm comm(MPI_COMM_WORLD);
  for (const bool told : {true, false}) {
    Iteration it(comm, spread);
    Anderson anderson(comm);
    for (int k = 0; k < 3; ++k)
      it.x = anderson.next(it.x, it.next(), it.weight, false);
    EXPECT_GT(anderson.depth(), 0u);
    for (double& b : it.b)
      b *= told ? 1.001 : 10.0;
    const auto g = it.next();
    const bool changed = told && comm.rank() == comm.size() - 1; // one rank is enough
    EXPECT_EQ(anderson.next(it.x, g, it.weight, changed), g);
    EXPECT_EQ(anderson.depth(), 0u);
  }
}

// x <- x + b: there is no solution, and nothing to run away to.
TEST(AndersonTest, DoesNotRunAway) {
  const Comm comm(MPI_COMM_WORLD);
  Iteration it(comm, {1.0, 0.5, 1e-7});
  Anderson anderson(comm);
  for (int k = 0; k < 8; ++k) {
    const auto x = it.x;
    it.x = anderson.next(it.x, it.next(), it.weight, false);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_LT(std::fabs(it.x[i] - x[i]), 11.0);
  }
}

TEST(AndersonTest, StandsWhereItIs) {
  const Comm comm(MPI_COMM_WORLD);
  Iteration it(comm, spread);
  for (std::size_t i = 0; i < it.x.size(); ++i)
    it.x[i] = it.b[i] / it.eigenvalue[i];
  Anderson anderson(comm);
  for (int k = 0; k < 3; ++k)
    it.x = anderson.next(it.x, it.next(), it.weight, false);
  EXPECT_LT(it.error(comm), 1e-14);
}
