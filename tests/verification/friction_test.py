# SPDX-License-Identifier: BSD-3-Clause
"""Coulomb friction of an elastic block on a rigid plane: exact thresholds, tractions and displacements.

At poisson 0 a block under the pressure p and the shear stress q on all faces that carry it is in a uniform
state: the interface has pressure p and shear traction q everywhere, sticks for q < mu p, and its upper end
moves by q (1/eps + H/G), in the augmented Lagrangian by q H/G.

Where the block is led along a path instead, its traction t after a step is the radial return of
t - eps (step of the path) to mu p: `returned` below, which is exact for a pressure that stays.
"""
import math
import unittest

import numpy

import scenes

MAPS = [("node_on_facet", "incremental"), ("facet_on_facet", "incremental"),
        ("sliding_elastic", "inclined_ray"), ("sliding_elastic", "incremental")]
ENFORCEMENTS = ("penalty", "augmented_lagrangian")
MU, PRESSURE = 0.3, 1e-3
EPSILON = 20.0  # 10 E / h, cells 1/2 high
SHEAR_COMPLIANCE = 2.0  # H / G
NEWTON = 1e-10  # relative; rounding of positions of order 1 against p / eps leaves 1e-12


def pair(formulation, friction_map, enforcement, **changes):
    return {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "formulation": formulation,
                     "friction_map": friction_map, "enforcement": enforcement, "friction": MU,
                     "multiplier_tolerance": 1e-9, "max_augmentations": 100, **changes}}


def block(divisions=(2, 2, 2)):
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [3, 3, 1], "lower_divisions": [4, 4, 1],
                              "upper_divisions": list(divisions)}},
        "materials": {"m": {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}},
        "bodies": {"lower": {"blocks": ["lower"], "rigid": {}},
                   "upper": {"blocks": ["upper"], "material": "m"}},
        "newton": {"tolerance": NEWTON},
    }


def pushed(contact, ratio, push, steps, press=0.5):
    """Pressed until t = press, then sheared by ratio mu p times the curve `push`; only friction holds it."""
    shear = ratio * MU * PRESSURE
    return {**block(), "contact": contact, "time": {"steps": steps, "adaptive": False},
            "curves": {"press": [[0, 0], [press, 1]], "push": push},
            "loads": {"press": {"side_set": "upper_top", "traction": [0, 0, -PRESSURE], "curve": "press"},
                      **{place: {"side_set": place, "traction": traction, "curve": "push"}
                         for place, traction in (("upper_top", [shear, 0, 0]), ("upper_x1", [0, 0, shear]),
                                                 ("upper_x0", [0, 0, -shear]))}}}


def led(contact, path, divisions=(2, 2, 1), **changes):
    """Pressed in the first step by a dead load, then led through the points (x, y) of the path, one a step.
    The block is one cell high: all its nodes are led."""
    steps = len(path) + 1
    knots = [(i + 1) / steps for i in range(steps)]
    curve = {axis: [[0, 0], [knots[0], 0]] + [[t, float(point[i])] for t, point in zip(knots[1:], path)]
             for i, axis in enumerate("xy")}
    return scenes.merged({
        **block(divisions), "contact": contact, "time": {"steps": steps, "adaptive": False},
        "curves": {"press": [[0, 0], [knots[0], 1]], **curve},
        "loads": {"press": {"side_set": "upper_top", "traction": [0, 0, -PRESSURE], "curve": "press"}},
        "displacements": {axis + end: {"set": "upper_" + end, axis: 1.0, "curve": axis}
                          for axis in "xy" for end in ("top", "bottom")}}, changes)


def returned(path, epsilon, limit):
    """Tractions after each step of the path and the work spent on slip."""
    traction, work, last, tractions = numpy.zeros(2), 0.0, numpy.zeros(2), []
    for point in numpy.asarray(path, float):
        trial = traction - epsilon * (point - last)
        size = numpy.linalg.norm(trial)
        traction = trial * min(1.0, limit / size) if size > 0 else trial
        work += limit * max(0.0, size - limit) / epsilon
        last = point
        tractions.append(traction)
    return numpy.array(tractions), work


def shear_forces(result):
    """Tangential force on the block after each step behind the first one."""
    steps = range(2, len(result.fields.times))
    return numpy.array([[result.fields.globals(i)["pair_force_" + axis] for axis in "xy"] for i in steps])


def each():
    return [(*m, e) for m in MAPS for e in ENFORCEMENTS]


