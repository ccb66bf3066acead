# SPDX-License-Identifier: BSD-3-Clause
"""Friction where methods fail: no pressure, no slip direction, coincident nodes, release, repeated steps."""
import math
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import scenes

MAPS = [("node_on_facet", "incremental"), ("facet_on_facet", "incremental"),
        ("sliding_elastic", "inclined_ray"), ("sliding_elastic", "incremental")]
ENFORCEMENTS = ("penalty", "augmented_lagrangian")
MU = 0.3


def each():
    return [(*m, e) for m in MAPS for e in ENFORCEMENTS]


def pair(formulation, friction_map, enforcement, **changes):
    return {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "formulation": formulation,
                     "friction_map": friction_map, "enforcement": enforcement, "friction": MU,
                     "multipliers": "per_point",
                     "multiplier_tolerance": 1e-6, "max_augmentations": 50, **changes}}


def blocks(contact, poisson=0.3, **generate):
    """Two elastic blocks, the lower one held at its bottom."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [2, 2, 1], "lower_divisions": [4, 4, 2],
                              "upper_divisions": [2, 2, 2], **generate}},
        "materials": {"m": {"model": "linear_elastic", "young": 1.0, "poisson": poisson}},
        "bodies": {name: {"blocks": [name], "material": "m"} for name in ("lower", "upper")},
        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]}},
        "contact": contact,
    }


class NoForce(unittest.TestCase):
    """S08: a block that touches another one exactly, without any load: nothing may move or be singular."""

    def check(self, deck):
        result = scenes.run(deck)
        u = result.fields.vector("displacement")
        self.assertTrue(numpy.isfinite(u).all())
        self.assertLess(numpy.abs(u).max(), 2e-12)
        self.assertLess(numpy.abs(result.force()).max(), 1e-10)
        self.assertEqual(result.summary["cut_backs"], 0)

    def test_block_that_only_touches(self):
        for case in each():
            with self.subTest(case=case):
                self.check(blocks(pair(*case)))

    def test_held_block_with_a_gap_of_rounding(self):
        for formulation, friction_map in MAPS:
            for gap in (0.0, 1e-17, 1e-12):
                with self.subTest(formulation=formulation, map=friction_map, gap=gap):
                    deck = blocks(pair(formulation, friction_map, "penalty"), gap=gap)
                    deck["displacements"]["top"] = {"set": "upper_top", "fix": ["x", "y", "z"]}
                    self.check(deck)


class SpinningPad(unittest.TestCase):
    """S15: a plate turns under a pad about its middle, where nothing slips: torque mu p sum w r, by the points' weights w
    and distances r. Friction opposes the chord of a step, the moment arm is at its end: cos(turn / 2)."""

    TURN, STEPS = 0.1, 5

    def lever(self, formulation):
        """sum w r / area: three points in each of 3 x 3 faces, or the nodes; one of each at r = 0."""
        if formulation == "node_on_facet":
            x, w = numpy.linspace(-0.5, 0.5, 5), numpy.array([.5, 1, 1, 1, .5]) / 4
        else:
            gauss, weights = numpy.polynomial.legendre.leggauss(3)
            x = numpy.concatenate([(2 * i + gauss) / 6 for i in (-1, 0, 1)])
            w = numpy.tile(weights / 6, 3)
        return numpy.einsum("i,j,ij->", w, w, numpy.hypot(*numpy.meshgrid(x, x)))

    def test_torque(self):
        with tempfile.TemporaryDirectory() as folder:
            self.check_torques(pathlib.Path(folder) / "scene.exo")

    def check_torques(self, path):
        for case in each():
            nodes = case[0] == "node_on_facet"
            start = 1 / (self.STEPS + 1)
            mesh = exodus_edit.read(scenes.mesh(path, "blocks", lower_size=[3, 3, 1], lower_divisions=[4, 4, 1],
                                                upper_divisions=[4, 4, 1] if nodes else [3, 3, 1]))
            pad = mesh.node_sets["upper_bottom"]
            mesh.node_sets.update({f"n{node}": numpy.array([node]) for node in pad})
            exodus_edit.write(path, mesh)
            deck = {
                "mesh": {"file": "scene.exo"},
                "materials": {"m": {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}},
                "bodies": {"lower": {"blocks": ["lower"],
                                     "rigid": {"center": [1.5, 1.5, 1], "rotation": [0, 0, self.TURN],
                                               "curve": "turn"}},
                           "upper": {"blocks": ["upper"], "material": "m"}},
                "curves": {"press": [[0, 0], [start, 1]], "turn": [[start, 0], [1, 1]]},
                "displacements": {"plan": {"set": "upper_bottom", "fix": ["x", "y"]},
                                  "top": {"set": "upper_top", "fix": ["x", "y"]},
                                  "press": {"set": "upper_top", "z": -1e-3, "curve": "press"}},
                "contact": pair(*case, penalty=1e3, points=3, multiplier_tolerance=1e-9),
                "time": {"steps": self.STEPS + 1}, "newton": {"tolerance": 1e-9},
                "verify": {f"{axis}{node}": scenes.probe(f"reaction_{axis}", f"n{node}")
                           for node in pad for axis in "xy"},
            }
            with self.subTest(case=case):
                result = scenes.run(deck, files=[path])
                force = result.force()[2]
                exact = MU * force * self.lever(case[0]) * math.cos(self.TURN / self.STEPS / 2)
                arm = mesh.x[pad] - [1.5, 1.5, 1]
                # the pad is held at its nodes: their reactions balance the friction of the turning plate
                torque = -sum(r[0] * result.quantity(f"y{node}") - r[1] * result.quantity(f"x{node}")
                              for r, node in zip(arm, pad))
                print(f"spinning pad  {' '.join(case):50s} torque/exact - 1 {torque / exact - 1:8.1e}  stick "
                      f"{result.contact()['stick_points']} slip {result.contact()['slip_points']}")
                self.assertTrue(numpy.isfinite(result.fields.vector("contact_traction")).all())
                self.assertEqual(result.contact()["active_points"], 64 if nodes else 81)
                self.assertLess(abs(torque / exact - 1), 1e-6)
                self.assertLess(numpy.abs(result.force()[:2]).max(), 1e-9 * force)


class CoincidentNodes(unittest.TestCase):
    """S30: nodes and points right above nodes and edges of the other mesh."""

    WAY = 0.002  # moves part of the points

    def solve(self, mesh, case, folder, **contact):
        path = pathlib.Path(folder) / "scene.exo"
        exodus_edit.write(path, mesh)
        deck = blocks(pair(*case, **contact))
        deck["mesh"] = {"file": "scene.exo"}
        deck["displacements"]["top"] = {"set": "upper_top", "y": 0, "x": self.WAY, "z": -0.02}
        deck["time"], deck["newton"] = {"steps": 2}, {"tolerance": 1e-11}
        return scenes.run(deck, files=[path])

    def compare(self, case, shifts, permutations, folder, **contact):
        generated = scenes.mesh(pathlib.Path(folder) / "generated.exo", "blocks", lower_size=[2, 2, 1],
                                lower_divisions=[4, 4, 2], upper_divisions=[2, 2, 2])
        original = exodus_edit.read(generated)
        upper = numpy.unique(original.blocks[[b.name for b in original.blocks].index("upper")].nodes)
        random, reference, worst = numpy.random.default_rng(1), None, 0.0
        for shift in shifts:
            for number in range(permutations + 1):
                mesh = exodus_edit.read(generated)
                mesh.x[upper, :2] += shift
                place = numpy.arange(len(mesh.x))
                if number:
                    mesh, place = exodus_edit.permute(mesh, random)
                result = self.solve(mesh, case, folder, **contact)
                u = result.fields.vector("displacement")[place]
                counts = [result.contact()[key] for key in ("stick_points", "slip_points")]
                if reference is None:
                    reference = u, counts
                self.assertEqual(counts, reference[1])
                worst = max(worst, numpy.abs(u - reference[0]).max() / numpy.abs(u).max())
        print(f"coincident  {' '.join(case):50s} shift {shifts[0]:g} {contact or ''}: stick/slip {counts}, "
              f"largest difference {worst:8.1e}")
        self.assertGreater(max(counts), 0)
        self.assertLess(worst, 1e-10)
        return sum(counts)

    def test_aligned(self):
        with tempfile.TemporaryDirectory() as folder:
            for case in [(*m, "penalty") for m in MAPS[1:]] + [(*MAPS[2], "augmented_lagrangian")]:
                with self.subTest(case=case):
                    points = self.compare(case, (0.0, 1e-16, 1e-12, -1e-12), 1, folder)
                    self.assertEqual(points, 16)

    def test_points_above_edges_and_nodes(self):
        """A quarter aside, three points in a face: rows of points above edges of the other mesh."""
        with tempfile.TemporaryDirectory() as folder:
            for case in [(*m, "penalty") for m in MAPS[1:]]:
                with self.subTest(case=case):
                    self.assertGreater(self.compare(case, (0.25,), 2, folder, points=3), 30)

    def test_no_point_is_missed_or_counted_twice(self):
        """On a rigid plate, poisson 0: uniform pressure E d / (H + E / eps), eps = 10 E / (H / 2)."""
        with tempfile.TemporaryDirectory() as folder:
            generated = scenes.mesh(pathlib.Path(folder) / "generated.exo", "blocks", lower_size=[2, 2, 1],
                                    lower_divisions=[4, 4, 2], upper_divisions=[2, 2, 2])
            for case in each():
                for shift in (0.0, 1e-16, -1e-16, 1e-12, -1e-12, 0.25):
                    mesh = exodus_edit.read(generated)
                    names = [block.name for block in mesh.blocks]
                    mesh.x[numpy.unique(mesh.blocks[names.index("upper")].nodes), :2] += shift
                    path = pathlib.Path(folder) / "scene.exo"
                    exodus_edit.write(path, mesh)
                    deck = blocks(pair(*case, points=3), poisson=0.0)
                    deck["mesh"] = {"file": "scene.exo"}
                    deck["bodies"]["lower"] = {"blocks": ["lower"], "rigid": {}}
                    deck["displacements"] = {"top": {"set": "upper_top", "x": 0, "y": 0, "z": -0.02}}
                    with self.subTest(case=case, shift=shift):
                        result = scenes.run(deck, files=[path])
                        exact = 0.02 / (1.05 if case[2] == "penalty" else 1.0)
                        self.assertEqual(result.contact()["active_points"],
                                         16 if case[0] == "node_on_facet" else 36)
                        # the multipliers stop at 1e-6, each augmentation leaves 1/21
                        self.assertLess(abs(result.force()[2] / exact - 1),
                                        1e-8 if case[2] == "penalty" else 1e-6)


class Release(unittest.TestCase):
    """S39: pressed, pulled off: nothing pulls, and the way back is the way there."""

    def ball(self, formulation, enforcement, mu, **contact):
        return {
            "mesh": {"generate": {"kind": "sphere_plane", "facets": 3, "core": 0.3}},
            "materials": {"m": {"young": 1.0, "poisson": 0.3}},
            "bodies": {"sphere": {"blocks": ["sphere"], "material": "m"},
                       "plate": {"blocks": ["plate"],
                                 "rigid": {"displacement": [0, 0, 0.03], "curve": "c"}}},
            "displacements": {"x0": {"set": "x0", "fix": ["x"]}, "y0": {"set": "y0", "fix": ["y"]},
                              "top": {"set": "top", "fix": ["z"]}},
            "curves": {"c": [[0, 0], [0.4, 1], [1, -0.5]]},
            "contact": {"pair": {"primary": "contact", "secondary": "plate_top", "friction": mu,
                                 "formulation": formulation, "enforcement": enforcement,
                                 "multiplier_tolerance": 1e-4, **contact}},
            "time": {"steps": 10}, "newton": {"tolerance": 1e-9},
        }

    def forces(self, fields):
        return numpy.array([fields.globals(i)["pair_force_z"] for i in range(len(fields.times))])

    def test_pulled_off(self):
        for formulation in ("node_on_facet", "facet_on_facet", "sliding_elastic"):
            for enforcement, mu in (("penalty", 0.0), ("penalty", MU), ("augmented_lagrangian", 0.0)):
                with self.subTest(formulation=formulation, enforcement=enforcement, mu=mu):
                    result = scenes.run(self.ball(formulation, enforcement, mu))
                    fields = result.fields
                    force = {round(t, 6): f for t, f in zip(fields.times, self.forces(fields))}
                    self.assertGreater(force[0.4], 1e-4)
                    # the plate passes 1/4, 1/2 and 3/4 of its way up twice
                    loop = max(abs(force[round(0.1 * i, 6)] - force[round(0.8 - 0.1 * i, 6)])
                               for i in (1, 2, 3)) / force[0.4]
                    print(f"release  {formulation:16s} {enforcement:21s} mu {mu}: "
                          f"difference of the ways {loop:8.1e}")
                    if mu == 0:
                        self.assertLess(loop, 1e-8 if enforcement == "penalty" else 1e-4)
                    for step in range(len(fields.times)):
                        self.assertGreaterEqual(fields.nodal("contact_pressure", step).min(), 0.0)
                    self.assertEqual(max(abs(f) for t, f in force.items() if t > 0.81), 0.0)
                    self.assertEqual(result.contact()["active_points"], 0)

    def test_tension_keeps_it(self):
        result = scenes.run(self.ball("facet_on_facet", "penalty", 0.0, tension=True))
        self.assertLess(self.forces(result.fields)[-1], -1e-6)


class CutBack(unittest.TestCase):
    """S33: a step that fails leaves no trace: friction as if the smaller steps had been asked for."""

    CURVES = {"press": [[0, 0], [0.25, 1], [1, 1]], "slide": [[0, 0], [0.25, 0], [0.5, 1], [1, -1]]}

    def deck(self, case, curves, steps, newton):
        # no node above an edge: which face the closest point takes there may depend on the path
        deck = blocks(pair(*case), lower_divisions=[5, 5, 1], upper_divisions=[2, 2, 1])
        deck["displacements"].update(top={"set": "upper_top", "y": 0, "z": -0.02, "curve": "press"},
                                     slide={"set": "upper_top", "x": 0.02, "curve": "slide"})
        deck.update(curves=curves, time={"steps": steps}, newton={"tolerance": 1e-11, **newton})
        return deck

    def test_equals_smaller_steps(self):
        for case in each():
            with self.subTest(case=case):
                cut = self.cut_run(case)
                self.assertIsNotNone(cut, "no limit of the iterations cuts a step and still ends")
                times, count = cut.fields.times, cut.summary["steps"]
                self.assertGreater(count, 4)
                curves = {name: [[i / count, float(numpy.interp(t, *zip(*knots)))]
                                 for i, t in enumerate(times)] for name, knots in self.CURVES.items()}
                direct = scenes.run(self.deck(case, curves, count, {}))
                self.assertEqual(direct.summary["cut_backs"], 0)
                self.assertEqual(direct.summary["steps"], count)
                u, v = cut.fields.vector("displacement"), direct.fields.vector("displacement")
                error = numpy.abs(u - v).max() / numpy.abs(v).max()
                work = (cut.contact()["friction_dissipation"] / direct.contact()["friction_dissipation"]) - 1
                print(f"cut-back  {' '.join(case):50s} {cut.summary['cut_backs']} cuts, {count} steps: "
                      f"difference {error:8.1e}  work {work:8.1e}")
                self.assertLess(error, 1e-10)
                self.assertLess(abs(work), 1e-8)
                self.assertGreater(direct.contact()["slip_points"], 0)

    def cut_run(self, case):
        """The run with the largest limit of Newton iterations that fails in some step and ends well."""
        for limit in range(14, 3, -1):
            result = scenes.run(self.deck(case, self.CURVES, 4, {"max_iterations": limit}), check=False)
            if result.status == 0 and result.summary["cut_backs"] > 0:
                return result
        return None


if __name__ == "__main__":
    unittest.main()
