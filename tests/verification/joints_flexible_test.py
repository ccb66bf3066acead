# SPDX-License-Identifier: BSD-3-Clause
"""Joints of rigid bodies that hold a deformable one."""
import unittest
from math import cos, sin, sqrt

import numpy

import scenes
from mechanisms import FREE, Scene, vector


class Flexible(Scene):
    """An elastic block between two rigid caps on hinges with the same axis, which turn alike."""

    def test_turns_without_stress(self):
        caps = {name: {"node_sets": [name], "rigid": {"free": FREE, "center": [0.3, 0.4, z]}}
                for name, z in (("z0", -0.2), ("z1", 1.3))}
        deck = {"mesh": {"generate": {"kind": "box", "divisions": [2, 2, 3], "distortion": 0.1}},
                "materials": {"rubber": {"young": 2, "poisson": 0.3}},
                "bodies": {"block": {"blocks": ["box"], "material": "rubber"}, **caps},
                "joints": {"drive": {"kind": "revolute", "bodies": ["ground", "z0"],
                                     "origin": [2, 0, 0], "axis": [0, 1, 1], "rotation": 3.5},
                           "rest": {"kind": "cylindrical", "bodies": ["ground", "z1"],
                                    "origin": [2, 0, 0], "axis": [0, 1, 1]}},
                "newton": {"tolerance": 1e-12}, "time": {"steps": 14}}
        result = scenes.run(deck)
        found = result.fields.globals()
        self.close([found["drive_rotation"], found["rest_rotation"]], 3.5, 1e-9)
        self.close(found["rest_translation"], 0, 1e-9)
        axis, x = numpy.array([0, 1, 1]) / sqrt(2), result.fields.coordinates - [2, 0, 0]
        moved = cos(3.5) * x + sin(3.5) * numpy.cross(axis, x) + \
            (1 - cos(3.5)) * numpy.outer(x @ axis, axis)
        self.close(result.fields.vector("displacement"), moved - x, 1e-8)
        self.assertLess(result.fields.element("von_mises", "box").max(), 1e-8)
        self.close([*vector(found, "drive_force"), *vector(found, "drive_moment")], 0, 1e-8)

    def test_twisted(self):
        """The moments of drive and support balance, and the drive's work is stored."""
        caps = {name: {"node_sets": [name], "rigid": {"free": FREE, "center": [0.5, 0.5, z]}}
                for name, z in (("z0", 0.0), ("z1", 1.0))}
        hinges = {"drive": {"kind": "revolute", "bodies": ["ground", "z1"],
                            "origin": [0.5, 0.5, 1], "axis": [0, 0, 1], "rotation": 0.5},
                  "rest": {"kind": "lock", "bodies": ["ground", "z0"], "origin": [0.5, 0.5, 0]}}
        deck = {"mesh": {"generate": {"kind": "box", "divisions": [2, 2, 3]}},
                "materials": {"rubber": {"young": 2, "poisson": 0.3}},
                "bodies": {"block": {"blocks": ["box"], "material": "rubber"}, **caps},
                "joints": hinges, "time": {"steps": 8}}
        result = scenes.run(deck)
        found = result.fields.globals()
        self.assertGreater(found["drive_moment_z"], 0.02)
        self.close(vector(found, "drive_moment")[2] + vector(found, "rest_moment")[2], 0, 1e-8)
        self.close(vector(found, "drive_force") + vector(found, "rest_force"), 0, 1e-8)
        energy = result.summary["energy"]
        self.assertGreater(energy["stored"], 0.005)
        self.assertLess(abs(energy["imbalance"]), 2e-3 * energy["stored"])


if __name__ == "__main__":
    unittest.main()
