// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/node_exchange.hpp"

#include <gtest/gtest.h>

#include <map>

using namespace abut;

namespace {

/// What every rank says of nodes, seen by all of them: the slow way.
std::map<Global, std::vector<double>> all_said(const Comm& comm, const std::vector<Global>& nodes,
                                               const std::vector<double>& values) {
  std::vector<double> mine;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    mine.insert(mine.end(), {double(nodes[i]), values[i]});
  const std::vector<double> all = comm.all_gather(mine);
  std::map<Global, std::vector<double>> said; // in the order of the ranks
  for (std::size_t i = 0; i < all.size(); i += 2)
    said[Global(all[i])].push_back(all[i + 1]);
  return said;
}

/// Ten nodes on each rank but the second, which has none; ghosts of all others, some twice.
struct Scene {
  Comm comm{MPI_COMM_WORLD};
  std::vector<Global> first{0}, nodes, ghosts;
  std::size_t owned;

  Scene() {
    for (int r = 0; r < comm.size(); ++r)
      first.push_back(first.back() + (r == 1 ? 0 : 10));
    const Global mine = first[std::size_t(comm.rank())];
    owned = std::size_t(first[std::size_t(comm.rank()) + 1] - mine);
    for (std::size_t i = 0; i < owned; ++i)
      nodes.push_back(mine + Global(i));
    for (Global n = first.back() - 1; n >= 0; n -= 1 + comm.rank())
      if (n < mine || n >= mine + Global(owned) || n % 3 == 0)
        ghosts.push_back(n);
    ghosts.push_back(first.back() / 2);
    ghosts.push_back(first.back() / 2);
    nodes.insert(nodes.end(), ghosts.begin(), ghosts.end());
  }
  double value(std::size_t i) const { return 0.1 * double(nodes[i]) + 1e-3 * double(i * i) / 7.0; }
  std::vector<double> values() const {
    std::vector<double> v;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      v.push_back(value(i) * (comm.rank() + 1));
    return v;
  }
};

} // namespace

TEST(NodeExchange, GhostsTakeTheOwnersValues) {
  const Scene s;
  const NodeExchange exchange(s.comm, s.first, s.ghosts);
  std::vector<Global> v(2 * s.nodes.size(), -1);
  for (std::size_t i = 0; i < s.owned; ++i) {
    v[2 * i] = s.nodes[i];
    v[2 * i + 1] = 7 * s.nodes[i];
  }
  exchange.to_ghosts(v.data(), 2);
  for (std::size_t i = 0; i < s.nodes.size(); ++i) {
    EXPECT_EQ(v[2 * i], s.nodes[i]);
    EXPECT_EQ(v[2 * i + 1], 7 * s.nodes[i]);
  }
}

TEST(NodeExchange, OwnersGetSumLeastAndLargest) {
  const Scene s;
  const NodeExchange exchange(s.comm, s.first, s.ghosts);
  const auto said = all_said(s.comm, s.nodes, s.values());
  std::vector<double> sum = s.values(), least = sum, largest = sum;
  exchange.add_to_owners(sum.data());
  exchange.min_to_owners(least.data());
  exchange.max_to_owners(largest.data());
  for (std::size_t i = 0; i < s.owned; ++i) {
    const std::vector<double>& all = said.at(s.nodes[i]);
    EXPECT_GT(all.size(), 0U);
    double expected = 0.0;
    for (const double x : all)
      expected += x;
    EXPECT_NEAR(sum[i], expected, 1e-15 * double(all.size()) * expected);
    EXPECT_EQ(least[i], *std::min_element(all.begin(), all.end()));
    EXPECT_EQ(largest[i], *std::max_element(all.begin(), all.end()));
  }
  for (std::size_t i = s.owned; i < s.nodes.size(); ++i)
    EXPECT_EQ(sum[i], s.values()[i]) << "ghost rows stay as they are";
}

TEST(SharedNodes, AllHoldersGetTheSameSum) {
  const Comm comm(MPI_COMM_WORLD);
  std::vector<Global> nodes; // 0 .. 59 in some order: those that rank + 1 divides
  for (Global k = 0; k < 60; ++k)
    if ((7 * k) % 60 % (comm.rank() + 1) == 0)
      nodes.push_back((7 * k) % 60);
  std::vector<double> values;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    values.push_back((double(nodes[i]) + 0.3) / (comm.rank() + 3.0));
  const auto said = all_said(comm, nodes, values);
  const SharedNodes shared(comm, nodes);
  std::vector<double> sum = values;
  shared.sum(sum.data());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::vector<double>& all = said.at(nodes[i]);
    double expected = 0.0;
    for (const double x : all)
      expected += x;
    EXPECT_EQ(sum[i], expected); // every rank adds in this order
    EXPECT_EQ(shared.is_shared(Local(i)), all.size() > 1);
    EXPECT_EQ(shared.owner(Local(i)), 0); // which has them all
  }
  EXPECT_EQ(comm.size() > 1, comm.any(shared.is_shared(0)));
}
