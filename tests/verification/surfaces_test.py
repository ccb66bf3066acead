#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes on surfaces that the deck selects are those on the side sets of the mesh."""
import unittest

import numpy as np
import scenes

BY_SIDE_SETS = {
    "mesh": {"generate": {"kind": "blocks", "lower_divisions": [4, 4, 2], "upper_divisions": [3, 3, 3]}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "soft"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "head": {"set": "upper_top", "fix": ["x", "y"]}},
    "loads": {"push": {"pressure": 0.02, "side_set": "upper_top"},
              "wind": {"traction": [0, 0.001, 0], "side_set": "upper_x1"}},
    "contact": {"press": {"primary": "upper_bottom", "secondary": "lower_top"}},
    "verify": {"head": scenes.probe("displacement_z", "upper_top"),
               "foot": scenes.probe("reaction_z", "lower_bottom")},
}
UP = {"direction": [0, 0, 1], "angle": 20}
SURFACES = {
    "under": {"body": "upper", "plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}},
    "floor": {"body": "lower", "normal": UP},
    "ground": {"box": {"low": [0, 0, -1], "high": [1, 1, -1]}},
    "sides": {"body": "upper", "subtract": ["under", "lid"]},
    "lid": {"blocks": [2], "normal": UP},
    "windward": {"part_of": "sides", "normal": {"direction": [1, 0, 0]}},
}
BY_SURFACES = scenes.merged(BY_SIDE_SETS, {
    "surfaces": SURFACES,
    "displacements": {"foot": {"set": "ground"}, "head": {"set": "lid"}},
    "loads": {"push": {"side_set": "lid"}, "wind": {"side_set": "windward"}},
    "contact": {"press": {"primary": "under", "secondary": "floor"}},
    "verify": {"head": {"place": "lid"}, "foot": {"place": "ground"}}})


class Surfaces(unittest.TestCase):
    def test_the_same_scene(self):
        sets, surfaces = scenes.run(BY_SIDE_SETS), scenes.run(BY_SURFACES)
        self.assertGreater(sets.contact("press")["active_points"], 0)
        self.assertAlmostEqual(surfaces.quantity("foot"), 0.02, delta=2e-4)
        for name in ("head", "foot"):
            self.assertAlmostEqual(surfaces.quantity(name), sets.quantity(name), delta=1e-9)
        np.testing.assert_allclose(surfaces.force("press"), sets.force("press"), atol=1e-9)
        self.assertIn("lid", surfaces.fields.names("ss"))
        np.testing.assert_array_equal(surfaces.fields.side_set("lid"), surfaces.fields.side_set("upper_top"))

    def test_nodes_of_a_part_are_the_same_on_ranks(self):
        """Half a face: ranks own nodes on its edge without owning a face of it."""
        half = {"surfaces": {"lid": None, "sides": None, "windward": None,
                             "half": {"box": {"low": [-1, -1, 1], "high": [0.34, 0.67, 1]}}},
                "displacements": {"head": {"set": "half", "z": -0.01}},
                "loads": None, "verify": {"head": {"place": "half"}}}
        deck = scenes.merged(BY_SURFACES, half)
        one, more = scenes.run(deck, ranks=1), scenes.run(deck, ranks=4)
        self.assertAlmostEqual(one.quantity("head"), -0.01, delta=1e-9)
        for name in ("head", "foot"):
            self.assertAlmostEqual(more.quantity(name), one.quantity(name), delta=1e-8)

    def test_a_rigid_body_and_forces_take_their_nodes(self):
        deck = scenes.merged(BY_SURFACES, {
            "bodies": {"cap": {"node_sets": ["lid"], "rigid": {"free": ["z"]}}}, "displacements": {"head": None},
            "loads": {"push": None, "wind": None, "nail": {"force": [0, 0, -1e-3], "node_set": "lid"}},
            "verify": {"foot": {"place": "ground"}}})
        self.assertAlmostEqual(scenes.run(deck).quantity("foot"), 16e-3, delta=1e-6)

    def refused(self, changes, message):
        result = scenes.run(scenes.merged(BY_SURFACES, changes), command="check", check=False)
        self.assertEqual(result.status, 2, result.output)
        self.assertRegex(result.output, r"(?m)^abut: \S*scene\.yaml:\d+: " + message)
        self.assertEqual(result.output.count("abut: "), 1, result.output)

    def test_errors_name_the_place_and_the_nearest_word(self):
        self.refused({"contact": {"press": {"primary": "undr"}}},
                     r"contact\.press\.primary: the mesh has no side set 'undr'; .*did you mean 'under'\?")
        self.refused({"surfaces": {"windward": {"part_of": "side"}}},
                     r"surfaces\.windward\.part_of: the mesh has no side set or surface 'side'; .*did you mean 'sides'\?")
        self.refused({"surfaces": {"lid": {"blocks": ["uper"]}}},
                     r"surfaces\.lid\.blocks: the mesh has no block 'uper'; valid: lower, upper; did you mean 'upper'\?")
        self.refused({"surfaces": {"lid": {"normal": {"direction": [1, 2, 3], "angle": 1}}}},
                     r"surfaces\.lid: no face is left: 118 outer faces, 54 of the blocks, 0 with the normal")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
