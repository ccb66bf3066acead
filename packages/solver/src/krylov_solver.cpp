// SPDX-License-Identifier: BSD-3-Clause
#include "krylov_solver.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "parameter_text.hpp"
#include "preconditioning.hpp"

#include <BelosSolverFactory_Tpetra.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_ParameterListExceptions.hpp>
#include <cmath>
#include <optional>
#include <sstream>

namespace abut::solver {

namespace {

using Problem = Belos::LinearProblem<double, MultiVector, Operator>;

constexpr double max_growth = 1.5;   ///< of the iterations with a preconditioner that is kept
constexpr int slack = 2;             ///< iterations beyond that
constexpr double worn_growth = 1.15; ///< beyond which the next system gets a new one
constexpr int most_kept =
    2; ///< systems on which a preconditioner stays as it is, where it might do

/// By how many powers of ten a residual falls.
double decades(double relative_residual) {
  return std::max(1.0, -std::log10(std::max(relative_residual, 1e-16)));
}

std::string scientific(double x) {
  std::ostringstream text;
  text.precision(2);
  text << std::scientific << x;
  return text.str();
}

/// An operator whose time is counted.
class Measured : public Operator {
public:
  Measured(RCP<const Operator> inner, double& seconds)
      : inner_(std::move(inner)), seconds_(seconds) {}

  RCP<const Map> getDomainMap() const override { return inner_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return inner_->getRangeMap(); }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp mode, double alpha,
             double beta) const override {
    const Stopwatch watch;
    inner_->apply(x, y, mode, alpha, beta);
    seconds_ += watch.seconds();
  }

private:
  RCP<const Operator> inner_;
  double& seconds_;
};

} // namespace

class KrylovSolver::Implementation {
public:
  Implementation(const LinearOptions& options, const NonlinearSystem& system, LogSink log,
                 KrylovRole role, KrylovSolver& owner)
      : options_(options), log_(std::move(log)), role_(role), owner_(owner),
        preconditioning_(make_preconditioning(options, system, log_)) {
    Teuchos::ParameterList probe; // unreadable lists are reported before anything is solved
    merge_parameter_text(options_.belos, "Belos", probe);
    merge_parameter_text(options_.muelu, "MueLu", probe);
    merge_parameter_text(options_.ifpack2, "Ifpack2", probe);
  }

  void set_matrix(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) {
    if (symmetric != symmetric_ || worn_)
      forget();
    else if (!preconditioner_.is_null())
      keep_or_renew(matrix, graph_version == graph_version_);
    matrix_ = matrix;
    symmetric_ = symmetric;
    graph_version_ = graph_version;
  }

  void forget() {
    preconditioner_ = Teuchos::null;
    worn_ = false;
  }

  LinearResult solve(const Vector& b, Vector& x, double tolerance) {
    if (!preconditioner_.is_null()) {
      const double usual = iterations_per_decade_ * decades(tolerance);
      const int limit =
          std::min(options_.max_iterations, static_cast<int>(max_growth * usual) + slack);
      const auto result = iterate(symmetric_, b, x, tolerance, limit);
      if (result) {
        const double fresh = iterations_per_decade_ * decades(result->relative_residual);
        worn_ = result->iterations > worn_growth * fresh + 1.0;
        return *result;
      }
      forget();
    }
    build_preconditioner();
    auto result = iterate(symmetric_, b, x, tolerance, options_.max_iterations);
    if (!result && symmetric_ && role_ == KrylovRole::alone) {
      log_message("Conjugate gradients did not converge (" + last_attempt_ +
                  "); GMRES takes over.");
      result = iterate(false, b, x, tolerance, options_.max_iterations);
    }
    if (!result) {
      forget();
      throw SolveError("The Krylov solver did not converge: " + last_attempt_ + ", wanted " +
                       scientific(tolerance) + ".");
    }
    iterations_per_decade_ = result->iterations / decades(result->relative_residual);
    return *result;
  }

private:
  void log_message(const std::string& message) { log(log_, LogLevel::info, message); }

  void build_preconditioner() {
    try {
      owner_.measured_setup([this] {
        preconditioner_ = preconditioning_->build(matrix_, symmetric_);
        return true;
      });
      kept_ = 0;
    } catch (const Teuchos::Exceptions::InvalidParameter&) {
      throw; // a list of the user's, which no other step mends
    } catch (const std::exception& e) {
      preconditioner_ = Teuchos::null;
      throw SolveError(std::string("The preconditioner cannot be built: ") + e.what());
    }
  }

