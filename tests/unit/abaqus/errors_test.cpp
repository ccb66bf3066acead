// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

using namespace abut;
using namespace abut::abaqus_test;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace {

TEST(AbaqusErrors, NameTheirPlaceAndTheNearestWord) {
  const auto changed = [](const std::string& old, const std::string& text) {
    return error_of(with(two_cubes, old, text));
  };
  EXPECT_THAT(changed("*STATIC", "*STATICS"),
              HasSubstr("a.inp:45: *STATICS: abut does not know this keyword; did you mean "
                        "'STATIC'?"));
  EXPECT_THAT(changed("FOOT, 1, 3", "FOOD, 1, 3"),
              StartsWith("a.inp:42: *BOUNDARY: there is no node set 'FOOD'; valid: "));
  EXPECT_THAT(changed("FOOT, 1, 3", "FOOD, 1, 3"), HasSubstr("did you mean 'FOOT'?"));
  EXPECT_THAT(changed("SOLE, LID", "SOLE, LIT"), HasSubstr("a.inp:37: *CONTACT PAIR: there is no "
                                                           "surface 'LIT'"));
  EXPECT_THAT(changed("MATERIAL=STEEL", "MATERIAL=STEAL"), HasSubstr("did you mean 'STEEL'?"));
  EXPECT_THAT(changed("INTERACTION=SOFT", "INTERACTION=SOFA"), HasSubstr("did you mean 'SOFT'?"));
  EXPECT_EQ(changed(" 3, 1., 1., 0.", " 3, 1., x, 0."),
            "a.inp:4: *NODE: expected a coordinate, got 'x'");
  EXPECT_EQ(changed("6, 7, 8\n", "6, 7\n"),
            "a.inp:19: *ELEMENT: element 1 has 7 nodes, expected 8");
  EXPECT_EQ(changed("1, 1, 2, 3, 4,", "1, 1, 2, 3, 19,"),
            "a.inp:19: *ELEMENT: there is no node 19");
  EXPECT_THAT(changed("1, 1, 2, 3, 4, 5, 6, 7, 8", "1, 5, 6, 7, 8, 1, 2, 3, 4"),
              StartsWith("a.inp:19: *ELEMENT: element 1 is inside out"));
  EXPECT_THAT(changed("LOWER, S2", "LOWER, S7"), HasSubstr("expected a face S1 to S6"));
  EXPECT_THAT(changed("*END STEP\n", ""), HasSubstr("there is no *END STEP"));
}

TEST(AbaqusErrors, WhatIsNotSupportedIsAllTold) {
  const std::string text =
      with(with(two_cubes, "*STATIC\n", "*STATIC, RIKS\n"), "*STEP\n",
           "*EQUATION\n2\n1,1,1.,2,1,-1.\n*ORIENTATION, NAME=O\n1,0,0,0,1,0\n*STEP\n");
  EXPECT_EQ(
      error_of(text),
      "a.inp:44: *EQUATION: abut has no equations between nodes; it has *TIE, *RIGID BODY and "
      "*COUPLING with *KINEMATIC\n"
      "a.inp:47: *ORIENTATION: abut has no directions in materials\n"
      "a.inp:50: *STATIC: RIKS: abut has not");
  EXPECT_THAT(error_of(with(two_cubes, "*ELASTIC\n", "*PLASTIC\n10., 0.\n*ELASTIC\n")),
              HasSubstr("abut's materials are elastic"));
  EXPECT_THAT(error_of(with(two_cubes, "TYPE=C3D8, ELSET=UPPER", "TYPE=C3D15, ELSET=UPPER")),
              HasSubstr("abut has no prism of 15 nodes"));
  EXPECT_THAT(error_of(with(two_cubes, "TYPE=C3D8, ELSET=UPPER", "TYPE=S8R, ELSET=UPPER")),
              HasSubstr("abut has no elements of type 'S8R'"));
  EXPECT_THAT(error_of(with(two_cubes, "NAME=SOFT", "NAME=SOFT, PAD THICKNESS=1.")),
              HasSubstr("*SURFACE INTERACTION, PADTHICKNESS: abut does not know this parameter"));
}

TEST(AbaqusErrors, OutputIsIgnoredAndTold) {
  const abaqus::Scene s = scene_of(
      with(two_cubes, "*END STEP", "*NODE PRINT, NSET=ALL\nU\n*TEMPERATURE\nALL, 20.\n*END STEP"));
  const std::string report = s.report.text("a.inp");
  EXPECT_THAT(report, HasSubstr("ignored  line 48  *NODE PRINT: output"));
  EXPECT_THAT(report,
              HasSubstr("ignored  line 50  *TEMPERATURE: no material of the model expands"));
  EXPECT_THAT(error_of(with(with(two_cubes, "*END STEP", "*TEMPERATURE\nALL, 20.\n*END STEP"),
                            "*ELASTIC\n", "*EXPANSION\n1e-5\n*ELASTIC\n")),
              HasSubstr("abut has no expansion by temperature, as material 'STEEL' has"));
}

TEST(AbaqusErrors, AFileThatIncludesItselfIsToldSo) {
  translation::Report report;
  const std::string text = "*INCLUDE, INPUT=b.inp\n";
  const auto read = [&](const std::string&) { return text; };
  try {
    abaqus::read_model(text, "a.inp", read, report);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "b.inp:1: *INCLUDE: the file includes itself");
  }
}

} // namespace
