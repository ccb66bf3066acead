#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits of round bodies whose flat faces do not match, against Lame's rings in plane stress.

The interference e comes from the meshes or as an offset; with `initial_gap: round` it is that of the round surfaces
whatever the faces, so that every space of multipliers, formulation and side gives Lame's pressure. What is left is the
error of the finite elements and of the penalty, a few percent on these meshes.
"""
import itertools
import math
import unittest

import numpy as np
import scenes

A, B, C, YOUNG, FIT, THICKNESS = 1.0, 2.0, 3.0, 1000.0, 2e-3, 0.2
SPACES = ({"enforcement": "penalty", "penalty_factor": 50}, *(
    {"enforcement": "augmented_lagrangian", "multipliers": space} for space in ("per_point", "smoothed", "dual")))
TOLERANCE = 0.04


def lame():
    """Pressure of the fit."""
    return YOUNG * FIT / (B * ((C**2 + B**2) / (C**2 - B**2) + (B**2 + A**2) / (B**2 - A**2)))


def deck(gap=0.0, theta=(8, 10), steps=1, primary="inner_outer", **contact):
    secondary = "outer_inner" if primary == "inner_outer" else "inner_outer"
    return {"mesh": {"generate": {"kind": "rings", "inner_radius": A, "interface_radius": B, "outer_radius": C,
                                  "gap": gap, "thickness": THICKNESS, "inner_theta": theta[0],
                                  "outer_theta": theta[1], "inner_r": 8, "outer_r": 8}},
            "materials": {"steel": {"model": "linear_elastic", "young": YOUNG, "poisson": 0.3}},
            "bodies": {name: {"blocks": [name], "material": "steel"} for name in ("inner", "outer")},
            "displacements": {name: {"set": name, "fix": [name[0]]} for name in ("x0", "y0", "z0")},
            "contact": {"pair": {"primary": primary, "secondary": secondary, **contact}},
            "time": {"steps": steps}}


class Shares(unittest.TestCase):
    def share(self, result):
        """Force of the fit along x over Lame's, positive when the rings press."""
        side = 1 if "outer_inner" in str(result.deck_path.read_text().split('"primary"')[1][:20]) else -1
        return side * result.force()[0] / (lame() * B * THICKNESS)


