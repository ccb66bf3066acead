// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/linear_solver.hpp"
#include "abut/solver/load_stepping.hpp"

#include "dense_system.hpp"
#include "pulled_block.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace abut {
namespace {

using test::DenseSystem;
using test::Values;

/// Solves no better than it is asked to: the residual that it leaves is the tolerance.
class Grudging : public solver::LinearSolver {
public:
  explicit Grudging(const solver::NonlinearSystem& system)
      : LinearSolver("grudging"), exact_(solver::make_linear_solver({}, system)) {}
  std::vector<double> asked;

private:
  void do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) override {
    exact_->setup(matrix, graph_version, symmetric);
  }
  solver::LinearResult do_solve(const Vector& b, Vector& x, double tolerance) override {
    asked.push_back(tolerance);
    exact_->solve(b, x, tolerance);
    x.scale(1.0 + tolerance);
    return {1, tolerance};
  }
  std::unique_ptr<solver::LinearSolver> exact_;
};

/// f = K x + stiffening x^3 - 1 (component by component).
DenseSystem springs(double stiffening, bool symmetric = true) {
  DenseSystem system(
      2,
      [=](const Values& x) {
        const auto cube = [](double v) { return v * v * v; };
        return Values{2 * x[0] - x[1] + stiffening * cube(x[0]) - 1,
                      2 * x[1] - x[0] + stiffening * cube(x[1]) - 1};
      },
      [=](const Values& x) {
        return Values{2 + 3 * stiffening * x[0] * x[0], -1, -1, 2 + 3 * stiffening * x[1] * x[1]};
      });
  system.is_symmetric = symmetric;
  return system;
}

solver::NewtonResult solve(DenseSystem& system, solver::NewtonSolver& newton) {
  Vector x = system.vector({0.0, 0.0});
  const auto result = newton.solve(system, x);
  EXPECT_TRUE(result.converged) << result.reason;
  return result;
}

TEST(ForcingTerms, CostNewtonNoIterations) {
  for (const double stiffening : {0.1, 1.0, 10.0}) {
    DenseSystem system = springs(stiffening);
    Grudging exact(system), loose(system);
    solver::NewtonSolver strict(exact, {}, 1e-12), forced(loose, {});
    EXPECT_EQ(solve(system, forced).iterations, solve(system, strict).iterations) << stiffening;
    EXPECT_EQ(loose.asked.front(), 1e-3);
    const double tightest = *std::min_element(loose.asked.begin(), loose.asked.end());
    EXPECT_LT(tightest, 1e-4); // Newton's second order is not given away
    EXPECT_GT(tightest, 1e-9); // nor is it more than it needs
    for (const double tolerance : exact.asked)
      EXPECT_EQ(tolerance, 1e-12);
  }
}

// A solve that ends by its correction does not need second order to the end.
TEST(ForcingTerms, GoNoFurtherThanACorrectionNeeds) {
  double tightest[2];
  for (const bool by_correction : {false, true}) {
    DenseSystem system = springs(1.0);
    Grudging linear(system), exact(system);
    solver::NewtonOptions options;
    if (by_correction)
      options.displacement_tolerance = 1e-3;
    solver::NewtonSolver newton(linear, options), strict(exact, options, 1e-12);
    EXPECT_EQ(solve(system, newton).iterations, solve(system, strict).iterations);
    tightest[by_correction] = *std::min_element(linear.asked.begin(), linear.asked.end());
  }
  EXPECT_GT(tightest[true], 10.0 * tightest[false]);
}

TEST(ForcingTerms, LearnThatASceneIsLinear) {
  DenseSystem system = springs(0.0);
  Grudging linear(system);
  solver::NewtonSolver newton(linear, {});
  EXPECT_EQ(solve(system, newton).iterations, 2); // it takes the first to see it
  EXPECT_EQ(solve(system, newton).iterations, 1);
  EXPECT_EQ(solve(system, newton).iterations, 1);
}

TEST(ForcingTerms, GoFurtherWithFriction) {
  double tightest[2];
  for (const bool symmetric : {true, false}) {
    DenseSystem system = springs(0.0, symmetric);
    Grudging linear(system);
    solver::NewtonSolver newton(linear, {});
    solve(system, newton);
    tightest[symmetric] = *std::min_element(linear.asked.begin(), linear.asked.end());
  }
  EXPECT_LT(tightest[false], 1e-2 * tightest[true]);
}

TEST(ForcingTerms, LeaveTheChoiceToANoxList) {
  DenseSystem system = springs(1.0);
  Grudging linear(system);
  solver::NewtonOptions options;
  options.nox = R"(<ParameterList><ParameterList name="Direction"><ParameterList name="Newton">
    <ParameterList name="Linear Solver"><Parameter name="Tolerance" type="double" value="3e-5"/>
    </ParameterList></ParameterList></ParameterList></ParameterList>)";
  solver::NewtonSolver newton(linear, options);
  solve(system, newton);
  for (const double tolerance : linear.asked)
    EXPECT_EQ(tolerance, 3e-5);
}

TEST(ForcingTerms, PredictionOfALinearSceneIsItsSolution) {
  test::PulledBlock block(6);
  solver::LinearOptions options;
  options.method = solver::LinearMethod::krylov;
  const auto linear = solver::make_linear_solver(options, block);
  solver::NewtonOptions newton_options;
  newton_options.tolerance = 1e-6;
  solver::NewtonSolver newton(*linear, newton_options);
  solver::AugmentedLagrangian loop(newton);
  solver::TimeOptions time;
  time.steps = 3;
  Vector x(block.map());
  const auto result = solver::LoadStepping(loop, time).run(block, x);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_EQ(result.counters.newton_iterations, 0);
}

} // namespace
} // namespace abut
