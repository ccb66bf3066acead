// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/node_exchange.hpp"

#include "abut/core/error.hpp"

#include <limits>
#include <map>
#include <unordered_map>

namespace abut {

namespace {

using Neighbour = NeighbourMessages::Neighbour;

int byte_count(std::size_t rows, std::size_t row_bytes) {
  const std::size_t bytes = rows * row_bytes;
  ABUT_REQUIRE(bytes < std::size_t(std::numeric_limits<int>::max()),
               "a message between two ranks is larger than 2 GiB");
  return static_cast<int>(bytes);
}

/// Owners send what others hold copies of.
std::vector<Neighbour> owners_and_ghosts(const Comm& comm, const std::vector<Global>& first_node,
                                         const std::vector<Global>& ghosts) {
  const auto ranks = static_cast<std::size_t>(comm.size());
  const Global first = first_node[static_cast<std::size_t>(comm.rank())];
  const Global owned = first_node[static_cast<std::size_t>(comm.rank()) + 1] - first;
  std::vector<std::vector<Global>> wanted(ranks);
  std::vector<std::vector<Local>> receive(ranks);
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    const auto next = std::upper_bound(first_node.begin(), first_node.end(), ghosts[i]);
    const auto owner = static_cast<std::size_t>(next - first_node.begin()) - 1;
    wanted[owner].push_back(ghosts[i]);
    receive[owner].push_back(static_cast<Local>(owned) + static_cast<Local>(i));
  }
  const auto asked = comm.exchange(wanted);
  std::vector<Neighbour> result;
  for (std::size_t r = 0; r < ranks; ++r) {
    if (asked[r].empty() && receive[r].empty())
      continue;
    Neighbour& other = result.emplace_back();
    other.rank = static_cast<int>(r);
    other.receive = std::move(receive[r]);
    for (const Global node : asked[r])
      other.send.push_back(static_cast<Local>(node - first));
  }
  return result;
}

/// For each node the ranks that have it, this one among them, in ascending order. A node's home,
/// picked by its number, tells each of them who the others are.
std::vector<std::vector<int>> holders_of(const Comm& comm, const std::vector<Global>& nodes) {
  const auto ranks = static_cast<std::size_t>(comm.size());
  std::vector<std::vector<Global>> held(ranks);
  std::unordered_map<Global, std::size_t> here;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ABUT_REQUIRE(here.emplace(nodes[i], i).second, "a node stands twice in a list of nodes");
    held[static_cast<std::size_t>(nodes[i]) % ranks].push_back(nodes[i]);
  }
  const auto asked = comm.exchange(held);
  std::map<Global, std::vector<Global>> at_home;
  for (std::size_t r = 0; r < ranks; ++r)
    for (const Global node : asked[r])
      at_home[node].push_back(static_cast<Global>(r));
  std::vector<std::vector<Global>> answer(ranks); // node, number of holders, holders
  for (const auto& [node, list] : at_home)
    for (const Global r : list) {
      auto& to = answer[static_cast<std::size_t>(r)];
      to.insert(to.end(), {node, static_cast<Global>(list.size())});
      to.insert(to.end(), list.begin(), list.end());
    }
  std::vector<std::vector<int>> result(nodes.size());
  for (const auto& part : comm.exchange(answer))
    for (auto p = part.begin(); p != part.end(); p += 2 + p[1])
      result[here.at(*p)].assign(p + 2, p + 2 + p[1]);
  return result;
}

/// The nodes that each pair of ranks shares, by ascending number on both.
std::vector<Neighbour> sharers(const Comm& comm, const std::vector<Global>& nodes,
                               const std::vector<std::vector<int>>& holders) {
  std::map<int, std::map<Global, Local>> with;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const int rank : holders[i])
      if (rank != comm.rank())
        with[rank][nodes[i]] = static_cast<Local>(i);
  std::vector<Neighbour> result;
  for (const auto& [rank, shared] : with) {
    Neighbour& other = result.emplace_back();
    other.rank = rank;
    for (const auto& entry : shared)
      other.send.push_back(entry.second);
    other.receive = other.send;
  }
  return result;
}

} // namespace

void NeighbourMessages::exchange_bytes(const std::vector<const void*>& from,
                                       const std::vector<void*>& to, std::size_t row_bytes,
                                       bool backward) const {
  constexpr int tag = 2113; // of no other message that is on its way meanwhile
  std::vector<MPI_Request> requests;
  for (std::size_t k = 0; k < neighbours_.size(); ++k) {
    const Neighbour& other = neighbours_[k];
    const auto& rows = backward ? other.send : other.receive;
    if (!rows.empty())
      MPI_Irecv(to[k], byte_count(rows.size(), row_bytes), MPI_BYTE, other.rank, tag, comm_,
                &requests.emplace_back());
  }
  for (std::size_t k = 0; k < neighbours_.size(); ++k) {
    const Neighbour& other = neighbours_[k];
    const auto& rows = backward ? other.receive : other.send;
    if (!rows.empty())
      MPI_Isend(from[k], byte_count(rows.size(), row_bytes), MPI_BYTE, other.rank, tag, comm_,
                &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

NodeExchange::NodeExchange(const Comm& comm, const std::vector<Global>& first_node,
                           const std::vector<Global>& ghosts)
    : messages_(comm, owners_and_ghosts(comm, first_node, ghosts)) {}

SharedNodes::SharedNodes(const Comm& comm, const std::vector<Global>& nodes)
    : SharedNodes(comm, nodes, holders_of(comm, nodes)) {}

SharedNodes::SharedNodes(const Comm& comm, const std::vector<Global>& nodes,
                         const std::vector<std::vector<int>>& holders)
    : rank_(comm.rank()), messages_(comm, sharers(comm, nodes, holders)) {
  for (const std::vector<int>& list : holders) {
    owner_.push_back(list.front());
    holder_count_.push_back(static_cast<int>(list.size()));
  }
}

} // namespace abut
