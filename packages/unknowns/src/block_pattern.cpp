// SPDX-License-Identifier: BSD-3-Clause
#include "abut/unknowns/block_pattern.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <array>

namespace abut::unknowns {

using Block = std::pair<Global, Global>;

struct BlockPattern::Blocks {
  std::vector<Block> owned, shared;
  std::vector<Global> nodes; ///< distinct mesh nodes of the cells
  std::vector<Global> rows;  ///< their global block rows, as DofMap::resolve gives them
};

namespace {

void sort_unique(std::vector<Block>& blocks) {
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
}

/// The same where all rows lie in [first, first + rows): by row first, each row by itself.
void sort_unique(std::vector<Block>& blocks, Global first, Local rows) {
  std::vector<std::size_t> end(static_cast<std::size_t>(rows) + 1, 0);
  for (const Block& b : blocks)
    ++end[static_cast<std::size_t>(b.first - first) + 1];
  for (std::size_t r = 1; r < end.size(); ++r)
    end[r] += end[r - 1];
  std::vector<Global> column(blocks.size());
  for (const Block& b : blocks)
    column[end[static_cast<std::size_t>(b.first - first)]++] = b.second; // to where the next began
  std::size_t kept = 0;
  auto begin = column.begin();
  for (Local r = 0; r < rows; ++r) {
    const auto stop = column.begin() + static_cast<std::ptrdiff_t>(end[std::size_t(r)]);
    std::sort(begin, stop);
    for (const auto last = std::unique(begin, stop); begin != last; ++begin)
      blocks[kept++] = {first + r, *begin};
    begin = stop;
  }
  blocks.resize(kept);
}

/// Appends the block rows of a node: its own, both of the body it moves with, or none.
void append_rows(const DofMap& dofs, Global resolved, std::vector<Global>& rows) {
  if (resolved >= 0)
    rows.push_back(resolved);
  if (resolved >= -1)
    return;
  const Global row = dofs.row_of_body(static_cast<int>(-2 - resolved));
  if (row >= 0)
    rows.insert(rows.end(), {row, row + 1});
}

/// Neighbours of each owned or shared row, as sorted distinct pairs, from the cells of this rank.
void local_blocks(const DofMap& dofs, const std::vector<const Connectivity*>& all,
                  const std::unordered_map<Global, Global>& row_of, std::vector<Block>& owned,
                  std::vector<Block>& shared) {
  const Global first = dofs.first_row(), end = first + dofs.num_rows();
  std::vector<Global> rows;
  std::size_t limit = std::size_t(1) << 24; // keeps memory near that of the distinct pairs
  for (const Connectivity* cells : all)
    for (Local c = 0; c < cells->cells(); ++c) {
      rows.clear();
      for (Local s = cells->offsets[c]; s < cells->offsets[c + 1]; ++s)
        append_rows(dofs, row_of.at(cells->nodes[s]), rows);
      if (dofs.num_bodies() > 0) { // many nodes may share the rows of one body
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      }
      for (Global r : rows) {
        auto& list = r >= first && r < end ? owned : shared;
        for (Global k : rows)
          list.emplace_back(r, k);
      }
      if (owned.size() > limit) {
        sort_unique(owned, first, dofs.num_rows());
        limit = std::max(limit, 2 * owned.size());
      }
    }
  sort_unique(owned, first, dofs.num_rows());
  sort_unique(shared);
}

/// All pairs of the rows of a link and of its two bodies, in owned rows.
void append_links(const DofMap& dofs, std::vector<Block>& owned) {
  const Global first = dofs.first_row(), end = first + dofs.num_rows();
  for (int i = 0; i < dofs.num_links(); ++i) {
    std::vector<Global> rows;
    const auto add = [&](Global row) {
      if (row >= 0)
        rows.insert(rows.end(), {row, row + 1});
    };
    for (const int body : dofs.link(i).body)
      add(body < 0 ? -1 : dofs.row_of_body(body));
    add(dofs.row_of_link(i));
    for (const Global r : rows)
      for (const Global k : rows)
        if (r >= first && r < end)
          owned.emplace_back(r, k);
  }
}

} // namespace

void BlockPattern::build(const std::vector<const Connectivity*>& cells) {
  const Comm& comm = dofs_.mesh().comm;
  const Global first = dofs_.first_row(), end = first + dofs_.num_rows();
  Blocks b;
  for (const Connectivity* c : cells)
    b.nodes.insert(b.nodes.end(), c->nodes.begin(), c->nodes.end());
  std::sort(b.nodes.begin(), b.nodes.end());
  b.nodes.erase(std::unique(b.nodes.begin(), b.nodes.end()), b.nodes.end());
  b.rows = dofs_.resolve(b.nodes);
  std::unordered_map<Global, Global> row_of(2 * b.nodes.size());
  for (std::size_t i = 0; i < b.nodes.size(); ++i)
    row_of[b.nodes[i]] = b.rows[i];

  local_blocks(dofs_, cells, row_of, b.owned, b.shared);
  std::vector<std::vector<Global>> send(static_cast<std::size_t>(comm.size()));
  for (const Block& p : b.shared) {
    auto& list = send[static_cast<std::size_t>(dofs_.owner_of_row(p.first))];
    list.push_back(p.first);
    list.push_back(p.second);
  }
  for (const auto& list : comm.exchange(send))
    for (std::size_t i = 0; i < list.size(); i += 2)
      b.owned.emplace_back(list[i], list[i + 1]);
  for (Global r = first; r < end; ++r)
    b.owned.emplace_back(r, r);
  for (int body = 0; body < dofs_.num_bodies(); ++body) {
    const Global r = dofs_.row_of_body(body);
    if (r < first || r >= end)
      continue;
    b.owned.emplace_back(r, r + 1);
    b.owned.emplace_back(r + 1, r);
  }
  append_links(dofs_, b.owned);
  sort_unique(b.owned, first, dofs_.num_rows());

  number_columns(b);
  number_rigid_nodes(b);
  plan_exchange();
  build_graph();
  ++version_;
}

void BlockPattern::number_columns(const Blocks& b) {
  const Global first = dofs_.first_row(), end = first + dofs_.num_rows();
  const Local owned_rows = dofs_.num_rows();
  std::vector<Global> ghosts;
  const auto note = [&](Global r) {
    if (r >= 0 && (r < first || r >= end))
      ghosts.push_back(r);
  };
  for (const Block& p : b.owned)
    note(p.second);
  std::vector<Global> rows;
  for (Global r : b.rows)
    append_rows(dofs_, r, rows);
  for (Global r : rows)
    note(r);
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());

