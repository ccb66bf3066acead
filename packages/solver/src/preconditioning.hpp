// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/log.hpp"
#include "abut/core/trilinos_fwd.hpp"
#include "abut/solver/options.hpp"

#include <Tpetra_Operator_fwd.hpp>
#include <memory>

namespace abut::solver {

class NonlinearSystem;

/// Makes what stands in for the inverse of a matrix within a Krylov method, for one matrix after
/// the other. Every member is collective.
class Preconditioning {
public:
  using Operator = Tpetra::Operator<double, Local, Global, Node>;

  virtual ~Preconditioning() = default;
  /// From nothing. Throws what the library that makes it throws.
  virtual RCP<Operator> build(const RCP<const Matrix>& matrix, bool symmetric) = 0;
  /// For another matrix, at a part of the price of the first. same_graph: only values differ from
  /// the last one. Null: there is no cheaper way than to build.
  virtual RCP<Operator> renew(const RCP<const Matrix>& matrix, bool symmetric, bool same_graph) {
    static_cast<void>(matrix), static_cast<void>(symmetric), static_cast<void>(same_graph);
    return Teuchos::null;
  }
};

/// What is asked for; for `automatic`, multigrid where the system's rows are nodes at known places,
/// else incomplete factors. Throws InputError where multigrid is asked for and they are not.
/// Collective.
Preconditioner choose_preconditioner(Preconditioner asked, const NonlinearSystem& system);

/// As decks call it. Throws Defect for `automatic`.
const char* name(Preconditioner preconditioner);

/// By options.preconditioner, which must have been chosen.
std::unique_ptr<Preconditioning> make_preconditioning(const LinearOptions& options,
                                                      const NonlinearSystem& system,
                                                      const LogSink& log);

/// Node-block multigrid, see abut::multigrid. The system must know the places of its rows.
std::unique_ptr<Preconditioning> make_cycle_preconditioning(const NonlinearSystem& system);

/// MueLu, or Ifpack2's incomplete factors.
std::unique_ptr<Preconditioning> make_muelu_preconditioning(const LinearOptions& options,
                                                            const NonlinearSystem& system,
                                                            const LogSink& log);
std::unique_ptr<Preconditioning> make_ilu_preconditioning(const LinearOptions& options);

} // namespace abut::solver
