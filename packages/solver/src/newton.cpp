// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/newton.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/linear_solver.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "convergence_test.hpp"
#include "forcing_term.hpp"
#include "line_search.hpp"
#include "parameter_text.hpp"
#include "thyra_model.hpp"

#include <NOX_Observer.hpp>
#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_Thyra_Group.H>
#include <NOX_Thyra_Vector.H>
#include <Teuchos_oblackholestream.hpp>
#include <algorithm>

namespace abut::solver {

namespace {

/// Tells the system when Newton goes on from an iterate: its tangent has been used, and the trials
/// of the line search come next.
class IterateObserver : public NOX::Observer {
public:
  explicit IterateObserver(NonlinearSystem& system) : system_(system) {}
  void runPreLineSearch(const NOX::Solver::Generic&) override { system_.iterate_taken(); }

private:
  NonlinearSystem& system_;
};

RCP<Teuchos::ParameterList> nox_parameters(const NewtonOptions& options,
                                           std::optional<double> linear_tolerance,
                                           bool indefinite) {
  const auto list = Teuchos::parameterList();
  list->set("Nonlinear Solver", "Line Search Based");
  auto& newton = list->sublist("Direction").set("Method", "Newton").sublist("Newton");
  newton.set("Forcing Term Method", "Constant");
  // NOX would go on with whatever a failed linear solve left behind.
  newton.set("Rescue Bad Newton Solve", false);
  newton.sublist("Linear Solver").set("Tolerance", linear_tolerance.value_or(ForcingTerm::finest));
  auto& search = list->sublist("Line Search");
  if (options.line_search == LineSearch::automatic) {
    search.set("Method", "User Defined");
    search.set<RCP<NOX::LineSearch::UserDefinedFactory>>(
        "User Defined Line Search Factory", rcp(new SlopeLineSearchFactory(indefinite)));
  } else {
    search.set("Method", "Full Step");
  }
  const RCP<std::ostream> nowhere = rcp(new Teuchos::oblackholestream);
  auto& printing = list->sublist("Printing");
  printing.set("Output Information", 0);
  printing.set("Output Stream", nowhere);
  printing.set("Error Stream", nowhere);
  merge_parameter_text(options.nox, "NOX", *list);
  return list;
}

/// Whether NOX is left to ask for the one tolerance that nox_parameters gave it.
bool asks_for_default(Teuchos::ParameterList& list) {
  auto& newton = list.sublist("Direction").sublist("Newton");
  return newton.get<std::string>("Forcing Term Method") == "Constant" &&
         newton.sublist("Linear Solver").get<double>("Tolerance") == ForcingTerm::finest;
}

RCP<NOX::Solver::Generic> build_solver(const RCP<NOX::Abstract::Group>& group,
                                       const RCP<NOX::StatusTest::Generic>& test,
                                       const RCP<Teuchos::ParameterList>& list) {
  std::string why;
  try {
    return NOX::Solver::buildSolver(group, test, list);
  } catch (const std::exception& e) {
    why = e.what();
  } catch (const char* e) { // NOX throws plain text in places
    why = e;
  }
  throw InputError("NOX does not take its parameter list: " + why);
}

} // namespace

NewtonSolver::NewtonSolver(LinearSolver& linear, NewtonOptions options,
                           std::optional<double> linear_tolerance)
    : linear_(linear), options_(std::move(options)), linear_tolerance_(linear_tolerance),
      forcing_(std::make_unique<ForcingTerm>(options_.tolerance, options_.displacement_tolerance)) {
  nox_parameters(options_, linear_tolerance_, false);
}

NewtonSolver::~NewtonSolver() = default;

double NewtonSolver::predictor_tolerance() {
  return linear_tolerance_ ? *linear_tolerance_ : forcing_->predictor_tolerance();
}

void NewtonSolver::exchange_state(StateArchive& archive) {
  archive.numbers("newton", [&](auto& v) { forcing_->list_state(v); });
  linear_.exchange_state(archive);
}

void NewtonSolver::begin_step(const Vector& x) {
  step_start_ = rcp(new Vector(x, Teuchos::Copy));
  largest_work_ = 0.0;
}

NewtonResult NewtonSolver::solve(NonlinearSystem& system, Vector& x,
                                 const IterationCallback& observer, const EarlyEnd& early) {
  const auto list = nox_parameters(options_, linear_tolerance_, system.indefinite());
  list->sublist("Solver Options")
      .set<RCP<NOX::Observer>>("Observer", rcp(new IterateObserver(system)));
  ForcingTerm* const forcing =
      !linear_tolerance_ && asks_for_default(*list) ? forcing_.get() : nullptr;
  forcing_->begin_solve(system);
  const auto model = make_thyra_model(system);
  const auto start = thyra_vector(*model, rcp(new Vector(x, Teuchos::Copy)));
  const RCP<Thyra::PreconditionerBase<double>> no_preconditioner;
  const RCP<Thyra::PreconditionerFactoryBase<double>> no_factory;
  const RCP<NOX::Abstract::Group> group = rcp(
      new NOX::Thyra::Group(NOX::Thyra::Vector(start), model, model->create_W_op(),
                            make_solve_factory(linear_, forcing), no_preconditioner, no_factory));
  RCP<const Vector> origin = step_start_;
  if (origin.is_null())
    origin = rcp(new Vector(x, Teuchos::Copy));
  const IncrementScale scale{*origin, largest_work_};
  const auto test = rcp(new ConvergenceTest(system, linear_, options_, early, scale, observer));
  const auto solver = build_solver(group, test, list);
  try {
    solver->solve();
  } catch (const char* e) {
    throw SolveError(std::string("NOX stopped: ") + e);
  }
  const auto& last = dynamic_cast<const NOX::Thyra::Vector&>(solver->getSolutionGroup().getX());
  Tpetra::deep_copy(x, *tpetra_vector(last.getThyraRCPVector()));
  if (!step_start_.is_null() && test->result().converged)
    largest_work_ = test->largest_work();
  return test->result();
}

} // namespace abut::solver
