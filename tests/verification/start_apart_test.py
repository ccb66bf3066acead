# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that nothing but contact holds, and that stand off what will hold them: a block over another, pressed down by
a dead load in one step. The nearest points hold it until it touches (Interaction::hold_by_nearest)."""
import unittest

import scenes

LOAD, FORMULATIONS = 0.05, ("facet_on_facet", "sliding_elastic", "node_on_facet")
WAYS = {
    "penalty": {},
    "smoothed": {"enforcement": "augmented_lagrangian", "multipliers": "smoothed"},
    "dual": {"enforcement": "augmented_lagrangian", "multipliers": "dual"},
}
ELASTIC = {"model": "neo_hookean", "young": 1, "poisson": 0.3}


def deck(gap, load=LOAD, upright=True, element="hex8", **contact):
    """Unit blocks, 3 x 3 faces on 2 x 2; load: pressure on the top; upright: its top moves along z alone."""
    displacements = {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]}}
    if upright:
        displacements["top"] = {"set": "upper_top", "fix": ["x", "y"]}
    return {
        "mesh": {"generate": {"kind": "blocks", "gap": gap, "element": element}},
        "materials": {"elastic": ELASTIC},
        "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("upper", "lower")},
        "displacements": displacements,
        "loads": {"weight": {"side_set": "upper_top", "traction": [0, 0, -load]}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
    }


class StartApart(unittest.TestCase):
    def rest(self, scene, load, most=15):
        """It comes to rest on the other, without a cut, and carries the load; what was done is said."""
        result = scenes.run(scene)
        s = result.summary
        self.assertEqual(s["cut_backs"], 0)
        self.assertLessEqual(s["newton_iterations"], most)
        last = len(result.fields.times) - 1
        self.assertAlmostEqual(result.fields.globals(last)["pair_force_z"], load, delta=1e-6 * load)
        self.assertTrue(any("nothing but contact can hold" in text for text in s["warnings"]), s["warnings"])
        return result

    def test_every_formulation_and_space(self):
        for formulation in FORMULATIONS:
            for way, options in WAYS.items():
                for gap, load in ((0.001, 0.001), (0.02, 0.001), (0.2, 0.001), (0.02, LOAD), (0.2, LOAD)):
                    with self.subTest(formulation=formulation, way=way, gap=gap, load=load):
                        self.rest(deck(gap, load, formulation=formulation, **options), load)

    def test_the_answer_is_that_of_a_start_in_touch(self):
        touching, apart = (scenes.run(deck(gap)).fields.vector("displacement") for gap in (0.0, 0.1))
        upper = apart[:, 2] < -0.1
        self.assertGreater(upper.sum(), 50)
        apart[upper, 2] += 0.1
        self.assertLess(abs(apart - touching).max(), 1e-6)
        self.assertGreater(abs(touching).max(), 0.05)

    def test_friction_holds_the_rest(self):
        self.rest(deck(0.02, upright=False, friction=0.3), LOAD)

    def test_quadratic_cells(self):
        self.rest(deck(0.02, element="hex20"), LOAD)

    def test_a_rigid_body_falls_into_place(self):
        for gap in (0.01, 0.2):
            scene = deck(gap, upright=False)
            scene["bodies"]["upper"] = {"blocks": ["upper"], "rigid": {"free": ["z"], "force": [0, 0, -LOAD]}}
            del scene["loads"]
            self.rest(scene, LOAD)

    def test_what_contact_cannot_hold_is_named(self):
        result = scenes.run(deck(0.02, upright=False), check=False)
        self.assertEqual(result.status, 2, result.output)
        self.assertRegex(result.output, r"body 'upper' is free to move: translation along x, translation along y, "
                                        r"rotation about z through \(0\.5, 0\.5, [\d.]+\)\. Hold it")

    def test_a_body_that_is_pulled_away_is_named(self):
        result = scenes.run(deck(0.02, load=-LOAD), check=False)
        self.assertEqual(result.status, 1, result.output)
        self.assertIn("Body 'upper' is free to move: translation along z", result.output)


if __name__ == "__main__":
    unittest.main()
