// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/load_stepping.hpp"

#include "abut/solver/linear_solver.hpp"
#include "dense_system.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace abut {
namespace {

using solver::LoadResult;
using solver::StepReport;
using solver::TimeOptions;
using test::DenseSystem;
using test::Values;

/// A hardening spring x + x^3 in series with a plastic slider, x[0] pulled by the load 4 t, and
/// x[1] following it; x[2] is prescribed to t. The slip of the slider is history: trial values are
/// computed with every residual, and a step larger than `largest_step` fails.
class Slider : public DenseSystem {
public:
  Slider()
      : DenseSystem(
            3, [this](const Values& x) { return force(x); },
            [this](const Values& x) { return stiffness(x); }) {
    reference = 4.0;
  }

  RCP<const Matrix> predictor(const Vector& x, Vector& rhs) override {
    const auto matrix = DenseSystem::predictor(x, rhs);
    Values all = gather(rhs);
    all[2] = time - gather(x)[2];
    scatter_to(all, rhs);
    return matrix;
  }
  void apply_constraints(Vector& x) override {
    Values all = gather(x);
    all[2] = time;
    scatter_to(all, x);
  }
  void accept(const Vector& x) override {
    DenseSystem::accept(x);
    slip = trial_slip;
    last_time = time;
  }
  void reject() override {
    DenseSystem::reject();
    trial_slip = slip;
  }

  double largest_step = std::numeric_limits<double>::infinity();
  double fails_beyond = std::numeric_limits<double>::infinity();
  int evaluations_before_failure = 0;
  double slip = 0.0, trial_slip = 0.0, last_time = 0.0;

private:
  static constexpr double yield = 0.5;

  void scatter_to(const Values& all, Vector& v) const { Tpetra::deep_copy(v, vector(all)); }

  Values force(const Values& x) {
    if (last_evaluated_ != time)
      evaluated_ = 0, last_evaluated_ = time;
    const bool too_far = time - last_time > largest_step * (1 + 1e-12) || time > fails_beyond;
    if (too_far && evaluated_++ >= evaluations_before_failure)
      return {};
    const double stretch = x[0] - slip, over = std::max(0.0, std::abs(stretch) - yield);
    trial_slip = slip + std::copysign(over, stretch);
    return {x[0] + x[0] * x[0] * x[0] + 2.0 * (x[0] - trial_slip) - 4.0 * time,
            x[1] + 0.3 * std::sin(x[1]) - x[0], 0.0};
  }
  Values stiffness(const Values& x) {
    const double elastic = std::abs(x[0] - slip) < yield ? 2.0 : 0.0;
    return {1.0 + 3.0 * x[0] * x[0] + elastic, 0, 0, -1, 1.0 + 0.3 * std::cos(x[1]), 0, 0, 0, 1};
  }

