// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut::febio;
using namespace abut::febio::test;

namespace {

/// Two cubes whose upper one is of another material, which a test names.
std::map<std::size_t, std::string> unequal(const std::string& upper, bool upper_is_primary,
                                           const std::string& more = "") {
  const std::string low = "low face", up = "up_face";
  return {
      {7, upper + "</Material>"},
      {26, "<SurfacePair name=\"pair\"><primary>" + (upper_is_primary ? up : low) + "</primary>"},
      {27, "<secondary>" + (upper_is_primary ? low : up) + "</secondary></SurfacePair></Mesh>"},
      {29, "<SolidDomain name=\"upper\" mat=\"other\"/></MeshDomains>"},
      {38, "<Contact><contact name=\"touch\" surface_pair=\"pair\" "
           "type=\"sliding-facet-on-facet\">"},
      {40, "<penalty>0.5</penalty><auto_penalty>1</auto_penalty>" + more},
      {41, ""}};
}

/// The line of the penalty in the entry of this name.
std::string penalty(const std::map<std::size_t, std::string>& changes,
                    const std::string& entry = "touch") {
  const std::string contact = section(scene_with(changes).deck, "contact");
  const std::size_t begin = contact.find("  " + entry + ":");
  const std::size_t at = contact.find("    penalty", begin);
  if (begin == std::string::npos || at == std::string::npos)
    return "none";
  return contact.substr(at + 4, contact.find('\n', at) - at - 4);
}

std::string elastic(double young) {
  return "<material id=\"3\" name=\"other\" type=\"neo-Hookean\"><E>" + std::to_string(young) +
         "</E><v>0</v></material>";
}

// The lower cube has E = 10. FEBio's penalty is the primary's, abut's the softer one's.
TEST(AutomaticPenalty, IsScaledToThePrimary) {
  EXPECT_EQ(penalty(unequal(elastic(10), true)), "penalty_factor: 0.5");
  EXPECT_EQ(penalty(unequal(elastic(1000), false)), "penalty_factor: 0.5");
  EXPECT_EQ(penalty(unequal(elastic(1000), true)),
            "penalty_factor: 50  # FEBio: 0.5, of the primary's E, here 100 times the other's");
  EXPECT_EQ(penalty(unequal(elastic(4), false)),
            "penalty_factor: 1.25  # FEBio: 0.5, of the primary's E, here 2.5 times the other's");
}

// G = 2, K = 4 in all of these, so that E = 9 K G / (3 K + G) = 36/7.
TEST(AutomaticPenalty, TakesYoungsModulusWithoutStrain) {
  const std::string expected =
      "penalty_factor: 0.972222222222  # FEBio: 0.5, of the primary's E, here 1.944 times the "
      "other's";
  const auto other = [](const std::string& type, const std::string& parameters) {
    return unequal("<material id=\"3\" name=\"other\" type=\"" + type + "\">" + parameters +
                       "</material>",
                   false);
  };
  EXPECT_EQ(penalty(other("Mooney-Rivlin", "<c1>0.75</c1><c2>0.25</c2><k>4</k>")), expected);
  EXPECT_EQ(penalty(other("Ogden", "<c1>1</c1><m1>4</m1><c2>3</c2><m2>2</m2><k>4</k>")), expected);
  EXPECT_EQ(
      penalty(other("Ogden unconstrained", "<c1>4</c1><m1>4</m1><cp>2.6666666666666667</cp>")),
      expected);
}

TEST(AutomaticPenalty, TwoPassesWithTheirOwnAreTwoContacts) {
  const auto equal = unequal(elastic(10), false, "<two_pass>1</two_pass>");
  EXPECT_EQ(penalty(equal), "penalty_factor: 1  # twice FEBio's: its two passes add up");
  EXPECT_EQ(penalty(equal, "touch_second_pass"), "none");

  const auto both = unequal(elastic(1000), false, "<two_pass>1</two_pass>");
  EXPECT_EQ(section(scene_with(both).deck, "contact"),
            "contact:\n"
            "  touch:\n"
            "    primary: \"low face\"\n"
            "    secondary: up_face\n"
            "    penalty_factor: 0.5\n"
            "  touch_second_pass:  # FEBio: touch\n"
            "    primary: up_face\n"
            "    secondary: \"low face\"\n"
            "    penalty_factor: 50  # FEBio: 0.5, of the primary's E, here 100 times the "
            "other's\n");
}

// FEBio takes E / (1 - v^2) of the rigid material: here 9 / 0.75 times A / V = 1.
TEST(AutomaticPenalty, OfARigidPrimaryIsANumber) {
  const std::string rigid = "<material id=\"3\" name=\"other\" type=\"rigid body\"><E>9</E><v>0.5"
                            "</v></material>";
  EXPECT_EQ(penalty(unequal(rigid, true)),
            "penalty: 6  # FEBio: 0.5, from the rigid material's E and v");
  EXPECT_EQ(penalty(unequal(rigid, false)), "penalty_factor: 0.5");
  const auto both = unequal(rigid, false, "<two_pass>1</two_pass>");
  EXPECT_EQ(penalty(both), "penalty_factor: 0.5");
  EXPECT_EQ(penalty(both, "touch_second_pass"),
            "penalty: 6  # FEBio: 0.5, from the rigid material's E and v");
}

TEST(AutomaticPenalty, OfSeveralStiffnessesIsAContactForEach) {
  auto mixed = unequal(elastic(1000), false);
  mixed[24] = "<Surface name=\"low face\"><quad4 id=\"1\">5,6,7,8</quad4><quad4 "
              "id=\"2\">15,16,17,18</quad4></Surface>";
  const Scene scene = scene_with(mixed);
  EXPECT_EQ(section(scene.deck, "contact"), "contact:\n"
                                            "  touch:\n"
                                            "    primary: \"low face_part_1\"\n"
                                            "    secondary: up_face\n"
                                            "    penalty_factor: 0.5\n"
                                            "  touch_part_2:  # FEBio: touch\n"
                                            "    primary: \"low face_part_2\"\n"
                                            "    secondary: up_face\n"
                                            "    penalty_factor: 0.5\n");
  ASSERT_EQ(scene.mesh.side_sets.at("low face_part_2").size(), 1u);
  EXPECT_EQ(scene.mesh.side_sets.at("low face_part_2")[0].block, 1);
  EXPECT_EQ(scene.mesh.side_sets.at("low face").size(), 2u);
}

TEST(AutomaticPenalty, OfSeveralStiffnessesInTwoPasses) {
  auto mixed = unequal(elastic(1000), false, "<two_pass>1</two_pass>");
  mixed[24] = "<Surface name=\"low face\"><quad4 id=\"1\">5,6,7,8</quad4><quad4 "
              "id=\"2\">15,16,17,18</quad4></Surface>";
  EXPECT_EQ(penalty(mixed), "penalty_factor: 0.5");
  EXPECT_EQ(penalty(mixed, "touch_part_2"), "penalty_factor: 0.5");
  EXPECT_EQ(penalty(mixed, "touch_second_pass"),
            "penalty_factor: 50  # FEBio: 0.5, of the primary's E, here 100 times the other's");
}

// A rigid primary beside the soft one: each of its penalties is a number.
TEST(AutomaticPenalty, OfASurfaceThatIsRigidInPart) {
  auto mixed = unequal("<material id=\"3\" name=\"other\" type=\"rigid body\"><E>9</E><v>0.5</v>"
                       "</material>",
                       false);
  mixed[24] = "<Surface name=\"low face\"><quad4 id=\"1\">5,6,7,8</quad4><quad4 "
              "id=\"2\">15,16,17,18</quad4></Surface>";
  EXPECT_EQ(penalty(mixed), "penalty_factor: 0.5");
  EXPECT_EQ(penalty(mixed, "touch_part_2"),
            "penalty: 6  # FEBio: 0.5, from the rigid material's E and v");
}

TEST(AutomaticPenalty, IsRefusedWhereNoDeckCanSayTheSame) {
  auto rigid =
      unequal("<material id=\"3\" name=\"other\" type=\"rigid body\"><E>0</E></material>", true);
  EXPECT_EQ(error_with(rigid),
            "m.feb:38: Contact/contact/auto_penalty: surface 'up_face' is rigid, and FEBio's "
            "penalty from the E and v of the rigid material is not above 0: give a number, "
            "auto_penalty 0");
}

} // namespace
