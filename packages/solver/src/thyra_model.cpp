// SPDX-License-Identifier: BSD-3-Clause
#include "thyra_model.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/linear_solver.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "forcing_term.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_StateFuncModelEvaluatorBase.hpp>
#include <Thyra_TpetraLinearOp.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>

namespace abut::solver {

namespace {

using Extraction = Thyra::TpetraOperatorVectorExtraction<double, Local, Global, Node>;
using Space = Thyra::VectorSpaceBase<double>;

/// The system's tangent of the moment.
class CurrentTangent : public Operator {
public:
  explicit CurrentTangent(RCP<const Map> map) : map_(std::move(map)) {}

  void set(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) {
    matrix_ = matrix, graph_version_ = graph_version, symmetric_ = symmetric;
  }
  void hand_to(LinearSolver& linear) const { linear.setup(matrix_, graph_version_, symmetric_); }

  RCP<const Map> getDomainMap() const override { return map_; }
  RCP<const Map> getRangeMap() const override { return map_; }
  bool hasTransposeApply() const override { return true; }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp mode, double alpha,
             double beta) const override {
    ABUT_REQUIRE(!matrix_.is_null(), "the tangent is used before it was evaluated");
    matrix_->apply(x, y, mode, alpha, beta);
  }

private:
  RCP<const Map> map_;
  RCP<const Matrix> matrix_;
  long graph_version_ = 0;
  bool symmetric_ = false;
};

class Model : public Thyra::StateFuncModelEvaluatorBase<double> {
public:
  explicit Model(NonlinearSystem& system)
      : system_(system),
        space_(Thyra::createVectorSpace<double, Local, Global, Node>(system.map())) {
    in_.setModelEvalDescription("abut");
    in_.setSupports(IN_ARG_x);
    out_.setModelEvalDescription("abut");
    out_.setSupports(OUT_ARG_f);
    out_.setSupports(OUT_ARG_W_op);
  }

  RCP<const Space> get_x_space() const override { return space_; }
  RCP<const Space> get_f_space() const override { return space_; }
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override { return in_; }
  RCP<Thyra::LinearOpBase<double>> create_W_op() const override {
    const RCP<Operator> tangent = rcp(new CurrentTangent(system_.map()));
    return Thyra::tpetraLinearOp<double, Local, Global, Node>(space_, space_, tangent);
  }

private:
  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override { return out_; }

  void evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override {
    const auto x = Extraction::getConstTpetraVector(in.get_x());
    if (!out.get_f().is_null())
      system_.residual(*x,
                       *Extraction::getTpetraVector(RCP<Thyra::VectorBase<double>>(out.get_f())));
    if (!out.get_W_op().is_null()) {
      const auto held = Extraction::getTpetraOperator(out.get_W_op());
      const auto matrix = system_.tangent(*x);
      Teuchos::rcp_dynamic_cast<CurrentTangent>(held, true)
          ->set(matrix, system_.graph_version(), system_.symmetric());
    }
  }

  NonlinearSystem& system_;
  RCP<const Space> space_;
  InArgsSetup<double> in_;
  OutArgsSetup<double> out_;
};

class Solve : public Thyra::LinearOpWithSolveBase<double> {
public:
  Solve(LinearSolver& linear, ForcingTerm* forcing) : linear_(linear), forcing_(forcing) {}

  void initialize(const RCP<const Thyra::LinearOpBase<double>>& forward) {
    forward_ = forward;
    const auto held = Extraction::getConstTpetraOperator(forward);
    Teuchos::rcp_dynamic_cast<const CurrentTangent>(held, true)->hand_to(linear_);
  }
  RCP<const Thyra::LinearOpBase<double>> release() {
    return std::exchange(forward_, Teuchos::null);
  }

  RCP<const Space> range() const override { return is_set() ? forward_->range() : Teuchos::null; }
  RCP<const Space> domain() const override { return is_set() ? forward_->domain() : Teuchos::null; }

private:
  bool is_set() const { return !forward_.is_null(); }
  bool opSupportedImpl(Thyra::EOpTransp) const override { return true; }
  void applyImpl(const Thyra::EOpTransp mode, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    forward_->apply(mode, x, y, alpha, beta);
  }
  bool solveSupportsImpl(Thyra::EOpTransp mode) const override { return mode == Thyra::NOTRANS; }
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp mode,
                                         const Thyra::SolveMeasureType&) const override {
    return mode == Thyra::NOTRANS;
  }

