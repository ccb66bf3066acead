#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is said of sets, penalties, free motions, contacts and comparisons is so."""
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy as np
import scenes

BLOCKS = {
    "mesh": {"generate": {"kind": "blocks", "lower_divisions": [2, 2, 2], "upper_divisions": [3, 3, 3]}},
    "materials": {"soft": {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "soft"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "head": {"set": "upper_top", "fix": ["x", "y"], "z": -0.01}},
    "contact": {"press": {"primary": "upper_bottom", "secondary": "lower_top"}},
}
BOX = {
    "mesh": {"generate": {"kind": "box", "divisions": [2, 2, 2]}},
    "materials": BLOCKS["materials"],
    "bodies": {"a": {"blocks": ["box"], "material": "soft"}},
}


class Case(unittest.TestCase):
    def refused(self, deck, message, **more):
        """By check and by run, with status 2 and one such line."""
        for command in ("check", "run"):
            result = scenes.run(deck, command=command, check=False, **more)
            self.assertEqual(result.status, 2, result.output)
            self.assertRegex(result.output, r"(?m)^abut: \S*scene\.yaml:\d+: " + message)


class Sets(Case):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="abut_sets_")
        cls.path = pathlib.Path(cls.folder.name)
        cls.mesh = exodus_edit.read(scenes.mesh(cls.path / "plain.exo", "blocks", lower_divisions=[2, 2, 2],
                                                upper_divisions=[3, 3, 3]))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def write(self):
        exodus_edit.write(self.path / "mesh.exo", self.mesh)
        return [self.path / "mesh.exo"]

    def deck(self, changes):
        return scenes.merged(scenes.merged(BLOCKS, {"mesh": {"generate": None, "file": "mesh.exo"}}), changes)

    def test_empty_sets_are_refused(self):
        self.mesh.node_sets["nobody"] = np.zeros(0, int)
        self.mesh.side_sets["no face"] = (np.zeros(0, int), np.zeros(0, int))
        files = self.write()
        zero = {"expected": 0, "tolerance": 1}
        for section, key, entry in (
                ("displacements", "set", {"set": "nobody", "fix": ["x"]}),
                ("displacements", "set", {"set": "no face", "fix": ["x"]}),
                ("loads", "side_set", {"side_set": "no face", "pressure": 1}),
                ("loads", "side_set", {"side_set": "no face", "traction": [0, 0, 1]}),
                ("loads", "node_set", {"node_set": "nobody", "force": [0, 0, 1]}),
                ("bodies", "node_sets", {"node_sets": ["nobody"], "rigid": {"free": ["x"]}}),
                ("verify", "place", {"place": "nobody", "quantity": "displacement_x", **zero}),
                ("verify", "place", {"place": "no face", "quantity": "reaction_x", **zero})):
            with self.subTest(section=section, key=key):
                word = entry[key] if isinstance(entry[key], str) else entry[key][0]
                self.refused(self.deck({section: {"new": entry}}),
                             rf"{section}\.new\.{key}: '{word}' of the mesh is empty$", files=files)

    def test_double_faces_and_nodes_count_once(self):
        plain = scenes.run(self.deck({}), files=self.write())
        elements, sides = self.mesh.side_sets["upper_bottom"]
        self.mesh.side_sets["upper_bottom"] = (np.append(elements, elements[:2]), np.append(sides, sides[:2]))
        foot = self.mesh.node_sets.get("lower_bottom", np.zeros(0, int))
        self.mesh.node_sets["lower_bottom"] = np.append(foot, foot[:1])
        deck = self.deck({"verify": {"foot": scenes.probe("reaction_z", "lower_bottom")}})
        double = scenes.run(deck, files=self.write())
        np.testing.assert_allclose(double.force("press"), plain.force("press"), rtol=1e-12, atol=1e-15)
        self.assertAlmostEqual(double.quantity("foot"), plain.force("press")[2], delta=1e-9)
        said = [w for w in double.summary["warnings"] if "more than once" in w]
        self.assertEqual(len(said), 2, double.summary["warnings"])
        self.assertIn("side set 'upper_bottom' lists faces more than once; each counts once (2 left out)", said[1])

    def test_names_beyond_32_characters(self):
        start = "a very long name of a side set that says what it is for, "
        for old, new in (("upper_bottom", "one"), ("lower_top", "two")):
            self.mesh.side_sets[start + new] = self.mesh.side_sets.pop(old)
        run = scenes.run(self.deck({"contact": {"press": {"primary": start + "one", "secondary": start + "two"}}}),
                         files=self.write())
        self.assertGreater(run.contact("press")["active_points"], 0)
        self.assertIn(start + "two", run.fields.names("ss"))
        name = "n" * 201
        self.refused(self.deck({"contact": {"press": None, name: {"primary": start + "one",
                                                                   "secondary": start + "two"}}}),
                     rf"contact\.{name}: the name has 201 characters, expected at most 200$", files=self.write())

    def setUp(self):
        self.mesh = exodus_edit.read(self.path / "plain.exo")


