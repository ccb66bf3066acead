// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/newton.hpp"

#include <NOX_StatusTest_Generic.H>

namespace abut::solver {

/// Decides after every iterate whether Newton is done, and writes down its history. Fails, with a
/// reason, on a residual that is not finite, grows without bound, repeats itself, or takes too
/// long.
class ConvergenceTest : public NOX::StatusTest::Generic {
public:
  ConvergenceTest(const NonlinearSystem& system, const LinearSolver& linear,
                  const NewtonOptions& options, const EarlyEnd& early, IterationCallback observer);

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int indent) const override;

  NewtonResult result() const;

private:
  void record(const NOX::Solver::Generic& solver);
  NOX::StatusTest::StatusType judge();
  bool diverges() const;
  int cycle_length() const; ///< 0: no cycle
  std::string too_many_iterations() const;

  const NonlinearSystem& system_;
  const LinearSolver& linear_;
  const NewtonOptions& options_;
  const EarlyEnd early_;
  IterationCallback observer_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
  std::vector<double> residuals_;
  double reference_ = 0.0, first_reference_ = 0.0;
  long long linear_at_start_, linear_before_;
  std::string reason_;
};

} // namespace abut::solver
