# SPDX-License-Identifier: BSD-3-Clause
"""Imported models of two cubes, one on the other, whose answers are known.

No Poisson effect and no motion sideways: a neo-Hookean cube of stretch s carries P = E/2 (s - 1/s).
"""
import pathlib
import shutil
import tempfile
import unittest

import numpy

import scenes

CORNERS = [(0, 0), (1, 0), (1, 1), (0, 1)]
LOWER, UPPER = 10.0, 1000.0  # Young's moduli
FACTOR, DOWN = 0.5, 0.1
LOWER_TOP, UPPER_BOTTOM = slice(4, 8), slice(8, 12)

SIDEWAYS = '''<bc name="sideways" node_set="all" type="zero displacement">
      <x_dof>1</x_dof><y_dof>1</y_dof></bc>'''
FLOOR = '''<bc name="floor" node_set="bottom" type="zero displacement"><z_dof>1</z_dof></bc>'''
PRESS = f'''<bc name="press" node_set="top" type="prescribed displacement">
      <dof>z</dof><value lc="1">{-DOWN}</value></bc>'''
TOUCH = f'''<Contact><contact name="touch" surface_pair="pair" type="sliding-facet-on-facet">
      <auto_penalty>1</auto_penalty><penalty>{FACTOR}</penalty><two_pass>1</two_pass>
    </contact></Contact>'''
# Without FEBio's tolerances: the residual decides.
EXACT = "<dtol>0</dtol>"
CONTROL = f'''<Control><time_steps>2</time_steps><step_size>0.5</step_size>
    <solver type="solid">{EXACT}</solver></Control>'''


def cubes(control=CONTROL, boundary=SIDEWAYS + FLOOR + PRESS, more=TOUCH, upper="neo-Hookean"):
    nodes = [(x, y, z) for z in (0, 1, 1, 2) for x, y in CORNERS]
    nodes = "\n".join(f'<node id="{10 * (i + 1)}">{x},{y},{z}</node>'
                      for i, (x, y, z) in enumerate(nodes))
    ids = [str(10 * (i + 1)) for i in range(16)]
    return f'''<?xml version="1.0" encoding="UTF-8"?>
<febio_spec version="4.0"><Module type="solid"/>
  {control}
  <Material>
    <material id="1" name="soft" type="neo-Hookean"><E>{LOWER}</E><v>0</v></material>
    <material id="2" name="hard" type="{upper}"><E>{UPPER}</E><v>0</v></material>
  </Material>
  <Mesh>
    <Nodes name="all">{nodes}</Nodes>
    <Elements type="hex8" name="lower cube"><elem id="7">{",".join(ids[:8])}</elem></Elements>
    <Elements type="hex8" name="upper"><elem id="3">{",".join(ids[8:])}</elem></Elements>
    <NodeSet name="bottom">{",".join(ids[:4])}</NodeSet>
    <NodeSet name="top">{",".join(ids[12:])}</NodeSet>
    <Surface name="below"><quad4 id="1">{",".join(ids[4:8])}</quad4></Surface>
    <Surface name="above"><quad4 id="1">{",".join(reversed(ids[8:12]))}</quad4></Surface>
    <SurfacePair name="pair"><primary>below</primary><secondary>above</secondary></SurfacePair>
  </Mesh>
  <MeshDomains><SolidDomain name="lower cube" mat="soft"/><SolidDomain name="upper" mat="hard"/>
  </MeshDomains>
  <Boundary>{boundary}</Boundary>
  {more}
  <LoadData><load_controller id="1" name="ramp" type="loadcurve"><interpolate>LINEAR</interpolate>
    <points><pt>0,0</pt><pt>1,1</pt></points></load_controller></LoadData>
</febio_spec>
'''


def root(function):
    """The zero of a growing or falling function between 0 and 10."""
    low, high = 1e-9, 10.0
    sign = numpy.sign(function(high))
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if sign * function(middle) > 0 else (middle, high)
    return low


