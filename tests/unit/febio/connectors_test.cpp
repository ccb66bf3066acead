// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio::test;

namespace {

const std::string bodies = "<body_a>base</body_a><body_b>plate</body_b>";

/// The upper cube is the rigid body `plate`, the nodes below the lower one move with `base`.
std::map<std::size_t, std::string> with_rigid(const std::string& section) {
  return {{7, "<material id=\"3\" name=\"base\" type=\"rigid body\"/></Material>"},
          {29, "<SolidDomain name=\"upper\" mat=\"plate\"/></MeshDomains>"},
          {31, "<bc name=\"hold\" node_set=\"bottom\" type=\"rigid\"><rb>base</rb></bc>"},
          {32, ""},
          {33, ""},
          {34, ""},
          {36, "<Rigid>" + section + "</Rigid>"},
          {44, "<points><pt>0,0</pt><pt>2,1</pt></points></load_controller><load_controller "
               "id=\"2\" name=\"LC2\" type=\"loadcurve\"><points><pt>0,1</pt><pt>2,3</pt></points>"
               "</load_controller></LoadData>"}};
}

std::string connector(const std::string& type, const std::string& inside) {
  return "<rigid_connector name=\"it\" type=\"" + type + "\">" + bodies + inside +
         "</rigid_connector>";
}

std::string joints(const std::string& type, const std::string& inside) {
  const std::string deck = scene_with(with_rigid(connector(type, inside))).deck;
  const std::size_t first = deck.find("joints:\n");
  return deck.substr(first + 8, deck.find("\n", first + 8) - first - 8);
}

std::string message(const std::string& type, const std::string& inside) {
  return error_with(with_rigid(connector(type, inside)));
}

} // namespace

TEST(Connectors, EachKind) {
  EXPECT_EQ(joints("rigid revolute joint",
                   "<joint_origin>1,2,3</joint_origin><rotation_axis>0,2,0</rotation_axis>"
                   "<transverse_axis>1,0,0</transverse_axis><force_penalty>1e9</force_penalty>"
                   "<laugon>1</laugon><prescribed_rotation>1</prescribed_rotation>"
                   "<rotation lc=\"1\">6.2832</rotation><moment>0</moment>"),
            "  it: {kind: revolute, bodies: [base, plate], origin: [1, 2, 3], axis: [0, 2, 0], "
            "rotation: 6.2832, curve: LC1}");
  // FEBio's moment and force act on body a, abut's on the second; its rotation is not prescribed.
  EXPECT_EQ(joints("rigid revolute joint",
                   "<joint_origin>1,2,3</joint_origin><prescribed_rotation>0</prescribed_rotation>"
                   "<rotation lc=\"1\">6.2832</rotation><moment lc=\"2\">5</moment>"),
            "  it: {kind: revolute, bodies: [base, plate], origin: [1, 2, 3], axis: [0, 0, 1], "
            "moment: -5, load_curve: LC2}");
  EXPECT_EQ(joints("rigid prismatic joint", "<joint_origin>0,0,0</joint_origin>"
                                            "<prescribed_translation>1</prescribed_translation>"
                                            "<translation>0.5</translation>"),
            "  it: {kind: prismatic, bodies: [base, plate], origin: [0, 0, 0], axis: [1, 0, 0], "
            "translation: 0.5, curve: constant}");
  EXPECT_EQ(joints("rigid cylindrical joint",
                   "<joint_origin>0,0,0</joint_origin><joint_axis>0,0,1</joint_axis>"
                   "<prescribed_translation>1</prescribed_translation>"
                   "<translation lc=\"2\">0.5</translation><moment lc=\"1\">2</moment>"),
            "  it: {kind: cylindrical, bodies: [base, plate], origin: [0, 0, 0], axis: [0, 0, 1], "
            "translation: 0.5, curve: LC2, moment: -2, load_curve: LC1}");
  EXPECT_EQ(joints("rigid spherical joint",
                   "<joint_origin>0,0,1</joint_origin><moment_x>0</moment_x>"
                   "<rotation_x lc=\"1\">1</rotation_x>"),
            "  it: {kind: spherical, bodies: [base, plate], origin: [0, 0, 1]}");
  EXPECT_EQ(joints("rigid spherical joint",
                   "<joint_origin>0,0,1</joint_origin><prescribed_rotation>1</prescribed_rotation>"
                   "<rotation_x lc=\"1\">1</rotation_x><rotation_z lc=\"1\">-2</rotation_z>"),
            "  it: {kind: spherical, bodies: [base, plate], origin: [0, 0, 1], rotation_vector: "
            "[1, 0, -2], curve: LC1}");
  EXPECT_EQ(joints("rigid spherical joint",
                   "<joint_origin>0,0,1</joint_origin><moment_y lc=\"2\">3</moment_y>"),
            "  it: {kind: spherical, bodies: [base, plate], origin: [0, 0, 1], moment_vector: "
            "[0, -3, 0], load_curve: LC2}");
  EXPECT_EQ(joints("rigid lock", "<joint_origin>0,0,1</joint_origin><first_axis>1,0,0</first_axis>"
                                 "<second_axis>0,1,0</second_axis>"),
            "  it: {kind: lock, bodies: [base, plate], origin: [0, 0, 1]}");
  EXPECT_EQ(joints("rigid spring", "<k>10</k><insertion_a>0,0,0</insertion_a>"
                                   "<insertion_b>0,0,2</insertion_b><free_length>0</free_length>"),
            "  it: {kind: spring, bodies: [base, plate], from: [0, 0, 0], to: [0, 0, 2], "
            "stiffness: 10}");
}

