// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/augmented.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <exception>

namespace abut::solver {

namespace {
constexpr double loosest = 1e-2;        ///< tolerance of a solve that multipliers change after
constexpr double share_of_change = 0.1; ///< of the multipliers' last change, and of first forces
constexpr double near = 1e-2;           ///< tolerance of an approach, and of a landing

/// So is a state that has no residual, as where an element is inverted.
bool is_overloaded(NonlinearSystem& system, const Vector& x) {
  Vector f(x.getMap());
  try {
    system.residual(x, f);
  } catch (const SolveError&) {
    return true;
  }
  return system.overloaded();
}

} // namespace

bool AugmentedLagrangian::lead(SolveKind kind, NonlinearSystem& system, Vector& x,
                               const IterationCallback& observer) {
  const Vector start(x, Teuchos::Copy);
  const auto marked = [&](IterationReport report) {
    report.approach = true;
    observer(report);
  };
  system.begin_solve(kind);
  bool arrived = false;
  try {
    arrived = newton_.solve(system, x, marked, {near, 1.0}).converged;
  } catch (const SolveError&) { // Newton has another start, or had one
  }
  if (!arrived)
    Tpetra::deep_copy(x, start);
  return arrived;
}

NewtonResult AugmentedLagrangian::solve_first(NonlinearSystem& system, Vector& x,
                                              const IterationCallback& observer,
                                              const EarlyEnd& early) {
  const Vector start(x, Teuchos::Copy);
  NewtonResult result;
  std::exception_ptr failure;
  system.begin_solve(SolveKind::newton);
  try {
    result = newton_.solve(system, x, observer, early);
  } catch (const SolveError&) {
    failure = std::current_exception();
  }
  if (result.converged || !system.lands()) {
    if (failure)
      std::rethrow_exception(failure);
    return result;
  }
  Tpetra::deep_copy(x, start);
  if (lead(SolveKind::landing, system, x, observer)) {
    system.begin_solve(SolveKind::newton);
    return newton_.solve(system, x, observer, early);
  }
  if (failure)
    std::rethrow_exception(failure);
  return result;
}

AugmentedResult AugmentedLagrangian::solve(NonlinearSystem& system, Vector& x,
                                           const IterationCallback& observer) {
  AugmentedResult result;
  const auto counted = [&](const IterationReport& report) {
    result.iterations += report.iteration > 0;
    if (observer)
      observer(report);
  };
  const double finest = newton_.options().tolerance;
  const bool inexact = augment_ && newton_.options().inexact;
  EarlyEnd early;
  if (inexact)
    early = {loosest, share_of_change};
  if (is_overloaded(system, x))
    lead(SolveKind::approach, system, x, counted);
  for (;;) {
    result.solves.push_back(result.solves.empty() ? solve_first(system, x, counted, early)
                                                  : newton_.solve(system, x, counted, early));
    const NewtonResult& solve = result.solves.back();
    if (!solve.converged) {
      result.reason = solve.reason;
      if (result.augmentations > 0)
        result.reason += " (after augmentation " + std::to_string(result.augmentations) + ")";
      return result;
    }
    if (augment_)
      result.report = augment_(result.augmentations);
    if (!augment_)
      break;
    if (result.report.converged || result.report.stalled) {
      if (early.tolerance <= finest)
        break;
      early.tolerance = 0.0; // the same solve goes on
      continue;
    }
    ++result.augmentations;
    system.begin_solve(SolveKind::after_augmentation);
    // A multiplier that grows before its force has moved anything would grow for nothing.
    if (inexact)
      early = {std::min(loosest, share_of_change * result.report.change), share_of_change};
  }
  result.converged = true;
  result.stalled = result.report.stalled && !result.report.converged;
  if (result.stalled)
    result.reason = result.report.reason;
  return result;
}

} // namespace abut::solver
