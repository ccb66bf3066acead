# SPDX-License-Identifier: BSD-3-Clause
"""How much too soft the penalty makes a contact, as the summary says it, beside the truth: blocks in series by hand, a
rubber block against multipliers on the same mesh."""
import unittest

import scenes

SUGGESTION = "take 'enforcement: augmented_lagrangian' or a larger penalty_factor"
CONVERGED = {"enforcement": "augmented_lagrangian", "multipliers": "per_point", "min_augmentations": 8}
YOUNG, DEPTH, APPROACH, STIFF = 2.0, 1 / 3, 0.01, 2e5


def columns(gap=0.0, steps=1, load=None, **contact):
    """Unit blocks without lateral strain, 3 x 3 x 3 cells on 2 x 2 x 2, pressed by a displacement or a load."""
    deck = {
        "mesh": {"generate": {"kind": "blocks", "gap": gap}},
        "materials": {"elastic": {"model": "linear_elastic", "young": YOUNG, "poisson": 0.0}},
        "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("lower", "upper")},
        "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "head": {"set": "upper_top", "fix": ["x", "y"], "z": -gap - APPROACH}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
        "time": {"steps": steps},
    }
    if load:
        del deck["displacements"]["head"]["z"]
        deck["loads"] = {"weight": {"side_set": "upper_top", "traction": [0, 0, -load]}}
    return deck


def stack(approach, **contact):
    """Stiff blocks without lateral strain, one element deep each."""
    deck = columns(**contact)
    deck["mesh"]["generate"].update(lower_divisions=[2, 2, 1], upper_divisions=[3, 3, 1])
    deck["materials"]["elastic"]["young"] = STIFF
    deck["displacements"]["head"]["z"] = -approach
    return deck


