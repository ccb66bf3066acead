#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What docs/user/bring-your-mesh.md says to type works, and says what it says.
usage: bring_your_mesh_test.py [Commands|WithGmsh]"""
import pathlib
import re
import shutil
import tempfile
import unittest

import scenes

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "user" / "bring-your-mesh.md").read_text()
SECTION = PAGE.split("\n## ")[1]  # the pin in a hole
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", SECTION, re.M | re.S)


class Case(unittest.TestCase):
    def setUp(self):
        """A folder in which the page's commands find what they name."""
        folder = tempfile.TemporaryDirectory(prefix="abut_page_")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        (self.path / "build" / "bin").mkdir(parents=True)
        (self.path / "build" / "bin" / "abut").symlink_to(shutil.which(scenes.EXECUTABLE))
        shutil.copytree(ROOT / "input" / "pin", self.path / "input" / "pin")

    def shell(self, command):
        status, output = scenes.execute(["bash", "-c", command], 120, self.path)
        self.assertEqual(status, 0, f"{command}\n{output}")
        return output


class Commands(Case):
    def test_commands_and_what_they_print(self):
        run = 0
        for language, text in BLOCKS:
            for part in re.split(r"(?m)^\$ ", text)[1:] if language == "" else []:
                command, _, shown = part.partition("\n")
                output = self.shell(command)
                if shown:
                    self.assertEqual(output, shown, command)
                run += 1
        self.assertEqual(run, 6)
        self.assertTrue((self.path / "pin" / "pin_results.exo").exists())
        names = scenes.Fields(self.path / "pin" / "pin_results.exo").names("ss")
        self.assertIn("hole", names)

    def test_the_deck_is_that_of_input(self):
        deck = (ROOT / "input" / "pin" / "pin.yaml").read_text()
        self.assertIn(("yaml", deck.split("verify:")[0]), BLOCKS)


@unittest.skipIf(shutil.which("gmsh") is None, "gmsh is not there")
class WithGmsh(Case):
    def test_the_mesh_is_made_and_runs(self):
        for version in ("msh41", "msh41 -bin", "msh2", "msh2 -bin"):
            made = next(text for _, text in BLOCKS if text.startswith("gmsh "))
            self.shell(made.replace("msh41", version) + "build/bin/abut import input/pin/pin.msh --output-dir pin")
        self.shell("cp input/pin/pin.yaml pin/ && build/bin/abut run pin/pin.yaml --output-dir pin && "
                   "build/bin/abut report pin/pin_results.exo")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
