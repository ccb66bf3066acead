# SPDX-License-Identifier: BSD-3-Clause
"""`abut report` of runs that converged, stopped, or left less than all; and of what is no results."""
import base64
import io
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image
import numpy as np

import scenes

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import result_file

DECK = {
    "title": "A block <pressed> & drawn",
    "mesh": {"generate": {"kind": "blocks", "lower_size": [2, 2, 1], "lower_divisions": [5, 5, 2],
                          "upper_divisions": [3, 3, 2]}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "soft"}, "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "top": {"set": "upper_top", "x": 0.02, "y": 0.0, "z": -0.1}},
    "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "friction": 0.3}},
    "time": {"steps": 2},
    "verify": {"right": {"quantity": "force_z", "place": "pair", "expected": 0.0, "tolerance": 1e3},
               "wrong": {"quantity": "force_z", "place": "pair", "expected": 1e3, "tolerance": 1e-3}},
}
# The blocks are two high together: beyond t = 0.8 nothing of them would be left.
IMPOSSIBLE = scenes.merged(DECK, {"displacements": {"top": {"x": 0.0, "z": -2.5}}, "time": {"steps": 10, "max_cuts": 2}})
CONTACT_COLORS = 0.25  # least saturation of a pixel that shows pressure: bodies are in pale tints


def report(*arguments, environment=None):
    """Exit status and what was said."""
    done = subprocess.run([scenes.EXECUTABLE, "report", *map(str, arguments)], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, **(environment or {})}, timeout=120, check=False)
    return done.returncode, done.stdout


class Page:
    def __init__(self, path):
        self.text = pathlib.Path(path).read_text(encoding="utf-8")
        self.sections = dict(re.findall(r'<section id="([\w-]+)">(.*?)</section>', self.text, re.S))
        self.images = {alt: matplotlib.image.imread(io.BytesIO(base64.b64decode(data))) for alt, data in
                       re.findall(r'<img alt="([^"]*)" src="data:image/png;base64,([^"]+)">', self.text)}


def colorful(image):
    """Pixels, left of the colour bar, that are neither grey nor pale."""
    height, width, _ = image.shape
    model = image[:int(0.82 * height), :int(0.86 * width), :3]  # without the arrows of the axes
    return int(((model.max(axis=2) - model.min(axis=2)) > CONTACT_COLORS).sum())


