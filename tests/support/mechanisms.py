# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of rigid bodies and joints: bricks, hinges, what a body does to a vector.

Joints close to 1e-9 of a body's size, so that positions are compared to 1e-8 of it; forces follow
from positions and from Newton's tolerance, 1e-8, times the lever arms of the mechanism.
"""
import pathlib
import shutil
import tempfile
import unittest

import numpy

import exodus_edit
import scenes

POSITION, FORCE = 1e-8, 1e-6
FREE = ["x", "y", "z", "rx", "ry", "rz"]
CORNERS = numpy.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                       (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]) - 0.5


def mesh_of(blocks, sides=None):
    """blocks: {name: (nodes, hexahedra)}; sides: {name: [(block, element, side), ...]}."""
    x, parts, first = [], [], {}
    count = elements = 0
    for i, (name, (nodes, cells)) in enumerate(blocks.items(), 1):
        parts.append(exodus_edit.Block(name, i, "HEX8", numpy.array(cells) + count))
        x.append(numpy.array(nodes, float))
        first[name] = elements
        count += len(nodes)
        elements += len(cells)
    mesh = exodus_edit.ExodusMesh(numpy.concatenate(x), parts)
    for name, faces in (sides or {}).items():
        mesh.side_sets[name] = (numpy.array([first[b] + e for b, e, s in faces]),
                                numpy.array([s for b, e, s in faces]))
    return mesh


def bar(a, b, width=0.1):
    """A brick between two points of the plane z = 0."""
    a, b = numpy.array(a, float), numpy.array(b, float)
    along = b - a
    across = numpy.array([-along[1], along[0]]) / numpy.linalg.norm(along) * width
    middle = 0.5 * (a + b)
    nodes = [(*(middle + c[0] * along + c[1] * across), c[2] * width) for c in CORNERS]
    return nodes, [range(8)]


def brick(center, size):
    return numpy.array(center) + CORNERS * size, [range(8)]


class Scene(unittest.TestCase):
    def solve(self, mesh, deck, **options):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        exodus_edit.write(folder / "scene_mesh.exo", mesh)
        deck = {"mesh": {"file": "scene_mesh.exo"}, **deck}
        return scenes.run(deck, files=[folder / "scene_mesh.exo"], **options)

    def same(self, a, b, steps, force):
        """All that bodies, joints and contact report, in lengths of one and this force."""
        for step in range(steps + 1):
            one, other = a.fields.globals(step), b.fields.globals(step)
            for name in filter(is_size, one):
                size = force if "_force" in name or "_moment" in name else 1.0
                self.assertAlmostEqual(one[name], other[name], delta=1e-10 * size, msg=name)

    def close(self, found, expected, tolerance):
        numpy.testing.assert_allclose(found, expected, rtol=0, atol=tolerance)


def is_size(name):
    return name[-2:] in ("_x", "_y", "_z") or name.endswith(("_rotation", "_translation"))


def free_body(name, center, **more):
    return {"blocks": [name], "rigid": {"free": FREE, "center": [*center, 0.0], **more}}


def hinge(kind, bodies, at, **more):
    axis = {} if kind == "spherical" else {"axis": [0, 0, 2]}
    return {"kind": kind, "bodies": bodies, "origin": [*at, 0], **axis, **more}


def vector(found, name):
    return numpy.array([found[f"{name}_{i}"] for i in "xyz"])


def turned(found, body, arm):
    """A vector of the reference configuration turned with a body."""
    w = vector(found, body + "_rotation")
    angle = numpy.linalg.norm(w)
    if angle == 0.0:
        return numpy.array(arm, float)
    e = w / angle
    return (numpy.cos(angle) * numpy.array(arm) + numpy.sin(angle) * numpy.cross(e, arm) +
            (1 - numpy.cos(angle)) * numpy.dot(e, arm) * e)
