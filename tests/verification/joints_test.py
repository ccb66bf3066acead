# SPDX-License-Identifier: BSD-3-Clause
"""Mechanisms of rigid bodies whose motion and forces are known exactly.

Joints close to 1e-9 of a body's size, so that positions are compared to 1e-8 of it; forces follow
from positions and from Newton's tolerance, 1e-8, times the lever arms of the mechanism.
"""
import pathlib
import shutil
import tempfile
import unittest
from math import atan2, cos, hypot, pi, sin, sqrt

import numpy

import exodus_edit
import scenes

POSITION, FORCE = 1e-8, 1e-6
FREE = ["x", "y", "z", "rx", "ry", "rz"]
CORNERS = numpy.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                       (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]) - 0.5


def mesh_of(blocks, sides=None):
    """blocks: {name: (nodes, hexahedra)}; sides: {name: [(block, element, side), ...]}."""
    x, parts, first = [], [], {}
    count = elements = 0
    for i, (name, (nodes, cells)) in enumerate(blocks.items(), 1):
        parts.append(exodus_edit.Block(name, i, "HEX8", numpy.array(cells) + count))
        x.append(numpy.array(nodes, float))
        first[name] = elements
        count += len(nodes)
        elements += len(cells)
    mesh = exodus_edit.ExodusMesh(numpy.concatenate(x), parts)
    for name, faces in (sides or {}).items():
        mesh.side_sets[name] = (numpy.array([first[b] + e for b, e, s in faces]),
                                numpy.array([s for b, e, s in faces]))
    return mesh


def bar(a, b, width=0.1):
    """A brick between two points of the plane z = 0."""
    a, b = numpy.array(a, float), numpy.array(b, float)
    along = b - a
    across = numpy.array([-along[1], along[0]]) / numpy.linalg.norm(along) * width
    middle = 0.5 * (a + b)
    nodes = [(*(middle + c[0] * along + c[1] * across), c[2] * width) for c in CORNERS]
    return nodes, [range(8)]


def brick(center, size):
    return numpy.array(center) + CORNERS * size, [range(8)]


class Scene(unittest.TestCase):
    def solve(self, mesh, deck, **options):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        exodus_edit.write(folder / "scene_mesh.exo", mesh)
        deck = {"mesh": {"file": "scene_mesh.exo"}, **deck}
        return scenes.run(deck, files=[folder / "scene_mesh.exo"], **options)

    def same(self, a, b, steps, force):
        """All that bodies, joints and contact report, in lengths of one and this force."""
        for step in range(steps + 1):
            one, other = a.fields.globals(step), b.fields.globals(step)
            for name in filter(is_size, one):
                size = force if "_force" in name or "_moment" in name else 1.0
                self.assertAlmostEqual(one[name], other[name], delta=1e-10 * size, msg=name)

    def close(self, found, expected, tolerance):
        numpy.testing.assert_allclose(found, expected, rtol=0, atol=tolerance)


def is_size(name):
    return name[-2:] in ("_x", "_y", "_z") or name.endswith(("_rotation", "_translation"))


def free_body(name, center, **more):
    return {"blocks": [name], "rigid": {"free": FREE, "center": [*center, 0.0], **more}}


def hinge(kind, bodies, at, **more):
    axis = {} if kind == "spherical" else {"axis": [0, 0, 2]}
    return {"kind": kind, "bodies": bodies, "origin": [*at, 0], **axis, **more}


