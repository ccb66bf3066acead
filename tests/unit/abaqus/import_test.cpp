// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

using namespace abut;
using namespace abut::abaqus_test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

TEST(Abaqus, TwoCubesBecomeAMeshAndADeck) {
  const abaqus::Scene s = scene_of(two_cubes);
  ASSERT_EQ(s.mesh.blocks.size(), 1u);
  EXPECT_EQ(s.mesh.blocks[0].name, "BOTH");
  EXPECT_THAT(s.mesh.blocks[0].element_id, ElementsAre(1, 2));
  EXPECT_THAT(s.mesh.node_id, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18));
  EXPECT_THAT(s.mesh.node_sets.at("HEAD"), ElementsAre(12, 13, 14, 15));
  ASSERT_EQ(s.mesh.side_sets.at("LID").size(), 1u);
  EXPECT_EQ(s.mesh.side_sets.at("LID")[0].side, 5);
  EXPECT_EQ(s.mesh.side_sets.at("SOLE")[0].side, 4);
  EXPECT_EQ(s.deck, R"(# From Abaqus or CalculiX: a.inp
title: a
mesh: {file: a.exo}
materials:
  STEEL: {model: linear_elastic, young: 1000, poisson: 0.3}
bodies:
  BOTH: {blocks: [BOTH], material: STEEL}
displacements:
  FOOT: {set: FOOT, fix: [x, y, z]}
  HEAD: {set: HEAD, fix: [x, y]}
  HEAD_2: {set: HEAD, z: -0.01}
contact:
  SOLE_on_LID:
    primary: SOLE
    secondary: LID
    penalty: 5000  # pressure over overclosure
time: {end: 1, steps: 1}
output: {name: a_results}
)");
  EXPECT_EQ(s.report.count(translation::Fate::refused), 0);
  EXPECT_THAT(s.report.text("a.inp"), HasSubstr("used  line 36  *CONTACT PAIR\n"));
}

/// Capitals, blanks, comments, lines that go on, parameters and keywords that are cut short.
TEST(Abaqus, SpellingDoesNotMatter) {
  std::string text = with(two_cubes, "*NODE, NSET=ALL", "** a comment\n\n  *nOdE ,\n nse = all ");
  text = with(text, "*SURFACE INTERACTION, NAME=SOFT", "*SurfaceInteraction,name=soft");
  text = with(text, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
              "*SURFACE BEHAV, PRESSURE-OVER =lin");
  text = with(text, "5000.", "+5.D3,");
  text = with(text, "*END STEP", "*endstep");
  text = with(text, "1, 1, 2, 3, 4, 5, 6, 7, 8", "1, 1, 2, 3, 4,\n 5, 6, 7, 8,");
  text = with(text, "*ELSET, ELSET=BOTH\nLOWER, UPPER", "*ELSET, ELSET=Both\nlower,\n2,");
  std::string windows;
  for (const char c : text)
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  const abaqus::Scene plain = scene_of(two_cubes), s = scene_of(windows);
  EXPECT_EQ(s.mesh.x, plain.mesh.x);
  EXPECT_EQ(s.mesh.blocks[0].nodes, plain.mesh.blocks[0].nodes);
  EXPECT_EQ(s.mesh.blocks[0].name, "BOTH"); // as the section spells it
  EXPECT_EQ(s.deck, plain.deck);
}

TEST(Abaqus, NumbersOfARangeThatAreNothingAreLeftOut) {
  const abaqus::Scene s =
      scene_of(with(two_cubes, "15, 18", "15, 1000000000\n*NSET, NSET=ODD, GENERATE\n1, 18, 2"));
  EXPECT_EQ(s.mesh.node_sets.at("HEAD").size(), 4u);
  EXPECT_THAT(s.mesh.node_sets.at("ODD"), ElementsAre(0, 2, 4, 6, 8, 10, 12, 14));
}

TEST(Abaqus, FilesAreIncludedWithinTheDataToo) {
  const std::size_t lines = cubes.find(" 1, 0."), end = cubes.find("11, 0.");
  const std::string inner = cubes.substr(lines, end - lines);
  const std::string outer = with(two_cubes, inner, "*INCLUDE, INPUT=nodes.txt\n");
  translation::Report report;
  std::string asked;
  const auto read = [&](const std::string& path) {
    asked = path;
    return inner;
  };
  const abaqus::Model model = abaqus::read_model(outer, "folder/a.inp", read, report);
  EXPECT_EQ(asked, "folder/nodes.txt");
  EXPECT_EQ(model.nodes.size(), 16u);
  EXPECT_EQ(model.where(model.nodes[2].place), "folder/nodes.txt:3");
  EXPECT_EQ(abaqus::translate(model, "a", report).mesh.x, scene_of(two_cubes).mesh.x);
}

TEST(Abaqus, InstancesAreShiftedAndThenTurned) {
  // The upper cube is the same part, turned by a right angle about an edge of the shifted one.
  const std::string part =
      cubes.substr(0, cubes.find("11, 0.")) + R"(*ELEMENT, TYPE=C3D8, ELSET=Cube
1, 1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=bottom
1, 2, 3, 4
*SURFACE, NAME=top
Cube, S2
*SURFACE, NAME=bottom
Cube, S1
*SOLID SECTION, ELSET=Cube, MATERIAL=STEEL
)";
  const std::string text = "*PART, NAME=Block\n" + part + R"(*END PART
