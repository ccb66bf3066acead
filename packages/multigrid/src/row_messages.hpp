// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/multigrid/block_matrix.hpp"
#include "distribution.hpp"

#include <algorithm>

namespace abut::multigrid {

/// Block rows on their way to other ranks, with columns by global number.
template <class T, int R, int C> class RowMessages {
public:
  using Matrix = BlockMatrix<T, R, C>;

  explicit RowMessages(const Comm& comm)
      : comm_(comm), head_(std::size_t(comm.size())), value_(std::size_t(comm.size())) {}

  void add(int rank, Global number, const Matrix& a, Local row, const Distribution& columns) {
    auto& head = head_[std::size_t(rank)];
    head.push_back(number);
    head.push_back(a.offset(row + 1) - a.offset(row));
    for (Local k = a.offset(row); k < a.offset(row + 1); ++k)
      head.push_back(columns.global(a.column(k)));
    auto& value = value_[std::size_t(rank)];
    value.insert(value.end(), a.block(a.offset(row)), a.block(a.offset(row + 1)));
  }

  /// Sends all rows, and calls take(number, column, block) for each block that arrives, in the
  /// order of the ranks. Collective.
  template <class Take> void deliver(const Take& take) {
    head_ = comm_.exchange(head_);
    value_ = comm_.exchange(value_);
    for (std::size_t r = 0; r < head_.size(); ++r) {
      const T* block = value_[r].data();
      for (auto p = head_[r].begin(); p != head_[r].end();) {
        const Global number = *p++, count = *p++;
        for (Global k = 0; k < count; ++k, block += Matrix::block_size)
          take(number, *p++, block);
      }
    }
  }

private:
  const Comm& comm_;
  std::vector<std::vector<Global>> head_; ///< per rank: number, count, columns of each row
  std::vector<std::vector<T>> value_;
};

/// Rows of a matrix as a list of entries, for those that come together from several ranks.
template <class T, int R, int C> class RowLists {
public:
  explicit RowLists(Local rows) : rows_(rows) {}

  void add(Local row, Local column, const T* block) { entry_.push_back({row, column, block}); }
  /// Entries of one place are added. Rows in the order of their columns.
  BlockMatrix<T, R, C> matrix() {
    std::stable_sort(entry_.begin(), entry_.end(), [](const Entry& a, const Entry& b) {
      return a.row < b.row || (a.row == b.row && a.column < b.column);
    });
    std::vector<Local> offset(static_cast<std::size_t>(rows_) + 1, 0), column;
    const auto is_new = [&](std::size_t n) {
      return n == 0 || entry_[n].row != entry_[n - 1].row ||
             entry_[n].column != entry_[n - 1].column;
    };
    for (std::size_t n = 0; n < entry_.size(); ++n)
      if (is_new(n)) {
        ++offset[std::size_t(entry_[n].row) + 1];
        column.push_back(entry_[n].column);
      }
    for (std::size_t i = 1; i < offset.size(); ++i)
      offset[i] += offset[i - 1];
    auto a = make_block_matrix<T, R, C>(offset, column);
    Local k = -1;
    for (std::size_t n = 0; n < entry_.size(); ++n) {
      if (is_new(n))
        ++k;
      for (int v = 0; v < a.block_size; ++v)
        a.block(k)[v] += entry_[n].block[v];
    }
    return a;
  }

private:
  struct Entry {
    Local row, column;
    const T* block;
  };
  Local rows_;
  std::vector<Entry> entry_;
};

template <class T, int R, int C> struct DistributedRows {
  BlockMatrix<T, R, C> matrix;
  Distribution columns;
};

/// The owned rows of a matrix and behind them, from their owners, the ghosts of `rows`. The columns
/// of the owned rows keep their numbers. Collective.
template <class T, int R, int C>
DistributedRows<T, R, C> with_ghost_rows(const BlockMatrix<T, R, C>& owned,
                                         const Distribution& rows, const Distribution& columns) {
  if (rows.comm().size() == 1)
    return {owned, columns};
  RowMessages<T, R, C> messages(rows.comm());
  for (const auto& other : rows.exchange().messages().neighbours())
    for (const Local row : other.send)
      messages.add(other.rank, rows.global(row), owned, row, columns);
  GhostList numbers(columns, true);
  RowLists<T, R, C> lists(rows.size());
  for (Local i = 0; i < owned.rows; ++i)
    for (Local k = owned.offset(i); k < owned.offset(i + 1); ++k)
      lists.add(i, owned.column(k), owned.block(k));
  messages.deliver([&](Global row, Global column, const T* block) {
    lists.add(rows.local(row), numbers.local(column), block);
  });
  return {lists.matrix(), Distribution(rows.comm(), columns.first(), numbers.ghosts())};
}

/// Adds the ghost rows of a matrix to those of their owners. The ghosts of `rows` are the first
/// ones of the columns that result. columns: of `parts`. Collective.
template <class T, int R, int C>
DistributedRows<T, R, C> sum_to_owners(const BlockMatrix<T, R, C>& parts, const Distribution& rows,
                                       const Distribution& columns) {
  if (rows.comm().size() == 1)
    return {parts, rows};
  RowMessages<T, R, C> messages(rows.comm());
  for (Local i = rows.owned(); i < parts.rows; ++i)
    messages.add(rows.owner(rows.global(i)), rows.global(i), parts, i, columns);
  GhostList numbers(rows, true);
  RowLists<T, R, C> lists(rows.owned());
  for (Local i = 0; i < rows.owned(); ++i)
    for (Local k = parts.offset(i); k < parts.offset(i + 1); ++k)
      lists.add(i, numbers.local(columns.global(parts.column(k))), parts.block(k));
  messages.deliver([&](Global row, Global column, const T* block) {
    lists.add(rows.local(row), numbers.local(column), block);
  });
  return {lists.matrix(), Distribution(rows.comm(), rows.first(), numbers.ghosts())};
}

} // namespace abut::multigrid
