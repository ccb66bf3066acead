#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Contact in pieces: three formulations, penalty and three spaces of multipliers, friction to mu = 10.

A block is pressed on another that is meshed otherwise, drawn along it and back; the stops fall into each of
that. What a piece takes over is all that decides between stick and slip, so that the end and the numbers of
iterations are those of the run in one piece.
"""
import unittest

import chain
import scenes

TOLERANCE = 1e-12
SCENE = {
    "mesh": {"generate": {"kind": "blocks", "lower_size": [2, 1, 0.5], "lower_divisions": [5, 2, 1],
                          "upper_size": [1, 0.8, 0.4], "upper_divisions": [3, 2, 1], "turn": 7}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 3.0, "poisson": 0.2}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "stiff"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "press": {"set": "upper_top", "z": -0.02, "curve": "press"},
                      "slide": {"set": "upper_top", "x": 0.06, "y": 0.01, "curve": "slide"}},
    "curves": {"press": [[0, 0], [0.25, 1]], "slide": [[0.125, 0], [0.75, 1], [1, 0.8]]},
    "newton": {"tolerance": 1e-12},
    "linear_solver": {"method": "direct"},
}
ENFORCEMENTS = {
    "penalty": {"enforcement": "penalty"},
    **{space: {"enforcement": "augmented_lagrangian", "multipliers": space}
       for space in ("per_point", "smoothed", "dual")},
}


def with_contact(**options):
    return {**SCENE, "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **options}}}


class Contact(chain.Restarted):
    def pieces_are_the_whole(self, label, deck):
        whole = chain.one_piece(deck)
        pieces = chain.in_pieces(deck)
        self.assertGreater(whole.contact()["active_points"], 0)
        most = self.same_end(whole, pieces[-1], TOLERANCE)
        self.same_course(whole, pieces, TOLERANCE)
        print(f"{label}: difference {most:.1e}, {whole.summary['newton_iterations']} iterations, "
              f"{whole.summary['augmentations']} augmentations, stick {whole.contact()['stick_points']}, "
              f"slip {whole.contact()['slip_points']}", flush=True)
        return whole

    def formulation(self, name):
        for friction in (0.0, 0.3, 10.0):
            for enforcement, options in ENFORCEMENTS.items():
                with self.subTest(enforcement=enforcement, friction=friction):
                    whole = self.pieces_are_the_whole(
                        f"{name} {enforcement} mu {friction:g}",
                        with_contact(formulation=name, friction=friction, **options))
                    if friction == 0.0 and name != "sliding_elastic":  # whose tangent is not symmetric
                        self.assertGreater(whole.summary["extrapolated_steps"], 0)
                    if friction == 0.3:
                        self.assertGreater(whole.contact()["max_slip"], 1e-3)
                    if friction == 10.0:
                        self.assertGreater(whole.contact()["stick_points"], 0)

    def test_node_on_facet(self):
        self.formulation("node_on_facet")

    def test_facet_on_facet(self):
        self.formulation("facet_on_facet")

    def test_sliding_elastic(self):
        self.formulation("sliding_elastic")

    def test_other_memories(self):
        """Penalties that are chosen or follow areas, sticky points and ties, two passes, overlaps at the start."""
        for label, options in {
                "chosen factor": {"penalty_factor": "automatic", "enforcement": "augmented_lagrangian",
                                  "multipliers": "smoothed"},
                "areas": {"update_penalty": True, "friction": 0.3},
                "two passes": {"two_pass": True, "friction": 0.3},
                "sticky": {"sticky": True, "stick_strength": 0.02},
                "tied": {"tied": True},
                "augmented at the end": {"enforcement": "augmented_lagrangian", "multipliers": "per_point",
                                         "uzawa": "end_of_step", "friction": 0.3},
                "overlap": {"initial_overlap": "adjust", "friction": 0.3},
                "overlap of nodes": {"initial_overlap": "adjust", "friction": 0.3,
                                     **ENFORCEMENTS["dual"]},
                "incremental": {"formulation": "sliding_elastic", "friction_map": "incremental",
                                "friction": 0.3}}.items():
            with self.subTest(label):
                gap = -0.004 if "overlap" in label else 0.0
                deck = scenes.merged(with_contact(**options), {"mesh": {"generate": {"gap": gap}}})
                self.pieces_are_the_whole(label, deck)

    def test_windows(self):
        """Contact that begins after the first stop and ends before the last; a hold that counts from there."""
        deck = scenes.merged(with_contact(friction=0.3), {
            "contact": {"pair": {"from": 0.25, "until": 0.625}},
            "displacements": {"side": {"set": "upper_bottom", "y": 0.01, "from": 0.375, "until": 0.875,
                                       "relative": True}}})
        whole, pieces = chain.one_piece(deck), chain.in_pieces(deck)
        most = self.same_end(whole, pieces[-1], TOLERANCE, vectors=("displacement",))
        self.same_course(whole, pieces, TOLERANCE)
        self.assertEqual(whole.contact()["active_points"], 0)
        self.assertGreater(whole.contact()["friction_dissipation"], 0.0)
        print(f"windows: difference {most:.1e}")

    def test_krylov(self):
        """A run that has written a checkpoint goes on without its hierarchy, as the one does that starts there."""
        for friction in (0.0, 0.3):
            with self.subTest(friction=friction):
                deck = scenes.merged(with_contact(friction=friction), {
                    "mesh": {"generate": {"lower_divisions": [10, 5, 4], "upper_divisions": [8, 6, 4]}},
                    "linear_solver": {"method": "krylov"}, "output": {"checkpoint": {"every": 2}}})
                whole, pieces = chain.one_piece(deck), chain.in_pieces(deck)
                counts = (*chain.COUNTS, "linear_iterations")
                most = self.same_end(whole, pieces[-1], TOLERANCE, counts)
                self.assertGreater(whole.summary["linear_iterations"], 2 * whole.summary["newton_iterations"])
                print(f"Krylov, mu {friction:g}: difference {most:.1e}, {whole.summary['linear_iterations']} iterations")

    def test_cut_steps_stay_cut(self):
        """A step that had to be cut leaves short ones, and how short they are goes on."""
        deck = scenes.merged(with_contact(friction=0.3), {
            "newton": {"max_iterations": 4, "tolerance": 1e-8}, "displacements": {"slide": {"x": 0.2}},
            "time": {"target_iterations": 1, "prediction": "tangent"}})
        whole, pieces = chain.one_piece(deck), chain.in_pieces(deck)
        self.assertGreater(pieces[-2].summary["cut_backs"], 0)
        self.assertGreater(whole.summary["steps"], 2 * chain.STEPS)
        self.same_end(whole, pieces[-1], TOLERANCE)
        self.same_course(whole, pieces, TOLERANCE)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
