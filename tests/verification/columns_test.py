# SPDX-License-Identifier: BSD-3-Clause
"""Columns of neo-Hookean material under finite compression: exact solutions.

W = G/2 (I1 - 3) - G ln J + L/2 (ln J)^2. With the axial stretch l and the force per reference area N:
  poisson 0         N = (E/2) (l - 1/l)
  sides on rollers  N = G (l - 1/l) + L ln(l)/l
  free sides        N = G (l - y/l), y = lateral stretch squared, G (y - 1) + L ln(l y) = 0
Two columns pressed together by D: sum of H (1 - l(N)) - N/eps = D.
"""
import math
import unittest

import numpy

import scenes

TOLERANCE = 1e-6
BALANCE = 1e-10
# stretch: y, N free sides, N rollers (E = 1, poisson 0.3), N (E = 1, poisson 0)
SINGLE = {0.9: (1.0644099132, -.10872219, -.14873537, -.10555556),
          0.8: (1.1392111945, -.24000538, -.33399775, -.225),
          0.7: (1.2275193723, -.40523042, -.57418265, -.36428571),
          0.6: (1.3339837672, -.62434857, -.90143489, -.53333333),
          0.5: (1.465957674, -.93535206, -1.37670829, -.75)}
AUGMENTED = {"enforcement": "augmented_lagrangian", "penalty_factor": 100,
             "multiplier_tolerance": 1e-9, "max_augmentations": 50}


def supports(bodies, sides):
    """Rollers on all four sides, or on x0 and y0 only ("free")."""
    return {f"{body}{axis}{end}": {"set": f"{body}{axis}{end}", "fix": [axis]}
            for body in bodies for axis in "xy" for end in ("01" if sides == "rollers" else "0")}


def single(stretch, poisson, sides, steps=1):
    return {
        "mesh": {"generate": {"kind": "box", "divisions": [2, 2, 3]}},
        "materials": {"rubber": {"young": 1.0, "poisson": poisson}},
        "bodies": {"column": {"blocks": ["box"], "material": "rubber"}},
        "displacements": {"bottom": {"set": "z0", "fix": ["z"]},
                          "top": {"set": "z1", "z": stretch - 1}, **supports([""], sides)},
        "newton": {"tolerance": 1e-12},
        "time": {"steps": steps, "adaptive": False},
        "verify": {"reaction": scenes.probe("reaction_z", "z1"),
                   "side": scenes.probe("displacement_x", "x1")},
    }


