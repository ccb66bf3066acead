#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Files of checkpoints: refused with a reason before anything is solved, never half written, where results go."""
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import struct
import subprocess
import tempfile
import unittest

import numpy

import chain
import scenes
from contact_restart_test import with_contact

DECK = scenes.merged(with_contact(friction=0.3), {"time": {"end": 0.5, "steps": 4},
                                                  "output": {"checkpoint": {"every": 1}}})
LONGER = {"time": {"end": 1.0, "steps": 8}}


def checksum(data):
    """FNV-1a of 64 bits."""
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 % 2**64
    return value


def sealed(content):
    """A file that is whole, whatever it says."""
    line = b"abut checkpoint %4d %20d\n" % (1, len(content) + 8)
    content = line + content[len(line):]
    return content + struct.pack("<Q", checksum(content))


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.first = scenes.run(DECK)
        cls.bytes = chain.checkpoint(cls.first).read_bytes()

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def restarted(self, content, changes=None, **options):
        file = self.folder / "state.checkpoint"
        file.write_bytes(content)
        return scenes.run(scenes.merged(scenes.merged(DECK, LONGER), changes or {}),
                          arguments=["--restart", str(file)], check=False, **options)

    def refused(self, content, reason, changes=None, **options):
        result = self.restarted(content, changes, **options)
        self.assertEqual(result.status, 2, result.output)
        self.assertRegex(result.output, f"checkpoint '.*state.checkpoint': {reason}")
        self.assertEqual(result.result_files, [])
        self.assertIsNone(result.summary)

    def test_what_is_no_whole_checkpoint(self):
        whole, middle = self.bytes, len(self.bytes) // 2
        flipped = bytearray(whole)
        flipped[middle] ^= 1
        self.refused(b"", "it is not a checkpoint of abut")
        self.refused(b"title: a deck\n", "it is not a checkpoint of abut")
        self.refused(whole[:30], "it is cut short: 30 bytes")
        self.refused(whole[:middle], f"it is cut short: {middle} of {len(whole)} bytes")
        self.refused(whole[:-1], f"it is cut short: {len(whole) - 1} of {len(whole)} bytes")
        self.refused(whole + b"x", f"it is damaged: {len(whole) + 1} of {len(whole)} bytes")
        self.refused(bytes(flipped), "it is damaged: its checksum does not fit")
        self.refused(bytes(flipped), "it is damaged: its checksum does not fit", ranks=2)

    def test_every_damaged_byte_is_seen(self):
        """A few hundred of them, the first lines all; with a step too few files would hide a hole."""
        head = self.bytes.index(b"\n", 42)
        for place in [*range(0, 42, 3), *range(42, head, max(1, head // 8)),
                      *range(head, len(self.bytes), max(1, len(self.bytes) // 8))]:
            damaged = bytearray(self.bytes)
            damaged[place] ^= 0x10
            self.refused(bytes(damaged), "it is")

    def test_what_it_holds_counts(self):
        """Numbers that are off by a thousandth lead elsewhere: they are read, and nothing makes them up."""
        def end(content):
            result = self.restarted(content)
            self.assertEqual(result.status, 0, result.output)
            return result.fields.vector("displacement"), result.summary["energy"]
        u, energy = end(self.bytes)
        for name in ("unknowns", "contact.pair.history", "work", "work.forces"):
            moved, other = end(sealed(self.scaled(name, 1.001)))
            self.assertTrue(numpy.abs(moved - u).max() > 1e-9 or
                            abs(other["work_in"] - energy["work_in"]) > 1e-6 * energy["work_in"], name)

    def scaled(self, name, factor):
        """The content of the checkpoint with another array of that name."""
        content = bytearray(self.bytes[:-8])
        place = content.index(b"\n", 42) + 1
        for array in json.loads(content[42:place])["arrays"]:
            place += 8 * array["keys"]
            values = numpy.frombuffer(content, "<f8", array["values"], place).copy()
            if array["name"] == name:
                whole = (values == numpy.round(values))  # ids, flags and lengths of lists
                values[~whole] *= factor
                content[place:place + 8 * len(values)] = values.tobytes()
            place += 8 * array["values"]
        return bytes(content)

    def test_other_versions(self):
        self.refused(self.bytes.replace(b"abut checkpoint    1", b"abut checkpoint    2", 1),
                     "its format is 2, this abut reads format 1")
        content = re.sub(rb'"program":"[^"]*"', b'"program":"9.9.9"', self.bytes[:-8], count=1)
        self.refused(sealed(content), r"it was written by abut 9\.9\.9, this is abut \d")
        content = self.bytes[:-8].replace(b'"name":"contact.pair.history"', b'"name":"contact.other.history"', 1)
        result = self.restarted(sealed(content))
        self.assertEqual(result.status, 2)
        self.assertIn("it does not hold 'contact.pair.history' of this model", result.output)

    def test_other_decks_and_meshes(self):
        self.refused(self.bytes, "it is of another model .*in 'contact', it has 'friction: 0.3' where this deck has "
                     "'friction: 0.5'", {"contact": {"pair": {"friction": 0.5}}})
        self.refused(self.bytes, "it is of another model .*in 'materials', it has 'young: 1' where this deck has "
                     "'young: 2'", {"materials": {"soft": {"young": 2.0}}})
        self.refused(self.bytes, "it is of another model", {"loads": {"more": {"pressure": 0.001,
                                                                               "side_set": "upper_top"}}})
        self.refused(self.bytes, "it is of another mesh", {"mesh": {"generate": {"turn": 8}}})
        self.refused(self.bytes, r"it is at t = 0.5, and the run ends at time.end = 0.5: nothing is left to do but",
                     {"time": {"end": 0.5, "steps": 4}})

    def test_what_grows_until_the_end_holds_it(self):
        """An interference without a curve is whole at time.end; another end would take part of it back."""
        fit = {"contact": {"pair": {"interference": 0.001}}}
        first = scenes.run(scenes.merged(DECK, fit))
        self.refused(chain.checkpoint(first).read_bytes(), "it is of another model .*'end: 0.5' where this deck has", fit)

    def test_steps_solvers_and_output_may_differ(self):
        result = self.restarted(self.bytes, {
            "title": "later", "time": {"end": 0.75, "steps": 12, "max_cuts": 3}, "newton": {"tolerance": 1e-9},
            "linear_solver": {"method": "krylov"}, "output": {"checkpoint": None, "name": "other", "points": True}})
        self.assertEqual(result.status, 0, result.output)
        self.assertEqual([round(t * 16) for t in result.fields.times], [9, 10, 11, 12])
        self.assertEqual(result.summary["steps"], 8)
        names = sorted(f.name for f in (result.folder / "results").iterdir())
        self.assertEqual(names, ["other-s002.points.csv", "other.exo-s002", "other.history.csv",
                                 "other.history.json"])

    def test_parts_of_results(self):
        """A file of its own for each part, as MOOSE names them; per rank where asked."""
        result = self.restarted(self.bytes, {"output": {"files": "per_rank"}}, ranks=2, quiet=False)
        self.assertEqual(result.status, 0, result.output)
        self.assertIn("goes on from step 4 at t = 0.5", result.output)
        self.assertIn("step 5  t = 0.625", result.output)
        names = sorted(f.name for f in (result.folder / "results").iterdir())
        self.assertEqual(names, ["scene.checkpoint", "scene.exo-s002.2.0", "scene.exo-s002.2.1", "scene.history.csv",
                                 "scene.history.json"])

    def test_written_when_due(self):
        """Every third step and the last one; seen by what the file holds while the run goes on."""
        found = []
        for every in (3, 1000):
            deck = scenes.merged(DECK, {"output": {"checkpoint": {"every": every}}})
            result = scenes.run(deck)
            found.append(chain.facts(chain.checkpoint(result))["step"])
        self.assertEqual(found, [4, 4])
        result = scenes.run(scenes.merged(DECK, {"output": {"checkpoint": {"every": None, "minutes": 1e-6}}}))
        self.assertTrue(chain.checkpoint(result).is_file())
        self.assertFalse(list((scenes.run(scenes.merged(DECK, {"output": None})).folder / "results").glob("*point*")))

    def test_stays_where_the_disk_is_full(self):
        """The checkpoint before survives whole, the run goes on with a warning."""
        deck = scenes.merged(DECK, {"output": {"every": 1000, "checkpoint": {"every": 1}},
                                    "contact": {"pair": {"points": 4}}})  # results do not grow with points
        first = scenes.run(scenes.merged(deck, {"time": {"end": 0.125, "steps": 1}}))
        file = chain.checkpoint(first)
        before, limit = file.read_bytes(), len(file.read_bytes()) - 100
        results = max(f.stat().st_size for f in (first.folder / "results").glob("*.exo"))
        self.assertLess(results, limit, "the limit must be the checkpoint's")

        def limited():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        line = [scenes.EXECUTABLE, "run", str(first.deck_path), "--output-dir", str(first.folder / "results"),
                "--summary", str(first.folder / "second.json")]
        first.deck_path.write_text(json.dumps(scenes.merged(deck, {"time": {"end": 0.25, "steps": 2}})))
        done = subprocess.run(line, preexec_fn=limited, capture_output=True, text=True, timeout=60,
                              env={**os.environ, "OMP_NUM_THREADS": "1"}, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, "warning: no checkpoint: cannot write '.*scene.checkpoint': File too large; the "
                         "one before stays")
        self.assertEqual(file.read_bytes(), before)
        self.assertFalse(file.with_suffix(".checkpoint.unfinished").exists())
        warnings = json.loads((first.folder / "second.json").read_text())["warnings"]
        self.assertTrue(any(w.startswith("no checkpoint") for w in warnings), warnings)

    def test_replaces_nothing_but_checkpoints(self):
        folder = self.folder / "results"
        folder.mkdir()
        (folder / "scene.checkpoint").write_text("notes of mine\n")
        (self.folder / "scene.yaml").write_text(json.dumps(DECK))
        status, output = scenes.execute([scenes.EXECUTABLE, "run", str(self.folder / "scene.yaml"), "--output-dir",
                                         str(folder)], 60)
        self.assertEqual(status, 2)
        self.assertRegex(output, "the checkpoint would overwrite '.*scene.checkpoint', which is a file of another kind")
        self.assertEqual((folder / "scene.checkpoint").read_text(), "notes of mine\n")

    def test_results_have_their_name_once_they_are_whole(self):
        """What a killed run has left of a file is not in the way; a link is followed, and stays."""
        (self.folder / "scene.yaml").write_text(json.dumps(DECK))
        (self.folder / "scene.exo.unfinished").write_bytes(bytes(1000))
        (self.folder / "elsewhere").mkdir()
        names = ("scene.exo", "scene.checkpoint")
        for name in names:
            (self.folder / name).symlink_to(self.folder / "elsewhere" / name)
        line = [scenes.EXECUTABLE, "run", str(self.folder / "scene.yaml"), "--quiet", "--output-dir", str(self.folder)]
        for _ in range(2):  # the link leads nowhere, then to results
            status, output = scenes.execute(line, 60)
            self.assertEqual(status, 0, output)
            self.assertFalse(list(self.folder.rglob("elsewhere/*.unfinished")))
        for name in names:
            self.assertTrue((self.folder / name).is_symlink())
        self.assertEqual(chain.facts(self.folder / "elsewhere" / "scene.checkpoint")["step"], 4)
        self.assertEqual(len(scenes.Fields(self.folder / "elsewhere" / "scene.exo").times), 5)

    def test_a_signal_leaves_results_checkpoint_and_summary(self):
        deck = scenes.merged(DECK, {"time": {"end": 1.0, "steps": 800}, "output": {"checkpoint": {"every": 1000}}})
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number.name):
                folder = self.folder / number.name
                folder.mkdir()
                (folder / "scene.yaml").write_text(json.dumps(deck))
                line = [scenes.EXECUTABLE, "run", str(folder / "scene.yaml"), "--output-dir", str(folder),
                        "--summary", str(folder / "summary.json")]
                with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as run:
                    for text in run.stdout:
                        if text.startswith("step 5 "):
                            break
                    run.send_signal(number)
                    run.stdout.read()
                    self.assertEqual(run.wait(60), 5)
                summary = json.loads((folder / "summary.json").read_text())
                self.assertEqual(summary["status"], "stopped")
                self.assertIn(f"ended by signal {int(number)}", summary["reason"])
                self.assertGreaterEqual(summary["steps"], 5)
                facts = chain.facts(folder / "scene.checkpoint")
                self.assertEqual((facts["t"], facts["step"]), (summary["t"], summary["steps"]))
                self.assertEqual(scenes.Fields(folder / "scene.exo").times[-1], summary["t"])
                done = subprocess.run([*line[:3], "--quiet", "--restart", str(folder / "scene.checkpoint"),
                                       "--output-dir", str(folder)], timeout=300, check=False)
                self.assertEqual(done.returncode, 0)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
