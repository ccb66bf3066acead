// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/linear_solver.hpp"

#include "dense_system.hpp"
#include "elastic_block.hpp"

#include <gtest/gtest.h>

namespace abut {
namespace {

using solver::LinearMethod;
using solver::LinearOptions;
using solver::Preconditioner;
using test::ElasticBlock;

double distance(const Vector& a, const Vector& b) {
  Vector difference(a, Teuchos::Copy);
  difference.update(-1.0, b, 1.0);
  return difference.norm2() / b.norm2();
}

struct Outcome {
  solver::LinearResult result;
  double error; ///< relative, of the solution
};

Outcome solve_for_known(solver::LinearSolver& linear, const ElasticBlock& block, double tolerance) {
  const Vector exact = test::wavy_vector(block.map());
  Vector b(block.map()), x(block.map());
  block.matrix()->apply(exact, b);
  linear.setup(block.matrix(), block.graph_version(), block.symmetric());
  const auto result = linear.solve(b, x, tolerance);
  return {result, distance(x, exact)};
}

LinearOptions direct() {
  LinearOptions options;
  options.method = LinearMethod::direct;
  return options;
}

LinearOptions krylov(Preconditioner preconditioner) {
  LinearOptions options;
  options.method = LinearMethod::krylov;
  options.preconditioner = preconditioner;
  return options;
}

TEST(DirectSolver, FindsKnownSolutionSymmetricAndNot) {
  for (const bool skew : {false, true})
    for (const long long first_id : {0LL, 5000LL}) {
      const ElasticBlock block(6, {false, skew, first_id});
      ASSERT_EQ(block.symmetric(), !skew);
      const auto linear = solver::make_linear_solver(direct(), block);
      const auto outcome = solve_for_known(*linear, block, 1e-8);
      EXPECT_LT(outcome.result.relative_residual, 1e-13);
      EXPECT_LT(outcome.error, 1e-11); // condition number about 1e3
      EXPECT_EQ(outcome.result.iterations, 1);
    }
}

TEST(DirectSolver, IsTakenWhereMultipliersAreUnknowns) {
  using test::Values;
  test::DenseSystem system(
      2, [](const Values& x) { return x; },
      [](const Values&) {
        return Values{0.0, 2.0, 2.0, 0.0};
      });
  system.is_indefinite = true;
  const auto linear = solver::make_linear_solver(krylov(Preconditioner::automatic), system);
  const Vector b = system.vector({6.0, 4.0});
  Vector x(system.map());
  linear->setup(system.tangent(b), 0, false);
  EXPECT_EQ(linear->solve(b, x, 1e-8).iterations, 1);
  EXPECT_EQ(system.gather(x), (Values{2.0, 3.0}));
}

TEST(DirectSolver, UsesTheWholeOfAnUnsymmetricMatrix) {
  const ElasticBlock skew(3, {false, true, 0}), plain(3);
  const auto linear = solver::make_linear_solver(direct(), skew);
  const Vector b = test::wavy_vector(skew.map());
  Vector x(skew.map()), y(skew.map());
  linear->setup(skew.matrix(), 0, false);
  linear->solve(b, x, 1e-8);
  linear->setup(plain.matrix(), 0, true);
  linear->solve(b, y, 1e-8);
  EXPECT_GT(distance(x, y), 1e-3);
}

TEST(DirectSolver, TakesNewValuesAndNewGraphs) {
  const ElasticBlock block(4);
  const auto linear = solver::make_linear_solver(direct(), block);
  solve_for_known(*linear, block, 1e-8);
  // New values in the old graph.
  const auto scaled = rcp(new Matrix(*block.matrix(), Teuchos::Copy));
  scaled->resumeFill();
  scaled->scale(4.0);
  scaled->fillComplete();
  const Vector b = test::wavy_vector(block.map());
  Vector x(block.map()), y(block.map());
  linear->setup(block.matrix(), 0, true);
  linear->solve(b, x, 1e-8);
  linear->setup(scaled, 0, true);
  linear->solve(b, y, 1e-8);
  y.scale(4.0);
  EXPECT_LT(distance(y, x), 1e-13);
  // Another graph: the diagonal alone.
  Vector diagonal(block.map());
  block.matrix()->getLocalDiagCopy(diagonal);
  const auto sparse = rcp(new Matrix(block.map(), 1));
  {
    const auto d = diagonal.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < d.extent(0); ++i) {
      const Global row = block.map()->getGlobalElement(static_cast<Local>(i));
      const double value = d(i, 0);
      sparse->insertGlobalValues(row, 1, &value, &row);
    }
  }
  sparse->fillComplete();
  linear->setup(sparse, 1, true);
  linear->solve(b, x, 1e-8);
  y.elementWiseMultiply(1.0, diagonal, x, 0.0);
  EXPECT_LT(distance(y, b), 1e-14);
}

TEST(DirectSolver, NamesASingularMatrix) {
  for (const bool skew : {false, true}) {
    const ElasticBlock block(3, {true, skew, 0});
    const auto linear = solver::make_linear_solver(direct(), block);
    const Vector b = test::wavy_vector(block.map());
    Vector x(block.map());
    try {
      linear->setup(block.matrix(), 0, block.symmetric());
      linear->solve(b, x, 1e-8);
      // The skew part may hold the block; then the solution must be one.
      EXPECT_TRUE(skew) << "a floating block was solved";
    } catch (const SolveError& e) {
      EXPECT_NE(std::string(e.what()).find("singular"), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("free to move"), std::string::npos) << e.what();
    }
  }
}

TEST(DirectSolver, NamesASingularMatrixEvenForConsistentLoads) {
  const ElasticBlock block(3, {true, false, 0});
  const auto linear = solver::make_linear_solver(direct(), block);
  EXPECT_THROW(solve_for_known(*linear, block, 1e-8), SolveError);
}

TEST(LinearSolver, ZeroRightHandSideGivesZero) {
  const ElasticBlock block(3);
  for (const auto& options : {direct(), krylov(Preconditioner::ilu)}) {
    const auto linear = solver::make_linear_solver(options, block);
    linear->setup(block.matrix(), 0, true);
    const Vector b(block.map());
    Vector x = test::wavy_vector(block.map());
    EXPECT_EQ(linear->solve(b, x, 1e-8).iterations, 0);
    EXPECT_EQ(x.norm2(), 0.0);
  }
}

TEST(KrylovSolver, FindsKnownSolution) {
  for (const bool skew : {false, true})
    for (const auto preconditioner :
         {Preconditioner::multigrid, Preconditioner::muelu, Preconditioner::ilu}) {
      const ElasticBlock block(12, {false, skew, 0});
      const auto linear = solver::make_linear_solver(krylov(preconditioner), block);
      const auto outcome = solve_for_known(*linear, block, 1e-8);
      EXPECT_LT(outcome.result.relative_residual, 1e-7);
      EXPECT_LT(outcome.error, 1e-5);
      const int most = preconditioner == Preconditioner::ilu ? 80 : 30;
      EXPECT_LT(outcome.result.iterations, most);
      EXPECT_GT(outcome.result.iterations, 2);
    }
}

TEST(KrylovSolver, MultigridBarelyFeelsTheMesh) {
  const ElasticBlock coarse(6), fine(16);
  int iterations[2];
  int i = 0;
  for (const auto* block : {&coarse, &fine}) {
    const auto linear = solver::make_linear_solver(krylov(Preconditioner::automatic), *block);
    iterations[i++] = solve_for_known(*linear, *block, 1e-8).result.iterations;
  }
  EXPECT_LE(iterations[1], 2 * iterations[0] + 6);
}

TEST(KrylovSolver, SaysWhyItFailed) {
  const ElasticBlock block(6);
  auto options = krylov(Preconditioner::ilu);
  options.max_iterations = 3;
  const auto linear = solver::make_linear_solver(options, block);
  try {
    solve_for_known(*linear, block, 1e-8);
    FAIL() << "three iterations cannot do";
  } catch (const SolveError& e) {
    EXPECT_NE(std::string(e.what()).find("3 iterations"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("residual"), std::string::npos) << e.what();
  }
}

TEST(KrylovSolver, GmresTakesOverWhereConjugateGradientsFail) {
  const ElasticBlock skew(8, {false, true, 0, 10.0});
  int messages = 0;
  const auto log = [&](LogLevel, const std::string&) { ++messages; };
  const auto linear = solver::make_linear_solver(krylov(Preconditioner::ilu), skew, log);
  const Vector exact = test::wavy_vector(skew.map());
  Vector b(skew.map()), x(skew.map());
  skew.matrix()->apply(exact, b);
  linear->setup(skew.matrix(), 0, true); // which it is not
  EXPECT_LT(linear->solve(b, x, 1e-8).relative_residual, 1e-7);
  EXPECT_LT(distance(x, exact), 1e-5);
  EXPECT_EQ(messages, 1);
}

TEST(KrylovSolver, KeepsThePreconditionerWhileItServes) {
  const ElasticBlock block(6), skew(6, {false, true, 0});
  const auto linear = solver::make_linear_solver(krylov(Preconditioner::muelu), block);
  const int fresh = solve_for_known(*linear, block, 1e-8).result.iterations;
  EXPECT_EQ(solve_for_known(*linear, block, 1e-8).result.iterations, fresh);
  EXPECT_LT(solve_for_known(*linear, skew, 1e-8).error, 1e-5);
  linear->forget();
  EXPECT_EQ(solve_for_known(*linear, block, 1e-8).result.iterations, fresh);
}

TEST(LinearSolver, AutomaticChoosesBySizeAndFallsBack) {
  const ElasticBlock block(6); // more unknowns than multigrid's coarsest level
  LinearOptions options;
  EXPECT_EQ(
      solve_for_known(*solver::make_linear_solver(options, block), block, 1e-8).result.iterations,
      1);
  options.direct_limit = 100;
  EXPECT_GT(
      solve_for_known(*solver::make_linear_solver(options, block), block, 1e-8).result.iterations,
      1);
  options.max_iterations = 2;
  int warnings = 0;
  const auto log = [&](LogLevel level, const std::string&) {
    warnings += level == LogLevel::warning;
  };
  const auto linear = solver::make_linear_solver(options, block, log);
  const auto outcome = solve_for_known(*linear, block, 1e-8);
  EXPECT_EQ(warnings, 1);
  EXPECT_LT(outcome.error, 1e-11);
}

TEST(LinearSolver, PassesListsThrough) {
  const ElasticBlock block(6);
  auto options = krylov(Preconditioner::ilu);
  const int plain =
      solve_for_known(*solver::make_linear_solver(options, block), block, 1e-8).result.iterations;
  options.ifpack2 = R"(<ParameterList><ParameterList name="inner preconditioner parameters">
    <Parameter name="fact: iluk level-of-fill" type="int" value="2"/></ParameterList></ParameterList>)";
  const int filled =
      solve_for_known(*solver::make_linear_solver(options, block), block, 1e-8).result.iterations;
  EXPECT_LT(filled, plain);
  options.belos = "<ParameterList><oops/>";
  EXPECT_THROW(solver::make_linear_solver(options, block), InputError);
}

TEST(LinearSolver, TimesItselfAndCounts) {
  const ElasticBlock block(6);
  PhaseTimers timers;
  const auto linear = solver::make_linear_solver(direct(), block, {}, &timers);
  solve_for_known(*linear, block, 1e-8);
  EXPECT_GT(timers.seconds(Phase::linear_solve), 0.0);
  EXPECT_EQ(linear->total_iterations(), 1);
}

} // namespace
} // namespace abut
