// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/load_stepping.hpp"

#include <vector>

namespace abut::app {

/// Residual over reference force of each iterate of one Newton solve, the first included [1].
using Residuals = std::vector<double>;

/// What a converged step has cost.
struct StepCost {
  int step = 0; ///< from 1, over all parts of a run
  double t = 0.0;
  int iterations = 0, augmentations = 0; ///< of the attempt that converged
  int cuts = 0;                          ///< attempts that failed before it
  std::vector<Residuals> solves;         ///< in their order, those of failed attempts included
};

/// Follows Newton's method through a run.
class Convergence {
public:
  void iteration(const solver::IterationReport& report);
  void step(const solver::StepReport& report);

  const std::vector<StepCost>& steps() const { return steps_; }
  /// Of the attempts after the last converged step.
  const std::vector<Residuals>& failed() const { return solves_; }

private:
  std::vector<StepCost> steps_;
  std::vector<Residuals> solves_;
};

} // namespace abut::app
