#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Friction on 1, 2 and 4 ranks: pressed, slid over faces, reversed so that part of the points stick again.

History travels with the points and partners lie on other ranks; nothing of it may depend on the cut. The
number of Newton iterations is printed only: where many points change between stick and slip, rounding
decides on the way, not on the end.
"""
import unittest

import numpy as np

import scenes
from ranks_test import TOLERANCE, Ranks

SCENE = {
    "mesh": {"generate": {"kind": "blocks", "lower_size": [4, 1, 0.5], "lower_divisions": [12, 3, 1],
                          "upper_size": [1.6, 0.8, 0.4], "upper_divisions": [5, 2, 1],
                          "turn": 5}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 3.0, "poisson": 0.2}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "stiff"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "press": {"set": "upper_top", "y": 0.011, "z": -0.02, "curve": "press"},
                      "slide": {"set": "upper_top", "x": 0.5, "curve": "slide"}},
    "curves": {"press": [[0, 0], [0.2, 1]], "slide": [[0.2, 0], [0.8, 1], [1, 0.94]]},
    "time": {"steps": 10},
    "newton": {"tolerance": 1e-10},
    "linear_solver": {"method": "direct"},
    "output": {"files": "per_rank"},
}


def with_contact(formulation, **options):
    return {**SCENE, "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top",
                                          "formulation": formulation, "friction": 0.3, **options}}}


class SameOnAllRanks(unittest.TestCase):
    def compare(self, label, deck):
        one = Ranks(deck, 1)
        u, contact = one.displacement(), one.result.contact()
        self.assertGreater(contact["stick_points"], 0)
        self.assertGreater(contact["slip_points"], 0)
        self.assertGreater(contact["max_slip"], 0.4)  # a face of the lower block is 1/3 long
        for ranks in (2, 4):
            with self.subTest(ranks=ranks):
                many = Ranks(deck, ranks)
                difference = np.abs(many.displacement() - u).max() / np.abs(u).max()
                print(f"{label} on {ranks} ranks: difference {difference:.1e}, stick {contact['stick_points']} "
                      f"slip {contact['slip_points']}, newton {many.summary['newton_iterations']} for "
                      f"{one.summary['newton_iterations']}, faces {many.faces('upper_bottom')}")
                self.assertLess(difference, TOLERANCE)
                for key in ("unknowns", "steps", "augmentations", "cut_backs"):
                    self.assertEqual(many.summary[key], one.summary[key], key)
                for key in ("active_points", "stick_points", "slip_points"):
                    self.assertEqual(many.result.contact()[key], contact[key], key)
                np.testing.assert_allclose(many.result.force(), one.result.force(), rtol=0,
                                           atol=1e-9 * np.abs(one.result.force()).max())
                self.assertAlmostEqual(many.result.contact()["friction_dissipation"],
                                       contact["friction_dissipation"],
                                       delta=1e-9 * contact["friction_dissipation"])
        return one

    def test_penalty(self):
        for formulation in ("facet_on_facet", "sliding_elastic"):
            with self.subTest(formulation=formulation):
                self.compare(f"{formulation} penalty", with_contact(formulation))

    def test_augmented_lagrangian(self):
        for formulation in ("node_on_facet", "facet_on_facet", "sliding_elastic"):
            with self.subTest(formulation=formulation):
                one = self.compare(f"{formulation} augmented",
                                   with_contact(formulation, enforcement="augmented_lagrangian",
                                                multiplier_tolerance=1e-3))
                self.assertGreater(one.summary["augmentations"], 10)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
