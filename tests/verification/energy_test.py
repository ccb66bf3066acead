# SPDX-License-Identifier: BSD-3-Clause
"""The energy ledger of a run: work in = stored + penalty + friction, and an imbalance that falls with the step.

Work comes in by the trapezoidal rule over each step, against state functions: the imbalance is of order 2 in the
step. So is friction work where a point slips on; the step in which it starts to slip is cruder.
Where the penalty pressure acts on the current area (sliding_elastic) it has no potential, and part of the
penalty energy never closes: that formulation is held to the order with multipliers.
"""
import math
import unittest

import scenes

STEPS = (10, 20, 40)
NEO_HOOKEAN = {"model": "neo_hookean", "young": 1, "poisson": 0.3}
LINEAR = {"model": "linear_elastic", "young": 1, "poisson": 0}
# The ledger counts what springs hold only as far as multipliers have taken it over: those of the points do.
AUGMENTED = {"enforcement": "augmented_lagrangian", "multipliers": "per_point", "penalty_factor": 10,
             "multiplier_tolerance": 1e-7, "max_augmentations": 60}
DEFAULT = {"enforcement": "augmented_lagrangian"}
CLOSED = {**DEFAULT, "gap_tolerance": 1e-7, "max_augmentations": 60}  # springs of the default hold nothing then


