# SPDX-License-Identifier: BSD-3-Clause
"""Several interfaces at once, and the options of one interface, against exact answers."""
import math
import pathlib
import re
import tempfile
import unittest

import exodus_edit
import numpy

import scenes

LINEAR = {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}
FORMULATIONS = ("node_on_facet", "facet_on_facet", "sliding_elastic")
SIDES = {f"{body}_{side}": {"set": f"{body}_{side}", "fix": [side[0]]}
         for body in ("lower", "upper") for side in ("x0", "y0")}
MULTIPLIERS = {"enforcement": "augmented_lagrangian", "multiplier_tolerance": 1e-8, "max_augmentations": 60}


def boxes(path, **parts):
    """One mesh of boxes given by (origin, size, divisions); sets are named PART_x0 and so on."""
    whole = exodus_edit.ExodusMesh(numpy.zeros((0, 3)), [])
    elements = 0
    for number, (name, (origin, size, divisions)) in enumerate(parts.items(), 1):
        one = exodus_edit.read(scenes.mesh(path.with_name("part.exo"), "box", origin=origin, size=size,
                                           divisions=divisions))
        first = len(whole.x)
        whole.x = numpy.vstack([whole.x, one.x])
        whole.blocks.append(exodus_edit.Block(name, number, one.blocks[0].kind, one.blocks[0].nodes + first))
        for side, (cells, sides) in one.side_sets.items():
            whole.side_sets[f"{name}_{side}"] = (cells + elements, sides)
        elements += one.num_elements
    exodus_edit.write(path, whole)
    return path


def points(result):
    """Rows of the point table at the end of the run."""
    table = next((result.folder / "results").glob("*.points.csv"))
    rows = numpy.genfromtxt(table, delimiter=",", names=True, dtype=None, encoding=None)
    return rows[rows["time"] == rows["time"].max()]


