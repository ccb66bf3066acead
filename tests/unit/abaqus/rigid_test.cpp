// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/measure.hpp"
#include "abut/mesh/sides.hpp"
#include "two_cubes.hpp"

using namespace abut;
using namespace abut::abaqus_test;
using ::testing::HasSubstr;

namespace {

/// The upper cube is rigid: nodes 11 to 18, reference node 99 above it.
const std::string rigid = with(with(with(two_cubes, "*ELSET, ELSET=BOTH\nLOWER, UPPER",
                                         "*NODE\n99, .5, .5, 3.\n*ELSET, ELSET=BOTH\nLOWER"),
                                    "HEAD, 1, 2", "99, 1, 2\n99, 4, 6"),
                               "HEAD, 3, 3", "99, 3, 3") +
                          "";

std::string with_body(const std::string& text, const std::string& line) {
  return with(text, "*STEP\n", line + "*STEP\n");
}

TEST(AbaqusRigid, TheReferenceNodeMovesTheBody) {
  const abaqus::Scene s = scene_of(with_body(rigid, "*RIGID BODY, REF NODE=99, ELSET=UPPER\n"));
  expect_line(s.deck, "  UPPER:\n    blocks: [UPPER]\n"
                      "    rigid: {displacement: [0, 0, -0.01], center: [0.5, 0.5, 3]}");
  EXPECT_EQ(s.mesh.num_nodes(), 16); // without node 99
}

TEST(AbaqusRigid, WhatNothingPrescribesIsFree) {
  const std::string text = with(with(rigid, "99, 3, 3, -.01", "FOOT, 1"), "*END STEP",
                                "*CLOAD\n99, 3, -7.\n99, 5, 2.\n*END STEP");
  const std::string deck = scene_of(with_body(with(text, "99, 4, 6", "99, 4"),
                                              "*RIGID BODY, REF NODE=99, ELSET=UPPER\n"))
                               .deck;
  expect_line(deck, "    rigid: {center: [0.5, 0.5, 3], free: [z, ry, rz], force: [0, 0, -7], "
                    "moment: [0, 2, 0]}");
}

TEST(AbaqusRigid, ACouplingIsARigidBodyOfNodes) {
  const std::string coupled = with(
      with_body(
          with(rigid, "LOWER\n*SURFACE", "LOWER, UPPER\n*SURFACE, NAME=TOP\nUPPER, S2\n*SURFACE"),
          "*COUPLING, CONSTRAINT NAME=grip, REF NODE=99, SURFACE=TOP\n*KINEMATIC\n1, 6\n"),
      "FOOT, 1, 3", "FOOT, 1, 3");
  const abaqus::Scene s = scene_of(coupled);
  expect_line(s.deck, "  grip:\n    node_sets: [HEAD]\n"
                      "    rigid: {displacement: [0, 0, -0.01], center: [0.5, 0.5, 3]}");
  EXPECT_THAT(error_of(with(coupled, "*KINEMATIC\n1, 6", "*KINEMATIC\n1, 2")),
              HasSubstr("abut couples all of x, y and z"));
  EXPECT_THAT(error_of(with(coupled, "*KINEMATIC\n1, 6", "*DISTRIBUTING")),
              HasSubstr("abut has *KINEMATIC below *COUPLING"));
}

/// A square of four facets at z = 1, and one triangle, that look down or up.
TEST(AbaqusRigid, FacetsBecomeSolidsBehindTheSideThatTouches) {
  const std::string facets = R"(*NODE
21, 0., 0., 1.
22, 2., 0., 1.
23, 2., 2., 1.
24, 0., 2., 1.
25, 4., 1., 1.
*ELEMENT, TYPE=R3D4, ELSET=PLATE
21, 21, 22, 23, 24
*ELEMENT, TYPE=R3D3, ELSET=PLATE
22, 22, 25, 23
*RIGID BODY, REF NODE=21, ELSET=PLATE
*SURFACE, NAME=TOUCH
PLATE, SNEG
)";
  for (const bool up : {false, true}) {
    const std::string text =
        with(with(with(two_cubes, "*MATERIAL", facets + "*MATERIAL"), "SNEG", up ? "SPOS" : "SNEG"),
             "SOLE, LID", "LID, TOUCH");
    const abaqus::Scene s = scene_of(text);
    const auto& sides = s.mesh.side_sets.at("TOUCH");
    ASSERT_EQ(sides.size(), 2u);
    double volume = 0.0;
    for (const mesh::SideData& side : sides) {
      const std::vector<Vec3> x = mesh::side_points(s.mesh, side);
      const Vec3 normal = cross(x[1] - x[0], x[2] - x[0]);
      EXPECT_EQ(normal[2] > 0.0, up);
      for (const Vec3& p : x)
        EXPECT_EQ(p[2], 1.0);
      const mesh::BlockData& block = s.mesh.blocks[std::size_t(side.block)];
      Vec3 nodes[8];
      for (std::size_t a = 0; a < block.nodes.size(); ++a)
        for (int i = 0; i < 3; ++i)
          nodes[a][i] = s.mesh.x[3 * std::size_t(block.nodes[a]) + std::size_t(i)];
      volume += fem::measure_cell(block.type, nodes).volume;
    }
    EXPECT_GT(volume, 0.0);
    expect_line(s.deck, "    blocks: [PLATE_HEX8, PLATE_WEDGE6]");
    expect_line(s.deck, "    node_sets: [tied_to_PLATE]");
  }
  EXPECT_THAT(error_of(with(with(two_cubes, "*MATERIAL", facets + "*MATERIAL"), "SNEG",
                            "SNEG\nPLATE, SPOS")),
              HasSubstr("both sides of its facets"));
}

} // namespace