def block(material=NEO_HOOKEAN, **contact):
    """A block that is pressed on a rigid plate by its top, then led across it."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [3, 3, 1], "lower_divisions": [4, 4, 1],
                              "upper_size": [1, 1, 0.5], "upper_divisions": [2, 2, 2]}},
        "materials": {"elastic": material},
        "bodies": {"plate": {"blocks": ["lower"], "rigid": {}},
                   "block": {"blocks": ["upper"], "material": "elastic"}},
        "displacements": {"lead": {"set": "upper_top", "x": 0.1, "y": 0, "curve": "slide"},
                          "press": {"set": "upper_top", "z": -0.05, "curve": "press"}},
        "curves": {"press": [[0, 0], [0.5, 1]], "slide": [[0, 0], [0.5, 0], [1, 1]]},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
        "newton": {"tolerance": 1e-10},
    }


def pressed_pair(**upper):
    """An elastic block on a plate, too rough for it to slip, under what `upper` brings."""
    deck = scenes.merged(block(friction=10), {"displacements": None})
    return scenes.merged(deck, upper)


class Ledger(unittest.TestCase):
    def run_steps(self, deck, name):
        """The energies of the run with each number of steps; order of the imbalance over them."""
        results = [scenes.run(scenes.merged(deck, {"time": {"steps": n}})) for n in STEPS]
        energies = [result.summary["energy"] for result in results]
        for result, e in zip(results, energies):
            self.assertEqual(result.summary["cut_backs"], 0)
            self.assertGreater(result.contact()["active_points"], 0)
            self.assertGreaterEqual(e["friction"], 0)
            total = e["stored"] + e["penalty"] + e["friction"] + e["imbalance"]
            self.assertAlmostEqual(total / e["work_in"], 1, delta=1e-12)
        relative = [e["imbalance"] / e["work_in"] for e in energies]
        order = math.log(abs(relative[0] / relative[-1])) / math.log(STEPS[-1] / STEPS[0])
        last = energies[-1]
        print(f"{name:52s} imbalance/work {' '.join(f'{v:+.2e}' for v in relative)}  order {order:.2f}  "
              + "  ".join(f"{key} {last[key]:.4e}" for key in ("work_in", "stored", "penalty", "friction")), flush=True)
        return results[-1], last, relative, order


class Sliding(Ledger):
    def check(self, name, friction, **options):
        result, energy, relative, order = self.run_steps(block(friction=friction, **options), name)
        self.assertGreater(order, 1.6 if friction else 1.9)  # points start to slip one after the other
        self.assertLess(abs(relative[-1]), 1e-3)
        self.assertGreater(energy["stored"], 0)
        if friction > 0:
            self.assertGreater(result.contact()["slip_points"], 0)
            self.assertGreater(energy["friction"], 0.3 * energy["work_in"])
        else:
            self.assertEqual(energy["friction"], 0)

    def test_penalty(self):
        for formulation in ("node_on_facet", "facet_on_facet"):
            for friction in (0, 0.3):
                with self.subTest(formulation=formulation, friction=friction):
                    self.check(f"penalty {formulation} friction {friction}", friction, formulation=formulation)

    def test_multipliers(self):
        for formulation, material in (("node_on_facet", NEO_HOOKEAN), ("facet_on_facet", NEO_HOOKEAN),
                                      ("sliding_elastic", LINEAR)):
            for friction in (0, 0.3):
                with self.subTest(formulation=formulation, friction=friction):
                    self.check(f"multipliers {formulation} friction {friction}", friction,
                               formulation=formulation, material=material, **AUGMENTED)

    def test_default_multipliers(self):
        """A gap of a thousandth of a face lets springs hold what the end of a step takes over: of first order in the
        step, and less where nothing is asked for, since what gaps cost is bounded then. Closed further, the ledger
        is of second order as it is with multipliers at points."""
        for formulation, material in (("facet_on_facet", NEO_HOOKEAN), ("sliding_elastic", LINEAR)):
            with self.subTest(formulation=formulation):
                scene = {"formulation": formulation, "material": material}
                _, _, relative, order = self.run_steps(block(friction=0, gap_tolerance=1e-3, **scene, **DEFAULT),
                                                       f"a thousandth of a face {formulation}")
                self.assertGreater(order, 0.8)
                self.assertLess(order, 1.2)
                self.assertLess(abs(relative[-1]), 0.01)
                _, _, bounded, _ = self.run_steps(block(friction=0, **scene, **DEFAULT), f"default {formulation}")
                self.assertLess(max(map(abs, bounded)), max(map(abs, relative)))
                self.check(f"default, closed {formulation}", 0.3, **scene, **CLOSED)
        self.check("default, closed facet_on_facet friction 0", 0, formulation="facet_on_facet", **CLOSED)

    def test_multipliers_at_the_end_of_steps(self):
        """Multipliers take over what springs hold, and the ledger loses it: of first order in the step."""
        for space in ("per_point", "smoothed", "dual"):
            for friction in (0, 0.3):
                with self.subTest(space=space, friction=friction):
                    deck = block(friction=friction, enforcement="augmented_lagrangian", multipliers=space,
                                 penalty_factor=10, uzawa="end_of_step")
                    result, _, relative, order = self.run_steps(deck, f"end of step {space} friction {friction}")
                    self.assertEqual(result.summary["augmentations"], 0)
                    self.assertGreater(order, 0.9)
                    self.assertLess(abs(relative[-1]), 0.01)

    def test_pressed_while_led(self):
        deck = scenes.merged(block(friction=0.3), {"curves": {"press": [[0, 0], [0.5, 0.5], [1, 1]]}})
        _, energy, relative, order = self.run_steps(deck, "pressed while led")
        self.assertGreater(energy["friction"], 0.1 * energy["work_in"])
        self.assertGreater(order, 1.6)
        self.assertLess(abs(relative[-1]), 1e-3)

    def test_friction_work_never_falls(self):
        """Lifted off again, the block has lost what it lost."""
        for formulation in ("node_on_facet", "facet_on_facet", "sliding_elastic"):
            deck = block(friction=0.3, formulation=formulation)
            deck["curves"]["press"] = [[0, 0], [0.5, 1], [1, 1], [2, -0.1]]
            result = scenes.run(scenes.merged(deck, {"time": {"steps": 30, "end": 2}}))
            lost = [result.fields.globals(i)["energy_friction"] for i in range(len(result.fields.times))]
            with self.subTest(formulation=formulation):
                self.assertEqual(result.contact()["active_points"], 0)
                self.assertGreater(lost[-1], 1e-3)
                self.assertGreaterEqual(min(b - a for a, b in zip(lost, lost[1:])), -1e-14 * lost[-1])


class Drivers(Ledger):
    """Each of them alone brings the work in."""

    def check(self, deck, name):
        result, energy, relative, order = self.run_steps(deck, name)
        self.assertEqual(result.contact()["slip_points"], 0)
        self.assertGreater(order, 1.9)
        self.assertLess(abs(relative[-1]), 2e-4)

    def test_dead_traction(self):
        self.check(pressed_pair(loads={"press": {"side_set": "upper_top", "traction": [0.01, 0, -0.1]}}),
                   "dead traction")

    def test_follower_pressure(self):
        self.check(pressed_pair(loads={"press": {"side_set": "upper_top", "pressure": 0.1}}), "follower pressure")

    def test_body_force(self):
        self.check(pressed_pair(loads={"weight": {"block": "upper", "body_force": [0, 0, -0.2]}}), "body force")

    def test_rigid_driver(self):
        driver = {"node_sets": ["upper_top"],
                  "rigid": {"center": [1.5, 1.5, 1.5], "displacement": [0, 0, -0.05], "rotation": [0, 0.02, 0.1]}}
        self.check(pressed_pair(bodies={"driver": driver}), "rigid driver")

    def test_free_rigid_body(self):
        driver = {"node_sets": ["upper_top"],
                  "rigid": {"center": [1.5, 1.5, 1.5], "free": ["z", "rz"], "force": [0, 0, -0.1],
                            "moment": [0, 0, 2e-3]}}
        self.check(pressed_pair(bodies={"driver": driver}), "free rigid body with force and moment")

    def test_rigid_plate(self):
        """The plate moves under the block whose top is held."""
        deck = pressed_pair(bodies={"plate": {"rigid": {"displacement": [0, 0, 0.05]}}},
                            displacements={"top": {"set": "upper_top", "fix": ["x", "y", "z"]}})
        self.check(deck, "rigid plate")


if __name__ == "__main__":
    unittest.main()
