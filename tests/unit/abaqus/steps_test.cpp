// SPDX-License-Identifier: BSD-3-Clause
// Several steps on one axis of time, amplitudes, what ends and what goes on.
#include "two_cubes.hpp"

using namespace abut;
using namespace abut::abaqus_test;
using ::testing::HasSubstr;
using ::testing::Not;

namespace {

const std::string before = cubes + material + pair;

TEST(AbaqusSteps, ADisplacementGoesOnFromWhereItIs) {
  const std::string deck = scene_of(before + held + R"(*STEP
*STATIC
.5, 1.
*BOUNDARY
HEAD, 3, 3, -.01
*END STEP
*STEP
*STATIC
.5, 2.
*BOUNDARY
HEAD, 3, 3, -.04
*END STEP
*STEP
*STATIC
*END STEP
)")
                               .deck;
  expect_line(deck, "  HEAD_2: {set: HEAD, z: -0.04, curve: moves_HEAD}");
  expect_line(deck, "  moves_HEAD: [[0, 0], [1, 0.25], [3, 1], [4, 1]]");
  expect_line(deck, "time: {end: 4, steps: 8}");
}

TEST(AbaqusSteps, OpNewLetsGo) {
  const std::string deck = scene_of(before + held + R"(*STEP
*STATIC
*BOUNDARY
HEAD, 3, 3, -.01
*CLOAD
7, 1, 5.
*END STEP
*STEP
*STATIC
*BOUNDARY, OP=NEW
FOOT, 1, 3
18, 1, 3
*CLOAD, OP=NEW
8, 1, 2.
*END STEP
)")
                               .deck;
  expect_line(deck, "  FOOT: {set: FOOT, fix: [x, y, z]}");
  expect_line(deck, "  HEAD: {set: held_HEAD, fix: [x, y], until: 1}");
  expect_line(deck, "  HEAD_2: {set: held_HEAD_2, fix: [x, y]}"); // node 18
  expect_line(deck, "  HEAD_3: {set: held_HEAD, z: -0.01, curve: moves_HEAD, until: 1}");
  expect_line(deck, "  HEAD_4: {set: held_HEAD_2, z: -0.01, curve: moves_HEAD_2}");
  expect_line(deck, "  moves_HEAD_2: [[0, 0], [1, 1], [2, 0]]");
  // A force that is taken away goes down over the step.
  expect_line(deck, "  force_on_nodes_2: {force: [5, 0, 0], node_set: loaded_nodes_2, curve: "
                    "moves_HEAD_2}");
  expect_line(deck, "  force_on_nodes: {force: [2, 0, 0], node_set: loaded_nodes, curve: "
                    "loads_force_on_nodes}");
  expect_line(deck, "  loads_force_on_nodes: [[0, 0], [1, 0], [2, 1]]");
}

TEST(AbaqusSteps, FixedHoldsWhereTheNodesAre) {
  const std::string deck = scene_of(before + held + R"(*STEP
*STATIC
*CLOAD
HEAD, 3, -1.
*END STEP
*STEP
*STATIC
*BOUNDARY, FIXED
HEAD, 3, 3
*END STEP
)")
                               .deck;
  expect_line(deck, "  HEAD_2: {set: HEAD, fix: [z], from: 1, relative: true}");
}

TEST(AbaqusSteps, AmplitudesCountTheTimeOfTheirStepOrAllOfIt) {
  const std::string loads = R"(*AMPLITUDE, NAME=saw
0., 0., .5, 1., 1., 0.
*AMPLITUDE, NAME=late, TIME=TOTAL TIME
0., 0., 1.5, 1.
*STEP
*STATIC
*END STEP
*STEP
*STATIC
*DSLOAD, AMPLITUDE=saw
LID, P, 2.
*CLOAD, AMPLITUDE=LATE
HEAD, 1, 3.
*BOUNDARY
HEAD, 3, 3
*END STEP
)";
  const std::string deck = scene_of(before + held + loads).deck;
  expect_line(deck, "  pressure_on_LID: {pressure: 2, side_set: LID, curve: loads_LID}");
  expect_line(deck, "  loads_LID: [[0, 0], [1, 0], [1.5, 1], [2, 0]]");
  expect_line(deck, "  loads_force_on_HEAD: [[0, 0], [1, 0], [1.000000002, 0.6666666666666666], "
                    "[1.5, 1], [2, 1]]");
  // In the next step it holds its last value.
  EXPECT_THAT(scene_of(before + held + loads + "*STEP\n*STATIC\n*END STEP\n").deck,
              HasSubstr("loads_LID: [[0, 0], [1, 0], [1.5, 1], [2, 0], [3, 0]]"));
}

