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

    def test_tie_of_the_second_step(self):
        """The upper cube sinks into the lower one, is tied to it there and pulled up again."""
        penalty, up = 50.0, 0.15
        late = """<load_controller id="2" type="loadcurve"><points><pt>1,0</pt><pt>2,1</pt></points>
          </load_controller></LoadData>"""
        pull = f'''<Boundary><bc name="pull" node_set="top" type="prescribed displacement"><dof>z</dof>
          <value lc="2">{up}</value><relative>1</relative></bc></Boundary>'''
        for name, rules, spring in (
                ("penalty", f"<penalty>{penalty}</penalty>", 1 / penalty),
                ("multipliers", "<laugon>AUGLAG</laugon><tolerance>1e-9</tolerance><maxaug>100</maxaug>"
                 f"<penalty>{penalty}</penalty>", 0.0)):
            for kind in ("tied-node-on-facet", "tied-elastic", "tied-facet-on-facet"):
                tie = f'''<Contact><contact name="tie" surface_pair="pair" type="{kind}">{rules}
                  </contact></Contact>'''
                with self.subTest(kind=kind, rules=name):
                    text = cubes(boundary=SIDEWAYS + FLOOR, more="", control=f"""<Step>
                      <step>{CONTROL}<Boundary>{PRESS}</Boundary></step>
                      <step>{CONTROL}{pull}{tie}</step></Step>""")
                    fields = self.run_cubes(text.replace("</LoadData>", late)).fields
                    before = fields.nodal("displacement_z", list(fields.times).index(1.0))
                    numpy.testing.assert_allclose(before[LOWER_TOP], 0, atol=1e-12)
                    kept = up if kind == "tied-elastic" else up - DOWN  # the others pull them together
                    p = root(lambda p: stretched(LOWER, p) + stretched(UPPER, p) + p * spring - 2 - kept)
                    uz = fields.nodal("displacement_z")
                    self.assertGreater(stretched(LOWER, p), 1.03)
                    numpy.testing.assert_allclose(uz[LOWER_TOP], stretched(LOWER, p) - 1, rtol=0,
                                                  atol=1e-8)
                    numpy.testing.assert_allclose(uz[-4:], up - DOWN, rtol=0, atol=1e-12)

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

    def test_supports_let_go(self):
        """Pressed by a force, held there while the force is gone, pressed further, then released."""
        tie = '''<Contact><contact name="tie" surface_pair="pair" type="tied-elastic">
          <penalty>50</penalty></contact></Contact>'''
        force = '''<Loads><nodal_load name="push" node_set="top" type="nodal_load"><dof>z</dof>
          <scale lc="1">-0.25</scale></nodal_load></Loads>'''

        def hold(value, relative):
            return f'''<Boundary><bc name="hold" node_set="top" type="prescribed displacement">
              <dof>z</dof><value lc="1">{value}</value><relative>{relative}</relative></bc></Boundary>'''

        steps = "".join(f"<step>{CONTROL}{what}</step>"
                        for what in (force, hold(0, 1), hold(-0.05, 1), hold(-DOWN, 0), ""))
        fields = self.run_cubes(cubes(control=f"<Step>{steps}</Step>", boundary=SIDEWAYS + FLOOR,
                                      more=tie)).fields
        top = {t: fields.nodal("displacement_z", i)[-4:] for i, t in enumerate(fields.times)}
        pushed = stretched(LOWER, -1) + stretched(UPPER, -1) - 2 - 1 / 50
        self.assertLess(pushed, -0.05)
        for t, expected in ((1, pushed), (2, pushed), (3, pushed - 0.05), (4, -DOWN), (5, 0)):
            numpy.testing.assert_allclose(top[t], expected, rtol=0, atol=1e-8, err_msg=f"t = {t}")

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

    def test_what_nothing_holds_any_more(self):
        """The upper cube flies off; the message names what has let it go."""
        result = self.run_cubes(cubes(
            control=f"<Step><step>{CONTROL}<Boundary>{PRESS}</Boundary></step><step>{CONTROL}</step></Step>",
            boundary=SIDEWAYS + FLOOR), check=False)
        self.assertEqual(result.status, 1)
        self.assertIn("stopped at t = 1 of 2", result.output)
        self.assertIn("There begins or ends: displacements.press.", result.output)

    def test_rigid_body_lets_go(self):
        """Driven down, then free under a force, then stopped where it is, then moved from there."""
        fixed = "".join(f"<{d}_dof>1</{d}_dof>" for d in ("Rx", "Ry", "Ru", "Rv", "Rw"))

        def held(more=""):
            return f'''<rigid_bc name="held" type="rigid_fixed"><rb>hard</rb>{fixed}{more}</rigid_bc>'''

        def moved(value, relative):
            return f'''<rigid_bc name="down" type="rigid_displacement"><rb>hard</rb><dof>z</dof>
              <value lc="1">{value}</value><relative>{relative}</relative></rigid_bc>'''

        force = '''<rigid_load name="push" type="rigid_force"><rb>hard</rb><dof>Rz</dof>
          <value>-0.5</value></rigid_load>'''
        steps = "".join(f"<step>{CONTROL}<Rigid>{what}</Rigid></step>"
                        for what in (held() + moved(-DOWN, 0), held() + force,
                                     held("<Rz_dof>1</Rz_dof>"), held() + moved(-0.02, 1)))
        penalty = 1000.0
        touch = f'''<Contact><contact name="touch" surface_pair="pair" type="sliding-facet-on-facet">
          <penalty>{penalty}</penalty></contact></Contact>'''
        fields = self.run_cubes(cubes(control=f"<Step>{steps}</Step>", boundary=SIDEWAYS + FLOOR,
                                      more=touch, upper="rigid body")).fields
        pushed = stretched(LOWER, -0.5) - 1 - 0.5 / penalty
        down = {t: fields.nodal("displacement_z", i)[-8:] for i, t in enumerate(fields.times)}
        for t, expected in ((1, -DOWN), (2, pushed), (3, pushed), (4, pushed - 0.02)):
            numpy.testing.assert_allclose(down[t], expected, rtol=0, atol=1e-8, err_msg=f"t = {t}")

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
