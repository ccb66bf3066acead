// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "parameter_text.hpp"
#include "preconditioning.hpp"

#include <Ifpack2_Factory.hpp>
#include <MueLu_CreateTpetraPreconditioner.hpp>

namespace abut::solver {

namespace {

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

class MueLuPreconditioning : public Preconditioning {
public:
  MueLuPreconditioning(const LinearOptions& options, const NonlinearSystem& system,
                       const LogSink& log)
      : options_(options), map_(system.map()), per_node_(system.unknowns_per_node()) {
    if (!ids_come_by_node(*map_, per_node_)) {
      abut::log(log, LogLevel::info,
                "The unknowns are not numbered node by node: multigrid treats each on its own.");
      per_node_ = 1;
      return;
    }
    const std::vector<RowPlace> places = system.row_places();
    int mine = !places.empty() || local_size(*map_) == 0 ? 1 : 0, all = 0;
    Teuchos::reduceAll(*map_->getComm(), Teuchos::REDUCE_MIN, mine, Teuchos::outArg(all));
    if (per_node_ <= 4 && all == 1)
      set_modes(places);
  }

  RCP<Operator> build(const RCP<const Matrix>& matrix, bool) override {
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
    RCP<Operator> changeable = Teuchos::rcp_const_cast<Matrix>(matrix);
    return MueLu::CreateTpetraPreconditioner(changeable, list);
  }

private:
  void set_modes(const std::vector<RowPlace>& places) {
    const auto mpi = Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(map_->getComm(), true);
    const auto space = multigrid::rigid_motions(Comm(*mpi->getRawMpiComm()), per_node_, places);
    const auto node_map =
        rcp(new Map(map_->getGlobalNumElements() / static_cast<std::size_t>(per_node_),
                    places.size(), 0, map_->getComm()));
    coordinates_ = rcp(new MultiVector(node_map, 3));
    const auto point = coordinates_->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t n = 0; n < places.size(); ++n)
      for (std::size_t d = 0; d < 3; ++d)
        point(n, d) = places[n].point[d];
    const auto modes = static_cast<std::size_t>(space.modes);
    null_space_ = rcp(new MultiVector(map_, modes));
    const auto mode = null_space_->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < space.values.size(); ++i)
      mode(i / modes, i % modes) = space.values[i];
  }

  LinearOptions options_;
  RCP<const Map> map_;
  int per_node_;
  RCP<MultiVector> coordinates_, null_space_;
};

class IncompleteFactors : public Preconditioning {
public:
  explicit IncompleteFactors(const LinearOptions& options) : options_(options) {}

  RCP<Operator> build(const RCP<const Matrix>& matrix, bool symmetric) override {
    Teuchos::ParameterList list;
    list.set("inner preconditioner name", "RILUK");
    list.set("schwarz: overlap level", 1);
    // A symmetric preconditioner for CG; the restricted one needs fewer iterations with GMRES.
    list.set("schwarz: combine mode", symmetric ? "ADD" : "ZERO");
    list.sublist("inner preconditioner parameters").set("fact: iluk level-of-fill", 0);
    merge_parameter_text(options_.ifpack2, "Ifpack2", list);
    using RowMatrix = Tpetra::RowMatrix<double, Local, Global, Node>;
    auto schwarz = Ifpack2::Factory::create<RowMatrix>("SCHWARZ", matrix);
    schwarz->setParameters(list);
    schwarz->initialize();
    schwarz->compute();
    return schwarz;
  }

private:
  LinearOptions options_;
};

} // namespace

std::unique_ptr<Preconditioning> make_muelu_preconditioning(const LinearOptions& options,
                                                            const NonlinearSystem& system,
                                                            const LogSink& log) {
  return std::make_unique<MueLuPreconditioning>(options, system, log);
}

std::unique_ptr<Preconditioning> make_ilu_preconditioning(const LinearOptions& options) {
  return std::make_unique<IncompleteFactors>(options);
}

} // namespace abut::solver
