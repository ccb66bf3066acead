// SPDX-License-Identifier: BSD-3-Clause
#include "scene.hpp"

#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <cstdio>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::deck;

TEST(Deck, FillsEverySection) {
  const Deck d = parse_deck(yaml_scene, "decks/ball.yaml");
  EXPECT_EQ(d.title, "ball on floor");
  EXPECT_EQ(d.mesh_path(), "decks/ball.exo");
  ASSERT_EQ(d.materials.size(), 1u);
  EXPECT_EQ(d.materials[0].name, "rubber");
  EXPECT_EQ(d.materials[0].young, 10.0);
  ASSERT_EQ(d.bodies.size(), 2u);
  EXPECT_THAT(d.bodies[0].blocks, testing::ElementsAre("ball", "core"));
  EXPECT_FALSE(d.bodies[0].rigid);
  EXPECT_TRUE(d.bodies[1].rigid);
  EXPECT_THAT(d.bodies[1].motion.rotation, testing::ElementsAre(0.0, 0.0, 1e-3));
  EXPECT_THAT(d.bodies[1].motion.center, testing::ElementsAre(1.0, 2.0, 3.0));
  ASSERT_EQ(d.displacements.size(), 1u);
  EXPECT_THAT(d.displacements[0].components, testing::ElementsAre(true, true, true));
  EXPECT_THAT(d.displacements[0].values, testing::ElementsAre(0.0, 0.0, -0.5));
  ASSERT_EQ(d.surfaces.size(), 3u);
  EXPECT_EQ(d.surfaces[0].body, "ball");
  EXPECT_EQ(d.surfaces[0].selection.plane->normal[2], 2.0);
  EXPECT_EQ(d.surfaces[0].selection.normal->angle, 10.0);
  EXPECT_FALSE(d.surfaces[0].selection.box.has_value());
  EXPECT_EQ(d.surfaces[1].selection.cylinder->radius, 2.0);
  EXPECT_EQ(d.surfaces[1].selection.within, 0.01);
  EXPECT_EQ(d.surfaces[2].subtract, std::vector<std::string>{"lid"});
  ASSERT_EQ(d.loads.size(), 4u);
  EXPECT_EQ(d.loads[0].kind, solid::LoadKind::traction);
  EXPECT_EQ(d.loads[0].place, "skin");
  EXPECT_EQ(d.loads[1].kind, solid::LoadKind::pressure);
  EXPECT_EQ(d.loads[1].pressure.number, 2.5);
  EXPECT_EQ(d.loads[2].kind, solid::LoadKind::body_force);
  EXPECT_EQ(d.loads[2].vector[2].number, -9.81);
  EXPECT_EQ(d.loads[3].kind, solid::LoadKind::force);
  EXPECT_EQ(d.loads[3].place, "hook");
  ASSERT_EQ(d.contact.size(), 1u);
  EXPECT_EQ(d.contact[0].name, "ball_on_floor");
  EXPECT_EQ(d.contact[0].enforcement, contact::Enforcement::augmented_lagrangian);
  EXPECT_EQ(d.contact[0].penalty_factor, 20.0);
  EXPECT_EQ(d.time.steps, 4);
  EXPECT_FALSE(d.time.adaptive);
  EXPECT_EQ(d.newton.line_search, solver::LineSearch::none);
  EXPECT_EQ(d.linear.method, solver::LinearMethod::krylov);
  EXPECT_EQ(d.linear.direct_limit, 100000);
  EXPECT_EQ(d.output.every, 2);
  ASSERT_EQ(d.verify.size(), 2u);
  EXPECT_EQ(d.verify[0].quantity, Quantity::force_z);
  EXPECT_DOUBLE_EQ(d.verify[0].allowed_error(), 0.06);
  EXPECT_EQ((*d.verify[1].point)[2], 1.0);
  EXPECT_EQ(d.verify[1].allowed_error(), 1e-9);
}

