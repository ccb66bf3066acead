// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio;
using namespace abut::febio::test;

namespace {

std::string control(const std::string& solver, const std::string& analysis = "DYNAMIC") {
  return "<Control><analysis>" + analysis +
         "</analysis><time_steps>4</time_steps><step_size>0.5</step_size><solver type=\"solid\">" +
         solver + "</solver></Control>";
}

std::string rule(const std::string& solver) {
  return section(scene_with({{3, control(solver)}}).deck, "dynamics");
}

/// The upper cube is rigid and may fall; its load is the body force alone.
std::map<std::size_t, std::string> falling() {
  return {
      {3, control("")},
      {6, "<material id=\"2\" name=\"plate\" type=\"rigid body\"><density>2</density></material>"},
      {29, "<SolidDomain name=\"upper\" mat=\"plate\"/></MeshDomains>"},
      {33, ""},
      {34, ""},
      {36, "<Rigid><rigid_bc name=\"guide\" type=\"rigid_fixed\"><rb>plate</rb><Rx_dof>1</Rx_dof>"
           "<Ry_dof>1</Ry_dof><Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>"
           "</Rigid>"},
      {37, "<Loads><body_load name=\"weight\" type=\"const\"><z>9.81</z></body_load></Loads>"}};
}

} // namespace

TEST(Dynamics, RulesOfTimeIntegration) {
  EXPECT_EQ(rule(""), "dynamics: {}\n");
  EXPECT_EQ(rule("<rhoi>-1</rhoi>"), "dynamics: {}\n");
  EXPECT_EQ(rule("<rhoi>-2</rhoi><alpha>1</alpha><beta>0.25</beta><gamma>0.5</gamma>"),
            "dynamics: {}\n");
  EXPECT_EQ(rule("<rhoi>0.8</rhoi><gamma>0.7</gamma>"), "dynamics: {spectral_radius: 0.8}\n");
  EXPECT_EQ(rule("<rhoi>1</rhoi>"), "dynamics: {}\n");
  EXPECT_EQ(rule("<beta>0.3025</beta><gamma>0.6</gamma><rtol>1e-3</rtol>"),
            "dynamics: {beta: 0.3025, gamma: 0.6}\n");
  EXPECT_EQ(section(scene_with({{3, control("<rhoi>0.8</rhoi>", "STATIC")}}).deck, "dynamics"), "");
}

TEST(Dynamics, DensityAndVelocity) {
  const auto changes = [](const char* analysis, const char* set) {
    return std::map<std::size_t, std::string>{
        {3, control("", analysis)},
        {37,
         std::string("<Loads></Loads><Initial><ic name=\"shot\" type=\"velocity\" node_set=\"") +
             set + "\"><value>0,0.5,-2</value></ic></Initial>"}};
  };
  const std::string deck = scene_with(changes("dynamic", "all")).deck;
  EXPECT_NE(section(deck, "materials").find("{young: 10, poisson: 0.3, density: 1}"),
            std::string::npos);
  for (const char* body : {"  lower: ", "  upper: "})
    EXPECT_NE(section(deck, "bodies").find(body + std::string("{blocks: [") + (body + 2)[0]),
              std::string::npos);
  EXPECT_NE(section(deck, "bodies").find("initial_velocity: [0, 0.5, -2]}"), std::string::npos);
  EXPECT_EQ(scene_with(changes("STATIC", "all")).deck.find("velocity"), std::string::npos);
  EXPECT_EQ(
      error_with(changes("DYNAMIC", "top")),
      "m.feb:37: Initial/ic 'shot': it holds for some nodes of <Elements> 'upper': abut takes "
      "one velocity for all of a body");
}

TEST(Dynamics, RigidBodyFalls) {
  auto changes = falling();
  const std::string deck = scene_with(changes).deck;
  EXPECT_NE(section(deck, "bodies")
                .find("rigid: {center: [0.5, 0.5, 1.5], free: [z], force: [0, 0, -19.62], "
                      "load_curve: constant, density: 2}"),
            std::string::npos)
      << deck;
  EXPECT_NE(section(deck, "loads").find("body_force: [0, 0, -9.81], block: lower"),
            std::string::npos);
  changes[36].insert(changes[36].size() - 8,
                     "<rigid_ic type=\"initial_rigid_velocity\"><rb>plate</rb><value>0,0,-3</value>"
                     "</rigid_ic>");
  EXPECT_NE(section(scene_with(changes).deck, "bodies").find("initial_velocity: [0, 0, -3]\n"),
            std::string::npos);
}

TEST(Dynamics, Refused) {
  EXPECT_EQ(error_with({{3, control("<alpha>0.9</alpha>")}}),
            "m.feb:3: Control/solver/alpha: abut has alpha 1; a rhoi between 0 and 1 gives "
            "generalised alpha");
  EXPECT_EQ(
      error_with({{3, control("<gamma>0.4</gamma>")}}),
      "m.feb:3: Control/solver: abut takes beta and gamma of stable rules, 2 beta >= gamma >= "
      "0.5");
  EXPECT_EQ(
      error_with({{3, "<Step><step>" + control("") + "</step><step>" + control("", "STATIC") +
                          "</step></Step>"}}),
      "m.feb:3: Step/step/Control/analysis: some steps are DYNAMIC and some are not: abut has "
      "one kind of analysis");
  auto changes = falling();
  changes[6] =
      "<material id=\"2\" name=\"plate\" type=\"rigid body\"><density>0</density></material>";
  EXPECT_EQ(error_with(changes),
            "m.feb:6: Material/material 'plate': the rigid body is free and has "
            "no mass: give it elements and a density");
}
