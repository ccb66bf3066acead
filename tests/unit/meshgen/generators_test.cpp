// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/mesh/quality.hpp"
#include "abut/meshgen/convert.hpp"
#include "abut/meshgen/generators.hpp"
#include "abut/meshgen/graded_axis.hpp"
#include "mesh_checks.hpp"

#include <gtest/gtest.h>

using namespace abut_test;
using namespace abut::mesh;
using namespace abut::meshgen;

namespace {

TEST(GradedAxis, UniformCoreThenOneRatioUpToTheLimit) {
  const auto x = graded_axis(1.0, {0.2, 0.02, 1.3, 0.2});
  EXPECT_EQ(x.front(), 0.0);
  EXPECT_EQ(x.back(), 1.0);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(x[i + 1] - x[i], 0.02, 1e-15);
  for (std::size_t i = 11; i + 1 < x.size(); ++i) {
    const double ratio = (x[i + 1] - x[i]) / (x[i] - x[i - 1]);
    EXPECT_GT(ratio, 1.0 - 1e-9);
    EXPECT_LT(ratio, 1.3 + 1e-9);
    EXPECT_LT(x[i + 1] - x[i], 0.2 + 1e-12);
  }
  EXPECT_LT(x.size(), 24U); // a uniform axis would have 51
}

TEST(GradedAxis, ShortTailAndWrongInput) {
  const auto x = graded_axis(1.0, {0.99, 0.33, 1.2, 0.0});
  ASSERT_EQ(x.size(), 5U);
  EXPECT_NEAR(x[4] - x[3], 0.01, 1e-15);
  EXPECT_EQ(graded_axis(1.0, {1.0, 0.25, 1.2, 0.0}).size(), 5U);
  EXPECT_THROW(graded_axis(1.0, {0.1, 0.01, 0.9, 0.0}), abut::InputError);
  EXPECT_THROW(graded_axis(-1.0, {0.1, 0.01, 1.1, 0.0}), abut::InputError);
  EXPECT_THROW(uniform_axis(0.0, 1.0, 0), abut::InputError);
}

class EveryCell : public ::testing::TestWithParam<CellType> {};

TEST_P(EveryCell, BoxIsConformingAndClosedBySideSets) {
  BoxOptions o;
  o.size = {3.0, 2.0, 1.0};
  o.divisions = {3, 4, 5};
  o.origin = {1.0, 2.0, 3.0};
  o.distortion = 0.2;
  o.element = GetParam();
  const MeshData m = box(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.05);
  EXPECT_NEAR(volume(m), 6.0, 1e-12);
  std::vector<SideData> outside;
  ASSERT_TRUE(boundary(m, outside));
  std::size_t in_sets = 0;
  for (const auto& [name, sides] : m.side_sets)
    in_sets += sides.size();
  EXPECT_EQ(in_sets, outside.size());
  // Faces per quadrilateral of the boundary: a cut one counts twice.
  const std::size_t quads = 2 * (3 * 4 + 4 * 5 + 5 * 3);
  const bool tets = abut::fem::info(GetParam()).corners == 4;
  const bool wedges = abut::fem::info(GetParam()).corners == 6;
  EXPECT_EQ(in_sets, tets ? 2 * quads : wedges ? quads + 2 * 3 * 4 : quads);
  EXPECT_NEAR(total_area(m, m.side_sets.at("z1")), 6.0, 1e-12);
  EXPECT_NEAR(total_area(m, m.side_sets.at("x0")), 2.0, 1e-12);
  for (const SideData& s : m.side_sets.at("y1")) {
    const Vec3 a = area(m, s);
    EXPECT_GT(a[1], 0.9 * norm(a)); // the normal points out
  }
  ASSERT_FALSE(m.node_sets.at("x1").empty());
  for (Global n : m.node_sets.at("x1"))
    EXPECT_EQ(m.x[3 * n], 4.0);
}

TEST_P(EveryCell, QuadraticNodesCompleteTheSets) {
  BoxOptions o;
  o.divisions = {2, 2, 2};
  o.element = GetParam();
  const MeshData m = box(o);
  // Nodes on one face of 2 x 2 quadrilaterals, with middles of edges and of faces.
  const std::map<CellType, std::size_t> expected{{CellType::hex8, 9},   {CellType::hex20, 21},
                                                 {CellType::hex27, 25}, {CellType::tet4, 9},
                                                 {CellType::tet10, 25}, {CellType::wedge6, 9}};
  for (const char* set : {"x0", "x1", "y0", "y1", "z0", "z1"})
    EXPECT_EQ(m.node_sets.at(set).size(), expected.at(GetParam())) << set;
}

TEST_P(EveryCell, BlockPairKeepsApartAndFacesEachOther) {
  BlockPairOptions o;
  o.lower_size = {2.0, 2.0, 1.0};
  o.lower_divisions = {4, 4, 2};
  o.upper_size = {1.0, 1.5, 0.5};
  o.upper_divisions = {3, 5, 2};
  o.gap = 0.01;
  o.rotation = 20.0;
  o.distortion = 0.1;
  o.element = GetParam();
  const MeshData m = block_pair(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.02);
  EXPECT_NEAR(volume(m), 4.0 + 0.75, 1e-12);
  ASSERT_EQ(m.blocks.size(), 2U);
  EXPECT_EQ(m.blocks[0].name, "lower");
  EXPECT_EQ(m.blocks[1].name, "upper");
  EXPECT_EQ(m.side_sets.size(), 12U);
  EXPECT_NEAR(total_area(m, m.side_sets.at("lower_top")), 4.0, 1e-12);
  EXPECT_NEAR(total_area(m, m.side_sets.at("upper_bottom")), 1.5, 1e-12);
  for (const SideData& s : m.side_sets.at("lower_top"))
    EXPECT_GT(area(m, s)[2], 0.0);
  for (const SideData& s : m.side_sets.at("upper_bottom")) {
    EXPECT_LT(area(m, s)[2], 0.0);
    for (Global n : side_nodes(m, s))
      EXPECT_NEAR(point(m, n)[2], 0.01, 1e-15);
  }
  for (Global n : m.node_sets.at("upper_x0"))
    EXPECT_NEAR(point(m, n)[0], 0.5, 1e-15);
}

TEST_P(EveryCell, RingsLieOnTrueCircles) {
  RingsOptions o;
  o.gap = -0.01;
  o.element = GetParam();
  const MeshData m = rings(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.1);
  for (const auto& [set, radius] : std::map<std::string, double>{{"inner_inner", 1.0},
                                                                 {"inner_outer", 1.5},
                                                                 {"outer_inner", 1.49},
                                                                 {"outer_outer", 2.0}}) {
    ASSERT_FALSE(m.node_sets.at(set).empty());
    for (Global n : m.node_sets.at(set))
      EXPECT_NEAR(std::hypot(m.x[3 * n], m.x[3 * n + 1]), radius, 1e-14);
  }
  for (Global n : m.node_sets.at("x0"))
    EXPECT_EQ(m.x[3 * n], 0.0);
  for (Global n : m.node_sets.at("y0"))
    EXPECT_EQ(m.x[3 * n + 1], 0.0);
  EXPECT_NEAR(total_area(m, m.side_sets.at("x0")), 0.1 * (0.5 + 0.51), 1e-12);
}

TEST_P(EveryCell, HertzBlockIsFineAtTheOrigin) {
  HertzBlockOptions o;
  o.facets = 4;
  o.element = GetParam();
  const MeshData m = hertz_block(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.0);
  EXPECT_NEAR(volume(m), 1.0, 1e-12);
  ASSERT_EQ(m.node_sets.at("origin").size(), 1U);
  EXPECT_EQ(norm(point(m, m.node_sets.at("origin")[0])), 0.0);
  for (Global n : m.node_sets.at("contact")) {
    EXPECT_EQ(point(m, n)[2], 0.0);
    EXPECT_LE(std::hypot(m.x[3 * n], m.x[3 * n + 1]), 0.4 * (1.0 + 1e-9));
  }
  EXPECT_GE(m.side_sets.at("contact").size(), 16U);
}

INSTANTIATE_TEST_SUITE_P(Cells, EveryCell, ::testing::ValuesIn(all_types),
                         [](const auto& p) { return abut::fem::info(p.param).name; });

TEST(BlockPair, TheSameSeedGivesTheSameMesh) {
  BlockPairOptions o;
  o.distortion = 0.2;
  const MeshData a = block_pair(o), b = block_pair(o);
  EXPECT_EQ(a.x, b.x);
  o.distortion = 0.0;
  EXPECT_NE(a.x, block_pair(o).x);
}

TEST(BlockPair, RotationMovesTheInterfaceButNotTheOutline) {
  BlockPairOptions o;
  o.upper_divisions = {4, 4, 2};
  const MeshData straight = block_pair(o);
  o.rotation = 15.0;
  const MeshData turned = block_pair(o);
  double largest = 0.0;
  for (Global n : straight.node_sets.at("upper_bottom"))
    largest = std::max(largest, norm(point(turned, n) - point(straight, n)));
  EXPECT_GT(largest, 0.04);
  for (const char* set : {"upper_x0", "upper_y1", "upper_top", "lower_top"})
    for (Global n : straight.node_sets.at(set))
      EXPECT_LT(norm(point(turned, n) - point(straight, n)), 1e-15);
  o.rotation = 45.0;
  EXPECT_THROW(block_pair(o), abut::InputError);
}

TEST(BlockPair, FlanksOfTheLowerTopDrop) {
  BlockPairOptions o;
  o.lower_size = {2.5, 0.1, 0.5};
  o.lower_divisions = {10, 1, 2};
  o.upper_size = {2.0, 0.1, 1.0};
  o.shift = -0.125;
  o.flat = 0.5;
  o.drop = 0.2;
  o.element = abut::fem::CellType::hex20;
  const MeshData m = block_pair(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.5);
  double lowest = 0.0;
  for (Global n : m.node_sets.at("lower_top")) {
    const double beyond = std::max(0.0, std::abs(point(m, n)[0] - 1.25) - 0.5);
    EXPECT_NEAR(point(m, n)[2], -0.2 * beyond * beyond, 1e-15);
    lowest = std::min(lowest, point(m, n)[2]);
  }
  EXPECT_NEAR(lowest, -0.1125, 1e-15);
  for (Global n : m.node_sets.at("lower_bottom"))
    EXPECT_EQ(point(m, n)[2], -0.5);
  for (Global n : m.node_sets.at("upper_x0"))
    EXPECT_NEAR(point(m, n)[0], 0.125, 1e-15);
}

TEST(Convert, RefusesWedgesThatDoNotStack) {
  // Two cells, the second on its side: its first direction meets the first one's cut face.
  MeshData m;
  for (double z : {0.0, 1.0, 2.0})
    for (double y : {0.0, 1.0})
      for (double x : {0.0, 1.0})
        m.x.insert(m.x.end(), {x, y, z});
  m.blocks.resize(1);
  m.blocks[0].id = 1;
  m.blocks[0].name = "two";
  m.blocks[0].nodes = {0, 1, 3, 2, 4, 5, 7, 6};
  const std::vector<Global> on_side{4, 6, 10, 8, 5, 7, 11, 9};
  m.blocks[0].nodes.insert(m.blocks[0].nodes.end(), on_side.begin(), on_side.end());
  ASSERT_GT(min_scaled_jacobian(m), 0.99);
  EXPECT_THROW(convert(m, CellType::wedge6), abut::InputError);
  const MeshData tets = convert(m, CellType::tet10);
  EXPECT_NEAR(volume(tets), 2.0, 1e-14);
  EXPECT_GT(min_scaled_jacobian(tets), 0.3);
}

} // namespace