TEST(Connectors, ABodyThatOnlyAJointHoldsIsABody) {
  const std::string deck =
      scene_with(with_rigid(connector("rigid lock", "<joint_origin>0,0,1</joint_origin>"))).deck;
  EXPECT_NE(deck.find("  base:\n    node_sets: [bottom]\n"), std::string::npos) << deck;
}

TEST(Connectors, WhatIsWrongOrMissingIsNamed) {
  const std::string origin = "<joint_origin>0,0,0</joint_origin>";
  const auto expect = [](const std::string& found, const std::string& part) {
    EXPECT_NE(found.find(part), std::string::npos) << found;
    EXPECT_NE(found.find("m.feb:36"), std::string::npos) << found;
  };
  expect(message("rigid damper", origin), "type 'rigid damper': abut has rigid revolute joint");
  expect(message("rigid revolute joint", ""), "joint_origin");
  expect(message("rigid revolute joint", origin + "<rotation_axis>0,0,0</rotation_axis>"),
         "<rotation_axis>: expected a direction, got zero");
  expect(message("rigid revolute joint",
                 origin + "<prescribed_rotation>1</prescribed_rotation><moment>1</moment>"),
         "<rotation> and <moment> cannot both be prescribed");
  expect(message("rigid spherical joint",
                 origin + "<prescribed_rotation>1</prescribed_rotation><moment_y>1</moment_y>"),
         "<prescribed_rotation> and <moment_y> cannot both be given");
  expect(message("rigid spherical joint",
                 origin + "<moment_x lc=\"1\">1</moment_x><moment_y lc=\"2\">1</moment_y>"),
         "its components follow different load curves");
  expect(message("rigid cylindrical joint",
                 origin + "<joint_axis>0,0,1</joint_axis><force lc=\"1\">1</force>"
                          "<moment lc=\"2\">1</moment>"),
         "follow different load curves");
  expect(message("rigid spring", "<k>0</k><insertion_a>0,0,0</insertion_a>"
                                 "<insertion_b>0,0,2</insertion_b>"),
         "<k>: expected a number > 0");
  expect(error_with(with_rigid("<rigid_connector type=\"rigid lock\"><body_a>plate</body_a>"
                               "<body_b>plate</body_b>" +
                               origin + "</rigid_connector>")),
         "connects 'plate' with itself");
  expect(error_with(with_rigid("<rigid_connector type=\"rigid lock\"><body_a>plate</body_a>"
                               "<body_b>plat</body_b>" +
                               origin + "</rigid_connector>")),
         "there is no material 'plat'");
}

TEST(Connectors, LoadsOfABodyMayFollowTheirOwnCurves) {
  const std::string deck =
      scene_with(with_rigid("<rigid_load type=\"rigid_force\"><rb>plate</rb><dof>Rx</dof>"
                            "<value lc=\"1\">7</value></rigid_load>"
                            "<rigid_load type=\"rigid_moment\"><rb>plate</rb><dof>Rw</dof>"
                            "<value lc=\"2\">3</value></rigid_load>"))
          .deck;
  EXPECT_NE(deck.find("force: [7, 0, 0], moment: [0, 0, 3], load_curves: {x: LC1, rz: LC2}}"),
            std::string::npos)
      << deck;
}
