#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""kill -9 at random moments, again and again: no work is lost but the step under way, and the end is the same.

usage: kills_restart_test.py [KILLS [SEED]]

A run that writes a checkpoint after each step is killed, goes on from what it left, is killed again; when it gets
to its end it begins anew, until there were so many kills. What it left must be a whole checkpoint each time, never
one of an earlier step than was reported, and each end is compared with that of the run that nobody killed.
"""
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import chain
import scenes
from contact_restart_test import with_contact

KILLS = int(sys.argv[1]) if len(sys.argv) > 1 else 20
SEED = int(sys.argv[2]) if len(sys.argv) > 2 else random.randrange(10**6)
TOLERANCE = 1e-12
DECK = scenes.merged(with_contact(friction=0.3), {"time": {"end": 1.0, "steps": 40},
                                                  "output": {"checkpoint": {"every": 1}}})


class Kills(chain.Restarted):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "scene.yaml").write_text(json.dumps(DECK))
        self.checkpoint = self.folder / "results" / "scene.checkpoint"
        # What is killed leaves MPI's folder behind, and takes that of others along where it is a common one.
        (self.folder / "mpi").mkdir()
        self.environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
                            "OMPI_MCA_orte_tmpdir_base": str(self.folder / "mpi")}

    def run_for(self, seconds):
        """Steps that were reported, and whether the run came to its end."""
        line = [scenes.EXECUTABLE, "run", str(self.folder / "scene.yaml"), "--output-dir", str(self.folder / "results"),
                "--summary", str(self.folder / "summary.json")]
        if self.checkpoint.exists():
            line += ["--restart", str(self.checkpoint)]
        with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              env=self.environment) as run:
            try:
                said = run.communicate(timeout=seconds)[0]
            except subprocess.TimeoutExpired:
                run.kill()
                said = run.communicate()[0]
        complete = "nothing is left to do" in said  # it was killed behind the very last thing that a run writes
        self.assertTrue(run.returncode in (0, -signal.SIGKILL) or complete, said)
        steps = [int(n) for n in re.findall(r"^step (\d+) ", said, re.M)]
        return max(steps, default=0), run.returncode == 0 or complete

    def kept_step(self):
        return chain.facts(self.checkpoint)["step"] if self.checkpoint.exists() else 0

    def test_kills(self):
        whole = scenes.run(DECK)
        start = scenes.run(scenes.merged(DECK, {"time": {"end": 0.025, "steps": 1}})).seconds
        chance = random.Random(SEED)
        kills = ends = lost = reached = 0
        while kills < KILLS or ends == 0:
            seconds = chance.uniform(0.5 * start, start + 0.5 * (whole.seconds - start)) if kills < KILLS else 60
            reported, at_end = self.run_for(seconds)
            reached = max(reached, reported)
            if at_end:
                last = scenes.Result(pathlib.Path(tempfile.mkdtemp()), None, 0, "", 0)
                last.summary = json.loads((self.folder / "summary.json").read_text())
                last._fields = scenes.Fields(max((self.folder / "results").glob("*.exo*"), key=lambda f: f.stat().st_mtime))
                self.same_end(whole, last, TOLERANCE)
                ends += 1
                shutil.rmtree(self.folder / "results")
                reached = 0
                continue
            kills += 1
            lost += self.kept_step() < reached
            self.assertGreaterEqual(self.kept_step(), reached - 1)
        print(f"seed {SEED}: {kills} kills, {ends} ends the same, {lost} times a reported step was not yet kept")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], warnings="ignore")
