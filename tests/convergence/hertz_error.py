# SPDX-License-Identifier: BSD-3-Clause
"""Contact pressure of a run held against the Hertz solution of the same force.

Taking the force from the run leaves out how far the body reaches (a half-space has no depth of its own).
"""
import math

import numpy

GAUSS, WEIGHT = numpy.polynomial.legendre.leggauss(4)


def pressure_line(fields, side):
    """Abscissae and nodal contact pressures along y = 0 of a surface, by growing x."""
    nodes = fields.node_set(side)
    nodes = nodes[numpy.abs(fields.coordinates[nodes, 1]) < 1e-12]
    nodes = nodes[numpy.argsort(fields.coordinates[nodes, 0])]
    return (fields.coordinates[nodes, 0] + fields.nodal("displacement_x")[nodes],
            fields.nodal("contact_pressure")[nodes])


def cylinder(force, radius, modulus):
    """Half width and peak pressure; force per length, modulus 1/E* = (1 - nu^2)/E."""
    a = math.sqrt(4 * force * radius / (math.pi * modulus))
    return a, 2 * force / (math.pi * a)


def sphere(force, radius, modulus):
    """Contact radius and peak pressure."""
    a = (3 * force * radius / (4 * modulus))**(1 / 3)
    return a, 3 * force / (2 * math.pi * a**2)


def pressure_error(x, p, a, peak, axisymmetric=False, pieces=40):
    """Relative L2 error of the piecewise linear pressure, over a line or (weight r) over a disc."""
    error = norm = 0.0
    for left, right, p_left, p_right in zip(x, x[1:], p, p[1:]):
        if left > 2 * a:
            break
        edges = numpy.linspace(left, right, pieces + 1)
        middle, half = (edges[1:] + edges[:-1]) / 2, (edges[1] - edges[0]) / 2
        s = (middle[:, None] + half * GAUSS).ravel()
        w = numpy.tile(half * WEIGHT, pieces) * (s if axisymmetric else 1)
        computed = p_left + (p_right - p_left) * (s - left) / (right - left)
        exact = peak * numpy.sqrt(numpy.maximum(1 - (s / a)**2, 0))
        error += numpy.sum(w * (computed - exact)**2)
        norm += numpy.sum(w * exact**2)
    return math.sqrt(error / norm)


def regressed_radius(x, p, a):
    """From p^2 = c0 + c1 x^2 over 0.2 a < x < 0.9 a; needs no face to end at the contact edge."""
    inside = (x > 0.2 * a) & (x < 0.9 * a)
    if numpy.count_nonzero(inside) < 2:
        inside = x < 0.9 * a
    slope, constant = numpy.polyfit(x[inside]**2, p[inside]**2, 1)
    return math.sqrt(-constant / slope)


# Penalty-softened Hertz sphere, E*/(eps a): force at the same approach over that of Hertz.
SOFTENED = ((.003, .9986), (.01, .9953), (.03, .9859), (.1, .9548), (.3, .8770), (1.0, .6870))


def softened(softness):
    """Force over that of Hertz, from the table; what is lost is interpolated in logarithms."""
    return 1 - math.exp(numpy.interp(math.log(softness), [math.log(s) for s, _ in SOFTENED],
                                     [math.log(1 - f) for _, f in SOFTENED]))