class Threshold(unittest.TestCase):
    """The load that slides the block is mu N, bracketed by 1 -+ 1e-6."""

    def test_just_below_sticks(self):
        for case in each():
            with self.subTest(case=case):
                ratio = 1 - 1e-6
                deck = pushed(pair(*case), ratio, [[0.5, 0], [1, 1]], 2)
                deck["verify"] = {"top": scenes.probe("displacement_x", "upper_top"),
                                  "bottom": scenes.probe("displacement_x", "upper_bottom")}
                result = scenes.run(deck)
                slack = 0.0 if case[2] != "penalty" else 1 / EPSILON
                top = ratio * MU * PRESSURE * (slack + SHEAR_COMPLIANCE)
                error = result.quantity("top") / top - 1
                print(f"stick 1 - 1e-6  {' '.join(case):50s} u/exact - 1 {error:9.1e}")
                self.assertEqual(result.contact()["slip_points"], 0)
                self.assertEqual(result.contact()["stick_points"], 16)
                self.assertLess(abs(error), 1e-8)
                self.assertLess(abs(result.quantity("bottom") - slack * ratio * MU * PRESSURE), 1e-11)
                self.assertLess(abs(-result.force()[0] / result.force()[2] / MU / ratio - 1), 1e-9)

    def test_just_above_slides(self):
        for case in each():
            with self.subTest(case=case):
                ratio = 1 + 1e-6
                deck = pushed(pair(*case), ratio, [[0.5, 0], [1, 1]], 2)
                result = scenes.run(deck, check=False)
                self.assertEqual(result.status, 1, result.output)
                self.assertEqual(result.fields.times[-1], 0.5)
                self.assertIn("singular", result.output)

    def test_led_block_slides_at_the_threshold(self):
        """Penalty: the end of sticking is the way mu p / eps."""
        limit = MU * PRESSURE
        for formulation, friction_map in MAPS:
            for k in (2, 4, 6):
                for sign, status in ((-1, "stick_points"), (1, "slip_points")):
                    with self.subTest(formulation=formulation, map=friction_map, k=k, sign=sign):
                        way = limit / EPSILON * (1 + sign * 10.0**-k)
                        deck = led(pair(formulation, friction_map, "penalty", penalty=EPSILON), [(way, 0)])
                        result = scenes.run(deck)
                        self.assertEqual(result.contact()[status], 16)
                        force = min(1.0, 1 + sign * 10.0**-k)
                        self.assertLess(abs(-result.force()[0] / limit - force), 1e-9)

    def test_full_slip_of_an_elastic_block_on_an_elastic_plate(self):
        """The surface tilts as the strain does, and T/N - mu with it."""
        strain = 1e-5
        for case in each():
            with self.subTest(case=case):
                # a node right above an edge may take either face: none is, for node_on_facet
                faces = 5 if case[0] == "node_on_facet" else 4
                deck = scenes.merged(block(), {
                    "mesh": {"generate": {"lower_divisions": [faces, faces, 1]}},
                    "materials": {"m": {"poisson": 0.3}},
                    "bodies": {"lower": {"rigid": None, "material": "m"}},
                    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                                      "top": {"set": "upper_top", "y": 0, "x": 0.02, "curve": "slide"}},
                    "loads": {"press": {"side_set": "upper_top", "traction": [0, 0, -strain],
                                        "curve": "press"}},
                    "curves": {"press": [[0, 0], [0.5, 1]], "slide": [[0.5, 0], [1, 1]]},
                    "time": {"steps": 4}, "newton": {"tolerance": 1e-8}})
                deck["contact"] = pair(*case, multiplier_tolerance=1e-5)
                result = scenes.run(deck)
                force = result.force()
                error = -force[0] / force[2] / MU - 1
                print(f"T/(mu N) - 1, elastic  {' '.join(case):50s} {error:9.1e}  "
                      f"slip {result.contact()['slip_points']} stick {result.contact()['stick_points']}")
                self.assertEqual(result.contact()["stick_points"], 0)
                self.assertGreater(result.contact()["slip_points"], 8)
                self.assertLess(abs(error), 1e-4)


class Hold(unittest.TestCase):
    """Half of the threshold, held or reversed, moves nothing."""

    def drift(self, case, push, steps, compare):
        deck = pushed(pair(*case), 0.5, push, steps, press=1 / steps)
        fields = scenes.run(deck).fields
        reference = fields.vector("displacement", compare[0])
        self.assertGreater(numpy.abs(reference[fields.node_set("upper_top"), 0]).max(), 2e-4)
        return max(numpy.abs(fields.vector("displacement", i) - reference).max() for i in compare[1:])

    def test_held_for_100_steps(self):
        for case in each():
            with self.subTest(case=case):
                steps = 102
                drift = self.drift(case, [[1 / steps, 0], [2 / steps, 1]], steps, range(2, steps + 1))
                print(f"drift in 100 steps  {' '.join(case):50s} {drift:8.1e}")
                self.assertLess(drift, 1e-10)

    def test_reversed_20_times(self):
        for case in each():
            with self.subTest(case=case):
                steps = 42
                push = [[1 / steps, 0]] + [[(i + 2) / steps, (-1)**i] for i in range(41)]
                drift = self.drift(case, push, steps, range(2, steps + 1, 2))
                print(f"drift in 20 cycles  {' '.join(case):50s} {drift:8.1e}")
                self.assertLess(drift, 1e-10)


