// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/newton.hpp"

#include "abut/solver/linear_solver.hpp"
#include "dense_system.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <optional>

namespace abut {
namespace {

using solver::IterationReport;
using solver::NewtonOptions;
using solver::NewtonResult;
using test::DenseSystem;
using test::Values;

struct Solved {
  NewtonResult result;
  Values x;
  std::vector<IterationReport> reports;
};

Solved solve(DenseSystem& system, const Values& start, NewtonOptions options = {}) {
  const auto linear = solver::make_linear_solver({}, system);
  solver::NewtonSolver newton(*linear, options);
  Vector x = system.vector(start);
  Solved solved;
  solved.result = newton.solve(system, x, [&](const auto& r) { solved.reports.push_back(r); });
  solved.x = system.gather(x);
  return solved;
}

/// x0^2 + x1 = 3, x0 - x1^2 = -1.5 + ... with the root (1, 2): quadratic near it.
DenseSystem two_unknowns() {
  return {2,
          [](const Values& x) {
            return Values{x[0] * x[0] + x[1] - 3.0, x[0] - x[1] * x[1] + 3.0};
          },
          [](const Values& x) {
            return Values{2.0 * x[0], 1.0, 1.0, -2.0 * x[1]};
          }};
}

TEST(Newton, ConvergesQuadratically) {
  auto system = two_unknowns();
  NewtonOptions options;
  options.tolerance = 1e-13;
  const auto solved = solve(system, {2.0, 3.0}, options);
  ASSERT_TRUE(solved.result.converged) << solved.result.reason;
  EXPECT_NEAR(solved.x[0], 1.0, 1e-13);
  EXPECT_NEAR(solved.x[1], 2.0, 1e-13);
  const auto& r = solved.result.residual_history;
  ASSERT_GE(r.size(), 5u);
  int quadratic = 0;
  for (std::size_t i = 1; i < r.size(); ++i)
    if (r[i - 1] < 0.5 && r[i] > 1e-14)
      quadratic += r[i] <= r[i - 1] * r[i - 1];
  EXPECT_GE(quadratic, 2);
  EXPECT_EQ(solved.result.linear_iterations, solved.result.iterations);
}

// The point of the unit circle farthest along (1, -1/2), the force of the circle as third unknown:
// the slope along the first step changes its sign, though the residual halves.
TEST(Newton, TakesFullStepsThatHelpWhereMultipliersAreUnknowns) {
  for (const bool indefinite : {false, true}) {
    DenseSystem system(
        3,
        [](const Values& x) {
          return Values{x[2] * x[0] - 1.0, x[2] * x[1] + 0.5,
                        0.5 * (x[0] * x[0] + x[1] * x[1] - 1.0)};
        },
        [](const Values& x) { return Values{x[2], 0.0, x[0], 0.0, x[2], x[1], x[0], x[1], 0.0}; });
    system.is_indefinite = indefinite;
    const auto solved = solve(system, {2.0, 0.0, 0.5});
    ASSERT_TRUE(solved.result.converged) << solved.result.reason;
    EXPECT_NEAR(std::fabs(solved.x[0]), std::sqrt(0.8), 1e-7);
    EXPECT_EQ(solved.reports[1].step_length == 1.0, indefinite);
  }
}

TEST(Newton, ReportsEveryIterate) {
  auto system = two_unknowns();
  system.reference = 10.0;
  const auto solved = solve(system, {2.0, 3.0});
  ASSERT_EQ(solved.reports.size(), solved.result.residual_history.size());
  ASSERT_EQ(static_cast<int>(solved.reports.size()), solved.result.iterations + 1);
  EXPECT_EQ(solved.reports.front().step_length, 0.0);
  EXPECT_EQ(solved.reports.front().linear_iterations, 0);
  EXPECT_EQ(solved.reports.back().step_length, 1.0);
  EXPECT_EQ(solved.reports.back().linear_iterations, 1);
  EXPECT_EQ(solved.reports.back().residual, solved.result.residual);
  EXPECT_DOUBLE_EQ(solved.reports[1].relative, solved.reports[1].residual / 10.0);
}

TEST(Newton, StopsAtTheToleranceTimesTheReference) {
  auto loose = two_unknowns(), tight = two_unknowns();
  loose.reference = 1e6;
  const auto a = solve(loose, {2.0, 3.0}), b = solve(tight, {2.0, 3.0});
  EXPECT_LT(a.result.iterations, b.result.iterations);
  EXPECT_LE(a.result.residual, 1e-2);
  EXPECT_EQ(a.result.reference, 1e6);
}

// The correction that ends the solve is within its share of the increment since the start of the
// step, the one before it was not.
TEST(Newton, EndsAtASmallCorrection) {
  auto system = two_unknowns();
  const auto linear = solver::make_linear_solver({}, system);
  const auto iterates = [&](std::optional<double> tolerance, double energy, bool from_step) {
    NewtonOptions options;
    options.tolerance = 1e-13;
    options.displacement_tolerance = tolerance;
    options.energy_tolerance = energy;
    solver::NewtonSolver newton(*linear, options);
    if (from_step)
      newton.begin_step(system.vector({-997.0, 3.0}));
    Vector x = system.vector({2.0, 3.0});
    const auto result = newton.solve(system, x);
    EXPECT_TRUE(result.converged);
    return std::pair(result, system.gather(x));
  };
  const auto [full, root] = iterates(std::nullopt, 1e-2, false);
  const auto [loose, x] = iterates(1e-2, 1e-2, false);
  EXPECT_LT(loose.iterations, full.iterations);
  EXPECT_GT(loose.residual, full.residual);
  EXPECT_NEAR(x[0], root[0], 1e-5);
  EXPECT_NEAR(x[1], root[1], 1e-5);
  // A longer way from the start of the step allows a longer correction, but not if its work counts.
  EXPECT_LT(iterates(1e-2, 1.0, true).first.iterations, loose.iterations);
  EXPECT_GT(iterates(1e-2, 1e-8, true).first.iterations,
            iterates(1e-2, 1.0, true).first.iterations);
}

TEST(Newton, TakesNoIterationAtTheSolution) {
  auto system = two_unknowns();
  system.reference = 0.0; // nothing to compare with: zero is converged all the same
  const auto solved = solve(system, {1.0, 2.0});
  EXPECT_TRUE(solved.result.converged);
  EXPECT_EQ(solved.result.iterations, 0);
  EXPECT_EQ(solved.x[0], 1.0);
}

TEST(Newton, LineSearchTamesAnOvershoot) {
  const auto f = [](const Values& x) { return Values{std::atan(x[0]), x[1] - 1.0}; };
  const auto derivative = [](const Values& x) {
    return Values{1.0 / (1.0 + x[0] * x[0]), 0.0, 0.0, 1.0};
  };
  NewtonOptions plain;
  plain.line_search = solver::LineSearch::none;
  plain.max_iterations = 12;
  for (const double start : {3.0, 6.0, 10.0}) {
    DenseSystem with(2, f, derivative), without(2, f, derivative);
    const auto solved = solve(with, {start, 0.0});
    ASSERT_TRUE(solved.result.converged) << start << solved.result.reason;
    EXPECT_LT(solved.result.iterations, 15);
    bool shortened = false;
    for (const auto& r : solved.reports)
      shortened |= r.iteration > 0 && r.step_length < 1.0;
    EXPECT_TRUE(shortened);
    try {
      EXPECT_FALSE(solve(without, {start, 0.0}, plain).result.converged);
    } catch (const SolveError&) {
      // So far out that the derivative is numerically zero.
    }
  }
}

TEST(Newton, CurvedValley) {
  // Stationary point of Rosenbrock's function (1 - a)^2 + 100 (b - a^2)^2 from the usual start.
  DenseSystem system(
      2,
      [](const Values& x) {
        const double c = x[1] - x[0] * x[0];
        return Values{-2.0 * (1.0 - x[0]) - 400.0 * x[0] * c, 200.0 * c};
      },
      [](const Values& x) {
        return Values{2.0 + 1200.0 * x[0] * x[0] - 400.0 * x[1], -400.0 * x[0], -400.0 * x[0],
                      200.0};
      });
  system.is_symmetric = true;
  const auto solved = solve(system, {-1.2, 1.0});
  ASSERT_TRUE(solved.result.converged) << solved.result.reason;
  EXPECT_NEAR(solved.x[0], 1.0, 1e-8);
  EXPECT_NEAR(solved.x[1], 1.0, 1e-8);
}

TEST(Newton, ShortensAStepIntoInvalidStates) {
  // log x is defined for x > 0 only; Newton from 20 steps to 20 - 20 log 20 < 0.
  const auto derivative = [](const Values& x) { return Values{1.0 / x[0]}; };
  for (const bool throws : {true, false}) {
    DenseSystem system(
        1,
        [throws](const Values& x) {
          if (x[0] > 0.0)
            return Values{std::log(x[0])};
          return throws ? Values{} : Values{std::numeric_limits<double>::quiet_NaN()};
        },
        derivative);
    const auto solved = solve(system, {20.0});
    ASSERT_TRUE(solved.result.converged);
    EXPECT_NEAR(solved.x[0], 1.0, 1e-8);
    EXPECT_LT(solved.reports[1].step_length, 1.0);
  }
}

TEST(Newton, PassesSolveErrorsOn) {
  DenseSystem nowhere(
      2, [](const Values&) { return Values{}; },
      [](const Values&) {
        return Values{1, 0, 0, 1};
      });
  EXPECT_THROW(solve(nowhere, {1.0, 1.0}), SolveError);
  DenseSystem singular(
      2,
      [](const Values&) {
        return Values{1, 1};
      },
      [](const Values&) {
        return Values{1, -1, -1, 1};
      });
  EXPECT_THROW(solve(singular, {1.0, 1.0}), SolveError);
}

/// A row of springs, each node of which may touch its own stiff stop at once.
DenseSystem stops(int n, double stiffness) {
  const auto gap = [](int i) { return 0.01 * (i + 1); };
  return {n,
          [=](const Values& x) {
            Values f(x.size());
            for (int i = 0; i < n; ++i) {
              f[i] = 2.0 * x[i] - (i ? x[i - 1] : 0.0) - (i + 1 < n ? x[i + 1] : 0.0) - 0.1;
              f[i] += stiffness * std::max(0.0, x[i] - gap(i));
            }
            return f;
          },
          [=](const Values& x) {
            Values k(x.size() * x.size(), 0.0);
            for (int i = 0; i < n; ++i) {
              k[i * n + i] = 2.0 + (x[i] > gap(i) ? stiffness : 0.0);
              if (i)
                k[i * n + i - 1] = k[(i - 1) * n + i] = -1.0;
            }
            return k;
          }};
}

TEST(Newton, ClosingContactsDoNotStallTheLineSearch) {
  for (const double stiffness : {1e2, 1e4, 1e8}) {
    auto system = stops(20, stiffness);
    system.is_symmetric = true;
    const auto solved = solve(system, Values(20, 0.0));
    ASSERT_TRUE(solved.result.converged) << stiffness << ": " << solved.result.reason;
    EXPECT_LE(solved.result.iterations, 12) << stiffness;
    int touching = 0;
    for (int i = 0; i < 20; ++i)
      touching += solved.x[i] > 0.01 * (i + 1);
    EXPECT_GT(touching, 3);
  }
}

TEST(Newton, FollowsAChangingGraph) {
  const auto coupled = [](const Values& x) {
    // The coupling of the two exists only once x0 exceeds one.
    const double over = std::max(0.0, x[0] - 1.0);
    return Values{x[0] - 3.0 + 5.0 * over + x[1] * over, x[1] - 1.0 + over};
  };
  const auto derivative = [](const Values& x) {
    const double on = x[0] > 1.0 ? 1.0 : 0.0, over = std::max(0.0, x[0] - 1.0);
    return Values{1.0 + on * (5.0 + x[1]), over, on, 1.0};
  };
  DenseSystem changing(2, coupled, derivative), fixed(2, coupled, derivative);
  changing.changing_graph = true;
  const auto a = solve(changing, {0.0, 0.0}), b = solve(fixed, {0.0, 0.0});
  ASSERT_TRUE(a.result.converged) << a.result.reason;
  EXPECT_EQ(a.result.iterations, b.result.iterations);
  EXPECT_GT(changing.graph_version(), 1);
  EXPECT_NEAR(a.x[0], b.x[0], 1e-12);
  EXPECT_GT(a.x[0], 1.0);
}

TEST(Newton, SaysWhyItStopped) {
  NewtonOptions options;
  options.max_iterations = 2;
  auto slow = two_unknowns();
  auto solved = solve(slow, {50.0, 30.0}, options);
  EXPECT_FALSE(solved.result.converged);
  EXPECT_EQ(solved.result.iterations, 2);
  EXPECT_NE(solved.result.reason.find("2 iterations"), std::string::npos) << solved.result.reason;

  // x^3 - 2 x + 2 sends Newton from 0 to 1 and back for ever.
  options = {};
  options.line_search = solver::LineSearch::none;
  DenseSystem cycle(
      1, [](const Values& x) { return Values{x[0] * x[0] * x[0] - 2.0 * x[0] + 2.0}; },
      [](const Values& x) { return Values{3.0 * x[0] * x[0] - 2.0}; });
  solved = solve(cycle, {0.0}, options);
  EXPECT_FALSE(solved.result.converged);
  EXPECT_NE(solved.result.reason.find("cycle of 2"), std::string::npos) << solved.result.reason;
  EXPECT_LT(solved.result.iterations, 10);

  // A derivative of the wrong sign drives x away.
  DenseSystem away(
      1, [](const Values& x) { return Values{x[0]}; }, [](const Values&) { return Values{-0.01}; });
  solved = solve(away, {1.0}, options);
  EXPECT_FALSE(solved.result.converged);
  EXPECT_NE(solved.result.reason.find("diverges"), std::string::npos) << solved.result.reason;
}

TEST(Newton, TakesAUserList) {
  NewtonOptions options;
  options.nox = R"(<ParameterList><ParameterList name="Line Search">
    <Parameter name="Method" type="string" value="Full Step"/>
    <ParameterList name="Full Step"><Parameter name="Full Step" type="double" value="0.5"/>
    </ParameterList></ParameterList></ParameterList>)";
  options.max_iterations = 60;
  auto system = two_unknowns();
  const auto solved = solve(system, {2.0, 3.0}, options);
  ASSERT_TRUE(solved.result.converged);
  EXPECT_EQ(solved.reports[1].step_length, 0.5);
  EXPECT_GT(solved.result.iterations, 15); // half steps halve the error

  options.nox = "<ParameterList>";
  EXPECT_THROW(solve(system, {2.0, 3.0}, options), InputError);
  options.nox = R"(<ParameterList><Parameter name="Nonlinear Solver" type="string" value="Magic"/>
    </ParameterList>)";
  EXPECT_THROW(solve(system, {2.0, 3.0}, options), InputError);
}

} // namespace
} // namespace abut