class FourBar(Scene):
    """A crank turns once and more, the rocker swings; a moment acts on the rocker."""
    CRANK, COUPLER, ROCKER, GROUND = 1.0, 3.0, 2.8, 3.5
    START, TURNS, STEPS, MOMENT = 0.6, 1.25, 30, 7.0

    def place(self, crank):
        """Ends of crank and rocker for the angle of the crank, the open branch."""
        b = self.CRANK * numpy.array([cos(crank), sin(crank)])
        d = numpy.array([self.GROUND, 0.0])
        span = numpy.linalg.norm(d - b)
        angle = numpy.arccos((span**2 + self.ROCKER**2 - self.COUPLER**2) /
                             (2 * span * self.ROCKER))
        to_crank = atan2(*(b - d)[::-1])
        return b, d + self.ROCKER * numpy.array([cos(to_crank - angle), sin(to_crank - angle)])

    def rocker_angle(self, crank):
        c = self.place(crank)[1]
        return atan2(c[1], c[0] - self.GROUND) % (2 * pi)

    def deck(self, kinds):
        a, d = (0.0, 0.0), (self.GROUND, 0.0)
        b, c = self.place(self.START)
        self.mesh = mesh_of({"crank": bar(a, b), "coupler": bar(b, c), "rocker": bar(d, c)})
        joints = {"drive": hinge("revolute", ["ground", "crank"], a,
                                 rotation=f"{2 * self.TURNS} * pi * t"),
                  "b": hinge(kinds[0], ["crank", "coupler"], b),
                  "c": hinge(kinds[1], ["coupler", "rocker"], c),
                  "d": hinge(kinds[2], ["ground", "rocker"], d)}
        bodies = {"crank": free_body("crank", (0.1, 0.2)), "coupler": free_body("coupler", b),
                  "rocker": free_body("rocker", c, moment=[0, 0, self.MOMENT], load_curve="one")}
        return {"bodies": bodies, "joints": joints, "time": {"steps": self.STEPS},
                "curves": {"one": [[0, 1], [1, 1]]}}

    def check(self, result):
        start, h = self.rocker_angle(self.START), 1e-5
        swings = []
        for step in range(self.STEPS + 1):
            crank = self.START + 2 * pi * self.TURNS * step / self.STEPS
            found = result.fields.globals(step)
            self.close(found["drive_rotation"], crank - self.START, POSITION)
            self.close(found["d_rotation"], self.rocker_angle(crank) - start, POSITION)
            swings.append(found["d_rotation"])
            b = self.place(crank)[0] - self.place(self.START)[0]
            move = [found["coupler_displacement_" + i] for i in "xyz"]
            self.close(move, [*b, 0.0], POSITION)
            if step == 0:
                continue
            # Power of the drive and of the moment balance; central difference, error h^2.
            speed = (self.rocker_angle(crank + h) - self.rocker_angle(crank - h)) / (2 * h)
            self.close(found["drive_moment_z"], -self.MOMENT * speed, FORCE * self.MOMENT)
            self.close([found["d_force_" + i] for i in "xyz"],
                       [found["b_force_" + i] * -1 for i in "xyz"], FORCE * self.MOMENT)
        self.assertGreater(max(swings) - min(swings), 0.7)
        self.assertEqual(result.summary["cut_backs"], 0)

    def test_exactly_constrained(self):
        deck = self.deck(("revolute", "spherical", "cylindrical"))
        result = self.solve(self.mesh, deck, quiet=False)
        self.assertNotIn("warning", result.output)
        self.check(result)

    def test_work_of_drive_and_moment(self):
        """Nothing is stored: what is left over falls with the square of the step."""
        left = []
        for self.STEPS in (30, 60):
            deck = self.deck(("revolute", "spherical", "cylindrical"))
            left.append(self.solve(self.mesh, deck).summary["energy"]["imbalance"])
        self.assertGreater(abs(left[0]), 1e-4 * self.MOMENT)
        self.assertAlmostEqual(left[0] / left[1], 4.0, delta=0.3)

    def test_hinges_alone(self):
        """Three of their conditions hold by themselves: left out, and told."""
        deck = self.deck(("revolute", "revolute", "revolute"))
        result = self.solve(self.mesh, deck, quiet=False)
        self.assertEqual(result.output.count("is held by other joints or supports already"), 3)
        self.check(result)

    def test_same_on_all_ranks(self):
        deck = self.deck(("revolute", "spherical", "cylindrical"))
        one, here = self.solve(self.mesh, deck, ranks=1), self.solve(self.mesh, deck)
        self.same(one, here, self.STEPS, self.MOMENT)


