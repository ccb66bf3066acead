# SPDX-License-Identifier: BSD-3-Clause
"""Runs one deck on the ranks of the test; all its verify entries must hold.
usage: input_decks_test.py DECK"""
import pathlib
import sys
import unittest

import scenes


class Deck(unittest.TestCase):
    path = None

    def test_verify_entries(self):
        result = scenes.run(self.path, seconds=300, files=sorted(self.path.parent.glob("*.exo")))
        entries = result.summary["verify"]
        for entry in entries:
            print(f"{entry['name']:20s} {entry['value']:.9g}  expected {entry['expected']:.9g}")
        self.assertTrue(entries, "a deck without verify entries proves nothing")
        self.assertTrue(all(entry["ok"] for entry in entries))
        self.assertTrue(any(contact["active_points"] for contact in result.summary["contact"].values()))


if __name__ == "__main__":
    Deck.path = pathlib.Path(sys.argv.pop(1))
    unittest.main()
