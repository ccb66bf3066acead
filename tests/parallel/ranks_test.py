#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The same scene on 1, 2 and 4 ranks: same displacements, same counts.

Each parallel run writes a file per rank, so that the tests also see where the contact lies: a cut
through it, or ranks without any of it, must really have happened.
"""
import unittest

import numpy as np
import scenes

TOLERANCE = 1e-10  # largest difference of a displacement over the largest displacement

SLAB = {
    "mesh": {"generate": {"kind": "blocks", "lower_size": [8, 1, 1], "lower_divisions": [16, 2, 2],
                          "upper_size": [8, 1, 1], "upper_divisions": [24, 3, 2]}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 3.0, "poisson": 0.2}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "stiff"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "top": {"set": "upper_top", "x": 0.02, "y": 0.0, "z": -0.2}},
    "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top"}},
    "time": {"steps": 2},
    "linear_solver": {"method": "direct"},
    "output": {"files": "per_rank"},
}

SPHERE = {
    "mesh": {"generate": {"kind": "sphere_plane", "facets": 4, "core": 0.3}},
    "materials": {"elastic": {"young": 1.0, "poisson": 0.3}},
    "bodies": {"sphere": {"blocks": ["sphere"], "material": "elastic"},
               "plate": {"blocks": ["plate"], "rigid": {"displacement": [0, 0, 0.03]}}},
    "displacements": {"symmetry_x": {"set": "x0", "fix": ["x"]},
                      "symmetry_y": {"set": "y0", "fix": ["y"]},
                      "top": {"set": "top", "fix": ["z"]}},
    "contact": {"pair": {"primary": "contact", "secondary": "plate_top"}},
    "time": {"steps": 2},
    "linear_solver": {"method": "direct"},
    "output": {"files": "per_rank"},
}

# Pressed in the first fifth, then pushed along by 1.1, more than four faces of the lower block.
SLIDING = {
    "mesh": {"generate": {"kind": "blocks", "lower_size": [4, 1, 0.5],
                          "lower_divisions": [16, 4, 2], "upper_size": [1.5, 0.8, 0.5],
                          "upper_divisions": [8, 3, 2]}},
    "materials": SLAB["materials"],
    "bodies": SLAB["bodies"],
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "press": {"set": "upper_top", "y": 0.0, "z": -0.03, "curve": "press"},
                      "slide": {"set": "upper_top", "x": 1.1, "curve": "slide"}},
    "curves": {"press": [[0, 0], [0.2, 1]], "slide": [[0.2, 0], [1, 1]]},
    "contact": SLAB["contact"],
    "time": {"steps": 10},
    "linear_solver": {"method": "direct"},
    "output": {"files": "per_rank"},
}

AUGMENTED = {"contact": {"pair": {"enforcement": "augmented_lagrangian", "multiplier_tolerance": 1e-4}}}


class Ranks:
    """One run, its per-rank files put together by node number."""

    def __init__(self, deck, ranks):
        self.result = scenes.run(deck, ranks=ranks)
        self.summary = self.result.summary
        self.files = [scenes.Fields(path) for path in self.result.result_files]
        assert len(self.files) == ranks, self.result.result_files

    def displacement(self):
        """Nodes x 3 in the order of the node numbers; nodes on a cut must agree."""
        seen = {}
        for file in self.files:
            for node, u in zip(file.node_map, file.vector("displacement")):
                assert np.array_equal(seen.setdefault(node, u), u), "ranks differ at a shared node"
        return np.array([seen[node] for node in sorted(seen)])

    def faces(self, side_set):
        """Number of faces of a side set on each rank."""
        return [len(file.side_set(side_set)[0]) for file in self.files]

    def active_ranks(self, side_set):
        """Number of ranks that own a face of the side set under pressure."""
        return sum(bool(_has_pressure(file, side_set)) for file in self.files)


def _has_pressure(file, side_set):
    elements = set(file.side_set(side_set)[0])
    pressure, first = file.nodal("contact_pressure"), 0
    for block in file.names("eb"):
        nodes = file.connectivity(block)
        for e, row in enumerate(nodes, first):
            if e in elements and (pressure[row] > 0).sum() >= 4:
                return True
        first += len(nodes)
    return False


class SameOnAllRanks(unittest.TestCase):
    def compare(self, deck, primary, augmented=False):
        one = Ranks(deck, 1)
        u = one.displacement()
        scale = np.abs(u).max()
        self.assertGreater(scale, 1e-3)
        self.assertGreater(one.result.contact()["active_points"], 0)
        if augmented:
            self.assertGreater(one.summary["augmentations"], 1)
        runs = []
        for ranks in (2, 4):
            with self.subTest(ranks=ranks):
                many = Ranks(deck, ranks)
                self.assertEqual(many.summary["ranks"], ranks)
                difference = np.abs(many.displacement() - u).max() / scale
                print(f"{self.id().split('.')[-1]} on {ranks} ranks: difference {difference:.1e}, "
                      f"faces {many.faces(primary)}")
                self.assertLess(difference, TOLERANCE)
                for key in ("unknowns", "steps", "newton_iterations", "augmentations", "cut_backs"):
                    self.assertEqual(many.summary[key], one.summary[key], key)
                self.assertEqual(many.result.contact()["active_points"],
                                 one.result.contact()["active_points"])
                np.testing.assert_allclose(many.result.force(), one.result.force(), rtol=0,
                                           atol=1e-9 * np.abs(one.result.force()).max())
                runs.append(many)
        return runs

    def test_slab_cut_through_contact_penalty(self):
        for run in self.compare(SLAB, "upper_bottom"):
            self.assertGreaterEqual(run.active_ranks("upper_bottom"), 2)

    def test_slab_cut_through_contact_augmented(self):
        for run in self.compare(scenes.merged(SLAB, AUGMENTED), "upper_bottom", augmented=True):
            self.assertGreaterEqual(run.active_ranks("upper_bottom"), 2)

    def test_sphere_with_ranks_without_faces(self):
        for deck in (SPHERE, scenes.merged(SPHERE, AUGMENTED)):
            runs = self.compare(deck, "contact", augmented=deck is not SPHERE)
            self.assertIn(0, runs[-1].faces("contact"))
            self.assertGreater(sum(runs[-1].faces("contact")), 0)

    def test_sliding_over_several_faces(self):
        for run in self.compare(SLIDING, "upper_bottom"):
            self.assertEqual(run.summary["steps"], 10)
            # 1.1 is more than four faces of the lower block, and more than faces are collected for.
            slid = [file.nodal("displacement_x")[file.node_set("upper_bottom")]
                    for file in run.files]
            self.assertGreater(np.concatenate(slid).min(), 1.0)
            self.assertGreaterEqual(run.active_ranks("upper_bottom"), 2)

    def test_points_that_swing_between_faces(self):
        # Points right above edges of the lower faces: what a point did before decides here, and
        # must do so alike on any number of ranks. Without that memory Newton cycles for ever.
        deck = scenes.merged(SLAB, {
            "mesh": {"generate": {"upper_divisions": [20, 3, 2]}}, "time": {"steps": 1},
            "displacements": {"top": {"x": 0.01, "z": -0.1}},
            "contact": {"pair": {"enforcement": "augmented_lagrangian",
                                 "multiplier_tolerance": 1e-4, "max_augmentations": 15}}})
        for run in self.compare(deck, "upper_bottom", augmented=True):
            self.assertEqual(run.summary["cut_backs"], 0)

    def test_krylov_agrees_with_direct(self):
        krylov = scenes.merged(SLAB, {"linear_solver": {"method": "krylov", "tolerance": 1e-10}})
        direct, iterative = Ranks(SLAB, 2), Ranks(krylov, 2)
        u, v = direct.displacement(), iterative.displacement()
        print(f"krylov: difference {np.abs(u - v).max() / np.abs(u).max():.1e}, "
              f"{iterative.summary['linear_iterations']} linear iterations")
        self.assertLess(np.abs(u - v).max(), 1e-6 * np.abs(u).max())
        self.assertGreater(iterative.summary["linear_iterations"],
                           direct.summary["linear_iterations"] + 20)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
