// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"

#include <gtest/gtest.h>
#include <string>

using namespace abut;
using namespace abut::deck;

namespace {

/// A sound deck of eleven lines; each case replaces one line or adds some at the end.
const std::string lines[] = {
    "mesh: {file: a.exo}",
    "materials:",
    "  steel: {young: 210, poisson: 0.3}",
    "bodies:",
    "  ball: {blocks: [1], material: steel}",
    "contact:",
    "  pair:",
    "    primary: top",
    "    secondary: bottom",
    "    penalty_factor: 10",
    "time: {steps: 2}",
};

std::string deck_with(std::size_t line, const std::string& text) {
  std::string deck;
  for (std::size_t i = 0; i < std::size(lines); ++i)
    deck += (i + 1 == line ? text : lines[i]) + "\n";
  return line > std::size(lines) ? deck + text + "\n" : deck;
}

std::string error_of(const std::string& text) {
  try {
    parse_deck(text, "d.yaml");
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

struct Case {
  std::size_t line;
  const char* text;
  const char* message;
};

class DeckErrors : public testing::TestWithParam<Case> {};

const char* const young = "  steel: {poisson: 0.3, young: ";

} // namespace

TEST(DeckErrors, TheDeckItselfIsSound) {
  EXPECT_EQ(error_of(deck_with(0, "")), "no error");
}

TEST_P(DeckErrors, NameFileLineKeyAndWhatWasExpected) {
  const Case& c = GetParam();
  EXPECT_EQ(error_of(deck_with(c.line, c.text)), c.message);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, DeckErrors,
    testing::Values(
        Case{
            6, "contct:",
            "d.yaml:6: contct: unknown key; valid: title, mesh, surfaces, materials, bodies, "
            "joints, displacements, loads, curves, contact, time, dynamics, newton, linear_solver, "
            "audit, output, trilinos, check, verify; did you mean 'contact'?"},
        Case{10, "    penalty_factr: 10",
             "d.yaml:10: contact.pair.penalty_factr: unknown key; did you mean 'penalty_factor'? "
             "valid: primary, secondary, primary_side, formulation, enforcement, multipliers, "
             "weighted_gap, augmentation, uzawa, "
             "penalty_factor, penalty, penalty_curve, update_penalty, friction, friction_curve, "
             "friction_map, friction_switching, two_pass, tension, tied, tie_distance, tie_gap, "
             "sticky, "
             "stick_within, stick_strength, offset, "
             "initial_overlap, initial_gap, interference, interference_curve, fit_within, "
             "tangent, from, until, points, reach, "
             "projection_margin, segment_updates, multiplier_tolerance, gap_tolerance, gap_limit, "
             "min_augmentations, max_augmentations"},
        Case{1, "", "d.yaml:1: missing key 'mesh' (where the mesh comes from)"},
        Case{9, "",
             "d.yaml:7: contact.pair: missing key 'secondary' (side set that is projected on)"},
        Case{1, "mesh: {fil: a.exo}",
             "d.yaml:1: mesh.fil: unknown key; valid: file, generate; did you mean 'file'?"},
        Case{1, "mesh: {}", "d.yaml:1: mesh: expected one of the keys file, generate"},
        Case{1, "mesh: {file: a.exo, generate: {kind: blocks}}",
             "d.yaml:1: mesh.generate: only one of the keys file, generate is allowed, 'file' is "
             "given too"},
        Case{1, "mesh: {generate: {size: 2}}",
             "d.yaml:1: mesh.generate: missing key 'kind' (the generator)"},
        Case{12, "loads: {l: {side_set: s}}",
             "d.yaml:12: loads.l.side_set: unknown key; valid: curve, traction, pressure, "
             "body_force, force"},
        Case{
            12, "loads: {l: {force: [1, 2, 3], side_set: s}}",
            "d.yaml:12: loads.l.side_set: unknown key; valid: force, node_set, curve; did you mean "
            "'node_set'?"},
        Case{12, "displacements: {d: {set: s}}",
             "d.yaml:12: displacements.d: expected at least one of the keys x, y, z, fix"},
        Case{12, "displacements: {d: {set: s, x: 1, fix: [x]}}",
             "d.yaml:12: displacements.d.fix: direction 'x' is prescribed twice"},
        Case{12, "displacements: {d: {set: s, x: 1, from: 0.5, until: 0.5}}",
             "d.yaml:12: displacements.d.until: expected more than from"},
        Case{5, "  ball: {blocks: [1], rigid: {free: [z], holds: {h: {fix: [x], z: 1}}}}",
             "d.yaml:5: bodies.ball.rigid.holds: 'h' holds component 'x', which is prescribed "
             "always; list it under 'free'"},
        Case{5, "  ball: {blocks: [1], rigid: {free: [z], holds: {h: {fix: [z], z: 1}}}}",
             "d.yaml:5: bodies.ball.rigid.holds.h.fix: component 'z' is prescribed twice"},
        Case{12, "verify: {v: {quantity: newton_iterations, expected: 3}}",
             "d.yaml:12: verify.v: expected at least one of the keys tolerance, "
             "relative_tolerance"},
        Case{12, "surfaces: {s: {}}",
             "d.yaml:12: surfaces.s: expected at least one of the keys blocks, body, part_of, "
             "node_set, plane, cylinder, sphere, box, normal, join, subtract"},
        Case{12, "surfaces: {s: {plan: {point: [0, 0, 0], normal: [0, 0, 1]}}}",
             "d.yaml:12: surfaces.s.plan: unknown key; valid: blocks, body, part_of, node_set, "
             "plane, cylinder, sphere, box, normal, within, join, subtract; did you mean 'plane'?"},
        Case{12, "surfaces: {s: {plane: {point: [0, 0, 0]}}}",
             "d.yaml:12: surfaces.s.plane: missing key 'normal' (its length does not matter)"},
        Case{12, "surfaces: {s: {body: bal}}",
             "d.yaml:12: surfaces.s.body: 'bal' is not a name under bodies; valid: ball; did you "
             "mean 'ball'?"},
        Case{12, "surfaces: {s: {normal: {direction: [0, 0, 0]}}}",
             "d.yaml:12: surfaces.s.normal.direction: expected a direction, got zero"},
        Case{12, "surfaces: {s: {normal: {direction: [0, 0, 1], angle: 200}}}",
             "d.yaml:12: surfaces.s.normal.angle: expected a number >= 0 and <= 180, got '200'"},
        Case{12, "surfaces: {s: {box: {low: [0, 1, 0], high: [1, 0, 1]}}}",
             "d.yaml:12: surfaces.s.box.high: its y is less than that of 'low'"},
        Case{5, "  ball: {blocks: [1]}",
             "d.yaml:5: bodies.ball: expected one of the keys material, rigid"}));

INSTANTIATE_TEST_SUITE_P(
    Values, DeckErrors,
    testing::Values(
        Case{10, "    penalty_factor: abc",
             "d.yaml:10: contact.pair.penalty_factor: expected a number > 0 or 'automatic', got "
             "'abc'"},
        Case{10, "    penalty_factor: \"10\"",
             "d.yaml:10: contact.pair.penalty_factor: expected a number > 0 or 'automatic', got "
             "the text '10'"},
        Case{10, "    penalty_factor: -1",
             "d.yaml:10: contact.pair.penalty_factor: expected a number > 0 or 'automatic', got "
             "'-1'"},
        Case{10, "    penalty_factor: .inf",
             "d.yaml:10: contact.pair.penalty_factor: expected a number > 0 or 'automatic', got "
             "'.inf'"},
        Case{10, "    penalty_factor: [1]",
             "d.yaml:10: contact.pair.penalty_factor: expected a number > 0 or 'automatic', got a "
             "list of 1 item"},
        Case{10, "    penalty_factor:",
             "d.yaml:10: contact.pair.penalty_factor: expected a number > 0 or 'automatic', got "
             "nothing"},
        Case{10, "    enforcement: penaltyy",
             "d.yaml:10: contact.pair.enforcement: unknown value 'penaltyy'; valid: penalty, "
             "augmented_lagrangian; did you mean 'penalty'?"},
        Case{10, "    enforcement: [penalty]",
             "d.yaml:10: contact.pair.enforcement: expected one word, got a list of 1 item; valid: "
             "penalty, augmented_lagrangian"},
        Case{10, "    points: automatc",
             "d.yaml:10: contact.pair.points: expected a whole number >= 1 and <= 6 or "
             "'automatic', got 'automatc'"},
        Case{8, "    primary: \"\"",
             "d.yaml:8: contact.pair.primary: expected a text, got an empty one"},
        Case{11, "time: {steps: 1.5}",
             "d.yaml:11: time.steps: expected a whole number >= 1, got '1.5'"},
        Case{11, "time: {steps: 0}",
             "d.yaml:11: time.steps: expected a whole number >= 1, got '0'"},
        Case{11, "time: {steps: 3000000000}",
             "d.yaml:11: time.steps: expected a whole number up to 2147483647, got '3000000000'"},
        Case{11, "time: {adaptive: maybe}",
             "d.yaml:11: time.adaptive: expected true or false, got 'maybe'"},
        Case{12, "loads: [a]", "d.yaml:12: loads: expected a map of names, got a list of 1 item"},
        Case{11, "time: 3", "d.yaml:11: time: expected a map, got '3'"},
        Case{5, "  ball: {blocks: 1, material: steel}",
             "d.yaml:5: bodies.ball.blocks: expected a list of one or more texts, got '1'"},
        Case{5, "  ball: {blocks: [1], material: {a: 1}}",
             "d.yaml:5: bodies.ball.material: expected a text, got a map"},
        Case{12, "loads: {l: {force: [1, 2], node_set: s}}",
             "d.yaml:12: loads.l.force: expected a list of 3 numbers or expressions, got a list of "
             "2 items"},
        Case{
            12, "displacements: {d: {set: s, fix: [x, w]}}",
            "d.yaml:12: displacements.d.fix: unknown value 'w'; valid: x, y, z; did you mean 'x'?"},
        Case{12, "curves: {c: [[0, 0]]}",
             "d.yaml:12: curves.c: expected a list of two or more points [t, value], got a list of "
             "1 item"},
        Case{12, "curves: {c: [[0, 0], [1]]}",
             "d.yaml:12: curves.c: expected a point [t, value], got a list of 1 item"},
        Case{12, "curves: {c: [[0, 0], [0, 1]]}",
             "d.yaml:12: curves.c: t must grow from point to point, got 0 after 0"},
        Case{12, "trilinos: {Belos: {a: []}}", "d.yaml:12: a: an empty list has no type"},
        Case{12, "trilinos: {Belos: {a: \"1\\n2\"}}",
             "d.yaml:12: a: expected one line of text without control characters"},
        Case{12, "trilinos: {Belos: {a: [\"b,c\"]}}",
             "d.yaml:12: a: an item of an Array must not hold ',', '{' or '}': 'b,c'"},
        Case{12, "trilinos: {Aztec: {}}",
             "d.yaml:12: trilinos.Aztec: unknown key; valid: NOX, Belos, MueLu, Ifpack2"}));

INSTANTIATE_TEST_SUITE_P(
    References, DeckErrors,
    testing::Values(
        Case{5, "  ball: {blocks: [1], material: stel}",
             "d.yaml:5: bodies.ball.material: 'stel' is not a name under materials; valid: steel; "
             "did you mean 'steel'?"},
        Case{5, "  ball: {blocks: [1, 1], material: steel}",
             "d.yaml:5: bodies.ball.blocks: block '1' already belongs to body 'ball'"},
        Case{5, "  ball: {blocks: [1], rigid: {}}",
             "d.yaml:4: bodies: the motion of all bodies is prescribed; expected one with a "
             "material, or a rigid one with components that are 'free'"},
        Case{5, "", "d.yaml:4: bodies: expected at least one, got nothing"},
        Case{10, "    penalty: 0",
             "d.yaml:10: contact.pair.penalty: 0 no longer means automatic: write 'penalty: "
             "automatic' or leave the key out"},
        Case{10, "    stick_strength: 0",
             "d.yaml:10: contact.pair.stick_strength: 0 no longer means unlimited: write "
             "'stick_strength: unlimited' or leave the key out"},
        Case{10, "    until: 0",
             "d.yaml:10: contact.pair.until: 0 no longer means end: write 'until: end' or leave "
             "the key out"},
        Case{10, "    max_augmentations: 0",
             "d.yaml:10: contact.pair.max_augmentations: expected a whole number >= 1, got '0' "
             "(for multipliers that change once, at the end of each step, write 'uzawa: "
             "end_of_step')"},
        Case{9, "    secondary: bottom\n    friction: 0.3\n    friction_curve: c",
             "d.yaml:11: contact.pair.friction_curve: 'c' is not a name under curves; none is "
             "defined"},
        Case{12, "loads: {l: {force: [1, 2, 3], node_set: s, curve: c}}",
             "d.yaml:12: loads.l.curve: 'c' is not a name under curves; none is defined"},
        Case{12, "displacements: {d: {set: s, x: 1, curve: c}}",
             "d.yaml:12: displacements.d.curve: 'c' is not a name under curves; none is defined"},
        Case{12, "verify: {v: {quantity: force_z, place: par, expected: 1, tolerance: 0}}",
             "d.yaml:12: verify.v.place: 'par' is not a name under contact; valid: pair; did you "
             "mean 'pair'?"},
        Case{12, "verify: {v: {quantity: max_pressure, expected: 1, tolerance: 0}}",
             "d.yaml:12: verify.v: missing key 'place' (the contact interface)"},
        Case{12, "verify: {v: {quantity: displacement_x, expected: 1, tolerance: 0}}",
             "d.yaml:12: verify.v: expected one of the keys place, point"}));

TEST(DeckErrors, PoissonExplainsItsLimits) {
  for (const char* bad : {"0.5", "-1.2", "-1", "0.6"}) {
    const std::string text = std::string("  steel: {young: 1, poisson: ") + bad + "}";
    const std::string message = error_of(deck_with(3, text));
    EXPECT_EQ(message.find("d.yaml:3: materials.steel.poisson: expected a number > -1 and < 0.5, "
                           "got '" +
                           std::string(bad) + "' (at 0.5 the material is incompressible"),
              0u)
        << message;
  }
  EXPECT_EQ(error_of(deck_with(3, "  steel: {young: 1, poisson: 0.499}")), "no error");
}

TEST(DeckErrors, MaterialsHaveTheKeysOfTheirModel) {
  const auto error = [](const std::string& keys) {
    return error_of(deck_with(3, "  steel: {" + keys + "}"));
  };
  const std::string at = "d.yaml:3: materials.steel";
  EXPECT_EQ(error("model: mooney_rivlin, c1: 1, c2: -0.2, bulk: 1000"), "no error");
  EXPECT_EQ(error("model: mooney_rivlin, c1: 1, c2: -1, bulk: 1000"),
            at + ".c1: expected c1 + c2 > 0, which is half the shear modulus");
  EXPECT_EQ(error("model: mooney_rivlin, c1: 1"),
            at + ": missing key 'bulk' (K of K/2 (ln J)^2, a thousand times G for rubber)");
  EXPECT_EQ(error("model: mooney_rivlin, c1: 1, bulk: 1000, young: 1"),
            at + ".young: unknown key; valid: model, c1, c2, bulk, density");
  EXPECT_EQ(error("young: 1, poisson: 0.3, c1: 1"),
            at + ".c1: unknown key; valid: model, young, poisson, density");
  EXPECT_EQ(error("model: ogden, coefficients: [1, 2], exponents: [2], bulk: 9"),
            at + ".exponents: expected as many as coefficients, which are 2");
  EXPECT_EQ(error("model: ogden, coefficients: [1, 2], exponents: [2, 0], bulk: 9"),
            at + ".exponents: an exponent must not be zero");
  EXPECT_EQ(error("model: ogden_unconstrained, coefficients: [-1], exponents: [2], lambda: 1"),
            at + ".coefficients: expected a sum > 0, which is twice the shear modulus");
  EXPECT_EQ(error("model: ogden, coefficients: 3, exponents: [2], bulk: 9"),
            at + ".coefficients: expected a list of one or more numbers, got '3'");
}

TEST(DeckErrors, YoungIsPositive) {
  for (const char* bad : {"0", "-5", "x"})
    EXPECT_EQ(error_of(deck_with(3, std::string(young) + bad + "}")),
              "d.yaml:3: materials.steel.young: expected a number > 0, got '" + std::string(bad) +
                  "'");
}