class Blocks(Case):
    def test_numbers_of_blocks(self):
        run = scenes.run(scenes.merged(BLOCKS, {
            "bodies": {"lower": {"blocks": [1]}, "upper": {"blocks": [2]}},
            "loads": {"weight": {"block": 2, "body_force": [0, 0, -1e-4]}}}))
        self.assertGreater(run.contact("press")["active_points"], 0)
        self.refused(scenes.merged(BLOCKS, {"bodies": {"lower": {"blocks": [3]}}}),
                     r"bodies\.lower\.blocks: the mesh has no block '3'; valid: lower, upper")
        self.refused(scenes.merged(BLOCKS, {"bodies": {"lower": {"blocks": [1, "lower"]}}}),
                     r"bodies\.lower\.blocks: block 'lower' already belongs to body 'lower'")


class Points(Case):
    def ask(self, point):
        return scenes.merged(BOX, {"displacements": {"all": {"set": "z0", "fix": ["x", "y", "z"]}},
                                   "verify": {"tip": scenes.probe("displacement_z", point=point)}})

    def test_far_from_any_node(self):
        self.refused(self.ask([9, 9, 9]),
                     r"verify\.tip\.point: the point \(9, 9, 9\) is not in the mesh: its nearest node, 27, "
                     r"is 13\.8564 away$")
        self.refused(self.ask([0.5, 0.5, 1.7]), r"verify\.tip\.point: the point .* is 0\.7 away$")

    def test_anywhere_in_an_element(self):
        for point in ([0.25, 0.25, 0.25], [0.5, 0.5, 1.0], [1, 1, 1.0001]):
            self.assertEqual(scenes.run(self.ask(point), command="check").status, 0)


