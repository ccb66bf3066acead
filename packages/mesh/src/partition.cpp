// SPDX-License-Identifier: BSD-3-Clause
#include "partition.hpp"

#include "abut/core/error.hpp"
#include "abut/core/types.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Zoltan2_BasicVectorAdapter.hpp>
#include <Zoltan2_PartitioningProblem.hpp>

namespace abut::mesh {

std::vector<int> bisect(const std::vector<double>& points, int dim, const Comm& comm) {
  if (comm.size() == 1)
    return std::vector<int>(points.size() / dim, 0);

  // An equal slice of the points for each rank.
  Global count = static_cast<Global>(points.size()) / dim;
  comm.broadcast(&count, sizeof count);
  const auto begin = [&](int rank) { return count * rank / comm.size(); };
  std::vector<std::vector<double>> send(static_cast<std::size_t>(comm.size()));
  if (comm.is_root())
    for (int r = 0; r < comm.size(); ++r)
      send[r].assign(points.begin() + dim * begin(r), points.begin() + dim * begin(r + 1));
  const std::vector<double> mine = comm.exchange(send)[0];
  const int size = static_cast<int>(mine.size()) / dim;

  std::vector<Global> ids;
  for (int i = 0; i < size; ++i)
    ids.push_back(begin(comm.rank()) + i);
  using Adapter = Zoltan2::BasicVectorAdapter<Zoltan2::BasicUserTypes<double, Local, Global>>;
  std::vector<const double*> coordinates;
  for (int d = 0; d < dim; ++d)
    coordinates.push_back(mine.data() + d);
  std::vector<int> strides(static_cast<std::size_t>(dim), dim);
  std::vector<const double*> weights;
  std::vector<int> weight_strides;
  const Adapter adapter(size, ids.data(), coordinates, strides, weights, weight_strides);

  Teuchos::ParameterList options;
  options.set("algorithm", "rcb");
  options.set("num_global_parts", comm.size());
  options.set("imbalance_tolerance", 1.02);
  options.set("error_check_level", "no_assertions");
  options.sublist("zoltan_parameters").set("DEBUG_LEVEL", "0"); // prints nothing
  const Teuchos::RCP<const Teuchos::Comm<int>> teuchos =
      Teuchos::rcp(new Teuchos::MpiComm<int>(comm.mpi()));
  Zoltan2::PartitioningProblem<Adapter> problem(const_cast<Adapter*>(&adapter), &options, teuchos);
  problem.solve();
  const int* parts = problem.getSolution().getPartListView();
  return comm.gather(std::vector<int>(parts, parts + size));
}

} // namespace abut::mesh
