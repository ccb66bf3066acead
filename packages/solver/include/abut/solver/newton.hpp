// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"
#include "abut/core/trilinos_fwd.hpp"
#include "abut/solver/options.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace abut::solver {

class ForcingTerm;
class LinearSolver;
class NonlinearSystem;

/// One accepted Newton iterate; iteration 0 is the state that the solve starts from.
struct IterationReport {
  int iteration = 0;
  double residual = 0.0;     ///< |f|_2 over all unknowns [force]
  double relative = 0.0;     ///< residual over reference force [1]
  double step_length = 0.0;  ///< fraction of the Newton step that was taken [1]; 0 at iteration 0
  int linear_iterations = 0; ///< of this iteration
  bool approach = false;     ///< of a solve before the step's own: SolveKind approach or landing
};

using IterationCallback = std::function<void(const IterationReport&)>;

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;  ///< |f|_2 at the end [force]
  double reference = 0.0; ///< reference force at the end [force]
  long long linear_iterations = 0;
  std::vector<double> residual_history; ///< |f|_2 of every iterate, the first included [force]
  std::string reason;                   ///< one sentence when not converged
};

/// When a solve may end before the options' own tolerance: at |f|_2 <= tolerance * reference force
/// and |f|_2 <= reduction * its first |f|_2.
struct EarlyEnd {
  double tolerance = 0.0; ///< [1]
  double reduction = 1.0; ///< [1]
};

/// Newton's method (NOX) with a line search. Converged: |f|_2 <= tolerance * reference force, f
/// exactly zero, or a correction within NewtonOptions::displacement_tolerance.
class NewtonSolver {
public:
  /// `linear` must outlive the solver. `linear_tolerance`: relative residual asked of each linear
  /// solve; none: forcing terms, no tighter than Newton has use for. Either way, the user's NOX
  /// list may choose its own. Throws InputError for a bad NOX list.
  NewtonSolver(LinearSolver& linear, NewtonOptions options,
               std::optional<double> linear_tolerance = std::nullopt);
  ~NewtonSolver();

  /// Solves system.residual(x) = 0 from x on, which is overwritten by the last iterate. The last
  /// residual of the system has then been evaluated at x. Not to converge within the iterations is
  /// a result; a SolveError of the system (where a shorter step does not cure it) or of the linear
  /// solver is passed on, x is then not usable. Collective.
  NewtonResult solve(NonlinearSystem& system, Vector& x, const IterationCallback& observer = {},
                     const EarlyEnd& early = {});

  /// From here on corrections are measured against the increment from x, the state at the start of
  /// a step. Without it, against the increment from the start of each solve.
  void begin_step(const Vector& x);

  /// How exactly linear systems are to be solved follows earlier solves, and so does what solves
  /// them.
  void exchange_state(StateArchive& archive);

  LinearSolver& linear() { return linear_; }
  const NewtonOptions& options() const { return options_; }
  /// Of the linear solve that predicts a step. [1]
  double predictor_tolerance();

private:
  LinearSolver& linear_;
  NewtonOptions options_;
  std::optional<double> linear_tolerance_;
  std::unique_ptr<ForcingTerm> forcing_;
  RCP<const Vector> step_start_; ///< null: none is known
  double largest_work_ = 0.0;    ///< |dx . f| of the step's corrections so far [energy]
};

} // namespace abut::solver
