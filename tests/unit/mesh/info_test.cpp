// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/info.hpp"
#include "abut/meshgen/generators.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::mesh;

namespace {

class InfoOfCells : public testing::TestWithParam<fem::CellType> {};

/// A box of 2 x 3 x 4 at (1, 1, 1) in cells of 1 x 1 x 2 before they are cut into others.
TEST_P(InfoOfCells, VolumesAreasAndExtentOfABox) {
  meshgen::BoxOptions o;
  o.size = {2.0, 3.0, 4.0};
  o.origin = {1.0, 1.0, 1.0};
  o.divisions = {2, 3, 2};
  o.element = GetParam();
  const MeshData mesh = meshgen::box(o);
  const MeshInfo i = info(mesh);
  EXPECT_EQ(i.nodes, mesh.num_nodes());
  EXPECT_EQ(i.elements, mesh.num_elements());
  EXPECT_EQ(i.loose_nodes, 0);
  ASSERT_EQ(i.blocks.size(), 1u);
  EXPECT_EQ(i.blocks[0].elements, mesh.num_elements());
  EXPECT_NEAR(i.blocks[0].volume, 24.0, 1e-12);
  const double areas[] = {12.0, 12.0, 8.0, 8.0, 6.0, 6.0}; // x0, x1, y0, ...
  for (std::size_t s = 0; s < 6; ++s)
    EXPECT_NEAR(i.side_sets[s].area, areas[s], 1e-12) << i.side_sets[s].name;
  for (int d = 0; d < 3; ++d) {
    EXPECT_EQ(i.low[d], 1.0);
    EXPECT_EQ(i.high[d], 1.0 + o.size[std::size_t(d)]);
  }
  EXPECT_DOUBLE_EQ(i.min_edge, 1.0);
  const bool cut = fem::info(GetParam()).corners < 8;
  EXPECT_GE(i.max_edge, 2.0);
  EXPECT_LE(i.aspect_ratio.value, i.max_edge / i.min_edge + 1e-12);
  EXPECT_GT(i.scaled_jacobian.value, cut ? 0.1 : 1.0 - 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Cells, InfoOfCells,
                         testing::Values(fem::CellType::hex8, fem::CellType::hex20,
                                         fem::CellType::hex27, fem::CellType::tet4,
                                         fem::CellType::tet10, fem::CellType::wedge6));

TEST(Info, TellsWhichElementIsWorst) {
  meshgen::BoxOptions o;
  o.divisions = {2, 1, 1};
  MeshData mesh = meshgen::box(o);
  mesh.blocks[0].element_id = {70, 80};
  const double far[] = {9.0, 0.5, 0.5}; // a node of no element
  mesh.x.insert(mesh.x.end(), far, far + 3);
  for (std::size_t n = 0; n < 12; ++n)
    if (mesh.x[3 * n] == 1.0)
      mesh.x[3 * n] = 3.5; // the second element is 3 long
  const MeshInfo i = info(mesh);
  EXPECT_EQ(i.loose_nodes, 1);
  EXPECT_EQ(i.aspect_ratio.id, 80);
  EXPECT_DOUBLE_EQ(i.aspect_ratio.value, 3.0);
  EXPECT_DOUBLE_EQ(i.aspect_ratio.center[0], 2.0);
  EXPECT_DOUBLE_EQ(i.mean_edge, (4 * 0.5 + 8 + 4 * 3 + 8) / 24);
  EXPECT_EQ(i.high[0], 9.0);
  std::swap(mesh.blocks[0].nodes[8], mesh.blocks[0].nodes[12]);
  EXPECT_EQ(info(mesh).scaled_jacobian.id, 80);
  EXPECT_LE(info(mesh).scaled_jacobian.value, 0.0);
}

TEST(Info, OfAMeshWithoutElements) {
  EXPECT_EQ(text(info(MeshData{})), "mesh: 0 nodes, 0 elements in the box (0, 0, 0) to (0, 0, 0)\n"
                                    "  edges: shortest 0, mean 0, longest 0\n");
}

} // namespace
