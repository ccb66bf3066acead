// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/augmented.hpp"

#include "abut/solver/linear_solver.hpp"
#include "dense_system.hpp"

#include <gtest/gtest.h>
#include <memory>

namespace abut {
namespace {

using solver::AugmentReport;
using test::DenseSystem;
using test::Values;

/// Two springs in a row, pulled by `force` against a rigid stop at `gap`.
struct Stop {
  double k0 = 3.0, k1 = 6.0, force = 10.0, gap = 1.0, penalty = 4.0, multiplier = 0.0;

  double stiffness() const { return k0 * k1 / (k0 + k1); } ///< felt at the stop
  double exact_force() const { return force - stiffness() * gap; }
  double traction(double x) const { return std::max(0.0, multiplier + penalty * (x - gap)); }

  DenseSystem system() const {
    return {2,
            [this](const Values& x) {
              const double pull = k1 * (x[1] - x[0]);
              return Values{k0 * x[0] - pull, pull + traction(x[1]) - force};
            },
            [this](const Values& x) {
              return Values{k0 + k1, -k1, -k1, k1 + (traction(x[1]) > 0.0 ? penalty : 0.0)};
            }};
  }
};

class Augmented : public ::testing::Test {
protected:
  Augmented() : system(stop.system()) {
    system.reference = 10.0;
    solver::NewtonOptions options;
    options.tolerance = 1e-13;
    linear = solver::make_linear_solver({}, system);
    newton = std::make_unique<solver::NewtonSolver>(*linear, options);
    x = std::make_unique<Vector>(system.vector({0.0, 0.0}));
  }
  double contact_force() const { return stop.traction(system.gather(*x)[1]); }

