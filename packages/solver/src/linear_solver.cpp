// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/linear_solver.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "escalating_solver.hpp"
#include "krylov_solver.hpp"
#include "mumps_solver.hpp"
#include "preconditioning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// An iteration of Krylov with multigrid costs as much as a factorization over this many unknowns
/// (measured on blocks in contact: 100 at 23,000 unknowns, 130 at 75,000), at least so many times.
constexpr long long unknowns_per_iteration = 100;
constexpr long long fewest_iterations = 100;

int worthwhile_iterations(long long unknowns) {
  constexpr long long most = std::numeric_limits<int>::max();
  return static_cast<int>(
      std::min(most, std::max(fewest_iterations, unknowns / unknowns_per_iteration)));
}

} // namespace

template <class Work> void LinearSolver::measured(Work work) {
  const OptionalScope scope(timers_, Phase::linear_solve);
  const Stopwatch watch;
  const auto stop = [&] { use_.seconds += watch.seconds(); };
  try {
    work();
  } catch (const SolveError&) {
    stop();
    use_.failures += !failed_;
    failed_ = true;
    throw;
  }
  stop();
}

void LinearSolver::setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) {
  solved_ = failed_ = false;
  measured([&] { do_setup(matrix, graph_version, symmetric); });
}

LinearResult LinearSolver::solve(const Vector& b, Vector& x, double tolerance) {
  LinearResult result;
  x.putScalar(0.0);
  const double size = b.norm2();
  if (size == 0.0)
    return result;
  if (!std::isfinite(size))
    throw SolveError("The right-hand side of a linear system is not a finite number.");
  measured([&] { result = do_solve(b, x, tolerance); });
  ++use_.solves;
  use_.iterations += result.iterations;
  use_.systems += !solved_;
  solved_ = true;
  return result;
}

std::unique_ptr<LinearSolver> make_linear_solver(const LinearOptions& options,
                                                 const NonlinearSystem& system, const LogSink& log,
                                                 PhaseTimers* timers) {
  const auto unknowns = static_cast<long long>(system.map()->getGlobalNumElements());
  const bool automatic = options.method == LinearMethod::automatic;
  const auto choose = [&](const std::string& method) {
    if (automatic)
      abut::log(log, LogLevel::info,
                "linear solver: " + method + " for " + std::to_string(unknowns) + " unknowns" +
                    (system.indefinite() ? ", multipliers among them" : ""));
  };
  if (system.indefinite() || options.method == LinearMethod::direct ||
      (automatic && unknowns <= options.direct_limit)) {
    choose("direct");
    return std::make_unique<MumpsSolver>(timers, system.indefinite());
  }
  LinearOptions cheap = options;
  cheap.preconditioner = choose_preconditioner(options.preconditioner, system);
  if (!automatic)
    return std::make_unique<KrylovSolver>(cheap, system, log, KrylovRole::alone, timers);
  cheap.max_iterations = std::min(options.max_iterations, worthwhile_iterations(unknowns));
  auto krylov = std::make_unique<KrylovSolver>(cheap, system, log, KrylovRole::first);
  choose(krylov->uses().front().method + ", direct where that fails,");
  return std::make_unique<EscalatingSolver>(std::move(krylov), std::make_unique<MumpsSolver>(),
                                            unknowns > options.dear_limit, log, timers);
}

} // namespace abut::solver
