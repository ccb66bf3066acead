# SPDX-License-Identifier: BSD-3-Clause
"""A manufactured solution of the Signorini problem with and without friction: scene, exact fields, errors.

A slab 0 <= Z <= 1, |X| <= 1 in plane strain (linear elastic), held at its top, pressed on a rigid obstacle:

    u_z = -d - P(X) (Z - Z^2)        u_x = S + mu m P(X) (Z - Z^2),  m = (L + 2 G)/G
    contact pressure p = (L + 2 G) P, shear traction mu p, gap 0, slip S everywhere

so that the stress of the contact face and Coulomb's law agree exactly; mu = S = 0 without friction. With
`share` < 1 the shear is share mu p and S = d = 0: every point sticks. Body force and tractions of the two ends follow from the stress. "partial": P = A max(0, 1 - X^2/a^2)^2, the face
lifts off the obstacle, which falls away beyond |X| = a; "full": P = A (2 + cos(pi X)), contact everywhere.
"""
import math

import numpy

import scenes
import solid_error

YOUNG, POISSON = 1.0, 0.3
SHEAR = YOUNG / (2 * (1 + POISSON))
LAME = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
STIFF = LAME + 2 * SHEAR
APPROACH = 0.01  # d
AMPLITUDE = 0.01  # A
EDGE = 0.5  # a
DROP = 0.5  # of the obstacle beyond a, times (|X| - a)^2
OBSTACLE = (2.5, 0.5)  # width and height
_NAMES = {"pi": math.pi, "cos": numpy.cos, "sin": numpy.sin, "abs": numpy.abs, "max": numpy.maximum}
_PROFILES = {  # P, P', P'' as formulas in X that the deck and numpy both read
    "partial": (f"{AMPLITUDE}*max(0,1-X^2/{EDGE**2})^2",
                f"({-4 * AMPLITUDE / EDGE**2}*X*max(0,1-X^2/{EDGE**2}))",
                f"({-4 * AMPLITUDE / EDGE**2}*(1-3*X^2/{EDGE**2})*(abs(X)<{EDGE}))"),
    "full": (f"({AMPLITUDE}*(2+cos(pi*X)))",
             f"({-AMPLITUDE}*pi*sin(pi*X))",
             f"({-AMPLITUDE}*pi^2*cos(pi*X))"),
}


class Solution:
    """Exact fields. friction > 0: the slab slides by `slip` along x, or sticks when share < 1."""

    def __init__(self, kind, friction=0.0, share=1.0, slip=0.05):
        self.kind, self.friction, self.shear_ratio = kind, friction, share * friction
        self.slip = slip if friction and share == 1 else 0.0
        # Where a face that is not in contact yet will stick depends on how it gets there.
        self.approach = APPROACH if share == 1 else 0.0
        self._profile = [formula.replace("^", "**") for formula in _PROFILES[kind]]
        p, dp, ddp = _PROFILES[kind]
        w, dw = "(Z-Z^2)", "(1-2*Z)"
        m = self.shear_ratio * STIFF / SHEAR
        # derivatives of u_x and u_z
        self._xx, self._xz = f"{m}*{dp}*{w}", f"{m}*{p}*{dw}"
        self._zx, self._zz = f"-{dp}*{w}", f"-{p}*{dw}"
        self.body_force = (f"{LAME + SHEAR}*{dp}*{dw}-{m}*({STIFF}*{ddp}*{w}-{2 * SHEAR}*{p})",
                           f"{SHEAR}*{ddp}*{w}-{2 * STIFF}*{p}-{m}*{LAME + SHEAR}*{dp}*{dw}")
        self.sigma_xx = f"{STIFF}*({self._xx})+{LAME}*({self._zz})"
        self.sigma_xz = f"{SHEAR}*({self._xz}+({self._zx}))"
        self.sigma_zz = f"{LAME}*({self._xx})+{STIFF}*({self._zz})"
        self.middle = OBSTACLE[0] / 2 - self.slip  # x of X = 0

    def in_deck(self, formula):
        """The same formula in the coordinates of the mesh, growing with the load parameter."""
        place = {"X": f"(x-{self.middle})", "Z": f"(z-{self.approach})"}
        return "(" + "".join(place.get(c, c) for c in formula) + ")*t"

    def value(self, formula, x, z):
        return eval(formula.replace("^", "**"), {**_NAMES, "X": x, "Z": z})  # formulas of this file

    def displacement(self, x, y, z):
        x, z = x - self.middle, z - self.approach
        bulge = self.value(_PROFILES[self.kind][0], x, z) * (z - z**2)
        m = self.shear_ratio * STIFF / SHEAR
        return numpy.array([self.slip + m * bulge, 0 * y, -self.approach - bulge])

    def deformation(self, x, y, z):
        """What is left of displacement without the motion of the whole."""
        return self.displacement(x, y, z) - numpy.array([self.slip, 0, -self.approach])[:, None]

    def gradient(self, x, y, z):
        x, z = x - self.middle, z - self.approach
        slopes = numpy.zeros((3, 3, len(x)))
        for i, j, formula in ((0, 0, self._xx), (0, 2, self._xz), (2, 0, self._zx), (2, 2, self._zz)):
            slopes[i, j] = self.value(formula, x, z)
        return slopes

    def unbalanced(self, x, z, step=1e-4):
        """Divergence of the stress plus body force, by central differences, in X and Z."""
        def slope(formula, direction):
            dx, dz = (step, 0) if direction == "x" else (0, step)
            return (self.value(formula, x + dx, z + dz) - self.value(formula, x - dx, z - dz)) / (2 * step)
        return numpy.array([
            slope(self.sigma_xx, "x") + slope(self.sigma_xz, "z") + self.value(self.body_force[0], x, z),
            slope(self.sigma_xz, "x") + slope(self.sigma_zz, "z") + self.value(self.body_force[1], x, z)])

    def pressure(self, x):
        return STIFF * self.value(_PROFILES[self.kind][0], x - self.middle, 0)


