// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"
#include "abut/solver/options.hpp"

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
  StepStart(NewtonSolver& newton, StepPrediction kind) : newton_(newton), kind_(kind) {}

  /// x from the equilibrium of the last step to the start of one that is dt longer; the system is
  /// at the new time already. Whether it was extrapolated. Throws SolveError. Collective.
  bool predict(NonlinearSystem& system, Vector& x, double dt);
  /// The attempt from an extrapolated start failed: the next start is a prediction.
  void distrust() { trusted_ = false; }
  /// A step of length dt from `before` on has ended. alone: by Newton; multipliers that were
  /// changed have moved x in a way that the next step's will not until they change again.
  void accepted(const Vector& before, const Vector& x, double dt, bool alone);

private:
  /// The last step's mean velocity, and the length of the step.
  struct Motion {
    RCP<const Vector> velocity; ///< null: none is known
    double dt = 0.0;
  };
  bool extrapolate(NonlinearSystem& system, Vector& x, double dt) const;
  std::vector<Vector> continuations(const Vector& x, double dt) const;

  NewtonSolver& newton_;
  StepPrediction kind_;
  Motion last_, before_last_;
  bool trusted_ = true;
};

} // namespace abut::solver
