// SPDX-License-Identifier: BSD-3-Clause
#include "old_versions.hpp"
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio;
using namespace abut::febio::test;

namespace {

Scene scene_of(const std::string& text) {
  return import(text, "m.feb", "m");
}

bool same_mesh(const mesh::MeshData& a, const mesh::MeshData& b) {
  if (a.x != b.x || a.node_id != b.node_id || a.node_sets != b.node_sets ||
      a.blocks.size() != b.blocks.size() || a.side_sets.size() != b.side_sets.size())
    return false;
  for (std::size_t i = 0; i < a.blocks.size(); ++i)
    if (a.blocks[i].name != b.blocks[i].name || a.blocks[i].nodes != b.blocks[i].nodes ||
        a.blocks[i].element_id != b.blocks[i].element_id)
      return false;
  for (const auto& [name, sides] : a.side_sets) {
    const auto other = b.side_sets.find(name);
    if (other == b.side_sets.end() || other->second.size() != sides.size())
      return false;
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (other->second[i].block != sides[i].block || other->second[i].side != sides[i].side ||
          other->second[i].element != sides[i].element)
        return false;
  }
  return true;
}

TEST(Versions, OneModelInTheWordsOfEach) {
  const Scene now = scene_of(model_4_0());
  EXPECT_NE(now.deck.find("fix: [x, y, z]"), std::string::npos) << now.deck;
  EXPECT_NE(now.deck.find("penalty_factor: 5"), std::string::npos) << now.deck;
  EXPECT_NE(now.deck.find("pressure: 0.3"), std::string::npos) << now.deck;
  EXPECT_NE(now.deck.find("free: [y]"), std::string::npos) << now.deck;
  for (const auto& [version, text] :
       {std::pair("3.0", model_3_0()), {"2.5", model_2_5()}, {"2.0", model_2_0()}}) {
    const Scene old = scene_of(text);
    EXPECT_EQ(old.deck, now.deck) << version;
    EXPECT_TRUE(same_mesh(old.mesh, now.mesh)) << version;
    EXPECT_EQ(old.report.count(Fate::refused), 0) << version;
  }
}

TEST(Versions, OthersAreRefused) {
  EXPECT_EQ(error_with({{2, "<febio_spec version=\"1.2\"><Module type=\"solid\"/>"}}),
            "m.feb:2: <febio_spec>: version '1.2': expected a file of version 2.0, 2.5, 3.0 or "
            "4.0");
  EXPECT_EQ(error_of("<febio_spec><Module type=\"solid\"/></febio_spec>"),
            "m.feb:1: <febio_spec>: expected an attribute 'version'");
  EXPECT_NE(error_of(replaced(model_2_5(), "<LoadData>", "<Include>more.feb</Include><LoadData>"))
                .find("<Include>: its content is in another file: put it in here"),
            std::string::npos);
  EXPECT_NE(error_of(replaced(model_2_0(), "<Geometry>", "<Geometry from=\"mesh.feb\">"))
                .find("<Geometry>: its content is in another file 'mesh.feb': put it in here"),
            std::string::npos);
}

TEST(Versions, MessagesHaveTheLineAndTheWordOfTheFile) {
  // Of a condition that is translated and of what no step knows.
  const std::string old =
      replaced(model_2_5(), "bc=\"x\" node_set=\"top\"", "bc=\"p\" node_set=\"top\"");
  const std::size_t at = old.find("<prescribe");
  const auto line =
      std::to_string(1 + std::count(old.begin(), old.begin() + std::ptrdiff_t(at), '\n'));
  EXPECT_EQ(error_of(old), "m.feb:" + line +
                               ": Boundary/prescribe 'shear': degree of freedom 'p': abut has x, y "
                               "and z");
  const std::string more =
      replaced(model_2_5(), "<prescribe", "<linear_constraint node=\"1\" bc=\"x\"/>\n<prescribe");
  EXPECT_EQ(error_of(more), "m.feb:" + line + ": Boundary/linear_constraint: not supported here");
  EXPECT_NE(error_of(replaced(model_2_0(), "bc=\"xyz\"", "bc=\"xyz\" color=\"red\""))
                .find("Boundary/fix: attribute 'color' is not supported here"),
            std::string::npos);
  EXPECT_NE(error_of(replaced(model_2_5(), "mat=\"1\"", "mat=\"5\""))
                .find("<Elements>: there is no material '5'; valid: soft one, plate"),
            std::string::npos);
}

TEST(Versions, NodeListsOf20BecomeSets) {
  const std::string text =
      replaced(replaced(model_2_0(), "<fix name=\"hold\" bc=\"xyz\" set=\"bottom\"/>",
                        "<fix bc=\"x\"><node id=\"1\"/><node id=\"2\"/></fix>"
                        "<fix bc=\"yz\"><node id=\"3\"/></fix>"),
               "<prescribe name=\"shear\" bc=\"x\" lc=\"1\" set=\"top\">0.1</prescribe>",
               "<prescribe bc=\"z\" lc=\"1\" scale=\"0.5\"><node id=\"5\">1</node>"
               "<node id=\"6\">-0.2</node><node id=\"7\">1</node></prescribe>");
  const Scene scene = scene_of(text);
  EXPECT_EQ(section(scene.deck, "displacements"),
            "displacements:\n"
            "  fixed: {set: fixed, fix: [x]}\n"
            "  fixed_2: {set: fixed_2, fix: [y, z]}\n"
            "  moved: {set: prescribed, z: 0.5, curve: LC1}\n"
            "  moved_2: {set: prescribed_2, z: -0.1, curve: LC1}\n");
  EXPECT_EQ(scene.mesh.node_sets.at("prescribed"), (std::vector<Global>{4, 6}));
  EXPECT_EQ(scene.mesh.node_sets.at("prescribed_2"), (std::vector<Global>{5}));
}

TEST(Versions, FacesAndRigidNodesOf20) {
  const std::string faces = replaced(
      replaced(model_2_0(), in_old_words("<surface type=\"SECONDARY\" set=\"up_face\"/>"),
               in_old_words(
                   "<surface type=\"SECONDARY\"><quad4 id=\"1\">14,13,12,11</quad4></surface>")),
      "</contact></Contact>",
      "</contact><contact type=\"rigid\"><node id=\"1\" rb=\"2\"/><node id=\"2\" "
      "rb=\"2\"/></contact></Contact>");
  const Scene scene =
      scene_of(replaced(faces, "<fix name=\"hold\" bc=\"xyz\" set=\"bottom\"/>", ""));
  EXPECT_EQ(scene.mesh.side_sets.at(in_old_words("touch_SECONDARY")).size(), 1u);
  EXPECT_NE(section(scene.deck, "contact").find(in_old_words("secondary: touch_SECONDARY")),
            std::string::npos);
  EXPECT_NE(section(scene.deck, "bodies").find("node_sets: [rigid]"), std::string::npos)
      << scene.deck;
  EXPECT_EQ(scene.mesh.node_sets.at("rigid"), (std::vector<Global>{0, 1}));
}

TEST(Versions, StepsOf25AreStepsOf40) {
  const auto steps = [](const std::string& first, const std::string& second) {
    const std::string control = "<Control><time_steps>2</time_steps><step_size>0.5</step_size>"
                                "</Control>";
    return std::pair(control + first, control + second);
  };
  const std::string old_fix = "<Boundary><fix name=\"a\" bc=\"z\" node_set=\"top\"/></Boundary>",
                    new_fix = "<Boundary><bc name=\"a\" type=\"zero displacement\" "
                              "node_set=\"top\"><z_dof>1</z_dof></bc></Boundary>";
  const auto [a, b] = steps(old_fix, "");
  const auto [c, d] = steps(new_fix, "");
  const std::string old =
      replaced(replaced(model_2_5(), old_control(), ""), "<LoadData>",
               "<Step name=\"one\">" + a + "</Step><Step name=\"two\">" + b + "</Step><LoadData>");
  const std::string four = model_4_0();
  const std::size_t begin = four.find("<Control>"), end = four.find("</Control>") + 10;
  const std::string now =
      replaced(replaced(four, four.substr(begin, end - begin), ""), "<LoadData>",
               "<Step><step name=\"one\">" + c + "</step><step name=\"two\">" + d +
                   "</step></Step><LoadData>");
  EXPECT_EQ(scene_of(old).deck, scene_of(now).deck);
  EXPECT_NE(scene_of(old).deck.find("until: 1"), std::string::npos);
}

// Curve 1 has points at 0, 1, 2: steps of 0.75 must be finer to meet 1.
TEST(Versions, MustPointsNeedNoNumber) {
  const std::string coarse = replaced(replaced(model_2_5(), "<time_steps>4", "<time_steps>2"),
                                      "<step_size>0.5", "<step_size>0.75");
  EXPECT_NE(scene_of(coarse).deck.find("steps: 2}"), std::string::npos);
  EXPECT_NE(scene_of(replaced(coarse, "<max_refs>",
                              "<time_stepper><dtmax lc=\"1\"></dtmax></time_stepper><max_refs>"))
                .deck.find("steps: 6}"),
            std::string::npos);
}

TEST(Versions, DataOfNodesAreRefused) {
  EXPECT_NE(error_of(replaced(model_2_5(), "<value>0.1</value>", "<value node_data=\"d\"/>"))
                .find("Boundary/prescribe/value: data of each node: abut has one value for all "
                      "nodes of a set"),
            std::string::npos);
  EXPECT_NE(
      error_of(replaced(model_2_5(), "<scale lc=\"1\">1</scale>", "<scale lc=\"1\">2</scale>"))
          .find("both <scale> and <value> are other than 1"),
      std::string::npos);
}

TEST(Versions, DynamicsOf25) {
  const std::string text =
      replaced(replaced(model_2_5(), "type=\"static\"", "type=\"dynamic\""), "<Loads>",
               "<Initial><init bc=\"vx\" node_set=\"all\"><value>2</value></init><init bc=\"vz\" "
               "node_set=\"all\"><value>-1</value></init></Initial><Loads>");
  const std::string deck = scene_of(text).deck;
  EXPECT_NE(deck.find("initial_velocity: [2, 0, -1]"), std::string::npos) << deck;
  EXPECT_NE(deck.find("dynamics:"), std::string::npos);
}

TEST(Versions, VelocitiesOfRigidBodies) {
  const std::string moving = replaced(replaced(model_2_5(), "type=\"static\"", "type=\"dynamic\""),
                                      "<force bc=\"y\" lc=\"1\">0.5</force>",
                                      "<initial_velocity>0,3,0</initial_velocity>");
  const std::string expected = "initial_velocity: [0, 3, 0]";
  EXPECT_NE(section(scene_of(moving).deck, "bodies").find(expected), std::string::npos);
  const std::string apart =
      replaced(replaced(moving, "<initial_velocity>0,3,0</initial_velocity>", ""), "<Loads>",
               "<Initial><rigid_body mat=\"2\"><initial_velocity>0,3,0</initial_velocity>"
               "</rigid_body></Initial><Loads>");
  EXPECT_EQ(scene_of(apart).deck, scene_of(moving).deck);
}

TEST(Versions, RotationsChangeTheirWord) {
  const std::string turned = replaced(model_2_5(), "<prescribed bc=\"z\" lc=\"2\">-0.2",
                                      "<prescribed bc=\"Rx\" lc=\"2\" type=\"relative\">0.7");
  const std::string deck =
      scene_of(replaced(turned, "<fixed bc=\"Rx\"/>", "<fixed bc=\"z\"/>")).deck;
  EXPECT_NE(section(deck, "bodies").find("rotation: [0.7, 0, 0]"), std::string::npos) << deck;
  EXPECT_NE(error_of(replaced(turned, "bc=\"Rx\" lc", "bc=\"Ru\" lc"))
                .find("<prescribed>: expected x, y, z, Rx, Ry or Rz as bc, got 'Ru'"),
            std::string::npos);
}

// The plate as a rigid sheet whose thickness counts for its weight alone.
TEST(Versions, RigidShellsAndTheirThickness) {
  const auto sheet = [](const std::string& text, const std::string& attributes,
                        const std::string& before, const std::string& data) {
    const std::string solid = "<Elements type=\"hex8\" " + attributes +
                              "><elem id=\"9\">11,12,13,14,15,16,17,18</elem>",
                      shell = "<Elements type=\"quad4\" " + attributes +
                              "><elem id=\"9\">11,12,13,14</elem>";
    return replaced(replaced(text, solid, shell), before, data + before);
  };
  const std::string data = "<ElementData var=\"shell thickness\" elem_set=\"upper\"><elem "
                           "lid=\"1\">0.1,0.1,0.1,0.1</elem></ElementData>";
  const Scene newer = scene_of(sheet(model_2_5(), "name=\"upper\" mat=\"plate\"", "<Boundary>",
                                     "<MeshData>" + data + "</MeshData>"));
  const Scene older =
      scene_of(sheet(model_2_0(), "elset=\"upper\" mat=\"2\"", "</Geometry>",
                     "<ElementData><element id=\"9\"><thickness>0.1,0.1,0.1,0.1</thickness>"
                     "</element></ElementData>"));
  EXPECT_EQ(newer.deck, older.deck);
  EXPECT_TRUE(same_mesh(newer.mesh, older.mesh));
  EXPECT_NE(newer.deck.find("free: [y]"), std::string::npos) << newer.deck;
  const std::string fibers = sheet(model_2_0(), "elset=\"upper\" mat=\"2\"", "</Geometry>",
                                   "<ElementData><element id=\"7\"><fiber>1,0,0</fiber></element>"
                                   "</ElementData>");
  EXPECT_NE(error_of(fibers).find("Geometry/ElementData: not supported here"), std::string::npos);
}

TEST(Versions, WallsAndJointsHaveMoved) {
  const std::string wall =
      replaced(model_2_5(), "</contact></Contact>",
               "</contact><contact name=\"wall\" type=\"rigid_wall\" surface=\"low face\">"
               "<penalty>3</penalty><plane>0,0,-1,-2</plane></contact></Contact>");
  EXPECT_NE(section(scene_of(wall).deck, "contact").find("secondary: wall"), std::string::npos);
  const std::string joint =
      replaced(replaced(model_2_5(), "</Material>",
                        "<material id=\"3\" name=\"other\" type=\"rigid body\"/></Material>"),
               "<Loads>",
               "<Constraints><constraint name=\"pin\" type=\"rigid revolute joint\">"
               "<body_a>2</body_a><body_b>3</body_b><joint_origin>0,0,2</joint_origin>"
               "</constraint></Constraints><Loads>");
  const std::string deck = scene_of(replaced(joint, "<fix name=\"hold\"",
                                             "<rigid rb=\"3\" node_set=\"bottom\"/><fix "
                                             "name=\"hold\""))
                               .deck;
  EXPECT_NE(section(deck, "joints").find("pin:"), std::string::npos) << deck;
}

TEST(Versions, OtherTypesOfOldContact) {
  const auto formulation = [](const std::string& type) {
    return section(
        scene_of(replaced(model_2_5(), "type=\"sliding-facet-on-facet\"", "type=\"" + type + "\""))
            .deck,
        "contact");
  };
  EXPECT_NE(formulation("sliding_with_gaps").find("formulation: node_on_facet"), std::string::npos);
  EXPECT_NE(formulation("sliding-tension-compression").find("formulation: sliding_elastic"),
            std::string::npos);
}

} // namespace
