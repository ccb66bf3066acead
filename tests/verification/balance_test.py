# SPDX-License-Identifier: BSD-3-Clause
"""Forces and moments through a contact interface: exact penalty "mattress" under a rigid block, and
balance of contact forces and reactions on curved surfaces.

A rigid block B x D = 1 x 1, pressed by d and tilted by angle a, s = sin a: pressure eps (d + s X) at the
distance X from its middle. In full contact N = eps d and M = eps s cos(a) / 12; beyond, the contact length
is 3 (B/2 - M/N).
"""
import math
import unittest

import numpy

import scenes


def tilted_block(depth, slope, facets, points):
    """All nodes of the block below are held; the reactions at its two ends give force and moment."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [2, 2, 1], "lower_divisions": [1, 1, 1],
                              "upper_divisions": [facets, facets, 1]}},
        "materials": {"any": {"model": "linear_elastic", "young": 1, "poisson": 0}},
        "bodies": {"lower": {"blocks": ["lower"], "material": "any"},
                   "upper": {"blocks": ["upper"],
                             "rigid": {"displacement": [0, 0, -depth], "center": [1, 1, 0],
                                       "rotation": [0, math.asin(slope), 0]}}},
        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "top": {"set": "lower_top", "fix": ["x", "y", "z"]}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "penalty": 3.0,
                             "points": points}},
        "verify": {"left": scenes.probe("reaction_z", "lower_x0"),
                   "right": scenes.probe("reaction_z", "lower_x1")},
    }


class Mattress(unittest.TestCase):
    def measure(self, depth, slope, facets, points=2):
        result = scenes.run(tilted_block(depth, slope, facets, points))
        force = result.force()[2] / 3.0
        self.assertLess(abs(force - (result.quantity("left") + result.quantity("right")) / 3.0), 1e-15)
        moment = (result.quantity("right") - result.quantity("left")) / 3.0  # ends at distance 1
        return force, moment, result

    def test_full_contact(self):
        for slope in (0.0, 0.01):
            cosine = math.cos(math.asin(slope))
            for facets in (1, 3):
                with self.subTest(slope=slope, facets=facets):
                    force, moment, result = self.measure(0.01, slope, facets)
                    print(f"mattress, slope {slope}, {facets} facets: N {force:.12f}  M {moment:.12e}")
                    self.assertEqual(result.contact()["active_points"], 4 * facets**2)
                    self.assertLess(abs(force / 0.01 - 1), 1e-12)
                    self.assertLess(abs(moment - slope * cosine / 12), 1e-14)

    def test_lift_off(self):
        slope = 0.04
        cosine = math.cos(math.asin(slope))
        force, moment, result = self.measure(0.25 * slope, slope, 4)  # lifts off at a facet edge
        self.assertEqual(result.contact()["active_points"], 3 * 4 * 4)
        length = 3 * (0.5 - moment / cosine / force)
        print(f"mattress, lift-off: N {force:.12f}  M {moment:.12e}  contact length {length:.12f}")
        self.assertLess(abs(force - slope * 0.75**2 / 2), 1e-14)
        self.assertLess(abs(moment - slope * cosine * 0.0703125), 1e-14)
        self.assertLess(abs(length - 0.75), 1e-10)


class Balance(unittest.TestCase):
    def test_sphere_and_plane(self):
        """Force on the plate, reactions at the symmetry planes and on top: normals of the sphere count."""
        deck = {
            "mesh": {"generate": {"kind": "sphere_plane", "facets": 4, "core": 0.3,
                                  "plate_size": 0.3, "plate_divisions": 6}},
            "materials": {"rubber": {"young": 1, "poisson": 0.3}},
            "bodies": {"sphere": {"blocks": ["sphere"], "material": "rubber"},
                       "plate": {"blocks": ["plate"], "rigid": {"displacement": [0, 0, 0.03]}}},
            "displacements": {"x0": {"set": "x0", "fix": ["x"]}, "y0": {"set": "y0", "fix": ["y"]},
                              "top": {"set": "top", "fix": ["z"]}},
            "newton": {"tolerance": 1e-13},
            "verify": {axis: scenes.probe(f"reaction_{axis}", place)
                       for axis, place in (("x", "x0"), ("y", "y0"), ("z", "top"))},
        }
        for primary, secondary in (("plate_top", "contact"), ("contact", "plate_top")):
            with self.subTest(primary=primary):
                deck["contact"] = {"pair": {"primary": primary, "secondary": secondary, "reach": 10}}
                result = scenes.run(deck)
                sign = -1 if primary == "contact" else 1  # the reported force acts on the primary
                on_plate = sign * result.force()
                reactions = numpy.array([result.quantity(axis) for axis in "xyz"])
                print(f"balance, primary {primary}: on the plate {on_plate}  reactions {reactions}")
                self.assertGreater(result.contact()["active_points"], 4)
                self.assertGreater(abs(on_plate[2]), 1e-4)
                self.assertLess(numpy.max(numpy.abs(on_plate - reactions)), 1e-10 * abs(on_plate[2]))


if __name__ == "__main__":
    unittest.main()
