# SPDX-License-Identifier: BSD-3-Clause
"""A run in one piece and the same run in four, each started from the checkpoint of the one before.

Steps are eighths, so that the ends of the pieces are the very times of the whole run. A piece ends where
`time.end` says, and leaves a checkpoint there as every run does that is asked for any.
"""
import json
import unittest

import numpy

import scenes

STEPS = 8
STOPS = (2, 4, 6, STEPS)  # of the pieces, in steps
COUNTS = ("steps", "newton_iterations", "augmentations", "cut_backs", "unknowns", "extrapolated_steps")
SITES = ("active_points", "stick_points", "slip_points", "flips")


def one_piece(deck, **options):
    return scenes.run(scenes.merged(deck, {"time": {"end": 1.0, "steps": STEPS}}), **options)


def in_pieces(deck, ranks=(1, 1, 1, 1), stops=STOPS, **options):
    """The results of all pieces, of which each is run on so many ranks."""
    pieces = []
    for count, stop in zip(ranks, stops):
        piece = scenes.merged(deck, {"time": {"end": stop / STEPS, "steps": stop},
                                     "output": {"checkpoint": {"every": 1000}}})
        arguments = ["--restart", str(checkpoint(pieces[-1]))] if pieces else []
        pieces.append(scenes.run(piece, ranks=count, arguments=arguments, **options))
    return pieces


def checkpoint(result):
    return next((result.folder / "results").glob("*.checkpoint"))


def facts(file):
    """What a checkpoint says of itself."""
    return json.loads(file.read_bytes().split(b"\n", 2)[1])


def difference(a, b, names):
    """Largest difference of nodal fields at the ends of two runs, over the largest value of each."""
    most = 0.0
    for name in names:
        x, y = a.fields.vector(name), b.fields.vector(name)
        most = max(most, numpy.abs(x - y).max() / max(numpy.abs(x).max(), 1e-300))
    return most


class Restarted(unittest.TestCase):
    def same_end(self, whole, last, tolerance, counts=COUNTS, vectors=("displacement", "contact_traction")):
        """All that is reported at the end of a run, and its fields; returns the largest difference."""
        most = difference(whole, last, vectors)
        self.assertLess(most, tolerance)
        for name in counts:
            self.assertEqual(last.summary[name], whole.summary[name], name)
        for name, contact in whole.summary["contact"].items():
            found = last.summary["contact"][name]
            for key in SITES:
                self.assertEqual(found[key], contact[key], f"{name}: {key}")
            for key in ("friction_dissipation", "penalty_energy", "max_slip", "penalty_factor", "penalty_error"):
                self.assertAlmostEqual(found[key], contact[key], msg=f"{name}: {key}",
                                       delta=10 * tolerance * max(abs(contact[key]), 1e-6))
        energy = whole.summary["energy"]
        size = max(abs(v) for v in energy.values())
        for key, value in energy.items():
            self.assertAlmostEqual(last.summary["energy"][key], value, delta=10 * tolerance * size, msg=key)
        return most

    def same_course(self, whole, pieces, tolerance, vectors=("displacement",)):
        """The files of the pieces hold the steps of the whole run, each once."""
        times = [t for piece in pieces for t in piece.fields.times]
        numpy.testing.assert_allclose(times, whole.fields.times, rtol=0, atol=1e-15)
        step = 0
        for piece in pieces:
            for k in range(len(piece.fields.times)):
                for name in vectors:
                    x, y = whole.fields.vector(name, step), piece.fields.vector(name, k)
                    self.assertLess(numpy.abs(x - y).max(), tolerance * max(numpy.abs(x).max(), 1e-300))
                step += 1
