# SPDX-License-Identifier: BSD-3-Clause
"""No step of the turned block fails up to f = 1000; and all switchings end in the same place.
usage: turned_block_test.py [unittest arguments] [--formulation WORD] [--spaces WORDS, of multipliers]
"""
import unittest

import numpy

import scenes
import study
import turned_block

KNOWN = study.arguments([])
FORMULATION = KNOWN.formulation or "facet_on_facet"
FACTORS = (1, 10, 100, 1000)
AUGMENTED = {"enforcement": "augmented_lagrangian"}
SPACES = KNOWN.spaces or ["automatic"]


class TurnedBlock(unittest.TestCase):
    def check(self, **options):
        count = turned_block.run({"formulation": FORMULATION, **options}, adaptive=False)
        print(f"{' '.join(map(str, options.values())):40s} solves for each step {count}", flush=True)
        self.assertEqual((count.stopped, count.failed), (0, 0))
        statuses = {int(s) for step in range(1, turned_block.STEPS + 1)
                    for s in numpy.unique(count.result.fields.nodal("contact_status", step))}
        self.assertGreaterEqual(statuses, {1, 2}, "slip and stick")
        return count

    def test_penalty(self):
        for factor in FACTORS:
            with self.subTest(factor=factor):
                self.check(penalty_factor=factor)

    def test_multipliers(self):
        for space in SPACES:
            for factor in FACTORS:
                with self.subTest(space=space, factor=factor):
                    self.check(penalty_factor=factor, multipliers=space, **AUGMENTED)

    def test_switching_does_not_move_the_answer(self):
        # The return map by itself, which may cycle, is the slow obvious way here: springs are so soft that it gets
        # there however the linear solver rounds. On facets it takes 60 to 63 iterations at f = 20 with six kinds of
        # BLAS kernels; at f = 50 it takes 72 to 87 or cycles, by chance. On nodes the same holds for 3 and 5.
        # Each of the 12 steps is solved to 1e-8 of the forces.
        factor = 3 if FORMULATION == "node_on_facet" else 20
        runs = [self.check(penalty_factor=factor, friction_switching=word)
                for word in scenes.words_of("friction_switching")]
        self.assertEqual(len(runs), 2)
        self.assertNotEqual(runs[0].residuals, runs[1].residuals, "the ways there differ")
        ends = [run.result.force("interface") for run in runs]
        difference = numpy.max(numpy.abs(ends[1] - ends[0])) / numpy.linalg.norm(ends[0])
        print(f"  difference of the forces {difference:.1e}")
        self.assertLess(difference, 12 * 1e-8)


if __name__ == "__main__":
    study.main()
