// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/linear_solver.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "krylov_solver.hpp"
#include "mumps_solver.hpp"

#include <cmath>
#include <optional>

namespace abut::solver {

namespace {

class OptionalScope {
public:
  OptionalScope(PhaseTimers* timers, Phase phase) {
    if (timers)
      scope_.emplace(*timers, phase);
  }

private:
  std::optional<PhaseTimers::Scope> scope_;
};

/// Krylov, and a direct solve of every matrix on which that fails.
class FallbackSolver : public LinearSolver {
public:
  FallbackSolver(std::unique_ptr<LinearSolver> krylov, std::unique_ptr<LinearSolver> direct,
                 LogSink log, PhaseTimers* timers)
      : LinearSolver(timers), krylov_(std::move(krylov)), direct_(std::move(direct)),
        log_(std::move(log)) {}

  void forget() override {
    krylov_->forget();
    direct_->forget();
    failures_ = 0;
  }

private:
  void do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) override {
    matrix_ = matrix, graph_version_ = graph_version, symmetric_ = symmetric;
    direct_is_set_up_ = false;
    use_direct_ = failures_ >= max_failures;
    if (!use_direct_)
      attempt([&] { krylov_->setup(matrix, graph_version, symmetric); });
  }

  LinearResult do_solve(const Vector& b, Vector& x, double tolerance) override {
    LinearResult result;
    if (!use_direct_) {
      attempt([&] { result = krylov_->solve(b, x, tolerance); });
      if (!use_direct_)
        return result;
    }
    if (!direct_is_set_up_)
      direct_->setup(matrix_, graph_version_, symmetric_);
    direct_is_set_up_ = true;
    return direct_->solve(b, x, tolerance);
  }

  template <class Work> void attempt(Work work) {
    try {
      work();
    } catch (const SolveError& e) {
      use_direct_ = true;
      ++failures_;
      log(log_, LogLevel::warning, std::string(e.what()) + " Solving directly instead.");
    }
  }

  static constexpr int max_failures = 3; ///< matrices on which Krylov fails before it is given up
  std::unique_ptr<LinearSolver> krylov_, direct_;
  LogSink log_;
  RCP<const Matrix> matrix_;
  long graph_version_ = 0;
  bool symmetric_ = false, use_direct_ = false, direct_is_set_up_ = false;
  int failures_ = 0;
};

} // namespace

void LinearSolver::setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) {
  const OptionalScope scope(timers_, Phase::linear_solve);
  do_setup(matrix, graph_version, symmetric);
}

LinearResult LinearSolver::solve(const Vector& b, Vector& x, double tolerance) {
  const OptionalScope scope(timers_, Phase::linear_solve);
  x.putScalar(0.0);
  const double size = b.norm2();
  if (size == 0.0)
    return {};
  if (!std::isfinite(size))
    throw SolveError("The right-hand side of a linear system is not a finite number.");
  const LinearResult result = do_solve(b, x, tolerance);
  total_iterations_ += result.iterations;
  return result;
}

std::unique_ptr<LinearSolver> make_linear_solver(const LinearOptions& options,
                                                 const NonlinearSystem& system, const LogSink& log,
                                                 PhaseTimers* timers) {
  const auto unknowns = static_cast<long long>(system.map()->getGlobalNumElements());
  const bool direct =
      system.indefinite() || options.method == LinearMethod::direct ||
      (options.method == LinearMethod::automatic && unknowns <= options.direct_limit);
  if (direct)
    return std::make_unique<MumpsSolver>(timers);
  if (options.method == LinearMethod::krylov)
    return std::make_unique<KrylovSolver>(options, system, log, timers);
  return std::make_unique<FallbackSolver>(std::make_unique<KrylovSolver>(options, system, log),
                                          std::make_unique<MumpsSolver>(), log, timers);
}

} // namespace abut::solver
