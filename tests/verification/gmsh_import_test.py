#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gmsh meshes become the Exodus meshes that they are; damaged files are refused with their place."""
import pathlib
import re
import tempfile
import unittest

import exodus_edit
import msh_write
import numpy as np
import scenes

CORPUS = pathlib.Path(__file__).resolve().parents[1] / "fuzz" / "corpus"
CELLS = ("hex8", "hex20", "hex27", "tet4", "tet10", "wedge6")


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="abut_gmsh_")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def call(self, *words):
        return scenes.execute([scenes.EXECUTABLE, *map(str, words)], 60, self.path)

    def take(self, file, status=0):
        """Imports a file; the mesh that comes of it and the report."""
        got, text = self.call("import", file, "--output-dir", self.path)
        self.assertEqual(got, status, text)
        if status != 0:
            return text
        stem = self.path / pathlib.Path(file).stem
        return exodus_edit.read(stem.with_suffix(".exo")), stem.with_suffix(".import.txt").read_text()

    def info(self, stem):
        status, text = self.call("mesh", "--info", self.path / f"{stem}.exo")
        self.assertEqual(status, 0, text)
        return text


class Flavours(Case):
    def equal(self, mesh, twin):
        np.testing.assert_array_equal(mesh.x, twin.x)
        self.assertEqual([(b.name, b.kind) for b in mesh.blocks], [(b.name, b.kind) for b in twin.blocks])
        for a, b in zip(mesh.blocks, twin.blocks):
            np.testing.assert_array_equal(a.nodes, b.nodes)
        self.assertEqual(sorted(mesh.side_sets), sorted(twin.side_sets))
        for name, (cells, sides) in twin.side_sets.items():
            expected = sorted(zip(cells, sides))
            self.assertEqual(sorted(zip(*mesh.side_sets[name])), expected, name)
        for name, nodes in twin.node_sets.items():
            self.assertEqual(sorted(mesh.node_sets[name]), sorted(set(nodes)), name)

    def test_each_cell_in_each_flavour_is_its_exodus_twin(self):
        for cell in CELLS:
            twin = exodus_edit.read(scenes.mesh(self.path / "twin.exo", "blocks", lower_divisions=[2, 1, 1],
                                                upper_divisions=[1, 2, 1], element=cell))
            twin.node_sets["two points"] = np.array([0, 3])
            for version, binary in msh_write.FLAVOURS:
                with self.subTest(cell=cell, version=version, binary=binary):
                    mesh, report = self.take(msh_write.write(self.path / "mesh.msh", twin, version, binary))
                    self.equal(mesh, twin)
                    self.assertRegex(report, r"used  (line|byte) \d+  volume group 'lower': block 'lower' of \d+ ")

    def test_the_other_byte_order(self):
        twin = exodus_edit.read(scenes.mesh(self.path / "twin.exo", "box", divisions=[2, 1, 1]))
        swap = msh_write.struct.pack
        for version in ("2.2", "4.1"):
            try:
                msh_write.struct.pack = lambda kinds, *values: swap(">" + kinds[1:], *values)
                file = msh_write.write(self.path / "mesh.msh", twin, version, True)
            finally:
                msh_write.struct.pack = swap
            self.equal(self.take(file)[0], twin)


