# SPDX-License-Identifier: BSD-3-Clause
"""FEBio models of two cubes, one on the other, whose answers are known, and what imports and runs them.

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


# Words of before 3.0.
OLD_PRIMARY, OLD_SECONDARY = "sla" "ve", "ma" "ster"


def cubes_of_2_0():
    """The cubes with their two passes in the words of specification 2.0: nodes and faces where they are used."""
    nodes = [(x, y, z) for z in (0, 1, 1, 2) for x, y in CORNERS]
    ids = [str(10 * (i + 1)) for i in range(16)]

    def listed(numbers, value=""):
        return "".join(f'<node id="{i}">{value}</node>' for i in numbers)

    text = "".join(f'<node id="{i}">{x},{y},{z}</node>' for i, (x, y, z) in zip(ids, nodes))
    return f'''<?xml version="1.0" encoding="UTF-8"?>
<febio_spec version="2.0">
  <Control><time_steps>2</time_steps><step_size>0.5</step_size><dtol>0</dtol><lstol>0.9</lstol>
    <analysis type="static"/></Control>
  <Material>
    <material id="1" type="neo-Hookean"><E>{LOWER}</E><v>0</v></material>
    <material id="2" type="neo-Hookean"><E>{UPPER}</E><v>0</v></material>
  </Material>
  <Geometry><Nodes>{text}</Nodes>
    <Elements type="hex8" mat="1"><elem id="7">{",".join(ids[:8])}</elem></Elements>
    <Elements type="hex8" mat="2"><elem id="3">{",".join(ids[8:])}</elem></Elements>
  </Geometry>
  <Boundary><fix bc="xy">{listed(ids)}</fix><fix bc="z">{listed(ids[:4])}</fix>
    <prescribe bc="z" lc="1" scale="{-DOWN}">{listed(ids[12:], 1)}</prescribe></Boundary>
  <Contact><contact name="touch" type="facet-to-facet sliding">
    <auto_penalty>1</auto_penalty><penalty>{FACTOR}</penalty><two_pass>1</two_pass>
    <surface type="{OLD_SECONDARY}"><quad4 id="1">{",".join(reversed(ids[8:12]))}</quad4></surface>
    <surface type="{OLD_PRIMARY}"><quad4 id="1">{",".join(ids[4:8])}</quad4></surface></contact></Contact>
  <LoadData><loadcurve id="1" type="linear"><loadpoint>0,0</loadpoint><loadpoint>1,1</loadpoint></loadcurve></LoadData>
</febio_spec>
'''


def shell_on_cube():
    """A rigid sheet of one quad4 that pushes the lower cube down by DOWN."""
    text = cubes(upper="rigid body", boundary=SIDEWAYS + FLOOR)
    ids = [str(10 * (i + 1)) for i in range(16)]
    text = text.replace(f'<Elements type="hex8" name="upper"><elem id="3">{",".join(ids[8:])}</elem>',
                        f'<Elements type="quad4" name="upper"><elem id="3">{",".join(ids[8:12])}</elem>')
    text = text.replace('<SolidDomain name="upper" mat="hard"/>', '<ShellDomain name="upper" mat="hard"/>')
    text = text.replace("<two_pass>1</two_pass>", "<two_pass>0</two_pass>")
    return text.replace("<Contact>", """<Rigid><rigid_bc name="push" type="rigid_displacement"><rb>hard</rb>
      <dof>z</dof><value lc="1">%s</value></rigid_bc><rigid_bc name="guide" type="rigid_fixed"><rb>2</rb>
      <Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof><Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>
      </Rigid><Contact>""" % -DOWN)


def root(function):
    """The zero of a growing or falling function between 0 and 10."""
    low, high = 1e-9, 10.0
    sign = numpy.sign(function(high))
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if sign * function(middle) > 0 else (middle, high)
    return low


def stretched(modulus, p):
    """Stretch of a cube under nominal stress p."""
    return p / modulus + (1 + (p / modulus)**2)**0.5


def pressed(penalty=FACTOR * (LOWER + UPPER)):
    """Displacements along z of the lower and the upper face in contact; A/V is 1, and FEBio's two passes
    add up."""
    p = root(lambda p: stretched(LOWER, -p) + stretched(UPPER, -p) - p / penalty - 2 + DOWN)
    return stretched(LOWER, -p) - 1, 1 - DOWN - stretched(UPPER, -p)


class Case(unittest.TestCase):
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

    def run_cubes(self, text, check=True):
        """With abut's own test of convergence, and a sharp one."""
        deck = self.imported(text)
        lines = [line for line in deck.read_text().splitlines() if not line.startswith("newton:")]
        deck.write_text("\n".join(lines) + "\nnewton: {tolerance: 1e-11}\n")
        return scenes.run(deck, files=[self.folder / "cubes.exo"], check=check)

    def expect_pressed(self, uz):
        below, above = pressed()
        self.assertGreater(abs(below - above), 1e-4)  # they overlap
        numpy.testing.assert_allclose(uz[LOWER_TOP], below, rtol=0, atol=1e-10)
        numpy.testing.assert_allclose(uz[UPPER_BOTTOM], above, rtol=0, atol=1e-10)
