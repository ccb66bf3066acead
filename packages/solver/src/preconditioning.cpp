// SPDX-License-Identifier: BSD-3-Clause
#include "preconditioning.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"

namespace abut::solver {

namespace {

/// Whether all ranks know where their rows are, and multigrid takes so many unknowns to a row.
bool takes_cycle(const NonlinearSystem& system) {
  const int fields = system.unknowns_per_node();
  const bool here = !system.row_places().empty() || local_size(*system.map()) == 0;
  int mine = here && fields <= 4 ? 1 : 0, all = 0;
  Teuchos::reduceAll(*system.map()->getComm(), Teuchos::REDUCE_MIN, mine, Teuchos::outArg(all));
  return all == 1;
}

} // namespace

Preconditioner choose_preconditioner(Preconditioner asked, const NonlinearSystem& system) {
  if (asked != Preconditioner::automatic && asked != Preconditioner::multigrid)
    return asked;
  if (takes_cycle(system))
    return Preconditioner::multigrid;
  if (asked == Preconditioner::multigrid)
    throw InputError("The unknowns of this system do not go together with multigrid.");
  return Preconditioner::ilu;
}

const char* name(Preconditioner preconditioner) {
  switch (preconditioner) {
  case Preconditioner::multigrid:
    return "multigrid";
  case Preconditioner::muelu:
    return "muelu";
  case Preconditioner::ilu:
    return "ilu";
  case Preconditioner::automatic:
    break;
  }
  throw Defect("a preconditioner that is not chosen");
}

std::unique_ptr<Preconditioning> make_preconditioning(const LinearOptions& options,
                                                      const NonlinearSystem& system,
                                                      const LogSink& log) {
  switch (options.preconditioner) {
  case Preconditioner::muelu:
    return make_muelu_preconditioning(options, system, log);
  case Preconditioner::ilu:
    return make_ilu_preconditioning(options);
  case Preconditioner::multigrid:
    return make_cycle_preconditioning(system);
  case Preconditioner::automatic:
    break;
  }
  throw Defect("a preconditioner that is not chosen");
}

} // namespace abut::solver
