# SPDX-License-Identifier: BSD-3-Clause
"""Hertz contact under mesh refinement, and what a finite penalty costs.

Hertz holds for a/R -> 0: the computed pressure sees the true shape and the tangential displacements,
which change it by O(a/R). Hence a/R = 0.01 (sphere) and 0.002 (cylinder), half the fine core of the mesh.
Errors are taken at the force of the run.
"""
import unittest

import hertz_error
import scenes
import study

MODULUS = 1 / (1 - 0.3**2)  # E = 1, poisson 0.3, rigid plane
RADIUS = 1.0
CORE = {"cylinder": 0.004, "sphere": 0.02}
SPACES = study.spaces(penalty_factor=10, multiplier_tolerance=1e-4, max_augmentations=4)


def scene(shape, facets, approach, **contact):
    """Quarter sphere, or half cylinder in plane strain one cell thick, on a rigid plate that rises."""
    core = CORE[shape]
    generate = {"facets": facets, "core": core}
    fixed = {"x0": "x", "y0": "y", "top": "z"}
    if shape == "cylinder":
        generate.update(kind="quarter_cylinder", growth=1.4, thickness=core / facets)
        fixed["y1"] = "y"
    else:
        generate.update(kind="sphere_plane", growth=2, max_size=0.4)
    return {
        "mesh": {"generate": generate},
        "materials": {"elastic": {"model": "linear_elastic", "young": 1, "poisson": 0.3}},
        "bodies": {"body": {"blocks": [shape], "material": "elastic"},
                   "plate": {"blocks": ["plate"], "rigid": {"displacement": [0, 0, approach]}}},
        "displacements": {name: {"set": name, "fix": [axis]} for name, axis in fixed.items()},
        "contact": {"pair": {"primary": "contact", "secondary": "plate_top", **contact}},
    }


class Errors:
    """Pressure error in L2, contact radius error, peak pressure error of one multiplier run."""

    def __init__(self, shape, facets, approach, **contact):
        size = CORE[shape] / facets
        result = scenes.run(scene(shape, facets, approach, **contact))
        x, p = hertz_error.pressure_line(result.fields, "contact")
        if shape == "cylinder":
            force = 2 * result.force()[2] / size
            a, peak = hertz_error.cylinder(force, RADIUS, MODULUS)
        else:
            force = 4 * result.force()[2]
            a, peak = hertz_error.sphere(force, RADIUS, MODULUS)
        self.pressure = hertz_error.pressure_error(x, p, a, peak, shape == "sphere")
        self.radius = abs(hertz_error.regressed_radius(x, p, a) / a - 1)
        self.peak = abs(p[0] / peak - 1)
        self.active = result.contact()["active_points"]
        self.per_radius = a / size
        print(f"{shape:8s} {self.per_radius:5.2f} facets per a  a/R {a:.4f}  force {force:.5e}  errors: "
              f"pressure L2 {self.pressure:.4f}  radius {self.radius:.4f}  peak {self.peak:.4f}  "
              f"({result.summary['unknowns']} unknowns)")


class Orders(unittest.TestCase):
    def study(self, space, shape, approach, meshes):
        runs = [Errors(shape, facets, approach, **SPACES[space]) for facets in meshes]
        pressure, radius = [r.pressure for r in runs], [r.radius for r in runs]
        overall = study.orders([meshes[0], meshes[-1]], [pressure[0], pressure[-1]])[0]
        print(f"{shape:8s} {space} orders: pressure L2 {study.words(study.orders(meshes, pressure))}"
              f"  overall {overall:.2f}  radius {study.words(study.orders(meshes, radius))}")
        for run in runs:
            self.assertGreater(run.active, 0)
        for values in (pressure, radius):
            self.assertEqual(values, sorted(values, reverse=True))
        # linear cells: the root at the contact edge allows order 1 in L2
        self.assertGreater(overall, 0.75)
        self.assertLess(overall, 1.3)
        return runs

    def test_cylinder(self):
        for space in SPACES:
            with self.subTest(space=space):
                runs = self.study(space, "cylinder", 1.42e-5, (8, 16, 32, 64))
                self.assertLess(runs[-1].pressure, 0.02)
                self.assertLess(max(run.peak for run in runs), 0.01)

    def test_sphere(self):
        for space in SPACES:
            with self.subTest(space=space):
                runs = self.study(space, "sphere", 1e-4, (4, 8, 16))
                self.assertLess(runs[-1].pressure, 0.07)
                self.assertLess(max(run.peak for run in runs), 0.03)


class Penalty(unittest.TestCase):
    def test_force_follows_softened_curve(self):
        """eps = f E/h with h the height of the surface cells; same mesh, same approach."""
        facets, approach = 8, 1e-4
        exact = scenes.run(scene("sphere", facets, approach, enforcement="augmented_lagrangian", multipliers="per_point",
                                 multiplier_tolerance=1e-4, penalty_factor=30)).force()[2]
        a, _ = hertz_error.sphere(4 * exact, RADIUS, MODULUS)
        for factor in (1, 10):
            with self.subTest(factor=factor):
                ratio = scenes.run(scene("sphere", facets, approach,
                                         penalty_factor=factor)).force()[2] / exact
                softness = MODULUS * CORE["sphere"] / facets / (factor * a)
                expected = hertz_error.softened(softness)
                print(f"penalty factor {factor}: E*/(eps a) {softness:.4f}  force over exact {ratio:.4f}"
                      f"  curve {expected:.4f}")
                self.assertLess(ratio, 1)
                self.assertLess(abs(ratio - expected), 0.1 * (1 - expected))


if __name__ == "__main__":
    unittest.main()
