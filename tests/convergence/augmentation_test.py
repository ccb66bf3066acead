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

    def test_partly_covered_primary(self):
        """Corners with little cover hand their functions on: no multiplier is left that closes nothing."""
        for space in SPACES:
            with self.subTest(space=space):
                count = self.count("block", multipliers=space, **AUGMENTED)
                self.assertLess(count.gap, GAP)
                self.assertLessEqual(max(count.augmentations), 6)

    def test_end_of_step(self):
        """One update at the end of each step costs no solve, and closes most of the gap that penalty leaves."""
        for space in SPACES:
            with self.subTest(space=space):
                penalty = self.count("block", multipliers=space)
                carried = self.count("block", multipliers=space, enforcement="augmented_lagrangian",
                                     uzawa="end_of_step")
                self.assertEqual(sum(carried.augmentations), 0)
                self.assertLessEqual(max(carried.newton), 3)
                self.assertLessEqual(carried.solves - penalty.solves, 2)
                self.assertGreater(penalty.gap, 3e-3)
                self.assertLess(carried.gap, 1e-3)


class Accelerated(unittest.TestCase):
    """f = 1, where a plain augmentation leaves half of the gap."""

    def check(self, scene, space):
        plain, accelerated = (
            augmentation_counts.Count(scene, penalty_factor=1, **study.contact(
                KNOWN, multipliers=space, augmentation=rule, **{**AUGMENTED, "multiplier_tolerance": 1e-4}))
            for rule in ("plain", "anderson"))
        for label, count in (("plain", plain), ("anderson", accelerated)):
            print(f"{scene} {space} f=1 {label:24s}{count}", flush=True)
        a, b = (count.summary["contact"]["pair"] for count in (plain, accelerated))
        self.assertGreater(a["active_points"], 0)
        self.assertEqual(a["active_points"], b["active_points"])
        self.assertAlmostEqual(a["force"][2] / b["force"][2], 1, delta=2e-4)
        self.assertAlmostEqual(a["max_pressure"] / b["max_pressure"], 1, delta=2e-3)
        self.assertLess(accelerated.gap, GAP)
        self.assertLess(sum(accelerated.augmentations), 0.8 * sum(plain.augmentations))

    def test_paraboloid(self):
        for space in SPACES:
            with self.subTest(space=space):
                self.check("paraboloid", space)

    def test_block_on_block(self):
        for space in SPACES:
            with self.subTest(space=space):
                self.check("covered_block", space)

    def test_not_with_friction(self):
        friction = {"penalty_factor": 10, "friction": 0.3, "multipliers": "dual",
                    "enforcement": "augmented_lagrangian", "gap_tolerance": 1e-4}
        plain, asked = (augmentation_counts.Count("covered_block", augmentation=rule, **friction)
                        for rule in ("plain", "anderson"))
        self.assertGreater(sum(plain.augmentations), 0)
        self.assertEqual(plain.solves, asked.solves)
        self.assertAlmostEqual(plain.penetration / asked.penetration, 1, delta=1e-9)


if __name__ == "__main__":
    study.main()
