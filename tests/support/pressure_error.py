# SPDX-License-Identifier: BSD-3-Clause
"""Contact pressures of facets, nodes and points of a run held against a known pressure.

All three are on the primary faces of one side set. A facet's pressure is the mean over its points, as programs
that keep one number per face report it; the nodal pressure is the bilinear field between the corners.
"""
import csv
import math

import numpy

CORNERS = {  # of the sides of a cell, as Exodus counts both
    8: ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)),
    4: ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)),
    6: ((0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1), (3, 4, 5)),
}
CELL_CORNERS = {8: 8, 20: 8, 27: 8, 4: 4, 10: 4, 6: 6}
POINT_WEIGHTS = {9: numpy.outer((5, 8, 5), (5, 8, 5)).ravel() / 324}
GAUSS, WEIGHT = numpy.polynomial.legendre.leggauss(3)


def face_corners(fields, blocks, side):
    """(faces, 3 or 4) node indices of the faces of a side set, whose cells lie in `blocks` from the first on."""
    elements, sides = fields.side_set(side)
    faces, first = [], 0
    for block in blocks:
        nodes = fields.connectivity(block)
        table = CORNERS[CELL_CORNERS[nodes.shape[1]]]
        here = (elements >= first) & (elements < first + len(nodes))
        faces += [nodes[e - first][list(table[s - 1])] for e, s in zip(elements[here], sides[here])]
        first += len(nodes)
    return numpy.array(faces)


