// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/augmented.hpp"

#include <algorithm>

namespace abut::solver {

namespace {
constexpr double loosest = 1e-3;        ///< tolerance of a solve that multipliers change after
constexpr double share_of_change = 0.1; ///< of the last change of the multipliers
} // namespace

AugmentedResult AugmentedLagrangian::solve(NonlinearSystem& system, Vector& x,
                                           const IterationCallback& observer) {
  AugmentedResult result;
  const double finest = newton_.options().tolerance;
  double tolerance = augment_ && newton_.options().inexact ? std::max(loosest, finest) : finest;
  for (;;) {
    result.solves.push_back(newton_.solve(system, x, observer, tolerance));
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
      if (tolerance <= finest)
        break;
      tolerance = finest;
      continue;
    }
    ++result.augmentations;
    if (newton_.options().inexact)
      tolerance =
          std::clamp(share_of_change * result.report.change, finest, std::max(loosest, finest));
  }
  result.converged = true;
  result.stalled = result.report.stalled && !result.report.converged;
  if (result.stalled)
    result.reason = result.report.reason;
  return result;
}

} // namespace abut::solver