def pressed(penalty=FACTOR * (LOWER + UPPER)):
    """Displacements along z of the lower and the upper face in contact; A/V is 1, and FEBio's two passes
    add up."""
    def stretch(modulus, p):
        return -p / modulus + (1 + (p / modulus)**2)**0.5

    p = root(lambda p: stretch(LOWER, p) + stretch(UPPER, p) - p / penalty - 2 + DOWN)
    return stretch(LOWER, p) - 1, 1 - DOWN - stretch(UPPER, p)


class Cubes(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="abut_cubes_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def imported(self, text):
        file = self.folder / "cubes.feb"
        file.write_text(text)
        status, output = scenes.execute([scenes.EXECUTABLE, "import", str(file), "--output-dir",
                                         str(self.folder)], 60)
        self.assertEqual(status, 0, output)
        return self.folder / "cubes.yaml"

    def run_cubes(self, text):
        deck = self.imported(text)
        deck.write_text(deck.read_text() + "newton: {tolerance: 1e-11}\n")
        return scenes.run(deck, files=[self.folder / "cubes.exo"])

    def expect_pressed(self, uz):
        below, above = pressed()
        self.assertGreater(abs(below - above), 1e-4)  # they overlap
        numpy.testing.assert_allclose(uz[LOWER_TOP], below, rtol=0, atol=1e-10)
        numpy.testing.assert_allclose(uz[UPPER_BOTTOM], above, rtol=0, atol=1e-10)

    def test_two_passes_between_unequal_cubes(self):
        result = self.run_cubes(cubes())
        self.assertEqual(set(result.summary["contact"]), {"touch", "touch_second_pass"})
        self.expect_pressed(result.fields.nodal("displacement_z"))

    def test_contact_of_the_second_step(self):
        """Without contact the upper cube sinks into the lower one, then it is pushed out."""
        result = self.run_cubes(cubes(
            control=f"<Step><step>{CONTROL}</step><step>{CONTROL}{TOUCH}</step></Step>", more=""))
        fields = result.fields
        first = list(fields.times).index(1.0)
        before = fields.nodal("displacement_z", first)
        numpy.testing.assert_allclose(before[LOWER_TOP], 0, atol=1e-12)
        numpy.testing.assert_allclose(before[UPPER_BOTTOM], -DOWN, rtol=1e-10)
        self.assertEqual(fields.times[-1], 2.0)
        self.expect_pressed(fields.nodal("displacement_z"))

    def test_multipliers_of_the_second_step(self):
        touch = TOUCH.replace("<two_pass>1</two_pass>", '''<laugon>AUGLAG</laugon>
          <tolerance>1e-9</tolerance><maxaug>100</maxaug>''')
        fields = self.run_cubes(cubes(
            control=f"<Step><step>{CONTROL}</step><step>{CONTROL}{touch}</step></Step>", more="")).fields
        before = fields.nodal("displacement_z", list(fields.times).index(1.0))
        numpy.testing.assert_allclose(before[LOWER_TOP], 0, atol=1e-12)
        height, _ = pressed(float("inf"))
        uz = fields.nodal("displacement_z")
        numpy.testing.assert_allclose(uz[LOWER_TOP], height, rtol=0, atol=1e-9)
        numpy.testing.assert_allclose(uz[UPPER_BOTTOM], height, rtol=0, atol=1e-9)

    def test_tied_cubes_pulled(self):
        """The tie is a spring between the two: P = PENALTY (above - below)."""
        penalty, up = 50.0, 0.2
        pull = PRESS.replace(f"{-DOWN}", f"{up}")

        def stretch(modulus, p):
            return p / modulus + (1 + (p / modulus)**2)**0.5

        p = root(lambda p: stretch(LOWER, p) + stretch(UPPER, p) + p / penalty - 2 - up)
        for kind in ("tied-node-on-facet", "tied-elastic"):
            tie = f'''<Contact><contact name="tie" surface_pair="pair" type="{kind}">
              <penalty>{penalty}</penalty></contact></Contact>'''
            with self.subTest(kind):
                fields = self.run_cubes(cubes(boundary=SIDEWAYS + FLOOR + pull, more=tie)).fields
                uz = fields.nodal("displacement_z")
                numpy.testing.assert_allclose(uz[LOWER_TOP], stretch(LOWER, p) - 1, rtol=0, atol=1e-10)
                numpy.testing.assert_allclose(uz[UPPER_BOTTOM], 1 + up - stretch(UPPER, p), rtol=0,
                                              atol=1e-10)

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

    def test_rigid_body_goes_down_then_sideways(self):
        def step(dof, value, *held):
            held = "".join(f"<{d}_dof>1</{d}_dof>" for d in held)
            return f'''<step>{CONTROL}<Rigid>
                <rigid_bc name="held" type="rigid_fixed"><rb>hard</rb>{held}</rigid_bc>
                <rigid_bc name="{dof}" type="rigid_displacement"><rb>hard</rb><dof>{dof}</dof>
                  <value lc="1">{value}</value></rigid_bc>
                <rigid_bc name="z" type="rigid_displacement"><rb>hard</rb><dof>z</dof>
                  <value lc="1">{-DOWN}</value></rigid_bc></Rigid></step>'''

        turns = ("Ru", "Rv", "Rw")
        fields = self.run_cubes(cubes(
            control="<Step>" + step("y", 0, "Rx", *turns) + step("x", 0.3, "Ry", *turns) + "</Step>",
            boundary=SIDEWAYS + FLOOR, upper="rigid body")).fields
        first = list(fields.times).index(1.0)
        upper = slice(8, 16)
        numpy.testing.assert_allclose(fields.vector("displacement", first)[upper],
                                      numpy.tile([0, 0, -DOWN], (8, 1)), atol=1e-12)
        numpy.testing.assert_allclose(fields.vector("displacement")[upper],
                                      numpy.tile([0.3, 0, -DOWN], (8, 1)), atol=1e-12)
        below = fields.nodal("displacement_z")[LOWER_TOP]
        self.assertLess(below.max(), -0.01)

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


def dropped(control, cells=6, height=0.05):
    """A rigid cube above a plate of cells x cells elements whose rim is clamped; all with their weight."""
    number = cells + 1
    nodes = [(x / cells * 3, y / cells * 3, z) for z in (-0.25, 0) for y in range(number) for x in range(number)]
    plate = [(o + x + number * y + 1, o + x + 1 + number * y + 1, o + x + 1 + number * (y + 1) + 1,
              o + x + number * (y + 1) + 1) for o in (0, number**2) for y in range(cells) for x in range(cells)]
    bottom, top = plate[:cells**2], plate[cells**2:]
    first = len(nodes) + 1
    nodes += [(1 + x, 1 + y, z + height) for z in (0, 1) for x, y in CORNERS]
    rim = [i + 1 for i, (x, y, _) in enumerate(nodes[:first - 1]) if x in (0, 3) or y in (0, 3)]
    text = "".join(f'<node id="{i}">{x},{y},{z}</node>' for i, (x, y, z) in enumerate(nodes, start=1))
    elements = "".join(f'<elem id="{i}">{",".join(map(str, below + above))}</elem>'
                       for i, (below, above) in enumerate(zip(bottom, top), start=1))
    faces = "".join(f'<quad4 id="{i}">{",".join(map(str, face))}</quad4>' for i, face in enumerate(top, start=1))
    cube = list(range(first, first + 8))
    under = ",".join(map(str, reversed(cube[:4])))
    return f'''<?xml version="1.0" encoding="UTF-8"?>
<febio_spec version="4.0"><Module type="solid"/>{control}
  <Material>
    <material id="1" name="plate" type="neo-Hookean"><density>1</density><E>500</E><v>0.4</v></material>
    <material id="2" name="cube" type="rigid body"><density>1</density></material>
  </Material>
  <Mesh><Nodes name="all">{text}</Nodes>
    <Elements type="hex8" name="plate">{elements}</Elements>
    <Elements type="hex8" name="cube"><elem id="999">{",".join(map(str, cube))}</elem></Elements>
    <NodeSet name="rim">{",".join(map(str, rim))}</NodeSet>
    <Surface name="over">{faces}</Surface><Surface name="under"><quad4 id="1">{under}</quad4></Surface>
    <SurfacePair name="pair"><primary>over</primary><secondary>under</secondary></SurfacePair>
  </Mesh>
  <MeshDomains><SolidDomain name="plate" mat="plate"/><SolidDomain name="cube" mat="cube"/></MeshDomains>
  <Boundary><bc name="rim" node_set="rim" type="zero displacement">
    <x_dof>1</x_dof><y_dof>1</y_dof><z_dof>1</z_dof></bc></Boundary>
  <Rigid><rigid_bc name="guide" type="rigid_fixed"><rb>cube</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof>
    <Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc></Rigid>
  <Loads><body_load name="weight" type="const"><z>1</z></body_load></Loads>
  <Contact><contact name="land" surface_pair="pair" type="sliding-facet-on-facet"><penalty>200</penalty>
    <two_pass>1</two_pass></contact></Contact>
</febio_spec>
'''


class Dropped(unittest.TestCase):
    def run_dropped(self, rule="", steps=60, ranks=None):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="abut_drop_"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        file = folder / "drop.feb"
        file.write_text(dropped(f'''<Control><analysis>DYNAMIC</analysis><time_steps>{steps}</time_steps>
          <step_size>{1.5 / steps}</step_size><solver type="solid">{EXACT}{rule}</solver></Control>'''))
        status, output = scenes.execute([scenes.EXECUTABLE, "import", str(file), "--output-dir", str(folder)], 60)
        self.assertEqual(status, 0, output)
        deck = folder / "drop.yaml"
        deck.write_text(deck.read_text() + "newton: {tolerance: 1e-11}\n")
        return scenes.run(deck, files=[folder / "drop.exo"], ranks=ranks)

    def test_falls_and_bounces(self):
        """The cube falls freely, z = - t^2/2, lands on the plate, and what it loses in height is work of its weight:
        the ledger closes to second order in the step."""
        imbalances = []
        for steps in (60, 120):
            result = self.run_dropped(steps=steps)
            fields = result.fields
            height = numpy.array([fields.globals(k)["cube_displacement_z"] for k in range(len(fields.times))])
            force = numpy.array([fields.globals(k)["land_force_z"] for k in range(len(fields.times))])
            falling = fields.times < 0.25  # 0.05 takes 0.316
            numpy.testing.assert_allclose(height[falling], -0.5 * fields.times[falling]**2, rtol=0, atol=1e-12)
            self.assertTrue((force[falling] == 0).all())
            self.assertGreater(abs(force).max(), 1)  # more than the weight of the cube
            self.assertLess(height.min(), -0.055)    # the plate gives way
            lowest = height.argmin()
            self.assertGreater(height[lowest:].max(), height.min() + 0.02)  # it comes up again
            energy = result.summary["energy"]
            imbalances.append(max(abs(fields.globals(k)["energy_imbalance"]) for k in range(len(fields.times))) / 0.05)
            self.assertGreater(energy["kinetic"] + energy["stored"], 0.01)
        print(f"imbalance over the energy of the fall {imbalances[0]:.1e} {imbalances[1]:.1e}", flush=True)
        self.assertLess(imbalances[1], 0.05)
        self.assertLess(imbalances[1], 0.5 * imbalances[0])

    def test_two_ranks(self):
        one, two = (self.run_dropped("<rhoi>0.7</rhoi>", ranks=n) for n in (1, 2))
        order = [numpy.argsort(r.fields.node_map) for r in (one, two)]
        u = [r.fields.vector("displacement")[o] for r, o in zip((one, two), order)]
        self.assertGreater(abs(u[0]).max(), 0.01)
        numpy.testing.assert_allclose(u[0], u[1], rtol=0, atol=1e-10)


if __name__ == "__main__":
    unittest.main()
