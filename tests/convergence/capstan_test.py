# SPDX-License-Identifier: BSD-3-Clause
"""An elastic strip round half a rigid cylinder, pulled until all of it slips: T2/T1 and p grow as exp(m theta).
usage: capstan_test.py [--meshes 32] [--formulation WORD]; faces of the strip along the half circle

The belt formula m = mu is that of a membrane. A strip of thickness t carries the friction at t/2 from its middle
line: with no bending moment inside, a shear force -mu p r t/(2 R), R = r + t/2, is left, and the balance along the
strip gives k m^2 + m = mu r/R with k = mu t/(2 R). The strip starts as the stress-free arc, on the penalty springs
(`offset`) that its tail force asks for. At the ends that shear force has no counterpart: the pressure oscillates
there over the length of a beam on springs, and the friction of the end reaction, of order t/r, is in T2.
"""
import math
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import scenes
import study

FRICTION, WRAP, STRESS, WIDTH, PENALTY = 0.3, math.pi, 1e-3, 0.1, 1.0
FORMULATIONS = ["facet_on_facet", "sliding_elastic"]
SMOOTH = 1e-3  # of the friction, until the strip has stretched under its tail force
END = 0.8  # not in the fit: several lengths (4 E t^3/12 eps)^(1/4) of the disturbance by an end
KNOWN = study.arguments([32])
if KNOWN.formulation:
    FORMULATIONS = [KNOWN.formulation]


def slope(thickness):
    middle = 1 + thickness / 2
    k = FRICTION * thickness / (2 * middle)
    return (-1 + math.sqrt(1 + 4 * k * FRICTION / middle)) / (2 * k)


def wrapped(path, faces, thickness):
    """Blocks bent to arcs of radius 1 at the contact; the cylinder reaches 0.1 rad beyond the strip or more."""
    cells = math.ceil((WRAP + 0.2) / WRAP * faces)
    scenes.mesh(path, "blocks", lower_size=[WRAP * cells / faces, WIDTH, 0.2], lower_divisions=[cells, 1, 1],
                upper_size=[WRAP, WIDTH, thickness], upper_divisions=[faces, 1, 1], element="hex20")
    mesh = exodus_edit.read(path)
    x, y, z = mesh.x.T
    angle = x - (x.min() + x.max()) / 2
    radius = 1 + z - (z.max() - thickness)
    mesh.x = numpy.stack([radius * numpy.sin(angle), y, radius * numpy.cos(angle)], axis=1)
    exodus_edit.write(path, mesh)
    return path


def deck(thickness, formulation, slide, **contact):
    return {
        "mesh": {"file": "strip.exo"},
        "materials": {"elastic": {"young": 1, "poisson": 0}},
        "bodies": {"cylinder": {"blocks": ["lower"], "rigid": {}},
                   "strip": {"blocks": ["upper"], "material": "elastic"}},
        "displacements": {"left": {"set": "upper_y0", "y": 0}, "right": {"set": "upper_y1", "y": 0},
                          "pull": {"set": "upper_x1", "z": -slide, "curve": "pull"}},
        "loads": {"tail": {"side_set": "upper_x0", "traction": [0, 0, -STRESS], "curve": "tail"}},
        "curves": {"tail": [[0, 1], [1, 1]], "pull": [[0, 0], [0.2, 0], [1, 1]],
                   "rough": [[0, SMOOTH], [0.2, SMOOTH], [0.21, 1]]},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "formulation": formulation,
                             "friction": FRICTION, "friction_curve": "rough", "penalty": PENALTY,
                             "offset": STRESS * thickness / PENALTY, **contact}},
        "time": {"steps": 5}, "output": {"points": True},
        "verify": {"pull": scenes.probe("reaction_z", "upper_x1")},
    }