  double last_evaluated_ = -1.0;
  int evaluated_ = 0;
};

struct Run {
  LoadResult result;
  Values x;
  std::vector<StepReport> steps;
};

Run run(Slider& system, TimeOptions time, solver::NewtonOptions newton_options = {},
        double start = 0.0, const Values& from = {0.0, 0.0, 0.0}) {
  newton_options.tolerance = 1e-10;
  const auto linear = solver::make_linear_solver({}, system);
  solver::NewtonSolver newton(*linear, newton_options);
  solver::AugmentedLagrangian loop(newton);
  solver::LoadStepping stepping(loop, time);
  Vector x = system.vector(from);
  solver::Standing standing;
  standing.t = start;
  Run done;
  done.result = stepping.run(
      system, x, [&](const StepReport& r, const Vector&) { done.steps.push_back(r); }, {},
      standing);
  done.x = system.gather(x);
  return done;
}

TEST(LoadStepping, ReachesTheEndExactlyInEqualSteps) {
  Slider system;
  TimeOptions time;
  time.steps = 10;
  time.end = 0.9;
  const auto done = run(system, time);
  ASSERT_TRUE(done.result.converged) << done.result.reason;
  ASSERT_EQ(done.steps.size(), 10u);
  for (int k = 1; k <= 10; ++k) {
    EXPECT_EQ(done.steps[k - 1].t, 0.9 * k / 10);
    EXPECT_EQ(done.steps[k - 1].step, k);
  }
  EXPECT_EQ(done.result.t, 0.9);
  EXPECT_EQ(done.x[2], 0.9);
  EXPECT_EQ(system.accepted, 10);
  EXPECT_EQ(system.rejected, 0);
  EXPECT_GT(system.slip, 0.0); // history was made
  EXPECT_EQ(done.result.counters.steps, 10);
  EXPECT_EQ(done.result.counters.cut_backs, 0);
  EXPECT_EQ(done.result.counters.linear_iterations, done.result.counters.newton_iterations + 10);
  const double x = done.x[0];
  EXPECT_NEAR(x + x * x * x + 2.0 * 0.5, 4.0 * 0.9, 1e-9);
}

TEST(LoadStepping, PredictorFollowsPrescribedValues) {
  Slider system;
  TimeOptions time;
  time.steps = 100;
  const auto done = run(system, time);
  ASSERT_TRUE(done.result.converged);
  // Along the elastic start the predictor leaves an error of second order only.
  EXPECT_LT(done.steps[0].solves[0].residual_history[0], 1e-4);
}

TEST(LoadStepping, RetriedHalfStepEqualsADirectOne) {
  TimeOptions whole, halves;
  halves.steps = 2;
  for (const int evaluations : {0, 1, 2, 3}) {
    Slider failing, plain;
    failing.largest_step = 0.5;
    failing.evaluations_before_failure = evaluations;
    const auto retried = run(failing, whole), direct = run(plain, halves);
    ASSERT_TRUE(retried.result.converged) << retried.result.reason;
    ASSERT_TRUE(direct.result.converged);
    EXPECT_EQ(failing.rejected, 1);
    EXPECT_EQ(retried.steps.size(), 2u);
    EXPECT_EQ(retried.steps[0].cuts, 1);
    EXPECT_EQ(retried.result.counters.cut_backs, 1);
    EXPECT_EQ(retried.steps[0].solves[0].residual_history,
              direct.steps[0].solves[0].residual_history);
    EXPECT_EQ(retried.x, direct.x);
    EXPECT_EQ(failing.slip, plain.slip);
    EXPECT_GT(plain.slip, 0.0);
  }
}

TEST(LoadStepping, GrowsAgainAfterACut) {
  Slider system;
  system.largest_step = 0.02;
  TimeOptions time;
  time.steps = 4;
  auto done = run(system, time);
  ASSERT_TRUE(done.result.converged) << done.result.reason;
  EXPECT_EQ(done.steps[0].dt, 0.25 / 16);
  EXPECT_EQ(done.result.t, 1.0);
  int grown = 0;
  for (std::size_t i = 1; i < done.steps.size(); ++i)
    grown += done.steps[i].cuts > 0; // it tried a larger one again
  EXPECT_GT(grown, 3);

  // Steps that take many iterations keep their size.
  Slider patient;
  patient.largest_step = 0.02;
  time.target_iterations = 0;
  done = run(patient, time);
  ASSERT_TRUE(done.result.converged);
  EXPECT_EQ(done.result.counters.cut_backs, 4);
  EXPECT_EQ(done.steps.size(), 64u);
}

// What a user asked for at the end of a step must be there, cut or not.
TEST(LoadStepping, MeetsEveryEndOfAStepAfterCuts) {
  Slider system;
  system.largest_step = 0.13;
  TimeOptions time;
  time.steps = 4;
  const auto done = run(system, time);
  ASSERT_TRUE(done.result.converged);
  EXPECT_GT(done.result.counters.cut_backs, 0);
  for (double end : {0.25, 0.5, 0.75, 1.0})
    EXPECT_EQ(std::count_if(done.steps.begin(), done.steps.end(),
                            [&](const auto& step) { return step.t == end; }),
              1)
        << end;
}

TEST(LoadStepping, GivesUpWithTheLastConvergedState) {
  Slider system, reference;
  system.fails_beyond = 0.5;
  TimeOptions time;
  time.steps = 4;
  const auto done = run(system, time);
  TimeOptions half;
  half.steps = 2;
  half.end = 0.5;
  const auto expected = run(reference, half);
  EXPECT_FALSE(done.result.converged);
  EXPECT_EQ(done.result.t, 0.5);
  EXPECT_EQ(done.x, expected.x);
  EXPECT_EQ(system.slip, reference.slip);
  EXPECT_EQ(system.time, 0.5);
  EXPECT_EQ(done.result.counters.cut_backs, time.max_cuts);
  EXPECT_NE(done.result.reason.find("t = 0.5"), std::string::npos) << done.result.reason;
  EXPECT_NE(done.result.reason.find("no residual here"), std::string::npos) << done.result.reason;
}

TEST(LoadStepping, HonoursTheSmallestStep) {
  Slider system;
  system.fails_beyond = 0.0;
  TimeOptions time;
  time.min_fraction = 0.25;
  const auto done = run(system, time);
  EXPECT_FALSE(done.result.converged);
  EXPECT_EQ(done.result.counters.cut_backs, 2);
  EXPECT_EQ(done.x, Values({0.0, 0.0, 0.0}));
}

TEST(LoadStepping, NotAdaptiveFailsAtOnce) {
  Slider system;
  system.largest_step = 0.3;
  TimeOptions time;
  time.adaptive = false;
  const auto done = run(system, time);
  EXPECT_FALSE(done.result.converged);
  EXPECT_EQ(done.result.counters.cut_backs, 0);
  EXPECT_EQ(system.rejected, 1);
}

TEST(LoadStepping, CutsWhenNewtonTakesTooLong) {
  Slider system;
  solver::NewtonOptions newton;
  newton.max_iterations = 2;
  const auto done = run(system, {}, newton);
  ASSERT_TRUE(done.result.converged) << done.result.reason;
  EXPECT_GT(done.result.counters.cut_backs, 0);
  long long useful = 0;
  for (const auto& step : done.steps)
    useful += step.iterations;
  EXPECT_GT(done.result.counters.newton_iterations, useful); // failed attempts are counted
}

TEST(LoadStepping, GoesOnFromACheckpoint) {
  Slider whole, first, second;
  TimeOptions time;
  time.steps = 4;
  const auto straight = run(whole, time);
  TimeOptions half;
  half.steps = 2;
  half.end = 0.5;
  const auto begun = run(first, half);
  second.slip = second.trial_slip = first.slip;
  second.last_time = 0.5;
  const auto resumed = run(second, time, {}, 0.5, begun.x);
  ASSERT_TRUE(resumed.result.converged);
  EXPECT_EQ(resumed.steps.size(), 2u);
  EXPECT_EQ(resumed.x, straight.x);
}

/// Springs that stiffen, pulled by a load over time; x[1] hangs on x[0]. Symmetric.
class Springs : public DenseSystem {
public:
  explicit Springs(std::function<double(double)> load)
      : DenseSystem(
            2,
            [this](const Values& x) {
              if (std::abs(x[0]) > breaks_beyond)
                return Values{};
              return Values{2 * x[0] - x[1] + x[0] * x[0] * x[0] - load_(time), x[1] - x[0]};
            },
            [](const Values& x) {
              return Values{2 + 3 * x[0] * x[0], -1, -1, 1};
            }),
        load_(std::move(load)) {
    is_symmetric = true;
  }
  /// Kinds of the solves of each step.
  void set_time(double t) override {
    DenseSystem::set_time(t);
    predicted.push_back(false);
  }
  RCP<const Matrix> predictor(const Vector& x, Vector& rhs) override {
    predicted.back() = true;
    return DenseSystem::predictor(x, rhs);
  }

