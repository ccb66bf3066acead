// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/log.hpp"
#include "abut/core/state_archive.hpp"
#include "abut/core/timers.hpp"
#include "abut/core/trilinos_fwd.hpp"
#include "abut/solver/options.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace abut::solver {

class NonlinearSystem;

struct LinearResult {
  int iterations = 0;             ///< Krylov iterations; a direct solve counts one
  double relative_residual = 0.0; ///< |b - A x| / |b|, computed after the solve [1]
};

/// What one method has done in a run, failures included.
struct LinearUse {
  std::string method;         ///< as options name it
  long long systems = 0;      ///< matrices with which it solved
  long long solves = 0;       ///< right-hand sides solved for
  long long iterations = 0;   ///< of these solves; a direct solve counts one
  long long setups = 0;       ///< factorizations, or hierarchies built or renewed
  long long failures = 0;     ///< matrices that it gave up on
  double seconds = 0.0;       ///< wall time on this rank
  double setup_seconds = 0.0; ///< of these for setups
  double apply_seconds = 0.0; ///< of these for the preconditioner; what is left is Krylov's own
};

class Stopwatch {
public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Solves A x = b again and again for matrices of one row distribution. Every member is collective.
/// Failures that a smaller load step may cure (singular matrix, no convergence) are SolveErrors,
/// thrown on all ranks together.
class LinearSolver {
public:
  explicit LinearSolver(std::string method, PhaseTimers* timers = nullptr) : timers_(timers) {
    use_.method = std::move(method);
  }
  virtual ~LinearSolver() = default;

  /// Takes the values of `matrix`, which must stay as they are until the last solve with them.
  /// Symbolic work is done again only when `graph_version` or `symmetric` differ from the last
  /// call.
  void setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric);

  /// x = A^-1 b; what x holds on entry does not matter. `tolerance` bounds |b - A x| / |b| of
  /// iterative methods [1]; b = 0 gives x = 0 in no iteration.
  LinearResult solve(const Vector& b, Vector& x, double tolerance);

  /// Drops what has been made of earlier matrices and could change the next solution's last bits.
  /// Called when a load step is rolled back, so that the retry does not depend on the failure.
  /// Which methods fail in this run is not forgotten.
  virtual void forget() {}
  /// A load step has been accepted.
  virtual void step_accepted() {}
  /// What forget() leaves and the next solutions depend on.
  virtual void exchange_state(StateArchive&) {}

  /// Sum of LinearResult::iterations so far, failed solves not counted.
  long long total_iterations() const { return use_.iterations; }

  /// Of each method that this solver may turn to, in the order in which it does. Not collective.
  virtual std::vector<LinearUse> uses() const { return {use_}; }

protected:
  /// `work` makes factors or a hierarchy; whether it did is what it returns.
  template <class Work> void measured_setup(Work work);
  /// Where to add what applying a preconditioner takes.
  double& apply_seconds() { return use_.apply_seconds; }

private:
  virtual void do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) = 0;
  virtual LinearResult do_solve(const Vector& b, Vector& x, double tolerance) = 0;
  template <class Work> void measured(Work work);

  PhaseTimers* timers_;
  LinearUse use_;
  bool solved_ = false, failed_ = false; ///< with the present matrix
};

template <class Work> void LinearSolver::measured_setup(Work work) {
  const Stopwatch watch;
  const bool made = work();
  use_.setup_seconds += watch.seconds();
  use_.setups += made;
}

/// The solver that `options` ask for. Automatic: direct up to `direct_limit` unknowns and where
/// multipliers are among the unknowns, Krylov beyond, and direct there too (with a warning to
/// `log`) where Krylov fails or takes longer than a factorization would. The choice goes to `log`.
/// The system gives the number of unknowns and the node layout for multigrid. `timers` may be null
/// and must outlive the solver.
std::unique_ptr<LinearSolver> make_linear_solver(const LinearOptions& options,
                                                 const NonlinearSystem& system,
                                                 const LogSink& log = {},
                                                 PhaseTimers* timers = nullptr);

} // namespace abut::solver