class Belt:
    """angle (from the tail), pressure and status of the points of the last step, and T2/T1."""

    def __init__(self, faces, thickness, formulation, slide=0.012, **contact):
        scene = deck(thickness, formulation, slide, **contact)
        with tempfile.TemporaryDirectory() as folder:
            mesh = wrapped(pathlib.Path(folder) / "strip.exo", faces, thickness)
            self.result = scenes.run(scene, files=[mesh], seconds=300)
        self.tensions = -self.result.quantity("pull") / (STRESS * thickness * WIDTH)
        table = next((self.result.folder / "results").glob("*.points.csv"))
        rows = numpy.genfromtxt(table, delimiter=",", names=True, dtype=None, encoding=None)
        rows = rows[rows["time"] == rows["time"].max()]
        self.angle = numpy.arctan2(rows["x"], rows["z"]) + WRAP / 2
        self.pressure, self.status = rows["pressure"], rows["status"]

    def slope(self):
        inside = (self.angle > END) & (self.angle < WRAP - END)
        return numpy.polyfit(self.angle[inside], numpy.log(self.pressure[inside]), 1)[0]


class Capstan(unittest.TestCase):
    def check(self, faces, thickness, formulation, tolerance, **contact):
        belt = Belt(faces, thickness, formulation, **contact)
        m, summary = slope(thickness), belt.result.contact()
        found, tensions = belt.slope(), math.exp(m * WRAP)
        print(f"t/r {thickness:.2f} {formulation:15s} {contact.get('enforcement', 'penalty'):20s} {faces:3d} faces"
              f"  m {found:.6f}  exact {m:.6f}  error {found / m - 1:+.1e}"
              f"   T2/T1 {belt.tensions:.5f}  exact {tensions:.5f}  error {belt.tensions / tensions - 1:+.1e}"
              f"  ({belt.result.summary['newton_iterations']} iterations)", flush=True)
        self.assertEqual(summary["stick_points"], 0)
        self.assertGreater(summary["slip_points"], 0.95 * 9 * faces)
        self.assertLess(abs(found / m - 1), tolerance)
        self.assertLess(abs(belt.tensions / tensions - 1), 0.02)

    def test_full_slip(self):
        """0.5 % tells m from mu, which it is less than by 1.1 % and 2.6 %."""
        for faces in KNOWN.meshes:
            for thickness in (0.02, 0.05):
                for formulation in FORMULATIONS:
                    with self.subTest(faces=faces, thickness=thickness, formulation=formulation):
                        self.check(faces, thickness, formulation, 5e-3)

    def test_multipliers(self):
        """They resolve the waves of the quadratic faces, which the springs of the penalty smooth out."""
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                self.check(KNOWN.meshes[-1], 0.05, formulation, 0.02, enforcement="augmented_lagrangian")

    def test_partial_slip(self):
        """T2/T1 below the limit: the strip slips over ln(T2/T1)/m from the pulled end, less the length
        sqrt(E t/eps) over which the tangential springs of the rest take up their share of the tension."""
        faces, thickness, penalty = KNOWN.meshes[-1], 0.02, 5.0
        for formulation in FORMULATIONS:
            for slide in (4e-4, 1.2e-3):
                with self.subTest(formulation=formulation, slide=slide):
                    belt = Belt(faces, thickness, formulation, slide, penalty=penalty,
                                offset=STRESS * thickness / penalty)
                    exact = WRAP - math.log(belt.tensions) / slope(thickness) + math.sqrt(thickness / penalty)
                    sticks, slips = belt.angle[belt.status == "stick"], belt.angle[belt.status == "slip"]
                    print(f"{formulation:15s} T2/T1 {belt.tensions:.5f}  sticks to {sticks.max():.4f}  slips from "
                          f"{slips.min():.4f}  exact {exact:.4f}", flush=True)
                    self.assertLess(sticks.max(), slips.min())
                    self.assertLess(abs(slips.min() - exact), WRAP / faces / 2)


if __name__ == "__main__":
    study.main()
