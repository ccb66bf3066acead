# SPDX-License-Identifier: BSD-3-Clause
"""Two equal elastic bodies in Hertz contact, meshes 3:2, points on the fine or on the coarse side.
usage: hertz_pair_test.py [--meshes 8] [--formulation WORD]; faces of the coarse body
along the core, which is twice the contact wide for cylinders and 1.25 times for spheres

Hertz holds for a/R -> 0; here a/R is 0.004 and 0.02 with R = 1/2 the radius that counts.
"""
import itertools
import unittest

import numpy

import hertz_error
import scenes
import study

MODULUS = 0.5 / (1 - 0.3**2)  # 1/E* = 2 (1 - nu^2)/E, E = 1
RADIUS = 0.5
CORE = {"cylinder": 0.004, "sphere": 0.0125}
APPROACH = {"cylinder": 2.84e-5, "sphere": 2e-4}
KNOWN = study.arguments([8, 16])
MULTIPLIERS = {"enforcement": "augmented_lagrangian", "multiplier_tolerance": 1e-2,
               "max_augmentations": 4}
SPACES = study.spaces(multiplier_tolerance=1e-2, max_augmentations=4)


def scene(shape, facets, fine_primary, **contact):
    core = CORE[shape]
    generate = {"core": core, "upper_facets": 3 * facets // 2, "lower_facets": facets}
    fixed = {"x0": "x", "y0": "y", "lower_bottom": "z"}
    if shape == "cylinder":
        generate.update(kind="two_cylinders", growth=1.4, thickness=core / facets)
        fixed["y1"] = "y"
    else:
        generate.update(kind="two_spheres", growth=2, max_size=0.4)
    sides = ["upper_contact", "lower_contact"]
    primary, secondary = sides if fine_primary else sides[::-1]
    displacements = {name: {"set": name, "fix": [axis]} for name, axis in fixed.items()}
    displacements["top"] = {"set": "upper_top", "z": -APPROACH[shape]}
    return {
        "mesh": {"generate": generate},
        "materials": {"elastic": {"model": "linear_elastic", "young": 1, "poisson": 0.3}},
        "bodies": {body: {"blocks": [body], "material": "elastic"} for body in ("upper", "lower")},
        "displacements": displacements,
        "contact": {"pair": {"primary": primary, "secondary": secondary,
                             **study.contact(KNOWN, **contact)}},
    }


class Errors:
    """Pressure error in L2, contact radius and peak pressure at the force of the run."""

    def __init__(self, shape, facets, fine_primary, **contact):
        deck = scene(shape, facets, fine_primary, **contact)
        result = scenes.run(deck, seconds=300)
        primary = deck["contact"]["pair"]["primary"]
        x, p = hertz_error.pressure_line(result.fields, primary)
        self.force = abs(result.force()[2])
        if shape == "cylinder":
            a, peak = hertz_error.cylinder(2 * self.force / (CORE[shape] / facets), RADIUS, MODULUS)
        else:
            a, peak = hertz_error.sphere(4 * self.force, RADIUS, MODULUS)
        self.radius_of_contact = a
        self.pressure = hertz_error.pressure_error(x, p, a, peak, shape == "sphere")
        self.radius = abs(hertz_error.regressed_radius(x, p, a) / a - 1)
        self.peak = p[0] / peak - 1
        self.active = result.contact()["active_points"]
        self.layer = self.first_layer(result.fields, primary)
        faces = a / CORE[shape] * facets * (1.5 if fine_primary else 1)
        print(f"{shape:8s} {'fine' if fine_primary else 'coarse':6s} primary  {faces:5.2f} faces per a  "
              f"force {self.force:.5e}  errors: pressure L2 {self.pressure:.4f}  radius {self.radius:.4f}  "
              f"peak {self.peak:+.4f}  ({result.summary['unknowns']} unknowns)", flush=True)

    @staticmethod
    def first_layer(fields, primary):
        """Height of the cells at the contact on the primary side."""
        x = fields.coordinates
        upper = primary.startswith("upper")
        axis = (abs(x[:, 0]) < 1e-12) & (abs(x[:, 1]) < 1e-12) & (x[:, 2] > 0 if upper else x[:, 2] < 0)
        return numpy.min(numpy.abs(x[axis, 2]))


class Cylinders(unittest.TestCase):
    def test_orders(self):
        for space, fine_primary in itertools.product(SPACES, (True, False)):
            with self.subTest(space=space, fine_primary=fine_primary):
                runs = [Errors("cylinder", n, fine_primary, **SPACES[space]) for n in KNOWN.meshes]
                errors = [run.pressure for run in runs]
                print(f"  {space} orders: pressure", study.words(study.orders(KNOWN.meshes, errors)),
                      " radius", study.words(study.orders(KNOWN.meshes, [r.radius for r in runs])))
                self.assertGreater(min(run.active for run in runs), 0)
                # linear cells: the root at the contact edge allows order 1 in L2
                self.assertGreater(study.order(KNOWN.meshes, errors), 0.75)
                self.assertLess(abs(runs[-1].peak), 0.03)


class Spheres(unittest.TestCase):
    meshes = (4, 8) if KNOWN.thorough else (4,)

    def test_pressure_and_softened_force(self):
        """With eps = f E/h, h the height of the first layer, against multipliers on the same mesh."""
        for fine_primary in (True, False) if KNOWN.thorough else (True,):
            with self.subTest(fine_primary=fine_primary):
                for facets in self.meshes:
                    exact = Errors("sphere", facets, fine_primary, **MULTIPLIERS)
                    self.assertGreater(exact.active, 0)
                    for factor in (1, 10):
                        soft = Errors("sphere", facets, fine_primary, penalty_factor=factor)
                        self.compare(exact, soft, factor, finest=facets == 8)
                self.assertLess(abs(exact.peak), 0.05)

    def compare(self, exact, soft, factor, finest):
        softness = MODULUS * exact.layer / (factor * exact.radius_of_contact)
        ratio, expected = soft.force / exact.force, hertz_error.softened(softness)
        print(f"  f {factor:2d}  E*/(eps a) {softness:.4f}  force over exact {ratio:.4f}  "
              f"curve {expected:.4f}")
        self.assertLess(abs(ratio - expected), 0.015 if finest else 0.03)


if __name__ == "__main__":
    study.main()
