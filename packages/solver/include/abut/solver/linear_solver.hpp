// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/log.hpp"
#include "abut/core/timers.hpp"
#include "abut/core/trilinos_fwd.hpp"
#include "abut/solver/options.hpp"

#include <memory>

namespace abut::solver {

class NonlinearSystem;

struct LinearResult {
  int iterations = 0;             ///< Krylov iterations; a direct solve counts one
  double relative_residual = 0.0; ///< |b - A x| / |b|, computed after the solve [1]
};

/// Solves A x = b again and again for matrices of one row distribution. Every member is collective.
/// Failures that a smaller load step may cure (singular matrix, no convergence) are SolveErrors,
/// thrown on all ranks together.
class LinearSolver {
public:
  explicit LinearSolver(PhaseTimers* timers = nullptr) : timers_(timers) {}
  virtual ~LinearSolver() = default;

  /// Takes the values of `matrix`, which must stay as they are until the last solve with them.
  /// Symbolic work is done again only when `graph_version` or `symmetric` differ from the last
  /// call.
  void setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric);

  /// x = A^-1 b; what x holds on entry does not matter. `tolerance` bounds |b - A x| / |b| of
  /// iterative methods [1]; b = 0 gives x = 0 in no iteration.
  LinearResult solve(const Vector& b, Vector& x, double tolerance);

  /// Drops everything learnt from earlier matrices that could change the next solution's last bits.
  /// Called when a load step is rolled back, so that the retry does not depend on the failure.
  virtual void forget() {}

  /// Sum of LinearResult::iterations so far, failed solves not counted.
  long long total_iterations() const { return total_iterations_; }

private:
  virtual void do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) = 0;
  virtual LinearResult do_solve(const Vector& b, Vector& x, double tolerance) = 0;

  PhaseTimers* timers_;
  long long total_iterations_ = 0;
};

/// The solver that `options` ask for. Automatic: direct up to `direct_limit` unknowns, Krylov
/// beyond, and direct there too (with a warning to `log`) where Krylov fails. The system gives the
/// number of unknowns and the node layout for multigrid. `timers` may be null and must outlive the
/// solver.
std::unique_ptr<LinearSolver> make_linear_solver(const LinearOptions& options,
                                                 const NonlinearSystem& system,
                                                 const LogSink& log = {},
                                                 PhaseTimers* timers = nullptr);

} // namespace abut::solver
