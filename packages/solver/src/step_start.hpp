// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"
#include "abut/solver/options.hpp"
#include "abut/solver/standing.hpp"

#include <vector>

namespace abut::solver {

class NewtonSolver;
class NonlinearSystem;

/// Where Newton starts a load step: the last state moved along with the new loads, by the linear
/// solve of NonlinearSystem::predictor or, for the price of some residuals, on along the line or
/// the parabola through the last states, whichever leaves less of a residual.
class StepStart {
public:
  /// `newton`, whose linear solver is used, must outlive this object.
  /// motions: of the steps before, the newest first.
  StepStart(NewtonSolver& newton, StepPrediction kind, std::array<StepMotion, 2> motions)
      : newton_(newton), kind_(kind), last_(motions[0]), before_last_(motions[1]) {}

  /// x from the equilibrium of the last step to the start of one that is dt longer; the system is
  /// at the new time already. Whether it was extrapolated. Throws SolveError. Collective.
  bool predict(NonlinearSystem& system, Vector& x, double dt);
  /// The attempt from an extrapolated start failed: the next start is a prediction.
  void distrust() { trusted_ = false; }
  /// A step of length dt from `before` on has ended. alone: by Newton; multipliers that were
  /// changed have moved x in a way that the next step's will not until they change again.
  void accepted(const Vector& before, const Vector& x, double dt, bool alone);
  std::array<StepMotion, 2> motions() const { return {last_, before_last_}; }

private:
  bool extrapolate(NonlinearSystem& system, Vector& x, double dt) const;
  std::vector<Vector> continuations(const Vector& x, double dt) const;

  NewtonSolver& newton_;
  StepPrediction kind_;
  StepMotion last_, before_last_;
  bool trusted_ = true;
};

} // namespace abut::solver
