# SPDX-License-Identifier: BSD-3-Clause
"""One tetrahedron, its base held, its apex on a rigid plane under the force (rho, 0, -1) N: Coulomb friction with
no, one or three solutions beside mu_c, and what the program makes of them.

The stiffness of the apex is K = V/h^2 (G I + (lambda + G) n n), n normal to the base, h its distance. With phi
from n to the plane, mu_c = K_xx/|K_xz| = (1 - 2 nu + cos^2 phi)/(cos phi sin phi). The apex may stick for rho < mu,
be off the plane for rho > mu_c, and slips between: alone for mu < rho < mu_c, as one of three for mu_c < rho < mu.
Every branch is right then; which one is found is a matter of the way there.
"""
import math
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import scenes

FORCE = 1e-4
PENALTY = {"penalty": 1e3}
STIFF = {"penalty": 1e5}  # beside mu_c slip is large, and multipliers converge slowly
MULTIPLIERS = {"enforcement": "augmented_lagrangian", "multipliers": "per_point", "penalty": 10,
               "multiplier_tolerance": 1e-9, "max_augmentations": 100}
ENFORCEMENTS = {"penalty": PENALTY, "augmented_lagrangian": MULTIPLIERS}
# factors of the normal and the tangential force and of mu over t, in four steps
WAYS = {
    "at once": {},
    "pressed, then sheared": {"normal": [[0, 0], [0.25, 1]], "shear": [[0.25, 0], [1, 1]]},
    "sheared, then pressed": {"normal": [[0.25, 0], [1, 1]], "shear": [[0, 0], [0.25, 1]]},
    "lifted before": {"normal": [[0, 0], [0.25, -1], [0.5, 1]], "shear": [[0.5, 0], [1, 1]]},
    "smooth before": {"normal": [[0, 0], [0.25, 1]], "shear": [[0, 0], [0.25, 1]],
                      "rough": [[0, 0], [0.25, 0], [1, 1]]},
    "sheared back before": {"normal": [[0, 0], [0.25, 1]], "shear": [[0, 0], [0.5, -1], [1, 1]]},
}

# mu is that of the end, the load grows from none: whatever sticks does so where it started
FROM_STICK = ("at once", "pressed, then sheared", "sheared back before")
TOLERANCE, NEAR = 1e-6, 1e-3


def worst_angle(poisson):
    """Of the least mu_c, 2 sqrt((2 - 2 nu) (1 - 2 nu))."""
    return math.atan(math.sqrt((2 - 2 * poisson) / (1 - 2 * poisson)))


def critical(angle, poisson):
    return (1 - 2 * poisson + math.cos(angle)**2) / (math.cos(angle) * math.sin(angle))


