# SPDX-License-Identifier: BSD-3-Clause
"""Augmentations that bring little: the run says so once a step, and names the cause."""
import unittest

import augmentation_counts
import scenes

AUGMENTED = {"enforcement": "augmented_lagrangian", "multiplier_tolerance": 1e-3, "gap_tolerance": 1e-5,
             "penalty_factor": 10, "max_augmentations": 10}


class Plateau(unittest.TestCase):
    def warnings(self, deck):
        result = scenes.run(scenes.merged(deck, {"time": {"steps": 2}}), quiet=False)
        self.assertGreater(result.contact()["active_points"], 0)
        found = [line for line in result.output.splitlines() if "augmentations bring little" in line]
        print(self.id().split(".")[-1], *found[:1], sep="\n  ", flush=True)
        return found

    def check(self, deck, words):
        found = self.warnings(deck)
        self.assertIn(len(found), (1, 2), "once a step at most")
        for line in found:
            self.assertIn("pair:", line)
            self.assertIn(words, line)

    def test_stiff_and_fine_primary(self):
        for space in ("dual", "smoothed"):
            with self.subTest(space=space):
                self.check(augmentation_counts.block_on_block(lower=3, upper=6, upper_primary=True, moduli=(1, 100),
                                                              multipliers=space, **AUGMENTED),
                           "swap primary and secondary")

    def test_prescribed_nodes(self):
        """Both surfaces are held where they overlap: no multiplier parts them."""
        for space in ("per_point", "smoothed", "dual"):
            with self.subTest(space=space):
                deck = augmentation_counts.block_on_block(lower=4, upper=3, multipliers=space, **AUGMENTED)
                deck["displacements"]["lower"] = {"set": "lower_top", "fix": ["x", "y", "z"]}
                deck["displacements"]["upper"] = {"set": "upper_bottom", "z": -0.01}
                deck["displacements"]["top"]["z"] = -0.01
                self.check(deck, "prescribed")

    def test_partly_covered(self):
        deck = augmentation_counts.block_on_block(lower=7, upper=5, multipliers="per_point", **AUGMENTED)
        self.check(deck, "covered only in part")

    def test_points_one_by_one(self):
        deck = augmentation_counts.block_on_block(upper_primary=True, moduli=(4, 1), multipliers="per_point", **AUGMENTED)
        self.check(deck, "multipliers: dual")

    def test_none_where_it_goes_well(self):
        deck = augmentation_counts.block_on_block(upper_primary=True, moduli=(4, 1), multipliers="dual", **AUGMENTED)
        self.assertEqual(self.warnings(deck), [])


if __name__ == "__main__":
    unittest.main()