  column_row_.resize(static_cast<std::size_t>(owned_rows));
  for (Local r = 0; r < owned_rows; ++r)
    column_row_[r] = first + r;
  column_row_.insert(column_row_.end(), ghosts.begin(), ghosts.end());
  const auto column = [&](Global r) -> Local {
    if (r < 0)
      return -1;
    if (r >= first && r < end)
      return static_cast<Local>(r - first);
    return owned_rows +
           static_cast<Local>(std::lower_bound(ghosts.begin(), ghosts.end(), r) - ghosts.begin());
  };
  column_of_node_.clear();
  for (std::size_t i = 0; i < b.nodes.size(); ++i)
    column_of_node_[b.nodes[i]] = column(b.rows[i]);
  body_column_.assign(2 * static_cast<std::size_t>(dofs_.num_bodies()), -1);
  for (int body = 0; body < dofs_.num_bodies(); ++body) {
    const Global r = dofs_.row_of_body(body);
    const bool here = r >= first && r < end;
    if (r >= 0 && (here || std::binary_search(ghosts.begin(), ghosts.end(), r)))
      for (std::size_t i = 0; i < 2; ++i)
        body_column_[2 * std::size_t(body) + i] = column(r + static_cast<Global>(i));
  }

  row_offset_.assign(1, 0);
  columns_.clear();
  shared_row_.clear();
  row_of_shared_.clear();
  const auto append = [&](const std::vector<Block>& blocks, bool shared) {
    for (std::size_t i = 0; i < blocks.size();) {
      const Global r = blocks[i].first;
      if (shared) {
        row_of_shared_[r] = static_cast<Local>(row_offset_.size()) - 1;
        shared_row_.push_back(r);
      }
      const std::size_t begin = columns_.size();
      for (; i < blocks.size() && blocks[i].first == r; ++i)
        columns_.push_back(column(blocks[i].second));
      std::sort(columns_.begin() + static_cast<std::ptrdiff_t>(begin), columns_.end());
      row_offset_.push_back(static_cast<std::int64_t>(columns_.size()));
    }
  };
  append(b.owned, false);
  append(b.shared, true);
  row_length_.resize(static_cast<std::size_t>(num_rows()));
  for (Local r = 0; r < num_rows(); ++r)
    row_length_[r] = static_cast<Local>(row_offset_[r + 1] - row_offset_[r]) * dofs_.fields();
}