  /// An unsymmetric matrix changes with stick and slip: its coarse matrices are renewed each time.
  void keep_or_renew(const RCP<const Matrix>& matrix, bool same_graph) {
    if (symmetric_ && same_graph && kept_ < most_kept)
      ++kept_;
    else
      renew(matrix, same_graph);
  }

  /// A preconditioner that cannot be renewed is kept as it is.
  void renew(const RCP<const Matrix>& matrix, bool same_graph) {
    RCP<Operator> renewed;
    try {
      owner_.measured_setup([&] {
        renewed = preconditioning_->renew(matrix, symmetric_, same_graph);
        return !renewed.is_null();
      });
    } catch (const std::exception& e) {
      forget();
      return;
    }
    if (renewed.is_null())
      return;
    preconditioner_ = renewed;
    kept_ = 0;
  }

  /// Nothing when the tolerance is not met within `limit` iterations.
  std::optional<LinearResult> iterate(bool conjugate_gradients, const Vector& b, Vector& x,
                                      double tolerance, int limit) {
    x.putScalar(0.0);
    const auto problem = rcp(new Problem(matrix_, Teuchos::rcpFromRef<MultiVector>(x),
                                         Teuchos::rcpFromRef<const MultiVector>(b)));
    const RCP<const Operator> measured = rcp(new Measured(preconditioner_, owner_.apply_seconds()));
    if (conjugate_gradients)
      problem->setLeftPrec(measured);
    else
      problem->setRightPrec(measured);
    problem->setProblem();
    const auto list = Teuchos::parameterList();
    list->set("Convergence Tolerance", tolerance);
    list->set("Maximum Iterations", limit);
    if (conjugate_gradients) {
      // Away from a solution a tangent may be indefinite: CG goes on, and the residual tells.
      list->set("Assert Positive Definiteness", false);
    } else {
      // Flexible: what a preconditioner in single precision rounds does not limit the residual.
      list->set("Flexible Gmres", true);
      list->set("Num Blocks", std::min(limit, 200));
      list->set("Maximum Restarts", limit / 200 + 1);
    }
    merge_parameter_text(options_.belos, "Belos", *list);
    list->set("Maximum Iterations", std::min(limit, list->get<int>("Maximum Iterations")));

    Belos::SolverFactory<double, MultiVector, Operator> factory;
    RCP<Belos::SolverManager<double, MultiVector, Operator>> solver;
    try {
      solver = factory.create(conjugate_gradients ? "PSEUDOBLOCK CG" : "BLOCK GMRES", list);
    } catch (const std::exception& e) {
      throw InputError(std::string("Belos does not take its parameter list: ") + e.what());
    }
    solver->setProblem(problem);
    bool converged = false;
    std::string breakdown;
    try {
      converged = solver->solve() == Belos::Converged;
    } catch (const std::exception& e) {
      breakdown = ", it broke down"; // an operator that is not positive definite, or not finite
    }
    Vector residual(b.getMap());
    matrix_->apply(x, residual);
    residual.update(1.0, b, -1.0);
    const double relative = residual.norm2() / b.norm2();
    last_attempt_ = std::to_string(solver->getNumIters()) + " iterations, relative residual " +
                    scientific(relative) + breakdown;
    if (!converged || !(relative <= 10.0 * tolerance))
      return std::nullopt;
    return LinearResult{solver->getNumIters(), relative};
  }

  LinearOptions options_;
  LogSink log_;
  KrylovRole role_;
  KrylovSolver& owner_; ///< to measure setups
  std::unique_ptr<Preconditioning> preconditioning_;
  bool symmetric_ = false;
  long graph_version_ = -1;
  RCP<const Matrix> matrix_;
  RCP<Operator> preconditioner_;
  double iterations_per_decade_ = 0.0; ///< right after it was built
  int kept_ = 0;                       ///< systems since it was built or renewed
  bool worn_ = false;                  ///< the last system took more iterations than fresh ones do
  std::string last_attempt_;
};

KrylovSolver::KrylovSolver(const LinearOptions& options, const NonlinearSystem& system, LogSink log,
                           KrylovRole role, PhaseTimers* timers)
    : LinearSolver(std::string("krylov with ") + name(options.preconditioner), timers),
      implementation_(
          std::make_unique<Implementation>(options, system, std::move(log), role, *this)) {}

KrylovSolver::~KrylovSolver() = default;

void KrylovSolver::forget() {
  implementation_->forget();
}

void KrylovSolver::do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) {
  implementation_->set_matrix(matrix, graph_version, symmetric);
}

LinearResult KrylovSolver::do_solve(const Vector& b, Vector& x, double tolerance) {
  return implementation_->solve(b, x, tolerance);
}

} // namespace abut::solver
