# SPDX-License-Identifier: BSD-3-Clause
"""A rigid disc on a half-space that hardly changes its volume: the force is 2 a E* delta for every Poisson ratio.
Displacement elements lock as it goes to a half; enhanced ones and those with a mean dilatation do not."""
import math
import unittest

import scenes

RADIUS, DEPTH, SIZE = 1.0, 1e-3, 10
RATIOS = (0.3, 0.45, 0.49, 0.499, 0.4999)


def exact_force(nu):
    return 2 * RADIUS * DEPTH / (1 - nu**2) / 4


def far_field(nu):
    """Boussinesq's displacements of a point force, in decks' expressions; it is the punch's resultant."""
    size = 4 * exact_force(nu) * (1 + nu) / (2 * math.pi)
    r = "sqrt(x^2+y^2+z^2+1e-30)"
    along = f"t*{size!r}/{r}*(-z/{r}^2-{1 - 2 * nu!r}/({r}-z))"
    return f"{along}*x", f"{along}*y", f"-t*{size!r}/{r}*({2 * (1 - nu)!r}+z^2/{r}^2)"


def deck(element, material, nu, facets, **contact):
    x, y, z = far_field(nu)
    return {
        "mesh": {"generate": {"kind": "punch", "shape": "disc", "facets": facets, "size": SIZE, "growth": 1.4,
                              "max_size": SIZE, "punch_divisions": 32}},
        "materials": {"elastic": material},
        "bodies": {"body": {"blocks": ["body"], "material": "elastic", "element": element},
                   "punch": {"blocks": ["punch"], "rigid": {"displacement": [0, 0, -DEPTH]}}},
        "displacements": {"side": {"set": "side", "x": x, "y": y, "z": z},
                          "bottom": {"set": "bottom", "x": x, "y": y, "z": z},
                          "symmetry x": {"set": "x0", "x": x}, "symmetry y": {"set": "y0", "y": y}},
        "contact": {"punch": {"primary": "contact", "secondary": "punch_bottom", "projection_margin": 1e-6,
                              **contact}},
    }


def compressible(nu):
    return {"young": 1.0, "poisson": nu}


def uncoupled(nu):
    shear, bulk = 0.5 / (1 + nu), 1 / (3 * (1 - 2 * nu))
    return {"model": "mooney_rivlin", "c1": shear / 2, "bulk": bulk}


def error(element, material, nu, facets, **contact):
    """Of the force, relative to the exact one, and whether all points press."""
    result = scenes.run(deck(element, material, nu, facets, **contact), seconds=300)
    points = 3 * facets**2  # 4 in each of 3/4 facets^2 faces
    return -result.force("punch")[2] / exact_force(nu) - 1, result.contact("punch")["active_points"] == points


class Incompressible(unittest.TestCase):
    ENFORCEMENTS = ({"penalty_factor": 100}, {"enforcement": "augmented_lagrangian"})

    def test_mean_dilatation_does_not_lock(self):
        self.does_not_lock("mean_dilatation", uncoupled, 1, 0.025)

    def test_enhanced_does_not_lock(self):
        self.does_not_lock("enhanced", compressible, 2, 0.03)

    def does_not_lock(self, element, material, first, rest):
        """From RATIOS[first] on nothing but the last digits of the ratio changes. The rest is the edge, as wide as a face, and the same for all ratios; it halves with the faces."""
        print(element + ": contact | faces | error of the force for Poisson's ratio " + " ".join(map(str, RATIOS)))
        for contact in self.ENFORCEMENTS:
            worst = []
            for facets in (6, 10):
                errors, press = zip(*(error(element, material(nu), nu, facets, **contact) for nu in RATIOS))
                self.assertTrue(all(press))
                print(*contact.values(), "|", facets, "|", " ".join(f"{e:.4f}" for e in errors))
                worst.append(max(map(abs, errors)))
                self.assertLess(max(errors[first:]) - min(errors[first:]), 2e-3)
            self.assertLess(worst[1], 0.75 * worst[0])
            self.assertLess(worst[1], rest)

    def test_displacement_elements_lock_here(self):
        """Else the scene would show nothing."""
        errors, press = zip(*(error("displacement", compressible(nu), nu, 6, penalty_factor=100)
                              for nu in (0.3, 0.49, 0.4999)))
        print("displacement elements: " + " ".join(f"{e:.4f}" for e in errors))
        self.assertFalse(press[-1])  # some points even come off
        self.assertLess(errors[0], 0.06)
        self.assertGreater(errors[1], 0.15)
        self.assertGreater(errors[2], 2.0)


if __name__ == "__main__":
    unittest.main()