class FourBarUnderATinyMoment(FourBar):
    """Units do not matter."""
    MOMENT = 7e-12


class SliderCrank(Scene):
    """The slider's place and the moment that its load asks of the crank."""
    CRANK, ROD, LOAD, START, STEPS = 1.0, 2.5, 4.0, 0.4, 18

    def place(self, angle):
        return self.CRANK * cos(angle) + sqrt(self.ROD**2 - (self.CRANK * sin(angle))**2)

    def test_over_a_turn(self):
        b, c = (cos(self.START), sin(self.START)), (self.place(self.START), 0.0)
        mesh = mesh_of({"crank": bar((0, 0), b), "rod": bar(b, c), "slider": brick((*c, 0), 0.3)})
        bodies = {"crank": free_body("crank", (0, 0)), "rod": free_body("rod", b),
                  "slider": free_body("slider", (c[0] + 0.5, 0.2))}
        joints = {"drive": hinge("revolute", ["ground", "crank"], (0, 0), rotation=2 * pi),
                  "b": hinge("revolute", ["crank", "rod"], b),
                  "c": hinge("spherical", ["rod", "slider"], c),
                  "guide": {"kind": "prismatic", "bodies": ["ground", "slider"], "axis": [3, 0, 0],
                            "origin": [*c, 0], "force": -self.LOAD, "load_curve": "one"}}
        deck = {"bodies": bodies, "joints": joints, "time": {"steps": self.STEPS},
                "curves": {"one": [[0, 1], [1, 1]]}}
        result = self.solve(mesh, deck)
        lever = []
        for step in range(1, self.STEPS + 1):
            angle = self.START + 2 * pi * step / self.STEPS
            found = result.fields.globals(step)
            way = self.place(angle) - self.place(self.START)
            self.close(found["guide_translation"], way, POSITION)
            self.close(found["slider_displacement_x"], way, POSITION)
            s = self.CRANK * sin(angle)
            slope = -s - s * self.CRANK * cos(angle) / sqrt(self.ROD**2 - s**2)
            self.close(found["drive_moment_z"], self.LOAD * slope, FORCE * self.LOAD)
            # The rod pushes along itself; its component across goes into the guide.
            along = numpy.array([self.place(angle) - self.CRANK * cos(angle), -s])
            self.close([found["c_force_x"], found["c_force_y"], found["guide_force_y"]],
                       [self.LOAD, self.LOAD * along[1] / along[0],
                        -self.LOAD * along[1] / along[0]], FORCE * self.LOAD)
            lever.append(found["drive_moment_z"])
        self.assertLess(min(lever) * max(lever), -self.LOAD**2)


class SliderCrankUnderATinyForce(SliderCrank):
    LOAD = 4e-12


def vector(found, name):
    return numpy.array([found[f"{name}_{i}"] for i in "xyz"])


def turned(found, body, arm):
    """A vector of the reference configuration turned with a body."""
    w = vector(found, body + "_rotation")
    angle = numpy.linalg.norm(w)
    if angle == 0.0:
        return numpy.array(arm, float)
    e = w / angle
    return (numpy.cos(angle) * numpy.array(arm) + numpy.sin(angle) * numpy.cross(e, arm) +
            (1 - numpy.cos(angle)) * numpy.dot(e, arm) * e)


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


