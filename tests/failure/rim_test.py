# SPDX-License-Identifier: BSD-3-Clause
"""A stiff block is pressed into a soft one and drawn off it over the rim. Where a pressed point passes
the rim its force ends at once, and what springs back takes it up again: there is no balance between,
and a method that keeps looking for one never ends the step."""
import unittest

import scenes

STEPS = 40
SIZE, DRAWN = 0.5, 1.0


def deck(formulation, **contact):
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [1.5, 1, 0.5], "lower_divisions": [8, 5, 3],
                              "upper_size": [SIZE, SIZE, 0.5], "upper_divisions": [3, 3, 2], "shift": 0.1}},
        "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 1e4, "poisson": 0.3}},
        "bodies": {"lower": {"blocks": ["lower"], "material": "soft"},
                   "upper": {"blocks": ["upper"], "material": "stiff"}},
        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "press": {"set": "upper_top", "z": -0.08, "fix": ["y"], "curve": "press"},
                          "draw": {"set": "upper_top", "x": DRAWN, "curve": "draw"}},
        "curves": {"press": [[0, 0], [1, 1]], "draw": [[0, 0], [1, 0], [2, 1]]},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "formulation": formulation,
                             "enforcement": "augmented_lagrangian", **contact}},
        "time": {"end": 2, "steps": STEPS},
    }


class Rim(unittest.TestCase):
    def check(self, deck_of_case, cuts=0):
        result = scenes.run(deck_of_case, seconds=300)
        self.assertLessEqual(result.summary["cut_backs"], cuts)
        times = list(result.fields.times)
        force = [result.fields.globals(step)["pair_force_z"] for step in range(len(times))]
        pressed, drawn = force[times.index(1.0)], force[times.index(1.5):]
        self.assertGreater(pressed, 1e-2)
        # Off the rim with ever less of the block; the last points let go one row at a time.
        self.assertTrue(any(0.01 * pressed < f < 0.5 * pressed for f in drawn))
        self.assertEqual(force[-1], 0.0)

    def test_multiplier_at_each_node(self):
        self.check(deck("node_on_facet", multipliers="per_point", multiplier_tolerance=0.1), cuts=1)

    def test_the_default(self):
        for formulation in ("facet_on_facet", "sliding_elastic"):
            with self.subTest(formulation=formulation):
                self.check(deck(formulation))


if __name__ == "__main__":
    unittest.main()
