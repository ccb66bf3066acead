#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The nodal law on 1, 2 and 4 ranks. Its means run over all faces around a node, which the cut goes through."""
import unittest

import numpy as np

import friction_ranks_test as friction
import scenes
from ranks_test import SLAB, SPHERE, TOLERANCE, Ranks

DUAL = {"contact": {"pair": {"multipliers": "dual"}}}
AUGMENTED = {"contact": {"pair": {"multipliers": "dual", "enforcement": "augmented_lagrangian",
                                  "multiplier_tolerance": 1e-4}}}


def shared_nodes(run, side_set):
    """Nodes under pressure that faces of two ranks have."""
    seen = []
    for file in run.files:
        elements, pressure, first = set(file.side_set(side_set)[0]), file.nodal("contact_pressure"), 0
        here = set()
        for block in file.names("eb"):
            nodes = file.connectivity(block)
            for e, row in enumerate(nodes, first):
                if e in elements:
                    here |= {file.node_map[n] for n in row if pressure[n] > 0}
            first += len(nodes)
        seen.append(here)
    return {n for i, a in enumerate(seen) for b in seen[:i] for n in a & b}


class SameOnAllRanks(unittest.TestCase):
    def compare(self, deck, side_set, cut=True):
        """cut: whether faces around one node must lie on two ranks."""
        one = Ranks(deck, 1)
        u, contact = one.displacement(), one.result.contact()
        self.assertGreater(contact["active_points"], 0)
        for ranks in (2, 4):
            with self.subTest(ranks=ranks):
                many = Ranks(deck, ranks)
                difference = np.abs(many.displacement() - u).max() / np.abs(u).max()
                shared = len(shared_nodes(many, side_set))
                print(f"{self.id().split('.')[-1]} on {ranks} ranks: difference {difference:.1e}, "
                      f"{shared} pressed nodes shared, faces {many.faces(side_set)}")
                self.assertTrue(shared > 0 or not cut)
                self.assertLess(difference, TOLERANCE)
                counts = ["unknowns", "steps", "augmentations", "cut_backs"]
                if "friction" not in deck["contact"]["pair"]:  # there rounding decides on the way, not on the end
                    counts.append("newton_iterations")
                for key in counts:
                    self.assertEqual(many.summary[key], one.summary[key], key)
                for key in ("active_points", "stick_points", "slip_points"):
                    self.assertEqual(many.result.contact()[key], contact[key], key)
                self.assertAlmostEqual(many.result.contact()["max_pressure"], contact["max_pressure"],
                                       delta=1e-9 * contact["max_pressure"])
        return one

    def test_slab(self):
        for formulation in ("facet_on_facet", "sliding_elastic"):
            for changes in (DUAL, AUGMENTED):
                with self.subTest(formulation=formulation):
                    deck = scenes.merged(scenes.merged(SLAB, changes),
                                         {"contact": {"pair": {"formulation": formulation}}})
                    self.compare(deck, "upper_bottom")

    def test_sphere_with_ranks_without_faces(self):
        for formulation in ("node_on_facet", "facet_on_facet"):
            with self.subTest(formulation=formulation):
                deck = scenes.merged(scenes.merged(SPHERE, AUGMENTED),
                                     {"contact": {"pair": {"formulation": formulation}}})
                self.compare(deck, "contact", cut=False)

    def test_accelerated(self):
        for space in ("smoothed", "dual"):
            with self.subTest(space=space):
                changes = {"multipliers": space, "enforcement": "augmented_lagrangian", "augmentation": "anderson",
                           "penalty_factor": 1, "gap_tolerance": 1e-4, "max_augmentations": 50}
                one = self.compare(scenes.merged(SLAB, {"contact": {"pair": changes}, "newton": {"inexact": False}}),
                                   "upper_bottom")
                self.assertGreater(one.summary["augmentations"], 3)

    def test_end_of_step(self):
        for space in ("smoothed", "dual"):
            with self.subTest(space=space):
                changes = {"multipliers": space, "enforcement": "augmented_lagrangian", "uzawa": "end_of_step"}
                one = self.compare(scenes.merged(SLAB, {"contact": {"pair": changes}, "time": {"steps": 3}}),
                                   "upper_bottom")
                self.assertEqual(one.summary["augmentations"], 0)

    def test_friction(self):
        # Solves that stop early would leave what their tolerance allows, along a path that rounding chooses.
        for formulation in ("facet_on_facet", "sliding_elastic"):
            with self.subTest(formulation=formulation):
                one = self.compare(scenes.merged(
                    friction.with_contact(formulation, **AUGMENTED["contact"]["pair"]),
                    {"newton": {"inexact": False}}),
                                   "upper_bottom")
                self.assertGreater(one.result.contact()["slip_points"], 0)
                self.assertGreater(one.result.contact()["stick_points"], 0)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
