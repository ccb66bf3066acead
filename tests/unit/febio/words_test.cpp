// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio;
using namespace abut::febio::test;

namespace {

TEST(Words, UnitsAreTakenAsTheyAre) {
  const Scene scene = scene_with(
      {{2, "<febio_spec version=\"4.0\"><Module type=\"solid\"><units>mm-N-s</units></Module>"}});
  EXPECT_EQ(scene.deck, scene_with({}).deck);
  EXPECT_NE(scene.report.text("m.feb").find("ignored  line 2  Module/units: "), std::string::npos);
}

// FEBio reads a flag as a whole number, and words as 0, whatever they say.
TEST(Words, TrueIsNoNumber) {
  const auto flag = [](const std::string& word) {
    return scene_with({{41, "<two_pass>" + word + "</two_pass>"}});
  };
  EXPECT_NE(flag("1").deck, flag("0").deck);
  for (const char* word : {"True", "false"}) {
    EXPECT_EQ(flag(word).deck, flag("0").deck);
    EXPECT_NE(flag(word).report.text("m.feb").find(std::string("'") + word +
                                                   "' is no number: FEBio reads 0"),
              std::string::npos);
  }
  EXPECT_EQ(error_with({{41, "<two_pass>yes</two_pass>"}}),
            "m.feb:41: <two_pass>: expected 0 or 1, got 'yes'");
  EXPECT_EQ(scene_with({{41, "<smooth_aug>False</smooth_aug>"}}).deck, scene_with({}).deck);
}

TEST(Words, RigidBodiesByNumber) {
  const auto held = [](const std::string& body) {
    return scene_with({{29, "<SolidDomain name=\"upper\" mat=\"plate\" type=\"rigid-solid\"/>"
                            "</MeshDomains>"},
                       {33, ""},
                       {34, ""},
                       {36, "<Rigid><rigid_bc type=\"rigid_fixed\"><rb>" + body +
                                "</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof><Ru_dof>1</Ru_dof>"
                                "<Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc></Rigid>"}})
        .deck;
  };
  EXPECT_EQ(held("2"), held("plate"));
  EXPECT_NE(held("2").find("free: [z]"), std::string::npos);
}

TEST(Words, HarmlessOnesOfTies) {
  const auto tied = [](const std::string& type, const std::string& more) {
    return section(
        scene_with(
            {{38, "<Contact><contact name=\"touch\" surface_pair=\"pair\" type=\"" + type + "\">"},
             {41, more}})
            .deck,
        "contact");
  };
  const std::string update = "<update_penalty>1</update_penalty>";
  for (const char* type : {"tied-elastic", "tied-node-on-facet", "tied-facet-on-facet"}) {
    EXPECT_NE(tied(type, "").find("tied: true"), std::string::npos);
    EXPECT_EQ(tied(type, update + "<knmult>1</knmult>"), tied(type, "")) << type;
  }
  EXPECT_NE(tied("tied-facet-on-facet", "").find("tie_gap: close"), std::string::npos);
  EXPECT_EQ(tied("tied-facet-on-facet", "<gap_offset>1</gap_offset>").find("tie_gap"),
            std::string::npos);
}

// sigma = p I + G J^(-5/3) dev b, which is that of Mooney-Rivlin with c1 = G/2.
TEST(Words, IncompressibleNeoHookean) {
  const Scene scene = scene_with({{5, "<material id=\"1\" name=\"soft one\" type=\"incomp "
                                      "neo-Hookean\"><G>3</G><k>50</k></material>"}});
  EXPECT_EQ(section(scene.deck, "materials"),
            "materials:\n  soft_one: {model: mooney_rivlin, c1: 1.5, bulk: 50}  # FEBio: soft one, "
            "incomp neo-Hookean\n");
  EXPECT_NE(scene.deck.find("element: mean_dilatation"), std::string::npos);
}

// A point looks for the closest one of the secondary surface, whose normal decides.
TEST(Words, PrimaryFacesMayPointInward) {
  const auto turned = [](const std::string& type, const std::string& more, std::size_t line) {
    const std::string face = line == 24 ? "<Surface name=\"low face\"><quad4 id=\"1\">8,7,6,5"
                                        : "<Surface name=\"up_face\"><quad4 id=\"1\">11,12,13,14";
    return with(
        {{line, face + "</quad4></Surface>"},
         {38, "<Contact><contact name=\"touch\" surface_pair=\"pair\" type=\"" + type + "\">"},
         {41, more}});
  };
  const auto deck = [](const std::string& text) { return import(text, "m.feb", "m").deck; };
  for (const char* type : {"sliding-facet-on-facet", "sliding-node-on-facet", "sticky"})
    EXPECT_EQ(deck(turned(type, "", 24)),
              deck(with({{38, std::string("<Contact><contact name=\"touch\" surface_pair=\"pair\" "
                                          "type=\"") +
                                  type + "\">"},
                         {41, ""}})));
  EXPECT_NE(deck(turned("tied-facet-on-facet", "", 25)).find("tied: true"), std::string::npos);
  for (const std::string& text :
       {turned("sliding-elastic", "", 24),
        turned("sliding-facet-on-facet", "<two_pass>1</two_pass>", 24),
        turned("sliding-facet-on-facet", "<node_reloc>1</node_reloc>", 24)})
    EXPECT_EQ(error_of(text), "m.feb:38: Contact/contact 'touch': the faces of surface 'low face' "
                              "point into their bodies");
  EXPECT_EQ(error_of(turned("sliding-facet-on-facet", "", 25)),
            "m.feb:38: Contact/contact 'touch': the faces of surface 'up_face' point into their "
            "bodies");
}

} // namespace