def rubber(friction=0.3, squeeze=1.8, **contact):
    """A nearly incompressible block, its head bonded, pressed on a rigid floor."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [12, 12, 1], "lower_divisions": [1, 1, 1],
                              "upper_size": [10, 10, 6], "upper_divisions": [6, 6, 4]}},
        "materials": {"rubber": {"model": "mooney_rivlin", "c1": 0.5, "bulk": 1000}},
        "bodies": {"block": {"blocks": ["upper"], "material": "rubber"}, "floor": {"blocks": ["lower"], "rigid": {}}},
        "displacements": {"head": {"set": "upper_top", "fix": ["x", "y"], "z": -squeeze}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "friction": friction, **contact}},
        "time": {"steps": 10},
    }


class PenaltyError(unittest.TestCase):
    def stated(self, deck):
        """The error in the summary; a warning states it where it is beyond 2 %."""
        summary = scenes.run(deck).summary
        error, said = summary["penalty_error"], [w for w in summary["warnings"] if SUGGESTION in w]
        self.assertEqual(len(said), error > 0.02, (error, summary["warnings"]))
        for text in said:
            self.assertIn(f" off by about {100 * error:.1f} %", text)
        return error, summary

    def test_springs_in_series(self):
        for factor in (1, 10, 100):
            one_pass = 1 / (1 + factor * 2 / DEPTH)  # two heights of 1, eps = f E / depth
            both = 1 / (1 + factor * (1 / DEPTH + 2))  # half of each, the other depth being 1/2
            for way in ({}, {"multipliers": "dual"}, {"formulation": "sliding_elastic"},
                        {"formulation": "node_on_facet"}, {"two_pass": True}):
                with self.subTest(factor=factor, **way):
                    error, summary = self.stated(columns(penalty_factor=factor, **way))
                    exact = both if "two_pass" in way else one_pass
                    self.assertLess(abs(error / exact - 1), 0.1)
                    passes = summary["contact"].values()
                    self.assertAlmostEqual(sum(c["penalty_error"] for c in passes), error)
                    if len(passes) == 1:  # of the deepest point, on meshes that do not match
                        ratio = summary["contact"]["pair"]["penetration_over_approach"]
                        self.assertGreater(ratio, 0.95 * exact)
                        self.assertLess(ratio, 1.8 * exact)

    def test_a_gap_steps_and_a_load(self):
        """Neither a way without contact nor steps change the error; under a load it is that of the way."""
        exact = 1 / (1 + 2 / DEPTH)
        for deck in (columns(gap=0.02, steps=9, penalty_factor=1), columns(steps=5, penalty_factor=1),
                     columns(load=0.01, steps=4, penalty_factor=1)):
            error, _ = self.stated(deck)
            self.assertLess(abs(error / exact - 1), 0.1)

    def test_an_overlap_instead_of_work(self):
        deck = columns(gap=-APPROACH, penalty_factor=1)
        deck["displacements"]["head"]["z"] = 0
        error, summary = self.stated(deck)
        self.assertAlmostEqual(summary["energy"]["work_in"], 0, delta=1e-12)
        self.assertLess(abs(error * (1 + 2 / DEPTH) - 1), 0.1)

    def test_multipliers(self):
        for space in ("dual", "smoothed", "per_point"):
            with self.subTest(space=space):
                error, summary = self.stated(columns(enforcement="augmented_lagrangian", multipliers=space,
                                                     min_augmentations=3))
                self.assertLess(error, 1e-3)
                self.assertFalse(any("off by about" in text for text in summary["warnings"]), summary["warnings"])

    def test_dual_multipliers_of_a_stiff_stack(self):
        """A gap that is small beside a face is not small beside the way by which stiff bodies come together."""
        for approach in (1e-7, 1e-4):
            for formulation in ("facet_on_facet", "sliding_elastic", "node_on_facet"):
                with self.subTest(approach=approach, formulation=formulation):
                    error, summary = self.stated(stack(approach, enforcement="augmented_lagrangian", formulation=formulation))
                    self.assertLess(error, 1e-3)
                    self.assertAlmostEqual(summary["contact"]["pair"]["force"][2] / (STIFF * approach / 2), 1, delta=4e-3)
                    self.assertLessEqual(summary["augmentations"], 2)
        given, summary = self.stated(stack(1e-4, enforcement="augmented_lagrangian", gap_tolerance=1e-3))
        self.assertEqual(summary["augmentations"], 0)  # asked for no more than that
        self.assertLess(abs(given * (1 + 30 * 2) - 1), 0.1)

    def test_the_default_is_right_or_says_by_how_much_it_is_not(self):
        for name, deck in (("stack", lambda **contact: stack(1e-4, **contact)), ("rubber", rubber)):
            with self.subTest(scene=name):
                reference = scenes.run(deck(**CONVERGED)).force()[2]
                error, summary = self.stated(deck())
                true = 1 - summary["contact"]["pair"]["force"][2] / reference
                print(f"{name}: off by {true:.4f}, stated {error:.4f}", flush=True)
                self.assertTrue(true < 0.02 or error > 0.02, (true, error))
                self.assertLess(max(error / true, true / error), 1.5)

    def test_multipliers_left_open(self):
        """What they have not closed counts with the whole pressure, not with what their springs carry."""
        soft = {"enforcement": "augmented_lagrangian", "multipliers": "smoothed", "penalty_factor": 0.1,
                "max_augmentations": 1, "multiplier_tolerance": 1e-6}
        summary = scenes.run(columns(**soft)).summary
        force = summary["contact"]["pair"]["force"][2]
        true = 1 - force / (YOUNG * APPROACH / 2)
        self.assertGreater(true, 0.05)
        self.assertLess(abs(summary["penalty_error"] / true - 1), 0.1)
        self.assertTrue(any("ask for more augmentations" in text for text in summary["warnings"]))

    def test_rubber(self):
        for friction in (0.3, 0):
            closed, summary = self.stated(rubber(friction, **CONVERGED))
            self.assertLess(closed, 5e-3)
            reference = summary["contact"]["pair"]["force"][2]
            for factor in (10, 100):
                with self.subTest(friction=friction, factor=factor):
                    error, summary = self.stated(rubber(friction, penalty_factor=factor))
                    true = 1 - summary["contact"]["pair"]["force"][2] / reference
                    print(f"rubber, friction {friction}, f {factor}: off by {true:.4f}, stated {error:.4f}", flush=True)
                    self.assertLess(max(error / true, true / error), 1.5)

    def test_nothing_but_the_penalty_gives(self):
        """It is all the stiffness there is, between rigid bodies and where all nodes are held: nothing is too soft."""
        pressed = {"blocks": ["upper"], "rigid": {"free": ["z"], "force": [0, 0, -1]}}
        held = {side: {"set": side, "fix": ["x", "y", "z"]} for side in ("lower_bottom", "lower_top")}
        for lower, displacements in (({"blocks": ["lower"], "rigid": {}}, {}),
                                     ({"blocks": ["lower"], "material": "elastic"}, held)):
            deck = columns(penalty=100)
            deck["mesh"]["generate"]["lower_divisions"] = [1, 1, 1]
            deck["displacements"], deck["bodies"] = displacements, {"lower": lower, "upper": pressed}
            error, summary = self.stated(deck)
            self.assertEqual(error, 0)
            self.assertGreater(summary["contact"]["pair"]["penalty_energy"], 0)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
