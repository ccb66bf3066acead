#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that stop early, cut their steps or start without any force, and what they leave behind."""
import re
import shlex
import unittest

import numpy as np
import scenes

BLOCKS = {
    "mesh": {"generate": {"kind": "blocks", "lower_size": [2, 2, 1], "lower_divisions": [5, 5, 2],
                          "upper_divisions": [3, 3, 2]}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 4.0, "poisson": 0.2}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "stiff"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "top": {"set": "upper_top", "x": 0.0, "y": 0.0, "z": -0.6}},
    "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top"}},
    "newton": {"tolerance": 1e-10},
}

# The blocks are two high together: beyond t = 0.8 nothing of them would be left.
IMPOSSIBLE = scenes.merged(BLOCKS, {"displacements": {"top": {"z": -2.5}},
                                    "time": {"steps": 10, "max_cuts": 2}})


class StopsEarly(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ = scenes.run(IMPOSSIBLE, quiet=False, check=False)

    def test_status_and_sentence(self):
        self.assertEqual(self.run_.status, 1, self.run_.output)
        said = re.findall(r"^abut: (.*)$", self.run_.output, re.MULTILINE)
        self.assertEqual(len(said), 1, self.run_.output)
        self.assertRegex(said[0], r"^stopped at t = [0-9.e-]+ of 1: No step beyond t = [0-9.e-]+ "
                         r"converged \(2 cuts, down to a step of [0-9.e-]+\): "
                         r"([Ee]lement \d+ of block '\w+' is inverted: det F = -|Newton "
                         r"|contact\.pair: \d+ points lie at the centre of curvature ).*")

    def test_every_converged_step_is_readable(self):
        steps = [float(t) for t in re.findall(r"^step +\d+  t = ([0-9.e-]+)", self.run_.output,
                                              re.MULTILINE)]
        self.assertGreaterEqual(len(steps), 2)
        self.assertLess(steps[-1], 0.8)
        fields = self.run_.fields
        np.testing.assert_allclose(fields.times, [0.0] + steps, rtol=1e-5)
        top = fields.node_set("upper_top")
        for i, t in enumerate(fields.times):
            self.assertTrue(np.isfinite(fields.vector("displacement", i)).all())
            np.testing.assert_allclose(fields.nodal("displacement_z", i)[top], -2.5 * t, atol=1e-12)
        self.assertGreater(fields.nodal("contact_pressure").max(), 0.1)

    def test_summary(self):
        summary = self.run_.summary
        self.assertEqual(summary["status"], "stopped")
        self.assertEqual(summary["steps"], len(self.run_.fields.times) - 1)
        self.assertGreaterEqual(summary["cut_backs"], 2)
        self.assertGreater(self.run_.contact()["active_points"], 0)

    def test_quiet_still_says_why(self):
        run = scenes.run(IMPOSSIBLE, check=False)
        self.assertEqual(run.status, 1)
        self.assertTrue(run.output.startswith("abut: stopped at t = "), run.output)

    def test_without_cuts(self):
        run = scenes.run(scenes.merged(IMPOSSIBLE, {"time": {"adaptive": False}}), check=False)
        self.assertEqual(run.status, 1)
        self.assertEqual(run.summary["cut_backs"], 0)
        self.assertEqual(run.summary["steps"], len(run.fields.times) - 1)
        self.assertRegex(run.output, r"\(0 cuts, ")


class CutsBack(unittest.TestCase):
    def compare(self, changes, tolerance):
        big = scenes.run(scenes.merged(BLOCKS, changes))
        small = scenes.run(scenes.merged(scenes.merged(BLOCKS, changes), {"time": {"steps": 32}}))
        self.assertGreaterEqual(big.summary["cut_backs"], 1)
        self.assertEqual(small.summary["cut_backs"], 0)
        self.assertEqual(big.fields.times[-1], 1.0)
        u, v = big.fields.vector("displacement"), small.fields.vector("displacement")
        difference = np.abs(u - v).max() / np.abs(v).max()
        print(f"{self.id().split('.')[-1]}: {big.summary['cut_backs']} cut-backs, "
              f"{big.summary['steps']} steps, difference {difference:.1e}")
        self.assertLess(difference, tolerance)
        np.testing.assert_allclose(big.force(), small.force(), rtol=0,
                                   atol=tolerance * np.abs(small.force()).max())
        self.assertGreater(small.contact()["active_points"], 0)

    def test_end_does_not_depend_on_the_steps(self):
        # Four iterations do not suffice for the whole way at once.
        self.compare({"time": {"steps": 1},
                      "newton": {"max_iterations": 4}}, 1e-8)


class FreeApproach(unittest.TestCase):
    """A body that moves without strain until it touches has no forces to compare residuals with."""

    def test_moves_before_it_touches(self):
        deck = scenes.merged(BLOCKS, {
            "mesh": {"generate": {"gap": 0.1}}, "time": {"steps": 5},
            "displacements": {"top": {"x": 0.013, "y": 0.0071, "z": -0.15}}})
        run = scenes.run(deck)
        self.assertEqual(run.summary["cut_backs"], 0)
        self.assertEqual(run.summary["steps"], 5)
        self.assertGreater(run.contact()["active_points"], 0)
        fields = run.fields
        self.assertEqual(fields.nodal("contact_pressure", 3).max(), 0.0)
        upper = np.unique(fields.connectivity("upper"))
        np.testing.assert_allclose(fields.vector("displacement", 3)[upper],
                                   0.6 * np.array([[0.013, 0.0071, -0.15]] * len(upper)),
                                   rtol=0, atol=1e-14)


class Prints(unittest.TestCase):
    def printed(self, *arguments):
        """Bytes of standard output and of standard error, both sent to files."""
        run = scenes.run(BLOCKS)  # leaves the deck in a folder
        line = scenes._launcher(scenes.RANKS) + [scenes.EXECUTABLE, "run", str(run.deck_path),
                                                 *arguments]
        status, _ = scenes.execute(
            ["sh", "-c", " ".join(map(shlex.quote, line)) + " >out 2>err </dev/null"], 60,
            run.folder)
        self.assertEqual(status, 0)
        return (run.folder / "out").read_bytes(), (run.folder / "err").read_bytes()

    def test_quiet_prints_nothing(self):
        self.assertEqual(self.printed("--quiet"), (b"", b""))

    def test_plain_lines_in_a_file(self):
        out, err = self.printed()
        self.assertEqual(err, b"")
        self.assertNotIn(b"\r", out)
        self.assertNotIn(b"\x1b", out)
        lines = out.decode().splitlines()
        self.assertTrue(any(re.match(r"step 1  t = 1  \d+ iterations", line) for line in lines))
        self.assertTrue(any(re.match(r"  step 1 .*newton +1  residual", line) for line in lines))
        self.assertTrue(lines[-1].startswith("converged: 1 steps"), lines[-1])


if __name__ == "__main__":
    unittest.main(warnings="ignore")