TEST(Deck, KeepsTheStructsDefaults) {
  const Deck d = parse_deck("mesh: {file: a.exo}\nmaterials: {m: {young: 1, poisson: 0}}\n"
                            "bodies: {b: {blocks: [1], material: m}}\n"
                            "contact: {c: {primary: p, secondary: s}}\n",
                            "a.yaml");
  const contact::ContactOptions contact;
  EXPECT_EQ(d.contact[0].penalty_factor, contact.penalty_factor);
  EXPECT_EQ(d.contact[0].max_augmentations, contact.max_augmentations);
  EXPECT_EQ(d.linear.direct_limit, solver::LinearOptions().direct_limit);
  EXPECT_EQ(d.bodies[0].blocks[0], "1");
  EXPECT_EQ(d.mesh_path(), "a.exo");
  EXPECT_TRUE(d.newton.nox.empty());
}

TEST(Deck, FurtherFieldsAreThoseNamed) {
  const std::string before = "mesh: {file: a.exo}\nmaterials: {m: {young: 1, poisson: 0}}\n"
                             "bodies: {b: {blocks: [1], material: m}}\n";
  const Deck none = parse_deck(before, "a.yaml");
  EXPECT_FALSE(none.output.fields.strain || none.output.fields.nodal_stress ||
               none.output.fields.principal_stress || none.output.fields.stress_tensor);
  EXPECT_TRUE(none.output.history);
  const Deck some =
      parse_deck(before + "output: {fields: [nodal_stress, strain], history: false}\n", "a.yaml");
  EXPECT_TRUE(some.output.fields.strain && some.output.fields.nodal_stress);
  EXPECT_FALSE(some.output.fields.principal_stress || some.output.fields.stress_tensor);
  EXPECT_FALSE(some.output.history);
  EXPECT_EQ(to_yaml(parse_deck(to_yaml(some), "a.yaml")), to_yaml(some));
  EXPECT_THAT(to_yaml(some), testing::HasSubstr("fields: [\"strain\", \"nodal_stress\"]"));
}

TEST(Deck, AWordStandsForANumberThatIsNotGiven) {
  const std::string before = "mesh: {file: a.exo}\nmaterials: {m: {young: 1, poisson: 0}}\n"
                             "bodies: {b: {blocks: [1], material: m}}\n"
                             "newton: {displacement_tolerance: ";
  const Deck none = parse_deck(
      before + "none}\ncontact: {c: {primary: p, secondary: s, penalty: automatic, points: "
               "automatic, until: end, segment_updates: unlimited, stick_strength: unlimited, "
               "gap_limit: none, gap_tolerance: automatic, uzawa: end_of_step}}\n",
      "a.yaml");
  const contact::ContactOptions& o = none.contact[0];
  EXPECT_FALSE(o.penalty || o.points || o.window.until || o.segment_updates || o.stick_strength ||
               o.gap_limit || o.gap_tolerance || none.newton.displacement_tolerance);
  EXPECT_EQ(o.uzawa, contact::Uzawa::end_of_step);
  EXPECT_THAT(to_yaml(none), testing::HasSubstr("penalty: automatic\n"));
  EXPECT_EQ(to_yaml(parse_deck(to_yaml(none), "a.yaml")), to_yaml(none));
  const Deck given = parse_deck(
      before + "0.1}\ncontact: {c: {primary: p, secondary: s, penalty: 3, points: 4}}\n", "a.yaml");
  EXPECT_EQ(given.contact[0].penalty, 3.0);
  EXPECT_EQ(given.contact[0].points, 4);
  EXPECT_EQ(given.newton.displacement_tolerance, 0.1);
}

TEST(Deck, AbsentComponentIsFree) {
  const Deck d = parse_deck("mesh: {file: a.exo}\nmaterials: {m: {young: 1, poisson: 0}}\n"
                            "bodies: {b: {blocks: [1], material: m}}\n"
                            "displacements: {d: {set: s, y: 2}, e: {set: s, fix: [z]}}\n",
                            "a.yaml");
  EXPECT_THAT(d.displacements[0].components, testing::ElementsAre(false, true, false));
  EXPECT_THAT(d.displacements[0].values, testing::ElementsAre(0.0, 2.0, 0.0));
  EXPECT_THAT(d.displacements[1].components, testing::ElementsAre(false, false, true));
}

