// SPDX-License-Identifier: BSD-3-Clause
#include "abut/unknowns/dof_map.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <array>

namespace abut::unknowns {

namespace {

/// What the owners of global nodes answer, in the order of the nodes. answer: T of (local node).
template <class T, class Answer>
std::vector<T> ask_owners(const mesh::Mesh& mesh, const std::vector<Global>& nodes,
                          const Answer& answer) {
  const auto ranks = static_cast<std::size_t>(mesh.comm.size());
  const Global first_node = mesh.first_node[static_cast<std::size_t>(mesh.comm.rank())];
  std::vector<std::vector<Global>> ask(ranks);
  for (Global n : nodes)
    ask[static_cast<std::size_t>(mesh.owner(n))].push_back(n);
  std::vector<std::vector<T>> reply(ranks);
  const auto asked = mesh.comm.exchange(ask);
  for (std::size_t r = 0; r < ranks; ++r)
    for (Global n : asked[r])
      reply[r].push_back(answer(static_cast<Local>(n - first_node)));
  reply = mesh.comm.exchange(reply);
  std::vector<std::size_t> next(ranks, 0);
  std::vector<T> result;
  result.reserve(nodes.size());
  for (Global n : nodes) {
    const auto r = static_cast<std::size_t>(mesh.owner(n));
    result.push_back(reply[r][next[r]++]);
  }
  return result;
}

} // namespace

DofMap::DofMap(const mesh::Mesh& mesh, std::vector<std::string> field_names, RigidNodes rigid)
    : mesh_(mesh), field_names_(std::move(field_names)), rigid_(std::move(rigid)) {
  ABUT_REQUIRE(rigid_.body.empty() || static_cast<Local>(rigid_.body.size()) == mesh.num_local(),
               "one rigid body or none for each local node");
  ABUT_REQUIRE(num_bodies() == 0 || (fields() == 3 && mesh.dim == 3),
               "rigid bodies move in space with the three displacements");
  row_of_node_.assign(static_cast<std::size_t>(mesh.num_owned), -1);
  for (Local n = 0; n < mesh.num_owned; ++n) {
    if (body_of_node(n) >= 0)
      continue;
    row_of_node_[n] = num_node_rows();
    node_of_row_.push_back(n);
  }
  // Bodies and links go round the ranks. Only whoever knows all row counts can number them.
  num_rows_ = num_node_rows();
  const auto on_rank = [&](int i) { return static_cast<std::size_t>(i % mesh.comm.size()); };
  const auto mine = [&](int i) { return i % mesh.comm.size() == mesh.comm.rank(); };
  row_of_body_.assign(rigid_.has_unknowns.size(), -1);
  row_of_link_.assign(rigid_.links.size(), -1);
  for (int b = 0; b < num_bodies(); ++b)
    if (rigid_.has_unknowns[b] && mine(b))
      num_rows_ += 2;
  for (int i = 0; i < num_links(); ++i)
    if (link(i).has_unknowns && mine(i))
      num_rows_ += 2;
  const auto counts = mesh.comm.all_gather(Global(num_rows()));
  const auto node_counts = mesh.comm.all_gather(Global(num_node_rows()));
  first_row_.assign(1, 0);
  for (Global c : counts)
    first_row_.push_back(first_row_.back() + c);
  std::vector<Global> next;
  for (std::size_t r = 0; r < node_counts.size(); ++r)
    next.push_back(first_row_[r] + node_counts[r]);
  const auto take = [&](int i) {
    Global& row = next[on_rank(i)];
    row += 2;
    return row - 2;
  };
  for (int b = 0; b < num_bodies(); ++b)
    if (rigid_.has_unknowns[b])
      row_of_body_[b] = take(b);
  for (int i = 0; i < num_links(); ++i)
    if (link(i).has_unknowns)
      row_of_link_[i] = take(i);
  map_ = rcp(new Map(static_cast<Tpetra::global_size_t>(num_global_rows() * fields()),
                     static_cast<std::size_t>(num_rows()) * static_cast<std::size_t>(fields()), 0,
                     teuchos_comm(mesh.comm)));
}

int DofMap::owner_of_row(Global row) const {
  const auto it = std::upper_bound(first_row_.begin(), first_row_.end(), row);
  return static_cast<int>(it - first_row_.begin()) - 1;
}

std::vector<Global> DofMap::resolve(const std::vector<Global>& nodes) const {
  return ask_owners<Global>(mesh_, nodes, [&](Local node) -> Global {
    const int body = body_of_node(node);
    if (body >= 0)
      return -2 - body;
    const Local row = row_of_node_[node];
    return row < 0 ? -1 : first_row() + row;
  });
}

std::vector<double> DofMap::coordinates(const std::vector<Global>& nodes) const {
  using Point = std::array<double, 3>;
  const auto points = ask_owners<Point>(mesh_, nodes, [&](Local node) {
    const double* x = &mesh_.x[3 * static_cast<std::size_t>(node)];
    return Point{x[0], x[1], x[2]};
  });
  std::vector<double> result;
  for (const Point& p : points)
    result.insert(result.end(), p.begin(), p.end());
  return result;
}

std::vector<Global> DofMap::row_keys() const {
  std::vector<Global> keys(static_cast<std::size_t>(num_rows()), -1);
  for (Local r = 0; r < num_node_rows(); ++r)
    keys[std::size_t(r)] = mesh_.node_input[std::size_t(node_of_row(r))];
  Global next = mesh_.num_nodes;
  const auto name_pair = [&](Global row) { // of a body or a link, on its owner
    for (int i = 0; i < 2; ++i, ++next) {
      const Global mine = row + i - first_row();
      if (row >= 0 && mine >= 0 && mine < num_rows())
        keys[std::size_t(mine)] = next;
    }
  };
  for (int b = 0; b < num_bodies(); ++b)
    name_pair(row_of_body(b));
  for (int i = 0; i < num_links(); ++i)
    name_pair(row_of_link(i));
  return keys;
}

} // namespace abut::unknowns
