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


class Fit(unittest.TestCase):
    def share(self, result):
        """Force of the fit along x over Lame's, positive when the rings press."""
        side = 1 if "outer_inner" in str(result.deck_path.read_text().split('"primary"')[1][:20]) else -1
        return side * result.force()[0] / (lame() * B * THICKNESS)

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


if __name__ == "__main__":
    unittest.main()