class Fit(Shares):
    def test_round_surfaces_fit_whatever_the_faces(self):
        fits = ({"gap": -FIT, "initial_overlap": "resolve"}, {"gap": -FIT},
                {"offset": FIT, "initial_overlap": "adjust"}, {"offset": FIT, "initial_overlap": "resolve"})
        for fit, space in itertools.product(fits, SPACES):
            with self.subTest(**fit, **space):
                self.assertAlmostEqual(self.share(scenes.run(deck(initial_gap="round", **fit, **space))), 1,
                                       delta=TOLERANCE)

    def test_what_is_resolved_or_adjusted_is_round(self):
        for fit in ({"gap": -FIT, "initial_overlap": "resolve"}, {"offset": FIT, "initial_overlap": "adjust"}):
            given, automatic = (scenes.run(deck(**fit, **gap)) for gap in ({"initial_gap": "round"}, {}))
            self.assertEqual(list(automatic.force()), list(given.force()))
            self.assertIn("initial gap: of the round surfaces, automatic", scenes.run(deck(**fit), command="check").output)
        given, automatic = (scenes.run(deck(-FIT, **gap)) for gap in ({"initial_gap": "mesh"}, {}))
        self.assertEqual(list(automatic.force()), list(given.force()))

    def test_sides_formulations_meshes_ranks(self):
        for primary, formulation, (theta, ranks) in itertools.product(
                ("inner_outer", "outer_inner"), ("facet_on_facet", "sliding_elastic", "node_on_facet"),
                (((6, 10), 2), ((10, 10), 1), ((16, 12), 1))):
            nodes = formulation == "node_on_facet"
            if nodes and theta != (10, 10):
                continue  # wrong by what the mesh ratio says
            with self.subTest(primary=primary, formulation=formulation, theta=theta, ranks=ranks):
                scene = deck(-FIT, theta, primary=primary, formulation=formulation, initial_gap="round",
                             initial_overlap="resolve", penalty_factor=50)
                result = scenes.run(scene, ranks=ranks)
                if ranks > 1:
                    self.assertAlmostEqual(self.share(result), self.share(scenes.run(scene)), delta=1e-9)
                # a node between two hollow faces takes the normal of one of them
                self.assertAlmostEqual(self.share(result), 1, delta=0.06 if nodes else TOLERANCE)

    def test_resolved_grows_with_t(self):
        for space, gap in itertools.product(SPACES, ("mesh", "round")):
            with self.subTest(gap=gap, **space):
                # as deep as the faces are hollow, so that the rings touch in places in either reading
                result = scenes.run(deck(-10 * FIT, steps=4, initial_overlap="resolve", initial_gap=gap, **space))
                forces = [abs(result.fields.globals(step)["pair_force_x"]) for step in range(5)]
                self.assertGreater(forces[4], 5 * lame() * B * THICKNESS)
                np.testing.assert_allclose(forces, np.arange(5) / 4 * forces[4], rtol=0.02, atol=1e-9 * forces[4])

    def test_adjusted_meshes_press_nowhere(self):
        for space in SPACES:
            for gap in ("mesh", "round"):
                with self.subTest(gap=gap, **space):
                    result = scenes.run(deck(-FIT, initial_overlap="adjust", initial_gap=gap, **space))
                    self.assertGreater(result.contact()["initial_overlap"], 0.5 * FIT)
                    self.assertLess(abs(self.share(result)), 1e-6)

    def test_flat_faces_are_named(self):
        sagitta = B * (1 - math.cos(math.pi / 4 / 8))
        self.assertGreater(sagitta, FIT)
        for fit in ({"gap": -FIT, "initial_overlap": "resolve", "initial_gap": "mesh"}, {"offset": FIT}):
            for command in ("run", "check"):
                output = scenes.run(deck(**fit), quiet=False, command=command).output
                self.assertIn("contact.pair: the flat faces of 'inner_outer' and 'outer_inner' miss the gap of the "
                              "round surfaces that they stand for by up to 0.00", output)
        for element in ("hex20", "tet4"):
            scene = scenes.merged(deck(-FIT, initial_gap="round"), {"mesh": {"generate": {"element": element}}})
            self.assertIn("contact.pair: 'initial_gap: round' changes nothing: 'inner_outer' and 'outer_inner' have no "
                          "flat faces with four corners that bend", scenes.run(scene, command="check").output)
        for quiet in (deck(-FIT, initial_overlap="resolve"), deck(-FIT, (10, 10)), deck(-FIT, (64, 80)), deck(), deck(-FIT, initial_overlap="adjust")):
            self.assertNotIn("initial_gap", scenes.run(quiet, quiet=False).output)


