# SPDX-License-Identifier: BSD-3-Clause
"""The Python package reads back what was written, and draws what is in front."""
import json
import os
import pathlib
import sys
import tempfile
import unittest

import numpy as np

import exodus_edit

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "apps" / "python"))
import result_file
from abut import history, raster, scene, skin, summary
from abut.errors import InputError
from abut.results import Results


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class OneFile(Folder):
    def setUp(self):
        super().setUp()
        self.mesh = result_file.pressed_bricks(self.folder / "two.exo")
        self.results = Results(self.folder / "two.exo")

    def test_mesh(self):
        np.testing.assert_array_equal(self.results.coordinates, self.mesh.x)
        np.testing.assert_array_equal(self.results.connectivity("upper"), self.mesh.blocks[1].nodes)
        np.testing.assert_array_equal(self.results.node_map, self.mesh.node_map)
        np.testing.assert_array_equal(self.results.node_set("foot"), np.arange(4))
        self.assertEqual((self.results.blocks, self.results.kind("lower"), self.results.num_elements),
                         (["lower", "upper"], "HEX8", 2))

    def test_fields_of_first_and_last_step(self):
        np.testing.assert_array_equal(self.results.times, [0, 1])
        self.assertEqual(self.results.nodal("contact_pressure", 0).max(), 0)
        self.assertEqual(self.results.nodal("contact_pressure").sum(), 8 * 3)
        np.testing.assert_array_equal(self.results.vector("displacement")[8], [0, 0, -0.25])
        np.testing.assert_array_equal(self.results.element("von_mises", "upper"), [5])
        self.assertEqual(self.results.globals()["newton_iterations"], 9)
        np.testing.assert_array_equal(history.of_results(self.results)["press_force_z"], [0, 3])

    def test_what_is_not_there_is_named(self):
        for ask, words in ((lambda: self.results.nodal("presure"), "presure.*contact_pressure"),
                           (lambda: self.results.nodal("contact_gap", 2), "holds 2 steps"),
                           (lambda: self.results.connectivity("middle"), "middle.*lower, upper"),
                           (lambda: Results(self.folder / "none.exo"), "none.exo.*no such file")):
            with self.assertRaisesRegex(InputError, words):
                ask()

    def test_step_that_was_not_written_in_full_is_left_out(self):
        mesh, *_ = result_file.bricks()
        exodus_edit.write(self.folder / "many.exo", mesh)
        result_file.put_fields(self.folder / "many.exo", [0, 1], {f"field{i}": np.full((2, 16), i) for i in range(200)})
        whole, step = (self.folder / "many.exo").read_bytes(), 200 * 16 * 8
        cut = self.folder / "cut.exo"
        cut.write_bytes(whole[:-step])
        results = Results(cut)
        np.testing.assert_array_equal(results.times, [0])
        self.assertEqual(results.nodal("field7").max(), 7)
        with self.assertRaisesRegex(InputError, "holds 1 steps"):
            results.nodal("field7", 1)
        cut.write_bytes(whole[:len(whole) // 3])
        with self.assertRaisesRegex(InputError, "cut.exo: is damaged"):
            Results(cut)

    def test_scene_knows_pressed_faces_alone(self):
        model = scene.read(self.results)
        self.assertEqual(len(model.skin), 12)
        pressed = model.skin.part(model.pressed)
        self.assertEqual(sorted(map(sorted, pressed.corners.tolist())), [[4, 5, 6, 7], [8, 9, 10, 11]])
        np.testing.assert_array_equal(model.von_mises[model.skin.block == 1], 5)
        self.assertEqual(model.x[15, 2], 2.75)


class RankFiles(Folder):
    def setUp(self):
        super().setUp()
        # Rank 0 has the lower brick, rank 1 the upper one and a copy of node 27 (index 2).
        for rank, nodes in enumerate((np.arange(8), np.r_[15:7:-1, 2])):
            mesh, *_ = result_file.bricks()
            block = mesh.blocks[rank]
            local = [int(np.flatnonzero(nodes == n)[0]) for n in block.nodes[0]]
            blocks = [exodus_edit.Block(b.name, b.id, "HEX8", np.array([local]) if b is block else np.zeros((0, 8), int))
                      for b in mesh.blocks]
            part = exodus_edit.ExodusMesh(mesh.x[nodes], blocks, {"foot": np.flatnonzero(nodes < 4)})
            part.node_map = mesh.node_map[nodes]
            path = self.folder / f"two.exo.2.{rank}"
            exodus_edit.write(path, part)
            result_file.put_fields(path, [0, 1], {"number": np.stack([0 * nodes, nodes])}, None,
                                   {"steps": np.array([0.0, 1])})

    def test_parts_are_one_mesh(self):
        mesh, *_ = result_file.bricks()
        for name in ("two.exo", "two.exo.2.0", "two.exo.2.1"):
            with self.subTest(name):
                results = Results(self.folder / name)
                self.assertEqual(len(results.parts), 2)
                np.testing.assert_array_equal(results.node_map, mesh.node_map)
                np.testing.assert_array_equal(results.coordinates, mesh.x)
                np.testing.assert_array_equal(results.nodal("number"), np.arange(16))
                for block in mesh.blocks:
                    np.testing.assert_array_equal(results.connectivity(block.name), block.nodes)
                np.testing.assert_array_equal(results.node_set("foot"), np.arange(4))

    def test_missing_part_is_named(self):
        (self.folder / "two.exo.2.1").unlink()
        with self.assertRaisesRegex(InputError, r"missing: two\.exo\.2\.1"):
            Results(self.folder / "two.exo")


class Skins(unittest.TestCase):
    def test_faces_inside_are_none(self):
        class Cells:
            blocks = ["cells"]

            def __init__(self, cells):
                self.cells = np.array(cells)

            def connectivity(self, _):
                return self.cells

        hexes = Cells([range(8), [*range(4, 8), *range(8, 12)]])
        self.assertEqual(len(skin.outer_faces(hexes)), 10)
        tets = skin.outer_faces(Cells([(0, 1, 2, 3), (0, 2, 1, 4)]))  # they share 0, 1, 2
        self.assertEqual(len(tets), 6)
        wedges = Cells([range(6), [3, 4, 5, 6, 7, 8]])
        self.assertEqual(len(skin.outer_faces(wedges)), 8)
        tet10 = skin.outer_faces(Cells([range(10)]))
        first = np.flatnonzero((np.sort(tet10.corners, axis=1) == [0, 1, 3, 3]).all(axis=1))[0]
        self.assertEqual(tet10.middles[first].tolist(), [4, 8, -1, 7])

    def test_normals_point_out(self):
        corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        x = np.array([(*c, z) for z in (-1, 1) for c in corners], float)
        for table, nodes in ((skin.HEX, x), (skin.TET, np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.0)])),
                             (skin.WEDGE, np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1.0)]))):
            faces = nodes[np.array(table)]
            outward = np.einsum("fd,fd->f", skin.normals(faces), faces.mean(axis=1) - nodes.mean(axis=0))
            self.assertTrue((outward > 0).all())


