// SPDX-License-Identifier: BSD-3-Clause
#include "escalating_solver.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>

namespace abut::solver {

namespace {
constexpr int first_spared = 3, most_spared = 1000;
} // namespace

EscalatingSolver::EscalatingSolver(std::unique_ptr<LinearSolver> cheap,
                                   std::unique_ptr<LinearSolver> sure, bool dear, LogSink log,
                                   PhaseTimers* timers)
    : LinearSolver("automatic", timers), cheap_(std::move(cheap)), sure_(std::move(sure)),
      log_(std::move(log)), dear_(dear), next_spared_(first_spared) {}

void EscalatingSolver::forget() {
  cheap_->forget();
  sure_->forget();
}

std::vector<LinearUse> EscalatingSolver::uses() const {
  std::vector<LinearUse> all = cheap_->uses();
  for (LinearUse& use : sure_->uses())
    all.push_back(std::move(use));
  return all;
}

void EscalatingSolver::do_setup(const RCP<const Matrix>& matrix, long graph_version,
                                bool symmetric) {
  matrix_ = matrix, graph_version_ = graph_version, symmetric_ = symmetric;
  sure_is_set_up_ = false;
  use_sure_ = spared_ > 0;
  spared_ = std::max(0, spared_ - 1);
  if (!use_sure_)
    attempt([&] { cheap_->setup(matrix, graph_version, symmetric); });
}

LinearResult EscalatingSolver::do_solve(const Vector& b, Vector& x, double tolerance) {
  LinearResult result;
  if (!use_sure_ && attempt([&] { result = cheap_->solve(b, x, tolerance); }))
    return result;
  if (!sure_is_set_up_)
    sure_->setup(matrix_, graph_version_, symmetric_);
  sure_is_set_up_ = true;
  return sure_->solve(b, x, tolerance);
}

template <class Work> bool EscalatingSolver::attempt(Work work) {
  try {
    work();
    return true;
  } catch (const SolveError& e) {
    if (dear_ && !passed_on_) {
      passed_on_ = true;
      throw;
    }
    give_up(e.what());
    return false;
  }
}

void EscalatingSolver::give_up(const std::string& why) {
  use_sure_ = true;
  spared_ = next_spared_;
  next_spared_ = std::min(2 * next_spared_, most_spared);
  log(log_, LogLevel::warning,
      why + " This system and the next " + std::to_string(spared_) + " are solved directly.");
}

} // namespace abut::solver
