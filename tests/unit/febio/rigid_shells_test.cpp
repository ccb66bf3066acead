// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio;
using namespace abut::febio::test;

namespace {

/// The upper cube is a shell of rigid material instead, over the lower one. `facet`: how the
/// surface lists its face; the shell's own normal is +z.
std::map<std::size_t, std::string> shell(const std::string& facet, const std::string& domain,
                                         const std::string& type = "sliding-facet-on-facet") {
  return {{20, "<Elements type=\"quad4\" name=\"upper\">"},
          {21, "<elem id=\"9\">11,12,13,14</elem></Elements>"},
          {23, "<NodeSet name=\"top\">11,12,13,14</NodeSet>"},
          {25, "<Surface name=\"up_face\"><quad4 id=\"1\">" + facet + "</quad4></Surface>"},
          {29, domain + "</MeshDomains>"},
          {33, "</Boundary><Rigid><rigid_bc type=\"rigid_displacement\"><rb>2</rb>"},
          {34, "<dof>z</dof><value lc=\"1\">-0.1</value></rigid_bc>"},
          {35, "<rigid_bc type=\"rigid_fixed\"><rb>plate</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof>"
               "<Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc></Rigid>"},
          {36, ""},
          {38, "<Contact><contact name=\"touch\" surface_pair=\"pair\" type=\"" + type + "\">"}};
}

const std::string rigid = "<ShellDomain name=\"upper\" mat=\"plate\" type=\"rigid-shell\">"
                          "<shell_thickness>0.5</shell_thickness></ShellDomain>";

// The cell stands behind the face as the surface lists it: four face sizes above the plane here.
TEST(RigidShells, StandBehindTheirFaces) {
  const Scene scene = scene_with(shell("14,13,12,11", rigid));
  ASSERT_EQ(scene.mesh.blocks[1].type, fem::CellType::hex8);
  EXPECT_EQ(scene.mesh.blocks[1].element_id, std::vector<Global>{9});
  ASSERT_EQ(scene.mesh.node_id.size(), 16u);
  EXPECT_EQ(scene.mesh.node_id.back(), 103); // nodes 100 to 103 are new
  for (std::size_t n = 12; n < 16; ++n)
    EXPECT_DOUBLE_EQ(scene.mesh.x[3 * n + 2], 5.0);
  const mesh::SideData side = scene.mesh.side_sets.at("up_face").at(0);
  EXPECT_EQ(side.block, 1);
  EXPECT_EQ(side.side, 5);
  EXPECT_NE(section(scene.deck, "bodies").find("blocks: [upper]"), std::string::npos);
  EXPECT_NE(section(scene.deck, "bodies").find("displacement: [0, 0, -0.1]"), std::string::npos);
}

TEST(RigidShells, LieOnTheOtherSideWhereTheSurfaceIsTurned) {
  // Refused as contact: it would be inside; the cell is below the plane.
  const auto changes = shell("11,12,13,14", rigid);
  const Scene scene = scene_with(changes);
  for (std::size_t n = 12; n < 16; ++n)
    EXPECT_DOUBLE_EQ(scene.mesh.x[3 * n + 2], -3.0);
}

TEST(RigidShells, BothSidesMayTouch) {
  auto changes = shell("14,13,12,11", rigid);
  changes[25] += "<Surface name=\"above\"><quad4 id=\"1\">11,12,13,14</quad4></Surface>";
  const Scene scene = scene_with(changes);
  EXPECT_EQ(scene.mesh.blocks[1].element_id, (std::vector<Global>{9, 10}));
  const auto& below = scene.mesh.side_sets.at("up_face").at(0);
  const auto& above = scene.mesh.side_sets.at("above").at(0);
  EXPECT_NE(below.element, above.element);
}

TEST(RigidShells, TrianglesBecomeWedges) {
  auto changes = shell("14,13,12,11", rigid);
  changes[20] = "<Elements type=\"tri3\" name=\"upper\">";
  changes[21] = "<elem id=\"9\">11,12,13</elem><elem id=\"10\">11,13,14</elem></Elements>";
  changes[25] = "<Surface name=\"up_face\"><tri3 id=\"1\">13,12,11</tri3>"
                "<tri3 id=\"2\">14,13,11</tri3></Surface>";
  const Scene scene = scene_with(changes);
  EXPECT_EQ(scene.mesh.blocks[1].type, fem::CellType::wedge6);
  EXPECT_EQ(scene.mesh.side_sets.at("up_face").size(), 2u);
}

// FEBio's A / V of a shell is one over its thickness: 1 / 0.5, times E of the rigid material, 1.
TEST(RigidShells, HaveTheAutomaticPenaltyOfTheirThickness) {
  auto changes = shell("14,13,12,11", rigid);
  changes[26] = "<SurfacePair name=\"pair\"><primary>up_face</primary>";
  changes[27] = "<secondary>low face</secondary></SurfacePair></Mesh>";
  changes[41] = "<auto_penalty>1</auto_penalty>";
  EXPECT_NE(section(scene_with(changes).deck, "contact").find("penalty: 10  # FEBio: 5, from the"),
            std::string::npos);
  changes[29] = "<ShellDomain name=\"upper\" mat=\"plate\"/></MeshDomains><MeshData><ElementData "
                "type=\"shell thickness\" elem_set=\"upper\"><e lid=\"1\">0.1,0.1,0.1,0.1</e>"
                "</ElementData></MeshData>";
  EXPECT_NE(section(scene_with(changes).deck, "contact").find("penalty: 50  # FEBio: 5, from the"),
            std::string::npos);
}

TEST(RigidShells, ThatBendAreRefused) {
  EXPECT_EQ(error_with(shell("14,13,12,11", "<ShellDomain name=\"upper\" mat=\"soft one\"/>"))
                .substr(0, 96),
            "m.feb:29: MeshDomains/ShellDomain 'upper': abut has shells of rigid material alone: "
            "extrude it t");
  EXPECT_EQ(error_with(shell("14,13,12,11", "<SolidDomain name=\"upper\" mat=\"soft one\"/>")),
            "m.feb:29: MeshDomains/SolidDomain 'upper': its elements are shells: expected "
            "<ShellDomain>");
  auto free = shell("14,13,12,11", rigid);
  free[3] = "<Control><analysis>DYNAMIC</analysis><time_steps>4</time_steps><step_size>0.5"
            "</step_size></Control>";
  free[35] = "</Rigid>";
  EXPECT_NE(error_with(free).find("a free rigid body of shells with inertia"), std::string::npos);
}

} // namespace