class Raster(unittest.TestCase):
    VIEW = raster.View((0, 0, 1), (0, 1, 0))

    def square(self, half, z):
        return np.array([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)], float)

    def test_nearer_face_is_seen_and_every_pixel_of_it(self):
        faces = np.stack([self.square(4, 0), self.square(1, 1), self.square(2, -1)])
        frame = raster.Frame(-5, -5, 0.1, 100, 100)
        for order in ([0, 1, 2], [2, 1, 0], [1, 0, 2]):
            seen = raster.look(self.VIEW.project(faces[order]), None, frame)
            count = [(seen.face == order.index(i)).sum() for i in range(3)]
            self.assertEqual(count, [80 * 80 - 20 * 20, 20 * 20, 0])

    def test_face_much_larger_than_the_picture(self):
        faces = np.stack([self.square(3000, 0), self.square(1, 1)])
        frame = raster.Frame(-2, -2, 0.04, 100, 100)
        for bulges in (None, np.zeros((2, 4, 3))):
            seen = raster.look(self.VIEW.project(faces), bulges, frame)
            self.assertEqual([(seen.face == i).sum() for i in range(2)], [100 * 100 - 50 * 50, 50 * 50])
            x = raster.between_corners(seen, faces[:, :, 0])
            np.testing.assert_allclose(x, np.tile((np.arange(100) + 0.5) * 0.04 - 2, (100, 1)), atol=0.022)

    def test_back_is_not_seen_and_values_are_those_of_the_place(self):
        face = self.square(1, 0)[None]
        frame = raster.Frame(-1, -1, 0.02, 100, 100)
        self.assertEqual((raster.look(self.VIEW.project(face[:, ::-1]), None, frame).face >= 0).sum(), 0)
        seen = raster.look(self.VIEW.project(face), None, frame)
        values = raster.between_corners(seen, face[:, :, 0])
        np.testing.assert_allclose(values, np.tile((np.arange(100) + 0.5) * 0.02 - 1, (100, 1)), atol=0.011)
        corner = raster.nearest_corner(seen, np.arange(4)[None])
        self.assertEqual([corner[9, 9], corner[9, 90], corner[90, 90], corner[90, 9]], [0, 1, 2, 3])

    def test_curved_edge(self):
        face, bulge = self.square(1, 0)[None], np.zeros((1, 4, 3))
        bulge[0, 0, 1] = -0.5  # the lower edge hangs down: 2/3 of 0.5 times 2 more area
        frame = raster.Frame(-2, -2, 0.01, 400, 400)
        seen = raster.look(self.VIEW.project(face), self.VIEW.project(bulge), frame)
        self.assertAlmostEqual((seen.face >= 0).sum() * 1e-4, 4 + 2 / 3, delta=0.05)