  double breaks_beyond = std::numeric_limits<double>::infinity();
  std::vector<bool> predicted;

private:
  std::function<double(double)> load_;
};

LoadResult pull(Springs& system, int steps, solver::StepPrediction prediction, Values& x_end) {
  const auto linear = solver::make_linear_solver({}, system);
  solver::NewtonSolver newton(*linear, {});
  solver::AugmentedLagrangian loop(newton);
  TimeOptions time;
  time.steps = steps;
  time.prediction = prediction;
  Vector x = system.vector({0.0, 0.0});
  const auto result = solver::LoadStepping(loop, time).run(system, x);
  x_end = system.gather(x);
  return result;
}

TEST(StepStart, ExtrapolationSavesSystemsAndNewtonIterations) {
  const auto load = [](double t) { return 2.0 * t; };
  Springs plain(load), fast(load);
  Values x, y;
  const auto predicted = pull(plain, 20, solver::StepPrediction::tangent, x);
  const auto extrapolated = pull(fast, 20, solver::StepPrediction::automatic, y);
  ASSERT_TRUE(predicted.converged && extrapolated.converged);
  EXPECT_EQ(predicted.counters.extrapolated_steps, 0);
  EXPECT_GE(extrapolated.counters.extrapolated_steps, 17);
  EXPECT_LE(extrapolated.counters.newton_iterations, predicted.counters.newton_iterations);
  EXPECT_LE(extrapolated.counters.linear_iterations,
            predicted.counters.linear_iterations - extrapolated.counters.extrapolated_steps);
  EXPECT_NEAR(y[0], x[0], 1e-8);
}

TEST(StepStart, LoadsThatStopOrTurnArePredicted) {
  Values x;
  constexpr int steps = 24; // the one after half of them is the first that differs
  Springs held([](double t) { return std::min(t, 0.5); });
  Springs turned([](double t) { return std::min(t, 1.0 - t); });
  for (Springs* system : {&held, &turned}) {
    ASSERT_TRUE(pull(*system, steps, solver::StepPrediction::automatic, x).converged);
    EXPECT_FALSE(system->predicted[steps / 2 - 1]);
    EXPECT_TRUE(system->predicted[steps / 2]);
  }
}

TEST(StepStart, WithFrictionOnlyIfAsked) {
  Values x;
  for (const bool asked : {false, true}) {
    Springs system([](double t) { return t; });
    system.is_symmetric = false;
    const auto kind =
        asked ? solver::StepPrediction::extrapolation : solver::StepPrediction::automatic;
    const auto result = pull(system, 10, kind, x);
    ASSERT_TRUE(result.converged);
    EXPECT_EQ(result.counters.extrapolated_steps > 0, asked);
  }
}

TEST(StepStart, WhereItCannotBeEvaluatedThePredictionServes) {
  // The load creeps towards its end: the line goes where there is no residual.
  const auto load = [](double t) { return t < 0.55 ? t : 0.5; };
  Springs system(load);
  Values x;
  ASSERT_TRUE(pull(system, 10, solver::StepPrediction::automatic, x).converged);
  Springs brittle(load);
  brittle.breaks_beyond = 1.01 * x[0];
  Values y;
  const auto result = pull(brittle, 10, solver::StepPrediction::extrapolation, y);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_EQ(result.counters.cut_backs, 0);
  EXPECT_NEAR(y[0], x[0], 1e-8);
}

TEST(LoadStepping, RefusesMeaninglessTimes) {
  Slider system;
  TimeOptions time;
  time.steps = 0;
  EXPECT_THROW(run(system, time), InputError);
  time.steps = 1;
  time.end = -1.0;
  EXPECT_THROW(run(system, time), InputError);
}

} // namespace
} // namespace abut
