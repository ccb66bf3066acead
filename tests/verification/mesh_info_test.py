#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is told of meshes, loads and time before anything is solved."""
import pathlib
import re
import tempfile
import unittest

import scenes

BOX = {"kind": "box", "size": [2, 3, 4], "divisions": [2, 3, 2]}
DECK = {
    "mesh": {"generate": BOX},
    "surfaces": {"lid": {"normal": {"direction": [0, 0, 1]}}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}},
    "bodies": {"a": {"blocks": ["box"], "material": "soft"}},
    "displacements": {"foot": {"set": "z0", "fix": ["x", "y", "z"]}},
    "curves": {"half": [[0, 0], [2, 1], [4, 0]]},
    "loads": {"push": {"pressure": 0.5, "side_set": "lid"}, "wind": {"traction": [0, "x*t", 0], "side_set": "x1"},
              "weight": {"body_force": [0, 0, -0.1], "block": "box", "curve": "half"},
              "pull": {"force": [1, 0, 0], "node_set": "z1"}},
    "time": {"end": 2, "steps": 4},
}
BLOCK = r"""mesh: 36 nodes, 12 elements in the box \(0, 0, 0\) to \(2, 3, 4\)
  block 1 box: 12 HEX8, volume 24
(?:  .*\n)*  side set z1: 6 faces, area 6; node set of 12 nodes
  edges: shortest 1, mean 1\.\d+, longest 2
  worst aspect ratio \(longest over shortest edge\) 2: element 1 of block 'box' at \(0\.5, 0\.5, 1\)
  worst scaled Jacobian \(1 is best, 0 or less is inside out\) 1: element \d+ of block 'box' at .*
"""


class Told(unittest.TestCase):
    def test_of_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = scenes.mesh(pathlib.Path(folder) / "box.exo", **BOX)
            status, text = scenes.execute([scenes.EXECUTABLE, "mesh", "--info", str(file)], 60)
            self.assertEqual(status, 0, text)
            self.assertTrue(re.fullmatch(BLOCK, text), text)

    def test_wrong_words(self):
        for words, message in ((["--info", "no.exo"], r"mesh file 'no\.exo': cannot be read: .*"),
                               (["box", "--info", "no.exo"], r"abut mesh: --info FILE goes with nothing else"),
                               (["box"], r"abut mesh: expected KIND and -o FILE to write a mesh, or --info FILE .*"),
                               ([], r"abut mesh: expected KIND and -o FILE .*")):
            status, text = scenes.execute([scenes.EXECUTABLE, "mesh", *words], 60)
            self.assertEqual(status, 2, text)
            self.assertRegex(text, "^abut: " + message)

    def test_by_check(self):
        text = scenes.run(DECK, command="check").output
        self.assertIn("  block 1 box: 12 HEX8, volume 24\n", text)
        self.assertIn("  side set lid: 6 faces, area 6; node set of 12 nodes\n", text)
        self.assertEqual(text.count("unknowns: 108\n"), 1)
        self.assertIn("loads at t = 2, on the bodies as they are at the start:\n"
                      "  push: pressure on 'lid', resultant (0, 0, -6)\n"
                      "  wind: traction on 'x1', resultant (0, 48, 0)\n"
                      "  weight: body force on 'box', resultant (0, 0, -2.4), curve half\n"
                      "  pull: force at each node on 'z1', resultant (24, 0, 0)\n", text)
        self.assertIn("time: t from 0 to 2 in 4 steps of 0.5, cut down to 0.0005 where they fail\n", text)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
