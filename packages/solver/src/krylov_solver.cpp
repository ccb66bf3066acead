// SPDX-License-Identifier: BSD-3-Clause
#include "krylov_solver.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "parameter_text.hpp"

#include <BelosSolverFactory_Tpetra.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Ifpack2_Factory.hpp>
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <cmath>
#include <optional>
#include <sstream>

namespace abut::solver {

namespace {

using Problem = Belos::LinearProblem<double, MultiVector, Operator>;
using RowMatrix = Tpetra::RowMatrix<double, Local, Global, Node>;

constexpr double max_growth = 1.5; ///< of the iterations with a preconditioner that is kept

std::string scientific(double x) {
  std::ostringstream text;
  text.precision(2);
  text << std::scientific << x;
  return text.str();
}

/// Multigrid groups unknowns into nodes by their ids: node n must hold ids 3n, 3n+1, 3n+2.
bool ids_come_by_node(const Map& map, int per_node) {
  bool good = local_size(map) % static_cast<std::size_t>(per_node) == 0;
  const Global base = map.getIndexBase();
  for (Local i = 0; good && i < static_cast<Local>(local_size(map)); ++i) {
    const Global id = map.getGlobalElement(i) - base;
    const Global first = map.getGlobalElement(i - i % per_node) - base;
    good = first % per_node == 0 && id == first + i % per_node;
  }
  int mine = good ? 1 : 0, all = 0;
  Teuchos::reduceAll(*map.getComm(), Teuchos::REDUCE_MIN, mine, Teuchos::outArg(all));
  return all == 1;
}

} // namespace

class KrylovSolver::Implementation {
public:
  Implementation(const LinearOptions& options, const NonlinearSystem& system, LogSink log)
      : options_(options), log_(std::move(log)), map_(system.map()),
        per_node_(system.unknowns_per_node()) {
    const bool by_node = ids_come_by_node(*map_, per_node_);
    int mine = system.node_coordinates() || local_size(*map_) == 0 ? 1 : 0, all = 0;
    Teuchos::reduceAll(*map_->getComm(), Teuchos::REDUCE_MIN, mine, Teuchos::outArg(all));
    const bool elastic = per_node_ == 3 && by_node && all == 1;
    multigrid_ = options.preconditioner == Preconditioner::muelu ||
                 (options.preconditioner == Preconditioner::automatic && elastic);
    if (multigrid_ && !by_node) {
      log_message("The unknowns are not numbered node by node: multigrid treats each on its own.");
      per_node_ = 1;
    }
    if (elastic)
      set_rigid_body_modes(system.node_coordinates());
    Teuchos::ParameterList probe; // unreadable lists are reported before anything is solved
    merge_parameter_text(options_.belos, "Belos", probe);
    merge_parameter_text(options_.muelu, "MueLu", probe);
    merge_parameter_text(options_.ifpack2, "Ifpack2", probe);
  }

  void set_matrix(const RCP<const Matrix>& matrix, bool symmetric) {
    if (symmetric != symmetric_)
      forget();
    matrix_ = matrix;
    symmetric_ = symmetric;
  }

  void forget() { preconditioner_ = Teuchos::null; }

  LinearResult solve(const Vector& b, Vector& x, double tolerance) {
    if (!preconditioner_.is_null()) {
      const int limit = std::min(options_.max_iterations, reuse_limit_);
      const auto result = iterate(symmetric_, b, x, tolerance, limit);
      if (result)
        return *result;
      forget();
    }
    build_preconditioner();
    auto result = iterate(symmetric_, b, x, tolerance, options_.max_iterations);
    if (!result && symmetric_) {
      log_message("Conjugate gradients did not converge (" + last_attempt_ +
                  "); GMRES takes over.");
      result = iterate(false, b, x, tolerance, options_.max_iterations);
    }
    if (!result) {
      forget();
      throw SolveError("The Krylov solver did not converge: " + last_attempt_ + ", wanted " +
                       scientific(tolerance) + ".");
    }
    reuse_limit_ = static_cast<int>(std::ceil(max_growth * result->iterations)) + 1;
    return *result;
  }

private:
  void log_message(const std::string& message) { log(log_, LogLevel::info, message); }

  /// Three translations and three rotations about the centre, columns of equal size.
  void set_rigid_body_modes(const double* coordinates) {
    const auto local = static_cast<Local>(local_size(*map_));
    const Local nodes = local / 3;
    const auto node_map = rcp(new Map(map_->getGlobalNumElements() / 3,
                                      static_cast<std::size_t>(nodes), 0, map_->getComm()));
    coordinates_ = rcp(new MultiVector(node_map, 3));
    null_space_ = rcp(new MultiVector(map_, 6));
    const auto point = coordinates_->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (Local n = 0; n < nodes; ++n)
      for (int d = 0; d < 3; ++d)
        point(n, d) = coordinates[3 * n + d];

    double sum[4] = {0, 0, 0, double(nodes)}, total[4], square = 0, all_squares = 0;
    for (Local n = 0; n < nodes; ++n)
      for (int d = 0; d < 3; ++d)
        sum[d] += point(n, d);
    Teuchos::reduceAll(*map_->getComm(), Teuchos::REDUCE_SUM, 4, sum, total);
    for (int d = 0; d < 3; ++d)
      total[d] /= std::max(1.0, total[3]);
    for (Local n = 0; n < nodes; ++n)
      for (int d = 0; d < 3; ++d)
        square += std::pow(point(n, d) - total[d], 2);
    Teuchos::reduceAll(*map_->getComm(), Teuchos::REDUCE_SUM, square, Teuchos::outArg(all_squares));
    const double radius = std::sqrt(all_squares / std::max(1.0, total[3]));
    const double scale = radius > 0.0 ? 1.0 / radius : 1.0;

    null_space_->putScalar(0.0);
    const auto mode = null_space_->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (Local n = 0; n < nodes; ++n)
      for (int d = 0; d < 3; ++d) {
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        mode(3 * n + d, d) = 1.0;
        mode(3 * n + e, 3 + d) = -scale * (point(n, f) - total[f]);
        mode(3 * n + f, 3 + d) = scale * (point(n, e) - total[e]);
      }
  }

