// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/log.hpp"
#include "abut/solver/augmented.hpp"
#include "abut/solver/standing.hpp"

#include <functional>
#include <string>
#include <vector>

namespace abut::solver {

/// A converged load step.
struct StepReport {
  int step = 0; ///< from 1, over all parts of a run
  double t = 0.0, dt = 0.0;
  int iterations = 0, augmentations = 0; ///< of the attempt that converged
  int cuts = 0;                          ///< attempts that failed before it
  double residual = 0.0, reference = 0.0;
  std::vector<NewtonResult> solves; ///< one for each augmentation, with the residual histories
  AugmentReport augment;
  std::string note; ///< a plateau of the augmentation, else empty
};

/// Called with x of a step that converged and was accepted, to write results.
using StepCallback = std::function<void(const StepReport&, const Vector& x)>;
/// Called after it, where the next step begins.
using StandingCallback = std::function<void(const Standing&)>;

struct LoadResult {
  bool converged = false;
  double t = 0.0;     ///< of the last converged step
  std::string reason; ///< one sentence when not converged
  Counters counters;
};

/// Raises the load parameter t from where it stands to `end`. A failed step is rolled back, x bit
/// for bit, and tried again from a linear prediction if that is not where it started, else at half
/// its size; after steps that converge easily the size grows again by half, up to the nominal one.
/// Not adaptive: the first failed step ends the run.
class LoadStepping {
public:
  /// `loop` must outlive this object. Throws InputError for steps that are not positive.
  LoadStepping(AugmentedLagrangian& loop, TimeOptions options, LogSink log = {});

  /// Steps on from the equilibrium x where `from` stands; x is the last converged state afterwards.
  /// Collective.
  LoadResult run(NonlinearSystem& system, Vector& x, const StepCallback& on_step = {},
                 const IterationCallback& on_iteration = {}, const Standing& from = {},
                 const StandingCallback& on_standing = {});

private:
  struct Attempt {
    AugmentedResult result;
    std::string reason; ///< of failure; empty: the attempt converged
    int iterations = 0, augmentations = 0;
    bool extrapolated = false;
  };
  struct Course;
  Attempt attempt(Course& course, double t, const IterationCallback& observer);
  void finish_step(Course& course, const Attempt& tried, double t, const StepCallback& on_step);
  bool cut(Course& course, double t, const std::string& reason);
  double first_step(const Standing& from) const;
  double step_end(double t, double dt) const;

  AugmentedLagrangian& loop_;
  TimeOptions options_;
  LogSink log_;
};

} // namespace abut::solver