class MadeByGmsh(Case):
    """Files of tests/fuzz/corpus, written by Gmsh 4.8: one or two cells of known size and orientation."""

    def test_middle_nodes_lie_between_their_corners(self):
        for stem, kind in (("hex27", "HEX27"), ("hex20", "HEX20"), ("tet10", "TETRA10")):
            mesh, _ = self.take(CORPUS / f"{stem}.msh")
            block = mesh.blocks[0]
            self.assertEqual(block.kind, kind)
            edges = {"H": [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7),
                           (7, 4)],
                     "T": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]}[kind[0]]
            corners = 8 if kind[0] == "H" else 4
            middles = edges + [range(8), (0, 1, 2, 3), (4, 5, 6, 7), (0, 3, 4, 7), (1, 2, 5, 6), (0, 1, 4, 5),
                               (2, 3, 6, 7)] * (kind == "HEX27")
            for nodes in block.nodes:
                expected = [mesh.x[nodes[list(m)]].mean(axis=0) for m in middles]
                np.testing.assert_allclose(mesh.x[nodes[corners:]], expected, atol=1e-9)

    def test_volumes_and_areas(self):
        for stem, volume, areas in (("hex27", 6, {"top": 2, "bottom": 2}), ("hex20", 6, {"top": 2, "bottom": 2}),
                                    ("tet10", 2, {"floor": 2, "slope": 22 ** 0.5}),
                                    ("wedge6", 6, {"roof": 2, "side": 6, "all": 4 + 12 + 6 * 2 ** 0.5})):
            self.take(CORPUS / f"{stem}.msh")
            text = self.info(stem)
            self.assertAlmostEqual(float(re.search(r"volume (\S+)", text)[1]), volume, places=5)
            for name, area in areas.items():
                self.assertAlmostEqual(float(re.search(rf"side set {name}: .*area ([^;\s]+)", text)[1]), area, places=4)

    def test_points_and_curves_are_node_sets(self):
        mesh, report = self.take(CORPUS / "tet10.msh")
        np.testing.assert_array_equal(mesh.x[mesh.node_sets["tip"]], [[0, 0, 3]])
        mesh, report = self.take(CORPUS / "hex27.msh")
        self.assertEqual(len(mesh.node_sets["edge"]), 3)
        self.assertIn("used  line 128  curve group 'edge': node set 'edge' of 3 nodes\n", report)

    def test_a_deck_to_start_from(self):
        self.take(CORPUS / "wedge6.msh")
        deck = self.path / "wedge6.yaml"
        text = deck.read_text()
        self.assertIn("#   roof: 1 faces\n", text)
        self.assertEqual(text.count("FILL IN"), 3)
        status, output = self.call("check", deck)
        self.assertEqual(status, 2, output)
        self.assertIn("body 'wedges' is free to move", output)
        deck.write_text(text.replace("# displacements:\n", "displacements: {foot: {set: all, fix: [x, y, z]}}\n"))
        kept = deck.read_text()
        status, output = self.call("import", CORPUS / "wedge6.msh", "--output-dir", self.path)
        self.assertIn("stays as it is", output)
        self.assertEqual(deck.read_text(), kept)
        status, output = self.call("run", deck, "--output-dir", self.path, "--quiet")
        self.assertEqual((status, output), (0, ""))