  Thyra::SolveStatus<double>
  solveImpl(const Thyra::EOpTransp mode, const Thyra::MultiVectorBase<double>& b,
            const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
            const Teuchos::Ptr<const Thyra::SolveCriteria<double>> criteria) const override {
    ABUT_REQUIRE(mode == Thyra::NOTRANS, "no solve with the transposed tangent");
    using Criteria = Thyra::SolveCriteria<double>;
    constexpr double default_tolerance = 1e-8;
    double tolerance = default_tolerance;
    if (!criteria.is_null() && criteria->requestedTol != Criteria::unspecifiedTolerance())
      tolerance = criteria->requestedTol;
    const auto right = Extraction::getConstTpetraMultiVector(Teuchos::rcpFromRef(b));
    const auto left = Extraction::getTpetraMultiVector(Teuchos::rcpFromPtr(x));
    Thyra::SolveStatus<double> status;
    status.achievedTol = 0.0;
    for (std::size_t j = 0; j < right->getNumVectors(); ++j) {
      const auto column = right->getVector(j);
      if (forcing_)
        tolerance = forcing_->tolerance(column->norm2());
      const auto result = linear_.solve(*column, *left->getVectorNonConst(j), tolerance);
      if (forcing_)
        forcing_->solved(result.relative_residual);
      status.achievedTol = std::max(status.achievedTol, result.relative_residual);
    }
    status.solveStatus = Thyra::SOLVE_STATUS_CONVERGED;
    return status;
  }

  LinearSolver& linear_;
  ForcingTerm* forcing_;
  RCP<const Thyra::LinearOpBase<double>> forward_;
};

class SolveFactory : public Thyra::LinearOpWithSolveFactoryBase<double> {
public:
  SolveFactory(LinearSolver& linear, ForcingTerm* forcing) : linear_(linear), forcing_(forcing) {}

  bool isCompatible(const Thyra::LinearOpSourceBase<double>& source) const override {
    const auto held = Extraction::getConstTpetraOperator(source.getOp());
    return !Teuchos::rcp_dynamic_cast<const CurrentTangent>(held).is_null();
  }
  RCP<Thyra::LinearOpWithSolveBase<double>> createOp() const override {
    return rcp(new Solve(linear_, forcing_));
  }
  void initializeOp(const RCP<const Thyra::LinearOpSourceBase<double>>& source,
                    Thyra::LinearOpWithSolveBase<double>* op,
                    const Thyra::ESupportSolveUse) const override {
    dynamic_cast<Solve&>(*op).initialize(source->getOp());
  }
  void uninitializeOp(Thyra::LinearOpWithSolveBase<double>* op,
                      RCP<const Thyra::LinearOpSourceBase<double>>* source,
                      RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      RCP<const Thyra::LinearOpSourceBase<double>>* approximate,
                      Thyra::ESupportSolveUse* use) const override {
    const auto forward = dynamic_cast<Solve&>(*op).release();
    if (source)
      *source = forward.is_null() ? Teuchos::null : Thyra::defaultLinearOpSource(forward);
    if (preconditioner)
      *preconditioner = Teuchos::null;
    if (approximate)
      *approximate = Teuchos::null;
    if (use)
      *use = Thyra::SUPPORT_SOLVE_UNSPECIFIED;
  }

  // There is nothing to set from a list: options come with the linear solver.
  void setParameterList(const RCP<Teuchos::ParameterList>& list) override { list_ = list; }
  RCP<Teuchos::ParameterList> getNonconstParameterList() override { return list_; }
  RCP<Teuchos::ParameterList> unsetParameterList() override {
    return std::exchange(list_, Teuchos::null);
  }

private:
  LinearSolver& linear_;
  ForcingTerm* forcing_;
  RCP<Teuchos::ParameterList> list_;
};

} // namespace

RCP<const Thyra::ModelEvaluator<double>> make_thyra_model(NonlinearSystem& system) {
  return rcp(new Model(system));
}

RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> make_solve_factory(LinearSolver& linear,
                                                                          ForcingTerm* forcing) {
  return rcp(new SolveFactory(linear, forcing));
}

RCP<Thyra::VectorBase<double>> thyra_vector(const Thyra::ModelEvaluator<double>& model,
                                            const RCP<Vector>& x) {
  return Thyra::createVector<double, Local, Global, Node>(x, model.get_x_space());
}

RCP<const Vector> tpetra_vector(const RCP<const Thyra::VectorBase<double>>& x) {
  return Extraction::getConstTpetraVector(x);
}

} // namespace abut::solver
