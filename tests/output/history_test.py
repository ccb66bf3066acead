#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""NAME.history.csv and nodal reactions: they agree with summary and fields, and forces and moments balance to
rounding of the solve, on one rank and on two."""
import unittest

import numpy

import history
import scenes
from history import COLUMN, SLIDE

BALANCE = 1e-10
# A rigid block on a hinge at its lower left edge, turned down on the soft one by a moment and a force.
FLAP = scenes.merged(COLUMN, {
    "bodies": {"upper": None, "lid": {"blocks": ["upper"], "rigid": {
        "free": ["x", "y", "z", "rx", "ry", "rz"], "center": [0.5, 0.5, 0.5], "force": [0, 0, -0.02],
        "moment": [0, 0.01, 0]}}},
    "materials": {"soft": None},
    "joints": {"hinge": {"kind": "revolute", "bodies": ["ground", "lid"], "origin": [0.0, 0.5, 0.0],
                         "axis": [0, 1, 0]}},
    "displacements": {"head": None}})


def same(test, found, expected, size, tolerance=BALANCE):
    numpy.testing.assert_allclose(found, expected, rtol=0, atol=tolerance * size)


class Tables(unittest.TestCase):
    """Of three scenes, each on one rank and on two."""

    def check_agreement(self, result):
        """Rows against the fields' global variables and times, the last one against the summary."""
        path = history.path_of(result)
        table = history.read(path)
        names = list(table)
        self.assertEqual(names[0], "t")
        self.assertEqual(names[1:], result.fields.names("glo_var"))
        self.assertEqual([c["name"] for c in history.columns(path)], names)
        self.assertTrue(all(c["meaning"] for c in history.columns(path)))
        numpy.testing.assert_array_equal(table["t"], result.fields.times)
        for step in range(len(table["t"])):
            found = result.fields.globals(step)
            for name in names[1:]:
                self.assertEqual(table[name][step], found[name], name)
        last = {name: values[-1] for name, values in table.items()}
        summary = result.summary
        self.assertEqual(last["t"], summary["t"])
        self.assertEqual(last["steps"], summary["steps"])
        self.assertEqual(last["newton_iterations"], summary["newton_iterations"])
        for key, name in (("work_in", "work_in"), ("stored", "energy_stored"), ("penalty", "energy_penalty"),
                          ("friction", "energy_friction"), ("imbalance", "energy_imbalance")):
            self.assertEqual(last[name], summary["energy"][key])
        contact = summary["contact"]["press"]
        for key, name in (("active_points", "points"), ("stick_points", "stick_points"), ("slip_points", "slip_points"),
                          ("max_pressure", "pressure_max"), ("max_penetration", "penetration_max"),
                          ("max_slip", "slip_max")):
            self.assertEqual(last["press_" + name], contact[key], name)
        self.assertEqual(list(history.vector(table, "press_force")[-1]), contact["force"])
        self.assertGreater(contact["active_points"], 0)
        return table

    def check_reactions(self, result, table, supports):
        """The field is there at held nodes alone, and its sums are those of all supports together."""
        fields = result.fields
        x = fields.coordinates
        for step in range(len(table["t"])):
            reaction = fields.vector("reaction", step)
            force = sum(history.vector(table, name + "_reaction")[step] for name in supports)
            moment = sum(history.vector(table, name + "_reaction_moment")[step] for name in supports)
            size = max(numpy.abs(reaction).sum(), 1e-30)
            same(self, reaction.sum(axis=0), force, size, 1e-13)
            now = x + fields.vector("displacement", step)
            same(self, numpy.cross(now, reaction).sum(axis=0), moment, size, 1e-13)
        self.assertGreater(size, 1e-4)
        return reaction

    def of_ranks(self, deck):
        one, two = (scenes.run(deck, ranks=ranks) for ranks in (1, 2))
        tables = [self.check_agreement(run) for run in (one, two)]
        self.assertEqual(list(tables[0]), list(tables[1]))
        for name, values in tables[0].items():
            size = max(1e-3, numpy.abs(values).max())
            same(self, tables[1][name], values, size, 1e-9)
        return [(one, tables[0]), (two, tables[1])]

    def test_column(self):
        for run, table in self.of_ranks(COLUMN):
            reaction = self.check_reactions(run, table, ("foot", "head"))
            held = numpy.concatenate([run.fields.node_set(s) for s in ("lower_bottom", "upper_top")])
            self.assertEqual(numpy.abs(numpy.delete(reaction, held, axis=0)).max(), 0.0)
            self.assertTrue((numpy.abs(reaction[held]).max(axis=1) > 0).all())
            press, moment = history.vector(table, "press_force"), history.vector(table, "press_moment")
            size = abs(press[-1, 2])
            self.assertGreater(size, 0.01)
            same(self, history.vector(table, "foot_reaction"), press, size)
            same(self, history.vector(table, "head_reaction"), -press, size)
            same(self, history.vector(table, "foot_reaction_moment"), moment, size)
            same(self, history.vector(table, "head_reaction_moment"), -moment, size)
            # The force acts in the middle of the block, and the columns bulge by the same all round.
            same(self, moment[-1], numpy.cross([0.5, 0.5, 0.0], press[-1]), size, 1e-9)
            self.assertGreater(table["press_area"][-1], 1.0)
            self.assertEqual(table["press_points"][-1], 36)
            self.assertTrue(0 < table["press_penetration_mean"][-1] <= table["press_penetration_max"][-1])
            self.assertAlmostEqual(table["press_gap_mean"][-1], -table["press_penetration_mean"][-1], delta=1e-15)
            self.assertLess(table["press_gap_max"][-1], 0.0)

    def test_slide(self):
        for run, table in self.of_ranks(SLIDE):
            self.check_reactions(run, table, ("foot", "down", "drawn", "side"))
            t = table["t"][:, None]
            loads = t * numpy.array([0.002, 0.0, -0.001 - 0.01])
            press = history.vector(table, "press_force")
            size = abs(press[-1, 2])
            self.assertEqual(run.contact("press")["slip_points"], run.contact("press")["active_points"])
            self.assertGreater(abs(press[-1, 0]), 0.1 * size)
            upper = sum(history.vector(table, name + "_reaction") for name in ("down", "drawn", "side"))
            same(self, upper + loads + press, numpy.zeros_like(upper), size)
            same(self, history.vector(table, "foot_reaction"), press, size)
            self.assertGreater(numpy.abs(history.vector(table, "side_reaction")[-1, 1]), 1e-4)
            # Each has what it holds by itself; the edge that two hold counts for the first of them.
            same(self, history.vector(table, "drawn_reaction")[:, 1:], numpy.zeros((len(t), 2)), size, 1e-16)
            self.assertGreater(table["energy_friction"][-1], 1e-4)
            self.assertGreater(table["press_slip_max"][-1], 0.02)

    def test_flap(self):
        for run, table in self.of_ranks(FLAP):
            self.check_reactions(run, table, ("foot",))
            t = table["t"][:, None]
            press, joint = history.vector(table, "press_force"), history.vector(table, "hinge_force")
            size = numpy.abs(joint[-1]).max()
            self.assertGreater(abs(press[-1, 2]), 0.005)
            same(self, press + joint + t * numpy.array([0, 0, -0.02]), numpy.zeros_like(press), size)
            same(self, history.vector(table, "foot_reaction"), press, size)
            # About the origin: loads act on the center, the joint where its point has gone with the body.
            center = history.vector(table, "lid_position")
            same(self, center, [0.5, 0.5, 0.5] + history.vector(table, "lid_displacement"), 1.0, 1e-15)
            moments = (history.vector(table, "press_moment") + history.vector(table, "hinge_moment") +
                       numpy.cross([0.0, 0.5, 0.0], joint) + t * numpy.array([0, 0.01, 0]) +
                       numpy.cross(center, t * numpy.array([0, 0, -0.02])))
            same(self, moments, numpy.zeros_like(moments), size)
            summary = run.summary["joints"]["hinge"]
            self.assertEqual([list(joint[-1]), list(history.vector(table, "hinge_moment")[-1])],
                             [summary["force"], summary["moment"]])

    def test_windows(self):
        """What holds for a part of the run reacts in that part alone."""
        deck = scenes.merged(COLUMN, {"displacements": {"head": {"until": 0.6}, "later": {
            "set": "upper_top", "fix": ["x", "y", "z"], "from": 0.6, "relative": True}}, "time": {"steps": 5}})
        run = scenes.run(deck)
        table = self.check_agreement(run)
        head, later = (numpy.abs(history.vector(table, name + "_reaction")).max(axis=1) for name in ("head", "later"))
        numpy.testing.assert_array_equal(head > 0, [False, True, True, True, False, False])
        numpy.testing.assert_array_equal(later > 0, [False, False, False, False, True, True])
        self.check_reactions(run, table, ("foot", "head", "later"))


if __name__ == "__main__":
    unittest.main(warnings="ignore")
