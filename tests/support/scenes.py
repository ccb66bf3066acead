# SPDX-License-Identifier: BSD-3-Clause
"""Runs of the program for tests: a deck in, a summary and fields out.

    result = scenes.run(deck)                     # dict, text or path of a deck
    result.summary["contact"]["pair"]["force"]    # what the run reported
    result.fields.nodal("displacement_z")         # Exodus variable of the last step

ctest passes the program and the launcher in ABUT_EXECUTABLE, ABUT_MPIEXEC, ABUT_MPIEXEC_FLAGS and
the rank count of the test in ABUT_TEST_RANKS.
"""
import copy
import glob
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time
import weakref

import numpy

import process

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "apps" / "python"))
from abut.exodus import ExodusFile as Fields

EXECUTABLE = os.environ.get("ABUT_EXECUTABLE") or shutil.which("abut") or "abut"
MPIEXEC = os.environ.get("ABUT_MPIEXEC", "mpiexec")
MPIEXEC_FLAGS = os.environ.get("ABUT_MPIEXEC_FLAGS", "--oversubscribe").split()
RANKS = int(os.environ.get("ABUT_TEST_RANKS", "1"))

_ENVIRONMENT = {
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_btl_base_warn_component_unused": "0",
}


class Result:
    """What one run left behind. The folder lives as long as this object."""

    def __init__(self, folder, deck_path, status, output, seconds):
        self.folder = folder
        weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)
        self.deck_path = deck_path
        self.status = status      # exit status; None when the time limit was reached
        self.output = output      # standard output and error together
        self.seconds = seconds
        summary = self.folder / "summary.json"
        self.summary = json.loads(summary.read_text()) if summary.exists() else None
        self._fields = None

    @property
    def result_files(self):
        """One Exodus file, or one for each rank."""
        return sorted(glob.glob(str(self.folder / "results" / "*.exo*")))

    @property
    def fields(self):
        if self._fields is None:
            self._fields = Fields(self.result_files[0])
        return self._fields

    def contact(self, name="pair"):
        return self.summary["contact"][name]

    def force(self, name="pair"):
        """Contact force on the primary surface, 3 numbers."""
        return numpy.array(self.contact(name)["force"])

    def quantity(self, name):
        """Value of a verify entry."""
        return next(v["value"] for v in self.summary["verify"] if v["name"] == name)

    def newton_residuals(self):
        """{(step, augmentation): [residuals]} of the progress lines; a repeated step appears once,
        its last attempt. Needs quiet=False."""
        pattern = r"step\s+(\d+)\s+augmentation\s+(\d+)\s+newton\s+(\d+)\s+residual\s+(\S+)"
        tails = {}
        for step, augmentation, iteration, residual in re.findall(pattern, self.output):
            key = (int(step), int(augmentation))
            if int(iteration) == 0:
                tails[key] = []
            tails.setdefault(key, []).append(float(residual))
        return tails


class RunFailed(AssertionError):
    """A run that should have converged did not."""


def run(deck, ranks=None, seconds=60, quiet=True, arguments=(), files=(), check=True,
        command="run"):
    """Runs `abut run` in a fresh folder.

    deck: dict (written as JSON, which is YAML), text, or a path whose folder is copied from.
    files: paths copied beside the deck. ranks: of the test unless given; 1 runs without launcher.
    check: raise RunFailed unless the exit status is 0.
    """
    path = pathlib.Path(tempfile.mkdtemp(prefix="abut_scene_"))
    deck_path = _place_deck(deck, path)
    for file in files:
        shutil.copy(file, path)
    line = _launcher(ranks or RANKS) + [EXECUTABLE, command, str(deck_path)]
    if command == "run":
        line += ["--summary", str(path / "summary.json"), "--output-dir", str(path / "results")]
        line += ["--quiet"] if quiet else []
    start = time.monotonic()
    status, output = execute(line + list(arguments), seconds, path)
    result = Result(path, deck_path, status, output, time.monotonic() - start)
    if check and status != 0:
        raise RunFailed(f"{' '.join(line)}: status {status}\n{output}")
    return result


def execute(line, seconds, folder=None):
    """Exit status (None after too long; every process is ended then) and all that was printed."""
    return process.execute(line, seconds, folder, _ENVIRONMENT)


def mesh(path, kind, **options):
    """Writes a mesh with `abut mesh`; options as in `generate:` (lists become comma lists)."""
    line = [EXECUTABLE, "mesh", kind, "-o", str(path)]
    for key, value in options.items():
        value = ",".join(map(str, value)) if isinstance(value, (list, tuple)) else value
        value = str(value).lower() if isinstance(value, bool) else value
        line.append(f"--{key}={value}")
    status, output = execute(line, 60)
    if status != 0:
        raise RunFailed(f"{' '.join(line)}: status {status}\n{output}")
    return path


def merged(deck, changes):
    """A copy of a deck with the nested values of `changes` put in; None removes a key."""
    out = copy.deepcopy(deck)
    for key, value in changes.items():
        if value is None:
            out.pop(key, None)
        elif isinstance(value, dict) and isinstance(out.get(key), dict):
            out[key] = merged(out[key], value)
        else:
            out[key] = copy.deepcopy(value)
    return out


def probe(quantity, place=None, point=None):
    """A verify entry that only asks for a value: nothing fails it."""
    entry = {"quantity": quantity, "expected": 0.0, "tolerance": 1e300}
    if place is not None:
        entry["place"] = place
    if point is not None:
        entry["point"] = list(point)
    return entry


def words_of(key):
    """Words that the program knows for a key of decks, but for `automatic`."""
    status, text = execute([EXECUTABLE, "schema", "--markdown"], 60)
    assert status == 0, text
    row = re.search(rf"^\| `{key}` \| word \|.*$", text, re.M)
    return [w for w in re.findall(r"<br>`(\w+)`", row.group()) if w != "automatic"] if row else []


def settings(pairs):
    """Options written KEY=VALUE; what reads as JSON is taken as such."""
    options = {}
    for key, value in (pair.split("=", 1) for pair in pairs):
        try:
            options[key] = json.loads(value)
        except ValueError:
            options[key] = value
    return options


def _launcher(ranks):
    return [MPIEXEC, *MPIEXEC_FLAGS, "-n", str(ranks)] if ranks > 1 else []


def _place_deck(deck, folder):
    if isinstance(deck, dict):
        path = folder / "scene.yaml"
        path.write_text(json.dumps(deck, indent=1) + "\n")
    elif isinstance(deck, pathlib.PurePath) or "\n" not in deck:
        path = pathlib.Path(shutil.copy(deck, folder))
    else:
        path = folder / "scene.yaml"
        path.write_text(deck)
    return path