class Cam(Scene):
    """A round cam turns about a point off its center and lifts a flat follower against a spring."""
    RADIUS, OFF, FACETS, STEPS, STIFFNESS, PENALTY = 1.0, 0.3, 96, 24, 10.0, 1e4

    def cam(self):
        """A ring of bricks about (OFF, 0)."""
        nodes, cells = [], []
        for i in range(self.FACETS):
            a = 2 * pi * i / self.FACETS
            for r in (0.4, self.RADIUS):
                for z in (-0.1, 0.1):
                    nodes.append((self.OFF + r * cos(a), r * sin(a), z))
            n, m = 4 * i, 4 * ((i + 1) % self.FACETS)
            # bottom: inner, outer, next outer, next inner; side 2 is the outer face
            cells.append((n, n + 2, m + 2, m, n + 1, n + 3, m + 3, m + 1))
        return nodes, cells

    def blocks(self):
        return {"cam": self.cam(),
                "follower": brick((0, self.RADIUS + 0.1, 0), (4, 0.2, 0.2))}

    def scene(self):
        low = self.RADIUS
        mesh = mesh_of(self.blocks(), {"rim": [("cam", i, 1) for i in range(self.FACETS)],
                                       "flat": [("follower", 0, 0)]})
        deck = {
            "bodies": {"cam": free_body("cam", (self.OFF, 0.0)),
                       "follower": free_body("follower", (0, low + 0.1))},
            "joints": {"drive": hinge("revolute", ["ground", "cam"], (0, 0), rotation=2 * pi),
                       "guide": {"kind": "prismatic", "bodies": ["ground", "follower"],
                                 "axis": [0, 1, 0], "origin": [0, low + 0.1, 0]},
                       "spring": {"kind": "spring", "bodies": ["follower", "ground"],
                                  "from": [0, low + 0.2, 0], "to": [0, low + 2.2, 0],
                                  "stiffness": self.STIFFNESS, "free_length": 2.5}},
            "contact": {"pair": {"primary": "rim", "secondary": "flat",
                                 "formulation": "sliding_elastic", "penalty": self.PENALTY,
                                 "reach": 30}},
            "time": {"steps": self.STEPS}}
        return mesh, deck

    def test_lift_and_forces(self):
        self.check(self.solve(*self.scene()))

    def test_same_on_all_ranks(self):
        one, here = self.solve(*self.scene(), ranks=1), self.solve(*self.scene())
        self.same(one, here, self.STEPS, self.STIFFNESS)

    def febio(self):
        """The same from a FEBio file; its ground is a rigid body that is fixed."""
        blocks = {**self.blocks(), "frame": brick((0, -3, 0), 0.5)}
        nodes, parts, first, element = [], [], {}, 0
        for name, (x, cells) in blocks.items():
            first[name] = len(nodes) + 1
            nodes += [",".join(f"{v:.17g}" for v in point) for point in x]
            elements = ""
            for cell in cells:
                element += 1
                ids = ",".join(str(first[name] + n) for n in cell)
                elements += f'<elem id="{element}">{ids}</elem>'
            parts.append(f'<Elements type="hex8" name="{name}">{elements}</Elements>')
        nodes = "".join(f'<node id="{i}">{x}</node>' for i, x in enumerate(nodes, 1))
        faces = [(c[1], c[2], c[6], c[5]) for c in blocks["cam"][1]]
        rim = "".join(f'<quad4 id="{i}">' + ",".join(str(first["cam"] + n) for n in face) +
                      "</quad4>" for i, face in enumerate(faces, 1))
        flat = ",".join(str(first["follower"] + n) for n in (0, 1, 5, 4))
        materials = "".join(f'<material id="{i}" name="rigid {name}" type="rigid body">'
                            "<density>1</density></material>" for i, name in enumerate(blocks, 1))
        domains = "".join(f'<SolidDomain name="{name}" mat="rigid {name}"/>' for name in blocks)
        penalties = "<tolerance>0</tolerance><force_penalty>1e6</force_penalty>" \
                    "<moment_penalty>1e6</moment_penalty>"
        top = self.RADIUS + 0.2
        return f'''<?xml version="1.0" encoding="UTF-8"?>
<febio_spec version="4.0"><Module type="solid"/>
<Control><time_steps>{self.STEPS}</time_steps><step_size>{1 / self.STEPS:.17g}</step_size>
<solver type="solid"><dtol>0</dtol></solver></Control>
<Material>{materials}</Material>
<Mesh><Nodes name="all">{nodes}</Nodes>{"".join(parts)}
<Surface name="rim">{rim}</Surface><Surface name="flat"><quad4 id="1">{flat}</quad4></Surface>
<SurfacePair name="pair"><primary>rim</primary><secondary>flat</secondary></SurfacePair></Mesh>
<MeshDomains>{domains}</MeshDomains>
<Rigid>
<rigid_bc name="held" type="rigid_fixed"><rb>rigid frame</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof>
<Rz_dof>1</Rz_dof><Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>
<rigid_connector name="drive" type="rigid revolute joint">{penalties}
<body_a>rigid frame</body_a><body_b>rigid cam</body_b><joint_origin>0,0,0</joint_origin>
<rotation_axis>0,0,1</rotation_axis><transverse_axis>1,0,0</transverse_axis>
<prescribed_rotation>1</prescribed_rotation><rotation lc="1">{2 * pi:.17g}</rotation>
<moment>0</moment></rigid_connector>
<rigid_connector name="guide" type="rigid prismatic joint">{penalties}
<body_a>rigid frame</body_a><body_b>rigid follower</body_b>
<joint_origin>0,{self.RADIUS + 0.1},0</joint_origin><translation_axis>0,1,0</translation_axis>
<transverse_axis>1,0,0</transverse_axis></rigid_connector>
<rigid_connector name="spring" type="rigid spring"><body_a>rigid follower</body_a>
<body_b>rigid frame</body_b><k>{self.STIFFNESS}</k><insertion_a>0,{top},0</insertion_a>
<insertion_b>0,{top + 2},0</insertion_b><free_length>2.5</free_length></rigid_connector>
</Rigid>
<Contact><contact name="pair" surface_pair="pair" type="sliding-elastic"><penalty>{self.PENALTY}</penalty>
<search_radius>5</search_radius></contact></Contact>
<LoadData><load_controller id="1" type="loadcurve"><points><pt>0,0</pt><pt>1,1</pt></points>
</load_controller></LoadData></febio_spec>'''

    def test_from_febio(self):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / "cam.feb").write_text(self.febio())
        top = self.RADIUS + 2.2
        status, output = scenes.execute([scenes.EXECUTABLE, "import", str(folder / "cam.feb"),
                                         "--output-dir", str(folder)], 60)
        self.assertEqual(status, 0, output)
        self.assertIn("abut holds joints exactly", (folder / "cam.import.txt").read_text())
        result = scenes.run(folder / "cam.yaml", files=[folder / "cam.exo"])
        self.check(result)
        # What holds the frame balances what its three joints carry.
        for step in range(1, self.STEPS + 1):
            found = result.fields.globals(step)
            force = vector(found, "drive_force") + vector(found, "guide_force") - \
                vector(found, "spring_force")
            self.close(vector(found, "rigid_frame_force"), force, 1e-12)
            self.assertGreater(found["drive_force_y"], 1.0)
            at = numpy.array([0, self.RADIUS + 0.1 + found["guide_translation"], 0])
            moment = vector(found, "drive_moment") + vector(found, "guide_moment") + \
                numpy.cross(at, vector(found, "guide_force")) - \
                numpy.cross([0, top, 0], vector(found, "spring_force"))
            self.close(vector(found, "rigid_frame_moment"), moment, 1e-12)

    def check(self, result):
        self.assertEqual(result.summary["cut_backs"], 0)
        sagitta = self.RADIUS * (1 - cos(pi / self.FACETS))
        lifts = []
        for step in range(1, self.STEPS + 1):
            found = result.fields.globals(step)
            lift, angle = found["guide_translation"], 2 * pi * step / self.STEPS
            press = self.STIFFNESS * (0.5 + lift)
            self.close(found["spring_force_y"], press, FORCE)
            self.close(found["pair_force_y"], -press, FORCE)
            self.close(found["drive_moment_z"], press * self.OFF * cos(angle), FORCE)
            self.close(vector(found, "guide_force"), 0, FORCE)
            # A circle in a flat bed of springs, of a width of 0.2: force 4/3 w eps d sqrt(2 R d).
            depth = (press / (4 / 3 * 0.2 * self.PENALTY * sqrt(2 * self.RADIUS)))**(2 / 3)
            self.close(lift, self.OFF * sin(angle) - depth, sagitta)
            lifts.append(lift)
        self.assertGreater(max(lifts) - min(lifts), 1.9 * self.OFF)
        self.assertGreater(result.contact()["active_points"], 0)