class Path(unittest.TestCase):
    """Blocks led along paths of many elastic slips mu p / eps."""

    LIMIT = MU * PRESSURE

    def measure(self, case, path, epsilon=EPSILON):
        result = scenes.run(led(pair(*case, penalty=epsilon), path))
        return shear_forces(result), result

    def test_direction_is_the_one_of_slip(self):
        """37 degrees to the mesh: as much friction as along it, against the motion."""
        angle = math.radians(37)
        way = 50 * self.LIMIT / EPSILON * numpy.array([math.cos(angle), math.sin(angle)])
        for case in each():
            with self.subTest(case=case):
                forces, result = self.measure(case, [way * i / 3 for i in (1, 2, 3)])
                force = forces[-1]
                turn = (force[1] * way[0] - force[0] * way[1]) / numpy.linalg.norm(way) / self.LIMIT
                size = numpy.linalg.norm(force) / self.LIMIT - 1
                print(f"37 degrees  {' '.join(case):50s} turn {turn:8.1e}  size {size:8.1e}")
                self.assertEqual(result.contact()["slip_points"], 16)
                self.assertLess(abs(turn), 1e-8)
                self.assertLess(abs(size), 1e-8)
                self.assertLess(force @ way, 0)

    def test_reversal(self):
        """Stick, slip, back through 2 mu p / eps of sticking, slip, aside."""
        step = self.LIMIT / EPSILON
        path = [(.6 * step, 0), (1.3 * step, 0), (5 * step, 0), (4.2 * step, 0), (3.01 * step, 0),
                (2.9 * step, 0), (-5 * step, 0), (-5 * step, .7 * step), (-5 * step, 9 * step)]
        exact, _ = returned(path, EPSILON, self.LIMIT)
        self.assertEqual([bool(abs(numpy.linalg.norm(t) / self.LIMIT - 1) < 1e-12) for t in exact],
                         [False, True, True, False, False, True, True, True, True])
        for formulation, friction_map in MAPS:
            with self.subTest(formulation=formulation, map=friction_map):
                forces, _ = self.measure((formulation, friction_map, "penalty"), path)
                error = numpy.abs(forces - exact).max() / self.LIMIT
                print(f"reversal  {formulation} {friction_map}: {error:8.1e}")
                self.assertLess(error, 1e-8)

    def circle(self, steps, radius):
        angles = [math.pi / 2 * (i + 1) / steps for i in range(steps)]
        return [(radius * math.sin(a), radius * (1 - math.cos(a))) for a in angles]

    def test_quarter_circle_in_penalty(self):
        """Every traction and the work as by the radial return."""
        radius = 30 * self.LIMIT / EPSILON
        path = self.circle(10, radius)
        exact, work = returned(path, EPSILON, self.LIMIT)
        for formulation, friction_map in MAPS:
            with self.subTest(formulation=formulation, map=friction_map):
                forces, result = self.measure((formulation, friction_map, "penalty"), path)
                error = numpy.abs(forces - exact).max() / self.LIMIT
                spent = result.contact()["friction_dissipation"] / work - 1
                print(f"quarter circle  {formulation} {friction_map}: force {error:8.1e}  work {spent:8.1e}")
                self.assertLess(error, 1e-8)
                self.assertLess(abs(spent), 1e-8)

    def test_quarter_circle_in_augmented_lagrangian(self):
        """Without elastic slip the force opposes the chord: it lags by pi / (4 N), first order, and the
        work is that of the chords, second order."""
        radius = 0.1  # 1e3 elastic slips a step: each augmentation leaves 1e-3 of the error
        for formulation, friction_map in MAPS:
            with self.subTest(formulation=formulation, map=friction_map):
                lags, losses = [], []
                for steps in (5, 10, 20):
                    forces, result = self.measure((formulation, friction_map, "augmented_lagrangian"),
                                                  self.circle(steps, radius))
                    lags.append(math.pi / 2 - math.atan2(-forces[-1][1], -forces[-1][0]))
                    work = result.contact()["friction_dissipation"]
                    losses.append(1 - work / (self.LIMIT * radius * math.pi / 2))
                    chord = math.pi / (4 * steps)
                    self.assertEqual(result.contact()["slip_points"], 16)
                    self.assertLess(abs(lags[-1] - chord), 1e-6)
                    self.assertLess(abs(losses[-1] - (1 - math.sin(chord) / chord)), 1e-6)
                print(f"quarter circle  {formulation} {friction_map}: lag 4N/pi "
                      f"{[round(lag * 4 * n / math.pi, 7) for lag, n in zip(lags, (5, 10, 20))]}  work lost "
                      f"{[float(f'{loss:.4g}') for loss in losses]}")


if __name__ == "__main__":
    unittest.main()
