# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark script on tiny meshes: every scene runs, all fields are there. No time is judged."""
import contextlib
import io
import json
import math
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import bench
import bench_scenes
import scenes


def bench_run(*arguments):
    """What the script prints, and the record that it leaves of each scene."""
    with tempfile.TemporaryDirectory() as folder:
        line = ["bench.py", "--abut", scenes.EXECUTABLE, "--output", folder, "--runs", "1", "--size", "0.1", *arguments]
        printed = io.StringIO()
        with mock.patch.object(sys, "argv", line), contextlib.redirect_stdout(printed):
            bench.main()
        return printed.getvalue(), json.loads((pathlib.Path(folder) / "scenes.json").read_text())


class Bench(unittest.TestCase):
    def test_every_scene(self):
        printed, records = bench_run()
        self.assertEqual(set(records), set(bench_scenes.SCENES))
        for name, record in records.items():
            with self.subTest(name):
                ((run,),) = record["programs"]
                self.assertGreater(run["counts"]["linear_iterations"], 0)
                self.assertGreater(run["active_points"], 0)
                self.assertEqual(set(run["seconds"]), set(bench.ROWS))
                self.assertTrue(all(math.isfinite(t) and t >= 0 for t in run["seconds"].values()))
                self.assertGreater(run["seconds"]["search"], 0)
                self.assertLess(run["seconds"]["search + contact"], run["seconds"]["program"])
                self.assertIn(name, printed)

    def test_against_another_program(self):
        printed, records = bench_run("--scenes", "facet_friction", "--against", scenes.EXECUTABLE)
        record = records["facet_friction"]
        self.assertEqual([len(runs) for runs in record["programs"]], [1, 1])
        self.assertTrue(record["same_counts"])
        first, second = (runs[0]["seconds"]["contact"] for runs in record["programs"])
        self.assertAlmostEqual(record["ratios"]["contact"]["of_least"], first / second)
        self.assertIn("ratio", printed)


class Ratios(unittest.TestCase):
    """On times that are given."""

    def comparison(self, first, second):
        def program(seconds, iterations):
            return [mock.Mock(seconds={row: t for row in bench.ROWS}, counts={"linear_iterations": iterations})
                    for t in seconds]
        made = bench.Comparison({}, [], 0, 0, 1)
        made.runs = [program(*first), program(*second)]
        return made

    def test_least_and_median(self):
        made = self.comparison(([2.0, 3.0, 9.0], 10), ([1.0, 4.0, 6.0], 10))
        self.assertEqual(made.ratio("search"), 2.0)
        self.assertEqual(made.ratio("search", bench.statistics.median), 0.75)

    def test_other_numbers_of_iterations(self):
        made = self.comparison(([2.0], 20), ([1.0], 10))
        self.assertFalse(made.same_counts)
        self.assertEqual(made.ratio("contact"), 1.0)


if __name__ == "__main__":
    unittest.main()
