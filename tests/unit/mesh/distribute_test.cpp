// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/comm.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/meshgen/generators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace abut;
using namespace abut::mesh;
using namespace abut::meshgen;

namespace {

/// Two blocks of different cells, number maps that are no identity, a node in no element.
MeshData example() {
  BlockPairOptions o;
  o.lower_divisions = {4, 5, 3};
  o.upper_divisions = {3, 3, 4};
  MeshData m = block_pair(o);
  m.x.insert(m.x.end(), {9.0, 9.0, 9.0});
  m.node_sets["far"] = {m.num_nodes() - 1};
  for (Global n = 0; n < m.num_nodes(); ++n)
    m.node_id.push_back(1000 + 7 * n);
  Global id = 5;
  for (BlockData& b : m.blocks)
    for (std::size_t e = 0; e < b.nodes.size() / 8; ++e)
      b.element_id.push_back(id += 3);
  return m;
}

struct Scene {
  Comm comm{MPI_COMM_WORLD};
  MeshData whole = example();
  Mesh mesh = distribute(comm.is_root() ? whole : MeshData{}, comm);
};

TEST(Distribute, OwnsEveryElementOnceAndSpreadsThem) {
  const Scene s;
  EXPECT_EQ(s.mesh.num_elements, s.whole.num_elements());
  EXPECT_EQ(s.mesh.num_nodes, s.whole.num_nodes());
  std::vector<double> owners(static_cast<std::size_t>(s.whole.num_elements()), 0.0);
  Global mine = 0;
  for (const Block& b : s.mesh.blocks)
    for (Global e : b.element) {
      owners[e] += 1.0;
      ++mine;
    }
  s.comm.sum(owners.data(), static_cast<int>(owners.size()));
  for (double count : owners)
    EXPECT_EQ(count, 1.0);
  const double fair = static_cast<double>(s.whole.num_elements()) / s.comm.size();
  EXPECT_NEAR(static_cast<double>(mine), fair, 0.15 * fair + 1.0);
}

TEST(Distribute, KeepsElementsIdsAndCoordinates) {
  const Scene s;
  ASSERT_EQ(s.mesh.blocks.size(), 2U);
  Global first = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    const Block& block = s.mesh.blocks[b];
    const BlockData& in = s.whole.blocks[b];
    EXPECT_EQ(block.name, in.name);
    EXPECT_EQ(block.id, in.id);
    for (Local e = 0; e < block.size(); ++e) {
      const Global at = block.element[e] - first;
      EXPECT_EQ(block.element_id[e], in.element_id[at]);
      for (int i = 0; i < 8; ++i)
        EXPECT_EQ(s.mesh.node_input[block.nodes[8 * e + i]], in.nodes[8 * at + i]);
    }
    first += static_cast<Global>(in.element_id.size());
  }
  for (Local n = 0; n < s.mesh.num_local(); ++n) {
    const Global in = s.mesh.node_input[n];
    EXPECT_EQ(s.mesh.node_id[n], 1000 + 7 * in);
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(s.mesh.x[3 * n + d], s.whole.x[3 * in + d]);
  }
}

TEST(Distribute, NumbersNodesContiguouslyAndOwnsByLowestRank) {
  const Scene s;
  const int rank = s.comm.rank();
  ASSERT_EQ(s.mesh.first_node.size(), static_cast<std::size_t>(s.comm.size()) + 1);
  EXPECT_EQ(s.mesh.first_node.back(), s.mesh.num_nodes);
  EXPECT_EQ(s.mesh.first_node[rank + 1] - s.mesh.first_node[rank], s.mesh.num_owned);
  // Lowest rank with an element on each node, and the number its owner gave it.
  const std::size_t nodes = static_cast<std::size_t>(s.mesh.num_nodes);
  std::vector<double> lowest(nodes, s.comm.size()), number(nodes, 0.0);
  for (const Block& b : s.mesh.blocks)
    for (Local n : b.nodes)
      lowest[s.mesh.node_input[n]] = rank;
  for (double& l : lowest)
    l = s.comm.min(l);
  lowest.back() = 0; // the node in no element stays with the root
  for (Local n = 0; n < s.mesh.num_owned; ++n) {
    EXPECT_EQ(s.mesh.node[n], s.mesh.first_node[rank] + n);
    number[s.mesh.node_input[n]] += static_cast<double>(s.mesh.node[n]);
  }
  s.comm.sum(number.data(), static_cast<int>(nodes));
  Global ghosts = 0;
  for (Local n = 0; n < s.mesh.num_local(); ++n) {
    const Global in = s.mesh.node_input[n];
    EXPECT_EQ(s.mesh.owner(s.mesh.node[n]), lowest[in]);
    EXPECT_EQ(s.mesh.owner(s.mesh.node[n]) == rank, n < s.mesh.num_owned);
    EXPECT_EQ(static_cast<double>(s.mesh.node[n]), number[in]);
    if (s.comm.size() == 1) {
      EXPECT_EQ(s.mesh.node[n], in);
    }
    ghosts += n >= s.mesh.num_owned;
  }
  EXPECT_EQ(s.comm.sum(ghosts) > 0, s.comm.size() > 1);
}