def plates(lower=(3, 3, 1), upper=(2, 2, 2), size=(1, 1, 1), gap=0, **contact):
    """A column on a rigid plate, its top pressed by a dead traction; sides free, no Poisson effect."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [3, 3, 1], "lower_divisions": list(lower),
                              "upper_size": list(size), "upper_divisions": list(upper), "gap": gap}},
        "materials": {"elastic": LINEAR},
        "bodies": {"plate": {"blocks": ["lower"], "rigid": {}}, "column": {"blocks": ["upper"], "material": "elastic"}},
        "displacements": {"x": {"set": "upper_x0", "fix": ["x"]}, "y": {"set": "upper_y0", "fix": ["y"]}},
        "loads": {"press": {"side_set": "upper_top", "traction": [0, 0, -0.01]}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
        "newton": {"tolerance": 1e-11},
    }


class Corner(unittest.TestCase):
    """A block pushed into a corner: its edge belongs to both interfaces, each holds its own load."""

    def test_two_plates(self):
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation), tempfile.TemporaryDirectory() as folder:
                mesh = boxes(pathlib.Path(folder) / "corner.exo",
                             floor=([-1, -1, -1], [3, 3, 1], [5, 5, 1]), wall=([-1, -1, -.5], [1, 3, 3], [1, 5, 5]),
                             block=([0, 0, 0], [1, 1, 1], [3, 3, 3]))
                contact = {"formulation": formulation, "penalty": 100.0}
                deck = {
                    "mesh": {"file": "corner.exo"}, "materials": {"elastic": LINEAR},
                    "bodies": {"floor": {"blocks": ["floor"], "rigid": {}}, "wall": {"blocks": ["wall"], "rigid": {}},
                               "block": {"blocks": ["block"], "material": "elastic"}},
                    "displacements": {"y": {"set": "block_y0", "fix": ["y"]}},
                    "loads": {"down": {"side_set": "block_z1", "traction": [0, 0, -1e-3]},
                              "left": {"side_set": "block_x1", "traction": [-5e-4, 0, 0]}},
                    "contact": {"floor": {"primary": "block_z0", "secondary": "floor_z1", **contact},
                                "wall": {"primary": "block_x0", "secondary": "wall_x1", **contact}},
                    "newton": {"tolerance": 1e-11},
                    "verify": {"corner x": scenes.probe("displacement_x", point=[1, 1, 1]),
                               "corner z": scenes.probe("displacement_z", point=[1, 1, 1])}}
                result = scenes.run(deck, files=[mesh])
                numpy.testing.assert_allclose(result.force("floor"), [0, 0, 1e-3], rtol=0, atol=1e-10)
                numpy.testing.assert_allclose(result.force("wall"), [5e-4, 0, 0], rtol=0, atol=1e-10)
                # uniform stress, and the springs: -p (1/E + 1/eps), to the strain of 1e-3
                self.assertLess(abs(result.quantity("corner z") / -(1e-3 * 1.01) - 1), 2e-3)
                self.assertLess(abs(result.quantity("corner x") / -(5e-4 * 1.01) - 1), 2e-3)
                self.assertLess(abs(result.contact("floor")["max_pressure"] / 1e-3 - 1), 2e-3)


class SplitInterface(unittest.TestCase):
    """Two interfaces between the same bodies are the one interface they make up."""

    def test_halves(self):
        for formulation in FORMULATIONS[1:]:
            with self.subTest(formulation=formulation), tempfile.TemporaryDirectory() as folder:
                path = scenes.mesh(pathlib.Path(folder) / "halves.exo", "blocks", lower_size=[3, 3, 1],
                                   lower_divisions=[5, 5, 2], upper_divisions=[4, 3, 2])
                mesh = exodus_edit.read(path)
                cells, sides = mesh.side_sets["upper_bottom"]
                nodes = mesh.blocks[1].nodes[cells - len(mesh.blocks[0].nodes)]
                left = mesh.x[nodes, 0].mean(axis=1) < mesh.x[nodes, 0].mean()
                mesh.side_sets["left"] = (cells[left], sides[left])
                mesh.side_sets["right"] = (cells[~left], sides[~left])
                exodus_edit.write(path, mesh)
                options = {"secondary": "lower_top", "formulation": formulation, "friction": 0.3, "penalty": 20.0}
                deck = {"mesh": {"file": "halves.exo"}, "materials": {"elastic": {"young": 1, "poisson": 0.3}},
                        "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("lower", "upper")},
                        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                                          "top": {"set": "upper_top", "x": 0.02, "y": 0, "z": -0.03}},
                        "time": {"steps": 2}, "newton": {"tolerance": 1e-12}}
                one = scenes.run({**deck, "contact": {"pair": {"primary": "upper_bottom", **options}}}, files=[path])
                two = scenes.run({**deck, "contact": {"left": {"primary": "left", **options},
                                                      "right": {"primary": "right", **options}}}, files=[path])
                self.assertGreater(min(two.contact(name)["active_points"] for name in ("left", "right")), 0)
                numpy.testing.assert_allclose(two.force("left") + two.force("right"), one.force(), rtol=0, atol=1e-10)
                numpy.testing.assert_allclose(two.fields.vector("displacement"), one.fields.vector("displacement"),
                                              rtol=0, atol=1e-9)


class TwoPass(unittest.TestCase):
    """Each side carries half of the traction. Pressure on a column of 3 x 3 on 2 x 2 faces."""
    PRESSURE = 1e-3

    def deck(self, two_pass, fine_primary, **contact):
        sides = ["upper_bottom", "lower_top"][::1 if fine_primary else -1]
        return {"mesh": {"generate": {"kind": "blocks", "lower_divisions": [2, 2, 2], "upper_divisions": [3, 3, 2]}},
                "materials": {"elastic": LINEAR},
                "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("lower", "upper")},
                "displacements": {"bottom": {"set": "lower_bottom", "fix": ["z"]}, **SIDES},
                "loads": {"press": {"side_set": "upper_top", "traction": [0, 0, -self.PRESSURE]}},
                "contact": {"pair": {"primary": sides[0], "secondary": sides[1], "two_pass": two_pass,
                                     "penalty": 10.0, **contact}},
                "newton": {"tolerance": 1e-11}}

    def one_pass(self, formulation, fine_primary):
        """Largest error of the vertical stress over the pressure; the force carries the load."""
        result = scenes.run(self.deck(False, fine_primary, formulation=formulation))
        self.assertLess(abs(abs(result.force()[2]) / self.PRESSURE - 1), 1e-8)
        return self.stress_error(result)

    def both(self, formulation, fine_primary):
        result = scenes.run(self.deck(True, fine_primary, formulation=formulation))
        first, second = (result.force(name)[2] * (1 if fine_primary else -1) for name in ("pair", "pair_second_pass"))
        self.assertLess(abs((first - second) / self.PRESSURE - 1), 1e-8)
        return self.stress_error(result), abs(first / self.PRESSURE - 0.5)

    def stress_error(self, result):
        stress = numpy.concatenate([result.fields.element("stress_zz", body) for body in ("lower", "upper")])
        return numpy.abs(stress / -self.PRESSURE - 1).max()

    def test_patch(self):
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                fine, coarse = (self.one_pass(formulation, side) for side in (True, False))
                both, share = self.both(formulation, True)
                swapped, _ = self.both(formulation, False)
                print(f"{formulation:15s} largest stress error: points on the fine side {fine:.2e}  coarse {coarse:.2e}"
                      f"  both {both:.2e}; a side carries half but for {share:.1e}", flush=True)
                self.assertGreater(fine, 1e-3)  # the meshes do not fit
                self.assertLess(both, min(fine, coarse))
                self.assertLess(abs(swapped / both - 1), 1e-8)
                self.assertLess(share, max(fine, coarse))


class Hairpin(unittest.TestCase):
    """A hairpin squeezed shut: its inner surface is primary and secondary at once."""
    ARM, RADIUS, THICKNESS = 1.0, 0.1, 0.1

    def mesh(self, path):
        length = 2 * self.ARM + math.pi * self.RADIUS
        scenes.mesh(path, "box", size=[length, 0.1, self.THICKNESS], divisions=[40, 1, 2])
        mesh = exodus_edit.read(path)
        along, y, z = mesh.x.T
        radius, angle = self.RADIUS + z, (along - self.ARM) / self.RADIUS
        bend, back = (angle > 0) & (angle < math.pi), angle >= math.pi
        x = numpy.where(bend, self.ARM + radius * numpy.sin(angle), numpy.where(back, length - along, along))
        height = -radius * numpy.where(bend, numpy.cos(angle), numpy.where(back, -1, 1))
        mesh.x = numpy.stack([x, -y, height], axis=1)
        for name, at in (("lower_tip", 0), ("upper_tip", length)):
            mesh.node_sets[name] = numpy.where(numpy.isclose(along, at) & numpy.isclose(z, self.THICKNESS))[0]
        exodus_edit.write(path, mesh)
        return path

    def run_closed(self, mesh, close, formulation, ranks=1):
        deck = {"mesh": {"file": mesh.name}, "materials": {"elastic": {"young": 1, "poisson": 0}},
                "bodies": {"pin": {"blocks": ["box"], "material": "elastic"}},
                "displacements": {"front": {"set": "y0", "fix": ["y"]}, "back": {"set": "y1", "fix": ["y"]},
                                  "lower": {"set": "lower_tip", "x": 0, "z": close},
                                  "upper": {"set": "upper_tip", "x": 0, "z": -close}},
                "contact": {"self": {"primary": "z0", "secondary": "z0", "formulation": formulation}},
                "time": {"steps": 6}, "output": {"points": True}, "newton": {"tolerance": 1e-11},
                "verify": {"squeeze": scenes.probe("reaction_z", "lower_tip")}}
        return scenes.run(deck, files=[mesh], ranks=ranks)

    def test_closure(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh = self.mesh(pathlib.Path(folder) / "pin.exo")
            for formulation in FORMULATIONS:
                with self.subTest(formulation=formulation):
                    apart = self.run_closed(mesh, 0.09, formulation)
                    self.assertEqual(apart.contact("self")["active_points"], 0)
                    shut = self.run_closed(mesh, 0.11, formulation)
                    # bending alone would grow by 0.11/0.09; closure adds to it
                    self.assertGreater(shut.quantity("squeeze"), 10 * apart.quantity("squeeze"))
                    self.assertLess(numpy.abs(shut.force("self")[2]), 1e-8 * shut.quantity("squeeze"))
                    table = points(shut)
                    closed = table[table["pressure"] > 0]
                    self.assertGreater(len(closed), 0)
                    self.assertLess(closed["x"].max(), 0.5)  # arms only: no face meets its neighbours in the bend
                    both = self.run_closed(mesh, 0.11, formulation, ranks=2)
                    self.assertEqual(both.contact("self")["active_points"], shut.contact("self")["active_points"])
                    self.assertLess(abs(both.quantity("squeeze") / shut.quantity("squeeze") - 1), 1e-9)


class Overlap(unittest.TestCase):
    """Two neo-Hookean columns of modulus 1 and 10 (no Poisson effect, length 1) whose meshes overlap by D:
    sum of (1 - s_i) = D with the stretch s_i = N/E_i + sqrt(1 + (N/E_i)^2) at the nominal stress N."""

    def deck(self, overlap, treatment, push=0.0, steps=1):
        return {"mesh": {"generate": {"kind": "blocks", "lower_divisions": [2, 2, 2], "upper_divisions": [2, 2, 2],
                                      "gap": -overlap}},
                "materials": {"soft": {"young": 1, "poisson": 0}, "hard": {"young": 10, "poisson": 0}},
                "bodies": {"lower": {"blocks": ["lower"], "material": "soft"},
                           "upper": {"blocks": ["upper"], "material": "hard"}},
                "displacements": {"bottom": {"set": "lower_bottom", "fix": ["z"]},
                                  "top": {"set": "upper_top", "z": -push}, **SIDES},
                "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top",
                                     "initial_overlap": treatment, **MULTIPLIERS}},
                "time": {"steps": steps}, "newton": {"tolerance": 1e-10}}

    @staticmethod
    def exact(shortening):
        """Bisection for the nominal pressure."""
        low, high = 0.0, 10.0
        while high - low > 1e-14:
            n = (low + high) / 2
            short = sum(1 + n / e - math.sqrt(1 + (n / e)**2) for e in (1, 10))
            low, high = (n, high) if short < shortening else (low, n)
        return low

    def test_reference(self):
        self.assertAlmostEqual(self.exact(0.4), 0.45379942, delta=1e-8)

    def test_kept_resolved_adjusted(self):
        for overlap, treatment, push, steps in ((0.02, "keep", 0, 1), (0.4, "resolve", 0, 8), (0.02, "adjust", 0, 1),
                                                (0.02, "adjust", 0.1, 2), (0.02, "keep", 0.1, 2)):
            with self.subTest(overlap=overlap, treatment=treatment, push=push):
                result = scenes.run(self.deck(overlap, treatment, push, steps))
                exact = self.exact(push + (0 if treatment == "adjust" else overlap))
                print(f"overlap {overlap} {treatment:8s} push {push}  force {result.force()[2]:.8f}  exact {exact:.8f}")
                if treatment != "keep":  # which does not tell the overlap from penetration
                    self.assertAlmostEqual(result.contact()["initial_overlap"], overlap, delta=1e-12)
                self.assertLess(abs(result.force()[2] - exact), 1e-6 * max(exact, 1e-3))


class Options(unittest.TestCase):
    def penetration(self, **contact):
        return scenes.run(plates(penalty=10.0, **contact)).contact()["max_penetration"]

    def test_penalty_curve(self):
        for formulation in FORMULATIONS:
            deck = {**plates(formulation=formulation, penalty=10.0, penalty_curve="grow"),
                    "curves": {"grow": [[0, 1], [1, 4]]}, "time": {"steps": 2}}
            result = scenes.run(deck)
            self.assertAlmostEqual(result.contact()["max_penetration"], 0.01 / 40, delta=1e-9)
            self.assertAlmostEqual(result.force()[2], 0.01, delta=1e-11)

    def test_friction_curve(self):
        """The block slides on while the coefficient changes: F_x = mu(t) N."""
        for formulation in FORMULATIONS:
            deck = plates(formulation=formulation, friction=0.3, friction_curve="rough")
            deck["displacements"] = {"lead": {"set": "upper_top", "x": 0.1, "y": 0, "curve": "lead"}}
            deck["curves"] = {"rough": [[0, 0], [0.2, 0], [1, 2]], "lead": [[0, 0], [0.2, 0], [1, 1]],
                              "press": [[0, 0], [0.2, 1]]}
            deck["loads"]["press"]["curve"] = "press"
            deck["materials"]["elastic"] = {**LINEAR, "young": 100}
            deck["mesh"]["generate"]["upper_size"] = [1, 1, 0.25]
            for end, factor in ((0.6, 1), (1.0, 2)):
                result = scenes.run({**deck, "time": {"steps": 5 if end == 1 else 3, "end": end}})
                self.assertEqual(result.contact()["stick_points"], 0)
                self.assertLess(abs(result.force()[0] / (-0.3 * factor * 0.01) - 1), 1e-3, formulation)

    def test_friction_that_comes_after_the_motion(self):
        """Roughened at rest: what was slid before leaves no force."""
        for formulation in FORMULATIONS:
            deck = plates(formulation=formulation, friction=0.3, friction_curve="rough")
            deck["displacements"] = {"lead": {"set": "upper_top", "x": 0.01, "y": 0, "curve": "lead"}}
            deck["curves"] = {"rough": [[0, 0], [0.5, 0], [0.51, 1]], "lead": [[0, 0], [0.5, 1]]}
            deck["loads"]["press"]["curve"] = "lead"
            result = scenes.run({**deck, "time": {"steps": 4}})
            with self.subTest(formulation=formulation):
                self.assertGreater(result.contact()["active_points"], 0)
                self.assertLess(abs(result.force()[0]), 1e-9)

    def test_update_penalty(self):
        """Stretched to 1.2 x 1.2 the face has 1.44 times its area, and eps with it."""
        depths = {}
        for update in (False, True):
            deck = plates(update_penalty=update)
            deck["displacements"].update(wide={"set": "upper_x1", "x": 0.2, "curve": "wide"},
                                         deep={"set": "upper_y1", "y": 0.2, "curve": "wide"})
            deck["curves"] = {"wide": [[0, 0], [0.5, 1]]}
            result = scenes.run({**deck, "time": {"steps": 4}})
            depths[update] = result.contact()["max_penetration"]
            self.assertAlmostEqual(result.force()[2], 0.01, delta=1e-10)
        self.assertLess(abs(depths[False] / depths[True] / 1.44 - 1), 1e-6)

    def test_tension(self):
        """Points that may pull hold a column that is pulled off its plate."""
        for formulation in FORMULATIONS:
            deck = plates(formulation=formulation, penalty=10.0, tension=True)
            deck["curves"] = {"turn": [[0, 0], [0.5, 1], [1, -1]]}
            deck["loads"]["press"]["curve"] = "turn"
            result = scenes.run({**deck, "time": {"steps": 4}})
            with self.subTest(formulation=formulation):
                self.assertAlmostEqual(result.force()[2], -0.01, delta=1e-10)
                self.assertEqual(result.contact()["active_points"], 16)

    def test_tangent(self):
        """`check: tangent` prints an error for each part after each solve."""
        for formulation in FORMULATIONS:
            for enforcement in ("penalty", "augmented_lagrangian"):
                deck = plates(formulation=formulation, enforcement=enforcement, friction=0.3)
                deck["displacements"] = {"lead": {"set": "upper_top", "x": 0.05, "y": 0.02}}
                deck.update(check="tangent", time={"steps": 2})
                deck["loads"]["follow"] = {"side_set": "upper_x1", "pressure": 1e-3}
                result = scenes.run(deck, quiet=False)
                found = re.findall(r"tangent of (.*?)\s+error (\S+)", result.output)
                with self.subTest(formulation=formulation, enforcement=enforcement):
                    self.assertGreaterEqual(len(found), 2 * len({part for part, _ in found}))
                    self.assertTrue({"solid", "pair"} <= {part for part, _ in found}, found)
                    for part, error in found:
                        self.assertLess(float(error), 1e-6, part)

    def test_point_table(self):
        """The table of points and the summary tell the same."""
        for formulation in FORMULATIONS:
            deck = plates(formulation=formulation, friction=0.3)
            deck["displacements"] = {"lead": {"set": "upper_top", "x": 0.01, "y": 0.002}}
            result = scenes.run({**deck, "time": {"steps": 3}, "output": {"points": True}})
            table, contact = points(result), result.contact()
            with self.subTest(formulation=formulation):
                self.assertGreater(min(contact["slip_points"], contact["stick_points"]), 0)
                for status in ("stick", "slip"):
                    self.assertEqual((table["status"] == status).sum(), contact[status + "_points"])
                active = table[table["pressure"] > 0]
                self.assertEqual(len(active), contact["active_points"])
                self.assertLess(abs(-active["gap"].min() / contact["max_penetration"] - 1), 1e-8)
                self.assertAlmostEqual(active["slip"].max(), contact["max_slip"], delta=1e-9)
                traction = numpy.stack([active["traction_" + axis] for axis in "xyz"], axis=1)
                numpy.testing.assert_allclose(numpy.linalg.norm(traction, axis=1),
                                              numpy.hypot(active["pressure"], active["shear"]), rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