class Pages(unittest.TestCase):
    def folder(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        return pathlib.Path(folder.name)

    def page(self, *arguments, place):
        status, said = report(*arguments)
        self.assertEqual(status, 0, said)
        self.assertIn(f"report: {place}", said)
        page = Page(place)
        self.assertNotRegex(page.text, r'(?:src|href)=(?!"data:)|url\(|@import|<script|<link|https?:')
        return page


class OfARun(Pages):
    @classmethod
    def setUpClass(cls):
        cls.run_ = scenes.run(DECK)
        cls.exodus = cls.run_.folder / "results" / "scene.exo"
        shutil.copy(cls.run_.folder / "summary.json", cls.exodus.with_suffix(".json"))
        cls.page_ = cls().page(cls.exodus, place=cls.exodus.with_suffix(".html"))

    def test_sections_and_facts(self):
        page = self.page_
        self.assertEqual(list(page.sections), ["facts", "warnings", "pictures", "contact-surface", "curves", "convergence",
                                               "verify", "model", "costs", "files"])
        summary = self.run_.summary
        self.assertGreater(self.run_.contact()["active_points"], 0)
        facts = page.sections["facts"]
        for word in ("converged", f"{len(self.run_.fields.node_map):,}", f"{summary['unknowns']:,}"):
            self.assertIn(word, facts)
        self.assertIn("A block &lt;pressed&gt; &amp; drawn", page.text)
        self.assertNotIn("<pressed>", page.text)
        self.assertEqual(re.findall(r'class="badge (\w+)"', page.sections["verify"]), ["ok", "failed"])
        self.assertIn(f"{self.run_.contact()['max_pressure']:.6g}", page.sections["model"])
        self.assertIn("penalty: eps", page.sections["model"])
        self.assertIn("scene.json", page.sections["files"])

    def test_images_show_contact(self):
        page = self.page_
        self.assertEqual(list(page.images), [
            "deformed mesh with contact pressure", "deformed mesh with von Mises stress", "contact surface of lower",
            "contact surface of upper", "forces over t", *(["contact over t"] if "contact over t" in page.images else []),
            "energy over t", "iterations of each step", "residuals"])
        for alt, image in page.images.items():
            self.assertGreater(min(image.shape[:2]), 150, alt)
            self.assertGreater(len(np.unique(image[..., :3].reshape(-1, 3), axis=0)), 20, alt)
        self.assertGreater(colorful(page.images["deformed mesh with contact pressure"]), 2000)

    def test_convergence_of_every_step(self):
        convergence = self.run_.summary["convergence"]
        steps = convergence["steps"]
        self.assertEqual([step["step"] for step in steps], [1, 2])
        self.assertEqual(sum(step["newton_iterations"] for step in steps), self.run_.summary["newton_iterations"])
        for step in steps:
            iterations = sum(len(solve) - 1 for solve in step["residuals"])
            self.assertGreaterEqual(iterations, step["newton_iterations"])
            self.assertGreater(iterations, 0)
            self.assertLess(step["residuals"][-1][-1], 1e-8)
        self.assertEqual(convergence["failed_residuals"], [])

    def test_history_is_used_where_it_fits(self):
        folder = self.folder()
        shutil.copy(self.exodus, folder)
        place = folder / "scene.html"
        (folder / "scene.history.csv").write_text("t,pair_force_z,pair_area\n0,0,0\n0.25,1,1\n0.5,2,1\n1,3,1\n")
        page = self.page(folder / "scene.exo", place=place)
        self.assertIn("Every step, from the history", page.sections["curves"])
        self.assertIn("contact over t", page.images)
        self.assertNotIn("energy over t", page.images)
        (folder / "scene.history.csv").write_text("t,pair_force_z\n0,0\n0.3,1\n")  # and the page is written over
        page = self.page(folder / "scene.exo", place=place)
        self.assertIn("of another run", page.sections["facts"])
        self.assertIn("energy over t", page.images)

    def test_without_a_summary(self):
        folder = self.folder()
        shutil.copy(self.exodus, folder)
        page = self.page(folder / "scene.exo", place=folder / "scene.html")
        self.assertIn("There is no summary beside the results", page.sections["facts"])
        self.assertIn("deformed mesh with contact pressure", page.images)
        self.assertIn("iterations of each step", page.images)
        self.assertNotIn("verify", page.sections)
        status, said = report(folder / "scene.exo", "--summary", folder / "none.json")
        self.assertEqual(status, 2)
        self.assertIn("none.json: the summary cannot be read", said)

    def test_nothing_but_a_report_is_written_over(self):
        place = self.folder() / "letter.html"
        place.write_text("<html>dear</html>")
        status, said = report(self.exodus, "-o", place)
        self.assertEqual(status, 2)
        self.assertIn("letter.html", said)
        self.assertEqual(place.read_text(), "<html>dear</html>")


class OfARunThatStopped(Pages):
    def test_why_and_how_far(self):
        run = scenes.run(IMPOSSIBLE, check=False)
        self.assertEqual(run.status, 1, run.output)
        place = run.folder / "page.html"
        page = self.page(run.folder / "results" / "scene.exo", "--summary", run.folder / "summary.json", "-o", place,
                         place=place)
        self.assertIn("stopped", page.sections["facts"])
        self.assertIn("No step beyond t = ", page.sections["reason"])
        self.assertIn(f"t = {run.summary['t']:.6g}", page.sections["reason"])
        self.assertEqual(len(run.summary["convergence"]["steps"]), run.summary["steps"])
        self.assertGreaterEqual(len(run.summary["convergence"]["failed_residuals"]), 3)  # the step and two cuts
        self.assertIn("residuals", page.images)


class OfOtherFiles(Pages):
    def test_results_of_before_any_step(self):
        path = self.folder() / "two.exo"
        result_file.pressed_bricks(path)
        page = self.page(path, place=path.with_suffix(".html"))
        self.assertGreater(colorful(page.images["deformed mesh with contact pressure"]), 2000)
        mesh, *_ = result_file.bricks()
        result_file.exodus_edit.write(path, mesh)
        result_file.put_fields(path, [], {"displacement_x": np.zeros((0, 16))})
        page = self.page(path, place=path.with_suffix(".html"))
        self.assertIn("holds no step", page.sections["facts"])
        self.assertEqual(colorful(page.images["deformed mesh with contact pressure"]), 0)

    def test_what_is_no_results(self):
        folder = self.folder()
        result_file.pressed_bricks(folder / "two.exo")
        whole = (folder / "two.exo").read_bytes()
        (folder / "cut.exo").write_bytes(whole[:len(whole) // 3])
        (folder / "text.exo").write_text("no results")
        result_file.exodus_edit.write(folder / "mesh.exo", result_file.bricks()[0])
        for name, words in (("none.exo", "no such file"), ("text.exo", "cannot be read as an Exodus file"),
                            ("mesh.exo", "a mesh without results"), ("cut.exo", "cut.exo: .*(damaged|cannot be read)"),
                            ("", "cannot be read as an Exodus file")):
            with self.subTest(name):
                status, said = report(folder / name)
                self.assertEqual(status, 2, said)
                self.assertRegex(said, rf"^abut: [^\n]*{words}[^\n]*\n$")

    def test_without_python_or_its_modules(self):
        folder = self.folder()
        result_file.pressed_bricks(folder / "two.exo")
        bare = folder / "bare"
        bare.write_text('#!/bin/sh\nexec /usr/bin/python3 -S "$@"\n')  # without what packages install
        bare.chmod(bare.stat().st_mode | stat.S_IXUSR)
        for python, words in ((bare, "apt-get install python3-numpy python3-matplotlib python3-netcdf4"),
                              (folder / "none", "cannot start the Python interpreter '.*none'.*apt-get install python3")):
            status, said = report(folder / "two.exo", environment={"ABUT_PYTHON": str(python)})
            self.assertEqual(status, 5, said)
            self.assertRegex(said, words)
        self.assertFalse((folder / "two.html").exists())


if __name__ == "__main__":
    unittest.main()
