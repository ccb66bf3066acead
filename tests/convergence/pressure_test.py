# SPDX-License-Identifier: BSD-3-Clause
"""Pressures of the paraboloid against Hertz for each space of multipliers.
usage: pressure_test.py [unittest arguments] [--meshes 2 4] [--formulation WORD] [--spaces WORDS]
meshes: facets for each contact radius

The best a continuous bilinear pressure can do is lost on the one ring of faces that the contact edge cuts: an error of
order h/a. 0.41 to 0.49 h/a were measured on three meshes for averages at nodes, whatever the enforcement, and 0.52
with points at nodes. Points that
read smoothed multipliers open one by one and lose half of that, in the mean over places of the edge within its face: at
one place the error is that of the points which the edge has just passed, 0.2 to 0.31 h/a over one face.
"""
import unittest

import pressure_study
import scenes
import study

KNOWN = study.arguments([2])
SPACES = KNOWN.spaces or [word for word in scenes.words_of("multipliers") if word != "per_point"]
MULTIPLIERS = {"enforcement": "augmented_lagrangian"}
FACTOR = {"per_point": 10, "smoothed": 3, "dual": 30}
FINEST = 2.5944e-4  # force on the whole paraboloid, from 4 and 8 facets with multipliers by Richardson


class Pressures(unittest.TestCase):
    def run_scene(self, label, facets, loads=1, **options):
        approaches = pressure_study.loads(facets, loads)
        deck = pressure_study.deck(facets, approaches=approaches, **study.contact(KNOWN, **options))
        scores = pressure_study.Scores(deck)
        print(f"{label:20s} nf={facets} {scores}", flush=True)
        self.assertGreater(scores.summary["contact"]["pair"]["active_points"], 2 * facets**2)
        return scores

    def order(self, values):
        if KNOWN.thorough:
            order = study.order(KNOWN.meshes, values)
            print(f"  order {order:.2f}")
            self.assertGreater(order, 0.8)

    def test_nodal_pressure_of_any_penalty(self):
        """The average at the nodes does not mind stiffness, however the points' pressures oscillate."""
        nodal = []
        for facets in KNOWN.meshes:
            runs = [self.run_scene(f"f={factor}", facets, penalty_factor=factor) for factor in (10, 100)]
            faces = runs[1].facets_per_radius[-1]
            for run in runs:
                self.assertLess(run.nodal[-1], (0.55 if KNOWN.formulation == "node_on_facet" else 0.52) / faces)
            self.assertLess(runs[1].nodal[-1], runs[0].nodal[-1])
            if not KNOWN.nodal:  # the points of a node act alike: nothing can oscillate
                self.assertGreater(runs[1].point[-1], 1.5 * runs[0].point[-1])
            nodal.append(runs[1].nodal[-1])
        self.order(nodal)

    def test_multipliers(self):
        for space in SPACES:
            with self.subTest(space=space):
                errors = []
                for facets in KNOWN.meshes:
                    options = {"multipliers": space, "penalty_factor": FACTOR[space], **MULTIPLIERS}
                    run = self.run_scene(space, facets, **options)
                    faces = run.facets_per_radius[-1]
                    if space == "smoothed":
                        moved = self.run_scene("smoothed, 5 loads", facets, 5, **options)
                        errors.append(moved.point.mean())
                        self.assertLess((moved.point * moved.facets_per_radius).mean(), 0.3)
                    else:
                        errors.append(run.nodal[-1])
                        self.assertLess(errors[-1], 0.52 / faces)
                    # second order in h, 0.0096 and 0.008 measured; what penetrates is missing in the approach
                    missing = 1.5 * run.summary["contact"]["pair"]["max_penetration"] / pressure_study.APPROACH
                    self.assertLess(abs(run.force / FINEST - 1), 0.015 / faces**2 + missing)
                self.order(errors)


if __name__ == "__main__":
    study.main()
