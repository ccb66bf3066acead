// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/select_sides.hpp"
#include "abut/mesh/sides.hpp"
#include "abut/meshgen/generators.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::mesh;

namespace {

std::vector<SideData> sorted(std::vector<SideData> sides) {
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::vector<SideData> outer(const MeshData& mesh) {
  return SideIndex(mesh).outer();
}

MeshData box(fem::CellType type) {
  meshgen::BoxOptions o;
  o.divisions = {3, 2, 2};
  o.element = type;
  return meshgen::box(o);
}

MeshData rings(fem::CellType type) {
  meshgen::RingsOptions o;
  o.element = type;
  o.gap = 0.1;
  return meshgen::rings(o);
}

class EveryCell : public testing::TestWithParam<fem::CellType> {};

TEST_P(EveryCell, SkinOfABoxIsItsSixFaces) {
  const MeshData mesh = box(GetParam());
  std::vector<SideData> all;
  for (const char* name : {"x0", "x1", "y0", "y1", "z0", "z1"})
    all.insert(all.end(), mesh.side_sets.at(name).begin(), mesh.side_sets.at(name).end());
  EXPECT_EQ(outer(mesh), sorted(all));
}

TEST_P(EveryCell, PlaneNormalAndBoxFindAFace) {
  const MeshData mesh = box(GetParam());
  const std::vector<SideData> top = sorted(mesh.side_sets.at("z1"));
  FaceSelection plane, normal, within, set;
  plane.plane = PlaneOptions{{5.0, 5.0, 1.0}, {0.0, 0.0, -3.0}};
  normal.normal = NormalOptions{{0.0, 0.0, 2.0}, 0.0};
  within.box = BoxOptions{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}};
  set.node_set = "z1";
  for (const FaceSelection& selection : {plane, normal, within, set})
    EXPECT_EQ(select_sides(mesh, outer(mesh), selection).sides, top);
}

TEST_P(EveryCell, CylinderFindsCurvedFaces) {
  const MeshData mesh = rings(GetParam());
  FaceSelection bore;
  bore.cylinder = CylinderOptions{{0.0, 0.0, 9.0}, {0.0, 0.0, -1.0}, 1.0};
  EXPECT_EQ(select_sides(mesh, outer(mesh), bore).sides, sorted(mesh.side_sets.at("inner_inner")));
}

INSTANTIATE_TEST_SUITE_P(Cells, EveryCell,
                         testing::Values(fem::CellType::hex8, fem::CellType::hex20,
                                         fem::CellType::hex27, fem::CellType::tet4,
                                         fem::CellType::tet10, fem::CellType::wedge6));

TEST(SelectSides, CornersOfANodeSetAreEnough) {
  MeshData mesh = box(fem::CellType::hex20);
  std::vector<Global> corners;
  for (const SideData& side : mesh.side_sets.at("x1"))
    for (int a = 0; a < 4; ++a)
      corners.push_back(side_nodes(mesh, side)[std::size_t(a)]);
  mesh.node_sets["corners"] = corners;
  FaceSelection selection;
  selection.node_set = "corners";
  EXPECT_EQ(select_sides(mesh, outer(mesh), selection).sides, sorted(mesh.side_sets.at("x1")));
}

TEST(SelectSides, SphereFindsCurvedFaces) {
  meshgen::RoundOptions o;
  o.facets = 2;
  o.plate = false;
  const MeshData mesh = meshgen::quarter_sphere(o);
  FaceSelection selection;
  selection.sphere = SphereOptions{{0.0, 0.0, 1.0}, 1.0};
  EXPECT_EQ(select_sides(mesh, outer(mesh), selection).sides, sorted(mesh.side_sets.at("curved")));
}

TEST(SelectSides, NearMeansATwentiethOfTheShortestEdgeOrWhatIsGiven) {
  const MeshData mesh = box(fem::CellType::hex8); // edges of 1/3, 1/2, 1/2
  FaceSelection selection;
  for (const auto& [z, found] : {std::pair{1.02, true}, {1.03, false}}) { // those of z1: 1/60
    selection.plane = PlaneOptions{{0.0, 0.0, z - 0.005}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(!select_sides(mesh, outer(mesh), selection).sides.empty(), found) << z;
  }
  const SelectedSides none = select_sides(mesh, outer(mesh), selection);
  EXPECT_EQ(none.story, ", 0 near the plane (the nearest face keeps within 0.025 of it)");
  selection.within = 0.03;
  EXPECT_EQ(select_sides(mesh, outer(mesh), selection).sides.size(), 6u);
  selection.within = 0.6; // the upper half of the sides, too
  EXPECT_EQ(select_sides(mesh, outer(mesh), selection).sides.size(), 6u + 10u);
}

TEST(SelectSides, AngleOfTheNormalIsThatToTheOutside) {
  const MeshData mesh = rings(fem::CellType::hex8); // 8 faces of inner_outer over 90 degrees
  FaceSelection selection;
  selection.normal = NormalOptions{{1.0, 0.0, 0.0}, 45.0};
  selection.cylinder = CylinderOptions{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 1.5};
  EXPECT_EQ(select_sides(mesh, outer(mesh), selection).sides.size(), 4u);
  selection.normal->direction = {-1.0, 0.0, 0.0};
  EXPECT_EQ(select_sides(mesh, outer(mesh), selection).story,
            ", 8 near the cylinder, 0 with the normal");
}

TEST(SideIndex, FindsASideByItsCornersInAnyOrder) {
  const MeshData mesh = box(fem::CellType::tet10);
  const SideIndex index(mesh);
  for (const SideData& side : mesh.side_sets.at("y0")) {
    const std::vector<Global> nodes = side_nodes(mesh, side);
    const Global turned[] = {nodes[2], nodes[0], nodes[1]};
    EXPECT_EQ(index.find(turned, 3), std::vector<SideData>{side});
  }
  const Global nowhere[] = {0, 1, 2};
  EXPECT_LE(index.find(nowhere, 3).size(), 2u);
  EXPECT_TRUE(index.find(nowhere, 2).empty());
  const std::vector<Global> triangle = side_nodes(mesh, mesh.side_sets.at("y0")[0]);
  const Global quadrangle[] = {-1, triangle[0], triangle[1], triangle[2]};
  EXPECT_TRUE(index.find(quadrangle, 4).empty());
}

} // namespace
