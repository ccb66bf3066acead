// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/load_stepping.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/linear_solver.hpp"
#include "step_start.hpp"

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

/// What one run of steps goes through.
struct LoadStepping::Course {
  NonlinearSystem& system;
  Vector& x;
  Vector converged; ///< x of the last step
  StepStart start;
  double dt;
  int cuts = 0;
  LoadResult result;
};

LoadResult LoadStepping::run(NonlinearSystem& system, Vector& x, const StepCallback& on_step,
                             const IterationCallback& on_iteration, const Standing& from,
                             const StandingCallback& on_standing) {
  const double nominal = options_.end / options_.steps;
  Course course{system,
                x,
                Vector(x, Teuchos::Copy),
                StepStart(loop_.newton(), options_.prediction, from.motions),
                first_step(from),
                0,
                {}};
  LoadResult& result = course.result;
  result.t = from.t;
  result.counters = from.counters;
  const long long linear_before =
      loop_.newton().linear().total_iterations() - from.counters.linear_iterations;
  while (result.t < options_.end) {
    const double t = step_end(result.t, course.dt);
    const Attempt tried = attempt(course, t, on_iteration);
    result.counters.newton_iterations += tried.iterations;
    result.counters.augmentations += tried.augmentations;
    result.counters.linear_iterations = loop_.newton().linear().total_iterations() - linear_before;
    if (tried.reason.empty()) {
      finish_step(course, tried, t, on_step);
      if (on_standing)
        on_standing({result.t, course.dt, nominal, result.counters, course.start.motions()});
      continue;
    }
    system.reject();
    Tpetra::deep_copy(x, course.converged);
    loop_.newton().linear().forget();
    if (tried.extrapolated) {
      log(log_, LogLevel::info,
          "The step to t = " + number(t) +
              " is tried again from a linear prediction: " + tried.reason);
      course.start.distrust();
      continue;
    }
    if (!cut(course, t, tried.reason))
      return result;
  }
  result.converged = true;
  return result;
}

/// Halves the step; false where the run ends here.
bool LoadStepping::cut(Course& course, double t, const std::string& reason) {
  LoadResult& result = course.result;
  const double nominal = options_.end / options_.steps;
  course.dt = t - result.t; // no longer than up to the end of the nominal step
  const bool smaller = course.dt * 0.5 >= options_.min_fraction * nominal * (1.0 - snap);
  if (!options_.adaptive || course.cuts >= options_.max_cuts || !smaller) {
    course.system.set_time(result.t);
    result.reason = "No step beyond t = " + number(result.t) + " converged (" +
                    std::to_string(course.cuts) + " cuts, down to a step of " + number(course.dt) +
                    "): " + reason;
    return false;
  }
  log(log_, LogLevel::info, "The step to t = " + number(t) + " is cut in half: " + reason);
  course.dt *= 0.5;
  ++course.cuts;
  ++result.counters.cut_backs;
  return true;
}

void LoadStepping::finish_step(Course& course, const Attempt& tried, double t,
                               const StepCallback& on_step) {
  LoadResult& result = course.result;
  course.system.accept(course.x);
  loop_.newton().linear().step_accepted();
  course.start.accepted(course.converged, course.x, t - result.t, tried.augmentations == 0);
  Tpetra::deep_copy(course.converged, course.x);
  result.counters.extrapolated_steps += tried.extrapolated;
  const AugmentedResult& solved = tried.result;
  const StepReport report{static_cast<int>(++result.counters.steps),
                          t,
                          t - result.t,
                          solved.iterations,
                          solved.augmentations,
                          course.cuts,
                          solved.solves.back().residual,
                          solved.solves.back().reference,
                          solved.solves,
                          solved.report,
                          solved.stalled ? solved.reason : ""};
  result.t = t;
  if (!report.note.empty())
    log(log_, LogLevel::warning, report.note);
  if (on_step)
    on_step(report, course.x);
  course.cuts = 0;
  if (solved.solves.front().iterations <= options_.target_iterations)
    course.dt = std::min(options_.end / options_.steps, growth * course.dt);
}

/// A step that was cut is as short again, also where steps have another length by now.
double LoadStepping::first_step(const Standing& from) const {
  const double nominal = options_.end / options_.steps;
  return from.dt == 0.0 ? nominal : from.dt * (nominal / from.nominal);
}

double LoadStepping::step_end(double t, double dt) const {
  const double nominal = options_.end / options_.steps;
  const double whole = std::floor(t / nominal + snap) + 1.0;
  const double next =
      whole >= options_.steps ? options_.end : options_.end * whole / options_.steps;
  return t + dt < next - snap * nominal ? t + dt : next;
}

LoadStepping::Attempt LoadStepping::attempt(Course& course, double t,
                                            const IterationCallback& observer) {
  NonlinearSystem& system = course.system;
  Vector& x = course.x;
  Attempt tried;
  int solves = 0;
  // Counted as they come, for an exception takes the result along.
  const auto counting_observer = [&](const IterationReport& report) {
    if (report.iteration > 0)
      ++tried.iterations;
    else
      solves = report.approach ? 0 : solves + 1;
    if (observer)
      observer(report);
  };
  try {
    system.set_time(t);
    loop_.newton().begin_step(x);
    tried.extrapolated = course.start.predict(system, x, t - course.result.t);
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

} // namespace abut::solver
