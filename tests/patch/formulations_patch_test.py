# SPDX-License-Identifier: BSD-3-Clause
"""The contact patch test of contact_patch_test.py for every formulation and enforcement.

Matching and nested meshes are exact to round-off. Otherwise the relative error of the secondary nodal
forces under a uniform pressure is a property of the quadrature: points at the nodes carry their share of
the area, which the line meshes below give the error `nodal`; Gauss points as in contact_patch_test.py.
Errors of plan meshes are at most (1 + d)^2 - 1.
"""
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import nodal_forces
import scenes
from contact_patch_test import EXACT, LINE_DEFECT, P0, Measured, scene

FORMULATIONS = ("node_on_facet", "facet_on_facet", "sliding_elastic")
NODAL = {(3, 2): 1 / 9, (2, 3): 1 / 2, (4, 3): 1 / 8, (5, 3): 0.08, (2, 8): 3.0}


def pressed(primary, secondary, formulation, **contact):
    deck = scene(primary, secondary)
    deck["contact"]["pair"].update(formulation=formulation, **contact)
    return deck


def force_defect(fields, p):
    """Relative errors of the forces that the nodes of the lower block feel."""
    top = fields.node_set("lower_top")
    area = nodal_forces.nodal_areas(fields, "lower_top")[top]
    force = -nodal_forces.internal_forces(fields, "lower", 1.0, 0.0)[top, 2]
    return force / (p * area) - 1


class Exact(unittest.TestCase):
    def test_matching_and_nested(self):
        for formulation in FORMULATIONS:
            for enforcement in ("penalty", "augmented_lagrangian"):
                for primary, secondary in ((3, 3), (8, 2)):
                    with self.subTest(formulation=formulation, enforcement=enforcement, primary=primary):
                        m = Measured(pressed(primary, secondary, formulation, enforcement=enforcement,
                                             multiplier_tolerance=1e-11), P0)
                        print(f"exact  {formulation:16s} {enforcement:21s} {primary}:{secondary} "
                              f"stress {m.stress:.1e}  pressure {m.pressure:.1e}")
                        self.assertEqual(m.active, 4 * primary**2)
                        self.assertLess(m.stress, EXACT)
                        self.assertLess(m.pressure, EXACT)
                        self.assertLess(m.balance, EXACT)

    def test_friction_changes_nothing(self):
        """No shear, nothing slips: the same state with friction, by every map."""
        for formulation, friction_map in (("node_on_facet", "incremental"), ("facet_on_facet", "incremental"),
                                          ("sliding_elastic", "inclined_ray"),
                                          ("sliding_elastic", "incremental")):
            with self.subTest(formulation=formulation, map=friction_map):
                m = Measured(pressed(8, 2, formulation, friction=0.3, friction_map=friction_map), P0)
                self.assertLess(m.stress, EXACT)
                self.assertEqual(m.result.contact()["stick_points"], m.active)


def transferred(primary, secondary, formulation, folder):
    """Largest error of the secondary nodal forces under a pressure that is uniform because nothing gives:
    a rigid block pressed into a clamped one. Each node of the lower surface is a set of its own."""
    path = scenes.mesh(pathlib.Path(folder) / "scene.exo", "blocks", lower_divisions=[secondary, secondary, 1],
                       upper_divisions=[primary, primary, 1])
    mesh = exodus_edit.read(path)
    nodes = mesh.node_sets["lower_top"]
    mesh.node_sets.update({f"n{node}": numpy.array([node]) for node in nodes})
    exodus_edit.write(path, mesh)
    depth, penalty = 1e-3, 3.0
    deck = {
        "mesh": {"file": "scene.exo"},
        "materials": {"m": {"model": "linear_elastic", "young": 1, "poisson": 0}},
        "bodies": {"lower": {"blocks": ["lower"], "material": "m"},
                   "upper": {"blocks": ["upper"], "rigid": {"displacement": [0, 0, -depth]}}},
        "displacements": {name: {"set": name, "fix": ["x", "y", "z"]} for name in ("lower_top", "lower_bottom")},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "penalty": penalty,
                             "formulation": formulation}},
        "verify": {f"n{node}": scenes.probe("reaction_z", f"n{node}") for node in nodes},
    }
    result = scenes.run(deck, files=[path])
    area = nodal_forces.nodal_areas(result.fields, "lower_top")
    error = [result.quantity(f"n{node}") / (penalty * depth * area[node]) - 1 for node in nodes]
    return numpy.abs(error).max(), result.fields


class Unmatched(unittest.TestCase):
    def test_transfer_of_a_uniform_pressure(self):
        with tempfile.TemporaryDirectory() as folder:
            for formulation in FORMULATIONS:
                for (primary, secondary), line in NODAL.items():
                    with self.subTest(formulation=formulation, primary=primary, secondary=secondary):
                        found, fields = transferred(primary, secondary, formulation, folder)
                        if formulation == "node_on_facet":
                            expected = (1 + line)**2 - 1
                        else:
                            expected = nodal_forces.uniform_pressure_defect(fields, "upper_bottom",
                                                                            "lower_top", 2)
                        print(f"uniform  {formulation:16s} {primary}:{secondary}  found {found:.10f}  "
                              f"expected {expected:.10f}")
                        self.assertLess(abs(found - expected), 1e-9)

    def test_nodes_on_facets_in_equilibrium(self):
        """The blocks give: the defect spreads, and stays within 5 % of the one under a uniform pressure."""
        for (primary, secondary), line in NODAL.items():
            with self.subTest(primary=primary, secondary=secondary):
                m = Measured(pressed(primary, secondary, "node_on_facet"), P0)
                bound = (1 + line)**2 - 1
                found = numpy.abs(force_defect(m.fields, P0)).max()
                print(f"nodal  {primary}:{secondary}  table {bound:.4f}  found {found:.4f}")
                self.assertLess(found, bound * 1.05)
                self.assertGreater(m.stress, 1e-6)
                self.assertLess(m.balance, EXACT)

    def test_rays_are_as_good_as_closest_points(self):
        for (primary, secondary), line in LINE_DEFECT.items():
            with self.subTest(primary=primary, secondary=secondary):
                m = Measured(pressed(primary, secondary, "sliding_elastic"), P0)
                bound = (1 + line)**2 - 1
                found = numpy.abs(force_defect(m.fields, P0)).max()
                print(f"rays   {primary}:{secondary}  table {bound:.4f}  found {found:.4f}")
                self.assertLess(found, bound)
                self.assertGreater(m.stress, 1e-6)
                self.assertLess(m.balance, EXACT)


if __name__ == "__main__":
    unittest.main()