TEST(Deck, WhatHoldsForATime) {
  const std::string text =
      "mesh: {file: a.exo}\nmaterials: {m: {young: 1, poisson: 0}}\n"
      "bodies:\n  b: {blocks: [1], material: m}\n"
      "  r: {blocks: [2], rigid: {free: [z, rx], holds: {h: {z: 2, fix: [rx], curve: c, from: 1, "
      "relative: true}}}}\n"
      "displacements: {d: {set: s, y: 2, from: 1, until: 2}, e: {set: s, y: 1, from: 2}}\n"
      "curves: {c: [[0, 0], [3, 1]]}\ntime: {end: 3}\n";
  const Deck d = parse_deck(text, "a.yaml");
  const rigid::HoldOptions& hold = d.bodies[1].motion.holds[0];
  EXPECT_THAT(hold.components, testing::ElementsAre(false, false, true, true, false, false));
  EXPECT_THAT(hold.values, testing::ElementsAre(0, 0, 2, 0, 0, 0));
  EXPECT_TRUE(hold.relative);
  EXPECT_EQ(hold.curve, "c");
  EXPECT_EQ(hold.window, (Window{1.0, {}}));
  const Window first = d.displacements[0].window, second = d.displacements[1].window;
  EXPECT_EQ(first, (Window{1.0, 2.0}));
  EXPECT_FALSE(first.overlaps(second));
  EXPECT_TRUE(first.overlaps(hold.window));
  EXPECT_TRUE(first.holds(2.0) && !first.holds(1.0) && first.holds(1.001) && !first.holds(2.001));
  EXPECT_TRUE(Window().holds(0.0) && Window().is_whole_run() && !first.is_whole_run());
  const std::string written = to_yaml(d);
  EXPECT_EQ(to_yaml(parse_deck(written, "a.yaml")), written);
}

TEST(Deck, XmlGivesTheSameDeckAsYaml) {
  const Deck yaml = parse_deck(yaml_scene, "ball.yaml");
  const Deck xml = parse_deck(xml_scene, "ball.xml");
  EXPECT_EQ(to_yaml(yaml), to_yaml(xml));
  EXPECT_EQ(yaml.newton.nox, xml.newton.nox);
  EXPECT_EQ(yaml.linear.muelu, xml.linear.muelu);
  ASSERT_EQ(yaml.locations.size(), xml.locations.size());
  EXPECT_EQ(xml.where("contact.ball_on_floor.secondary"),
            "ball.xml:96: contact.ball_on_floor.secondary");
}

TEST(Deck, WrittenDeckReadsBackTheSame) {
  const Deck deck = parse_deck(yaml_scene, "ball.yaml");
  const std::string written = to_yaml(deck);
  // What was asked, and defaults that were not, are both there.
  EXPECT_THAT(written, testing::HasSubstr("penalty_factor: 20\n"));
  EXPECT_THAT(written, testing::HasSubstr("max_augmentations: 20\n"));
  EXPECT_THAT(written, testing::HasSubstr("side_set: \"inside\"\n"));
  EXPECT_THAT(written, testing::HasSubstr("\"max levels\": 3\n"));
  const Deck again = parse_deck(written, "ball.yaml");
  EXPECT_EQ(to_yaml(again), written);
  EXPECT_EQ(again.linear.muelu, deck.linear.muelu);
}