class FreeMotions(Case):
    def free(self, displacements, motions, base=BOX):
        deck = scenes.merged(base, {"displacements": displacements})
        result = scenes.run(deck, command="check", check=False)
        self.assertEqual(result.status, 2, result.output)
        self.assertIn(" is free to move: " + ", ".join(motions) + ". Hold", result.output)
        for motion in motions:
            self.assertRegex(result.output, r"FREE: body '\w+' can move: " + motion.replace("(", r"\(")
                             .replace(")", r"\)") + "\n")

    def test_a_face_held_in_one_direction(self):
        self.free({"g": {"set": "z1", "fix": ["x"]}},
                  ["translation along y", "translation along z", "rotation about x through (0.5, 0.5, 0.5)",
                   "rotation about y through (0.5, 0.5, 1)"])

    def test_a_face_held_in_two_directions(self):
        self.free({"g": {"set": "z1", "fix": ["x", "y"]}},
                  ["translation along z", "rotation about x through (0.5, 0.5, 1)",
                   "rotation about y through (0.5, 0.5, 1)"])

    def test_nothing_held(self):
        self.free({}, ["translation along x", "translation along y", "translation along z", "rotation about x",
                       "rotation about y", "rotation about z"])

    def test_a_ball_joint_and_a_hinge(self):
        mesh = exodus_edit.read(scenes.mesh(self.path / "box.exo", "box", divisions=[2, 2, 2]))
        corner = int(np.argmin(np.abs(mesh.x).sum(axis=1)))
        other = int(np.argmin(np.abs(mesh.x - [1, 1, 0]).sum(axis=1)))
        mesh.node_sets["corner"], mesh.node_sets["both"] = np.array([corner]), np.array([corner, other])
        exodus_edit.write(self.path / "box.exo", mesh)
        base = scenes.merged(BOX, {"mesh": {"generate": None, "file": str(self.path / "box.exo")}})
        self.free({"g": {"set": "corner", "fix": ["x", "y", "z"]}},
                  ["rotation about x through (0.5, 0, 0)", "rotation about y through (0, 0.5, 0)",
                   "rotation about z through (0, 0, 0.5)"], base)
        self.free({"g": {"set": "both", "fix": ["x", "y", "z"]}},
                  ["rotation about (0.707, 0.707, 0) through (0.5, 0.5, 0)"], base)

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="abut_free_")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)


class Stopped(Case):
    def test_contact_that_lets_go_is_named(self):
        """A block that is held sideways and pressed on a floor, then pulled off it."""
        run = scenes.run(scenes.merged(BLOCKS, {
            "displacements": {"head": {"fix": ["x", "y"], "z": None}}, "time": {"steps": 2},
            "curves": {"turn": [[0, -1], [0.5, -1], [1, 1]]},
            "loads": {"press": {"side_set": "upper_top", "traction": [0, 0, 1e-3], "curve": "turn"}}}), check=False)
        self.assertEqual(run.status, 1, run.output)
        self.assertIn("\nNothing but contact holds body 'upper' against: translation along z, rotation about x "
                      "through (0.5, 0.5, 1), rotation about y through (0.5, 0.5, 1)\n", run.output)

    def test_what_is_free_is_named(self):
        """Contact that ends."""
        run = scenes.run(scenes.merged(BLOCKS, {
            "displacements": {"head": {"fix": ["x", "y"], "z": None}}, "time": {"steps": 2},
            "contact": {"press": {"until": 0.5}},
            "loads": {"press": {"side_set": "upper_top", "traction": [0, 0, -1e-3]}}}), check=False)
        self.assertEqual(run.status, 1, run.output)
        self.assertIn("\nBody 'upper' is free to move: translation along z, rotation about x through (0.5, 0.5, 0.999), "
                      "rotation about y through (0.5, 0.5, 0.999)\n", run.output)

    def test_the_setting_that_ends_a_run(self):
        hard = scenes.merged(BLOCKS, {"newton": {"max_iterations": 1}, "contact": {"press": {"friction": 0.3}},
                                      "displacements": {"head": {"x": 0.3, "fix": ["y"]}}})
        for time, words in (({"min_fraction": 0.1}, r"no further because of time\.min_fraction, which is 0\.1"),
                            ({"max_cuts": 2}, r"no further because of time\.max_cuts, which is 2"),
                            ({"adaptive": False}, r"not cut because of 'time: \{adaptive: false\}'")):
            run = scenes.run(scenes.merged(hard, {"time": time}), check=False)
            self.assertEqual(run.status, 1, run.output)
            self.assertRegex(run.output, words)
            self.assertRegex(run.summary["reason"], words)


