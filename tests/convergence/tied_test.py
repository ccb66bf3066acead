# SPDX-License-Identifier: BSD-3-Clause
"""A clamped bar 1 x 1 x 4, cut across its middle at 0 or 30 degrees, pressed by 0.02 and bent by a shear
of 0.001 at its end: tied or held by friction against the same bar of one piece.

Matching meshes: tied with multipliers is the bar of one piece; with a penalty the cut gives 1/eps.
Meshes 3 : 2: the cut may not cost more than a bar that is as coarse as its coarser half; the reference is
a bar of hex20.
"""
import math
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import scenes

PRESSURE, SHEAR = 0.02, 0.001  # bending stress at the cut 0.012: it stays closed
MAPS = [("node_on_facet", "incremental"), ("facet_on_facet", "incremental"),
        ("sliding_elastic", "inclined_ray"), ("sliding_elastic", "incremental")]
FORMULATIONS = ("node_on_facet", "facet_on_facet", "sliding_elastic")


def skew(path, angle):
    """The plane z = 0 turns by the angle about y, the ends z = -2 and z = 2 stay."""
    mesh = exodus_edit.read(path)
    x, z = mesh.x[:, 0], mesh.x[:, 2]
    mesh.x[:, 2] = z + (1 - numpy.abs(z) / 2) * math.tan(math.radians(angle)) * (x - 0.5)
    exodus_edit.write(path, mesh)
    return path


class Bar(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name) / "scene.exo"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def deck(self, bodies, top, bottom):
        return {
            "mesh": {"file": "scene.exo"},
            "materials": {"m": {"model": "linear_elastic", "young": 1.0, "poisson": 0.3}},
            "bodies": {name: {"blocks": [name], "material": "m"} for name in bodies},
            "displacements": {"bottom": {"set": bottom, "fix": ["x", "y", "z"]}},
            "loads": {"top": {"side_set": top, "traction": [SHEAR, 0, -PRESSURE]}},
            "newton": {"tolerance": 1e-9}, "linear_solver": {"method": "direct"},
            "verify": {axis: scenes.probe(f"displacement_{axis}", top) for axis in "xz"},
        }

    def end(self, deck):
        """Mean displacement of the end: bending, axial."""
        result = scenes.run(deck, files=[self.path])
        return numpy.array([result.quantity("x"), result.quantity("z")]), result

    def one_piece(self, n, element="hex8", angle=0):
        scenes.mesh(self.path, "box", size=[1, 1, 4], divisions=[n, n, 4 * n], origin=[0, 0, -2],
                    element=element)
        skew(self.path, angle)
        return self.end(self.deck(["box"], "z1", "z0"))[0]

    def cut(self, primary, secondary, angle, steps=1, **contact):
        scenes.mesh(self.path, "blocks", lower_size=[1, 1, 2], upper_size=[1, 1, 2],
                    lower_divisions=[secondary, secondary, 2 * secondary],
                    upper_divisions=[primary, primary, 2 * primary])
        skew(self.path, angle)
        deck = self.deck(["lower", "upper"], "upper_top", "lower_bottom")
        deck["contact"] = {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}}
        deck["time"] = {"steps": steps}
        return self.end(deck)

    def test_matching_meshes(self):
        """The penalty's error is proportional to 1/f; multipliers remove it."""
        for angle in (0, 30):
            whole = self.one_piece(2, angle=angle)
            for formulation in FORMULATIONS:
                with self.subTest(formulation=formulation, angle=angle):
                    errors = [numpy.abs(self.cut(2, 2, angle, formulation=formulation, tied=True,
                                                 penalty_factor=f)[0] / whole - 1).max() for f in (1e2, 1e3)]
                    multipliers = numpy.abs(self.cut(
                        2, 2, angle, formulation=formulation, tied=True, penalty_factor=100,
                        enforcement="augmented_lagrangian", multiplier_tolerance=1e-9,
                        max_augmentations=50)[0] / whole - 1).max()
                    print(f"matching  {formulation:16s} {angle:2d} degrees: penalty {errors[0]:.2e} {errors[1]:.2e}"
                          f"  multipliers {multipliers:.1e}")
                    self.assertGreater(errors[0], 1e-4)
                    self.assertAlmostEqual(errors[0] / errors[1], 10, delta=0.5)
                    self.assertLess(multipliers, 1e-7)

    def test_unmatched_meshes(self):
        reference = self.one_piece(3, "hex20")
        for angle in (0, 30):
            coarse = self.one_piece(2, angle=angle) / reference - 1
            for formulation in FORMULATIONS:
                for options in ({"tied": True, "penalty_factor": 100}, {"friction": 10.0}):
                    with self.subTest(formulation=formulation, angle=angle, **options):
                        end, result = self.cut(3, 2, angle, formulation=formulation, **options)
                        error = end / reference - 1
                        print(f"3 : 2  {formulation:16s} {angle:2d} degrees {options}: error {error[0]:+.4f} "
                              f"{error[1]:+.4f}, one coarse piece {coarse[0]:+.4f} {coarse[1]:+.4f}")
                        self.assertEqual(result.contact()["slip_points"], 0)
                        self.assertGreater(result.contact()["stick_points"], 20)
                        self.assertLess(abs(error[0]), abs(coarse[0]))

    def test_first_contact_in_1_2_and_5_steps(self):
        """Bodies that touch stick from the start: the number of steps does not matter."""
        for formulation, friction_map in MAPS:
            for angle in (0, 30):
                with self.subTest(formulation=formulation, map=friction_map, angle=angle):
                    ends = [self.cut(3, 2, angle, steps, formulation=formulation, friction=10.0,
                                     friction_map=friction_map)[0] for steps in (1, 2, 5)]
                    spread = [float(numpy.abs(end / ends[-1] - 1).max()) for end in ends[:2]]
                    print(f"first contact  {formulation:16s} {friction_map:12s} {angle:2d} degrees: 1 step "
                          f"{spread[0]:.1e}, 2 steps {spread[1]:.1e} from 5")
                    self.assertLess(max(spread), 1e-3)


if __name__ == "__main__":
    unittest.main()