class Tet:
    """Apex at the origin, base an equilateral triangle; x and z only, by symmetry."""

    def __init__(self, angle, poisson):
        self.angle, self.poisson = angle, poisson
        n = numpy.array([math.cos(angle), 0, -math.sin(angle)])
        up, aside = numpy.array([math.sin(angle), 0, math.cos(angle)]), numpy.array([0, 1.0, 0])
        base = [-n + 0.2 * (math.cos(t) * up + math.sin(t) * aside) for t in 2 * math.pi / 3 * numpy.arange(3)]
        self.nodes = numpy.array([[0, 0, 0], *base])
        volume = numpy.linalg.det(self.nodes[1:]) / 6
        if volume > 0:
            self.nodes[[2, 3]] = self.nodes[[3, 2]]
        shear = 0.5 / (1 + poisson)
        n = n[[0, 2]]
        self.stiffness = abs(volume) * shear * (numpy.eye(2) + numpy.outer(n, n) / (1 - 2 * poisson))
        faces = [self.nodes[i] for i in ([1, 2], [2, 3], [3, 1])]
        vectors = [numpy.cross(*edges) / 2 for edges in faces]
        if vectors[0] @ self.nodes[3] > 0:
            vectors = [-v for v in vectors]
        self.area = sum(numpy.linalg.norm(v) for v in vectors if v[2] < 0) / 3  # of faces that face the plane

    def write(self, path):
        x, y, z = (a.ravel() for a in numpy.meshgrid([-1, 1], [-1, 1], [-0.5, 0], indexing="ij"))
        box = numpy.array([0, 4, 6, 2, 1, 5, 7, 3]) + 4
        blocks = [exodus_edit.Block("tet", 1, "TETRA", numpy.array([[1, 2, 3, 0]])),
                  exodus_edit.Block("plane", 2, "HEX8", box[None, :])]
        mesh = exodus_edit.ExodusMesh(numpy.concatenate([self.nodes, numpy.stack([x, y, z], axis=1)]), blocks)
        mesh.node_sets = {"apex": numpy.array([0]), "base": numpy.array([1, 2, 3])}
        mesh.side_sets = {"sides": (numpy.array([0, 0, 0]), numpy.array([0, 1, 2])),
                          "plane_top": (numpy.array([1]), numpy.array([5]))}
        exodus_edit.write(path, mesh)
        return path

    def solutions(self, rho, mu, spring=math.inf):
        """{branch: displacement / N} of an apex that starts at the origin; spring: penalty times area."""
        load, k = numpy.array([rho, -1.0]), self.stiffness
        soft = 0.0 if spring == math.inf else 1 / spring
        found = {}
        # unknowns u and the force (T, P) on the apex: u_z = -P soft, and u_x = -T soft or T = -mu P
        for branch, row in (("stick", [1, 0, soft, 0]), ("slip", [0, 0, 1, mu]), ("open", None)):
            if row is None:
                u, force = numpy.linalg.solve(k, load), numpy.zeros(2)
                valid = u[1] > 0
            else:
                matrix = numpy.zeros((4, 4))
                matrix[:2, :2], matrix[:2, 2:] = k, -numpy.eye(2)
                matrix[2], matrix[3] = row, [0, 1, 0, soft]
                solution = numpy.linalg.solve(matrix, [*load, 0, 0])
                u, force = solution[:2], solution[2:]
                slid = u[0] + force[0] * soft
                valid = force[1] > 0 and (abs(force[0]) <= mu * force[1] if branch == "stick" else slid > 0)
            if valid:
                found[branch] = u
        return found

    def deck(self, rho, mu, way="at once", steps=4, **contact):
        full = [[0, 0], [1, 1]]
        curves = {"normal": full, "shear": full, "rough": [[0, 1], [1, 1]], **WAYS[way]}
        return {
            "mesh": {"file": "tet.exo"},
            "materials": {"m": {"model": "linear_elastic", "young": 1, "poisson": self.poisson}},
            "bodies": {"tet": {"blocks": ["tet"], "material": "m"}, "plane": {"blocks": ["plane"], "rigid": {}}},
            "curves": curves,
            "displacements": {"base": {"set": "base", "fix": ["x", "y", "z"]}},
            "loads": {"press": {"node_set": "apex", "force": [0, 0, -FORCE], "curve": "normal"},
                      "shear": {"node_set": "apex", "force": [rho * FORCE, 0, 0], "curve": "shear"}},
            "contact": {"pair": {"primary": "sides", "secondary": "plane_top", "formulation": "node_on_facet",
                                 "friction": mu, "friction_curve": "rough", **contact}},
            "time": {"steps": steps}, "newton": {"tolerance": 1e-11},
        }


class State:
    """What a run ended with, in units of N: apex displacement, force on it, both one step before."""

    def __init__(self, tet, path, deck):
        self.result = scenes.run(deck, files=[path])
        fields, contact = self.result.fields, self.result.contact()
        self.u, self.u_before = (fields.vector("displacement", i)[0][[0, 2]] / FORCE for i in (-1, -2))
        self.force, self.force_before = (numpy.array([fields.globals(i)[f"pair_force_{axis}"] for axis in "xz"]) / FORCE
                                         for i in (-1, -2))
        self.branch = "stick" if contact["stick_points"] else "slip" if contact["slip_points"] else "open"
        pair, loads = deck["contact"]["pair"], deck["loads"]
        load = numpy.array([loads["shear"]["force"][0], loads["press"]["force"][2]]) / FORCE
        self.unbalanced = numpy.abs(tet.stiffness @ self.u - load - self.force).max()
        self.mu = pair["friction"]
        self.spring = math.inf if "enforcement" in pair else pair["penalty"] * tet.area

    def __str__(self):
        return (f"{self.branch:5s} u_x {self.u[0]:9.3f} u_z {self.u[1]:8.3f} T/P "
                f"{abs(self.force[0] / self.force[1]) if self.force[1] else 0:.4f} P {self.force[1]:.4f}")


