// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/linear_solver.hpp"

#include <memory>

namespace abut::solver {

/// What comes after a Krylov solver that fails.
enum class KrylovRole {
  alone, ///< nothing: GMRES tries once more what conjugate gradients could not do
  first, ///< a direct solver
};

/// Belos CG for a symmetric matrix (GMRES where that does not converge and nothing else follows)
/// and GMRES otherwise. The preconditioner is renewed or kept from matrix to matrix as long as the
/// iterations stay below 1.5 times those right after it was built.
class KrylovSolver : public LinearSolver {
public:
  /// options.preconditioner must have been chosen. Throws InputError when a user's list is not
  /// readable or holds a parameter that nobody knows.
  KrylovSolver(const LinearOptions& options, const NonlinearSystem& system, LogSink log,
               KrylovRole role, PhaseTimers* timers = nullptr);
  ~KrylovSolver() override;

  void forget() override;

private:
  void do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) override;
  LinearResult do_solve(const Vector& b, Vector& x, double tolerance) override;

  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace abut::solver
