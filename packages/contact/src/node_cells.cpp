// SPDX-License-Identifier: BSD-3-Clause
#include "node_cells.hpp"

#include <algorithm>
#include <unordered_map>

namespace abut::contact {

namespace {

void sort_unique(std::vector<Global>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Surface nodes that other ranks have too, by their mesh node.
std::unordered_map<Global, Local> shared_nodes(const mesh::Surface& surface,
                                               const CornerSpace& space) {
  std::unordered_map<Global, Local> here;
  for (Local n = 0; n < surface.num_nodes(); ++n)
    if (space.is_shared(n))
      here[surface.node[n]] = n;
  return here;
}

} // namespace

void join_columns(const Comm& comm, const mesh::Surface& surface, const CornerSpace& space,
                  std::vector<std::vector<Global>>& columns) {
  for (std::vector<Global>& list : columns)
    sort_unique(list);
  if (comm.size() == 1)
    return;
  std::vector<std::vector<Global>> send(static_cast<std::size_t>(comm.size()));
  for (Local n = 0; n < surface.num_nodes(); ++n) { // node, count, columns
    std::vector<Global>& list = columns[n];
    if (space.owner(n) == comm.rank() || list.empty())
      continue;
    auto& to = send[static_cast<std::size_t>(space.owner(n))];
    to.push_back(surface.node[n]);
    to.push_back(static_cast<Global>(list.size()));
    to.insert(to.end(), list.begin(), list.end());
    list.clear();
  }
  const auto here = shared_nodes(surface, space);
  for (const auto& part : comm.exchange(send))
    for (auto p = part.begin(); p != part.end();) {
      std::vector<Global>& list = columns[here.at(*p)];
      list.insert(list.end(), p + 2, p + 2 + p[1]);
      sort_unique(list);
      p += 2 + p[1];
    }
}

void NodeCells::build(const Comm& comm, const mesh::Surface& surface, const CornerSpace& space,
                      std::vector<std::vector<Global>> columns, const Rows& rows) {
  join_columns(comm, surface, space, columns);
  cells_.clear();
  cell_of_.assign(columns.size(), -1);
  for (Local n = 0; n < surface.num_nodes(); ++n) {
    if (columns[n].empty())
      continue;
    cell_of_[n] = static_cast<Local>(cells_.size());
    const std::size_t count = columns[n].size();
    cells_.push_back(
        {n, space.is_shared(n), std::move(columns[n]), std::vector<NodeRow>(count, NodeRow())});
  }
  if (comm.size() == 1)
    return;
  struct Parcel {
    Global node, column;
    NodeRow row;
  };
  std::vector<std::vector<Parcel>> send(static_cast<std::size_t>(comm.size()));
  rows([&](Local n) { return space.is_shared(n); },
       [&](Local n, Global column, const NodeRow& row) {
         send[static_cast<std::size_t>(space.owner(n))].push_back({surface.node[n], column, row});
       });
  const auto here = shared_nodes(surface, space);
  for (const auto& part : comm.exchange(send)) // in the order of ranks
    for (const Parcel& p : part)
      add_to(here.at(p.node), p.column, p.row);
}

void NodeCells::fill(const Rows& rows) {
  for (Cell& cell : cells_)
    if (!cell.shared)
      std::fill(cell.rows.begin(), cell.rows.end(), NodeRow());
  rows([&](Local n) { return cell_of_[n] >= 0 && !cells_[cell_of_[n]].shared; },
       [&](Local n, Global column, const NodeRow& row) { add_to(n, column, row); });
}

void NodeCells::add_to(Local node, Global column, const NodeRow& row) {
  Cell& cell = cells_[cell_of_[node]];
  const auto at = std::lower_bound(cell.columns.begin(), cell.columns.end(), column);
  add(cell.rows[static_cast<std::size_t>(at - cell.columns.begin())], row);
}

} // namespace abut::contact
