# SPDX-License-Identifier: BSD-3-Clause
"""Linkages that turn over a whole turn: motion and forces in closed form."""
import unittest
from math import atan2, cos, pi, sin, sqrt

import numpy

from mechanisms import FORCE, POSITION, Scene, bar, brick, free_body, hinge, mesh_of


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


if __name__ == "__main__":
    unittest.main()
