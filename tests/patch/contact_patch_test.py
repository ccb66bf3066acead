# SPDX-License-Identifier: BSD-3-Clause
"""Flat contact patch test: two stacked blocks, uniform pressure, plan meshes n1 : n2 (primary : secondary).

Load "traction": p0 on top; stress -p0 everywhere and contact pressure p0, whatever the penalty. The blocks
touch exactly at the start, so only contact holds the upper one.
Load "displacement": the top moves down by D; p = E' D / (H1 + H2 + E'/eps) with E' the modulus of uniaxial
stress (poisson 0) or strain (sides on rollers).

With a matching or nested primary mesh the test passes to round-off. Otherwise Gauss points miss the kinks
of the secondary shape functions: the relative error of the secondary nodal forces for a uniform pressure is
d on line meshes and at most (1+d)^2 - 1 on plan meshes; LINE_DEFECT holds d for two points per direction.
"""
import unittest

import numpy

import nodal_forces
import scenes

P0 = 1e-2
APPROACH = 0.02
EXACT = 1e-10
LINE_DEFECT = {(2, 3): 0.0245, (3, 2): 0.0172, (4, 3): 0.0061, (5, 3): 0.0039, (2, 8): 1.0}


def scene(primary, secondary, load="traction", poisson=0.0, sides="rollers", factor=10.0,
          model="linear_elastic", young=(1.0, 1.0), **mesh):
    """Lower block carries the secondary face, upper block the primary one. sides: all four on rollers,
    or only x0 and y0 ("two rollers"), which leaves the lateral strain free."""
    deck = {
        "mesh": {"generate": {"kind": "blocks", "lower_divisions": [secondary, secondary, 2],
                              "upper_divisions": [primary, primary, 2], **mesh}},
        "materials": {name: {"model": model, "young": e, "poisson": poisson}
                      for name, e in zip(("lower", "upper"), young)},
        "bodies": {name: {"blocks": [name], "material": name} for name in ("lower", "upper")},
        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["z"]}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top",
                             "penalty_factor": factor}},
        "newton": {"tolerance": 1e-12},
        "verify": {"reaction": scenes.probe("reaction_z", "lower_bottom")},
    }
    for body in ("lower", "upper"):
        for axis in "xy":
            for end in "01" if sides == "rollers" else "0":
                name = f"{body}_{axis}{end}"
                deck["displacements"][name] = {"set": name, "fix": [axis]}
    if load == "displacement":
        deck["displacements"]["top"] = {"set": "upper_top", "z": -APPROACH}
    elif load == "pressure":
        deck["loads"] = {"top": {"side_set": "upper_top", "pressure": P0}}
    else:
        deck["loads"] = {"top": {"side_set": "upper_top", "traction": [0, 0, -P0]}}
    return deck


class Measured:
    """Relative errors of one run against stress -p and contact pressure p_contact."""

    def __init__(self, deck, p, p_contact=None):
        result = scenes.run(deck)
        fields = result.fields
        p_contact = p if p_contact is None else p_contact
        self.stress = max(numpy.max(numpy.abs(fields.element("stress_zz", block) + p)) / p
                          for block in ("lower", "upper"))
        pressure = fields.nodal("contact_pressure")[fields.node_set("upper_bottom")]
        self.pressure = numpy.max(numpy.abs(pressure - p_contact)) / p_contact
        # nothing counts unless the pair was pressed
        self.active = result.contact()["active_points"]
        self.balance = abs(result.force()[2] - result.quantity("reaction")) / p
        self.fields, self.result, self.p = fields, result, p

    def nodal_defect(self, poisson):
        top = self.fields.node_set("lower_top")
        area = nodal_forces.nodal_areas(self.fields, "lower_top")[top]
        force = -nodal_forces.internal_forces(self.fields, "lower", 1.0, poisson)[top, 2]
        return numpy.max(numpy.abs(force / (self.p * area) - 1))

    def predicted_defect(self):
        return nodal_forces.uniform_pressure_defect(self.fields, "upper_bottom", "lower_top", 2)