def pair(lower, upper, approach, sides="rollers", steps=1, divisions=((1, 1, 2), (1, 1, 2)),
         model="neo_hookean", **contact):
    """lower, upper: (young, poisson). The upper block carries the primary face."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_divisions": list(divisions[0]),
                              "upper_divisions": list(divisions[1])}},
        "materials": {name: {"model": model, "young": m[0], "poisson": m[1]}
                      for name, m in (("lower", lower), ("upper", upper))},
        "bodies": {name: {"blocks": [name], "material": name} for name in ("lower", "upper")},
        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["z"]},
                          "top": {"set": "upper_top", "z": -approach},
                          **supports(["lower_", "upper_"], sides)},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
        "newton": {"tolerance": 1e-12},
        "time": {"steps": steps, "adaptive": False},
        "verify": {"bottom": scenes.probe("reaction_z", "lower_bottom"),
                   "top": scenes.probe("reaction_z", "upper_top"),
                   "side": scenes.probe("displacement_x", "upper_x1")},
    }


class SingleColumn(unittest.TestCase):
    def test_all_stretches(self):
        for poisson, sides, which in ((0.3, "free", 1), (0.3, "rollers", 2), (0.0, "free", 3)):
            with self.subTest(poisson=poisson, sides=sides):
                result = scenes.run(single(0.5, poisson, sides, steps=5))
                fields, worst = result.fields, 0.0
                side = fields.node_set("x1")
                for step, stretch in enumerate(SINGLE, start=1):
                    self.assertAlmostEqual(fields.times[step], 2 * (1 - stretch))
                    n, lateral = SINGLE[stretch][which], math.sqrt(SINGLE[stretch][0]) if which == 1 else 1
                    stress = fields.element("stress_zz", "box", step) * lateral**2
                    moved = fields.nodal("displacement_x", step)[side]
                    worst = max(worst, numpy.max(numpy.abs(stress - n)),
                                numpy.max(numpy.abs(moved - (lateral - 1))))
                worst = max(worst, abs(result.quantity("reaction") - n))
                print(f"single column, poisson {poisson}, {sides}: largest error {worst:.1e}")
                self.assertLess(worst, TOLERANCE)

    def test_steps(self):
        values = [scenes.run(single(0.5, 0.3, "free", steps)).quantity("reaction")
                  for steps in (1, 2, 5, 10)]
        print("single column, steps 1 2 5 10:", *(f"{value:.12f}" for value in values))
        self.assertLess(max(values) - min(values), 1e-10)

    def test_dead_load(self):
        deck = single(1.0, 0.0, "free")
        del deck["displacements"]["top"]
        deck["loads"] = {"top": {"side_set": "z1", "traction": [0, 0, -0.75]}}
        deck["verify"] = {"top": scenes.probe("displacement_z", "z1")}
        self.assertLess(abs(scenes.run(deck).quantity("top") + 0.5), TOLERANCE)


class TwoColumns(unittest.TestCase):
    def check(self, label, deck, exact):
        result = scenes.run(deck, quiet=False)
        force = result.force()[2]
        print(f"{label:46s} N {-force:.9f}  exact {-exact:.8f}  Newton "
              f"{result.summary['newton_iterations']}  augmentations {result.summary['augmentations']}")
        self.assertGreater(result.contact()["active_points"], 0)
        self.assertLess(abs(force - exact), TOLERANCE)
        self.assertLess(abs(force - result.quantity("bottom")), BALANCE)
        self.assertLess(abs(force + result.quantity("top")), BALANCE)
        return result

    def test_rollers(self):
        soft, stiff = (1.0, 0.3), (4.0, 0.0)
        for penalty, exact in ((1e3, .51682350), (1e2, .50926439), (10, .44593474), (1, .21174499)):
            with self.subTest(penalty=penalty):
                self.check(f"E 1 and 4, eps {penalty:g}", pair(stiff, soft, 0.4, penalty=penalty), exact)
        self.check("E 1 and 4, multipliers", pair(stiff, soft, 0.4, **AUGMENTED), .51768026)
        self.check("E 1 and 4, multipliers, stiff one above", pair(soft, stiff, 0.4, **AUGMENTED),
                   .51768026)

    def test_poisson_zero(self):
        result = self.check("poisson 0, E 1 and 10, multipliers",
                            pair((10.0, 0.0), (1.0, 0.0), 0.4, "free", **AUGMENTED), .45379942)
        fields = result.fields
        interface = fields.nodal("displacement_z")[fields.node_set("lower_top")]
        self.assertLess(numpy.max(numpy.abs(interface - (.9556492 - 1))), TOLERANCE)

    def test_equal_blocks_with_free_sides(self):
        same = (1.0, 0.3)
        forces = []
        for steps, upper in ((1, 1), (2, 1), (5, 1), (10, 1), (1, 4)):
            divisions = ((2, 2, 2), (upper, upper, 2)) if upper > 1 else ((1, 1, 2), (1, 1, 2))
            result = self.check(f"free sides, stretch 0.5, {steps} steps, {upper}:{divisions[0][0]}",
                                pair(same, same, 1.0, "free", steps, divisions, **AUGMENTED), .93535206)
            y = SINGLE[0.5][0]
            self.assertEqual(result.summary["steps"], steps)
            self.assertLess(abs(result.quantity("side") - (math.sqrt(y) - 1)), TOLERANCE)
            self.assertLess(abs(result.contact()["max_pressure"] - .93535206 / y), TOLERANCE)
            forces.append(result.force()[2])
        self.assertLess(max(forces) - min(forces), 1e-8)

    def test_newton_is_quadratic(self):
        deck = pair((4.0, 0.0), (1.0, 0.3), 1.0, divisions=((2, 2, 3), (4, 4, 3)), penalty=10)
        residuals = next(iter(scenes.run(deck, quiet=False).newton_residuals().values()))
        print("Newton residuals", *residuals)
        # above round-off and inside the region where the quadratic model holds
        ratios = [after / before**2 for before, after in zip(residuals, residuals[1:])
                  if before < 0.1 and after > 1e-13]
        print("r_(k+1) / r_k^2", *(f"{ratio:.3f}" for ratio in ratios))
        self.assertGreaterEqual(len(ratios), 2)
        self.assertLess(max(ratios), 1.0)


class Uzawa(unittest.TestCase):
    """The force error falls by k/(k + eps) = 1/(1 + f (H1 + H2)/h) with each augmentation, where
    k = E/(H1 + H2) and h is the height of the primary cells."""

    def factors(self, factor, cells, model, approach):
        deck = pair((1.0, 0.0), (1.0, 0.0), approach, divisions=((1, 1, 2), (1, 1, cells)), model=model,
                    **{**AUGMENTED, "penalty_factor": factor, "multiplier_tolerance": 1e-14, "augmentation": "plain"})
        stretch = 1 - approach / 2
        exact = approach / 2 if model == "linear_elastic" else (1 / stretch - stretch) / 2
        errors = []
        for number in range(4):
            # none within the step: multipliers change when it is over
            deck["contact"]["pair"]["uzawa"] = "nested" if number else "end_of_step"
            deck["contact"]["pair"]["max_augmentations"] = max(1, number)
            result = scenes.run(deck)
            self.assertEqual(result.summary["augmentations"], number)
            errors.append(exact - result.force()[2])
        return [after / before for before, after in zip(errors, errors[1:])]

    def test_factor(self):
        for model, approach, tolerance in (("linear_elastic", 1e-2, 1e-6), ("neo_hookean", 1e-3, 5e-3)):
            for factor, cells in ((0.1, 4), (1, 4)):
                with self.subTest(model=model, factor=factor, cells=cells):
                    predicted = 1 / (1 + factor * 2 * cells)
                    measured = self.factors(factor, cells, model, approach)
                    print(f"Uzawa factor, {model}, f {factor:g}, h 1/{cells}: predicted {predicted:.6f}"
                          "  measured", *(f"{value:.6f}" for value in measured))
                    for value in measured:
                        self.assertLess(abs(value / predicted - 1), tolerance)


if __name__ == "__main__":
    unittest.main()
