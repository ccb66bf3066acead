# SPDX-License-Identifier: BSD-3-Clause
"""A stiff block is pressed into a softer one by more than an element of it in one step.
usage: deep_punch_test.py [unittest arguments]

Its edges make a valley of the surface below, whose faces have normals apart. A point of the punch that passes behind the
bottom of the valley is closest to the edge there and to no face. When only faces and a margin beside them were partners,
normals jumped, corners lost their contact, and Newton took 31 iterations from touch or a cut step; on finer meshes it
did not arrive."""
import unittest

import block_on_block
import scenes


def pressed(lower, upper, depth, steps):
    deck = scenes.merged(block_on_block.deck(lower, upper, depth, steps), {"newton": {"displacement_tolerance": 1e-5}})
    return scenes.run(deck, seconds=120).summary


class DeepPunch(unittest.TestCase):
    def check(self, lower, upper, depth, most):
        summary = pressed(lower, upper, depth, 1)
        self.assertEqual(summary["cut_backs"], 0)
        self.assertLessEqual(summary["newton_iterations"], most)
        pair = summary["contact"]["pair"]
        # Some points of the second row stand off: the edges carry what they do not.
        self.assertGreater(pair["active_points"], 0.95 * 4 * upper**2)
        self.assertLess(pair["max_penetration_over_face_size"], 0.15)
        return pair["force"][2]

    def test_in_one_step(self):
        force = self.check(14, 11, 0.12, 12)
        steps = pressed(14, 11, 0.12, 4)["contact"]["pair"]["force"][2]
        self.assertAlmostEqual(force / steps, 1.0, delta=1e-5)  # bodies are elastic: the way does not matter

    def test_on_another_mesh(self):
        self.check(12, 10, 0.12, 15)


if __name__ == "__main__":
    unittest.main()