class Exact(unittest.TestCase):
    """Matching and nested meshes."""

    def check(self, deck, p=P0, p_contact=None, label=""):
        with self.subTest(label):
            m = Measured(deck, p, p_contact)
            print(f"exact  {label:42s} stress {m.stress:.1e}  pressure {m.pressure:.1e}")
            self.assertGreater(m.active, 0)
            self.assertLess(m.stress, EXACT)
            self.assertLess(m.pressure, EXACT)
            self.assertLess(m.balance, EXACT)
            return m

    def test_traction(self):
        for primary, secondary in ((3, 3), (8, 2)):
            for poisson in (0.0, 0.3):
                self.check(scene(primary, secondary, poisson=poisson),
                           label=f"{primary}:{secondary} traction, poisson {poisson}")

    def test_pressure_is_independent_of_penalty(self):
        for factor in (0.1, 1.0, 1000.0):
            self.check(scene(8, 2, poisson=0.3, factor=factor), label=f"8:2 traction, f {factor}")

    def test_different_stiffness(self):
        self.check(scene(8, 2, young=(10.0, 1.0)), label="8:2 traction, E 10 below 1")

    def test_other_cells(self):
        for element in ("tet4", "tet10", "hex20", "hex27", "wedge6"):
            for primary, secondary in ((3, 3), (8, 2)):
                self.check(scene(primary, secondary, poisson=0.3, element=element),
                           label=f"{primary}:{secondary} traction, {element}")

    def test_free_lateral_strain(self):
        # dead traction per reference area; the faces grow by (1 + nu p/E) each way
        self.check(scene(3, 3, poisson=0.3, sides="two rollers"), p_contact=P0 / (1 + 0.3 * P0)**2,
                   label="3:3 traction, poisson 0.3, free sides")

    def test_neo_hookean(self):
        # at poisson 0 the sides stay put without rollers; Cauchy = nominal stress
        for load in ("traction", "pressure"):
            m = self.check(scene(8, 2, load, model="neo_hookean", sides="two rollers"),
                           label=f"8:2 {load}, neo-Hookean")
            stretch = -P0 + numpy.sqrt(1 + P0**2)  # N = (E/2)(l - 1/l)
            gap = P0 / 20.0  # eps = 10 E A / V, cells 1/2 high
            top = m.fields.nodal("displacement_z")[m.fields.node_set("upper_top")]
            self.assertLess(numpy.max(numpy.abs(top - 2 * (stretch - 1) + gap)), EXACT)

    def test_displacement(self):
        modulus = {0.0: 1.0, 0.3: 0.7 / (1.3 * 0.4)}
        for primary, secondary in ((3, 3), (8, 2)):
            for poisson in (0.0, 0.3):
                for factor in (1.0, 10.0, 100.0):
                    epsilon = factor * 2.0  # cells of the upper block are 1/2 high
                    p = modulus[poisson] * APPROACH / (2 + modulus[poisson] / epsilon)
                    self.check(scene(primary, secondary, "displacement", poisson, factor=factor), p,
                               label=f"{primary}:{secondary} displacement, poisson {poisson}, f {factor}")


class WithinQuadrature(unittest.TestCase):
    """Meshes that do not fit: the error is that of the quadrature."""

    def measure(self, label, deck, poisson=0.0):
        m = Measured(deck, P0)
        defect, predicted = m.nodal_defect(poisson), m.predicted_defect()
        print(f"bound  {label:42s} stress {m.stress:.1e}  pressure {m.pressure:.1e}  "
              f"nodal force {defect:.4f}  predicted {predicted:.4f}")
        self.assertGreater(m.active, 0)
        self.assertLess(m.balance, EXACT)
        self.assertGreater(m.stress, 1e-6)  # a defect there must be, else nothing was tested
        self.assertLess(m.stress, predicted)
        return defect, predicted

    def test_ratios(self):
        for (primary, secondary), line in LINE_DEFECT.items():
            for poisson in (0.0, 0.3):
                with self.subTest(primary=primary, secondary=secondary, poisson=poisson):
                    bound = (1 + line)**2 - 1
                    label = f"{primary}:{secondary} traction, poisson {poisson}, table {bound:.4f}"
                    defect, predicted = self.measure(label, scene(primary, secondary, poisson=poisson),
                                                     poisson)
                    self.assertLess(defect, bound)
                    if (primary, secondary) == (2, 8):  # d = 1 is a node without force, below zero
                        self.assertLess(predicted, bound)
                    else:
                        self.assertAlmostEqual(predicted, bound, delta=2e-4)

    def test_ratio_beyond_table(self):
        defect, predicted = self.measure("7:5 traction", scene(7, 5))
        self.assertLess(defect, predicted)

    def test_rotated_mesh(self):
        for primary, secondary in ((4, 4), (6, 3)):
            with self.subTest(primary=primary, secondary=secondary):
                defect, predicted = self.measure(f"{primary}:{secondary} turned by 30 degrees",
                                                 scene(primary, secondary, rotation=30))
                self.assertLess(defect, predicted)

    def test_distorted_mesh(self):
        # the pressure itself varies here, which the prediction for a uniform one leaves out
        for primary, secondary in ((4, 4), (4, 2)):
            with self.subTest(primary=primary, secondary=secondary):
                defect, predicted = self.measure(f"{primary}:{secondary} distorted by 0.2",
                                                 scene(primary, secondary, distortion=0.2))
                self.assertLess(defect, 1.2 * predicted)


if __name__ == "__main__":
    unittest.main()
