// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/linear_solver.hpp"

#include <memory>

namespace abut::solver {

/// Direct solution by MUMPS: L D L^T for a symmetric matrix, LU otherwise. The true residual is
/// checked after every solve and improved by iterative refinement. Throws MachineError where memory
/// does not suffice.
class MumpsSolver : public LinearSolver {
public:
  /// joints: a singular matrix may be due to them.
  explicit MumpsSolver(PhaseTimers* timers = nullptr, bool joints = false);
  ~MumpsSolver() override;

private:
  void do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) override;
  LinearResult do_solve(const Vector& b, Vector& x, double tolerance) override;

  class Instance; ///< one MUMPS structure with its analysis and factors
  std::unique_ptr<Instance> instance_;
  RCP<const Matrix> matrix_;
  bool joints_;
};

} // namespace abut::solver
