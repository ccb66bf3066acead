// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/trilinos.hpp"
#include "abut/multigrid/multigrid.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "preconditioning.hpp"

namespace abut::solver {

namespace {

class CyclePreconditioning : public Preconditioning {
public:
  explicit CyclePreconditioning(const NonlinearSystem& system) {
    const auto mpi =
        Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(system.map()->getComm(), true);
    const Comm comm(*mpi->getRawMpiComm());
    const auto modes =
        multigrid::rigid_motions(comm, system.unknowns_per_node(), system.row_places());
    multigrid_ = std::make_shared<multigrid::Multigrid>(comm, modes);
    operator_ = multigrid::make_operator(multigrid_, system.map());
  }

  RCP<Operator> build(const RCP<const Matrix>& matrix, bool) override {
    multigrid_->setup(*matrix);
    return operator_;
  }

  RCP<Operator> renew(const RCP<const Matrix>& matrix, bool, bool same_graph) override {
    multigrid_->refresh(*matrix, same_graph);
    return operator_;
  }

private:
  std::shared_ptr<multigrid::Multigrid> multigrid_;
  RCP<Operator> operator_;
};

} // namespace

std::unique_ptr<Preconditioning> make_cycle_preconditioning(const NonlinearSystem& system) {
  return std::make_unique<CyclePreconditioning>(system);
}

} // namespace abut::solver
