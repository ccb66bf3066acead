// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

using namespace abut;
using namespace abut::abaqus_test;
using ::testing::HasSubstr;
using ::testing::Not;

namespace {

const std::string law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n5000.\n";

std::string contact(const std::string& text) {
  const std::string deck = scene_of(text).deck;
  const std::size_t at = deck.find("contact:\n");
  return deck.substr(at, deck.find("time:") - at);
}

TEST(AbaqusContact, HardContactIsHeldByMultipliers) {
  const std::string expected = R"(contact:
  SOLE_on_LID:
    primary: SOLE
    secondary: LID
    enforcement: augmented_lagrangian
)";
  EXPECT_EQ(contact(with(two_cubes, law, "")), expected);
  EXPECT_EQ(contact(with(two_cubes, law, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD\n")),
            expected);
  EXPECT_EQ(contact(with(two_cubes, law, "*SURFACE BEHAVIOR, PENALTY\n")), expected);
}

TEST(AbaqusContact, SlopesArePenalties) {
  EXPECT_THAT(contact(with(two_cubes, "TYPE=SURFACE TO SURFACE", "TYPE=NODE TO SURFACE")),
              HasSubstr("formulation: node_on_facet\n    penalty: 5000 "));
  const std::string table =
      contact(with(two_cubes, law,
                   "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0., -.02\n"
                   "10., .03\n"));
  EXPECT_THAT(table, HasSubstr("penalty: 200 "));
  EXPECT_THAT(table, HasSubstr("offset: 0.02\n"));
}

TEST(AbaqusContact, LawsThatAbutLacksAreRefused) {
  EXPECT_THAT(
      error_of(with(two_cubes, "LINEAR\n5000.\n", "EXPONENTIAL\n1., 2.\n")),
      HasSubstr("a.inp:39: *SURFACE BEHAVIOR: EXPONENTIAL: abut has no pressure over an open "
                "gap"));
  EXPECT_THAT(error_of(with(two_cubes, "LINEAR\n5000.\n", "TABULAR\n0., 0.\n1., 1.\n9., 2.\n")),
              HasSubstr("abut's pressure is linear in the overclosure"));
  EXPECT_THAT(error_of(with(two_cubes, "LINEAR", "LINAER")), HasSubstr("did you mean 'LINEAR'?"));
}

TEST(AbaqusContact, FrictionMayChangeBetweenSteps) {
  const std::string text = with(two_cubes, law, law + "*FRICTION\n.2, 100.\n") + R"(*STEP
*STATIC
*CHANGE FRICTION, INTERACTION=SOFT
*FRICTION
.5
*END STEP
)";
  const abaqus::Scene s = scene_of(text);
  expect_line(s.deck, "    friction: 0.5");
  expect_line(s.deck, "    friction_curve: friction_SOFT");
  expect_line(s.deck, "  friction_SOFT: [[0, 0.4], [1, 0.4], [1.000000002, 1], [2, 1]]");
  EXPECT_THAT(s.report.text("a.inp"), HasSubstr("not with the stick slope 100"));
}

TEST(AbaqusContact, PairsAreTakenOutAndIn) {
  const std::string text = two_cubes + R"(*STEP
*STATIC
*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE
SOLE, LID
*END STEP
*STEP
*STATIC
*MODEL CHANGE, TYPE=CONTACT PAIR, ADD
SOLE, LID
*END STEP
)";
  const std::string deck = contact(text);
  EXPECT_THAT(deck, HasSubstr("    until: 1\n  SOLE_on_LID_2:\n"));
  EXPECT_THAT(deck, HasSubstr("    from: 2\n"));
}

TEST(AbaqusContact, GapsAtTheStart) {
  const auto with_adjust = [](const std::string& word) {
    return contact(with(two_cubes, "*CONTACT PAIR,", "*CONTACT PAIR, " + word + ","));
  };
  EXPECT_THAT(with_adjust("ADJUST=0.1"),
              HasSubstr("initial_overlap: adjust\n    initial_gap: close\n    fit_within: 0.1\n"));
  EXPECT_THAT(with_adjust("ADJUST=0."), HasSubstr("initial_overlap: adjust\n"));
  EXPECT_THAT(with_adjust("ADJUST=0."), Not(HasSubstr("initial_gap")));
  const std::string sides = ", MAS"
                            "TER=LID, SLA"
                            "VE=SOLE";
  EXPECT_THAT(contact(with(two_cubes, "*STEP\n", "*CLEARANCE" + sides + ", VALUE=.02\n*STEP\n")),
              HasSubstr("interference: -0.02  # CLEARANCE\n    interference_curve: constant\n    "
                        "fit_within: 3\n"));
}

TEST(AbaqusContact, TiesAreExact) {
  const std::string tie =
      with(two_cubes, pair, "*TIE, NAME=glue, POSITION TOLERANCE=.5\nSOLE, LID\n");
  EXPECT_EQ(contact(tie), R"(contact:
  glue:
    primary: SOLE
    secondary: LID
    tied: true
    tie_distance: 0.5
    enforcement: augmented_lagrangian  # exact, as equations between the nodes
)");
  const std::string soft = contact(with(two_cubes, "LINEAR\n", "TIED\n"));
  EXPECT_THAT(soft, HasSubstr("tied: true\n    tie_distance: 3\n    tie_gap: close\n"));
  EXPECT_THAT(soft, HasSubstr("penalty: 5000 "));
  EXPECT_THAT(error_of(with(tie, "NAME=glue", "CYCLIC SYMMETRY")),
              HasSubstr("CYCLIC SYMMETRY: abut"));
}

TEST(AbaqusContact, NodesAreTakenForTheFacesThatTheyHave) {
  const std::string nodal = with(two_cubes, "*SURFACE, NAME=SOLE\n2, S1",
                                 "*SURFACE, NAME=SOLE, TYPE=NODE\n11,\n12,\n13,\n14,");
  EXPECT_EQ(scene_of(nodal).mesh.side_sets.at("SOLE").size(), 1u);
  EXPECT_THAT(error_of(with(nodal, "13,\n14,", "13,\n18,")),
              HasSubstr("4 of the 4 nodes of surface 'SOLE' are on no outer face"));
}

} // namespace
