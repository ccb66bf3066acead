// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/mesh/quality.hpp"
#include "abut/meshgen/contact_generators.hpp"
#include "mesh_checks.hpp"

#include <gtest/gtest.h>

using namespace abut_test;
using namespace abut::mesh;
using namespace abut::meshgen;

namespace {

constexpr double pi = 3.14159265358979323846;

class PairCell : public ::testing::TestWithParam<CellType> {};

TEST_P(PairCell, InterfaceNodesAreOnTheSurfaceOfBothBlocks) {
  InterfaceOptions o;
  o.shape = InterfaceShape::sphere;
  o.radius = 2.0;
  o.depth = 0.8;
  o.element = GetParam();
  const MeshData m = interface_pair(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.1);
  for (const char* set : {"lower_top", "upper_bottom"}) {
    ASSERT_FALSE(m.node_sets.at(set).empty());
    for (Global n : m.node_sets.at(set)) {
      const Vec3 x = point(m, n);
      EXPECT_NEAR(std::hypot(x[0], x[1], x[2] + 2.0), 2.0, 2e-15) << set;
    }
  }
  for (const SideData& s : m.side_sets.at("lower_top"))
    EXPECT_GT(area(m, s)[2], 0.0);
  for (const SideData& s : m.side_sets.at("upper_bottom"))
    EXPECT_LT(area(m, s)[2], 0.0);
  std::vector<SideData> outside;
  ASSERT_TRUE(boundary(m, outside));
  EXPECT_EQ(faces_in(m, {"lower_outer", "lower_top", "upper_outer", "upper_bottom"}),
            outside.size());
  EXPECT_EQ(faces_in(m, {"upper_outer"}),
            faces_in(m, {"upper_x0", "upper_x1", "upper_y0", "upper_y1", "upper_top"}));
  // Flat facets of the two meshes miss each other by their sagittas, h^2/8R in each direction.
  EXPECT_NEAR(volume(m), 1.6, 0.8 * (0.25 * 0.25 + 0.2 * 0.2) / 16.0);
}

TEST_P(PairCell, TwoSpheresTouchAtTheirPoles) {
  RoundPairOptions o;
  o.lower_radius = 2.0;
  o.upper_facets = 6;
  o.lower_facets = 4;
  o.element = GetParam();
  if (GetParam() == CellType::wedge6) {
    EXPECT_THROW(sphere_pair(o), abut::InputError);
    return;
  }
  const MeshData m = sphere_pair(o);
  EXPECT_GT(min_scaled_jacobian(m), abut::fem::info(GetParam()).corners == 4 ? 0.0 : 0.5);
  for (Global n : m.node_sets.at("upper_curved"))
    EXPECT_NEAR(norm(point(m, n) - Vec3{{0.0, 0.0, 1.0}}), 1.0, 4e-15);
  for (Global n : m.node_sets.at("lower_curved"))
    EXPECT_NEAR(norm(point(m, n) - Vec3{{0.0, 0.0, -2.0}}), 2.0, 4e-15);
  for (Global n : m.node_sets.at("x0"))
    EXPECT_EQ(m.x[3 * n], 0.0);
  for (Global n : m.node_sets.at("y0"))
    EXPECT_EQ(m.x[3 * n + 1], 0.0);
  for (Global n : m.node_sets.at("lower_bottom"))
    EXPECT_EQ(m.x[3 * n + 2], -2.0);
  std::vector<SideData> outside;
  ASSERT_TRUE(boundary(m, outside));
  EXPECT_EQ(faces_in(m, {"upper_curved", "lower_curved", "upper_top", "lower_bottom", "x0", "y0"}),
            outside.size());
  for (const SideData& s : m.side_sets.at("lower_contact"))
    EXPECT_GT(area(m, s)[2], 0.0);
  EXPECT_GT(volume(m), 0.98 * 9.0 * pi / 6.0);
}

TEST_P(PairCell, ParaboloidIsTrueAndConforming) {
  ParaboloidOptions o;
  o.radius = 2.0;
  o.facets = 3;
  o.gap = 0.01;
  o.plate_facets = 2;
  o.element = GetParam();
  const MeshData m = paraboloid(o);
  EXPECT_GT(min_scaled_jacobian(m), abut::fem::info(GetParam()).corners == 8 ? 0.7 : 0.0);
  for (Global n : m.node_sets.at("contact")) {
    const Vec3 x = point(m, n);
    EXPECT_NEAR(x[2], 0.01 + (x[0] * x[0] + x[1] * x[1]) / 4.0, 1e-16);
    EXPECT_LE(std::hypot(x[0], x[1]), 0.2);
  }
  for (Global n : m.node_sets.at("plate_top"))
    EXPECT_EQ(m.x[3 * n + 2], 0.0);
  const Vec3 pole = point(m, m.node_sets.at("pole")[0]);
  EXPECT_EQ(norm(pole - Vec3{{0.0, 0.0, 0.01}}), 0.0);
  for (const SideData& s : m.side_sets.at("contact"))
    EXPECT_LT(area(m, s)[2], 0.0);
  for (const SideData& s : m.side_sets.at("plate_top"))
    EXPECT_GT(area(m, s)[2], 0.0);
  std::vector<SideData> outside;
  ASSERT_TRUE(boundary(m, outside));
  const std::size_t lower_face = faces_in(m, {"top"}); // as many as the face opposite
  EXPECT_EQ(faces_in(m, {"x0", "x1", "y0", "y1", "top", "plate_top", "plate_bottom"}) + lower_face,
            outside.size());
  EXPECT_NEAR(volume(m), 2.0, 1e-12); // the block is sheared
}

TEST(Paraboloid, PlateOfOneCellReachesBeyondTheSymmetryPlanes) {
  ParaboloidOptions o;
  o.facets = 2;
  const MeshData m = paraboloid(o);
  EXPECT_EQ(m.side_sets.at("plate_top").size(), 1U);
  double low = 0.0;
  for (Global n : m.node_sets.at("plate_top"))
    low = std::min(low, m.x[3 * n]);
  EXPECT_EQ(low, -0.1);
  for (Global n : m.node_sets.at("x0"))
    EXPECT_EQ(m.x[3 * n], 0.0);
  o.core = 2.0;
  EXPECT_THROW(paraboloid(o), abut::InputError);
}

TEST_P(PairCell, TwoCylindersTouchAlongALine) {
  CylinderPairOptions o;
  o.upper_facets = 6;
  o.lower_facets = 4;
  o.element = GetParam();
  const MeshData m = cylinder_pair(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.0);
  for (Global n : m.node_sets.at("lower_contact"))
    EXPECT_NEAR(std::hypot(m.x[3 * n], m.x[3 * n + 2] + 1.0), 1.0, 2e-15);
  for (Global n : m.node_sets.at("y0"))
    EXPECT_EQ(m.x[3 * n + 1], 0.0);
  for (Global n : m.node_sets.at("y1"))
    EXPECT_EQ(m.x[3 * n + 1], o.thickness);
  std::vector<SideData> outside;
  ASSERT_TRUE(boundary(m, outside));
  EXPECT_EQ(
      faces_in(m, {"upper_curved", "lower_curved", "upper_top", "lower_bottom", "x0", "y0", "y1"}),
      outside.size());
}

TEST_P(PairCell, PunchEdgeIsWhereItShouldBe) {
  for (PunchShape shape : {PunchShape::strip, PunchShape::disc}) {
    PunchOptions o;
    o.shape = shape;
    o.facets = 6;
    o.offset = 0.5;
    o.size = 8.0;
    o.punch_divisions = shape == PunchShape::disc ? 16 : 1;
    o.element = GetParam();
    if (GetParam() == CellType::wedge6) {
      EXPECT_THROW(punch(o), abut::InputError);
      continue;
    }
    const MeshData m = punch(o);
    EXPECT_GT(min_scaled_jacobian(m), abut::fem::info(GetParam()).corners == 4 ? 0.0 : 0.5);
    std::vector<SideData> outside;
    ASSERT_TRUE(boundary(m, outside));
    const bool disc = shape == PunchShape::disc;
    EXPECT_NEAR(total_area(m, m.side_sets.at("punch_bottom")), disc ? pi / 4.0 : 0.1, 1e-12);
    // The sixth line of the mesh lies half a cell beyond the edge.
    const double line = 6.0 / 5.5;
    int found = 0;
    for (Global n : m.node_sets.at("top"))
      found += m.x[3 * n + 1] == 0.0 && std::abs(m.x[3 * n] - line) < 1e-14;
    EXPECT_EQ(found, 1);
    for (Global n : m.node_sets.at("side"))
      EXPECT_NEAR(std::hypot(m.x[3 * n], disc ? m.x[3 * n + 1] : 0.0), 8.0, 2e-15 * 8.0);
    std::vector<std::string> sets{"x0", "y0", "top", "bottom", "side"};
    if (!disc)
      sets.push_back("y1");
    const std::size_t of_punch = disc ? 2 * 192 + 3 * 16 : 6;
    EXPECT_EQ(faces_in(m, sets) + of_punch, outside.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, PairCell, ::testing::ValuesIn(all_types),
                         [](const auto& p) { return abut::fem::info(p.param).name; });

TEST(Interface, Shapes) {
  InterfaceOptions o;
  o.angle = 60.0;
  EXPECT_GT(min_scaled_jacobian(interface_pair(o)), 0.45); // cos 60
  MeshData m = interface_pair(o);
  for (Global n : m.node_sets.at("upper_bottom"))
    EXPECT_NEAR(m.x[3 * n + 2], std::sqrt(3.0) * (m.x[3 * n] - 0.5), 1e-15);
  EXPECT_NEAR(volume(m), 2.0, 1e-12);
  o.shape = InterfaceShape::sine;
  m = interface_pair(o);
  for (Global n : m.node_sets.at("lower_top"))
    EXPECT_NEAR(m.x[3 * n + 2], 0.1 * std::sin(2.0 * pi * m.x[3 * n]), 1e-15);
  o.shape = InterfaceShape::cylinder;
  o.radius = 1.5;
  m = interface_pair(o);
  for (Global n : m.node_sets.at("lower_top"))
    EXPECT_NEAR(std::hypot(m.x[3 * n], m.x[3 * n + 2] + 1.5), 1.5, 4e-16);
}

TEST(Interface, RefusesWhatLeavesTheBox) {
  InterfaceOptions o;
  o.angle = 60.0;
  o.upper_height = 0.8; // the plane rises to 0.866
  EXPECT_THROW(interface_pair(o), abut::InputError);
  o.angle = 85.0;
  EXPECT_THROW(interface_pair(o), abut::InputError);
  o.shape = InterfaceShape::sphere;
  EXPECT_THROW(interface_pair(o), abut::InputError); // radius 1 within a square of edge 1
}

TEST(Punch, RefusesWhatMakesNoMesh) {
  PunchOptions o;
  o.offset = 1.0;
  EXPECT_THROW(punch(o), abut::InputError);
  o.offset = 0.0;
  o.size = 2.0;
  EXPECT_THROW(punch(o), abut::InputError);
  o.size = 10.0;
  o.shape = PunchShape::disc;
  EXPECT_THROW(punch(o), abut::InputError); // one division of the punch
}

} // namespace
