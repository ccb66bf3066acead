# SPDX-License-Identifier: BSD-3-Clause
"""Imported models of two cubes in one step."""
import unittest

import numpy

import scenes
from febio_cubes import (CONTROL, DOWN, FACTOR, FLOOR, LOWER, LOWER_TOP, PRESS, SIDEWAYS, UPPER,
                         UPPER_BOTTOM, Case, cubes, cubes_of_2_0, root, shell_on_cube, stretched)


class Cubes(Case):
    def test_names_fit_the_deck(self):
        deck = self.imported(cubes().replace('"touch"', '"' + 230 * "t" + '"'))
        self.assertIn("\n  " + 190 * "t" + ":", deck.read_text())

    def test_what_was_not_imported_stays(self):
        self.imported(cubes())
        self.imported(cubes())  # once more
        for name, what in (("cubes.yaml", "the imported deck would overwrite"),
                           ("cubes.exo", "the mesh would overwrite")):
            whole = (self.folder / name).read_bytes()
            (self.folder / name).write_text("title: mine\n")
            status, output = scenes.execute([scenes.EXECUTABLE, "import", str(self.folder / "cubes.feb"),
                                             "--output-dir", str(self.folder)], 60)
            self.assertEqual(status, 2, output)
            self.assertIn(f"abut: {what} '{self.folder / name}', which ", output)
            self.assertEqual((self.folder / name).read_text(), "title: mine\n")
            (self.folder / name).write_bytes(whole)

    def test_two_passes_between_unequal_cubes(self):
        result = self.run_cubes(cubes())
        self.assertEqual(set(result.summary["contact"]), {"touch", "touch_second_pass"})
        self.expect_pressed(result.fields.nodal("displacement_z"))

    def test_old_files_are_the_same_model(self):
        result = self.run_cubes(cubes_of_2_0())
        self.assertEqual(set(result.summary["contact"]), {"touch", "touch_second_pass"})
        self.expect_pressed(result.fields.nodal("displacement_z"))

    def test_rigid_sheet_pushes_a_cube(self):
        """p = E/2 (1/s - s) of the cube is the penalty, FACTOR E A/V, times what the sheet sinks in."""
        uz = self.run_cubes(shell_on_cube()).fields.nodal("displacement_z")
        p = root(lambda p: stretched(LOWER, -p) - p / (FACTOR * LOWER) - (1 - DOWN))
        self.assertGreater(p, 0.1)
        numpy.testing.assert_allclose(uz[LOWER_TOP], stretched(LOWER, -p) - 1, rtol=0, atol=1e-10)
        numpy.testing.assert_allclose(uz[8:], -DOWN, rtol=0, atol=1e-12)

    def test_tied_cubes_pulled(self):
        """The tie is a spring between the two: P = PENALTY (above - below)."""
        penalty, up = 50.0, 0.2
        pull = PRESS.replace(f"{-DOWN}", f"{up}")

        p = root(lambda p: stretched(LOWER, p) + stretched(UPPER, p) + p / penalty - 2 - up)
        for kind in ("tied-node-on-facet", "tied-elastic"):
            tie = f'''<Contact><contact name="tie" surface_pair="pair" type="{kind}">
              <penalty>{penalty}</penalty></contact></Contact>'''
            with self.subTest(kind):
                fields = self.run_cubes(cubes(boundary=SIDEWAYS + FLOOR + pull, more=tie)).fields
                uz = fields.nodal("displacement_z")
                numpy.testing.assert_allclose(uz[LOWER_TOP], stretched(LOWER, p) - 1, rtol=0, atol=1e-10)
                numpy.testing.assert_allclose(uz[UPPER_BOTTOM], 1 + up - stretched(UPPER, p), rtol=0,
                                              atol=1e-10)

    def test_sticky_cubes(self):
        """Pressed and pulled apart again, or pulled only: what has touched holds, up to its strength."""
        penalty, up = 50.0, 0.15
        p = root(lambda p: stretched(LOWER, p) + stretched(UPPER, p) + p / penalty - 2 - up)
        self.assertGreater(p, 1.0)
        press = [(0, 0), (1, -DOWN), (2, up)]
        for course, more, holds in ((press, "", True), (press, "<max_traction>5</max_traction>", True),
                                    (press, "<max_traction>1</max_traction>", False),
                                    ([(0, 0), (2, up)], "", False),
                                    ([(0, 0), (2, up)], "<snap_tol>0.01</snap_tol>", True)):
            with self.subTest(course=course, more=more):
                stick = f'''<Contact><contact name="glue" surface_pair="pair" type="sticky">
                  <penalty>{penalty}</penalty>{more}</contact></Contact>'''
                text = cubes(boundary=SIDEWAYS + FLOOR + PRESS.replace(f"{-DOWN}", "1"), more=stick,
                             control=CONTROL.replace(">2<", ">4<"))
                points = "".join(f"<pt>{t},{z}</pt>" for t, z in course)
                fields = self.run_cubes(text.replace("<pt>0,0</pt><pt>1,1</pt>", points)).fields
                if course == press:
                    before = fields.nodal("displacement_z", list(fields.times).index(1.0))
                    self.assertLess(before[LOWER_TOP].max(), -0.05)
                uz = fields.nodal("displacement_z")
                numpy.testing.assert_allclose(uz[LOWER_TOP], stretched(LOWER, p) - 1 if holds else 0,
                                              rtol=0, atol=1e-9)
                numpy.testing.assert_allclose(uz[UPPER_BOTTOM],
                                              1 + up - stretched(UPPER, p) if holds else up, rtol=0,
                                              atol=1e-9)

    def test_traction_per_current_area(self):
        """With Poisson's ratio a pull on a free cube narrows the face that it acts on."""
        traction = f'''<Loads><surface_load name="pull" surface="roof" type="traction">
          <traction>0,0,4</traction>{{}}</surface_load></Loads>'''
        roof = '<Surface name="roof"><quad4 id="1">50,60,70,80</quad4></Surface><SurfacePair'
        planes = "".join(f'''<bc name="{axis}" node_set="side{axis}" type="zero displacement">
          <{axis}_dof>1</{axis}_dof></bc>''' for axis in "xy")
        sets = '<NodeSet name="sidex">10,40,50,80</NodeSet><NodeSet name="sidey">10,20,50,60</NodeSet>'
        still = '''<bc name="still" node_set="upper" type="zero displacement">
          <x_dof>1</x_dof><y_dof>1</y_dof><z_dof>1</z_dof></bc>'''
        nu = 0.3
        mu, lame = LOWER / (2 * (1 + nu)), LOWER * nu / ((1 + nu) * (1 - 2 * nu))
        for linear in ("", "<linear>1</linear>"):
            text = cubes(boundary=FLOOR + planes + still, more=traction.format(linear))
            text = text.replace("<SurfacePair", roof, 1).replace("<v>0</v>", f"<v>{nu}</v>", 1)
            text = text.replace("<NodeSet", sets + '<NodeSet name="upper">90:160:10</NodeSet><NodeSet', 1)
            u = self.run_cubes(text).fields.vector("displacement")[6]  # the corner (1, 1, 1)
            width, length = 1 + u[0], 1 + u[2]
            j = width**2 * length
            stress = (mu * (length**2 - 1) + lame * numpy.log(j)) / j
            across = (mu * (width**2 - 1) + lame * numpy.log(j)) / j
            with self.subTest(linear=linear):
                self.assertLess(width, 0.95)
                self.assertAlmostEqual(across, 0, delta=1e-8)
                self.assertAlmostEqual(stress * (width**2 if linear else 1), 4, delta=1e-8)

    def test_wall_comes_down(self):
        """A plane z = 1 - DOWN t whose normal points down; P = PENALTY (height - place)."""
        penalty = 200.0
        wall = f'''<Constraints><constraint type="rigid_wall" surface="below">
          <penalty>{penalty}</penalty><offset lc="1">{DOWN}</offset><plane>0,0,-1,-1</plane>
          </constraint></Constraints>'''
        hung = '''<bc name="hung" node_set="top" type="zero displacement"><z_dof>1</z_dof></bc>'''
        fields = self.run_cubes(cubes(boundary=SIDEWAYS + FLOOR + hung, more=wall)).fields
        height = root(lambda s: LOWER / 2 * (1 / s - s) - penalty * (s - 1 + DOWN))
        self.assertLess(height, 1 - 0.9 * DOWN)
        numpy.testing.assert_allclose(fields.nodal("displacement_z")[LOWER_TOP], height - 1, rtol=0,
                                      atol=1e-10)

    def test_mesh_opens_in_vtk(self):
        try:
            import vtk
        except ImportError:
            self.skipTest("VTK is not there")
        self.imported(cubes())
        reader = vtk.vtkExodusIIReader()
        reader.SetFileName(str(self.folder / "cubes.exo"))
        reader.UpdateInformation()
        found = {}
        for key, kind in (("blocks", vtk.vtkExodusIIReader.ELEM_BLOCK),
                          ("node sets", vtk.vtkExodusIIReader.NODE_SET),
                          ("side sets", vtk.vtkExodusIIReader.SIDE_SET)):
            names = [reader.GetObjectName(kind, i)
                     for i in range(reader.GetNumberOfObjects(kind))]
            found[key] = sorted(name.split(" ID: ")[0].strip() for name in names)
            for i in range(len(names)):
                reader.SetObjectStatus(kind, i, 1)
        reader.Update()
        self.assertEqual(found, {"blocks": ["lower cube", "upper"],
                                 "node sets": ["all", "bottom", "top"],
                                 "side sets": ["above", "below"]})
        pieces = {}
        output = reader.GetOutput()
        for i in range(output.GetNumberOfBlocks()):
            group = output.GetBlock(i)
            for k in range(group.GetNumberOfBlocks() if group else 0):
                name = group.GetMetaData(k).Get(vtk.vtkCompositeDataSet.NAME())
                pieces[name.split(" ID: ")[0].strip()] = group.GetBlock(k).GetNumberOfCells()
        self.assertEqual(pieces, {"lower cube": 1, "upper": 1, "all": 16, "bottom": 4, "top": 4,
                                  "above": 1, "below": 1})


if __name__ == "__main__":
    unittest.main()
