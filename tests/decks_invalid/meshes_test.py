#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Decks that are wrong only together with a mesh or a folder: exit status 2, the message, once.

The quoted messages are what a user reads; on several ranks they must still come once, and end.
"""
import pathlib
import re
import tempfile
import unittest

import exodus_edit
import numpy as np
import scenes

DECK = {
    "mesh": {"file": "blocks.exo"},
    "materials": {"rubber": {"young": 1.0, "poisson": 0.3}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "rubber"},
               "upper": {"blocks": ["upper"], "material": "rubber"}},
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "top": {"set": "upper_top", "x": 0, "y": 0, "z": -0.01}},
    "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top"}},
}


class InvalidMesh(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="abut_meshes_")
        cls.path = pathlib.Path(cls.folder.name)
        cls.mesh = scenes.mesh(cls.path / "blocks.exo", "blocks")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def expect(self, status, output, message):
        """Status 2 and one line 'abut: MESSAGE', however many ranks ran."""
        self.assertEqual(status, 2, output)
        lines = [line for line in output.splitlines() if line.startswith("abut: ")]
        self.assertEqual(len(lines), 1, output)
        self.assertTrue(re.fullmatch(message, lines[0][len("abut: "):]),
                        f"expected {message}\ngot {lines[0]}")

    def check(self, changes, message, files=None, command="check", base=None):
        deck = scenes.merged(scenes.merged(DECK, base or {}), changes)
        result = scenes.run(deck, files=[self.mesh] if files is None else files, check=False,
                            command=command)
        self.expect(result.status, result.output, message)

    def write(self, name, mesh):
        exodus_edit.write(self.path / name, mesh)
        return self.path / name

    def test_the_deck_itself_is_valid(self):
        result = scenes.run(DECK, files=[self.mesh], command="check")
        self.assertIn("the deck is valid", result.output)

    def test_side_set_absent(self):
        self.check({"contact": {"pair": {"primary": "upper_botom"}}},
                   r"\S*scene\.yaml:\d+: contact\.pair\.primary: the mesh has no side set "
                   r"'upper_botom'; valid: lower_bottom, lower_top, .*; "
                   r"did you mean 'upper_bottom'\?")

    def test_displacement_set_absent(self):
        self.check({"displacements": {"top": {"set": "lid"}}},
                   r"\S*scene\.yaml:\d+: displacements\.top\.set: the mesh has no node set or side "
                   r"set 'lid'; valid: lower_bottom, lower_top, (\w+, ){9}upper_y1")

    def test_block_absent(self):
        self.check({"bodies": {"upper": {"blocks": ["uper"]}}},
                   r"\S*scene\.yaml:\d+: bodies\.upper\.blocks: the mesh has no block 'uper'; "
                   r"valid: lower, upper; did you mean 'upper'\?")

    def test_block_in_no_body(self):
        self.check({"bodies": {"upper": None}},
                   r"\S*scene\.yaml:\d+: bodies: block 'upper' of the mesh belongs to no body")

    def test_block_in_two_bodies(self):
        self.check({"bodies": {"upper": {"blocks": ["upper", "lower"]}}},
                   r"\S*scene\.yaml:\d+: bodies\.upper\.blocks: block 'lower' already belongs to "
                   r"body 'lower'")

    def test_mesh_file_missing(self):
        self.check({"mesh": {"file": "absent.exo"}},
                   r"\S*scene\.yaml:\d+: mesh\.file: mesh file '\S*absent\.exo': cannot be read: "
                   r"No such file or directory")

    def test_mesh_file_is_sought_beside_the_deck(self):
        with tempfile.TemporaryDirectory() as elsewhere:
            beside = pathlib.Path(elsewhere) / "decks"
            beside.mkdir()
            line = scenes._launcher(scenes.RANKS) + [scenes.EXECUTABLE, "check", "decks/scene.yaml"]
            scenes._place_deck(DECK, beside)
            (pathlib.Path(elsewhere) / "blocks.exo").write_bytes(self.mesh.read_bytes())
            status, output = scenes.execute(line, 60, elsewhere)
            self.assertEqual(status, 2, output)
            self.assertRegex(output, r"mesh file 'decks/blocks\.exo': cannot be read")
            (beside / "blocks.exo").write_bytes(self.mesh.read_bytes())
            status, output = scenes.execute(line, 60, elsewhere)
            self.assertEqual(status, 0, output)

    def test_mesh_not_exodus(self):
        path = self.path / "text.exo"
        path.write_text("# this is no mesh\n" * 40)
        self.check({"mesh": {"file": "text.exo"}},
                   r"\S*scene\.yaml:\d+: mesh\.file: mesh file '\S*text\.exo': not a readable "
                   r"Exodus II file: .*", files=[path])

    def test_mesh_empty(self):
        path = self.path / "empty.exo"
        path.write_text("")
        self.check({"mesh": {"file": "empty.exo"}},
                   r"\S*scene\.yaml:\d+: mesh\.file: mesh file '\S*empty\.exo': not a readable "
                   r"Exodus II file: .*", files=[path])

    def test_mesh_truncated(self):
        whole = self.mesh.read_bytes()
        for share in (0.02, 0.6, 0.9, 0.98):
            with self.subTest(share=share):
                path = self.path / "short.exo"
                path.write_bytes(whole[:int(share * len(whole))])
                self.check({"mesh": {"file": "short.exo"}},
                           r"\S*scene\.yaml:\d+: mesh\.file: (mesh )?file '\S*short\.exo': .*"
                           r"(not a readable Exodus II file|truncated).*", files=[path])

    def test_inverted_element(self):
        mesh = exodus_edit.read(self.mesh)
        nodes = mesh.blocks[1].nodes
        nodes[4] = nodes[4][[4, 5, 6, 7, 0, 1, 2, 3]]
        path = self.write("inverted.exo", mesh)
        self.check({"mesh": {"file": "inverted.exo"}},
                   r"\S*scene\.yaml:\d+: mesh: element 13 \(HEX8\) of block 'upper' is inside out "
                   r"or degenerate in the mesh: its reference Jacobian has determinant "
                   r"-0\.0046\d*, expected > 0", files=[path])

    def test_element_of_unknown_kind(self):
        mesh = exodus_edit.read(self.mesh)
        mesh.blocks[0].kind = "PYRAMID5"
        mesh.blocks[0].nodes = mesh.blocks[0].nodes[:, :5]
        mesh.side_sets = {}
        path = self.write("pyramid.exo", mesh)
        self.check({"mesh": {"file": "pyramid.exo"}},
                   r".*block 'lower' \(id 1\) has elements of type PYRAMID5 with 5 nodes; valid: "
                   r"HEX8, HEX20, HEX27, TETRA4, TETRA10, WEDGE6", files=[path])

    def test_coordinates_not_finite(self):
        mesh = exodus_edit.read(self.mesh)
        mesh.x[7, 2] = np.nan
        path = self.write("nan.exo", mesh)
        self.check({"mesh": {"file": "nan.exo"}}, r"\S*scene\.yaml:\d+: mesh: element \d+ "
                   r".*determinant nan, expected > 0.*", files=[path])

    def test_free_body_without_support(self):
        self.check({"mesh": {"generate": {"kind": "blocks", "gap": 0.1}},
                    "displacements": {"top": None}},
                   r"\S*scene\.yaml:\d+: bodies\.upper: body 'upper' is free to move: "
                   r"(translation along [xyz]|rotation about [xyz]( through \([^)]*\))?|, )+\. "
                   r"Hold it with 'displacements', or start it in closed contact",
                   base={"mesh": None}, files=[])

    def test_free_body_is_told_by_run_too(self):
        self.check({"displacements": {"bottom": None}},
                   r"\S*scene\.yaml:\d+: bodies\.lower: body 'lower' is free to move: .*",
                   command="run")

    def test_conflicting_displacements(self):
        self.check({"displacements": {"side": {"set": "upper_x0", "fix": ["z"]}}},
                   r"\S*scene\.yaml:\d+: displacements\.side: node \d+ has its z displacement "
                   r"prescribed differently by 'top'")

    def test_unknown_generator_key(self):
        self.check({"mesh": {"generate": {"kind": "blocks", "lower_division": [1, 1, 1]}}},
                   r"\S*scene\.yaml:\d+: mesh\.generate: .*'lower_division'.*'lower_divisions'.*",
                   base={"mesh": None}, files=[])

    def test_unknown_generator(self):
        self.check({"mesh": {"generate": {"kind": "block"}}},
                   r"\S*scene\.yaml:\d+: mesh\.generate: .*'block'.*'blocks'.*",
                   base={"mesh": None}, files=[])

    def refuse_folder(self, folder, message):
        scenes._place_deck(scenes.merged(DECK, {"mesh": {"file": str(self.mesh)}}), self.path)
        line = scenes._launcher(scenes.RANKS) + [scenes.EXECUTABLE, "run", "scene.yaml",
                                                 "--output-dir", folder]
        status, output = scenes.execute(line, 60, self.path)
        self.expect(status, output, message)

    def test_output_folder_cannot_be_made(self):
        # Below a regular file: refused to every user, root too.
        (self.path / "a_file").write_text("")
        self.refuse_folder("a_file/results",
                           r"cannot write to the output folder 'a_file/results': Not a directory")

    def test_output_folder_is_a_file(self):
        (self.path / "a_file").write_text("")
        self.refuse_folder("a_file", r"cannot write to the output folder 'a_file': .+")

    def test_result_file_cannot_be_written(self):
        # A folder stands where the result file should be.
        (self.path / "taken" / "scene.exo").mkdir(parents=True)
        self.refuse_folder("taken", r"'taken/scene\.exo' cannot be written: Is a directory")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
