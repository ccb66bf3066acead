# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies with unknowns: loads against exact solutions, large rotations, Newton's rate.

A rigid plate on four clamped columns of a linear material without Poisson effect: a turn of the plate
stretches column i by u_i = w + tx (y_i - cy) - ty (x_i - cx) and bends it by tx, ty without shear, so
  F_z = sum E A u_i / h,  M_x = sum (y_i - cy) E A u_i / h + 4 E I tx / h,
  M_y = -sum (x_i - cx) E A u_i / h + 4 E I ty / h,  u_x = ty h / 2,  u_y = -tx h / 2.
Quadratic elements hold this field exactly.
"""
import math
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import scenes

MATERIAL = {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}
NEO_HOOKEAN = {"model": "neo_hookean", "young": 1.0, "poisson": 0.3}
ALL_FREE = ["x", "y", "z", "rx", "ry", "rz"]


def body(result, name):
    return {key: numpy.array(value) for key, value in result.summary["rigid_bodies"][name].items()}


def four_columns(folder):
    """Columns of 0.5 x 0.5 x 1 at the corners of a rectangle, sets `bottom` and `top`."""
    one = exodus_edit.read(scenes.mesh(folder / "one.exo", "box", size=[.5, .5, 1],
                                       divisions=[1, 1, 2], element="hex20"))
    count = len(one.x)
    shifts = [(0, 0, 0), (2, 0, 0), (0, 1.5, 0), (2.3, 1.5, 0)]
    mesh = exodus_edit.ExodusMesh(numpy.vstack([one.x + shift for shift in shifts]), [])
    nodes = numpy.vstack([one.blocks[0].nodes + i * count for i in range(4)])
    mesh.blocks = [exodus_edit.Block("columns", 1, one.blocks[0].kind, nodes)]
    for name, old in (("bottom", "z0"), ("top", "z1")):
        mesh.node_sets[name] = numpy.concatenate([one.node_sets[old] + i * count
                                                  for i in range(4)])
    exodus_edit.write(folder / "columns.exo", mesh)
    return folder / "columns.exo", numpy.array(shifts)[:, :2] + 0.25


class PlateOnColumns(unittest.TestCase):
    FORCE, MOMENT = numpy.array([0, 0, -2e-6]), numpy.array([7e-7, -4e-7, 0])
    CENTER = numpy.array([0.8, 1.1, 1.0])

    def deck(self, **solver):
        return {"mesh": {"file": "columns.exo"}, "materials": {"spring": MATERIAL},
                "bodies": {"columns": {"blocks": ["columns"], "material": "spring"},
                           "plate": {"node_sets": ["top"],
                                     "rigid": {"center": list(self.CENTER), "free": ALL_FREE,
                                               "force": list(self.FORCE),
                                               "moment": list(self.MOMENT)}}},
                "displacements": {"bottom": {"set": "bottom", "fix": ["x", "y", "z"]}},
                "newton": {"tolerance": 1e-11}, "linear_solver": solver or {"method": "direct"},
                "verify": {"height": {**scenes.probe("rigid_displacement_z", "plate")},
                           "turn": {**scenes.probe("rigid_rotation_y", "plate")}}}

    def exact(self, columns):
        k, bending = 0.25, 0.5**4 / 12
        x, y = (columns - self.CENTER[:2]).T
        matrix = k * numpy.array([[4, y.sum(), -x.sum()], [y.sum(), y @ y, -(x @ y)],
                                  [-x.sum(), -(x @ y), x @ x]])
        matrix += numpy.diag([0, 4 * bending, 4 * bending])
        w, tx, ty = numpy.linalg.solve(matrix, [self.FORCE[2], *self.MOMENT[:2]])
        return numpy.array([ty / 2, -tx / 2, w]), numpy.array([tx, ty, 0])

    def test_exact(self):
        for solver in ({}, {"method": "krylov", "preconditioner": "muelu", "tolerance": 1e-12},
                       {"method": "krylov", "preconditioner": "ilu", "tolerance": 1e-12}):
            with self.subTest(**solver), tempfile.TemporaryDirectory() as folder:
                mesh, columns = four_columns(pathlib.Path(folder))
                result = scenes.run(self.deck(**solver), files=[mesh])
                displacement, rotation = self.exact(columns)
                plate = body(result, "plate")
                size = numpy.linalg.norm(rotation)
                # Finite rotations differ from small ones by the angle, relative.
                self.assertGreater(size, 1e-7)
                self.assertLess(size, 1e-5)
                numpy.testing.assert_allclose(plate["displacement"], displacement, rtol=0,
                                              atol=1e-5 * size)
                numpy.testing.assert_allclose(plate["rotation"], rotation, rtol=0,
                                              atol=1e-5 * size)
                self.assertEqual(result.quantity("height"), plate["displacement"][2])
                self.assertEqual(result.quantity("turn"), plate["rotation"][1])
                self.assertEqual(abs(plate["force"]).max(), 0)
                self.assertEqual(abs(plate["moment"]).max(), 0)
                last = result.fields.globals()
                self.assertEqual(last["plate_rotation_x"], plate["rotation"][0])
                self.assertEqual(last["plate_displacement_z"], plate["displacement"][2])


class PressedBlock(unittest.TestCase):
    """A rigid block on an elastic one: moved by force and moment, or as far by displacement."""

    def deck(self, **rigid):
        return {"mesh": {"generate": {"kind": "blocks", "lower_size": [1.2, 1, 1],
                                      "lower_divisions": [4, 3, 3], "upper_size": [.8, .7, .3],
                                      "upper_divisions": [5, 4, 1]}},
                "materials": {"soft": NEO_HOOKEAN},
                "bodies": {"lower": {"blocks": ["lower"], "material": "soft"},
                           "upper": {"blocks": ["upper"], "rigid": {"center": [.4, .3, 1], **rigid}}},
                "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]}},
                "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top",
                                     "penalty": 20}},
                "newton": {"tolerance": 1e-11}, "linear_solver": {"method": "direct"},
                "time": {"steps": 4}}

    def test_force_equals_displacement(self):
        # About one axis: free turns about two add one about the third, which displacement has not.
        for axes, rotation in ((["z"], [.02, -.03, 0]), (["z", "ry"], [0, -.03, 0])):
            with self.subTest(free=axes):
                led = scenes.run(self.deck(displacement=[0, 0, -.06], rotation=rotation))
                reaction = body(led, "upper")
                self.assertGreater(led.contact()["active_points"], 60)
                self.assertLess(reaction["force"][2], -0.01)
                self.assertGreater(abs(reaction["moment"][1]), 1e-4)
                # What holds the led block balances contact, whose force is that on the primary.
                numpy.testing.assert_allclose(reaction["force"], -led.force(), atol=1e-12)
                change = {"rotation": rotation}
                if len(axes) > 1:
                    change = {"moment": [0, reaction["moment"][1], 0]}
                loaded = scenes.run(self.deck(free=axes, force=[0, 0, reaction["force"][2]],
                                              **change))
                upper = body(loaded, "upper")
                numpy.testing.assert_allclose(upper["displacement"], [0, 0, -.06], atol=1e-9)
                numpy.testing.assert_allclose(upper["rotation"], rotation, atol=1e-9)
                numpy.testing.assert_allclose(upper["force"][:2], reaction["force"][:2], atol=1e-10)
                self.assertEqual(upper["force"][2], 0)
                numpy.testing.assert_allclose(loaded.fields.vector("displacement"),
                                              led.fields.vector("displacement"), atol=1e-9)
                self.assertEqual(loaded.contact()["active_points"],
                                 led.contact()["active_points"])

    def test_nothing_holds_it(self):
        for free, motion in ((["z", "x"], "translation along x"), (["z", "rz"], "rotation about z"),
                             (ALL_FREE, "")):
            result = scenes.run(self.deck(free=free, force=[0, 0, -.01]), check=False)
            self.assertEqual(result.status, 2, result.output)
            self.assertIn("body 'upper' is free to move: " + motion, result.output)


class LargeRotation(unittest.TestCase):
    """A block without stress turns by 200 degrees with the rigid body that it is clamped to, and so
    does a free body at its other end."""
    ANGLE = math.radians(200) * numpy.array([2, -1, 2]) / 3
    CENTER, MOTION = numpy.array([.5, .2, -.3]), numpy.array([.4, -.2, .7])

    def test_follows(self):
        deck = {"mesh": {"generate": {"kind": "box", "divisions": [2, 2, 3], "distortion": .1}},
                "materials": {"rubber": NEO_HOOKEAN},
                "bodies": {"block": {"blocks": ["box"], "material": "rubber"},
                           "holder": {"node_sets": ["z0"],
                                      "rigid": {"center": list(self.CENTER),
                                                "rotation": list(self.ANGLE),
                                                "displacement": list(self.MOTION)}},
                           "cap": {"node_sets": ["z1"],
                                   "rigid": {"center": [1, 1, 1.5], "free": ALL_FREE}}},
                "newton": {"tolerance": 1e-12}, "linear_solver": {"method": "direct"},
                "time": {"steps": 25}}
        result = scenes.run(deck)
        a = numpy.linalg.norm(self.ANGLE)
        k = self.ANGLE / a
        s = numpy.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
        turn = numpy.eye(3) + math.sin(a) * s + (1 - math.cos(a)) * s @ s

        def moved(x):
            return (x - self.CENTER) @ turn.T + self.CENTER + self.MOTION

        x = result.fields.coordinates
        u = result.fields.vector("displacement")
        self.assertGreater(abs(u).max(), 1)
        numpy.testing.assert_allclose(x + u, moved(x), rtol=0, atol=1e-10)
        self.assertLess(result.fields.element("von_mises", "box").max(), 1e-10)
        cap, holder = body(result, "cap"), body(result, "holder")
        numpy.testing.assert_allclose(holder["rotation"], self.ANGLE, rtol=0, atol=1e-15)
        numpy.testing.assert_allclose(cap["rotation"], self.ANGLE, rtol=0, atol=1e-10)
        center = numpy.array([1, 1, 1.5])
        numpy.testing.assert_allclose(cap["displacement"], moved(center) - center, rtol=0,
                                      atol=1e-10)
        self.assertLess(abs(holder["force"]).max(), 1e-10)


class RolledBeam(unittest.TestCase):
    """A slender beam bent by a moment on a rigid cap: a circle of angle M L / (E I); the cap is free.
    The beam is neo-Hookean: of second order in thickness over radius it is not the elastica."""
    LENGTH, ANGLE = 8.0, 0.75 * math.pi

    def deck(self, steps=6, **changes):
        moment = self.ANGLE * (0.5**4 / 12) / self.LENGTH
        return scenes.merged(
            {"mesh": {"generate": {"kind": "box", "size": [self.LENGTH, .5, .5],
                                   "divisions": [12, 1, 1], "element": "hex20"}},
             "materials": {"rubber": {"young": 1.0, "poisson": 0.0}},
             "bodies": {"beam": {"blocks": ["box"], "material": "rubber"},
                        "cap": {"node_sets": ["x1"],
                                "rigid": {"center": [self.LENGTH, .25, .25], "free": ALL_FREE,
                                          "moment": [0, -moment, 0]}}},
             "displacements": {"clamp": {"set": "x0", "fix": ["x", "y", "z"]}},
             "newton": {"tolerance": 1e-10}, "linear_solver": {"method": "direct"},
             "time": {"steps": steps}}, changes)

    def test_rolls_up_and_newton_is_quadratic(self):
        result = scenes.run(self.deck(), quiet=False)
        cap = body(result, "cap")
        self.assertEqual(result.summary["cut_backs"], 0)
        radius = self.LENGTH / self.ANGLE
        numpy.testing.assert_allclose(cap["rotation"], [0, -self.ANGLE, 0], atol=2e-2)
        numpy.testing.assert_allclose(cap["displacement"],
                                      [radius * math.sin(self.ANGLE) - self.LENGTH, 0,
                                       radius * (1 - math.cos(self.ANGLE))], atol=5e-2)
        pairs = [(r, following) for residuals in result.newton_residuals().values()
                 for r, following in zip(residuals, residuals[1:]) if 1e-8 < r < 1e-4]
        print("Newton, residual after residual:", *(f"{a:.1e} -> {b:.1e}" for a, b in pairs))
        self.assertGreaterEqual(len(pairs), 5)
        for r, following in pairs:
            self.assertLess(following, max(r * r, 1e-12))

    def test_same_on_all_ranks(self):
        results = [scenes.run(self.deck(2, bodies={"cap": {"rigid": {"follower": True,
                                                                    "force": [0, 0, 1e-6]}}}),
                              ranks=ranks) for ranks in (1, 2, 4)]
        expected = body(results[0], "cap")
        self.assertGreater(numpy.linalg.norm(expected["rotation"]), 1)
        for other in results[1:]:
            found = body(other, "cap")
            for key in ("displacement", "rotation"):
                numpy.testing.assert_allclose(found[key], expected[key], rtol=0, atol=1e-10)
            numpy.testing.assert_allclose(other.fields.vector("displacement"),
                                          results[0].fields.vector("displacement"), rtol=0,
                                          atol=1e-10)
            self.assertEqual(other.summary["newton_iterations"],
                             results[0].summary["newton_iterations"])


class Refused(unittest.TestCase):
    """Wrong input: status 2 and a message with line and key."""
    DECK = {"mesh": {"generate": {"kind": "blocks"}}, "materials": {"rubber": NEO_HOOKEAN},
            "bodies": {"lower": {"blocks": ["lower"], "material": "rubber"},
                       "upper": {"blocks": ["upper"], "rigid": {"free": ["z"], "force": [0, 0, -.01]}}},
            "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]}},
            "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top"}}}

    def expect(self, changes, message):
        result = scenes.run(scenes.merged(self.DECK, changes), command="check", check=False)
        self.assertEqual(result.status, 2, result.output)
        self.assertRegex(result.output, message)
        self.assertEqual(result.output.count("abut: "), 1, result.output)

    def test_deck(self):
        self.assertEqual(scenes.run(self.DECK, command="check").status, 0)
        rigid = {"upper": {"rigid": {"force": None, "moment": [1, 0, 0], "free": None}}}
        self.expect({"bodies": rigid}, r"rigid\.moment: the motion is prescribed")
        rigid = {"upper": {"rigid": {"displacement": [0, 0, -1]}}}
        self.expect({"bodies": rigid}, r"rigid\.displacement: component 'z' is prescribed here and")
        self.expect({"bodies": {"upper": {"rigid": {"free": ["w"]}}}},
                    r"rigid\.free: unknown value 'w'")
        self.expect({"bodies": {"upper": {"rigid": {"load_curve": "up"}}}},
                    r"rigid\.load_curve: 'up' is not a name under curves")
        self.expect({"bodies": {"upper": {"rigid": {"curves": {"rx": "up"}}}}},
                    r"rigid\.curves\.rx: 'up' is not a name under curves")
        self.expect({"bodies": {"ghost": {"rigid": {"center": [0, 0, 0]}}}},
                    r"bodies\.ghost: expected .*blocks, node_sets")
        self.expect({"bodies": {"lower": {"node_sets": ["lower_top"]}}},
                    r"bodies\.lower\.node_sets: only a rigid body takes nodes")
        self.expect({"verify": {"w": scenes.probe("rigid_force_z", "lower")}},
                    r"verify\.w\.place: body 'lower' is not rigid")

    def test_mesh(self):
        self.expect({"bodies": {"cap": {"node_sets": ["upper_top"], "rigid": {}}}},
                    r"bodies\.cap: node \d+ already belongs to rigid body 'upper'")
        self.expect({"bodies": {"cap": {"node_sets": ["lower_bottom"], "rigid": {}}}},
                    r"displacements\.bottom: node \d+ moves with rigid body 'cap'")
        self.expect({"bodies": {"cap": {"node_sets": ["lower_botom"], "rigid": {}}}},
                    r"bodies\.cap\.node_sets: the mesh has no node set 'lower_botom'; .*lower_bottom")

    def test_what_hangs_on_a_free_body_is_free(self):
        deck = {"mesh": {"generate": {"kind": "box", "divisions": [1, 1, 1]}},
                "materials": {"rubber": NEO_HOOKEAN},
                "bodies": {"block": {"blocks": ["box"], "material": "rubber"},
                           "cap": {"node_sets": ["z1"],
                                   "rigid": {"center": [0, 0, 1], "free": ["x"]}}}}
        result = scenes.run(deck, command="check", check=False)
        self.assertEqual(result.status, 2, result.output)
        self.assertIn("body 'cap' is free to move: translation along x.", result.output)
        deck["displacements"] = {"one node": {"set": "z0", "x": 0}}
        self.assertEqual(scenes.run(deck, command="check").status, 0)


if __name__ == "__main__":
    unittest.main()