class Penalty(Case):
    def press(self, **options):
        return scenes.merged(BLOCKS, {"contact": {"press": options}})

    def test_beyond_all_bounds(self):
        # E A/V of the lower block: 1 / 0.5
        self.refused(self.press(penalty=1e100),
                     r"contact\.press\.penalty: 1e\+100 is 5e\+99 times the stiffness E A/V of the elements behind "
                     r"the surfaces, of which rounding leaves nothing; 10 to 1000 times is usual$")
        self.refused(self.press(penalty_factor=1e100), r"contact\.press\.penalty_factor: 1e\+100 is 1e\+100 times")

    def test_large(self):
        run = scenes.run(self.press(penalty=1e8), quiet=False)
        warning = run.summary["warnings"][0]
        self.assertRegex(warning, r"^contact\.press\.penalty: 1e\+08 is 5e\+07 times the stiffness")
        self.assertIn("warning: " + warning, run.output)
        self.assertEqual(scenes.run(self.press(penalty=1e4)).summary["warnings"], [])


class Elements(Case):
    def deck(self, cell, poisson, **body):
        return scenes.merged(BOX, {
            "mesh": {"generate": {"element": cell}}, "materials": {"soft": {"poisson": poisson}}, "bodies": {"a": body},
            "displacements": {"foot": {"set": "z0", "fix": ["x", "y", "z"]}}})

    def test_those_that_lock_are_named(self):
        volume = "elements lock in a material that hardly changes its volume"
        bending = "elements are too stiff where bodies bend"
        plain, enhanced = {"element": "displacement"}, {"element": "enhanced"}
        for cell, poisson, body, warning in (
                ("tet4", 0.3, {}, bending), ("wedge6", 0.3, {}, bending), ("tet4", 0.3, plain, None),
                ("tet4", 0.499, {}, volume), ("wedge6", 0.499, plain, volume), ("hex8", 0.499, plain, volume),
                ("hex8", 0.3, plain, None), ("hex8", 0.499, enhanced, None), ("tet10", 0.499, {}, None),
                ("hex20", 0.499, {}, None)):
            deck = self.deck(cell, poisson, **body)
            with self.subTest(cell=cell, poisson=poisson, body=body):
                found = scenes.run(deck).summary["warnings"]
                self.assertEqual(len(found), warning is not None, found)
                if warning:
                    self.assertIn(f"bodies.a: {cell.upper().replace('TET', 'TETRA')} {warning}", found[0])
                    self.assertIn("WARNING: " + found[0], scenes.run(deck, command="check").output)

    def test_those_that_are_not_there(self):
        self.refused(self.deck("tet4", 0.3, element="enhanced"),
                     r"bodies\.a\.element: 'enhanced' elements are hex8; these are TETRA4$")
        self.refused(self.deck("hex8", 0.3, element="mean_dilatation"),
                     r"bodies\.a\.element: a 'mean_dilatation' needs an uncoupled material, mooney_rivlin or ogden$")
        self.refused(self.deck("tet10", 0.3, element="mean_dilatation"),
                     r"bodies\.a\.element: elements with a 'mean_dilatation' are hex8 or wedge6; these are TETRA10$")
        self.refused(self.deck("hex8", 0.3, element="enhanced", material=None, rigid={}),
                     r"bodies\.a\.element: the elements of a rigid body do not deform$")


class Warnings(Case):
    def test_contact_that_never_touches(self):
        deck = scenes.merged(BLOCKS, {"contact": {"other": {"primary": "upper_x0", "secondary": "lower_x1"}}})
        run = scenes.run(deck, quiet=False)
        start = ("contact.other: at the start no point of 'upper_x0' has a partner on 'lower_x1' within 3 face "
                 "sizes: are they far apart, or do they face the wrong way?")
        end = "contact.other: 'upper_x0' and 'lower_x1' never touched in the whole run"
        self.assertEqual(run.summary["warnings"], [start, end])
        for text in (start, end):
            self.assertEqual(run.output.count("warning: " + text), 1, run.output)
        self.assertIn("WARNING: " + start, scenes.run(deck, command="check").output)

    def test_contact_that_touched_for_a_time(self):
        run = scenes.run(scenes.merged(BLOCKS, {
            "displacements": {"head": {"curve": "tap"}}, "time": {"steps": 2},
            "curves": {"tap": [[0, 0], [0.5, 1], [1, -1]]}}))
        self.assertEqual(run.contact("press")["active_points"], 0)
        self.assertEqual(run.summary["warnings"], [])

    def test_deep_points(self):
        run = scenes.run(scenes.merged(BLOCKS, {"mesh": {"generate": {"gap": -0.2}}, "contact": {"press": {
            "penalty_factor": 0.1}}}))
        start, end, soft = run.summary["warnings"]
        self.assertEqual(start, "contact.press: 'upper_bottom' and 'lower_top' overlap at the start by up to 0.2, "
                         "0.6 of a face: is that meant?")
        self.assertRegex(end, r"^contact\.press: points of 'upper_bottom' sank into 'lower_top' by up to 0\.6 of their "
                         r"face: ")
        self.assertIn(" off by about ", soft)

    def test_a_surface_that_may_touch_itself(self):
        deck = scenes.merged(BLOCKS, {"contact": {"self": {"primary": "upper_x0", "secondary": "upper_x0"}}})
        self.assertNotIn("WARNING: contact.self", scenes.run(deck, command="check").output)