TEST(AbaqusSteps, SmoothStepsAreSixteenPieces) {
  const std::string deck = scene_of(before + held + R"(*AMPLITUDE, NAME=soft, DEFINITION=SMOOTH STEP
0., 0., 1., 1.
*STEP
*STATIC
*BOUNDARY, AMPLITUDE=soft
HEAD, 3, 3, -.01
*END STEP
)")
                               .deck;
  EXPECT_THAT(deck, HasSubstr("moves_HEAD: [[0, 0], [0.0625, "));
  EXPECT_THAT(deck, HasSubstr("[0.5, 0.5]")); // half of the way at half of the time
  EXPECT_THAT(deck, HasSubstr("[1, 1]]"));
}

TEST(AbaqusSteps, LoadsOfOneStepAddUp) {
  const std::string deck = scene_of(before + held + R"(*STEP, AMPLITUDE=STEP
*STATIC
*CLOAD
HEAD, 3, -1.
HEAD, 3, -2.
*DLOAD
UPPER, P2, 4.
*END STEP
)")
                               .deck;
  expect_line(deck, "  force_on_HEAD: {force: [0, 0, -3], node_set: HEAD, curve: constant}");
  expect_line(deck, "  constant: [[0, 1], [1, 1]]");
  expect_line(deck,
              "  pressure_on_UPPER_P2: {pressure: 4, side_set: loaded_UPPER_P2, curve: constant}");
}

TEST(AbaqusSteps, GravityIsDensityTimesIt) {
  const std::string text =
      with(before, "1000., .3\n", "1000., .3\n*DENSITY\n7.\n") + held + R"(*STEP
*STATIC
*DLOAD
BOTH, GRAV, 10., 0., 0., -2.
*END STEP
)";
  expect_line(scene_of(text).deck, "  weight_of_BOTH: {body_force: [0, 0, -70], block: BOTH}");
  EXPECT_THAT(error_of(with(text, "BOTH, GRAV", "UPPER, GRAV")),
              HasSubstr("it acts on a part of block 'BOTH'"));
}

TEST(AbaqusSteps, SmallFirstIncrementsAreGuessesUnlessDirect) {
  const auto time = [](const std::string& words) {
    const std::string deck = scene_of(with(two_cubes, "*STATIC\n", "*STATIC" + words)).deck;
    return deck.substr(deck.find("time: "), deck.find("output") - deck.find("time: ") - 1);
  };
  EXPECT_EQ(time("\n.001, 1.\n"), "time: {end: 1, steps: 20}");
  EXPECT_EQ(time(", DIRECT\n.01, 1.\n"), "time: {end: 1, steps: 100}");
  EXPECT_EQ(time("\n1., 1., 1e-5, .1\n"), "time: {end: 1, steps: 10}");
}

TEST(AbaqusSteps, DynamicsHasDensityAndDampingOfItsRule) {
  const std::string text = with(with(two_cubes, "1000., .3\n", "1000., .3\n*DENSITY\n2.\n"),
                                "*STATIC\n", "*DYNAMIC, ALPHA=0.\n.1, 1.\n");
  const std::string deck = scene_of(with(text, "*STEP\n", R"(*INITIAL CONDITIONS, TYPE=VELOCITY
ALL, 3, 5.
*STEP
)"))
                               .deck;
  expect_line(deck, "dynamics: {spectral_radius: 1}");
  expect_line(deck, "  BOTH: {blocks: [BOTH], material: STEEL, initial_velocity: [0, 0, 5]}");
  EXPECT_THAT(deck, HasSubstr("z: -0.01, curve: constant")); // at once
  EXPECT_THAT(error_of(with(two_cubes, "*STATIC\n", "*DYNAMIC\n.1, 1.\n")),
              HasSubstr("expected *DENSITY below it"));
}

TEST(AbaqusSteps, MixedStepsAreRefused) {
  const std::string second = "*STEP, NLGEOM\n*STATIC\n*END STEP\n";
  EXPECT_THAT(error_of(two_cubes + second), HasSubstr("a step with NLGEOM behind one without"));
  EXPECT_THAT(
      error_of(with(two_cubes, "*STEP\n", "*STEP, NLGEOM\n") + "*STEP\n*STATIC\n*END STEP\n"),
      "no error"); // it stays on
}

} // namespace
