// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/linear_solver.hpp"
#include "abut/solver/load_stepping.hpp"

#include "pulled_block.hpp"

#include <gtest/gtest.h>

namespace abut {
namespace {

using solver::LinearMethod;
using solver::LinearOptions;
using test::ElasticBlock;
using test::PulledBlock;

/// Krylov for any size, direct where that fails.
LinearOptions krylov_first(int max_iterations = 500) {
  LinearOptions options;
  options.direct_limit = 0;
  options.max_iterations = max_iterations;
  return options;
}

struct Log {
  std::vector<std::string> info, warnings;
  LogSink sink() {
    return [this](LogLevel level, const std::string& text) {
      (level == LogLevel::warning ? warnings : info).push_back(text);
    };
  }
};

/// Relative error of the solution of A x = b with a known x.
double error_with(solver::LinearSolver& linear, const RCP<const Matrix>& matrix, bool symmetric) {
  const Vector exact = test::wavy_vector(matrix->getRowMap());
  Vector b(exact.getMap()), x(exact.getMap());
  matrix->apply(exact, b);
  linear.setup(matrix, 0, symmetric);
  linear.solve(b, x, 1e-10);
  x.update(-1.0, exact, 1.0);
  return x.norm2() / exact.norm2();
}

/// A + shift I.
RCP<const Matrix> shifted(const Matrix& matrix, double shift) {
  const auto copy = rcp(new Matrix(matrix, Teuchos::Copy));
  copy->resumeFill();
  for (Local i = 0; i < static_cast<Local>(local_size(*copy->getRowMap())); ++i) {
    const Global row = copy->getRowMap()->getGlobalElement(i);
    copy->sumIntoGlobalValues(row, 1, &shift, &row);
  }
  copy->fillComplete();
  return copy;
}

solver::LoadResult two_steps(PulledBlock& block, solver::LinearSolver& linear, Vector& x) {
  solver::NewtonSolver newton(linear, {});
  solver::AugmentedLagrangian loop(newton);
  solver::TimeOptions time;
  time.steps = 2;
  return solver::LoadStepping(loop, time).run(block, x);
}

TEST(Escalation, AShorterStepComesBeforeADearFactorization) {
  PulledBlock block(6);
  LinearOptions options = krylov_first(1);
  options.dear_limit = 0;
  const auto linear = solver::make_linear_solver(options, block);
  Vector x(block.map());
  const auto result = two_steps(block, *linear, x);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_GE(result.counters.cut_backs, 1);
  EXPECT_GE(linear->uses()[0].failures, 2);
  EXPECT_GE(linear->uses()[1].solves, 1);
}

TEST(Escalation, TheStepGoesOnWhereKrylovFails) {
  PulledBlock block(6);
  Log log;
  const auto linear = solver::make_linear_solver(krylov_first(1), block, log.sink());
  Vector x(block.map()), expected(block.map());
  const auto result = two_steps(block, *linear, x);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_EQ(result.counters.cut_backs, 0);
  ASSERT_EQ(log.warnings.size(), 1u);
  EXPECT_NE(log.warnings[0].find("1 iterations"), std::string::npos) << log.warnings[0];
  EXPECT_NE(log.warnings[0].find("solved directly"), std::string::npos) << log.warnings[0];

  const auto uses = linear->uses();
  ASSERT_EQ(uses.size(), 2u);
  EXPECT_EQ(uses[0].method, "krylov with multigrid");
  EXPECT_EQ(uses[0].failures, 1);
  EXPECT_EQ(uses[0].systems, 0);
  EXPECT_EQ(uses[1].method, "direct");
  EXPECT_EQ(uses[1].failures, 0);
  EXPECT_EQ(uses[1].systems, linear->total_iterations()); // each a back substitution
  EXPECT_EQ(uses[1].setups, 1);

  LinearOptions direct;
  direct.method = LinearMethod::direct;
  const auto sure = solver::make_linear_solver(direct, block);
  ASSERT_TRUE(two_steps(block, *sure, expected).converged);
  x.update(-1.0, expected, 1.0);
  EXPECT_LT(x.norm2(), 1e-12 * expected.norm2());
}

TEST(Escalation, WithoutItTheStepFails) {
  PulledBlock block(6);
  auto options = krylov_first(1);
  options.method = LinearMethod::krylov;
  const auto linear = solver::make_linear_solver(options, block);
  Vector x(block.map());
  EXPECT_FALSE(two_steps(block, *linear, x).converged);
}

TEST(Escalation, SolvesIndefiniteAndWildlyUnsymmetricMatrices) {
  const ElasticBlock block(6), wild(6, {false, true, 0, 1e4});
  const struct {
    RCP<const Matrix> matrix;
    bool symmetric;
  } cases[] = {{shifted(*block.matrix(), -0.1), true}, // eigenvalues from 0.003 to 1.6
               {shifted(*block.matrix(), -1.0), true},
               {wild.matrix(), false}};
  for (const auto& c : cases) {
    Log log;
    const auto linear = solver::make_linear_solver(krylov_first(), block, log.sink());
    const auto n = &c - cases;
    EXPECT_LT(error_with(*linear, c.matrix, c.symmetric), 1e-5) << n;
    const auto uses = linear->uses();
    EXPECT_EQ(uses[0].systems + uses[1].systems, 1) << n;
    EXPECT_EQ(uses[0].failures, uses[1].systems) << n;
    EXPECT_EQ(log.warnings.size(), static_cast<std::size_t>(uses[0].failures)) << n;
  }
}

TEST(Escalation, NobodyClaimsToHaveSolvedHalfOfAMatrix) {
  const ElasticBlock wild(6, {false, true, 0, 1e4});
  const auto linear = solver::make_linear_solver(krylov_first(), wild);
  EXPECT_THROW(error_with(*linear, wild.matrix(), true), SolveError); // symmetric it is not
  EXPECT_EQ(linear->uses()[0].systems + linear->uses()[1].systems, 0);
}

TEST(Escalation, SparesMoreMatricesAfterEachFailureAndTriesAgain) {
  const ElasticBlock block(6);
  Log log;
  const auto linear = solver::make_linear_solver(krylov_first(1), block, log.sink());
  std::vector<long long> failures;
  for (int i = 0; i < 12; ++i) {
    EXPECT_LT(error_with(*linear, block.matrix(), true), 1e-10);
    failures.push_back(linear->uses()[0].failures);
    linear->forget(); // a step that is tried again does not start from trust
  }
  EXPECT_EQ(failures, (std::vector<long long>{1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 3}));
  EXPECT_EQ(log.warnings.size(), 3u);
}

TEST(Escalation, KrylovMayTakeAsLongAsAFactorizationIsWorth) {
  const ElasticBlock block(8, {false, true, 0, 100.0});
  Log log;
  const auto linear = solver::make_linear_solver(krylov_first(1000000), block, log.sink());
  error_with(*linear, block.matrix(), false);
  EXPECT_LE(linear->uses()[0].iterations, 100);
}

TEST(Escalation, SaysWhatIsChosen) {
  const ElasticBlock block(6);
  Log first, second, third;
  solver::make_linear_solver(krylov_first(), block, first.sink());
  ASSERT_EQ(first.info.size(), 1u);
  EXPECT_NE(first.info[0].find("krylov with multigrid, direct where that fails, for 1029 unknowns"),
            std::string::npos)
      << first.info[0];
  solver::make_linear_solver({}, block, second.sink());
  ASSERT_EQ(second.info.size(), 1u);
  EXPECT_NE(second.info[0].find("direct for 1029 unknowns"), std::string::npos) << second.info[0];
  LinearOptions word;
  word.method = LinearMethod::direct;
  solver::make_linear_solver(word, block, third.sink());
  EXPECT_TRUE(third.info.empty()); // the user has chosen
}

} // namespace
} // namespace abut