*ASSEMBLY, NAME=A
*INSTANCE, NAME=low, PART=block
*END INSTANCE
*INSTANCE, NAME=high, PART=Block
0., 0., 1.
1., 0., 0., 1., 0., 5., 90.
*END INSTANCE
*NSET, NSET=held, INSTANCE=low
bottom,
*NSET, NSET=moved, INSTANCE=high
5, 6, 7, 8
*END ASSEMBLY
*MATERIAL, NAME=STEEL
*ELASTIC
1000., .3
*CONTACT PAIR
high.bottom, low.top
*BOUNDARY
held, ENCASTRE
low.7, 1
*STEP
*STATIC
*BOUNDARY
moved, 3, 3, -.01
*END STEP
)";
  const abaqus::Scene s = scene_of(text);
  ASSERT_EQ(s.mesh.num_nodes(), 16);
  EXPECT_TRUE(s.mesh.node_id.empty()); // both instances have 1 to 8
  EXPECT_EQ(s.mesh.blocks[0].name, "low.Cube");
  EXPECT_EQ(s.mesh.blocks[1].name, "high.Cube");
  // Node 2 of the part, (1, 0, 0): on the axis; node 1: a unit before it in x, now in y.
  const auto at = [&](std::size_t n) {
    return std::vector<double>(s.mesh.x.begin() + static_cast<std::ptrdiff_t>(3 * n),
                               s.mesh.x.begin() + static_cast<std::ptrdiff_t>(3 * n + 3));
  };
  EXPECT_THAT(at(9), ::testing::Pointwise(::testing::DoubleNear(1e-12), {1., 0., 1.}));
  EXPECT_THAT(at(8), ::testing::Pointwise(::testing::DoubleNear(1e-12), {1., -1., 1.}));
  EXPECT_THAT(at(12), ::testing::Pointwise(::testing::DoubleNear(1e-12), {1., -1., 2.}));
  EXPECT_THAT(s.mesh.node_sets.at("moved"), ElementsAre(12, 13, 14, 15));
  expect_line(s.deck, "  held: {set: held, fix: [x, y, z]}");
  expect_line(s.deck, "    primary: high.bottom");
  expect_line(s.deck, "    enforcement: augmented_lagrangian");
  expect_line(s.deck, "    formulation: node_on_facet");
}

TEST(Abaqus, MaterialsKeepTheirModuli) {
  const auto law = [](const std::string& lines, const std::string& step_words = "") {
    const std::string text = with(with(two_cubes, "*ELASTIC\n1000., .3\n", lines), "*STEP\n",
                                  "*STEP" + step_words + "\n");
    const std::string deck = scene_of(text).deck;
    const std::size_t at = deck.find("  STEEL: ");
    return deck.substr(at + 9, deck.find('\n', at) - at - 9);
  };
  EXPECT_EQ(law("*ELASTIC, TYPE=ISO\n1000., .3\n*DENSITY\n2.\n", ", NLGEOM"),
            "{model: saint_venant_kirchhoff, young: 1000, poisson: 0.3, density: 2}");
  // 2 G = 4 (C10 + C01), K = 2/D1.
  EXPECT_EQ(law("*HYPERELASTIC, NEO HOOKE\n.5, .01\n", ", NLGEOM"),
            "{model: mooney_rivlin, c1: 0.5, bulk: 200}");
  EXPECT_EQ(law("*HYPERELASTIC, MOONEY-RIVLIN\n.4, .1, .01\n", ", NLGEOM"),
            "{model: mooney_rivlin, c1: 0.4, c2: 0.1, bulk: 200}");
  EXPECT_EQ(law("*HYPERELASTIC, MOONEY-RIVLIN\n.4, .1\n", ", NLGEOM=YES"),
            "{model: mooney_rivlin, c1: 0.4, c2: 0.1, bulk: 1000}");
  // G = mu1 + mu2: abut's c are twice the mu.
  EXPECT_EQ(law("*HYPERELASTIC, OGDEN, N=2\n.6, 2., -.1, -2., .01, 0.\n", ", NLGEOM"),
            "{model: ogden, coefficients: [1.2, -0.2], exponents: [2, -2], bulk: 200}");
}

TEST(Abaqus, ElementsOfOneSectionWithOtherWordsAreOtherBodies) {
  const abaqus::Scene s = scene_of(
      with(two_cubes, "*ELEMENT, TYPE=C3D8, ELSET=UPPER", "*ELEMENT, TYPE=C3D8I, ELSET=UPPER"));
  expect_line(s.deck, "  BOTH: {blocks: [BOTH], material: STEEL}");
  expect_line(s.deck, "  BOTH_2: {blocks: [BOTH_enhanced], material: STEEL, element: enhanced}");
}

TEST(Abaqus, ASurfaceWithoutFaceWordsIsTheSkin) {
  const abaqus::Scene s = scene_of(with(two_cubes, "LOWER, S2", "LOWER,"));
  EXPECT_EQ(s.mesh.side_sets.at("LID").size(), 6u);
}

} // namespace