class Interference(Shares):
    """A value counts whatever gap or overlap the meshes have: beside the sagitta of .01 to .02 or beyond it."""

    def test_whatever_the_meshes(self):
        for gap, theta in itertools.product((0, -FIT, 5 * FIT, -10 * FIT), ((8, 10), (6, 10), (10, 10))):
            for space in SPACES:
                with self.subTest(gap=gap, theta=theta, **space):
                    result = scenes.run(deck(gap, theta, interference=FIT, **space))
                    contact = result.contact()
                    self.assertAlmostEqual(self.share(result), 1, delta=TOLERANCE)
                    self.assertEqual(contact["shifted_points"], contact["active_points"])
                    self.assertAlmostEqual(contact["max_pressure"] / lame(), 1, delta=2.5 * TOLERANCE)

    def test_sides_formulations_elements_ranks(self):
        formulations = ("facet_on_facet", "sliding_elastic", "node_on_facet")
        for primary, formulation, element in itertools.product(("inner_outer", "outer_inner"), formulations,
                                                               ("hex8", "hex20", "tet4", "tet10")):
            with self.subTest(primary=primary, formulation=formulation, element=element):
                scene = scenes.merged(deck(primary=primary, formulation=formulation, interference=FIT, penalty_factor=50),
                                      {"mesh": {"generate": {"element": element}}})
                result = scenes.run(scene)
                self.assertAlmostEqual(self.share(result), 1, delta=0.06)
                if element == "hex8":
                    self.assertAlmostEqual(self.share(scenes.run(scene, ranks=2)), self.share(result), delta=1e-9)

    def test_penalty_is_within_its_stated_error(self):
        exact = self.share(scenes.run(deck(interference=FIT, enforcement="augmented_lagrangian", multipliers="per_point",
                                           min_augmentations=3)))
        for factor in (1, 3, 10):
            result = scenes.run(deck(interference=FIT, penalty_factor=factor))
            error, stated = 1 - self.share(result) / exact, result.summary["penalty_error"]
            self.assertGreater(error, 1e-3)
            self.assertLess(max(error / stated, stated / error), 1.3)

    def test_grows_with_t_or_by_a_curve(self):
        for space in SPACES:
            for curve, shares in ((None, (0.25, 0.5, 0.75, 1)), ([[0, 1], [0.5, 1], [1, 0.5]], (1, 1, 0.75, 0.5))):
                with self.subTest(curve=curve, **space):
                    scene = deck(5 * FIT, steps=4, interference=FIT, **space)
                    if curve:
                        scene["curves"] = {"fit": curve}
                        scene["contact"]["pair"]["interference_curve"] = "fit"
                    result = scenes.run(scene)
                    whole = -lame() * B * THICKNESS
                    forces = [result.fields.globals(step)["pair_force_x"] / whole for step in range(1, 5)]
                    np.testing.assert_allclose(forces, shares, atol=TOLERANCE)

    def test_a_clearance_is_open(self):
        self.assertEqual(scenes.run(deck(-FIT, interference=-FIT)).contact()["active_points"], 0)

    def test_is_reported(self):
        scene = deck(-FIT, interference=FIT)
        said = "contact.pair: gaps of 32 of 32 points are shifted at the start, by up to 0.0"
        for command in ("run", "check"):
            self.assertIn(said, scenes.run(scene, quiet=False, command=command).output)
        self.assertIn("fit: interference 0.002, growing with t, where the surfaces are within 0.0",
                      scenes.run(scene, command="check").output)
        far = scenes.run(deck(0.05, interference=FIT, fit_within=0.01))
        self.assertTrue(any("the interference acts nowhere" in text for text in far.summary["warnings"]))


def apart(gap, approach, fit_within, **contact):
    """Two columns of unit length without lateral strain, `gap` apart, the upper one pressed down by `approach`."""
    return {"mesh": {"generate": {"kind": "blocks", "gap": gap, "lower_divisions": [3, 3, 2]}},
            "materials": {"elastic": {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}},
            "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("lower", "upper")},
            "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                              "head": {"set": "upper_top", "fix": ["x", "y"], "z": -approach}},
            "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "initial_gap": "close",
                                 "fit_within": fit_within, **contact}}}


class Close(unittest.TestCase):
    def test_gaps_close_without_strain(self):
        for space in SPACES:
            for formulation in ("facet_on_facet", "sliding_elastic", "node_on_facet"):
                with self.subTest(formulation=formulation, **space):
                    result = scenes.run(apart(0.02, 0.01, 0.03, formulation=formulation, **space))
                    self.assertAlmostEqual(result.force()[2], 0.005 * (1 - result.summary["penalty_error"]), delta=1e-5)
                    contact = result.contact()
                    self.assertEqual(contact["shifted_points"], contact["active_points"])
                    self.assertAlmostEqual(contact["max_shift"], 0.02, delta=1e-12)
                    resting = scenes.run(apart(0.02, 0, 0.03, formulation=formulation, **space))
                    self.assertLess(abs(resting.force()[2]), 1e-12)

    def test_gaps_beyond_the_distance_stay(self):
        contact = scenes.run(apart(0.02, 0.01, 0.015)).contact()
        self.assertEqual((contact["shifted_points"], contact["active_points"]), (0, 0))

    def test_flat_faces_of_a_clearance(self):
        """Closed and adjusted, faces that stand off and overlap by their sagitta touch everywhere: nothing presses."""
        for space in SPACES:
            with self.subTest(**space):
                scene = deck(FIT, initial_gap="close", fit_within=0.05, initial_overlap="adjust", **space)
                result = scenes.run(scene)
                self.assertLess(abs(result.force()[0]), 1e-6 * lame() * B * THICKNESS)
                self.assertEqual(result.contact()["shifted_points"], 32)
                self.assertIn("contact.pair: gaps of 32 of 32 points are shifted at the start, by up to 0.0",
                              scenes.run(scene, command="check").output)


if __name__ == "__main__":
    unittest.main()