class Histories(Folder):
    def test_columns_and_a_line_cut_off(self):
        path = self.folder / "run.history.csv"
        path.write_text("t,press_force_z\n0,0\n0.5,1e-3\n1,2")
        np.testing.assert_array_equal(history.read(path)["press_force_z"], [0, 1e-3, 2])
        path.write_text("t,press_force_z\n0,0\n0.5")
        np.testing.assert_array_equal(history.read(path)["t"], [0])
        path.write_text("t,a\n")
        self.assertEqual(len(history.read(path)["a"]), 0)
        for text in ("x,y\n1,2\n", "", "t,a\n0,b\n1,2\n"):
            path.write_text(text)
            with self.assertRaises(InputError):
                history.read(path)
        self.assertEqual(history.path_of("out/run.exo.4.0").name, "run.history.csv")


class Summaries(Folder):
    def put(self, name, seconds, **keys):
        (self.folder / name).write_text(json.dumps({"status": "converged", "deck": "blocks.yaml", **keys}))
        os.utime(self.folder / name, (seconds, seconds))

    def test_the_newest_that_names_the_results(self):
        self.assertIsNone(summary.find(self.folder / "blocks.exo"))
        self.put("old.json", 1, results="blocks.exo")
        self.put("new.json", 2, results="blocks.exo")
        self.put("other.json", 3, results="balls.exo")
        self.put("blocks.json", 4)
        (self.folder / "list.json").write_text("[1]")
        (self.folder / "broken.json").write_text("{")
        self.assertEqual(summary.find(self.folder / "blocks.exo").name, "new.json")
        self.assertEqual(summary.find(self.folder / "blocks.exo.4.2").name, "new.json")
        self.assertIsNone(summary.find(self.folder / "cubes.exo"))
        for name in ("new.json", "old.json"):
            (self.folder / name).unlink()
        self.assertEqual(summary.find(self.folder / "blocks.exo").name, "blocks.json")
        for name in ("list.json", "broken.json", "none.json"):
            with self.assertRaisesRegex(InputError, name):
                summary.read(self.folder / name)


if __name__ == "__main__":
    unittest.main()
