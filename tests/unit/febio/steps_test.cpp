// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut::febio;
using namespace abut::febio::test;

namespace {

std::string control(int count, const std::string& size) {
  return "<Control><time_steps>" + std::to_string(count) + "</time_steps><step_size>" + size +
         "</step_size></Control>";
}

/// The two cubes without Control, pressed by nothing, with two steps of 1 and 0.5 of time.
std::map<std::size_t, std::string> two_steps(const std::string& first, const std::string& second) {
  return {{3, ""},
          {33, ""},
          {34, ""},
          {42, "</contact></Contact>\n<Step><step>" + control(4, "0.25") + first +
                   "</step>\n<step>" + control(5, "0.1") + second + "</step></Step>"},
          {44, "<points><pt>0,0</pt><pt>1,1</pt><pt>2,3</pt></points></load_controller>"
               "<load_controller id=\"2\" name=\"other\" type=\"loadcurve\">"
               "<points><pt>0,1</pt><pt>1,1</pt><pt>1.25,5</pt></points></load_controller>"
               "</LoadData>"}};
}

std::string moved(const std::string& name, const std::string& dof, const std::string& value,
                  const std::string& curve, const std::string& more = "") {
  return "<Boundary><bc name=\"" + name + "\" node_set=\"top\" type=\"prescribed displacement\">" +
         "<dof>" + dof + "</dof><value lc=\"" + curve + "\">" + value + "</value>" + more +
         "</bc></Boundary>";
}

std::string fixed(const std::string& set) {
  return "<Boundary><bc name=\"still\" node_set=\"" + set +
         "\" type=\"zero displacement\"><x_dof>1</x_dof><z_dof>1</z_dof></bc></Boundary>";
}

TEST(Steps, OneAfterTheOtherInOneTime) {
  const std::string deck =
      scene_with(two_steps(moved("a", "z", "-0.1", "1"), moved("b", "z", "-0.2", "2"))).deck;
  // Steps of 0.05: the largest size up to the smallest step_size that meets 1.
  EXPECT_EQ(section(deck, "time"), "time: {end: 1.5, steps: 15}\n");
  EXPECT_EQ(section(deck, "displacements"),
            "displacements:\n"
            "  hold: {set: bottom, fix: [x, y, z]}\n"
            "  a: {set: top, z: 1, curve: LC1_in_step_1_other_in_step_2}  # FEBio: b\n");
  // The jump from -0.1 to -0.2 at 1; other has a corner in the second step, LC1 has none.
  EXPECT_EQ(section(deck, "curves"),
            "curves:\n"
            "  LC1_in_step_1_other_in_step_2: [[0, 0], [1, -0.1], [1.0000000015, -0.2], "
            "[1.25, -1], [1.5, -1]]\n");
}

TEST(Steps, ValuesThatContinueNeedNoJump) {
  const std::string deck =
      scene_with(two_steps(moved("a", "z", "-0.1", "1"), moved("b", "z", "-0.1", "2"))).deck;
  EXPECT_NE(deck.find("z: -0.1, curve: LC1_in_step_1_other_in_step_2"), std::string::npos) << deck;
  EXPECT_NE(deck.find("[[0, 0], [1, 1], [1.25, 5], [1.5, 5]]"), std::string::npos) << deck;
  // The same in both steps is no matter of steps.
  const std::string same =
      scene_with(two_steps(moved("a", "z", "-0.1", "1"), moved("b", "z", "-0.1", "1"))).deck;
  EXPECT_NE(same.find("a: {set: top, z: -0.1, curve: LC1}"), std::string::npos) << same;
}

TEST(Steps, FixedInOneAndMovedInAnother) {
  const std::string second =
      "<Boundary><bc name=\"still\" node_set=\"top\" type=\"zero displacement\"><x_dof>1</x_dof>"
      "</bc><bc name=\"b\" node_set=\"top\" type=\"prescribed displacement\"><dof>z</dof>"
      "<value lc=\"1\">-0.2</value></bc></Boundary>";
  const std::string deck = scene_with(two_steps(fixed("top"), second)).deck;
  EXPECT_EQ(section(deck, "displacements"),
            "displacements:\n"
            "  hold: {set: bottom, fix: [x, y, z]}\n"
            "  still: {set: top, fix: [x]}\n"
            "  still_2: {set: top, z: -0.2, curve: LC1_in_step_2}  # FEBio: still, b\n");
}

TEST(Steps, WhatIsFixedInAllStepsGivesWayToOne) {
  auto changes = two_steps("", moved("b", "z", "-0.2", "1"));
  changes[33] = "<bc name=\"still\" node_set=\"top\" type=\"zero displacement\"><x_dof>1</x_dof>"
                "<z_dof>1</z_dof></bc>";
  const std::string deck = scene_with(changes).deck;
  EXPECT_EQ(section(deck, "displacements"),
            "displacements:\n"
            "  hold: {set: bottom, fix: [x, y, z]}\n"
            "  still: {set: top, fix: [x]}\n"
            "  still_2: {set: top, z: -0.2, curve: LC1_in_step_2}  # FEBio: still, b\n");
  EXPECT_EQ(section(deck, "curves"),
            "curves:\n  LC1_in_step_2: [[0, 0], [1, 0], [1.0000000015, 1], [1.5, 2]]\n");
}

TEST(Steps, DisplacementsOfOneStepHaveAWindow) {
  EXPECT_EQ(section(scene_with(two_steps(moved("a", "z", "-0.1", "1"), "")).deck, "displacements"),
            "displacements:\n"
            "  hold: {set: bottom, fix: [x, y, z]}\n"
            "  a: {set: top, z: -0.1, curve: LC1, until: 1}\n");
  EXPECT_EQ(section(scene_with(two_steps("", fixed("top"))).deck, "displacements"),
            "displacements:\n"
            "  hold: {set: bottom, fix: [x, y, z]}\n"
            "  still: {set: top, fix: [x, z], from: 1}\n");
}

TEST(Steps, RelativeDisplacementsCountFromTheirStep) {
  const std::string relative = "<relative>1</relative>";
  // In the first step, or outside of steps, that is where the model is at rest.
  EXPECT_EQ(section(scene_with(two_steps(moved("a", "z", "-0.1", "1", relative),
                                         moved("b", "z", "-0.2", "2", relative)))
                        .deck,
                    "displacements"),
            "displacements:\n"
            "  hold: {set: bottom, fix: [x, y, z]}\n"
            "  a: {set: top, z: -0.1, curve: LC1, until: 1}\n"
            "  b: {set: top, z: -0.2, curve: other, from: 1, relative: true}\n");
}

TEST(Steps, LoadsActInTheirStepAlone) {
  const std::string load = "<Loads><surface_load name=\"p\" surface=\"up_face\" type=\"pressure\">"
                           "<pressure lc=\"1\">3</pressure></surface_load><nodal_load name=\"n\" "
                           "node_set=\"top\" type=\"nodal_load\"><dof>x</dof><scale>2</scale>"
                           "</nodal_load></Loads>";
  const std::string deck = scene_with(two_steps(load, "")).deck;
  EXPECT_EQ(section(deck, "loads"),
            "loads:\n"
            "  p: {pressure: 3, side_set: up_face, curve: LC1_in_step_1}\n"
            "  n: {force: [2, 0, 0], node_set: top, curve: constant_in_step_1}\n");
  const std::string curves = section(deck, "curves");
  EXPECT_NE(curves.find("LC1_in_step_1: [[0, 0], [1, 1], [1.0000000015, 0], [1.5, 0]]"),
            std::string::npos)
      << curves;
  EXPECT_NE(curves.find("constant_in_step_1: [[0, 1], [1, 1], [1.0000000015, 0], [1.5, 0]]"),
            std::string::npos)
      << curves;
}

std::string contact(const std::string& parameters) {
  return "<Contact><contact name=\"late\" surface_pair=\"pair\" type=\"sliding-elastic\">" +
         parameters + "</contact></Contact>";
}

TEST(Steps, ContactOfOneStepHasAWindow) {
  const auto late = [](const std::string& first, const std::string& second) {
    const std::string deck = scene_with(two_steps(first, second)).deck;
    const std::string text = deck.substr(deck.find("  late:"));
    return text.substr(0, text.find("time:"));
  };
  EXPECT_EQ(late("", contact("<penalty>7</penalty>")),
            "  late:\n    primary: \"low face\"\n    secondary: up_face\n"
            "    formulation: sliding_elastic\n    penalty: 7\n    reach: 1  # FEBio: "
            "search_radius 1\n    from: 1\n");
  EXPECT_EQ(
      late(contact("<penalty lc=\"1\">7</penalty>"), ""),
      "  late:\n    primary: \"low face\"\n    secondary: up_face\n"
      "    formulation: sliding_elastic\n    penalty: 7\n    penalty_curve: LC1\n    reach: 1 "
      " # FEBio: search_radius 1\n    until: 1\n");
  for (const char* kind : {"<laugon>AUGLAG</laugon>", "<fric_coeff>0.3</fric_coeff>"})
    EXPECT_NE(late(contact(kind), "").find("    until: 1\n"), std::string::npos) << kind;
}

std::string pushed(const std::string& dof, const std::string& value, const std::string& curve) {
  return "<rigid_bc name=\"" + dof + "\" type=\"rigid_displacement\"><rb>plate</rb><dof>" + dof +
         "</dof><value lc=\"" + curve + "\">" + value + "</value></rigid_bc>";
}
std::string held(const std::string& components) {
  std::string out = "<rigid_bc name=\"held\" type=\"rigid_fixed\"><rb>plate</rb>";
  for (const char c : components)
    out += std::string("<R") + c + "_dof>1</R" + c + "_dof>";
  return out + "</rigid_bc>";
}

/// The upper cube is a rigid plate.
std::map<std::size_t, std::string> plate_in_steps(const std::string& first,
                                                  const std::string& second) {
  auto changes = two_steps("<Rigid>" + first + "</Rigid>", "<Rigid>" + second + "</Rigid>");
  changes[29] = "<SolidDomain name=\"upper\" mat=\"plate\"/></MeshDomains>";
  return changes;
}

TEST(Steps, RigidBodiesMayFollowACurveForEachComponent) {
  const std::string deck =
      scene_with(plate_in_steps(held("xyuvw") + pushed("z", "-0.2", "1"),
                                held("yuvw") + pushed("z", "-0.2", "2") + pushed("x", "0.5", "1")))
          .deck;
  EXPECT_NE(deck.find("    rigid: {displacement: [0.5, 0, -0.2], curves: {x: LC1_in_step_2, z: "
                      "LC1_in_step_1_other_in_step_2}}\n"),
            std::string::npos)
      << deck;
}

TEST(Steps, ReleasedRigidBodiesAreHeldForATime) {
  const std::string deck = scene_with(plate_in_steps(held("xyzuvw"), held("xyuvw"))).deck;
  EXPECT_NE(deck.find("    rigid:\n      free: [z]\n      holds:\n"
                      "        held: {fix: [z], until: 1}\n"),
            std::string::npos)
      << deck;
}

TEST(Steps, RigidBodiesStopWhereTheyAre) {
  const std::string deck =
      scene_with(plate_in_steps(held("xyuvw") + pushed("z", "-0.2", "1"), held("xyzuvw"))).deck;
  EXPECT_NE(deck.find("      free: [z]\n      holds:\n"
                      "        z: {z: -0.2, curve: LC1, until: 1}\n"
                      "        held: {fix: [z], from: 1, relative: true}\n"),
            std::string::npos)
      << deck;
}

TEST(Steps, EachHasAControl) {
  auto changes = two_steps("", "");
  changes[3] = control(4, "0.5");
  EXPECT_EQ(error_with(changes),
            "m.feb:43: <Control>: a second one; the first is in line 3, outside of the steps");
  changes[3] = "";
  changes[42] = "</contact></Contact><Step><step/><step/></Step>";
  EXPECT_EQ(error_with(changes), "m.feb:42: <step>: expected an element <Control> in it");
}

TEST(Steps, SizesWithoutACommonMeasureAreRefused) {
  auto changes = two_steps("", "");
  changes[42] = "</contact></Contact><Step><step>" + control(3, "0.1234567") + "</step><step>" +
                control(2, "0.1") + "</step></Step>";
  EXPECT_EQ(error_with(changes),
            "m.feb:42: Control: abut's steps have one size, and none above a twentieth of the "
            "smallest step_size meets the ends of all steps: choose sizes that have a common "
            "measure");
}

} // namespace