TEST(Deck, JointsOfEveryKind) {
  const std::string text = R"(mesh: {file: a.exo}
bodies:
  a: {blocks: [a], rigid: {free: [x], force: [1, 0, 0], load_curves: {x: up}}}
  b: {blocks: [b], rigid: {}}
joints:
  pin: {kind: revolute, bodies: [a, b], origin: [1, 2, 3], axis: [0, 0, 2], rotation: 2 * t, curve: up}
  rail: {kind: prismatic, bodies: [ground, a], origin: [0, 0, 0], axis: [1, 0, 0], force: 4}
  rod: {kind: cylindrical, bodies: [a, b], origin: [0, 0, 0], axis: [1, 0, 0], translation: 3, moment: 5}
  ball: {kind: spherical, bodies: [a, b], origin: [0, 0, 1], rotation_vector: [t, 2, 0], curve: up}
  weld: {kind: lock, bodies: [a, b], origin: [0, 0, 1]}
  coil: {kind: spring, bodies: [a, b], from: [0, 0, 1], to: [0, 0, 2], stiffness: 10}
  pull: {kind: spring, bodies: [a, b], from: [0, 0, 1], to: [0, 0, 1], stiffness: 10, free_length: 0}
curves: {up: [[0, 0], [1, 2]]}
verify: {v: {quantity: joint_moment_z, place: pin, expected: 1, tolerance: 1}}
)";
  const Deck deck = parse_deck(text, "d.yaml");
  ASSERT_EQ(deck.joints.size(), 7u);
  const rigid::JointOptions& pin = deck.joints[0];
  EXPECT_EQ(pin.kind, rigid::JointKind::revolute);
  EXPECT_EQ(pin.bodies, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(pin.origin[2], 3.0);
  EXPECT_EQ(pin.rotation->at(Vec3::zero(), 0.5, curve_named(deck.curves, "up")), 1.0);
  EXPECT_FALSE(pin.moment || pin.translation || pin.force);
  EXPECT_EQ(deck.joints[1].force->at(Vec3::zero(), 0.5, {}), 2.0);
  EXPECT_EQ(deck.joints[2].translation->number, 3.0);
  EXPECT_EQ((*deck.joints[3].rotation_vector)[1].number, 2.0);
  EXPECT_EQ(deck.joints[5].stiffness, 10.0);
  EXPECT_FALSE(deck.joints[5].free_length);
  EXPECT_EQ(deck.joints[6].free_length, 0.0);
  EXPECT_EQ(deck.bodies[0].motion.load_curves[0], "up");
  EXPECT_TRUE(is_joint_quantity(deck.verify[0].quantity));
  const std::string written = to_yaml(deck);
  EXPECT_EQ(to_yaml(parse_deck(written, "d.yaml")), written);
}

TEST(Deck, TrilinosListsArriveTyped) {
  const Deck d = parse_deck(yaml_scene, "ball.yaml");
  const auto nox = Teuchos::getParametersFromXmlString(d.newton.nox);
  EXPECT_EQ(nox->sublist("Line Search").get<std::string>("Method"), "Full Step");
  const auto muelu = Teuchos::getParametersFromXmlString(d.linear.muelu);
  EXPECT_EQ(muelu->get<int>("max levels"), 3);
  EXPECT_EQ(muelu->get<double>("sa: damping factor"), 1.5);
  EXPECT_FALSE(muelu->get<bool>("repartition: enable"));
  EXPECT_TRUE(d.linear.belos.empty());
}

TEST(Deck, GeneratorKeysKeepTheirPlace) {
  const Deck d = parse_deck("mesh:\n  generate:\n    kind: blocks\n    size: [1, 2.5, 3]\n"
                            "    order: 2\nmaterials: {m: {young: 1, poisson: 0}}\n"
                            "bodies: {b: {blocks: [1], material: m}}\n",
                            "a.yaml");
  EXPECT_EQ(d.mesh.kind, "blocks");
  ASSERT_EQ(d.mesh.parameters.size(), 2u);
  EXPECT_EQ(d.mesh.parameters[0].key, "size");
  EXPECT_EQ(d.mesh.parameters[0].text, "1,2.5,3");
  EXPECT_EQ(d.mesh.generator_options().at("order"), "2");
  EXPECT_EQ(d.mesh.parameters[1].where.text(), "a.yaml:5");
  EXPECT_EQ(d.where("mesh.generate.order"), "a.yaml:5: mesh.generate.order");
  EXPECT_EQ(to_yaml(parse_deck(to_yaml(d), "a.yaml")), to_yaml(d));
}