class MultipleSolutions(unittest.TestCase):
    def run_in(self, folder, tet, *arguments, **contact):
        path = tet.write(pathlib.Path(folder) / "tet.exo")
        state = State(tet, path, tet.deck(*arguments, **contact))
        self.check_laws(state)
        return state

    def check_laws(self, state):
        """Equilibrium, no pull, no penetration but that of the springs, Coulomb's law with its direction."""
        tangential, normal = state.force
        self.assertLess(state.unbalanced, TOLERANCE)
        self.assertGreaterEqual(normal, 0)
        self.assertLessEqual(abs(tangential), state.mu * normal * (1 + TOLERANCE))
        if state.branch == "open":
            self.assertEqual(normal, 0)
            self.assertGreater(state.u[1], 0)
            return
        self.assertGreater(normal, 0)
        soft = 0 if state.spring == math.inf else 1 / state.spring
        reach = 1 / numpy.abs(state.spring if soft else 1)  # a displacement that is small
        self.assertLess(abs(state.u[1] + soft * normal), TOLERANCE * reach)
        if state.force_before[1] <= 0:
            return  # how much it slid since it touched is not known
        slid = (state.u - state.u_before + soft * (state.force - state.force_before))[0]
        if state.branch == "stick":
            self.assertLess(abs(slid), TOLERANCE * reach)
        else:
            self.assertLess(abs(abs(tangential) / (state.mu * normal) - 1), TOLERANCE)
            self.assertLess(slid * tangential, 0)

    def test_branches(self):
        """At the worst angle: every way ends in a state that holds; alone, a branch is found from the side of stick."""
        poisson = 0.3
        tet = Tet(worst_angle(poisson), poisson)
        mu_c = critical(tet.angle, poisson)
        for rho, mu, names in ((0.5, 1.0, "stick"), (1.2, 1.0, "slip"), (1.7, 1.0, "open"), (1.2, 2.0, "stick"),
                               (1.7, 2.0, "stick slip open"), (2.3, 2.0, "open")):
            for enforcement, options in ENFORCEMENTS.items():
                spring = math.inf if options is MULTIPLIERS else options["penalty"] * tet.area
                exact = tet.solutions(rho, mu, spring)
                self.assertEqual(" ".join(exact), names)
                for way in WAYS:
                    with self.subTest(rho=rho, mu=mu, enforcement=enforcement, way=way), \
                            tempfile.TemporaryDirectory() as folder:
                        state = self.run_in(folder, tet, rho, mu, way, **options)
                        print(f"mu_c {mu_c:.4f} mu {mu} rho {rho} {enforcement:20s} {way:22s} {state}  possible: {names}")
                        if state.branch == "open" or way in FROM_STICK:
                            self.check_branch(state, exact)
                        if way in FROM_STICK:
                            self.assertEqual(state.branch, next(iter(exact)))
                        if mu < rho > mu_c:
                            self.assertEqual(state.branch, "open")
                        if rho < mu_c:
                            self.assertNotEqual(state.branch, "open")

    def check_branch(self, state, exact):
        """Multipliers and springs: the apex where the branch has it."""
        self.assertIn(state.branch, exact)
        error = numpy.abs(state.u - exact[state.branch]).max()
        self.assertLess(error, TOLERANCE * max(1, numpy.abs(exact[state.branch]).max()))

    def test_thresholds(self):
        """Off the plane is possible for rho > mu_c only, whatever mu; slip goes without bound at mu = mu_c."""
        for poisson, degrees in ((0.3, 30), (0.3, 45), (0.3, None), (0.3, 75), (0.45, 45), (0.45, None)):
            tet = Tet(math.radians(degrees) if degrees else worst_angle(poisson), poisson)
            mu_c = critical(tet.angle, poisson)
            if not degrees:
                self.assertAlmostEqual(mu_c, 2 * math.sqrt((2 - 2 * poisson) * (1 - 2 * poisson)), 12)
            with self.subTest(poisson=poisson, degrees=degrees), tempfile.TemporaryDirectory() as folder:
                for share, branch in ((1 - NEAR, "stick"), (1 + NEAR, "open")):
                    state = self.run_in(folder, tet, share * mu_c, 2 * mu_c, "smooth before", **PENALTY)
                    self.assertEqual(state.branch, branch)
                mu, rho = (1 - NEAR) * mu_c, (1 - NEAR / 2) * mu_c
                state = self.run_in(folder, tet, rho, mu, "pressed, then sheared", **STIFF)
                u = tet.solutions(rho, mu, state.spring)["slip"][0]
                rigid = (rho - mu) / (tet.stiffness[0, 0] - mu * abs(tet.stiffness[0, 1]))
                print(f"nu {poisson} phi {math.degrees(tet.angle):5.2f} mu_c {mu_c:.5f}: sticks at rho/mu_c {1 - NEAR}, "
                      f"off at {1 + NEAR}; slip at mu/mu_c {1 - NEAR} {state.u[0]:.5f} exact {u:.5f} rigid {rigid:.5f}")
                self.assertEqual(state.branch, "slip")
                self.assertLess(abs(state.u[0] / u - 1), TOLERANCE)


if __name__ == "__main__":
    unittest.main()
