// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/augmented.hpp"

namespace abut::solver {

AugmentedResult AugmentedLagrangian::solve(NonlinearSystem& system, Vector& x,
                                           const IterationCallback& observer) {
  AugmentedResult result;
  for (;; ++result.augmentations) {
    result.solves.push_back(newton_.solve(system, x, observer));
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
    if (!augment_ || result.report.converged || result.report.stalled)
      break;
  }
  result.converged = true;
  result.stalled = result.report.stalled && !result.report.converged;
  if (result.stalled)
    result.reason = result.report.reason;
  return result;
}

} // namespace abut::solver