TEST(Deck, DynamicsIsThereOrNot) {
  const std::string still = R"(
mesh: {file: m.exo}
materials: {steel: {young: 1, poisson: 0.3, density: 2}}
bodies:
  block: {blocks: [a], material: steel}
  cap: {node_sets: [b], rigid: {}}
)";
  const Deck statics = parse_deck(still, "a.yaml");
  EXPECT_FALSE(statics.dynamics.active);
  EXPECT_EQ(to_yaml(statics).find("dynamics"), std::string::npos);
  EXPECT_EQ(statics.materials[0].density, 2.0);
  EXPECT_TRUE(parse_deck(still + "dynamics: {}\n", "a.yaml").dynamics.active);
  const Deck moves = parse_deck(R"(
mesh: {file: m.exo}
materials: {steel: {young: 1, poisson: 0.3, density: 2}}
bodies:
  block: {blocks: [a], material: steel, initial_velocity: [1, 2, 3]}
  cap:
    node_sets: [b]
    rigid: {free: [x, rx], mass: 3, moments_of_inertia: [1, 2, 3], products_of_inertia: [0, 0.1, 0]}
    initial_angular_velocity: [0.5, 0, 0]
dynamics: {beta: 0.3, gamma: 0.6}
)",
                                "a.yaml");
  EXPECT_EQ(moves.dynamics.rule().beta, 0.3);
  EXPECT_EQ(moves.dynamics.rule().gamma, 0.6);
  const Deck again = parse_deck(to_yaml(moves), "a.yaml");
  EXPECT_EQ(to_yaml(again), to_yaml(moves));
  EXPECT_EQ(again.bodies[1].motion.mass, 3.0);
  EXPECT_EQ(again.bodies[1].motion.products_of_inertia[1], 0.1);
  EXPECT_EQ(again.bodies[1].initial_angular_velocity[0], 0.5);
}

TEST(Deck, WhereFallsBackToTheEnclosingKey) {
  const Deck d = parse_deck(yaml_scene, "ball.yaml");
  EXPECT_EQ(d.where("contact.ball_on_floor.primary"),
            "ball.yaml:27: contact.ball_on_floor.primary");
  EXPECT_EQ(d.where("contact.ball_on_floor.reach"), "ball.yaml:26: contact.ball_on_floor.reach");
  EXPECT_EQ(d.where("nothing.here"), "ball.yaml: nothing.here");
}

TEST(Deck, CurvesAreLinearAndConstantBeyondTheEnds) {
  const Deck d = parse_deck(yaml_scene, "ball.yaml");
  const Curve up = curve_named(d.curves, "up");
  EXPECT_EQ(up(-1.0), 0.0);
  EXPECT_EQ(up(0.0), 0.0);
  EXPECT_EQ(up(0.25), 0.5);
  EXPECT_EQ(up(0.5), 1.0);
  EXPECT_EQ(up(7.0), 1.0);
  EXPECT_EQ(curve_named(d.curves, "")(0.3), 0.3);
  EXPECT_THROW(curve_named(d.curves, "down"), Defect);
  const Curve jagged{"j", {{-1.0, 2.0}, {1.0, -2.0}, {3.0, 6.0}}};
  EXPECT_EQ(jagged(-5.0), 2.0);
  EXPECT_EQ(jagged(0.5), -1.0);
  EXPECT_EQ(jagged(2.0), 2.0);
  EXPECT_EQ(jagged(9.0), 6.0);
}

TEST(Deck, EveryRankReadsTheSameOrFailsTheSame) {
  const Comm comm(MPI_COMM_WORLD);
  const std::string file = "test_deck_ranks" + std::to_string(comm.size()) + ".yaml";
  comm.on_root([&] { std::ofstream(file) << yaml_scene; });
  const Deck deck = read_deck(comm, file);
  EXPECT_EQ(to_yaml(deck), to_yaml(parse_deck(yaml_scene, file)));
  comm.on_root([&] { std::remove(file.c_str()); });
  for (const char* absent : {"no_such_deck.yaml", "."}) {
    try {
      read_deck(comm, absent);
      ADD_FAILURE() << absent;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), testing::StartsWith(std::string(absent) + ": "));
    }
  }
}
