# SPDX-License-Identifier: BSD-3-Clause
"""Imported models of two cubes whose steps bring, change and take away conditions."""
import unittest

import numpy

from febio_cubes import (CONTROL, DOWN, FLOOR, LOWER, LOWER_TOP, PRESS, SIDEWAYS, TOUCH, UPPER, UPPER_BOTTOM,
                         Case, cubes, pressed, root, stretched)


class Steps(Case):
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


if __name__ == "__main__":
    unittest.main()
