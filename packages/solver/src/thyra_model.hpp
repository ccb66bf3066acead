// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos_fwd.hpp"

#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Thyra_ModelEvaluator.hpp>

namespace abut::solver {

class ForcingTerm;
class LinearSolver;
class NonlinearSystem;

/// The system as a Thyra model: f(x), and W = df/dx as an operator that passes on to whatever
/// matrix the system holds at present, for its graph may change. Both arguments must outlive the
/// model.
RCP<const Thyra::ModelEvaluator<double>> make_thyra_model(NonlinearSystem& system);

/// Solves with the W of such a model, as exactly as `forcing` says, or where that is null as the
/// caller does; both must outlive the factory. SolveErrors of `linear` pass through.
RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> make_solve_factory(LinearSolver& linear,
                                                                          ForcingTerm* forcing);

/// Views of Tpetra vectors as Thyra vectors of the model's space, and back; nothing is copied.
RCP<Thyra::VectorBase<double>> thyra_vector(const Thyra::ModelEvaluator<double>& model,
                                            const RCP<Vector>& x);
RCP<const Vector> tpetra_vector(const RCP<const Thyra::VectorBase<double>>& x);

} // namespace abut::solver