class Flexible(Scene):
    """An elastic block between two rigid caps on hinges with the same axis, which turn alike."""

    def test_turns_without_stress(self):
        caps = {name: {"node_sets": [name], "rigid": {"free": FREE, "center": [0.3, 0.4, z]}}
                for name, z in (("z0", -0.2), ("z1", 1.3))}
        deck = {"mesh": {"generate": {"kind": "box", "divisions": [2, 2, 3], "distortion": 0.1}},
                "materials": {"rubber": {"young": 2, "poisson": 0.3}},
                "bodies": {"block": {"blocks": ["box"], "material": "rubber"}, **caps},
                "joints": {"drive": {"kind": "revolute", "bodies": ["ground", "z0"],
                                     "origin": [2, 0, 0], "axis": [0, 1, 1], "rotation": 3.5},
                           "rest": {"kind": "cylindrical", "bodies": ["ground", "z1"],
                                    "origin": [2, 0, 0], "axis": [0, 1, 1]}},
                "newton": {"tolerance": 1e-12}, "time": {"steps": 14}}
        result = scenes.run(deck)
        found = result.fields.globals()
        self.close([found["drive_rotation"], found["rest_rotation"]], 3.5, 1e-9)
        self.close(found["rest_translation"], 0, 1e-9)
        axis, x = numpy.array([0, 1, 1]) / sqrt(2), result.fields.coordinates - [2, 0, 0]
        moved = cos(3.5) * x + sin(3.5) * numpy.cross(axis, x) + \
            (1 - cos(3.5)) * numpy.outer(x @ axis, axis)
        self.close(result.fields.vector("displacement"), moved - x, 1e-8)
        self.assertLess(result.fields.element("von_mises", "box").max(), 1e-8)
        self.close([*vector(found, "drive_force"), *vector(found, "drive_moment")], 0, 1e-8)

    def test_twisted(self):
        """The moments of drive and support balance, and the drive's work is stored."""
        caps = {name: {"node_sets": [name], "rigid": {"free": FREE, "center": [0.5, 0.5, z]}}
                for name, z in (("z0", 0.0), ("z1", 1.0))}
        hinges = {"drive": {"kind": "revolute", "bodies": ["ground", "z1"],
                            "origin": [0.5, 0.5, 1], "axis": [0, 0, 1], "rotation": 0.5},
                  "rest": {"kind": "lock", "bodies": ["ground", "z0"], "origin": [0.5, 0.5, 0]}}
        deck = {"mesh": {"generate": {"kind": "box", "divisions": [2, 2, 3]}},
                "materials": {"rubber": {"young": 2, "poisson": 0.3}},
                "bodies": {"block": {"blocks": ["box"], "material": "rubber"}, **caps},
                "joints": hinges, "time": {"steps": 8}}
        result = scenes.run(deck)
        found = result.fields.globals()
        self.assertGreater(found["drive_moment_z"], 0.02)
        self.close(vector(found, "drive_moment")[2] + vector(found, "rest_moment")[2], 0, 1e-8)
        self.close(vector(found, "drive_force") + vector(found, "rest_force"), 0, 1e-8)
        energy = result.summary["energy"]
        self.assertGreater(energy["stored"], 0.005)
        self.assertLess(abs(energy["imbalance"]), 2e-3 * energy["stored"])


