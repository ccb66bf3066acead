# SPDX-License-Identifier: BSD-3-Clause
"""Bodies on joints that springs hold: balance of forces and moments, and the work."""
import unittest
from math import hypot

import numpy

from mechanisms import (FORCE, FREE, POSITION, Scene, bar, brick, free_body, hinge, mesh_of, turned,
                        vector)


class Springs(Scene):
    def test_slider_on_an_inclined_spring(self):
        """Force and way of a spring that turns as it stretches."""
        stiffness, free, load, height = 10.0, 0.8, 3.0, 1.5
        mesh = mesh_of({"slider": brick((0, 0, 0), 0.2)})
        deck = {"bodies": {"slider": free_body("slider", (0.0, 0.0), force=[load, 0, 0])},
                "joints": {"guide": {"kind": "prismatic", "bodies": ["ground", "slider"],
                                     "axis": [1, 0, 0], "origin": [0, 0, 0]},
                           "spring": {"kind": "spring", "bodies": ["ground", "slider"],
                                      "from": [0, height, 0], "to": [0, 0, 0],
                                      "stiffness": stiffness, "free_length": free}},
                "time": {"steps": 2}}
        result = self.solve(mesh, deck)
        low, high = 0.0, 10.0
        for _ in range(200):
            x = 0.5 * (low + high)
            length = hypot(x, height)
            low, high = (low, x) if stiffness * (length - free) * x / length > load else (x, high)
        found = result.fields.globals()
        self.close(found["guide_translation"], x, POSITION)
        self.close(found["spring_translation"], length - free, POSITION)
        self.close(vector(found, "spring_force"), [-load, load / x * height, 0], FORCE * load)
        self.close(vector(found, "guide_force"), [0, -load / x * height, 0], FORCE * load)
        stored = 0.5 * stiffness * ((length - free)**2 - (height - free)**2)
        self.close(found["energy_stored"], stored, FORCE)
        self.assertEqual(result.summary["joints"]["spring"]["translation"],
                         found["spring_translation"])

    def test_body_on_a_ball_turns_about_all_axes(self):
        """Three springs hold it: their moments balance the load's, the ball carries the rest."""
        load = numpy.array([1.0, -2.0, 1.5])
        tips, anchors = [], []
        springs = {}
        for i in range(3):
            tips.append(numpy.eye(3)[i])
            anchors.append(numpy.eye(3)[i] + 1.2 * numpy.eye(3)[(i + 1) % 3])
            springs[f"s{i}"] = {"kind": "spring", "bodies": ["body", "ground"],
                                "from": list(tips[i]), "to": list(anchors[i]), "stiffness": 2.0}
        center = numpy.array([0.5, 0.2, 0.7])
        mesh = mesh_of({"body": brick(center, 0.3)})
        deck = {"bodies": {"body": {"blocks": ["body"],
                                    "rigid": {"free": FREE, "center": list(center),
                                              "force": list(load)}}},
                "joints": {"ball": {"kind": "spherical", "bodies": ["ground", "body"],
                                    "origin": [0, 0, 0]}, **springs},
                "time": {"steps": 4}}
        result = self.solve(mesh, deck)
        found = result.fields.globals()
        w = vector(found, "body_rotation")
        self.assertGreater(min(abs(w)), 0.1)
        self.assertAlmostEqual(found["ball_rotation"], numpy.linalg.norm(w), delta=1e-12)
        self.close(center + vector(found, "body_displacement"), turned(found, "body", center),
                   POSITION)
        force, moment = load.copy(), numpy.cross(turned(found, "body", center), load)
        for i in range(3):
            tip = turned(found, "body", tips[i])
            pull = anchors[i] - tip
            length = numpy.linalg.norm(pull)
            expected = 2.0 * (length - 1.2) * pull / length  # on the body, the spring's first
            self.close(vector(found, f"s{i}_force"), -expected, FORCE)
            force += expected
            moment += numpy.cross(tip, expected)
        self.close(vector(found, "ball_force"), -force, FORCE)
        self.close(vector(found, "ball_moment"), 0, 0)
        self.close(moment, 0, FORCE)
        self.assertGreater(numpy.linalg.norm(force), 0.5)

    def ball(self, **joint):
        center = numpy.array([0.5, 0.2, 0.7])
        mesh = mesh_of({"arm": brick((0, 0, 0), 0.2), "body": brick(center, 0.3)})
        deck = {"bodies": {"arm": {"blocks": ["arm"],
                                   "rigid": {"rotation": [0, 0, 0.9], "curve": "early"}},
                           "body": {"blocks": ["body"],
                                    "rigid": {"free": FREE, "center": list(center)}}},
                "joints": {"ball": {"kind": "spherical", "bodies": ["arm", "body"],
                                    "origin": [0, 0, 0.4], **joint}},
                "curves": {"early": [[0, 0], [0.5, 1]]}, "time": {"steps": 8}}
        return mesh, deck, center

    def test_driven_ball(self):
        """A rotation vector in the directions of an arm that turned before; the work against a
        moment on the body, trapezoidal rule."""
        vector_at_end = numpy.array([0.6, -1.5, 1.0])
        mesh, deck, center = self.ball(rotation_vector=[f"{v} * max(0, 2 * t - 1)"
                                                        for v in vector_at_end])
        result = self.solve(mesh, deck)
        found = result.fields.globals()
        arm = {f"arm_rotation_{i}": v for i, v in zip("xyz", (0, 0, 0.9))}
        inner = {f"own_rotation_{i}": v for i, v in zip("xyz", vector_at_end)}
        for e in numpy.eye(3):
            self.close(turned(found, "body", e), turned(arm, "arm", turned(inner, "own", e)),
                       POSITION)
        self.assertAlmostEqual(found["ball_rotation"], numpy.linalg.norm(vector_at_end),
                               delta=POSITION)
        at = numpy.array([0, 0, 0.4])
        moved = at + turned(arm, "arm", turned(inner, "own", center - at))
        self.close(center + vector(found, "body_displacement"), moved, POSITION)

    def test_ball_under_a_moment(self):
        """A moment fixed in space against springs: the moment and what they store."""
        moment = numpy.array([0.4, -0.6, 0.5])
        left = []
        for steps in (4, 8):
            mesh, deck, center = self.ball(moment_vector=list(moment))
            deck["bodies"]["arm"]["rigid"] = {}
            deck["time"]["steps"] = steps
            for i in range(3):
                tip, to = center + 0.5 * numpy.eye(3)[i], numpy.eye(3)[(i + 1) % 3]
                deck["joints"][f"s{i}"] = {"kind": "spring", "bodies": ["body", "ground"],
                                           "from": list(tip), "to": list(tip + to),
                                           "stiffness": 8.0}
            result = self.solve(mesh, deck)
            found = result.fields.globals()
            self.close(vector(found, "ball_moment"), moment, 1e-15)
            at, balance = numpy.array([0, 0, 0.4]), moment.copy()
            for i in range(3):
                tip = turned(found, "body", center + 0.5 * numpy.eye(3)[i] - at)
                balance -= numpy.cross(tip, vector(found, f"s{i}_force"))
            self.close(balance, 0, FORCE)
            left.append(result.summary["energy"]["imbalance"])
        self.assertGreater(min(abs(vector(found, "body_rotation"))), 0.02)
        self.assertAlmostEqual(left[0] / left[1], 4.0, delta=0.5)

    def test_double_pendulum(self):
        """Two bars hang on each other and on springs, under loads across: what each hinge carries
        is the sum of all that hangs on it, and nothing turns about a hinge."""
        bars = {"upper": ((0, 0, 0), (0, -1, 0)), "lower": ((0, -1, 0), (0, -2.2, 0))}
        loads = {"upper": numpy.array([1.0, -3.0, 0]), "lower": numpy.array([2.0, -2.0, 0])}
        anchor = {"upper": (1.0, -1.0, 0), "lower": (1.0, -2.2, 0)}
        mesh = mesh_of({name: bar(a[:2], b[:2]) for name, (a, b) in bars.items()})
        deck = {"bodies": {name: free_body(name, 0.5 * (numpy.add(*ends))[:2],
                                           force=list(loads[name]))
                           for name, ends in bars.items()},
                "joints": {"top": hinge("revolute", ["ground", "upper"], (0, 0)),
                           "knee": hinge("revolute", ["upper", "lower"], (0, -1))},
                "time": {"steps": 4}}
        for name, (a, b) in bars.items():
            deck["joints"]["spring_" + name] = {
                "kind": "spring", "bodies": [name, "ground"], "from": list(b),
                "to": list(anchor[name]), "stiffness": 1.5}
        result = self.solve(mesh, deck)
        found = result.fields.globals()
        self.assertGreater(abs(found["upper_rotation_z"]), 0.2)
        carried = {}
        knee = turned(found, "upper", (0, -1, 0))
        for name, at in (("upper", numpy.zeros(3)), ("lower", knee)):
            a, b = numpy.array(bars[name][0]), numpy.array(bars[name][1])
            middle = at + turned(found, name, 0.5 * (b - a))
            tip = at + turned(found, name, b - a)
            self.close(0.5 * (a + b) + vector(found, name + "_displacement"), middle, POSITION)
            pull = -vector(found, "spring_" + name + "_force")
            length = numpy.linalg.norm(numpy.array(anchor[name]) - tip)
            self.close(pull, 1.5 * (length - 1.0) * (numpy.array(anchor[name]) - tip) / length,
                       FORCE)
            carried[name] = (pull + loads[name],
                             numpy.cross(middle, loads[name]) + numpy.cross(tip, pull))
        force, moment = carried["lower"]
        self.close(vector(found, "knee_force"), -force, 10 * FORCE)
        self.close((moment - numpy.cross(knee, force))[2], 0, 10 * FORCE)
        self.close(vector(found, "top_force"), -force - carried["upper"][0], 10 * FORCE)
        self.close((moment + carried["upper"][1])[2], 0, 10 * FORCE)
        self.assertGreater(numpy.linalg.norm(force), 1.0)


if __name__ == "__main__":
    unittest.main()
