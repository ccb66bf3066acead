// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio;
using namespace abut::febio::test;

namespace {

TEST(Import, DeckIsWhatAPersonWouldWrite) {
  EXPECT_EQ(scene_with({}).deck, R"(# From FEBio's m.feb
title: m
mesh: {file: m.exo}
materials:
  soft_one: {young: 10, poisson: 0.3}  # FEBio: soft one, neo-Hookean
bodies:
  lower: {blocks: [lower], material: soft_one, element: displacement}
  upper: {blocks: [upper], material: soft_one, element: displacement}
displacements:
  hold: {set: bottom, fix: [x, y, z]}
  press: {set: top, z: -0.1, curve: LC1}
curves:
  LC1: [[0, 0], [2, 1]]
contact:
  touch:
    primary: "low face"
    secondary: up_face
    formulation: sliding_elastic
    penalty: 5
    reach: 1  # FEBio: search_radius 1
time: {end: 2, steps: 4}
newton: {displacement_tolerance: 0.001}  # FEBio: dtol, etol
output: {name: m_results}
)");
}

TEST(Import, MeshKeepsIdsNamesAndSets) {
  const mesh::MeshData mesh = scene_with({}).mesh;
  EXPECT_EQ(mesh.node_id, (std::vector<Global>{1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17,
                                               18})); // node 99 belongs to no element
  ASSERT_EQ(mesh.blocks.size(), 2u);
  EXPECT_EQ(mesh.blocks[1].name, "upper");
  EXPECT_EQ(mesh.blocks[1].element_id, std::vector<Global>{9});
  EXPECT_EQ(mesh.blocks[1].nodes, (std::vector<Global>{8, 9, 10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(mesh.x[3 * 13], 1.0);
  EXPECT_EQ(mesh.x[3 * 13 + 2], 2.0);
  EXPECT_EQ(mesh.node_sets.at("bottom"), (std::vector<Global>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.node_sets.at("all").size(), 16u);
  const auto& upper = mesh.side_sets.at("up_face");
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_EQ(upper[0].block, 1);
  EXPECT_EQ(upper[0].side, 4); // z = least
  EXPECT_EQ(mesh.side_sets.at("low face")[0].side, 5);
}

TEST(Import, EveryConstructIsReported) {
  const Report report =
      scene_with({{3, "<Globals><Constants><T>0</T></Constants></Globals><Control>"
                      "<time_steps>4</time_steps><step_size>0.5</step_size>"
                      "<solver type=\"solid\"><dtol>0.1</dtol></solver>"
                      "</Control>"}})
          .report;
  EXPECT_EQ(report.count(Fate::refused), 0);
  const std::string text = report.text("m.feb");
  for (const char* line :
       {"used  line 5  Material/material 'soft one'\n", "used  line 5  Material/material/E\n",
        "used  line 40  Contact/contact/penalty\n",
        "ignored  line 3  Globals: ", "1 nodes that belong to no element"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "in\n" << text;
  EXPECT_EQ(text.find("/elem"), std::string::npos) << text; // counts with what holds it
}

TEST(Import, Materials) {
  const auto material = [](const std::string& type, const std::string& parameters) {
    return section(scene_with({{5, "<material id=\"1\" name=\"soft one\" type=\"" + type + "\">" +
                                       parameters + "</material>"}})
                       .deck,
                   "materials");
  };
  EXPECT_EQ(material("Mooney-Rivlin", "<c1>1</c1><c2>0</c2><k>100</k>"),
            "materials:\n  soft_one: {model: mooney_rivlin, c1: 1, bulk: 100}  # FEBio: soft one, "
            "Mooney-Rivlin\n");
  EXPECT_EQ(material("Ogden", "<k>9</k><c1>1</c1><m1>2</m1><c2>0</c2><m2>1</m2><c3>0.5</c3>"
                              "<m3>-3</m3>"),
            "materials:\n  soft_one: {model: ogden, coefficients: [1, 0.5], exponents: [2, -3], "
            "bulk: 9}  # FEBio: soft one, Ogden\n");
  EXPECT_EQ(material("Ogden unconstrained", "<cp>4</cp><c1>1</c1><m1>2</m1>"),
            "materials:\n  soft_one: {model: ogden_unconstrained, coefficients: [1], exponents: "
            "[2], lambda: 4}  # FEBio: soft one, Ogden unconstrained\n");
  EXPECT_EQ(material("Holmes-Mow", "<E>1</E><v>0.1</v><beta>0.5</beta>"),
            "materials:\n  soft_one: {model: holmes_mow, young: 1, poisson: 0.1, beta: 0.5}  # "
            "FEBio: soft one, Holmes-Mow\n");
  EXPECT_EQ(material("isotropic elastic", "<E>1</E><v>0.1</v>"),
            "materials:\n  soft_one: {model: saint_venant_kirchhoff, young: 1, poisson: 0.1}  # "
            "FEBio: soft one, isotropic elastic\n");
}

TEST(Import, Elements) {
  const std::string deck =
      scene_with({{5, "<material id=\"1\" name=\"soft one\" type=\"Mooney-Rivlin\"><c1>1</c1>"
                      "<c2>0</c2><k>100</k></material>"}})
          .deck;
  EXPECT_EQ(section(deck, "bodies"),
            "bodies:\n"
            "  lower: {blocks: [lower], material: soft_one, element: mean_dilatation}\n"
            "  upper: {blocks: [upper], material: soft_one, element: mean_dilatation}\n");
}

TEST(Import, PrescribedWinsOverFixed) {
  const Scene scene = scene_with({{31, "<bc name=\"hold\" node_set=\"all\" type=\"zero "
                                       "displacement\">"}});
  EXPECT_EQ(section(scene.deck, "displacements"),
            "displacements:\n"
            "  hold: {set: all_rest, fix: [z]}\n"
            "  hold_2: {set: all, fix: [x, y]}  # FEBio: hold\n"
            "  press: {set: top, z: -0.1, curve: LC1}\n");
  EXPECT_EQ(scene.mesh.node_sets.at("all_rest").size(), 12u);
  EXPECT_NE(scene.report.text("").find("4 nodes have their z displacement prescribed instead"),
            std::string::npos);
}

TEST(Import, ConditionsOfOneSetStandTogether) {
  const Scene scene =
      scene_with({{31, "<bc name=\"a\" node_set=\"bottom\" type=\"zero "
                       "displacement\"><x_dof>1</x_dof></bc><bc name=\"b\" "
                       "node_set=\"bottom\" type=\"zero displacement\">"},
                  {32, "<y_dof>1</y_dof></bc><bc name=\"c\" node_set=\"@surface:low "
                       "face\" type=\"zero displacement\"><z_dof>1</z_dof></bc>"}});
  EXPECT_EQ(section(scene.deck, "displacements"), "displacements:\n"
                                                  "  a: {set: bottom, fix: [x, y]}  # FEBio: b\n"
                                                  "  c: {set: \"low face\", fix: [z]}\n"
                                                  "  press: {set: top, z: -0.1, curve: LC1}\n");
}

TEST(Import, ValueWithoutCurveHoldsAtAllTimes) {
  const Scene scene = scene_with({{34, "<dof>z</dof><value>-0.1</value></bc>"}});
  EXPECT_EQ(section(scene.deck, "curves"), "curves:\n  constant: [[0, 1], [2, 1]]\n");
  EXPECT_NE(scene.deck.find("z: -0.1, curve: constant"), std::string::npos);
}

const std::map<std::size_t, std::string> upper_is_rigid = {
    {29, "<SolidDomain name=\"upper\" mat=\"plate\"/></MeshDomains>"}};

Scene rigid_scene(const std::string& conditions, std::map<std::size_t, std::string> more = {}) {
  auto changes = upper_is_rigid;
  changes[36] = "<Rigid>" + conditions + "</Rigid>";
  changes.insert(more.begin(), more.end());
  return scene_with(changes);
}

TEST(Import, RigidBodies) {
  const std::string fixed = "<rigid_bc name=\"f\" type=\"rigid_fixed\"><rb>plate</rb>"
                            "<Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof><Rz_dof>1</Rz_dof>"
                            "<Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>";
  const std::string down = "<rigid_bc name=\"d\" type=\"rigid_displacement\"><rb>plate</rb>"
                           "<dof>z</dof><value lc=\"1\">-0.2</value></rigid_bc>";
  const std::string turn = "<rigid_bc name=\"t\" type=\"rigid_rotation\"><rb>plate</rb>"
                           "<dof>Rw</dof><value lc=\"1\">0.3</value></rigid_bc>";
  const auto body = [](const Scene& scene) {
    const std::string bodies = section(scene.deck, "bodies");
    return bodies.substr(bodies.find("  plate:"));
  };
  // The nodes of the body are not prescribed besides.
  Scene scene = rigid_scene(fixed);
  EXPECT_EQ(body(scene), "  plate:\n    blocks: [upper]\n    rigid: {}\n");
  EXPECT_EQ(scene.deck.find("press"), std::string::npos);
  EXPECT_NE(scene.report.text("").find("4 nodes move with rigid bodies instead"),
            std::string::npos);
  // A prescribed component wins over a fixed one, whatever their order.
  EXPECT_EQ(body(rigid_scene(down + fixed)),
            "  plate:\n    blocks: [upper]\n    rigid: {displacement: [0, 0, -0.2], curve: LC1}\n");
  EXPECT_EQ(body(rigid_scene(down + fixed + turn)),
            "  plate:\n    blocks: [upper]\n    rigid: {displacement: [0, 0, -0.2], rotation: [0, "
            "0, 0.3], center: [0.5, 0.5, 1.5], curve: LC1}\n");
  // Components that nothing holds are free, and may be loaded.
  const std::string force = "<rigid_load name=\"l\" type=\"rigid_force\"><rb>plate</rb>"
                            "<dof>Rx</dof><value lc=\"1\">7</value></rigid_load>";
  EXPECT_EQ(
      body(rigid_scene(down + force)),
      "  plate:\n    blocks: [upper]\n    rigid: {displacement: [0, 0, -0.2], center: [0.5, "
      "0.5, 1.5], curve: LC1, free: [x, y, rx, ry, rz], force: [7, 0, 0], load_curve: LC1}\n");
}

// A rigid body that has no elements and does not turn prescribes displacements, and nothing else.
TEST(Import, NodesTiedToARigidBodyWithoutElements) {
  const auto scene = [](const std::string& free, const std::string& more) {
    return scene_with(
        {{33, "<bc name=\"press\" node_set=\"top\" type=\"rigid\"><rb>plate</rb></bc>"},
         {34, ""},
         {36, "<Rigid><rigid_bc name=\"f\" type=\"rigid_fixed\"><rb>plate</rb>"
              "<Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof><Rz_dof>1</Rz_dof><Ru_dof>1</Ru_dof>"
              "<Rv_dof>1</Rv_dof><Rw_dof>" +
                  free + "</Rw_dof></rigid_bc>" + more + "</Rigid>"}});
  };
  const std::string down = "<rigid_bc name=\"d\" type=\"rigid_displacement\"><rb>plate</rb>"
                           "<dof>z</dof><value lc=\"1\">-0.2</value></rigid_bc>";
  const std::string deck = scene("1", down).deck;
  EXPECT_EQ(section(deck, "bodies"),
            "bodies:\n"
            "  lower: {blocks: [lower], material: soft_one, element: displacement}\n"
            "  upper: {blocks: [upper], material: soft_one, element: displacement}\n");
  EXPECT_EQ(section(deck, "displacements"),
            "displacements:\n"
            "  hold: {set: bottom, fix: [x, y, z]}\n"
            "  top: {set: top, z: -0.2, fix: [x, y], curve: LC1}  # FEBio: tied to rigid body "
            "plate\n");
  // One that turns stays a body.
  const std::string turning = section(scene("0", "").deck, "bodies");
  EXPECT_EQ(turning.substr(turning.find("  plate:")),
            "  plate:\n    node_sets: [top]\n    rigid: {free: [rz]}\n");
}

TEST(Import, RigidMaterialsThatShareNodesAreOneBody) {
  const Scene scene = rigid_scene(
      "<rigid_bc name=\"f\" type=\"rigid_fixed\"><rb>second</rb><Rx_dof>1</Rx_dof></rigid_bc>",
      {{7, "<material id=\"3\" name=\"second\" type=\"rigid body\"/></Material>"},
       {33, "<bc name=\"press\" node_set=\"top\" type=\"rigid\"><rb>second</rb></bc>"},
       {34, ""}});
  const std::string bodies = section(scene.deck, "bodies");
  EXPECT_EQ(bodies.substr(bodies.find("  plate:")),
            "  plate:  # FEBio: plate and second\n    blocks: [upper]\n    node_sets: [top]\n"
            "    rigid: {center: [0.5, 0.5, 1.5], free: [y, z, rx, ry, rz]}\n");
}

TEST(Import, Loads) {
  const Scene scene = scene_with(
      {{37, "<Loads><surface_load name=\"p\" surface=\"low face\" type=\"pressure\"><pressure "
            "lc=\"1\">3</pressure></surface_load><nodal_load name=\"n\" node_set=\"top\" "
            "type=\"nodal_load\"><dof>x</dof><scale lc=\"1\">2</scale></nodal_load><body_load "
            "type=\"const\"><z lc=\"1\">9.8</z></body_load></Loads>"},
       {5, "<material id=\"1\" name=\"soft one\" type=\"neo-Hookean\"><density>2</density>"
           "<E>10</E><v>0.3</v></material>"}});
  EXPECT_EQ(section(scene.deck, "loads"),
            "loads:\n"
            "  p: {pressure: 3, side_set: \"low face\", curve: LC1}\n"
            "  n: {force: [2, 0, 0], node_set: top, curve: LC1}\n"
            "  weight_of_lower: {body_force: [0, 0, -19.6], block: lower, curve: LC1}\n"
            "  weight_of_upper: {body_force: [0, 0, -19.6], block: upper, curve: LC1}\n");
}

std::string contact_with(const std::string& type, const std::string& parameters) {
  return section(scene_with({{38, "<Contact><contact name=\"touch\" surface_pair=\"pair\" type=\"" +
                                      type + "\">"},
                             {39, parameters},
                             {40, ""},
                             {41, ""}})
                     .deck,
                 "contact");
}

TEST(Import, ContactParameters) {
  const std::string sides =
      "contact:\n  touch:\n    primary: \"low face\"\n    secondary: up_face\n";
  EXPECT_EQ(contact_with("sliding-facet-on-facet", ""), sides + "    penalty: 1\n");
  // FEBio adds its two passes up.
  EXPECT_EQ(contact_with("sliding-facet-on-facet",
                         "<two_pass>1</two_pass><auto_penalty>1</auto_penalty><penalty "
                         "lc=\"1\">3</penalty>"),
            sides + "    two_pass: true\n    penalty_factor: 6  # twice FEBio's: its two passes "
                    "add up\n    penalty_curve: LC1\n");
  EXPECT_EQ(contact_with("sliding-node-on-facet",
                         "<laugon>AUGLAG</laugon><tolerance>0.05</tolerance><gaptol>1e-3</gaptol>"
                         "<minaug>2</minaug><fric_coeff>0.4</fric_coeff><fric_penalty>1"
                         "</fric_penalty><seg_up>4</seg_up><search_tol>0.1</search_tol>"),
            sides + "    formulation: node_on_facet\n    enforcement: augmented_lagrangian\n"
                    "    penalty: 1\n    friction: 0.4\n    multipliers: per_point\n    "
                    "multiplier_tolerance: 0.05\n"
                    "    gap_limit: 0.001\n    min_augmentations: 2\n    max_augmentations: 10\n"
                    "    projection_margin: 0.1\n    segment_updates: 4\n");
  // No friction without a tangential penalty; the tolerance of the ray formulation is of squares.
  EXPECT_EQ(contact_with("sliding-node-on-facet", "<fric_coeff>0.4</fric_coeff>"),
            sides + "    formulation: node_on_facet\n    penalty: 1\n");
  EXPECT_EQ(contact_with("sliding-elastic",
                         "<laugon>AUGLAG</laugon><tolerance>0.1</tolerance><maxaug>20</maxaug>"
                         "<fric_coeff>0.4</fric_coeff><search_radius>5</search_radius>"
                         "<offset>0.01</offset>"),
            sides + "    formulation: sliding_elastic\n    enforcement: augmented_lagrangian\n"
                    "    penalty: 1\n    friction: 0.4\n    multipliers: per_point\n    "
                    "multiplier_tolerance: 0.0513\n"
                    "    offset: 0.01\n");
  // Without any tolerance FEBio never augments.
  EXPECT_EQ(contact_with("sliding-elastic", "<laugon>AUGLAG</laugon><tolerance>0</tolerance>"
                                            "<search_radius>5</search_radius>"),
            sides + "    formulation: sliding_elastic\n    penalty: 1\n");
}

TEST(Import, TiedContact) {
  const std::string sides =
      "contact:\n  touch:\n    primary: \"low face\"\n    secondary: up_face\n";
  EXPECT_EQ(contact_with("tied-node-on-facet",
                         "<laugon>AUGLAG</laugon><penalty>7</penalty><maxaug>20</maxaug>"
                         "<max_distance>0.2</max_distance><node_reloc>1</node_reloc>"),
            sides + "    formulation: node_on_facet\n    tied: true\n    tie_distance: 0.2\n"
                    "    enforcement: augmented_lagrangian\n    penalty: 7\n"
                    "    multipliers: per_point\n    projection_margin: 1e-04\n");
  EXPECT_EQ(contact_with("tied-facet-on-facet", "<penalty>7</penalty>"),
            sides + "    tied: true\n    tie_distance: 3\n    tie_gap: close\n    penalty: 7\n"
                    "    projection_margin: 1e-04\n");
  EXPECT_EQ(contact_with("sticky", "<penalty>7</penalty><search_tolerance>0.01</search_tolerance>"
                                   "<max_traction>3</max_traction><snap_tol>0.2</snap_tol>"),
            sides + "    formulation: node_on_facet\n    sticky: true\n    stick_within: 0.2\n"
                    "    stick_strength: 3\n    penalty: 7\n");
  EXPECT_EQ(contact_with("tied-elastic", "<two_pass>1</two_pass><gaptol>-1</gaptol>"),
            sides + "    formulation: sliding_elastic\n    tied: true\n    tie_distance: 1\n"
                    "    two_pass: true\n    penalty: 2  # twice FEBio's: its two passes add up\n");
}

std::map<std::size_t, std::string> wall(const std::string& parameters) {
  return {
      {35, "</Boundary><Constraints><constraint name=\"wall\" type=\"rigid_wall\" surface=\"low "
           "face\">" +
               parameters + "</constraint></Constraints>"}};
}

// The plane's normal has length 2: FEBio's gap is 4 (place + offset / 4 - n.x).
TEST(Import, RigidWallsAreBricks) {
  const Scene scene = scene_with(wall("<penalty lc=\"1\">5</penalty><offset lc=\"1\">0.4</offset>"
                                      "<plane>0,0,-2,-3</plane>"));
  const std::string bodies = section(scene.deck, "bodies");
  EXPECT_EQ(bodies.substr(bodies.find("  wall:")),
            "  wall:\n    blocks: [wall]\n    rigid: {displacement: [0, 0, -0.1], curve: LC1}\n");
  const std::string contact = section(scene.deck, "contact");
  EXPECT_EQ(contact.substr(contact.find("  wall:")),
            "  wall:\n    primary: \"low face\"\n    secondary: wall\n"
            "    formulation: node_on_facet\n    penalty: 20\n    penalty_curve: LC1\n");
  const mesh::BlockData& brick = scene.mesh.blocks.at(2);
  EXPECT_EQ(brick.element_id, std::vector<Global>{10});
  for (std::size_t a = 0; a < 8; ++a) {
    const double z = scene.mesh.x[3 * std::size_t(brick.nodes[a]) + 2];
    if (a < 4)
      EXPECT_GT(z, 3.0); // behind the plane
    else
      EXPECT_DOUBLE_EQ(z, 1.5);
  }
  EXPECT_EQ(scene.mesh.side_sets.at("wall").at(0).block, 2);
  EXPECT_EQ(error_with(wall("<penalty>5</penalty><plane>0,0,0,1</plane>")),
            "m.feb:35: <plane>: expected a, b, c, d with a normal (a, b, c)");
  EXPECT_EQ(error_with(wall("<laugon>AUGLAG</laugon><penalty>5</penalty><plane>0,0,1,1</plane>")),
            "m.feb:35: <constraint>: AUGLAG expects a <tolerance> > 0");
}

TEST(Import, BodyLoadOfOnePart) {
  const Scene scene =
      scene_with({{37, "<Loads><body_load name=\"w\" type=\"const\" elem_set=\"upper\"><x>3</x>"
                       "</body_load></Loads>"}});
  EXPECT_EQ(section(scene.deck, "loads"),
            "loads:\n"
            "  w_of_upper: {body_force: [-3, 0, 0], block: upper, curve: constant}  # FEBio: w\n");
}

TEST(Import, FacesThatPointInwardsAreRefusedUnlessFlipped) {
  const std::map<std::size_t, std::string> inward = {
      {24, "<Surface name=\"low face\"><quad4 id=\"1\">8,7,6,5</quad4></Surface>"}};
  EXPECT_EQ(error_with(inward),
            "m.feb:38: Contact/contact 'touch': the faces of surface 'low face' "
            "point into their bodies");
  auto flipped = inward;
  flipped[41] = "<flip_primary>1</flip_primary>";
  EXPECT_EQ(error_with(flipped), "no error");
}

TEST(Import, StepsMeetTheMustPoints) {
  const auto time = [](const std::string& points) {
    const Scene scene = scene_with(
        {{3, "<Control><time_steps>4</time_steps><step_size>0.5</step_size><time_stepper>"
             "<dtmax lc=\"2\">1</dtmax></time_stepper></Control>"},
         {44, "<points><pt>0,0</pt><pt>2,1</pt></points></load_controller><load_controller "
              "id=\"2\" type=\"loadcurve\"><points>" +
                  points + "</points></load_controller></LoadData>"}});
    return section(scene.deck, "time");
  };
  EXPECT_EQ(time("<pt>0,0.1</pt><pt>1.5,0.1</pt><pt>3,0.1</pt>"), "time: {end: 2, steps: 4}\n");
  EXPECT_EQ(time("<pt>0,0.1</pt><pt>1.1,0.1</pt>"), "time: {end: 2, steps: 20}\n");
}

TEST(Import, TolerancesOfNewtonAreFebios) {
  const auto newton = [](const std::string& solver) {
    const Scene scene = scene_with({{3, "<Control><time_steps>4</time_steps><step_size>0.5"
                                        "</step_size><solver type=\"solid\">" +
                                            solver + "</solver></Control>"}});
    return section(scene.deck, "newton");
  };
  EXPECT_EQ(newton("<dtol>0.1</dtol><etol>0.02</etol><lstol>1</lstol>"),
            "newton: {displacement_tolerance: 0.1, energy_tolerance: 0.02}  # FEBio: dtol, etol\n");
  EXPECT_EQ(newton("<dtol>0</dtol>"), ""); // FEBio's own sign for off: abut's residual decides
}

TEST(Import, SectionsMayStandInAStep) {
  const Scene plain = scene_with({});
  const Scene stepped = scene_with({{3, ""},
                                    {42, "</contact></Contact><Step><step id=\"1\" name=\"s\">"
                                         "<Control><time_steps>4</time_steps><step_size>0.5"
                                         "</step_size></Control></step></Step>"}});
  EXPECT_EQ(stepped.deck, plain.deck);
}

TEST(Import, Latin1AndLinesGoTogether) {
  std::string text = with({{1, "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><!-- M\xfcller -->"},
                           {19, "<elem id=\"7\">1,2,3,4,5,6,7,77</elem></Elements>"}});
  EXPECT_EQ(error_of(text), "m.feb:19: <elem>: there is no node 77");
}

} // namespace
