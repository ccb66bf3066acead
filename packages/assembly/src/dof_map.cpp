// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/dof_map.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>

namespace abut::assembly {

DofMap::DofMap(const mesh::Mesh& mesh, std::vector<std::string> field_names,
               const std::vector<char>& without_unknowns)
    : mesh_(mesh), field_names_(std::move(field_names)) {
  ABUT_REQUIRE(static_cast<Local>(without_unknowns.size()) == mesh.num_local(),
               "one flag for each local node");
  row_of_node_.assign(static_cast<std::size_t>(mesh.num_owned), -1);
  for (Local n = 0; n < mesh.num_owned; ++n) {
    if (without_unknowns[n])
      continue;
    row_of_node_[n] = num_rows();
    node_of_row_.push_back(n);
  }
  const auto counts = mesh.comm.all_gather(Global(num_rows()));
  first_row_.assign(1, 0);
  for (Global c : counts)
    first_row_.push_back(first_row_.back() + c);
  map_ = rcp(new Map(static_cast<Tpetra::global_size_t>(num_global_rows() * fields()),
                     static_cast<std::size_t>(num_rows()) * static_cast<std::size_t>(fields()), 0,
                     teuchos_comm(mesh.comm)));
}

int DofMap::owner_of_row(Global row) const {
  const auto it = std::upper_bound(first_row_.begin(), first_row_.end(), row);
  return static_cast<int>(it - first_row_.begin()) - 1;
}

std::vector<Global> DofMap::resolve(const std::vector<Global>& nodes) const {
  const auto ranks = static_cast<std::size_t>(mesh_.comm.size());
  const Global first_node = mesh_.first_node[static_cast<std::size_t>(mesh_.comm.rank())];
  const auto row_of = [&](Global node) -> Global {
    const Local row = row_of_node_[static_cast<std::size_t>(node - first_node)];
    return row < 0 ? -1 : first_row() + row;
  };
  std::vector<std::vector<Global>> ask(ranks);
  for (Global n : nodes)
    ask[static_cast<std::size_t>(mesh_.owner(n))].push_back(n);
  auto answer = mesh_.comm.exchange(ask);
  for (auto& list : answer)
    for (Global& n : list)
      n = row_of(n);
  answer = mesh_.comm.exchange(answer);
  std::vector<std::size_t> next(ranks, 0);
  std::vector<Global> rows;
  rows.reserve(nodes.size());
  for (Global n : nodes) {
    const auto r = static_cast<std::size_t>(mesh_.owner(n));
    rows.push_back(answer[r][next[r]++]);
  }
  return rows;
}

} // namespace abut::assembly
