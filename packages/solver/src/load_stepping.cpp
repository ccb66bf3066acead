// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/load_stepping.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/linear_solver.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut::solver {

namespace {

constexpr double growth = 1.5;
constexpr double snap = 1e-9; ///< times nearer to a nominal step's end than this, in steps, are it

std::string number(double x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

} // namespace

LoadStepping::LoadStepping(AugmentedLagrangian& loop, TimeOptions options, LogSink log)
    : loop_(loop), options_(options), log_(std::move(log)) {
  if (!(options.end > 0.0))
    throw InputError("time: end must be positive.");
  if (options.steps < 1)
    throw InputError("time: steps must be at least 1.");
}

LoadResult LoadStepping::run(NonlinearSystem& system, Vector& x, const StepCallback& on_step,
                             const IterationCallback& on_iteration, double start) {
  LoadResult result;
  result.t = start;
  const double nominal = options_.end / options_.steps;
  const long long linear_before = loop_.newton().linear().total_iterations();
  double dt = nominal;
  Vector converged(x, Teuchos::Copy);
  int cuts = 0;
  while (result.t < options_.end) {
    const double t = step_end(result.t, dt);
    const Attempt tried = attempt(system, x, t, on_iteration);
    result.counters.newton_iterations += tried.iterations;
    result.counters.augmentations += tried.augmentations;
    result.counters.linear_iterations = loop_.newton().linear().total_iterations() - linear_before;
    if (!tried.reason.empty()) {
      system.reject();
      Tpetra::deep_copy(x, converged);
      loop_.newton().linear().forget();
      dt = t - result.t; // no longer than up to the end of the nominal step
      const bool smaller = dt * 0.5 >= options_.min_fraction * nominal * (1.0 - snap);
      if (!options_.adaptive || cuts >= options_.max_cuts || !smaller) {
        system.set_time(result.t);
        result.reason = "No step beyond t = " + number(result.t) + " converged (" +
                        std::to_string(cuts) + " cuts, down to a step of " + number(dt) +
                        "): " + tried.reason;
        return result;
      }
      log(log_, LogLevel::info,
          "The step to t = " + number(t) + " is cut in half: " + tried.reason);
      dt *= 0.5;
      ++cuts;
      ++result.counters.cut_backs;
      continue;
    }

    system.accept(x);
    Tpetra::deep_copy(converged, x);
    const AugmentedResult& solved = tried.result;
    const StepReport report{static_cast<int>(++result.counters.steps),
                            t,
                            t - result.t,
                            solved.iterations,
                            solved.augmentations,
                            cuts,
                            solved.solves.back().residual,
                            solved.solves.back().reference,
                            solved.solves,
                            solved.report,
                            solved.stalled ? solved.reason : ""};
    result.t = t;
    if (!report.note.empty())
      log(log_, LogLevel::warning, report.note);
    if (on_step)
      on_step(report, x);
    cuts = 0;
    if (solved.solves.front().iterations <= options_.target_iterations)
      dt = std::min(nominal, growth * dt);
  }
  result.converged = true;
  return result;
}

double LoadStepping::step_end(double t, double dt) const {
  const double nominal = options_.end / options_.steps;
  const double whole = std::floor(t / nominal + snap) + 1.0;
  const double next =
      whole >= options_.steps ? options_.end : options_.end * whole / options_.steps;
  return t + dt < next - snap * nominal ? t + dt : next;
}

LoadStepping::Attempt LoadStepping::attempt(NonlinearSystem& system, Vector& x, double t,
                                            const IterationCallback& observer) {
  Attempt tried;
  int solves = 0;
  // Counted as they come, for an exception takes the result along.
  const auto counting_observer = [&](const IterationReport& report) {
    if (report.iteration > 0)
      ++tried.iterations;
    else if (!report.approach)
      ++solves;
    if (observer)
      observer(report);
  };
  try {
    system.set_time(t);
    loop_.newton().begin_step(x);
    predict(system, x);
    tried.result = loop_.solve(system, x, counting_observer);
    if (tried.result.converged)
      system.require_consistent();
    else
      tried.reason = tried.result.reason;
  } catch (const SolveError& e) {
    tried.reason = e.what();
  }
  tried.augmentations =
      tried.result.solves.empty() ? std::max(0, solves - 1) : tried.result.augmentations;
  return tried;
}

void LoadStepping::predict(NonlinearSystem& system, Vector& x) {
  Vector rhs(x.getMap()), dx(x.getMap());
  const auto tangent = system.predictor(x, rhs);
  auto& linear = loop_.newton().linear();
  linear.setup(tangent, system.graph_version(), system.symmetric());
  linear.solve(rhs, dx, loop_.newton().linear_tolerance());
  x.update(1.0, dx, 1.0);
  system.apply_constraints(x);
}

} // namespace abut::solver
