# SPDX-License-Identifier: BSD-3-Clause
"""Two elastic rings a < b < c of one material in plane strain, frictionless at b, under the pressure
p0 + p2 cos 2 theta from outside: the contact pressure is P0 + P2 cos 2 theta.

P0 follows Lame. For the second harmonic each ring has the stress function
(A r^2 + B r^4 + C/r^2 + D) cos 2 theta (Michell 1899); eight conditions at a, b and c give its constants.
"""
import math

import numpy

import scenes

INNER, INTERFACE, OUTER = 0.2, 0.6, 1.0
YOUNG, POISSON = 1.0, 0.2
THICKNESS = 0.1


def radial_stress(r):
    return -numpy.array([2.0, 0.0, 6 * r**-4, 4 * r**-2])


def shear_stress(r):
    return numpy.array([2.0, 6 * r**2, -6 * r**-4, -2 * r**-2])


def radial_displacement(r):
    """Times 2 G."""
    k = 3 - 4 * POISSON
    return numpy.array([-2 * r, (k - 3) * r**3, 2 * r**-3, (k + 1) / r])


def exact_harmonics(p0, p2):
    """P0 and P2."""
    a, b, c = INNER, INTERFACE, OUTER
    none = numpy.zeros(4)
    rows = [(radial_stress(a), none, 0), (shear_stress(a), none, 0), (shear_stress(b), none, 0),
            (none, shear_stress(b), 0), (radial_stress(b), -radial_stress(b), 0),
            (radial_displacement(b), -radial_displacement(b), 0),
            (none, radial_stress(c), -p2), (none, shear_stress(c), 0)]
    matrix = numpy.array([numpy.concatenate(row[:2]) for row in rows])
    constants = numpy.linalg.solve(matrix, numpy.array([row[2] for row in rows]))
    uniform = p0 * c**2 * (b**2 - a**2) / (b**2 * (c**2 - a**2))
    return uniform, -radial_stress(b) @ constants[:4]


def scene(inner_theta, outer_theta, p0, p2, element="hex8", inner_primary=True, radial=None, **contact):
    """Quarter of the rings, one cell thick; radial: cells through each ring."""
    r2 = "(x^2+y^2)"
    pressure = f"({p0!r}+{p2!r}*(x^2-y^2)/{r2})"
    traction = [f"-{pressure}*{axis}/sqrt{r2}*t" for axis in "xy"] + [0]
    sides = ["inner_outer", "outer_inner"]
    primary, secondary = sides if inner_primary else sides[::-1]
    radial = radial or min(inner_theta, outer_theta) // 2
    return {
        "mesh": {"generate": {"kind": "rings", "inner_radius": INNER, "interface_radius": INTERFACE,
                              "outer_radius": OUTER, "thickness": THICKNESS, "element": element,
                              "inner_theta": inner_theta, "outer_theta": outer_theta,
                              "inner_r": radial, "outer_r": radial}},
        "materials": {"elastic": {"model": "linear_elastic", "young": YOUNG, "poisson": POISSON}},
        "bodies": {ring: {"blocks": [ring], "material": "elastic"} for ring in ("inner", "outer")},
        "displacements": {"x": {"set": "x0", "fix": ["x"]}, "y": {"set": "y0", "fix": ["y"]},
                          "front": {"set": "z0", "fix": ["z"]}, "back": {"set": "z1", "fix": ["z"]}},
        "loads": {"outside": {"side_set": "outer_outer", "traction": traction}},
        "contact": {"pair": {"primary": primary, "secondary": secondary, **contact}},
    }


class Errors:
    """Relative errors of the pressure, L2 and largest over P0, and of its harmonics P0 and P2."""

    def __init__(self, deck, p0, p2):
        self.result = result = scenes.run(deck, seconds=300)
        fields = result.fields
        nodes = fields.node_set(deck["contact"]["pair"]["primary"])
        nodes = nodes[numpy.abs(fields.coordinates[nodes, 2]) < 1e-12]
        angle = numpy.arctan2(fields.coordinates[nodes, 1], fields.coordinates[nodes, 0])
        order = numpy.argsort(angle)
        angle, nodes = angle[order], nodes[order]
        # results report force per current area; the solution of small strains knows one area only
        pressure = fields.nodal("contact_pressure")[nodes] * self.stretch(
            fields.coordinates[nodes], fields.vector("displacement")[nodes])
        exact0, exact2 = exact_harmonics(p0, p2)
        error = pressure - exact0 - exact2 * numpy.cos(2 * angle)
        self.pressure = math.sqrt(self.integral(angle, error**2) / (exact0**2 * math.pi / 2))
        self.largest = numpy.max(numpy.abs(error)) / exact0
        self.uniform = self.integral(angle, pressure) * 2 / math.pi / exact0 - 1
        self.second = self.integral(angle, pressure * numpy.cos(2 * angle)) * 4 / math.pi / exact2 - 1
        self.active = result.contact()["active_points"]
        self.unknowns = result.summary["unknowns"]
        self.augmentations = result.summary["augmentations"]

    @staticmethod
    def stretch(x, u):
        """Length ratio of the faces at each node, the mean of its two."""
        ratio = (numpy.linalg.norm(numpy.diff(x + u, axis=0), axis=1) /
                 numpy.linalg.norm(numpy.diff(x, axis=0), axis=1))
        return (numpy.append(ratio, ratio[-1]) + numpy.append(ratio[0], ratio)) / 2

    @staticmethod
    def integral(x, y):
        """Trapezoids: exact to round-off for the first harmonics over a quarter."""
        return float(numpy.sum((x[1:] - x[:-1]) * (y[1:] + y[:-1])) / 2)

    def __str__(self):
        return (f"pressure L2 {self.pressure:.5f}  max {self.largest:.5f}  P0 {self.uniform:+.5f}  "
                f"P2 {self.second:+.5f}  ({self.unknowns} unknowns, {self.augmentations} augmentations, "
                f"{self.active} points)")
