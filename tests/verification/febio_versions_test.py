# SPDX-License-Identifier: BSD-3-Clause
"""Cases of FEBio's own suite, which are of specification 4.0, in the words of 3.0, 2.5 and 2.0: the same deck and the
same mesh come of each. usage: febio_versions_test.py [CASE ...]

The cases are sought where febio_suite_test.py seeks them; without them nothing is tested, and the test says so.
"""
import pathlib
import re
import shutil
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import febio_versions
import scenes
from febio_suite_test import SUITE

# Rigid bodies, nodes tied to them, must points, a body force, steps.
CASES = ("co01", "co09", "co18", "co36", "co40")
STEPS = (("3.0", febio_versions.to_3_0), ("2.5", febio_versions.to_2_5), ("2.0", febio_versions.to_2_0))


@unittest.skipIf(SUITE is None or not SUITE.is_dir(), "the folder febio-suite is not there")
class Versions(unittest.TestCase):
    cases = CASES

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="abut_versions_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def imported(self, file, version):
        """The lines of the deck, and what the mesh holds."""
        folder = self.folder / version
        status, output = scenes.execute([scenes.EXECUTABLE, "import", str(file), "--output-dir", str(folder)], 60)
        self.assertEqual(status, 0, output)
        mesh = scenes.Fields(folder / f"{file.stem}.exo")
        blocks = {block: mesh.connectivity(block).tolist() for block in mesh.names("eb")}
        return (folder / f"{file.stem}.yaml").read_text().splitlines(), (list(mesh.node_map), blocks)

    def test_decks_are_the_same(self):
        for case in self.cases:
            original = SUITE / "cases" / f"{case}.feb"
            root = xml.parse(original).getroot()
            deck, mesh = self.imported(original, "4.0")
            self.assertTrue(any("penalty" in line for line in deck))
            for version, rewrite in STEPS:
                with self.subTest(case, version=version):
                    rewrite(root)
                    self.assertEqual(root.get("version"), version)
                    file = self.folder / f"{case}.feb"
                    xml.ElementTree(root).write(file)
                    old_deck, old_mesh = self.imported(file, version)
                    self.assertEqual(old_mesh, mesh)
                    self.assertEqual(len(old_deck), len(deck))
                    for old, now in zip(old_deck, deck):
                        if version == "2.0" and "tied to rigid body" in now:  # a set without a name
                            old, now = (re.sub(r"\S+: {set: (\"[^\"]*\"|\w+)", "", line) for line in (old, now))
                        self.assertEqual(old, now)


if __name__ == "__main__":
    named = [a for a in sys.argv[1:] if re.fullmatch(r"co\d+", a)]
    if named:
        Versions.cases = tuple(named)
        sys.argv = [a for a in sys.argv if a not in named]
    unittest.main()
