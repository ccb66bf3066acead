// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/mesh/quality.hpp"
#include "abut/meshgen/generators.hpp"
#include "mesh_checks.hpp"

#include <gtest/gtest.h>

using namespace abut_test;
using namespace abut::mesh;
using namespace abut::meshgen;

namespace {

constexpr double pi = 3.14159265358979323846;

class RoundCell : public ::testing::TestWithParam<CellType> {};

TEST_P(RoundCell, SphereIsTrueAndConforming) {
  RoundOptions o;
  o.radius = 2.0;
  o.core = 0.4;
  o.facets = 6;
  o.gap = 0.01;
  o.element = GetParam();
  if (GetParam() == CellType::wedge6) {
    EXPECT_THROW(quarter_sphere(o), abut::InputError);
    return;
  }
  const MeshData m = quarter_sphere(o);
  const bool tets = abut::fem::info(GetParam()).corners == 4;
  EXPECT_GT(min_scaled_jacobian(m), tets ? 0.005 : 0.6);
  const Vec3 centre{{0.0, 0.0, 2.01}};
  for (Global n : m.node_sets.at("curved"))
    EXPECT_NEAR(norm(point(m, n) - centre), 2.0, 4e-15);
  for (Global n : m.node_sets.at("x0"))
    EXPECT_EQ(m.x[3 * n], 0.0);
  for (Global n : m.node_sets.at("y0"))
    EXPECT_EQ(m.x[3 * n + 1], 0.0);
  for (Global n : m.node_sets.at("top"))
    EXPECT_EQ(m.x[3 * n + 2], 2.01);
  ASSERT_EQ(m.node_sets.at("pole").size(), 1U);
  const Vec3 pole = point(m, m.node_sets.at("pole")[0]);
  EXPECT_EQ(pole[0], 0.0);
  EXPECT_EQ(pole[1], 0.0);
  EXPECT_EQ(pole[2], 0.01);

  // Sphere and plate are closed by their sets. Flat facets of side h lie on average h^2/(6 R) below
  // the sphere, with h at most R/5, so they miss at most 2 % of the eighth of a ball.
  std::vector<SideData> outside;
  ASSERT_TRUE(boundary(m, outside));
  EXPECT_EQ(faces_in(m, {"curved", "top", "x0", "y0"}) + 6, outside.size());
  const double exact = pi * 8.0 / 6.0, plate = 0.4 * 1.2 * 1.2;
  EXPECT_LT(volume(m) - plate, exact);
  EXPECT_GT(volume(m) - plate, 0.98 * exact);
}

TEST_P(RoundCell, CylinderIsTrueAndConforming) {
  CylinderOptions o;
  o.facets = 6;
  o.thickness = 0.05;
  o.element = GetParam();
  const MeshData m = quarter_cylinder(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.0);
  for (Global n : m.node_sets.at("curved"))
    EXPECT_NEAR(std::hypot(m.x[3 * n], m.x[3 * n + 2] - 1.0), 1.0, 2e-15);
  for (Global n : m.node_sets.at("top"))
    EXPECT_EQ(m.x[3 * n + 2], 1.0);
  std::vector<SideData> outside;
  ASSERT_TRUE(boundary(m, outside));
  EXPECT_EQ(faces_in(m, {"curved", "top", "x0", "y0", "y1"}) + 6, outside.size());
  EXPECT_NEAR(total_area(m, m.side_sets.at("curved")), 0.05 * pi / 2.0, 0.01 * 0.05 * pi / 2.0);
  for (Global n : m.node_sets.at("pole"))
    EXPECT_EQ(point(m, n)[2], 0.0);
}

INSTANTIATE_TEST_SUITE_P(Cells, RoundCell, ::testing::ValuesIn(all_types),
                         [](const auto& p) { return abut::fem::info(p.param).name; });

TEST(Sphere, CoreHasTheAskedFacets) {
  RoundOptions o;
  o.facets = 16;
  const MeshData m = quarter_sphere(o);
  EXPECT_GT(min_scaled_jacobian(m), 0.6);
  EXPECT_GT(m.num_nodes(), 10000);
  EXPECT_LT(m.num_nodes(), 30000);
  int along_x = 0; // nodes on the arc y = 0 within the core
  for (Global n : m.node_sets.at("contact")) {
    const Vec3 x = point(m, n);
    if (x[1] == 0.0 && std::asin(x[0]) <= 0.2 * (1.0 + 1e-9))
      ++along_x;
  }
  EXPECT_EQ(along_x, 17);
  double reach = 0.0;
  for (Global n : m.node_sets.at("contact"))
    reach = std::max(reach, std::hypot(m.x[3 * n], m.x[3 * n + 1]));
  EXPECT_GT(reach, 0.34);
  EXPECT_LE(reach, 0.4 * (1.0 + 1e-9));
  for (const SideData& s : m.side_sets.at("plate_top"))
    EXPECT_GT(area(m, s)[2], 0.0);
  for (const SideData& s : m.side_sets.at("contact"))
    EXPECT_LT(area(m, s)[2], 0.0);
  o.plate = false;
  EXPECT_EQ(quarter_sphere(o).blocks.size(), 1U);
}

TEST(Sphere, RefusesWhatMakesNoMesh) {
  RoundOptions o;
  o.core = 0.9;
  EXPECT_THROW(quarter_sphere(o), abut::InputError);
  o.core = 0.2;
  o.facets = 0;
  EXPECT_THROW(quarter_sphere(o), abut::InputError);
}

} // namespace
