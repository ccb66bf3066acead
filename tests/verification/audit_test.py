# SPDX-License-Identifier: BSD-3-Clause
"""What the audit of converged steps finds in whole runs: bodies in each other where contact believes in
nothing, bodies that went through each other, missing pairs; and that right runs are left alone."""
import pathlib
import unittest

import numpy as np

import scenes

SHARED = pathlib.Path(__file__).resolve().parents[3] / "shared" / "inputs"

# The lower block has one face on top; the upper one lies between the points of that face.
SMALL = {
    "mesh": {"generate": {"kind": "blocks", "lower_divisions": [1, 1, 1], "upper_size": [0.5, 0.5, 1],
                          "upper_divisions": [1, 1, 1]}},
    "materials": {"soft": {"model": "linear_elastic", "young": 1.0, "poisson": 0.3}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "soft"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "head": {"set": "upper_top", "fix": ["x", "y"], "z": -0.1}},
    "contact": {"pair": {"primary": "lower_top", "secondary": "upper_bottom", "formulation": "facet_on_facet",
                         "enforcement": "penalty"}},
    "time": {"steps": 5},
}
BLIND = scenes.merged(SMALL, {"mesh": {"generate": {"upper_size": [0.4, 0.4, 1]}}})


def found(result):
    return [text for text in result.summary["warnings"] if text.startswith("audit:")]


class Audit(unittest.TestCase):
    def check_found(self, result, words, overlap=None):
        self.assertEqual(len(found(result)), len(set(found(result))))
        self.assertTrue(found(result), result.summary["warnings"])
        for word in words:
            self.assertIn(word, found(result)[-1])
        audit = result.summary["audit"]
        if overlap is not None:
            self.assertAlmostEqual(audit["unseen_overlap"], overlap, delta=0.02 * overlap)
        self.assertGreaterEqual(audit["overlap"] + 1e-12, 0.0 if overlap is None else audit["unseen_overlap"])
        return audit

    def test_secondary_between_points(self):
        result = scenes.run(BLIND)
        self.assertEqual(result.contact()["active_points"], 0)
        self.check_found(result, ["'upper'", "'lower'", "contact.pair sees nothing", "finer side as primary"], 0.1)
        # Field by field, with the deepest step last.
        values = result.fields.globals()
        for name in ("overlap", "overlap_over_face_size", "unseen_overlap", "tension", "cone", "balance"):
            self.assertEqual(values["audit_" + name], result.summary["audit"][name], name)
        self.assertEqual(result.fields.globals(0)["audit_overlap"], 0.0)

    def test_sides_swapped_is_right(self):
        result = scenes.run(scenes.merged(BLIND, {"contact": {"pair": {"primary": "upper_bottom",
                                                                       "secondary": "lower_top"}}}))
        self.assertGreater(result.contact()["active_points"], 0)
        self.assertEqual(found(result), [])
        self.assertGreater(result.summary["audit"]["overlap"], 0.0)  # the penalty's own
        self.assertEqual(result.summary["audit"]["unseen_overlap"], 0.0)

    def test_strict_stops_with_the_reason(self):
        result = scenes.run(scenes.merged(BLIND, {"audit": {"strict": True}, "time": {"max_cuts": 2}}), check=False)
        self.assertEqual(result.status, 1)
        self.assertGreater(result.summary["cut_backs"], 0)
        self.assertIn("audit: body 'upper'", result.summary["reason"])
        # What is on disk is in order.
        self.assertEqual(result.summary["audit"]["unseen_overlap"], 0.0)

    def test_strict_lets_right_runs_pass(self):
        deck = scenes.merged(SMALL, {"mesh": {"generate": {"lower_divisions": [4, 4, 4],
                                                           "upper_divisions": [3, 3, 3]}},
                                     "audit": {"strict": True}})
        result = scenes.run(deck)
        self.assertGreater(result.contact()["active_points"], 0)
        self.assertEqual(result.summary["cut_backs"], 0)

    def test_missing_pair(self):
        result = scenes.run(scenes.merged(SMALL, {"contact": None}))
        self.check_found(result, ["no contact joins these bodies"], 0.1)

    def test_wrong_faces(self):
        result = scenes.run(scenes.merged(SMALL, {"contact": {"pair": {"primary": "upper_bottom",
                                                                       "secondary": "lower_bottom"}}}))
        self.check_found(result, ["but not these faces"], 0.1)

    def test_jump_through_a_plate(self):
        deck = scenes.merged(SMALL, {"mesh": {"generate": {"lower_size": [1, 1, 0.05], "lower_divisions": [4, 4, 1],
                                                           "upper_divisions": [2, 2, 2], "gap": 0.01}},
                                     "displacements": {"head": {"z": -1.5}}, "time": {"steps": 1},
                                     "contact": None})
        result = scenes.run(deck)
        self.check_found(result, ["'upper'", "went through", "in one step"])
        # The plate through the block, the longer of the two ways.
        self.assertAlmostEqual(result.summary["audit"]["unseen_overlap"], 1.0, delta=1e-9)

    def test_every(self):
        never = scenes.run(scenes.merged(BLIND, {"audit": {"every": 0}}))
        self.assertEqual(found(never), [])
        self.assertEqual(never.summary["audit"]["overlap"], 0.0)
        last = scenes.run(scenes.merged(BLIND, {"audit": {"every": 7}}))
        self.assertEqual(last.fields.globals(3)["audit_overlap"], 0.0)
        self.assertGreater(last.fields.globals(5)["audit_overlap"], 0.09)

    def test_ranks_agree(self):
        one, two = (scenes.run(BLIND, ranks=ranks) for ranks in (1, 2))
        np.testing.assert_allclose(*([r.summary["audit"][key] for key in ("overlap", "unseen_overlap")]
                                     for r in (one, two)), rtol=1e-8)
        self.assertEqual(found(one), found(two))
        self.assertTrue(found(one))

    def test_the_scene_of_the_inputs(self):
        deck = SHARED / "small_secondary_between_points.yaml"
        if not deck.exists():
            self.skipTest("needs ../shared/inputs")
        result = scenes.run(deck, files=[SHARED / "small_secondary_between_points_mesh.exo"])
        self.check_found(result, ["contact.pair"], 0.1)


if __name__ == "__main__":
    unittest.main()
