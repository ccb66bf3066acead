// SPDX-License-Identifier: BSD-3-Clause
// The tree against brute force and against Boost's R-tree.
#include "abut/search/bvh.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <gtest/gtest.h>
#include <random>
#include <set>

using abut::Local;
using abut::search::Box;
using abut::search::Bvh;
namespace bg = boost::geometry;

namespace {

std::vector<Box<3>> random_boxes(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0), size(0.0, 0.06);
  std::vector<Box<3>> boxes(static_cast<std::size_t>(n));
  for (auto& b : boxes)
    for (int i = 0; i < 3; ++i) {
      b.low[i] = place(random);
      b.high[i] = b.low[i] + size(random);
    }
  return boxes;
}

std::set<Local> overlaps(const Bvh<3>& tree, const Box<3>& q) {
  std::set<Local> found;
  tree.traverse([&](const Box<3>& b) { return b.overlaps(q); },
                [&](Local i) { EXPECT_TRUE(found.insert(i).second) << "visited twice"; });
  return found;
}

} // namespace

TEST(Bvh, FindsWhatBruteForceFindsAfterRefitToo) {
  Bvh<3> tree;
  auto boxes = random_boxes(2000, 1);
  tree.build(boxes);
  std::size_t hits = 0;
  for (int round = 0; round < 2; ++round) {
    for (const Box<3>& q : random_boxes(200, 2)) {
      std::set<Local> slow;
      for (Local i = 0; i < 2000; ++i)
        if (boxes[i].overlaps(q))
          slow.insert(i);
      EXPECT_EQ(overlaps(tree, q), slow);
      hits += slow.size();
    }
    boxes = random_boxes(2000, 3); // moved far: the tree is worse but must stay right
    tree.refit(boxes);
  }
  EXPECT_GT(hits, 100u);
}

TEST(Bvh, AgreesWithBoostRtree) {
  using Point = bg::model::point<double, 3, bg::cs::cartesian>;
  using BoostBox = bg::model::box<Point>;
  const auto boxes = random_boxes(1000, 5);
  bg::index::rtree<std::pair<BoostBox, Local>, bg::index::quadratic<16>> oracle;
  const auto convert = [](const Box<3>& b) {
    return BoostBox(Point(b.low[0], b.low[1], b.low[2]), Point(b.high[0], b.high[1], b.high[2]));
  };
  for (Local i = 0; i < 1000; ++i)
    oracle.insert({convert(boxes[i]), i});
  Bvh<3> tree;
  tree.build(boxes);
  for (const Box<3>& q : random_boxes(100, 6)) {
    std::set<Local> expected;
    for (auto it = oracle.qbegin(bg::index::intersects(convert(q))); it != oracle.qend(); ++it)
      expected.insert(it->second);
    EXPECT_EQ(overlaps(tree, q), expected);
  }
}

TEST(Bvh, NearestByShrinkingRadius) {
  const auto boxes = random_boxes(500, 8);
  Bvh<3> tree;
  tree.build(boxes);
  for (const Box<3>& q : random_boxes(100, 9)) {
    double best = 1e300, slow = 1e300;
    tree.traverse([&](const Box<3>& b) { return b.distance2(q.low) < best; },
                  [&](Local i) { best = std::min(best, boxes[i].distance2(q.low)); });
    for (const Box<3>& b : boxes)
      slow = std::min(slow, b.distance2(q.low));
    EXPECT_EQ(best, slow);
  }
}

TEST(Bvh, EmptyAndSingle) {
  Bvh<3> tree;
  tree.build({});
  tree.traverse([](const Box<3>&) { return true; }, [](Local) { FAIL(); });
  EXPECT_TRUE(tree.summary(3).empty());
  tree.build(random_boxes(1, 1));
  EXPECT_EQ(overlaps(tree, random_boxes(1, 1)[0]).size(), 1u);
}

TEST(Bvh, SummaryCoversEverything) {
  const auto boxes = random_boxes(300, 4);
  Bvh<3> tree;
  tree.build(boxes);
  const auto summary = tree.summary(4);
  EXPECT_LE(summary.size(), 16u);
  EXPECT_GT(summary.size(), 8u);
  for (const Box<3>& b : boxes) {
    bool covered = false;
    for (const Box<3>& s : summary) {
      bool in = true;
      for (int i = 0; i < 3; ++i)
        in = in && b.low[i] >= s.low[i] && b.high[i] <= s.high[i];
      covered = covered || in;
    }
    EXPECT_TRUE(covered);
  }
}

TEST(Box, LineThroughBox) {
  const Box<3> b{{0, 0, 0}, {1, 1, 1}};
  const double from[3] = {0.5, 0.5, 3.0}, down[3] = {0, 0, -1}, side[3] = {1, 0, 0};
  EXPECT_TRUE(b.meets_line(from, down, 2.0));
  EXPECT_FALSE(b.meets_line(from, down, 1.9));
  EXPECT_FALSE(b.meets_line(from, side, 10.0));
}

// Kernels hold copies of the tree: they count in one what the host finds, before and after a refit,
// and keep what they had when the host builds another.
TEST(Bvh, TreeIsReadByKernels) {
  Bvh<3> tree;
  const auto boxes = random_boxes(2000, 5), moved = random_boxes(2000, 6);
  const auto queries = abut::make_view("queries", random_boxes(300, 7));
  tree.build(boxes);
  const abut::search::Tree<3> view = tree.view();
  const auto count = [&queries](const abut::search::Tree<3>& in) {
    Local total = 0;
    Kokkos::parallel_reduce(
        "count", abut::Range(0, queries.extent(0)),
        KOKKOS_LAMBDA(const Local q, Local& sum) {
          const Box<3> query = queries(q);
          Local found = 0;
          in.traverse([&](const Box<3>& b) { return b.overlaps(query); }, [&](Local) { ++found; });
          sum += found;
        },
        total);
    return total;
  };
  const auto slow = [&queries](const std::vector<Box<3>>& all) {
    Local total = 0;
    for (std::size_t q = 0; q < queries.extent(0); ++q)
      for (const Box<3>& b : all)
        total += b.overlaps(queries(q));
    return total;
  };
  ASSERT_GT(slow(boxes), 100);
  ASSERT_NE(slow(boxes), slow(moved));
  EXPECT_EQ(count(view), slow(boxes));
  tree.refit(moved);
  EXPECT_EQ(count(view), slow(moved));
  tree.build(random_boxes(10, 8));
  EXPECT_EQ(count(view), slow(moved));
  tree = {};
  EXPECT_EQ(count(view), slow(moved));
  EXPECT_EQ(count(tree.view()), 0);
}
