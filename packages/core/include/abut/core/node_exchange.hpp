// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace abut {

/// What this rank sends to and receives from fixed other ranks, as lists of rows that are made
/// once. Messages go from rank to rank, without waiting for each other.
class NeighbourMessages {
public:
  struct Neighbour {
    int rank = 0;
    std::vector<Local> send, receive; ///< rows of values; what one rank sends the other receives
  };

  NeighbourMessages(const Comm& comm, std::vector<Neighbour> neighbours)
      : comm_(comm.mpi()), neighbours_(std::move(neighbours)) {}

  const std::vector<Neighbour>& neighbours() const { return neighbours_; }

  /// Sends rows of values (rows, width) forward, or backward: what is received otherwise then goes
  /// back to where it came from. Returns for each neighbour its rows, (its list, width).
  /// Collective.
  template <class T>
  std::vector<std::vector<T>> exchange(const T* values, int width, bool backward = false) const {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto w = static_cast<std::size_t>(width);
    std::vector<std::vector<T>> out(neighbours_.size()), in(neighbours_.size());
    std::vector<const void*> from;
    std::vector<void*> to;
    for (std::size_t k = 0; k < neighbours_.size(); ++k) {
      const Neighbour& other = neighbours_[k];
      for (const Local row : backward ? other.receive : other.send)
        out[k].insert(out[k].end(), values + static_cast<std::size_t>(row) * w,
                      values + (static_cast<std::size_t>(row) + 1) * w);
      in[k].resize((backward ? other.send : other.receive).size() * w);
      from.push_back(out[k].data());
      to.push_back(in[k].data());
    }
    exchange_bytes(from, to, w * sizeof(T), backward);
    return in;
  }

private:
  void exchange_bytes(const std::vector<const void*>& from, const std::vector<void*>& to,
                      std::size_t row_bytes, bool backward) const;

  MPI_Comm comm_;
  std::vector<Neighbour> neighbours_; ///< by ascending rank
};

/// Values at nodes that one rank owns and others hold copies of, the ghosts. Rows of values are
/// those of the nodes given: the owned ones first, in the order of their numbers.
class NodeExchange {
public:
  /// first_node: (ranks+1) first global number that each rank owns; ghosts: of this rank's rows
  /// behind the owned ones, in any order, perhaps repeated or owned here too. Collective.
  NodeExchange(const Comm& comm, const std::vector<Global>& first_node,
               const std::vector<Global>& ghosts);

  /// To whom owned rows go and from whom ghosts come.
  const NeighbourMessages& messages() const { return messages_; }

  /// Fills the ghost rows of values (rows, width) with those of their owners. Collective.
  template <class T> void to_ghosts(T* values, int width = 1) const {
    const auto in = messages_.exchange(values, width);
    for (std::size_t k = 0; k < in.size(); ++k)
      combine(messages_.neighbours()[k].receive, in[k], values, width,
              [](T& mine, const T& theirs) { mine = theirs; });
  }
  /// Adds the ghost rows to those of their owners, in the order of the ranks. Collective, as are
  /// the next two.
  template <class T> void add_to_owners(T* values, int width = 1) const {
    to_owners(values, width, [](T& mine, const T& theirs) { mine += theirs; });
  }
  /// The least of the owner's value and those of all ghosts.
  template <class T> void min_to_owners(T* values, int width = 1) const {
    to_owners(values, width, [](T& mine, const T& theirs) { mine = std::min(mine, theirs); });
  }
  template <class T> void max_to_owners(T* values, int width = 1) const {
    to_owners(values, width, [](T& mine, const T& theirs) { mine = std::max(mine, theirs); });
  }

private:
  template <class T, class Combine>
  void to_owners(T* values, int width, const Combine& combine_one) const {
    const auto in = messages_.exchange(values, width, true);
    for (std::size_t k = 0; k < in.size(); ++k)
      combine(messages_.neighbours()[k].send, in[k], values, width, combine_one);
  }
  template <class T, class Combine>
  static void combine(const std::vector<Local>& rows, const std::vector<T>& in, T* values,
                      int width, const Combine& combine_one) {
    auto theirs = in.begin();
    for (const Local row : rows)
      for (int i = 0; i < width; ++i)
        combine_one(values[static_cast<std::ptrdiff_t>(row) * width + i], *theirs++);
  }

  NeighbourMessages messages_;
};

/// Values at nodes that several ranks have without one that owns them: those of a surface.
class SharedNodes {
public:
  /// nodes: any numbers >= 0 that name a node alike on all ranks; each once. Collective.
  SharedNodes(const Comm& comm, const std::vector<Global>& nodes);

  bool is_shared(Local row) const { return holder_count_[row] > 1; }
  int owner(Local row) const { return owner_[row]; } ///< the lowest rank that has the node

  /// Sets every row of values (nodes, width) to the sum over all ranks that have the node. They add
  /// in the order of the ranks: each gets the same digits. Collective.
  template <class T> void sum(T* values, int width = 1) const {
    if (messages_.neighbours().empty())
      return;
    const auto in = messages_.exchange(values, width);
    std::vector<T> total(holder_count_.size() * static_cast<std::size_t>(width), T{});
    const auto add_from = [&](std::size_t k) {
      auto theirs = in[k].begin();
      for (const Local row : messages_.neighbours()[k].receive)
        for (int i = 0; i < width; ++i)
          total[static_cast<std::size_t>(row) * width + i] += *theirs++;
    };
    std::size_t k = 0;
    for (; k < in.size() && messages_.neighbours()[k].rank < rank_; ++k)
      add_from(k);
    for (std::size_t i = 0; i < total.size(); ++i)
      total[i] += values[i];
    for (; k < in.size(); ++k)
      add_from(k);
    std::copy(total.begin(), total.end(), values);
  }

private:
  SharedNodes(const Comm& comm, const std::vector<Global>& nodes,
              const std::vector<std::vector<int>>& holders);

  int rank_;
  std::vector<int> owner_, holder_count_; ///< (nodes)
  NeighbourMessages messages_;
};

} // namespace abut