def read_points(path):
    """Points of each written step: {time: {column: array}} with numbers where the columns hold numbers."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    steps = {}
    for row in rows:
        steps.setdefault(float(row["time"]), []).append(row)
    words = ("status", "interface")
    return {time: {key: numpy.array([row[key] if key in words else float(row[key]) for row in list_])
                   for key in list_[0]} for time, list_ in steps.items()}


def area_of(x):
    """Areas of faces (faces, corners, 3): exact for flat ones."""
    normal = numpy.cross(x[:, 2] - x[:, 0], x[:, -1] - x[:, 1]) if x.shape[1] == 4 else \
        numpy.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
    return numpy.linalg.norm(normal, axis=1) / 2


class Facets:
    """Mean pressures of the faces in the order of the side set, and of their points.

    reference, current: (faces, corners, 3); point_x (faces, points, 3); point_p, gap, active (faces, points).
    """

    def __init__(self, fields, blocks, side, points, step=-1):
        self.corners = face_corners(fields, blocks, side)
        x = fields.coordinates
        self.reference = x[self.corners]
        self.current = (x + fields.vector("displacement", step))[self.corners]
        self.nodal = fields.nodal("contact_pressure", step)[self.corners]
        self.area = area_of(self.reference)
        ids, count = numpy.unique(points["face"], return_counts=True)
        assert len(ids) == len(self.corners) and len(set(count)) == 1, "a point file of another surface"
        shape = len(ids), count[0]
        order = numpy.lexsort((points["point"], points["face"]))
        px = numpy.stack([points[axis][order] for axis in "xyz"], axis=1).reshape(*shape, 3)
        pp = points["pressure"][order].reshape(shape)
        middle, centers = px.mean(1), self.current.mean(1)
        nearest = [int(numpy.argmin(numpy.sum((middle - c)**2, axis=1))) for c in centers]
        assert len(set(nearest)) == len(nearest), "points of two faces lie on one"
        self.point_x, self.point_p = px[nearest], pp[nearest]
        self.gap = points["gap"][order].reshape(shape)[nearest]
        self.active = points["status"][order].reshape(shape)[nearest] != "open"
        self.weights = POINT_WEIGHTS.get(shape[1], numpy.full(shape[1], 1 / shape[1]))
        self.mean = self.point_p @ self.weights


def shape_functions(u, v):
    """(4, ...) of a quadrilateral with corners at -1 and 1."""
    return numpy.stack([(1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v)]) / 4


def corner_functions(facets):
    """(4, faces, points) bilinear functions at the points, found from where the points lie."""
    x = facets.current
    u, v = (numpy.zeros(facets.point_p.shape) for _ in "uv")
    for _ in range(20):
        du = numpy.stack([-(1 - v), 1 - v, 1 + v, -(1 + v)]) / 4
        dv = numpy.stack([-(1 - u), -(1 + u), 1 + u, 1 - u]) / 4
        miss = facets.point_x - numpy.einsum("afp,fad->fpd", shape_functions(u, v), x)
        tangents = numpy.stack([numpy.einsum("afp,fad->fpd", d, x) for d in (du, dv)], axis=-1)
        step = numpy.linalg.solve(numpy.einsum("fpdi,fpdj->fpij", tangents, tangents),
                                  numpy.einsum("fpdi,fpd->fpi", tangents, miss)[..., None])[..., 0]
        u, v = u + step[..., 0], v + step[..., 1]
    assert numpy.max(numpy.abs(miss)) < 1e-9, "points of curved faces"
    return shape_functions(u, v)


def weighted_gaps(facets, dual):
    """Largest |mean gap| over face size at the nodes whose faces are closed at every point, with the functions of
    the corners or their dual basis as weights. Quadrilaterals."""
    w = facets.area[:, None] * facets.weights
    functions = corner_functions(facets)
    if dual:
        mass = numpy.einsum("fp,afp,bfp->fab", w, functions, functions)
        diagonal = numpy.einsum("fp,afp->fa", w, functions)
        functions = numpy.einsum("fa,fab,bfp->afp", diagonal, numpy.linalg.inv(mass), functions)
    size = facets.corners.max() + 1
    top, bottom, closed = numpy.zeros(size), numpy.zeros(size), numpy.ones(size, bool)
    numpy.add.at(top, facets.corners, numpy.einsum("fp,afp,fp->fa", w, functions, facets.gap))
    numpy.add.at(bottom, facets.corners, numpy.einsum("fp,afp->fa", w, functions))
    numpy.logical_and.at(closed, facets.corners, facets.active.all(1)[:, None])
    nodes = numpy.intersect1d(numpy.unique(facets.corners), numpy.flatnonzero(closed))
    face = math.sqrt(facets.area.min())
    return float(numpy.max(numpy.abs(top[nodes] / bottom[nodes]))) / face if len(nodes) else math.nan


def field_samples(x, p, pieces=4):
    """Points, pressures and areas that integrate a bilinear (linear) field over faces (faces, corners, ...)."""
    edges = numpy.linspace(-1, 1, pieces + 1)
    half = 1 / pieces
    s = ((edges[1:] + edges[:-1])[:, None] / 2 + half * GAUSS).ravel()
    w = numpy.tile(WEIGHT * half, pieces)
    u, v = (a.ravel() for a in numpy.meshgrid(s, s, indexing="ij"))
    weight = numpy.outer(w, w).ravel()
    if x.shape[1] == 4:
        shape = shape_functions(u, v)
        du = numpy.stack([-(1 - v), 1 - v, 1 + v, -(1 + v)]) / 4
        dv = numpy.stack([-(1 - u), -(1 + u), 1 + u, 1 - u]) / 4
    else:  # the square folded to the triangle
        r, t = (1 + u) / 2, (1 + u) / 2 * (1 + v) / 2
        shape = numpy.stack([1 - r, r - t, t])
        du, dv = (numpy.repeat(d[:, None], len(u), 1) for d in numpy.array([[-1, 1, 0], [-1, 0, 1]]))
        weight = weight * r / 4
    where = numpy.einsum("as,fad->fsd", shape, x)
    jacobian = numpy.linalg.norm(numpy.cross(numpy.einsum("as,fad->fsd", du, x),
                                             numpy.einsum("as,fad->fsd", dv, x)), axis=2)
    return where, numpy.einsum("as,fa->fs", shape, p), jacobian * weight


def relative(weight, p, exact):
    return math.sqrt(numpy.sum(weight * (p - exact)**2) / numpy.sum(weight * exact**2))


class HertzScore:
    """Errors against Hertz under the force of the run [1].

    facet: L2 of the means over the reference faces (reference centers); facet_inner: r < 0.9 a alone; facet_center: of
    the facet next to the axis; nodal_facet: as facet, of the means of the corners' nodal pressure; nodal, nodal_inner:
    L2 of the nodal field in place; point, point_inner: L2 of the points' values; center: nodal pressure on the axis.
    """

    def __init__(self, facets, quarter_force, radius, modulus):
        self.force = 4 * quarter_force
        self.a = (3 * self.force * radius / (4 * modulus))**(1 / 3)
        self.p0 = 3 * self.force / (2 * math.pi * self.a**2)
        r = numpy.linalg.norm(facets.reference.mean(1)[:, :2], axis=1)
        inner = r < 0.9 * self.a
        exact = self.exact(r)
        self.facet = relative(facets.area, facets.mean, exact)
        self.facet_inner = relative(facets.area[inner], facets.mean[inner], exact[inner])
        self.nodal_facet = relative(facets.area, facets.nodal.mean(1), exact)
        first = numpy.argmin(r)
        self.facet_center = facets.mean[first] / exact[first] - 1
        self.facets_per_radius = self.a / math.sqrt(facets.area[first])
        x, p, area = field_samples(facets.current, facets.nodal)
        self.nodal, self.nodal_inner = self.both(numpy.linalg.norm(x[..., :2], axis=2), p, area)
        r = numpy.linalg.norm(facets.point_x[..., :2], axis=2)
        weight = area_of(facets.current)[:, None] * facets.weights
        self.point, self.point_inner = self.both(r, facets.point_p, weight)
        pole = numpy.argmin(numpy.linalg.norm(facets.reference[..., :2], axis=2))
        self.center = facets.nodal.ravel()[pole] / self.p0 - 1

    def exact(self, r):
        return self.p0 * numpy.sqrt(numpy.maximum(0, 1 - (r / self.a)**2))

    def both(self, r, p, weight):
        exact, inner = self.exact(r), r < 0.9 * self.a
        return relative(weight, p, exact), relative(weight[inner], p[inner], exact[inner])