class Verify(Case):
    def check(self, expected, arguments, status, output):
        deck = scenes.merged(BLOCKS, {"verify": {"force": {
            "quantity": "force_z", "place": "press", "expected": expected, "tolerance": 1e-3}}})
        run = scenes.run(deck, arguments=arguments, check=False)
        self.assertEqual(run.status, status, run.output)
        self.assertRegex(run.output, output)
        self.assertEqual(run.summary["status"], "converged")

    def test_strict_and_quiet(self):
        failed = r"(?m)^abut: verify force +0\.00\d+  expected +7 \+- 0\.001  FAILED$"
        self.check(7, [], 0, failed)
        self.check(7, ["--strict-verify"], 4, failed)
        self.check(0.005, ["--strict-verify"], 0, "^$")


class Encoding(Case):
    def test_latin_1_is_refused_when_read(self):
        for name, line, text in (("a.yaml", 2, b"title: x\ncontact: {\"k\xf6ntakt\": {}}\n"),
                                 ("a.xml", 2, b"<ParameterList>\n<Parameter name=\"\xf6\"/></ParameterList>"),
                                 ("b.yaml", 1, b"title: \xe2\x82\n"), ("c.yaml", 1, b"\xc0\xaf: 1\n")):
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / name
                path.write_bytes(text)
                status, output = scenes.execute([scenes.EXECUTABLE, "check", str(path)], 60)
            self.assertEqual(status, 2, output)
            self.assertRegex(output, rf"{name}:{line}: byte 0x(F6|E2|C0) is not UTF-8 \(it may be Latin-1\)")

    def test_utf_8_passes(self):
        deck = scenes.merged(BLOCKS, {"title": "Klötze 木", "contact": {"press": None, "köntakt": BLOCKS["contact"][
            "press"]}})
        run = scenes.run(scenes._place_deck(deck, pathlib.Path(tempfile.mkdtemp())))
        self.assertGreater(run.contact("köntakt")["active_points"], 0)


class Trilinos(Case):
    def test_a_list_that_trilinos_does_not_take(self):
        run = scenes.run(scenes.merged(BLOCKS, {
            "linear_solver": {"method": "krylov"}, "trilinos": {"Belos": {"Maximum Iterations": "many"}}}),
            check=False)
        self.assertEqual(run.status, 2, run.output)
        self.assertRegex(run.output, r"abut: \S*scene\.yaml:\d+: trilinos: Trilinos does not take this list: .*"
                         r"\"Maximum Iterations\" of type \"string\"")
        run = scenes.run(scenes.merged(BLOCKS, {
            "linear_solver": {"method": "krylov", "preconditioner": "muelu"}, "trilinos": {"MueLu": {"foo": "bar"}}}),
            check=False)
        self.assertEqual(run.status, 2, run.output)
        self.assertRegex(run.output, r"abut: \S*scene\.yaml:\d+: trilinos: Trilinos does not take this list: .*foo")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
