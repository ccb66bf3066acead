#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is written never costs a deck, a mesh, another run's results; faults of the machine have a status of
their own; help and unknown words."""
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
import unittest

import netCDF4
import numpy as np
import scenes
from words_test import BLOCKS

LONG = scenes.merged(BLOCKS, {"time": {"steps": 100000}, "output": {"every": 50000}})


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="abut_files_")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.place("scene.yaml", BLOCKS)

    def place(self, name, deck):
        (self.path / name).write_text(json.dumps(deck))

    def call(self, *words):
        return scenes.execute([scenes.EXECUTABLE, *words], 60, self.path)

    def refused(self, message, *words, kept=None):
        before = (self.path / kept).read_bytes() if kept else b""
        status, output = self.call(*words)
        self.assertEqual(status, 2, output)
        self.assertRegex(output, r"(?m)^abut: " + message)
        if kept:
            self.assertEqual((self.path / kept).read_bytes(), before)


class Overwrites(Case):
    def test_summaries(self):
        scenes.mesh(self.path / "mesh.exo", "box")
        self.assertEqual(self.call("run", "scene.yaml", "--summary", "s.json", "--quiet"), (0, ""))
        self.assertEqual(self.call("run", "scene.yaml", "--summary", "s.json", "--quiet"), (0, ""))
        self.assertEqual(json.loads((self.path / "s.json").read_text())["status"], "converged")
        for file, what in (("scene.yaml", "a file of another kind"), ("mesh.exo", "a mesh"),
                           ("scene.exo", "results of a run")):
            self.refused(f"the summary would overwrite '{file}', which is {what}; ",
                         "run", "scene.yaml", "--summary", file, kept=file)

    def test_a_summary_is_tried_before_the_solve(self):
        for file, why in (("nodir/s.json", "No such file or directory"), (".", "it is a folder")):
            self.refused(f"cannot write the summary '{file}': {why}$", "run", "scene.yaml", "--summary", file)
            self.assertFalse((self.path / "scene.exo").exists())

    def test_meshes(self):
        self.assertEqual(self.call("run", "scene.yaml", "--quiet"), (0, ""))
        for _ in range(2):
            scenes.mesh(self.path / "mesh.exo", "box")
        self.refused("the mesh would overwrite 'scene.yaml', which is a file of another kind; ",
                     "mesh", "box", "-o", "scene.yaml", kept="scene.yaml")
        self.refused("the mesh would overwrite 'scene.exo', which is results of a run; ",
                     "mesh", "box", "-o", "scene.exo", kept="scene.exo")

    def test_results(self):
        scenes.mesh(self.path / "scene.exo", "box")
        self.refused("the results would overwrite './scene.exo', which is a mesh; ", "run", "scene.yaml",
                     kept="scene.exo")
        (self.path / "scene.exo").write_text("a letter")
        self.refused("the results would overwrite './scene.exo', which is a file of another kind; ", "run",
                     "scene.yaml", kept="scene.exo")

    def test_what_a_killed_run_left_is_results(self):
        self.call("run", "scene.yaml")
        whole = (self.path / "scene.exo").read_bytes()
        (self.path / "scene.exo").write_bytes(whole[:len(whole) // 2])
        self.assertEqual(self.call("run", "scene.yaml", "--quiet"), (0, ""))
        self.assertEqual((self.path / "scene.exo").read_bytes()[:4], whole[:4])


class TwoRuns(Case):
    def start(self, ranks=1):
        """A run that is on its way."""
        self.place("long.yaml", LONG)
        run = subprocess.Popen(scenes._launcher(ranks) + [scenes.EXECUTABLE, "run", "long.yaml", "--summary",
                                                          "long.json"], cwd=self.path,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               env={**os.environ, **scenes._ENVIRONMENT})
        self.addCleanup(run.stdout.close)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        for line in run.stdout:
            if line.startswith("step 3 "):
                break
        return run

    def test_the_second_is_refused_while_the_first_lives(self):
        first = self.start()
        self.refused(rf"another run \(process {first.pid} on .+\) is writing './long.exo'; ", "run", "long.yaml")
        first.kill()
        first.wait()
        self.assertTrue((self.path / "long.exo.lock").exists())  # stale: no obstacle
        self.place("long.yaml", BLOCKS)
        self.assertEqual(self.call("run", "long.yaml", "--quiet", "--summary", "long.json"), (0, ""))
        self.assertEqual(list(self.path.glob("*.lock")), [])

    def test_signals_end_a_run_in_order(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            run = self.start()
            run.send_signal(number)
            output = run.stdout.read()
            self.assertEqual(run.wait(60), 5, output)
            self.assertIn("\nEverything up to there is in ./long.exo\n", output)
            self.assertRegex(output, rf"(?m)^abut: stopped at t = \S+ of 1: ended by signal {int(number)} \(\w+\)$")
            summary = json.loads((self.path / "long.json").read_text())
            self.assertEqual(summary["status"], "stopped")
            self.assertRegex(summary["reason"], "ended by signal")
            with netCDF4.Dataset(self.path / "long.exo") as results:
                np.testing.assert_allclose(results["time_whole"][:], [0, summary["steps"] / 100000], rtol=1e-9)
            self.assertGreaterEqual(summary["steps"], 3)
            self.assertEqual(list(self.path.glob("*.lock")), [])

    def test_a_signal_to_one_rank_ends_all(self):
        run = self.start(ranks=2)
        process = (self.path / "long.exo.lock").read_text().split()[1]
        os.kill(int(process), signal.SIGTERM)
        output = run.stdout.read()
        self.assertEqual(run.wait(60), 5, output)
        self.assertEqual(len(re.findall("^abut: ", output, re.M)), 1, output)
        self.assertEqual(json.loads((self.path / "long.json").read_text())["status"], "stopped")

    def test_one_summary(self):
        self.start()
        self.refused(r"another run \(process \d+ on .+\) is writing 'long.json'; ", "run", "scene.yaml", "--summary",
                     "long.json")


class MachineFaults(Case):
    def limited(self, limit, size, *words):
        def prepare():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(limit, (size, size))
        run = subprocess.run([scenes.EXECUTABLE, *words], cwd=self.path, preexec_fn=prepare, text=True, timeout=120,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return run.returncode, run.stdout

    def test_disk_full(self):
        self.place("long.yaml", scenes.merged(BLOCKS, {"time": {"steps": 20}}))
        status, output = self.limited(resource.RLIMIT_FSIZE, 60000, "run", "long.yaml", "--summary", "s.json")
        self.assertEqual(status, 5, output)
        self.assertRegex(output, r"(?m)^abut: stopped at t = \S+ of 1: file './long.exo': cannot write .*File too large")
        self.assertIn("\nWhat could be written is in ./long.exo\n", output)
        summary = json.loads((self.path / "s.json").read_text())
        self.assertEqual(summary["status"], "stopped")
        self.assertGreater(summary["steps"], 0)

    def test_disk_full_for_the_summary(self):
        status, output = self.call("run", "scene.yaml", "--summary", "/dev/full")
        self.assertEqual(status, 5, output)
        self.assertRegex(output, "\nconverged: .*\nabut: cannot write the summary '/dev/full': is the disk full\\?\n$")

    def test_memory(self):
        status, output = self.limited(resource.RLIMIT_AS, 1 << 30, "mesh", "box", "--divisions", "250,250,250",
                                      "-o", "mesh.exo")
        self.assertEqual(status, 5, output)
        self.assertRegex(output, r"^abut: the memory of this machine does not suffice")

    def test_memory_of_a_solve(self):
        """Whoever meets it, reader, kernels or a library."""
        self.place("large.yaml", scenes.merged(BLOCKS, {
            "mesh": {"generate": {"lower_divisions": [24, 24, 24], "upper_divisions": [24, 24, 24]}},
            "linear_solver": {"method": "krylov"}, "time": {"adaptive": False}}))
        status, output = self.limited(resource.RLIMIT_AS, 500 << 20, "run", "large.yaml", "--quiet")
        self.assertEqual(status, 5, output)
        self.assertIn("the memory of this machine does not suffice", output)


class Help(Case):
    def test_version(self):
        status, output = self.call("--version")
        self.assertEqual(status, 0)
        self.assertRegex(output, r"^abut \d+\.\d+\.\d+\n$")

    def test_help(self):
        self.assertEqual(self.call("help"), self.call("--help"))
        for command in ("run", "check", "mesh", "report", "schema", "import"):
            status, output = self.call("help", command)
            self.assertEqual((status, output), self.call(command, "--help"))
            self.assertIn(command, output)

    def test_unknown_words(self):
        commands = "valid: run, check, import, mesh, report, schema, help"
        self.refused(f"there is no command 'rnu'; {commands}; did you mean 'run'\\?$", "rnu", "scene.yaml")
        self.refused(f"there is no command 'schem'; {commands}; did you mean 'schema'\\?$", "help", "schem")
        self.refused(r"'abut run' has no option '--sumary'; valid: .*; did you mean '--summary'\?$", "run", "scene.yaml",
                     "--sumary", "s.json")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