class Refused(Scene):
    def deck(self, **joint):
        self.mesh = mesh_of({"link": bar((0, 0), (1, 0)), "rail": bar((0, 1), (1, 1))})
        return {"bodies": {"link": free_body("link", (0, 0)),
                           "rail": {"blocks": ["rail"], "rigid": {}}},
                "joints": {"pin": {**hinge("revolute", ["rail", "link"], (0, 0), rotation=1.0),
                                   **joint}},
                "time": {"steps": 2}}

    def expect(self, message, changes=None, status=2, command="check", **joint):
        deck = scenes.merged(self.deck(**joint), changes or {})
        result = self.solve(self.mesh, deck, command=command, check=False)
        self.assertEqual(result.status, status, result.output)
        self.assertRegex(result.output, message)

    def test_deck(self):
        self.expect("the deck is valid", status=0)
        self.expect(r"joints\.pin\.kind: .*revolut'.*did you mean 'revolute'", kind="revolut")
        self.expect(r"joints\.pin\.bodies: 'lik' is not a name under bodies", bodies=["lik", "rail"])
        self.expect(r"joints\.pin\.bodies: expected the names of two", bodies=["link", "link"])
        self.expect(r"joints\.pin\.bodies: expected the names of two", bodies=["link"])
        self.expect(r"joints\.pin\.axis: expected a direction", axis=[0, 0, 0])
        self.expect(r"joints\.pin\.moment: the rotation is prescribed", moment=2)
        self.expect(r"joints\.pin\.translation: unknown key", translation=2)
        self.expect(r"joints\.pin\.curve: 'up' is not a name under curves", curve="up")
        self.expect(r"linear_solver\.method: joints need a direct solver",
                    {"linear_solver": {"method": "krylov"}})
        self.expect(r"joints\.s\.to: the spring has no length",
                    {"joints": {"s": {"kind": "spring", "bodies": ["link", "ground"],
                                      "from": [0, 0, 0], "to": [0, 0, 0], "stiffness": 1}}})
        self.expect(r"bodies: the motion of all bodies is prescribed",
                    {"bodies": {"link": {"rigid": {"free": None}}}})
        self.expect(r"verify\.v\.place: 'pn' is not a name under joints",
                    {"verify": {"v": scenes.probe("joint_rotation", "pn")}})

    def test_what_a_joint_leaves_free_is_told(self):
        self.expect(r"body 'link' is free to move: rotation about z\.",
                    {"joints": {"pin": {"rotation": None}}})

    def test_joints_that_contradict_each_other(self):
        """The run stops with the joint's name; what holds twice without contradiction runs."""
        second = hinge("revolute", ["ground", "link"], (0, 0))
        self.expect("^$", {"joints": {"second": second}}, status=0, command="run")
        second["origin"] = [1, 0, 0]
        self.expect(r"Joint 'pin' cannot hold its rotation about its axis: other joints",
                    {"joints": {"second": second}}, status=1, command="run")

    def test_dead_point(self):
        """A slider cannot drive its crank from where all three joints lie on a line."""
        mesh = mesh_of({"crank": bar((0, 0), (1, 0)), "rod": bar((1, 0), (3, 0)),
                        "slider": brick((3, 0, 0), 0.3)})
        deck = {"bodies": {name: free_body(name, (0, 0)) for name in ("crank", "rod", "slider")},
                "joints": {"a": hinge("revolute", ["ground", "crank"], (0, 0)),
                           "b": hinge("revolute", ["crank", "rod"], (1, 0)),
                           "c": hinge("revolute", ["rod", "slider"], (3, 0)),
                           "drive": {"kind": "prismatic", "bodies": ["ground", "slider"],
                                     "axis": [1, 0, 0], "origin": [3, 0, 0], "translation": -0.5}}}
        result = self.solve(mesh, deck, check=False)
        self.assertEqual(result.status, 2)
        self.assertRegex(result.output, "is free to move: ")

    def test_steps_of_more_than_half_a_turn_are_cut(self):
        deck = self.deck(rotation=8.0)
        result = self.solve(self.mesh, scenes.merged(deck, {"verify": {
            "turn": scenes.probe("joint_rotation", "pin"),
            "body": scenes.probe("rigid_rotation_z", "link"),
            "moment": scenes.probe("joint_moment_z", "pin")}}))
        self.close(result.quantity("turn"), 8.0, POSITION)
        self.close(result.quantity("body"), 8.0, POSITION)
        self.assertGreater(result.summary["cut_backs"], 0)


if __name__ == "__main__":
    unittest.main()