ONE = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
6
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
5 1 1 1
9 7 7 7
$EndNodes
$Elements
3
1 4 2 0 1 1 2 3 4
2 4 2 0 2 2 3 4 5
3 2 2 0 8 1 3 2
$EndElements
"""


class Parts(Case):
    def of(self, *changes, text=ONE):
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        file = self.path / "one.msh"
        file.write_text(text)
        return file

    def test_without_groups_each_volume_is_a_block_and_each_surface_a_side_set(self):
        mesh, report = self.take(self.of())
        self.assertEqual([b.name for b in mesh.blocks], ["volume_1", "volume_2"])
        self.assertEqual(sorted(mesh.side_sets), ["surface_8"])
        self.assertIn("ignored  line 4  $Nodes: 1 nodes that belong to no volume\n", report)
        np.testing.assert_array_equal(mesh.node_map, [1, 2, 3, 4, 5])

    def test_with_groups_only_some_have_names(self):
        named = ("$Nodes", '$PhysicalNames\n1\n3 7 "steel rod"\n$EndPhysicalNames\n$Nodes')
        mesh, report = self.take(self.of(("1 4 2 0 1", "1 4 2 7 1"), ("3 2 2 0 8", "3 2 2 5 8"), named))
        self.assertEqual([b.name for b in mesh.blocks], ["steel rod", "volume_2"])
        self.assertEqual(sorted(mesh.side_sets), ["surface_5"])
        self.assertIn('steel_rod: {blocks: ["steel rod"]', (self.path / "one.yaml").read_text())
        self.assertIn("volume 2 of no group: block 'volume_2' of 1 TETRA4\n", report)

    def test_an_element_in_two_groups_goes_to_the_first(self):
        twice = ("3\n1 4 2 0 1", "4\n1 4 2 6 1"), ("2 4 2 0 2", "7 4 2 7 1 1 2 3 4\n2 4 2 7 2")
        mesh, report = self.take(self.of(*twice))
        self.assertEqual([(b.name, len(b.nodes)) for b in mesh.blocks], [("volume_6", 1), ("volume_7", 1)])
        self.assertIn("ignored  line 16  volume group 'volume_7': 1 elements that are in the block of another group "
                      "already\n", report)

    def test_a_face_between_two_elements_is_told(self):
        _, report = self.take(self.of(("1 3 2\n", "2 3 4\n")))
        self.assertIn("side set and node set 'surface_8' of 1 faces, 1 of them between two elements", report)

    def test_a_face_of_no_volume_is_told(self):
        _, report = self.take(self.of(("1 3 2\n", "1 3 9\n")))
        self.assertIn("ignored  line 17  surface 8 of no group: 1 faces that are no side of a volume\n", report)

    def refused(self, message, *changes):
        text = self.take(self.of(*changes), status=2)
        self.assertRegex(text, r"(?m)^abut: \S*one\.msh:" + message)

    def test_wrong_files(self):
        self.refused(r"2: \$MeshFormat: expected version 4\.1 or 2\.2, got '4'; save it as", ("2.2 0 8", "4 0 8"))
        self.refused(r"4: expected the beginning of a section, as \$Nodes, got 'Nodes'", ("$Nodes", "Nodes"))
        self.refused(r"15: \$Elements: elements of Gmsh's type 99 are not known", ("1 4 2 0 1", "1 99 2 0 1"))
        self.refused(r"15: pyramid of 5 nodes: 1 of them, which abut lacks; it has hexahedra",
                     ("1 4 2 0 1 1 2 3 4", "1 7 2 0 1 1 2 3 4 5"))
        self.refused(r"16: \$Elements: element 2 has node 8, which is not among the nodes", ("2 3 4 5", "2 3 4 8"))
        self.refused(r"16: \$Elements: element 2 has node 3 twice", ("2 3 4 5", "2 3 4 3"))
        self.refused(r"15: \$Elements: this element of block 'volume_1' is inside out or degenerate",
                     ("0 1 1 2 3 4", "0 1 2 1 3 4"))
        self.refused(r"4: \$Nodes: there are two nodes 3", ("4 0 0 1", "3 0 0 1"))
        self.refused(r"7: \$Nodes: expected a coordinate, got 'nan'", ("2 1 0 0", "2 nan 0 0"))
        self.refused(r"5: \$Nodes: expected a number of nodes, got 9000000000, for which the file is too short",
                     ("\n6\n", "\n9000000000\n"))
        self.refused(r"13: \$Elements: no element has a volume", ("3\n1 4 2 0 1 1 2 3 4\n2 4 2 0 2 2 3 4 5\n", "1\n"))
        self.refused(r"4: \$Nodes: expected \$MeshFormat first", ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "$Comments\n"
                                                                 "$EndComments\n\n"))
        self.refused(r"19: the file ends without a section \$Elements", ("$Elements", "$Comments"),
                     ("$EndElements", "$EndComments"))

    def test_a_file_that_is_no_msh(self):
        self.refused("1: expected a Gmsh file, which begins with", (ONE, "solid\n"))


class Truncated(Case):
    def test_wherever_a_file_ends_it_is_refused_with_the_place(self):
        for stem, unit in (("hex27", r":\d+"), ("wedge6", r":\d+"), ("hex20", r": byte \d+"),
                           ("tet10", r": byte \d+")):
            whole = (CORPUS / f"{stem}.msh").read_bytes()
            for share in (0.02, 0.2, 0.5, 0.75, 0.9, 0.97):
                with self.subTest(stem=stem, share=share):
                    file = self.path / "short.msh"
                    file.write_bytes(whole[:int(share * len(whole))])
                    text = self.take(file, status=2)
                    place = r":( byte )?\d+" if share < 0.1 else unit  # the kind of file may not be known yet
                    self.assertRegex(text, rf"(?m)^abut: \S*short\.msh{place}: .*")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
