# SPDX-License-Identifier: BSD-3-Clause
"""What multipliers cost over penalty alone, down to a weighted gap of 1e-4 face sizes that is measured here.
usage: augmentation_test.py [unittest arguments] [--formulation WORD] [--spaces WORDS, of multipliers]
"""
import unittest

import augmentation_counts
import scenes
import study

KNOWN = study.arguments([])
SPACES = KNOWN.spaces or [word for word in scenes.words_of("multipliers") if word != "per_point"]
GAP = 1e-4
AUGMENTED = {"enforcement": "augmented_lagrangian", "multiplier_tolerance": 1e6, "gap_tolerance": GAP,
             "max_augmentations": 50}


class Augmentations(unittest.TestCase):
    def count(self, scene, **options):
        count = augmentation_counts.Count(scene, penalty_factor=30, **study.contact(KNOWN, **options))
        label = f"{scene} {options['multipliers']} {options.get('enforcement', 'penalty')}"
        print(f"{label:50s}{count}", flush=True)
        self.assertGreater(count.summary["contact"]["pair"]["active_points"], 0)
        return count

    def test_cold_start(self):
        for space in SPACES:
            with self.subTest(space=space):
                penalty = self.count("paraboloid", multipliers=space)
                multipliers = self.count("paraboloid", multipliers=space, **AUGMENTED)
                self.assertGreater(penalty.gap, 2 * GAP)  # else there was nothing to do
                self.assertLess(multipliers.gap, GAP)
                self.assertLessEqual(multipliers.solves - penalty.solves, 6)

    def test_load_steps(self):
        """Multipliers come along: a step costs as many augmentations as the first one or fewer."""
        for space in SPACES:
            with self.subTest(space=space):
                penalty = self.count("covered_block", multipliers=space)
                multipliers = self.count("covered_block", multipliers=space, **AUGMENTED)
                self.assertGreater(penalty.gap, 2 * GAP)
                self.assertLess(multipliers.gap, GAP)
                extra = multipliers.solves - penalty.solves
                print(f"  {extra / 5:.1f} solves more for each step")
                self.assertLessEqual(extra, 5 * 6)


if __name__ == "__main__":
    study.main()