TEST(Distribute, GatherGivesTheInputBack) {
  const Scene s;
  const MeshData back = gather(s.mesh);
  if (!s.comm.is_root()) {
    EXPECT_EQ(back.num_nodes(), 0);
    return;
  }
  EXPECT_EQ(back.x, s.whole.x);
  EXPECT_EQ(back.node_id, s.whole.node_id);
  ASSERT_EQ(back.blocks.size(), 2U);
  for (int b = 0; b < 2; ++b) {
    EXPECT_EQ(back.blocks[b].nodes, s.whole.blocks[b].nodes);
    EXPECT_EQ(back.blocks[b].element_id, s.whole.blocks[b].element_id);
  }
  EXPECT_EQ(back.node_sets, s.whole.node_sets);
  ASSERT_EQ(back.side_sets.size(), s.whole.side_sets.size());
  const auto keys = [](const std::vector<SideData>& sides) {
    std::vector<std::vector<Global>> out;
    for (const SideData& t : sides)
      out.push_back({t.block, t.element, t.side});
    std::sort(out.begin(), out.end());
    return out;
  };
  for (const auto& [name, sides] : s.whole.side_sets)
    EXPECT_EQ(keys(back.side_sets.at(name)), keys(sides)) << name;
}

TEST(Distribute, AllNamesAreOnAllRanks) {
  const Scene s;
  for (const auto& [name, set] : s.whole.node_sets) {
    ASSERT_TRUE(s.mesh.node_sets.count(name)) << name;
    // Ghosts belong to the sets as well.
    std::vector<Global> expected, here;
    for (Local n : s.mesh.node_sets.at(name))
      here.push_back(s.mesh.node_input[n]);
    for (Global n : set)
      if (std::count(s.mesh.node_input.begin(), s.mesh.node_input.end(), n))
        expected.push_back(n);
    EXPECT_EQ(here, expected) << name;
  }
  EXPECT_EQ(s.mesh.side_sets.size(), s.whole.side_sets.size());
}

TEST(Distribute, IsDeterministic) {
  const Scene a, b;
  EXPECT_EQ(a.mesh.node_input, b.mesh.node_input);
  EXPECT_EQ(a.mesh.blocks[0].element, b.mesh.blocks[0].element);
}

TEST(Distribute, FewerElementsThanRanks) {
  const Comm comm(MPI_COMM_WORLD);
  const Mesh mesh = distribute(comm.is_root() ? box({}) : MeshData{}, comm);
  EXPECT_EQ(comm.sum(Global(mesh.blocks.at(0).size())), 1);
  EXPECT_EQ(comm.sum(Global(mesh.num_owned)), 8);
}

TEST(NodeExchange, BringsTheOwnersValues) {
  const Scene s;
  const NodeExchange exchange = node_exchange(s.mesh);
  std::vector<double> values(2 * s.mesh.node.size(), -1.0);
  for (Local n = 0; n < s.mesh.num_owned; ++n) {
    values[2 * n] = static_cast<double>(s.mesh.node_input[n]);
    values[2 * n + 1] = s.comm.rank();
  }
  exchange.to_ghosts(values.data(), 2);
  for (Local n = 0; n < s.mesh.num_local(); ++n) {
    EXPECT_EQ(values[2 * n], static_cast<double>(s.mesh.node_input[n]));
    EXPECT_EQ(values[2 * n + 1], s.mesh.owner(s.mesh.node[n]));
  }
}

} // namespace
