#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""NAME.history.csv has every step once: after restarts, kills, signals, and never in place of something else."""
import json
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import unittest

import numpy

import chain
import history
import scenes
from history import COLUMN, SLIDE


def children(pid):
    """Processes that mpiexec has started, by the kernel's list."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(path.read_text().rsplit(")", 1)[1].split()[1]) == pid:
                found.append(int(path.parent.name))
        except (OSError, ValueError):
            continue
    return sorted(found)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_rows_of_steps_that_are_not_in_the_fields(self):
        run = scenes.run(scenes.merged(COLUMN, {"output": {"every": 3}, "time": {"steps": 4}}))
        table = history.read(history.path_of(run))
        numpy.testing.assert_allclose(table["t"], [0, 0.25, 0.5, 0.75, 1], rtol=0, atol=1e-15)
        numpy.testing.assert_allclose(run.fields.times, [0, 0.75, 1], rtol=0, atol=1e-15)

    def test_none_is_written_where_none_is_wanted(self):
        run = scenes.run(scenes.merged(COLUMN, {"output": {"history": False}}))
        self.assertEqual(list((run.folder / "results").glob("*.history.*")), [])
        self.assertIn("foot_reaction_z", run.fields.globals())

    def test_goes_on_after_restarts(self):
        """Four parts in folders of their own, on one rank and two: the last one has all rows, each once."""
        one = chain.one_piece(SLIDE)
        whole = history.read(history.path_of(one))
        pieces = chain.in_pieces(SLIDE, ranks=(1, 2, 2, 1))
        for piece, stop in zip(pieces, chain.STOPS):
            table = history.read(history.path_of(piece))
            self.assertEqual(len(table["t"]), stop + 1)
            numpy.testing.assert_allclose(table["t"], whole["t"][:stop + 1], rtol=0, atol=1e-15)
            for name, values in whole.items():
                size = max(1e-3, numpy.abs(values).max())
                numpy.testing.assert_allclose(table[name], values[:stop + 1], rtol=0, atol=1e-9 * size, err_msg=name)

    def test_rows_behind_the_checkpoint_are_solved_again_and_stand_once(self):
        deck = scenes.merged(COLUMN, {"time": {"steps": 8}, "output": {"checkpoint": {"every": 3}}})
        first = scenes.run(deck)
        results = first.folder / "results"
        whole = history.path_of(first).read_text()
        # As a run leaves it that was killed in its eighth step, behind the checkpoint of its sixth.
        part = scenes.run(scenes.merged(deck, {"time": {"end": 0.75, "steps": 6}}))
        (results / "scene.checkpoint").unlink()
        shutil.copy(chain.checkpoint(part), results)
        status, output = scenes.execute(
            [scenes.EXECUTABLE, "run", str(first.deck_path), "--quiet", "--output-dir", str(results), "--restart",
             str(results / "scene.checkpoint")], 60)
        self.assertEqual(status, 0, output)
        again, once = history.read(history.path_of(first)), whole.splitlines()
        self.assertEqual(len(again["t"]), len(once) - 1)
        numpy.testing.assert_allclose(again["t"], numpy.arange(9) / 8, rtol=0, atol=1e-15)
        self.assertFalse(list(results.glob("*.unfinished")))

    def started(self, deck, ranks=1):
        """A run in this folder, once its fifth step has been reported."""
        (self.folder / "scene.yaml").write_text(json.dumps(deck))
        launcher = [scenes.MPIEXEC, *scenes.MPIEXEC_FLAGS, "-n", str(ranks)] if ranks > 1 else []
        line = launcher + [scenes.EXECUTABLE, "run", str(self.folder / "scene.yaml"), "--output-dir",
                           str(self.folder), "--summary", str(self.folder / "summary.json")]
        run = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        for text in run.stdout:
            if text.startswith("step 5 "):
                return run
        raise AssertionError(f"ended with {run.wait()}")

    def test_a_killed_run_keeps_its_rows(self):
        with self.started(scenes.merged(COLUMN, {"time": {"steps": 800}})) as run:
            run.kill()
            run.stdout.read()
        rows = (self.folder / "scene.history.csv").read_text().splitlines()
        self.assertGreaterEqual(len(rows), 1 + 1 + 5)
        self.assertEqual(len(history.read(self.folder / "scene.history.csv")["t"]), len(rows) - 1)

    def test_a_signal_leaves_everything_of_the_last_step(self):
        """Told to one rank of two; the same signal twice, as a launcher and its group are told it, is one."""
        deck = scenes.merged(COLUMN, {"time": {"steps": 800}})
        for ranks, number in ((1, signal.SIGINT), (2, signal.SIGTERM)):
            with self.subTest(ranks=ranks), self.started(deck, ranks) as run:
                ids = [run.pid] if ranks == 1 else children(run.pid)
                self.assertEqual(len(ids), ranks)
                for _ in range(2):
                    subprocess.run(["kill", f"-{int(number)}", str(ids[-1])], check=True)
                output = run.stdout.read()
                self.assertEqual(run.wait(60), 5, output)
                summary = json.loads((self.folder / "summary.json").read_text())
                self.assertEqual(summary["status"], "stopped")
                self.assertIn(f"ended by signal {int(number)}", summary["reason"])
                self.assertGreaterEqual(summary["steps"], 5)
                table = history.read(self.folder / "scene.history.csv")
                self.assertEqual((table["t"][-1], table["steps"][-1]), (summary["t"], summary["steps"]))
                fields = scenes.Fields(self.folder / "scene.exo")
                self.assertEqual(fields.times[-1], summary["t"])
                self.assertEqual(fields.globals()["press_force_z"], table["press_force_z"][-1])
                self.assertRegex(output, r"stopped at t = [\d.]+ of 1: ended by signal")

    def test_what_is_no_history_is_not_overwritten(self):
        (self.folder / "scene.yaml").write_text(json.dumps(COLUMN))
        line = [scenes.EXECUTABLE, "run", str(self.folder / "scene.yaml"), "--quiet", "--output-dir", str(self.folder)]
        for name, other in (("scene.history.csv", "year,king\n1066,William\n"), ("scene.history.json", "{}\n")):
            (self.folder / name).write_text(other)
            status, output = scenes.execute(line, 60)
            self.assertEqual(status, 2, output)
            self.assertRegex(output, f"the history would overwrite '.*{re.escape(name)}', which is a file of another "
                                     "kind; give another --output-dir, ")
            self.assertEqual((self.folder / name).read_text(), other)
            (self.folder / name).unlink()
        for _ in range(2):  # its own is
            status, output = scenes.execute(line, 60)
            self.assertEqual(status, 0, output)

    def test_a_full_disk_is_told(self):
        """The table is written to a device that takes nothing."""
        (self.folder / "scene.yaml").write_text(json.dumps(COLUMN))
        (self.folder / "scene.history.csv").symlink_to("/dev/full")
        status, output = scenes.execute([scenes.EXECUTABLE, "run", str(self.folder / "scene.yaml"), "--quiet",
                                         "--output-dir", str(self.folder)], 60)
        self.assertEqual(status, 2, output)
        self.assertIn("cannot write '", output)
        self.assertIn("scene.history.csv'", output)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
