# SPDX-License-Identifier: BSD-3-Clause
"""Nodal forces of hex8 meshes with flat surfaces normal to z: what a uniform contact pressure does to the
secondary nodes under Gauss quadrature on the primary faces, and what the solution of a run transfers."""
import numpy

HEX_SIDES = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7))
_SIGNS2 = numpy.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
_SIGNS3 = numpy.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1],
                       [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])


def quad_faces(fields, side_set):
    """faces x 4 node indices of a side set of hex8 cells."""
    cells = numpy.concatenate([fields.connectivity(block) for block in fields.names("eb")])
    elements, sides = fields.side_set(side_set)
    return numpy.array([cells[e][list(HEX_SIDES[s - 1])] for e, s in zip(elements, sides)])


def uniform_pressure_defect(fields, primary, secondary, points):
    """Largest relative error of the secondary nodal forces under pressure 1, integrated with
    points x points on each primary face and handed to the secondary face below each point."""
    plan = fields.coordinates[:, :2]
    below = quad_faces(fields, secondary)
    force, exact = numpy.zeros(len(plan)), nodal_areas(fields, secondary)
    abscissae, weights = numpy.polynomial.legendre.leggauss(points)
    for face in quad_faces(fields, primary):
        for a, wa in zip(abscissae, weights):
            for b, wb in zip(abscissae, weights):
                shape, gradient = _quad4(numpy.array([a, b]))
                area = abs(numpy.linalg.det(gradient @ plan[face])) * wa * wb
                target, values = _locate(shape @ plan[face], plan, below)
                force[target] += area * values
    nodes = numpy.unique(below)
    return numpy.max(numpy.abs(force[nodes] - exact[nodes]) / exact[nodes])


def nodal_areas(fields, side_set):
    """Integral of each node's shape function over a flat surface."""
    plan = fields.coordinates[:, :2]
    area = numpy.zeros(len(plan))
    for face in quad_faces(fields, side_set):
        for point in _SIGNS2 / numpy.sqrt(3):
            shape, gradient = _quad4(point)
            area[face] += shape * abs(numpy.linalg.det(gradient @ plan[face]))
    return area


def internal_forces(fields, block, young, poisson):
    """nodes x 3: forces that the displacements of the last step need in a linear elastic block."""
    x, u = fields.coordinates, fields.vector("displacement")
    force = numpy.zeros_like(x)
    shear = young / (2 * (1 + poisson))
    lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    for cell in fields.connectivity(block):
        for point in _SIGNS3 / numpy.sqrt(3):
            gradient = _hex8_gradient(point)
            jacobian = gradient @ x[cell]
            gradient = numpy.linalg.solve(jacobian, gradient)
            strain = gradient @ u[cell]
            strain = (strain + strain.T) / 2
            stress = 2 * shear * strain + lame * numpy.trace(strain) * numpy.eye(3)
            force[cell] += (gradient.T @ stress) * numpy.linalg.det(jacobian)
    return force


def _quad4(point):
    terms = 1 + _SIGNS2 * point
    shape = terms[:, 0] * terms[:, 1] / 4
    gradient = numpy.stack([_SIGNS2[:, 0] * terms[:, 1], _SIGNS2[:, 1] * terms[:, 0]]) / 4
    return shape, gradient


def _hex8_gradient(point):
    t = 1 + _SIGNS3 * point
    return numpy.stack([_SIGNS3[:, 0] * t[:, 1] * t[:, 2], _SIGNS3[:, 1] * t[:, 0] * t[:, 2],
                        _SIGNS3[:, 2] * t[:, 0] * t[:, 1]]) / 8


def _locate(position, plan, faces):
    """Nodes of the face that holds a position and its shape values there."""
    best = None
    for face in faces:
        if numpy.any(position < plan[face].min(0) - 1e-9) or numpy.any(position > plan[face].max(0) + 1e-9):
            continue
        point = numpy.zeros(2)
        for _ in range(20):
            shape, gradient = _quad4(point)
            point = point + numpy.linalg.solve((gradient @ plan[face]).T,
                                               position - shape @ plan[face])
        outside = numpy.max(numpy.abs(point))
        if best is None or outside < best[0]:
            best = (outside, face, _quad4(point)[0])
    assert best is not None and best[0] < 1 + 1e-6, position
    return best[1], best[2]