/// Local block row of a global one, owned or shared; -1 when no cell of this rank touches it.
Local BlockPattern::local_row(Global row) const {
  const Global first = dofs_.first_row();
  if (row >= first && row < first + dofs_.num_rows())
    return static_cast<Local>(row - first);
  const auto shared = row_of_shared_.find(row);
  return shared == row_of_shared_.end() ? -1 : shared->second;
}

void BlockPattern::number_rigid_nodes(const Blocks& b) {
  std::vector<Global> nodes;
  rigid_nodes_.body.clear();
  for (std::size_t i = 0; i < b.nodes.size(); ++i)
    if (b.rows[i] < -1) {
      column_of_node_[b.nodes[i]] = -2 - static_cast<Local>(nodes.size());
      nodes.push_back(b.nodes[i]);
      rigid_nodes_.body.push_back(static_cast<Local>(-2 - b.rows[i]));
    }
  if (dofs_.num_bodies() > 0)
    rigid_nodes_.x = dofs_.coordinates(nodes);
  body_row_.assign(2 * static_cast<std::size_t>(dofs_.num_bodies()), -1);
  for (int body = 0; body < dofs_.num_bodies(); ++body)
    if (dofs_.row_of_body(body) >= 0)
      for (std::size_t i = 0; i < 2; ++i)
        body_row_[2 * std::size_t(body) + i] =
            local_row(dofs_.row_of_body(body) + static_cast<Global>(i));
}

std::int64_t BlockPattern::body_block(int body, int i, int j) const {
  const std::size_t first = 2 * static_cast<std::size_t>(body);
  return position(body_row_[first + std::size_t(i)], body_column_[first + std::size_t(j)]);
}

void BlockPattern::add(Global row, Global column, double factor, const Mat3& m,
                       double* values) const {
  const Local owned_rows = dofs_.num_rows();
  const Global first = dofs_.first_row();
  const auto r = static_cast<Local>(row - first);
  auto c = static_cast<Local>(column - first);
  if (column < first || column >= first + owned_rows)
    c = static_cast<Local>(
        std::lower_bound(column_row_.begin() + owned_rows, column_row_.end(), column) -
        column_row_.begin());
  const std::int64_t p = position(r, c);
  ABUT_REQUIRE(p >= 0, "the pattern lacks a block of a rigid body");
  double* out = values + p;
  for (int i = 0; i < 3; ++i, out += row_length_[r])
    for (int j = 0; j < 3; ++j)
      out[j] += factor * m[i][j];
}

std::vector<double> BlockPattern::diagonal(const double* values) const {
  std::vector<double> result;
  for (Local r = 0; r < dofs_.num_rows(); ++r)
    for (int f = 0; f < dofs_.fields(); ++f)
      result.push_back(values[position(r, r) + static_cast<std::int64_t>(f) * row_length_[r] + f]);
  return result;
}

std::int64_t BlockPattern::num_values() const {
  return static_cast<std::int64_t>(columns_.size()) * dofs_.fields() * dofs_.fields();
}

std::int64_t BlockPattern::num_owned_values() const {
  return row_offset_[static_cast<std::size_t>(dofs_.num_rows())] * dofs_.fields() * dofs_.fields();
}

/// First scalar value of block (row, column), or -1 when the pattern does not hold it.
std::int64_t BlockPattern::position(Local row, Local column) const {
  const auto begin = columns_.begin() + row_offset_[row],
             end = columns_.begin() + row_offset_[row + 1];
  const auto it = std::lower_bound(begin, end, column);
  if (it == end || *it != column)
    return -1;
  const int f = dofs_.fields();
  return row_offset_[row] * f * f + (it - begin) * f;
}

