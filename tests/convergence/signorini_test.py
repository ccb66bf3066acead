# SPDX-License-Identifier: BSD-3-Clause
"""Orders of convergence on the manufactured Signorini solution.
usage: signorini_test.py [--meshes 8 16] [--elements hex8 hex20] [--formulation WORD] [--friction 0.3]

The edge of the contact lies on a line of the mesh: the solution is smooth in each cell, and the orders are
those of the cells, k + 1 in displacement and k in energy. On a mesh that does not fit, quadratic cells come
down to 5/2 and 3/2. Nodal pressures are averages over the faces of a node: order 2 for any cell.
node_on_facet is exact for linear faces; on quadratic ones points at nodes integrate too little, and order 1 in
displacement and 1/2 in energy are all it gives.
The default multipliers stand at corners. The one at the edge closes the mean of a gap that grows with h^2 beyond
it: a bump of height h^2 and width h, order 5/2 in displacement, 2 in energy, 3/2 in pressure.
"""
import argparse
import math
import sys
import unittest

import numpy

import signorini

BAND = 0.2
QUANTITIES = ("displacement", "energy", "pressure", "shear")


def order(runs, name):
    """Between the last two meshes."""
    coarse, fine = runs[-2:]
    return (math.log(getattr(coarse, name) / getattr(fine, name)) / math.log(fine.cells / coarse.cells))


class Manufactured(unittest.TestCase):
    def test_is_in_equilibrium(self):
        x, z = numpy.meshgrid(numpy.linspace(-0.93, 0.91, 24), numpy.linspace(0.03, 0.97, 9))
        for kind in ("partial", "full"):
            for friction, share in ((0, 1), (0.3, 1), (0.3, 0.5)):
                exact = signorini.Solution(kind, friction, share)
                self.assertLess(numpy.abs(exact.unbalanced(x, z)).max(), 1e-6 * signorini.AMPLITUDE)
                line = numpy.linspace(-0.9, 0.9, 7)
                normal, shear = (exact.value(f, line, 0.0) for f in (exact.sigma_zz, exact.sigma_xz))
                p = exact.pressure(line + exact.middle)
                self.assertLess(numpy.abs(normal + p).max(), 1e-15)
                self.assertLess(numpy.abs(shear - share * friction * p).max(), 1e-15)


class Orders(unittest.TestCase):
    meshes = (8, 16)
    elements = ("hex8", "hex20")
    formulation = None
    friction = 0.0

    def study(self, kind, element, share=1.0, **contact):
        if self.formulation:
            contact["formulation"] = self.formulation
        exact = signorini.Solution(kind, self.friction, share)
        print(f"\n{kind} contact, {element}, friction {self.friction:g} times {share:g},",
              *(f"{key} {value}" for key, value in contact.items()))
        runs = []
        for cells in self.meshes:
            runs.append(signorini.Errors(exact, cells, element, **contact))
            print(" ", runs[-1], flush=True)
            self.check_status(runs[-1], share)
        found = {name: order(runs, name) for name in QUANTITIES if name != "shear" or self.friction}
        print("  orders", "  ".join(f"{name} {value:.2f}" for name, value in found.items()))
        return runs, found

    def check_status(self, run, share):
        self.assertGreater(run.contact["active_points"], 0)
        if self.friction and share == 1:
            self.assertGreater(run.contact["slip_points"], 0)
        if share < 1:
            self.assertEqual(run.contact["slip_points"], 0)
            self.assertGreater(run.contact["stick_points"], 0)

    def check_band(self, found, **expected):
        for name, value in expected.items():
            self.assertLess(abs(found[name] - value), BAND, name)

    def check_least(self, found, **expected):
        for name, value in expected.items():
            self.assertGreater(found[name], value - BAND, name)

    def low_order(self, element):
        return self.formulation == "node_on_facet" and element == "hex20"

    def augmented(self, kind, share=1.0):
        for element in self.elements:
            k = 1 if element == "hex8" else 2
            with self.subTest(element=element):
                runs, found = self.study(kind, element, share, **signorini.AUGMENTED)
                if self.low_order(element):
                    self.check_band(found, displacement=1, energy=0.5)
                    self.check_least(found, pressure=1)
                else:
                    self.check_band(found, displacement=k + 1, energy=k, pressure=2)
                    if self.friction:
                        self.check_least(found, shear=1)
                for run in runs:
                    self.assertLess(run.contact["max_penetration"] * run.cells, 1e-6)
                    if not self.friction and self.formulation != "node_on_facet":
                        points = 2 * run.cells * (k + 1)**2
                        # Pressure rises as a square from the edge of contact: at the column of points next to it,
                        # 1e-4 of the largest on 32 hex20, it is less than the error of pressures.
                        column = 2 * (k + 1) if kind == "partial" else 0
                        self.assertAlmostEqual(run.contact["active_points"],
                                               points // 2 if kind == "partial" else points, delta=column)

    def default(self, kind, share=1.0):
        """Orders of the default multipliers."""
        for element in self.elements:
            k = 1 if element == "hex8" else 2
            with self.subTest(element=element):
                runs, found = self.study(kind, element, share, **signorini.DEFAULT)
                if self.low_order(element):
                    self.check_least(found, displacement=1, energy=0.5, pressure=1)
                    continue
                partial = kind == "partial"
                self.check_least(found, displacement=min(k + 1, 2.5 if partial else 3), energy=k,
                                 pressure=1.5 if partial else 2)
                if self.friction:
                    self.check_least(found, shear=1)

    def test_full_contact_with_default_multipliers(self):
        self.default("full")

    def test_partial_contact_with_default_multipliers(self):
        self.default("partial")

    def test_stick_with_default_multipliers(self):
        if not self.friction:
            self.skipTest("without friction nothing sticks")
        self.default("full", share=0.5)

    def test_full_contact(self):
        self.augmented("full")

    def test_partial_contact(self):
        self.augmented("partial")

    def test_penalty_caps_the_order(self):
        """eps = f E/h leaves a penetration p h/(f E): order 1 in everything, whatever the cells."""
        for element in self.elements:
            with self.subTest(element=element):
                runs, found = self.study("full", element, penalty_factor=1)
                if self.low_order(element):
                    self.check_band(found, displacement=1, pressure=1)
                else:
                    self.check_band(found, displacement=1, energy=1, pressure=1)
                exact = signorini.STIFF * 3 * signorini.AMPLITUDE / signorini.YOUNG
                depth = runs[-1].contact["max_penetration"] * runs[-1].cells
                self.assertLess(abs(depth / exact - 1), 0.1)
                stiffer, _ = self.study("full", element, penalty_factor=10)
                self.assertLess(stiffer[-1].displacement, runs[-1].displacement / 5)

    def test_stick(self):
        """Half of the shear that would slide."""
        if not self.friction:
            self.skipTest("without friction nothing sticks")
        self.augmented("full", share=0.5)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--meshes", type=int, nargs="+", default=Orders.meshes)
    parser.add_argument("--elements", nargs="+", default=Orders.elements)
    parser.add_argument("--formulation")
    parser.add_argument("--friction", type=float, default=0.0)
    options, rest = parser.parse_known_args()
    Orders.meshes, Orders.elements = options.meshes, options.elements
    Orders.formulation, Orders.friction = options.formulation, options.friction
    unittest.main(argv=sys.argv[:1] + rest)
