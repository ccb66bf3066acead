// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/newton.hpp"
#include "abut/solver/nonlinear_system.hpp"

#include <functional>

namespace abut::solver {

/// Called after every converged Newton solve with the number of augmentations done so far. Looks at
/// the state and either says that it is done, and then changes nothing, or updates the multipliers
/// for one more solve. It owns the tolerances and the largest number of augmentations.
using AugmentCallback = std::function<AugmentReport(int augmentation)>;

struct AugmentedResult {
  bool converged = false; ///< Newton converged and no further augmentation is asked for
  bool stalled = false;   ///< converged, but at a plateau: `report.reason` says which
  int augmentations = 0;  ///< updates of the multipliers that a solve followed
  int iterations = 0;     ///< Newton, over all solves
  std::vector<NewtonResult> solves;
  AugmentReport report; ///< the callback's last
  std::string reason;   ///< one sentence when not converged or stalled
};

/// Uzawa's loop: solve with the multipliers held, let the callback update them, and again. A solve
/// that multipliers will still change after is only taken as far as they are known; the last one
/// has Newton's own tolerance. Before the first, an overloaded start is approached, see SolveKind;
/// where the first fails all the same, it is tried once more from a landing.
/// It knows nothing of contact; without a callback it is one Newton solve.
class AugmentedLagrangian {
public:
  /// `newton` must outlive the loop.
  explicit AugmentedLagrangian(NewtonSolver& newton, AugmentCallback augment = {})
      : newton_(newton), augment_(std::move(augment)) {}

  void set_callback(AugmentCallback augment) { augment_ = std::move(augment); }

  /// Throws what NewtonSolver::solve throws. Collective: the callback must answer alike on all
  /// ranks.
  AugmentedResult solve(NonlinearSystem& system, Vector& x, const IterationCallback& observer = {});

  NewtonSolver& newton() { return newton_; }

private:
  /// A solve of this kind, from x to where the next one starts; x stays where it does not converge.
  bool lead(SolveKind kind, NonlinearSystem& system, Vector& x, const IterationCallback& observer);
  NewtonResult solve_first(NonlinearSystem& system, Vector& x, const IterationCallback& observer,
                           const EarlyEnd& early);

  NewtonSolver& newton_;
  AugmentCallback augment_;
};

} // namespace abut::solver