bool BlockPattern::locate(const Connectivity& cells, CellPositions& out) const {
  const Local owned_rows = dofs_.num_rows();
  out.row.resize(cells.nodes.size());
  out.block_offset.assign(1, 0);
  out.block_position.clear();
  out.rigid_block.clear();
  std::vector<Local> column;
  for (Local c = 0; c < cells.cells(); ++c) {
    const Local first = cells.offsets[c], n = cells.size(c);
    column.resize(static_cast<std::size_t>(n));
    for (Local a = 0; a < n; ++a) {
      const auto it = column_of_node_.find(cells.nodes[first + a]);
      if (it == column_of_node_.end())
        return false;
      column[a] = it->second;
      Local row = column[a];
      if (row >= owned_rows) {
        const auto shared = row_of_shared_.find(column_row_[row]);
        if (shared == row_of_shared_.end())
          return false;
        row = shared->second;
      }
      out.row[first + a] = row;
    }
    for (Local a = 0; a < n; ++a)
      for (Local b = 0; b < n; ++b)
        if (!locate_block(out.row[first + a], column[b], out))
          return false;
    out.block_offset.push_back(static_cast<std::int64_t>(out.block_position.size()));
  }
  return true;
}

/// Appends the position of one block of a cell; false when it lies outside the pattern.
bool BlockPattern::locate_block(Local row, Local column, CellPositions& out) const {
  std::int64_t p = -1;
  if (row >= 0 && column >= 0) {
    p = position(row, column);
    if (p < 0)
      return false;
  } else if (row != -1 && column != -1) {
    const auto both = [&](Local local, const std::vector<Local>& of_body) {
      if (local >= 0)
        return std::array<Local, 2>{local, -1};
      const auto body = static_cast<std::size_t>(rigid_nodes_.body[-2 - local]);
      return std::array<Local, 2>{of_body[2 * body], of_body[2 * body + 1]};
    };
    p = -2 - static_cast<std::int64_t>(out.rigid_block.size() / 4);
    for (Local r : both(row, body_row_))
      for (Local c : both(column, body_column_)) {
        out.rigid_block.push_back(r < 0 || c < 0 ? -1 : position(r, c));
        if (r >= 0 && c >= 0 && out.rigid_block.back() < 0)
          return false;
      }
  }
  out.block_position.push_back(p);
  return true;
}

void BlockPattern::plan_exchange() {
  const Comm& comm = dofs_.mesh().comm;
  const auto ranks = static_cast<std::size_t>(comm.size());
  const Local owned_rows = dofs_.num_rows();
  std::vector<std::vector<Global>> send(ranks); // row, count, columns...
  send_first_.assign(ranks + 1, 0);
  for (std::size_t i = 0; i < shared_row_.size(); ++i) {
    const auto owner = static_cast<std::size_t>(dofs_.owner_of_row(shared_row_[i]));
    const std::size_t row = static_cast<std::size_t>(owned_rows) + i;
    send[owner].push_back(shared_row_[i]);
    send[owner].push_back(row_offset_[row + 1] - row_offset_[row]);
    for (std::int64_t k = row_offset_[row]; k < row_offset_[row + 1]; ++k)
      send[owner].push_back(column_row_[columns_[k]]);
    ++send_first_[owner + 1];
  }
  for (std::size_t r = 0; r < ranks; ++r)
    send_first_[r + 1] += send_first_[r];
  const auto arrived = comm.exchange(send);

  const Global first = dofs_.first_row(), end = first + owned_rows;
  const auto ghosts = column_row_.begin() + owned_rows;
  received_.assign(ranks, {});
  for (std::size_t r = 0; r < ranks; ++r)
    for (std::size_t i = 0; i < arrived[r].size();) {
      const Local row = static_cast<Local>(arrived[r][i++] - first);
      const auto count = static_cast<Local>(arrived[r][i++]);
      received_[r].row.push_back(row);
      received_[r].count.push_back(count);
      for (Local k = 0; k < count; ++k) {
        const Global g = arrived[r][i++];
        const Local column =
            g >= first && g < end
                ? static_cast<Local>(g - first)
                : owned_rows +
                      static_cast<Local>(std::lower_bound(ghosts, column_row_.end(), g) - ghosts);
        received_[r].position.push_back(position(row, column));
        ABUT_REQUIRE(received_[r].position.back() >= 0, "a shared block is missing at its owner");
      }
    }
}

