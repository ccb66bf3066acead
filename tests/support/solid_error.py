# SPDX-License-Identifier: BSD-3-Clause
"""Norms of the error of displacement fields on hex8 and hex20 meshes against exact fields.

    errors = solid_error.norms(fields, "upper", displacement, gradient, lame, shear)

displacement(x, y, z) -> (3, points), gradient(x, y, z) -> (3, 3, points) with [i][j] = du_i/dx_j, both of
reference coordinates.
"""
import numpy

_CORNERS = numpy.array([(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1),
                        (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)], float)
_EDGES = numpy.array([(0, -1, -1), (1, 0, -1), (0, 1, -1), (-1, 0, -1),
                      (-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0),
                      (0, -1, 1), (1, 0, 1), (0, 1, 1), (-1, 0, 1)], float)


def shapes(nodes, xi):
    """N (nodes) and its gradient (nodes, 3) at a point of the reference cell [-1, 1]^3."""
    if nodes not in (8, 20):
        raise ValueError(f"cells of {nodes} nodes")
    values, slopes = numpy.zeros(nodes), numpy.zeros((nodes, 3))
    for a, corner in enumerate(_CORNERS):
        factor = 1 + corner * xi
        bulge = corner @ xi - 2 if nodes == 20 else 1.0
        values[a] = factor.prod() * bulge / 8
        for k in range(3):
            rest = factor.prod() / factor[k] if factor[k] else numpy.delete(factor, k).prod()
            slopes[a, k] = corner[k] * rest * (bulge + (factor[k] if nodes == 20 else 0)) / 8
    for a, edge in enumerate(_EDGES if nodes == 20 else ()):
        factor = numpy.where(edge == 0, 1 - xi**2, 1 + edge * xi)
        slope = numpy.where(edge == 0, -2 * xi, edge)
        values[8 + a] = factor.prod() / 4
        for k in range(3):
            slopes[8 + a, k] = slope[k] * numpy.delete(factor, k).prod() / 4
    return values, slopes


def norms(fields, block, displacement, gradient, lame, shear, points=4):
    """(error, exact) pairs: L2 norm of the displacement and energy norm sqrt(int strain : C : strain)."""
    cells = fields.connectivity(block)
    x, u = fields.coordinates[cells], fields.vector("displacement")[cells]
    place, weight = numpy.polynomial.legendre.leggauss(points)
    sums = numpy.zeros(4)
    for i in range(points**3):
        index = numpy.unravel_index(i, (points,) * 3)
        values, slopes = shapes(cells.shape[1], place[list(index)])
        jacobian = numpy.einsum("eai,ak->eik", x, slopes)
        volume = numpy.linalg.det(jacobian) * weight[list(index)].prod()
        computed = numpy.einsum("eai,ak,ekj->ije", u, slopes, numpy.linalg.inv(jacobian))
        at = numpy.einsum("eai,a->ie", x, values)
        exact = displacement(*at)
        sums[0] += volume @ ((numpy.einsum("eai,a->ie", u, values) - exact)**2).sum(axis=0)
        sums[1] += volume @ (exact**2).sum(axis=0)
        for k, slope in ((2, computed - gradient(*at)), (3, gradient(*at))):
            strain = (slope + slope.transpose(1, 0, 2)) / 2
            density = lame * numpy.trace(strain)**2 + 2 * shear * (strain**2).sum(axis=(0, 1))
            sums[k] += volume @ density
    return tuple(numpy.sqrt(sums[:2])), tuple(numpy.sqrt(sums[2:]))


def line_error(x, values, exact, pieces=8):
    """(error, exact) L2 norms over a line of the piecewise linear function through (x, values)."""
    place, weight = numpy.polynomial.legendre.leggauss(4)
    error = norm = 0.0
    for left, right, v_left, v_right in zip(x, x[1:], values, values[1:]):
        edges = numpy.linspace(left, right, pieces + 1)
        s = ((edges[1:] + edges[:-1])[:, None] / 2 + numpy.diff(edges)[:, None] / 2 * place).ravel()
        w = (numpy.diff(edges)[:, None] / 2 * weight).ravel()
        computed = v_left + (v_right - v_left) * (s - left) / (right - left)
        error += w @ (computed - exact(s))**2
        norm += w @ exact(s)**2
    return numpy.sqrt(error), numpy.sqrt(norm)