  void build_preconditioner() {
    try {
      preconditioner_ = multigrid_ ? build_multigrid() : build_incomplete_factors();
    } catch (const std::exception& e) {
      preconditioner_ = Teuchos::null;
      throw SolveError(std::string("The preconditioner cannot be built: ") + e.what());
    }
  }

  RCP<Operator> build_multigrid() const {
    Teuchos::ParameterList list;
    list.set("verbosity", "none");
    list.set("multigrid algorithm", "sa");
    list.set("number of equations", per_node_);
    list.set("smoother: type", "CHEBYSHEV");
    list.sublist("smoother: params").set("chebyshev: degree", 3);
    list.set("coarse: max size", 500);
    if (map_->getComm()->getSize() > 1) {
      // The default, KLU2, is wrong on several ranks in some builds of Trilinos.
      list.set("coarse: type", "RELAXATION");
      auto& coarse = list.sublist("coarse: params");
      coarse.set("relaxation: type", "Symmetric Gauss-Seidel");
      coarse.set("relaxation: sweeps", 20);
    }
    merge_parameter_text(options_.muelu, "MueLu", list);
    if (!null_space_.is_null()) {
      list.sublist("user data").set("Nullspace", null_space_);
      list.sublist("user data").set("Coordinates", coordinates_);
    }
    // MueLu asks for a matrix that it may change; it does not without "reuse" of our values.
    RCP<Operator> matrix = Teuchos::rcp_const_cast<Matrix>(matrix_);
    return MueLu::CreateTpetraPreconditioner(matrix, list);
  }

  RCP<Operator> build_incomplete_factors() const {
    Teuchos::ParameterList list;
    list.set("inner preconditioner name", "RILUK");
    list.set("schwarz: overlap level", 1);
    // A symmetric preconditioner for CG; the restricted one needs fewer iterations with GMRES.
    list.set("schwarz: combine mode", symmetric_ ? "ADD" : "ZERO");
    list.sublist("inner preconditioner parameters").set("fact: iluk level-of-fill", 0);
    merge_parameter_text(options_.ifpack2, "Ifpack2", list);
    auto schwarz = Ifpack2::Factory::create<RowMatrix>("SCHWARZ", matrix_);
    schwarz->setParameters(list);
    schwarz->initialize();
    schwarz->compute();
    return schwarz;
  }

  /// Nothing when the tolerance is not met within `limit` iterations.
  std::optional<LinearResult> iterate(bool conjugate_gradients, const Vector& b, Vector& x,
                                      double tolerance, int limit) {
    x.putScalar(0.0);
    const auto problem = rcp(new Problem(matrix_, Teuchos::rcpFromRef<MultiVector>(x),
                                         Teuchos::rcpFromRef<const MultiVector>(b)));
    if (conjugate_gradients)
      problem->setLeftPrec(preconditioner_);
    else
      problem->setRightPrec(preconditioner_);
    problem->setProblem();
    const auto list = Teuchos::parameterList();
    list->set("Convergence Tolerance", tolerance);
    list->set("Maximum Iterations", limit);
    if (!conjugate_gradients) {
      list->set("Num Blocks", std::min(limit, 200));
      list->set("Maximum Restarts", limit / 200 + 1);
    }
    merge_parameter_text(options_.belos, "Belos", *list);
    list->set("Maximum Iterations", std::min(limit, list->get<int>("Maximum Iterations")));

    Belos::SolverFactory<double, MultiVector, Operator> factory;
    RCP<Belos::SolverManager<double, MultiVector, Operator>> solver;
    try {
      solver = factory.create(conjugate_gradients ? "CG" : "GMRES", list);
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
  RCP<const Map> map_;
  int per_node_;
  bool multigrid_ = false, symmetric_ = false;
  RCP<MultiVector> coordinates_, null_space_;
  RCP<const Matrix> matrix_;
  RCP<Operator> preconditioner_;
  int reuse_limit_ = 0;
  std::string last_attempt_;
};

KrylovSolver::KrylovSolver(const LinearOptions& options, const NonlinearSystem& system, LogSink log,
                           PhaseTimers* timers)
    : LinearSolver(timers),
      implementation_(std::make_unique<Implementation>(options, system, std::move(log))) {}

KrylovSolver::~KrylovSolver() = default;

void KrylovSolver::forget() {
  implementation_->forget();
}

void KrylovSolver::do_setup(const RCP<const Matrix>& matrix, long, bool symmetric) {
  implementation_->set_matrix(matrix, symmetric);
}

LinearResult KrylovSolver::do_solve(const Vector& b, Vector& x, double tolerance) {
  return implementation_->solve(b, x, tolerance);
}

} // namespace abut::solver
