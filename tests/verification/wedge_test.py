# SPDX-License-Identifier: BSD-3-Clause
"""A block of weight G pushed up a slope by a horizontal force F (NAFEMS CGS-4): sliding at constant speed,
F / G = (tan a + mu) / (1 - mu tan a), exact for an elastic block too, by equilibrium. Down the slope the
block must be held for mu < tan a, and is pulled otherwise: F / G = (tan a - mu) / (1 + mu tan a).

The top of the block is led horizontally; its weight presses it on a rigid slope, smooth until it moves.
"""
import math
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import scenes

SLOPE, WEIGHT = 0.1, 1e-4
HEIGHT = 0.25  # pushed at its top a block of side 1 then stands flat: HEIGHT F / G < 1/6
TOLERANCE = 5e-4  # 0.05 %
MAPS = [("node_on_facet", "incremental"), ("facet_on_facet", "incremental"),
        ("sliding_elastic", "inclined_ray"), ("sliding_elastic", "incremental")]


def slope(folder):
    """Block on plate, turned so that the contact plane rises along x by SLOPE."""
    path = scenes.mesh(folder / "slope.exo", "blocks", lower_size=[3, 3, 1], lower_divisions=[4, 4, 1],
                       upper_size=[1, 1, HEIGHT], upper_divisions=[3, 3, 2])
    mesh = exodus_edit.read(path)
    angle = math.atan(SLOPE)
    turn = numpy.array([[math.cos(angle), 0, -math.sin(angle)], [0, 1, 0],
                        [math.sin(angle), 0, math.cos(angle)]])
    mesh.x = mesh.x @ turn.T
    exodus_edit.write(path, mesh)
    return path


def deck(formulation, friction_map, enforcement, mu, way):
    return {
        "mesh": {"file": "slope.exo"},
        "materials": {"m": {"model": "linear_elastic", "young": 1.0, "poisson": 0.3}},
        "bodies": {"lower": {"blocks": ["lower"], "rigid": {}},
                   "upper": {"blocks": ["upper"], "material": "m"}},
        "displacements": {"push": {"set": "upper_top", "x": way, "curve": "push"},
                          "side": {"set": "upper_top", "y": 0}},
        "loads": {"weight": {"block": "upper", "body_force": [0, 0, -WEIGHT / HEIGHT], "curve": "weight"}},
        "curves": {"weight": [[0, 0], [0.25, 1]], "push": [[0, 0], [0.25, 0], [1, 1]],
                   "rough": [[0, 0], [0.25, 0], [0.5, 1]]},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "friction": mu, "friction_curve": "rough",
                             "formulation": formulation, "friction_map": friction_map,
                             "enforcement": enforcement, "multiplier_tolerance": 1e-6,
                             "max_augmentations": 50}},
        "time": {"steps": 4}, "newton": {"tolerance": 1e-9},
        "verify": {"force": scenes.probe("reaction_x", "upper_top")},
    }


class Wedge(unittest.TestCase):
    def test_force(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh = slope(pathlib.Path(folder))
            for formulation, friction_map in MAPS:
                for enforcement in ("penalty", "augmented_lagrangian"):
                    for mu, up in ((0.0, True), (0.1, True), (0.2, True), (0.3, True), (0.3, False)):
                        case = f"{formulation} {friction_map} {enforcement} mu {mu} {'up' if up else 'down'}"
                        with self.subTest(case):
                            way = 0.01 if up else -0.01
                            result = scenes.run(deck(formulation, friction_map, enforcement, mu, way),
                                                files=[mesh])
                            friction = mu if up else -mu
                            exact = (SLOPE + friction) / (1 - friction * SLOPE)
                            value = result.quantity("force") / WEIGHT
                            contact = result.contact()
                            print(f"{case:62s} F/G {value:.7f}  exact {exact:.7f}  "
                                  f"error {value / exact - 1:8.1e}")
                            self.assertGreater(contact["active_points"], 8)
                            self.assertEqual(contact["stick_points"], 0)
                            if mu > 0:
                                self.assertGreater(contact["max_slip"], 0.005)
                            self.assertLess(abs(value / exact - 1), TOLERANCE)


if __name__ == "__main__":
    unittest.main()
