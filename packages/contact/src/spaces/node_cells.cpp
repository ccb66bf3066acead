// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/node_cells.hpp"

#include <algorithm>
#include <unordered_map>

namespace abut::contact {

namespace {

using Columns = std::vector<std::vector<Global>>; ///< (surface nodes)

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

/// The columns that this rank's pairs join to active nodes.
Columns own_columns(const NodalArrays& nodes, const PairArrays& pairs, const Connectivity& cells) {
  Columns columns(std::size_t(nodes.nodes()));
  for (Local i = 0; i < pairs.size(); ++i)
    for (int a = 0; a < nodes.corners(pairs.face(i)); ++a) {
      const Local n = nodes.node(pairs.face(i), a);
      if (nodes.site(n).active())
        columns[n].insert(columns[n].end(), cells.nodes.begin() + cells.offsets[i],
                          cells.nodes.begin() + cells.offsets[i + 1]);
    }
  for (auto& list : columns)
    sort_unique(list);
  return columns;
}

NodeRowArrays make_rows(const Columns& columns, const std::vector<char>& from_ranks) {
  std::vector<Local> node, first{0};
  std::vector<Global> column;
  std::vector<char> complete;
  for (std::size_t n = 0; n < columns.size(); ++n) {
    if (columns[n].empty())
      continue;
    node.push_back(static_cast<Local>(n));
    complete.push_back(from_ranks[n]);
    column.insert(column.end(), columns[n].begin(), columns[n].end());
    first.push_back(static_cast<Local>(column.size()));
  }
  NodeRowArrays rows;
  rows.node = make_view("abut::contact::row_node", node);
  rows.first = make_view("abut::contact::row_first", first);
  rows.column = make_view("abut::contact::row_column", column);
  rows.row = make_view<NodeRow>("abut::contact::row", column.size());
  rows.from_ranks = make_view("abut::contact::row_from_ranks", complete);
  return rows;
}

/// Row of a column in the cell, which has it.
Local row_of(const NodeRowArrays& rows, Local cell, Global column) {
  const Global *begin = rows.column.data() + rows.first(cell),
               *end = rows.column.data() + rows.first(cell + 1);
  return static_cast<Local>(std::lower_bound(begin, end, column) - rows.column.data());
}

/// Where the pairs' columns stand in the cells that are not complete.
void locate(const NodalArrays& nodes, const PairArrays& pairs, const Connectivity& cells,
            NodeRowArrays& rows) {
  const Local columns = pairs.size() > 0 ? pairs.first_column(pairs.size()) : 0;
  rows.position =
      make_view<Local>("abut::contact::row_position", std::size_t(columns) * max_corners, -1);
  std::vector<Local> cell_of(std::size_t(nodes.nodes()), -1);
  for (Local c = 0; c < rows.size(); ++c)
    if (!rows.from_ranks(c))
      cell_of[rows.node(c)] = c;
  for (Local i = 0; i < pairs.size(); ++i)
    for (int a = 0; a < nodes.corners(pairs.face(i)); ++a) {
      const Local cell = cell_of[nodes.node(pairs.face(i), a)];
      for (Local q = pairs.first_column(i); cell >= 0 && q < pairs.first_column(i + 1); ++q)
        rows.position(q * max_corners + a) = row_of(rows, cell, cells.nodes[q]);
    }
}

struct Parcel {
  Global node, column;
  NodeRow row;
};

/// The rows of shared nodes on the way to their owners, this rank among them.
std::vector<std::vector<Parcel>> pack(const Comm& comm, const mesh::Surface& surface,
                                      const CornerSpace& space, const NodeRowArrays& rows) {
  std::vector<std::vector<Parcel>> send(static_cast<std::size_t>(comm.size()));
  for (Local c = 0; c < rows.size(); ++c)
    for (Local k = rows.first(c); k < rows.first(c + 1); ++k)
      send[static_cast<std::size_t>(space.owner(rows.node(c)))].push_back(
          {surface.node[rows.node(c)], rows.column(k), rows.row(k)});
  return send;
}

} // namespace

void join_columns(const Comm& comm, const mesh::Surface& surface, const CornerSpace& space,
                  Columns& columns) {
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
                      const NodalArrays& nodes, const PairArrays& pairs, const AddRows& add,
                      Connectivity& cells) {
  Columns columns = own_columns(nodes, pairs, cells);
  std::vector<char> from_ranks(columns.size(), 0);
  std::vector<std::vector<Parcel>> arrived;
  const auto here = shared_nodes(surface, space);
  if (comm.size() > 1) {
    Columns shared(columns.size());
    for (Local n = 0; n < surface.num_nodes(); ++n)
      if (space.is_shared(n))
        shared[n].swap(columns[n]);
    NodeRowArrays rows = make_rows(shared, from_ranks);
    locate(nodes, pairs, cells, rows);
    add(rows);
    arrived = comm.exchange(pack(comm, surface, space, rows));
    for (const auto& part : arrived)
      for (const Parcel& p : part)
        columns[here.at(p.node)].push_back(p.column);
    for (const auto& [id, n] : here) {
      sort_unique(columns[n]);
      from_ranks[n] = 1;
    }
  }
  rows_ = make_rows(columns, from_ranks);
  locate(nodes, pairs, cells, rows_);
  std::unordered_map<Local, Local> cell_of;
  for (Local c = 0; c < rows_.size(); ++c) {
    cell_of[rows_.node(c)] = c;
    cells.add(rows_.column.data() + rows_.first(c), rows_.first(c + 1) - rows_.first(c));
  }
  for (const auto& part : arrived) // in the order of ranks
    for (const Parcel& p : part)
      contact::add(rows_.row(row_of(rows_, cell_of.at(here.at(p.node)), p.column)), p.row);
}

void NodeCells::refill(const AddRows& add) {
  for (Local c = 0; c < rows_.size(); ++c)
    if (!rows_.from_ranks(c))
      std::fill(&rows_.row(rows_.first(c)), &rows_.row(rows_.first(c)) +
                                                (rows_.first(c + 1) - rows_.first(c)),
                NodeRow());
  add(rows_);
}

} // namespace abut::contact
