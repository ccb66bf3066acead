// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/linear_solver.hpp"

#include <memory>

namespace abut::solver {

/// A cheap method, and a sure one for every matrix on which the cheap one throws a SolveError: the
/// very same system is then solved by the other. After each failure the cheap one is spared twice
/// as many matrices as after the one before, and then tried again: one hard state does not decide
/// over a whole run, and a hard run loses little.
/// Where the sure one is dear, the error is passed on first, for a shorter load step mostly leads
/// around the hard state; the sure one is for what fails in the same step after that.
class EscalatingSolver : public LinearSolver {
public:
  EscalatingSolver(std::unique_ptr<LinearSolver> cheap, std::unique_ptr<LinearSolver> sure,
                   bool dear, LogSink log, PhaseTimers* timers = nullptr);

  void forget() override;
  void step_accepted() override { passed_on_ = false; }
  void exchange_state(StateArchive& archive) override {
    if (archive.holds("linear_solver")) // steps may go on with another solver
      archive.numbers("linear_solver", [&](auto& v) { v(spared_, next_spared_); });
  }
  std::vector<LinearUse> uses() const override;

private:
  void do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) override;
  LinearResult do_solve(const Vector& b, Vector& x, double tolerance) override;
  /// False where `work` threw a SolveError.
  template <class Work> bool attempt(Work work);
  void give_up(const std::string& why);

  std::unique_ptr<LinearSolver> cheap_, sure_;
  LogSink log_;
  bool dear_;              ///< the sure one takes far longer than the cheap one
  bool passed_on_ = false; ///< an error of this step
  RCP<const Matrix> matrix_;
  long graph_version_ = 0;
  bool symmetric_ = false;
  bool use_sure_ = false, sure_is_set_up_ = false; ///< for the present matrix
  int spared_ = 0;                                 ///< matrices not to try the cheap one on
  int next_spared_;                                ///< after its next failure
};

} // namespace abut::solver
