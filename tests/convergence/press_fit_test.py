# SPDX-License-Identifier: BSD-3-Clause
"""Press fit of two rings on meshes that do not fit: error of the force against Lame's solution.

The overlap is d plus what the faces leave of the circle, h^2/8b for linear faces and of order h^4 for quadratic
ones: that is the error of the force, and where it is as large as d the local pressure means nothing. Lame's
solution itself holds up to terms d/b.
"""
import itertools
import math
import unittest

import numpy

import scenes
import study

A, B, C, POISSON, THICKNESS = 1.0, 2.0, 3.0, 0.3, 0.25
MODULUS = 1 / (1 - POISSON**2)  # plane strain, E = 1
SPACES = study.spaces(multiplier_tolerance=1e-6, max_augmentations=50)


def pressure(interference):
    ring = (C**2 + B**2) / (C**2 - B**2) + (B**2 + A**2) / (B**2 - A**2)  # Poisson's terms cancel
    return interference * MODULUS / (B * ring)


def scene(theta, element, interference, primary="outer_inner", **contact):
    secondary = "inner_outer" if primary == "outer_inner" else "outer_inner"
    return {
        "mesh": {"generate": {
            "kind": "rings", "element": element, "gap": -interference, "thickness": THICKNESS,
            "inner_radius": A, "interface_radius": B, "outer_radius": C, "inner_theta": theta,
            "outer_theta": 3 * theta // 4, "inner_r": theta // 2, "outer_r": theta // 2}},
        "materials": {"elastic": {"model": "linear_elastic", "young": 1, "poisson": POISSON}},
        "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("inner", "outer")},
        "displacements": {name: {"set": name, "fix": [name[0]]} for name in ("x0", "y0", "z0", "z1")},
        "contact": {"pair": {"primary": primary, "secondary": secondary, **contact}},
    }


class Errors:
    def __init__(self, theta, element, interference, primary="outer_inner", **contact):
        result = scenes.run(scene(theta, element, interference, primary, **contact))
        exact = pressure(interference)
        self.theta, self.active = theta, result.contact()["active_points"]
        self.force = abs(result.force()[0]) / (exact * B * THICKNESS) - 1
        local = result.fields.nodal("contact_pressure")[result.fields.node_set(primary)] / exact - 1
        self.local = math.sqrt(numpy.mean(local**2))
        sagitta = B * (1 - math.cos(math.pi / (4 * theta)))
        print(f"{element:6s} {theta:3d}:{3 * theta // 4:<3d} d {interference:g}  d/sagitta "
              f"{interference / sagitta:7.3f}  primary {primary}  errors: force {self.force:.3e}  "
              f"pressure rms {self.local:.3e}  ({result.summary['unknowns']} unknowns)")


def order(coarse, fine, name):
    return math.log(abs(getattr(coarse, name) / getattr(fine, name))) / math.log(fine.theta / coarse.theta)


class PressFit(unittest.TestCase):
    def test_linear_faces(self):
        for space, primary in itertools.product(SPACES, ("outer_inner", "inner_outer")):
            with self.subTest(space=space, primary=primary):
                runs = [Errors(theta, "hex8", 0.01, primary, **SPACES[space]) for theta in (8, 16, 32)]
                orders = [order(*pair, "force") for pair in zip(runs, runs[1:])]
                print(f"{space} orders: force {study.words(orders)}  pressure",
                      study.words(order(*pair, "local") for pair in zip(runs, runs[1:])))
                self.assertTrue(all(run.active > 0 for run in runs))
                # as long as the sagitta is as large as d faces open, and nodes open faces as a whole
                for value in orders if space == "per_point" else orders[1:]:
                    self.assertLess(abs(value - 2), 0.2)

    def test_quadratic_faces(self):
        for space, contact in SPACES.items():
            with self.subTest(space=space):
                runs = [Errors(theta, "hex20", 1e-4, **contact) for theta in (8, 16)]
                print(f"{space} order: force {order(*runs, 'force'):.2f}  pressure {order(*runs, 'local'):.2f}")
                self.assertGreater(order(*runs, "force"), 4 - 0.2)
                self.assertLess(Errors(16, "hex20", 1e-3, **contact).force, 4 * 1e-3 / B)

    def test_steps_change_nothing(self):
        deck = scene(8, "hex20", 1e-3, **SPACES["per_point"])
        forces = [scenes.run({**deck, "time": {"steps": steps}}).force()[0]
                  for steps in (1, 5)]
        self.assertLess(abs(forces[1] / forces[0] - 1), 1e-5)  # ten times the multipliers' tolerance


if __name__ == "__main__":
    unittest.main()