def scene(solution, cells, element, **contact):
    """cells: n along Z and 2 n along X; one across y, where it is held in plane strain."""
    side = 1 / cells
    partial = solution.kind == "partial"
    load = solution.in_deck
    ends = {f"end{end}": {"side_set": f"upper_x{end}",
                          "traction": [f"{sign}*{load(solution.sigma_xx)}", 0,
                                       f"{sign}*{load(solution.sigma_xz)}"]}
            for end, sign in ((0, "-1"), (1, "1"))}
    if solution.friction:
        contact["friction"] = solution.friction
    return {
        "mesh": {"generate": {
            "kind": "blocks", "element": element, "gap": solution.approach, "shift": -solution.slip,
            "upper_size": [2, side, 1], "upper_divisions": [2 * cells, 1, cells],
            "lower_size": [OBSTACLE[0], 2 * side, OBSTACLE[1]],
            "lower_divisions": [10 * (cells // 4), 1, 1],
            "flat": EDGE if partial else OBSTACLE[0], "drop": DROP}},
        "materials": {"elastic": {"model": "linear_elastic", "young": YOUNG, "poisson": POISSON}},
        "bodies": {"slab": {"blocks": ["upper"], "material": "elastic"},
                   "obstacle": {"blocks": ["lower"], "rigid": {}}},
        "displacements": {"top": {"set": "upper_top", "x": solution.slip, "z": -solution.approach},
                          "front": {"set": "upper_y0", "fix": ["y"]},
                          "back": {"set": "upper_y1", "fix": ["y"]}},
        "loads": {"body": {"block": "upper", "body_force": [load(solution.body_force[0]), 0,
                                                            load(solution.body_force[1])]}, **ends},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
        "newton": {"tolerance": 1e-11},
    }


# Multipliers of the points leave no gap at any of them: only then are the orders those of the exact problem.
AUGMENTED = {"enforcement": "augmented_lagrangian", "multipliers": "per_point", "penalty_factor": 10,
             "multiplier_tolerance": 1e-6, "max_augmentations": 50}
# What a deck gets by itself, closed further than to the default's thousandth of a face: that is of order 1.
DEFAULT = {"enforcement": "augmented_lagrangian", "gap_tolerance": 1e-7, "max_augmentations": 50}


class Errors:
    """Relative errors of one run: displacement L2 and energy norm, pressure and shear traction L2."""

    def __init__(self, solution, cells, element, seconds=900, **contact):
        result = scenes.run(scene(solution, cells, element, **contact), seconds=seconds)
        fields = result.fields
        (u, _), (energy, whole) = solid_error.norms(fields, "upper", solution.displacement,
                                                    solution.gradient, LAME, SHEAR)
        (_, size), _ = solid_error.norms(fields, "upper", solution.deformation, solution.gradient,
                                         LAME, SHEAR)
        self.displacement, self.energy = u / size, energy / whole
        x, p = self.line(fields, "contact_pressure", cells)
        error, norm = solid_error.line_error(x, p, solution.pressure)
        self.pressure = error / norm
        _, shear = self.line(fields, "contact_traction_x", cells)
        error, _ = solid_error.line_error(x, shear, lambda s: -solution.shear_ratio * solution.pressure(s))
        self.shear = error / norm
        self.contact = result.contact()
        self.summary = result.summary
        self.cells = cells

    @staticmethod
    def line(fields, name, cells):
        """Corner nodes of the contact face along y, the mean of both sides, by growing x."""
        nodes = fields.node_set("upper_bottom")
        places = fields.coordinates[nodes]
        column, across = ((places[:, :2] - places[:, :2].min(axis=0)) * cells).T
        corner = (abs(column - column.round()) < 1e-6) & (abs(across - across.round()) < 1e-6)
        values, x = numpy.zeros(2 * cells + 1), numpy.zeros(2 * cells + 1)
        for node, k in zip(nodes[corner], column[corner].round().astype(int)):
            values[k] += fields.nodal(name)[node] / 2
            x[k] = fields.coordinates[node, 0]
        return x, values

    def __str__(self):
        return (f"n {self.cells:3d}  u L2 {self.displacement:.3e}  energy {self.energy:.3e}  "
                f"pressure {self.pressure:.3e}  shear {self.shear:.3e}  "
                f"penetration/h {self.contact['max_penetration'] * self.cells:.1e}  "
                f"active {self.contact['active_points']}  "
                f"newton {self.summary['newton_iterations']}  "
                f"augmentations {self.summary['augmentations']}  "
                f"{self.summary['wall_seconds']:.2f} s")