void BlockPattern::add_shared_values(double* values) const {
  const Comm& comm = dofs_.mesh().comm;
  if (comm.size() == 1)
    return;
  const int f = dofs_.fields();
  const Local owned_rows = dofs_.num_rows();
  std::vector<std::vector<double>> send(received_.size());
  for (std::size_t r = 0; r < send.size(); ++r) {
    const double* begin = values + row_offset_[owned_rows + send_first_[r]] * f * f;
    const double* end = values + row_offset_[owned_rows + send_first_[r + 1]] * f * f;
    send[r].assign(begin, end);
  }
  const auto arrived = comm.exchange(send);
  for (std::size_t r = 0; r < arrived.size(); ++r) {
    const double* in = arrived[r].data();
    const std::int64_t* position = received_[r].position.data();
    for (std::size_t i = 0; i < received_[r].row.size(); ++i) {
      const Local length = row_length_[received_[r].row[i]], count = received_[r].count[i];
      for (int d = 0; d < f; ++d)
        for (Local k = 0; k < count; ++k)
          for (int g = 0; g < f; ++g)
            values[position[k] + std::int64_t(d) * length + g] += *in++;
      position += count;
    }
  }
}

void BlockPattern::add_shared_residual(double* residual) const {
  const Comm& comm = dofs_.mesh().comm;
  if (comm.size() == 1)
    return;
  const int f = dofs_.fields();
  const double* shared = residual + std::int64_t(dofs_.num_rows()) * f;
  std::vector<std::vector<double>> send(received_.size());
  for (std::size_t r = 0; r < send.size(); ++r)
    send[r].assign(shared + std::int64_t(send_first_[r]) * f,
                   shared + std::int64_t(send_first_[r + 1]) * f);
  const auto arrived = comm.exchange(send);
  for (std::size_t r = 0; r < arrived.size(); ++r)
    for (std::size_t i = 0; i < received_[r].row.size(); ++i)
      for (int d = 0; d < f; ++d)
        residual[std::int64_t(received_[r].row[i]) * f + d] += arrived[r][i * std::size_t(f) + d];
}

void BlockPattern::build_graph() {
  const int f = dofs_.fields();
  const Local owned_rows = dofs_.num_rows();
  using LocalGraph = Graph::local_graph_device_type;
  LocalGraph::row_map_type::non_const_type offsets("abut::assembly::offsets",
                                                   static_cast<std::size_t>(owned_rows) * f + 1);
  LocalGraph::entries_type::non_const_type entries("abut::assembly::entries",
                                                   static_cast<std::size_t>(num_owned_values()));
  const auto host_offsets = Kokkos::create_mirror_view(offsets);
  const auto host_entries = Kokkos::create_mirror_view(entries);
  std::size_t p = 0;
  host_offsets(0) = 0;
  for (Local r = 0; r < owned_rows; ++r)
    for (int d = 0; d < f; ++d) {
      for (std::int64_t k = row_offset_[r]; k < row_offset_[r + 1]; ++k)
        for (int g = 0; g < f; ++g)
          host_entries(p++) = columns_[k] * f + g;
      host_offsets(std::size_t(r) * f + d + 1) = p;
    }
  Kokkos::deep_copy(offsets, host_offsets);
  Kokkos::deep_copy(entries, host_entries);

  std::vector<Global> column_ids;
  column_ids.reserve(column_row_.size() * static_cast<std::size_t>(f));
  for (Global r : column_row_)
    for (int g = 0; g < f; ++g)
      column_ids.push_back(r * f + g);
  const auto map = dofs_.map();
  const RCP<const Map> columns =
      rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                  Teuchos::ArrayView<const Global>(column_ids), 0, map->getComm()));
  const auto graph = rcp(new Graph(map, columns, offsets, entries));
  graph->expertStaticFillComplete(map, map);
  graph_ = graph;
}

} // namespace abut::unknowns
