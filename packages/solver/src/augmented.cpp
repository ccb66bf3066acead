// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/augmented.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>

namespace abut::solver {

namespace {
constexpr double loosest = 1e-2;        ///< tolerance of a solve that multipliers change after
constexpr double share_of_change = 0.1; ///< of the multipliers' last change, and of first forces
constexpr double near = 1e-2;           ///< tolerance of an approach

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

int AugmentedLagrangian::approach(NonlinearSystem& system, Vector& x,
                                  const IterationCallback& observer) {
  if (!is_overloaded(system, x))
    return 0;
  const Vector start(x, Teuchos::Copy);
  int iterations = 0;
  const auto marked = [&](IterationReport report) {
    iterations = report.iteration;
    report.approach = true;
    if (observer)
      observer(report);
  };
  system.begin_solve(SolveKind::approach);
  bool arrived = false;
  try {
    arrived = newton_.solve(system, x, marked, {near, 1.0}).converged;
  } catch (const SolveError&) { // Newton has another start
  }
  if (!arrived)
    Tpetra::deep_copy(x, start);
  return iterations;
}

AugmentedResult AugmentedLagrangian::solve(NonlinearSystem& system, Vector& x,
                                           const IterationCallback& observer) {
  AugmentedResult result;
  const double finest = newton_.options().tolerance;
  const bool inexact = augment_ && newton_.options().inexact;
  EarlyEnd early;
  if (inexact)
    early = {loosest, share_of_change};
  result.iterations = approach(system, x, observer);
  system.begin_solve(SolveKind::newton);
  for (;;) {
    result.solves.push_back(newton_.solve(system, x, observer, early));
    const NewtonResult& solve = result.solves.back();
    result.iterations += solve.iterations;
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
