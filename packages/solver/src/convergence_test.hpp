// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/newton.hpp"

#include <NOX_StatusTest_Generic.H>

namespace abut::solver {

/// What corrections are measured against.
struct IncrementScale {
  const Vector& start; ///< the state at the start of the step
  double work = 0.0;   ///< largest |dx . f| of the step's corrections before this solve [energy]
};

/// Decides after every iterate whether Newton is done, and writes down its history. Fails, with a
/// reason, on a residual that is not finite, grows without bound, repeats itself, or takes too
/// long.
class ConvergenceTest : public NOX::StatusTest::Generic {
public:
  ConvergenceTest(const NonlinearSystem& system, const LinearSolver& linear,
                  const NewtonOptions& options, const EarlyEnd& early, const IncrementScale& scale,
                  IterationCallback observer);

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int indent) const override;

  NewtonResult result() const;
  double largest_work() const { return largest_work_; } ///< [energy]

private:
  void record(const NOX::Solver::Generic& solver);
  void measure_correction(const NOX::Solver::Generic& solver);
  NOX::StatusTest::StatusType judge();
  bool small_correction() const;
  bool diverges() const;
  int cycle_length() const; ///< 0: no cycle
  bool no_headway() const;
  std::string too_many_iterations() const;

  const NonlinearSystem& system_;
  const LinearSolver& linear_;
  const NewtonOptions& options_;
  const EarlyEnd early_;
  const Vector& start_;
  IterationCallback observer_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
  std::vector<double> residuals_, step_lengths_;
  double reference_ = 0.0, first_reference_ = 0.0;
  double correction_ = 0.0, increment_ = 0.0; ///< |dx|_2 of the full step, |x - start|_2
  double work_left_ = 0.0, largest_work_;     ///< |dx . f| with the new f, and the old ones' most
  long long linear_at_start_, linear_before_;
  std::string reason_;
};

} // namespace abut::solver