  Stop stop;
  DenseSystem system;
  std::unique_ptr<solver::LinearSolver> linear;
  std::unique_ptr<solver::NewtonSolver> newton;
  std::unique_ptr<Vector> x;
};

TEST_F(Augmented, WithoutCallbackIsOnePenaltySolve) {
  solver::AugmentedLagrangian loop(*newton);
  const auto result = loop.solve(system, *x);
  ASSERT_TRUE(result.converged);
  EXPECT_EQ(result.augmentations, 0);
  EXPECT_EQ(result.solves.size(), 1u);
  // The penalty spring shares the load with the others.
  const double penetration = stop.exact_force() / (stop.stiffness() + stop.penalty);
  EXPECT_NEAR(system.gather(*x)[1], stop.gap + penetration, 1e-13);
}

TEST_F(Augmented, ApproachesFromAnOverloadedState) {
  system.is_overloaded = true;
  int approached = 0, newton_from = -1;
  const auto observer = [&](const solver::IterationReport& r) {
    if (r.approach)
      approached = r.iteration;
    else if (r.iteration == 0)
      newton_from = r.residual < 1e-2 * system.reference;
  };
  const auto result = solver::AugmentedLagrangian(*newton).solve(system, *x, observer);
  ASSERT_TRUE(result.converged);
  EXPECT_EQ(system.solves, (std::vector{SolveKind::approach, SolveKind::newton}));
  EXPECT_GT(approached, 0);
  EXPECT_EQ(newton_from, 1);
  EXPECT_EQ(result.iterations, approached + result.solves.front().iterations);
  EXPECT_EQ(result.solves.size(), 1u);
}

TEST_F(Augmented, GoesOnFromThePredictedStateWhereAnApproachFails) {
  DenseSystem* self = nullptr;
  int met = 0;
  DenseSystem cliff(
      1,
      [&](const Values& v) {
        const bool falls = self->solves.back() == SolveKind::approach && v[0] != 0.0;
        met += falls;
        return falls ? Values() : Values{v[0] - 1.0};
      },
      [](const Values&) { return Values{1.0}; });
  self = &cliff;
  cliff.is_overloaded = true;
  cliff.solves = {SolveKind::prediction};
  Vector at = cliff.vector({0.0});
  double first = 0.0;
  const auto result =
      solver::AugmentedLagrangian(*newton).solve(cliff, at, [&](const solver::IterationReport& r) {
        if (!r.approach && r.iteration == 0)
          first = r.residual;
      });
  ASSERT_TRUE(result.converged) << result.reason;
  EXPECT_GT(met, 0);
  EXPECT_EQ(first, 1.0); // at the start, not where the approach left off
  EXPECT_NEAR(cliff.gather(at)[0], 1.0, 1e-12);
}

/// Newton has no residual at the start, nor anywhere left of 0.5; a landing has it.
struct Shore {
  DenseSystem* self = nullptr;
  bool all_fail = false;
  DenseSystem system{1,
                     [this](const Values& v) {
                       const bool newton = self->solves.back() == SolveKind::newton;
                       return all_fail || (newton && v[0] < 0.5) ? Values() : Values{v[0] - 1.0};
                     },
                     [](const Values&) { return Values{1.0}; }};
  Shore() {
    self = &system;
    system.solves = {SolveKind::prediction};
  }
};

TEST_F(Augmented, TriesOnceMoreFromALandingWhereNewtonFails) {
  Shore shore;
  shore.system.does_land = true;
  Vector at = shore.system.vector({0.0});
  const auto result = solver::AugmentedLagrangian(*newton).solve(shore.system, at);
  ASSERT_TRUE(result.converged) << result.reason;
  EXPECT_EQ(shore.system.solves, (std::vector{SolveKind::prediction, SolveKind::newton,
                                              SolveKind::landing, SolveKind::newton}));
  EXPECT_EQ(result.solves.size(), 1u);
  EXPECT_GT(result.iterations, 0); // those of the landing count
  EXPECT_NEAR(shore.system.gather(at)[0], 1.0, 1e-12);
}

TEST_F(Augmented, SaysWhyNewtonFailedWhereALandingFailsOrDiffersInNothing) {
  for (const bool lands : {true, false}) {
    Shore shore;
    shore.all_fail = lands;
    shore.system.does_land = lands;
    Vector at = shore.system.vector({0.0});
    EXPECT_THROW(solver::AugmentedLagrangian(*newton).solve(shore.system, at), SolveError);
    EXPECT_EQ(shore.system.solves.back(), lands ? SolveKind::landing : SolveKind::newton);
    EXPECT_EQ(shore.system.gather(at)[0], 0.0); // where the step began
  }
}

TEST_F(Augmented, ContractsByTheUzawaFactor) {
  Values errors;
  const auto augment = [&](int) {
    const double force = contact_force();
    AugmentReport report;
    errors.push_back(stop.exact_force() - force);
    report.change = std::abs(force - stop.multiplier) / force;
    report.converged = report.change < 1e-13;
    if (!report.converged)
      stop.multiplier = force;
    return report;
  };
  solver::AugmentedLagrangian loop(*newton, augment);
  const auto result = loop.solve(system, *x);
  ASSERT_TRUE(result.converged) << result.reason;
  EXPECT_EQ(result.augmentations + 1, static_cast<int>(errors.size()));
  EXPECT_EQ(result.solves.size(), errors.size());
  EXPECT_GT(result.augmentations, 10);
  const double factor = stop.stiffness() / (stop.stiffness() + stop.penalty);
  int compared = 0;
  for (std::size_t i = 1; i < errors.size() && errors[i] > 1e-4; ++i, ++compared)
    EXPECT_NEAR(errors[i] / errors[i - 1], factor, 1e-10);
  EXPECT_GE(compared, 5);
  EXPECT_NEAR(stop.multiplier, stop.exact_force(), 1e-11);
  EXPECT_NEAR(system.gather(*x)[1], stop.gap, 1e-11);
}

// Multipliers that are good enough are followed by Newton's own tolerance: to contact that is the
// same solve, which must not start its search anew.
TEST_F(Augmented, FinerToleranceIsNoNewSolve) {
  solver::AugmentedLagrangian loop(*newton, [&](int augmentation) {
    AugmentReport report;
    report.change = 1.0;
    report.converged = augmentation == 2;
    if (!report.converged)
      stop.multiplier = contact_force();
    return report;
  });
  const auto result = loop.solve(system, *x);
  ASSERT_TRUE(result.converged) << result.reason;
  EXPECT_EQ(result.solves.size(), 4u); // the last one finer
  EXPECT_EQ(system.solves, (std::vector{SolveKind::newton, SolveKind::after_augmentation,
                                        SolveKind::after_augmentation}));
}

// Beside large forces elsewhere that of an augmentation is small; multipliers that grew again
// before it has moved anything would grow for nothing.
TEST_F(Augmented, MovesBetweenAugmentationsBesideLargeForces) {
  system.reference = 5e3;
  const auto augment = [&](int) {
    const double force = contact_force();
    AugmentReport report;
    report.change = std::abs(force - stop.multiplier) / force;
    report.converged = report.change < 1e-6;
    if (!report.converged)
      stop.multiplier = force;
    return report;
  };
  ASSERT_TRUE(newton->options().inexact);
  solver::AugmentedLagrangian loop(*newton, augment);
  const auto result = loop.solve(system, *x);
  ASSERT_TRUE(result.converged) << result.reason;
  ASSERT_GT(result.augmentations, 5);
  EXPECT_EQ(result.solves[0].iterations, 2); // down to a tenth, as all others
  for (int i = 1; i <= result.augmentations; ++i)
    EXPECT_EQ(result.solves[std::size_t(i)].iterations, 1) << i;
  EXPECT_NEAR(stop.multiplier, stop.exact_force(), 1e-5 * stop.exact_force());
}

TEST_F(Augmented, TheCallbackCanBeReplaced) {
  solver::AugmentedLagrangian loop(*newton, [](int) { return AugmentReport{}; });
  EXPECT_EQ(loop.solve(system, *x).augmentations, 0);
  // The exact multiplier at once: one augmentation.
  loop.set_callback([&](int augmentation) {
    AugmentReport report;
    report.converged = augmentation == 1;
    stop.multiplier = stop.exact_force();
    return report;
  });
  const auto result = loop.solve(system, *x);
  ASSERT_TRUE(result.converged);
  EXPECT_EQ(result.augmentations, 1);
  EXPECT_NEAR(system.gather(*x)[1], stop.gap, 1e-13);
}

TEST_F(Augmented, StopsAtAPlateauAndSaysSo) {
  solver::AugmentedLagrangian loop(*newton, [&](int augmentation) {
    AugmentReport report;
    report.converged = false;
    report.stalled = augmentation == 3;
    if (report.stalled)
      report.reason = "The gap no longer falls.";
    stop.multiplier += 0.1;
    return report;
  });
  const auto result = loop.solve(system, *x);
  EXPECT_TRUE(result.converged);
  EXPECT_TRUE(result.stalled);
  EXPECT_EQ(result.augmentations, 3);
  EXPECT_EQ(result.reason, "The gap no longer falls.");
}

TEST_F(Augmented, ReportsAFailedSolve) {
  solver::NewtonOptions options;
  options.max_iterations = 0;
  solver::NewtonSolver impatient(*linear, options);
  int calls = 0;
  solver::AugmentedLagrangian loop(impatient, [&](int) {
    ++calls;
    return AugmentReport{};
  });
  const auto result = loop.solve(system, *x);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(calls, 0);
  EXPECT_FALSE(result.reason.empty());
}

} // namespace
} // namespace abut
