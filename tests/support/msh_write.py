# SPDX-License-Identifier: BSD-3-Clause
"""Writes meshes in the four flavours of Gmsh's MSH format: 2.2 and 4.1, ASCII and binary.

A mesh is an exodus_edit.ExodusMesh; blocks become physical volumes, side sets physical surfaces, node sets that
have no side set of their name physical points.
"""
import struct

import numpy as np

FLAVOURS = [("2.2", False), ("2.2", True), ("4.1", False), ("4.1", True)]

# Gmsh's reference manual, "Node ordering": pairs of corners whose middle comes next; then faces, then the cell.
HEX_EDGES = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]
HEX_FACES = [(0, 3, 2, 1), (0, 1, 5, 4), (0, 4, 7, 3), (1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 6, 7)]
TET_EDGES = [(0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3)]
CELLS = {"HEX8": (5, 8, []), "HEX20": (17, 8, HEX_EDGES),
         "HEX27": (12, 8, HEX_EDGES + HEX_FACES + [tuple(range(8))]),
         "TETRA4": (4, 4, []), "TETRA10": (11, 4, TET_EDGES), "WEDGE6": (6, 6, [])}
FACES = {3: 2, 4: 3, 6: 9, 8: 16, 9: 10}  # Gmsh's type by the number of nodes; corners come first in both
# Corners of the sides as Exodus II numbers them.
SIDES = {8: [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)],
         4: [(0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)],
         6: [(0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1), (3, 4, 5)]}


def in_order(corners, middles, nodes, x):
    """Corners of a cell, then the middles of these groups of them, each found by its place. Cells are straight."""
    order = list(nodes[:corners])
    for middle in middles:
        center = x[nodes[list(middle)]].mean(axis=0)
        order.append(nodes[np.argmin(np.linalg.norm(x[nodes] - center, axis=1))])
    assert len(set(order)) == len(nodes), order
    return order


def side_nodes(mesh, element, side):
    """Nodes of a side: its corners, then whichever nodes of the cell lie in its plane, in any order."""
    for block in mesh.blocks:
        if element < len(block.nodes):
            break
        element -= len(block.nodes)
    nodes = block.nodes[element]
    corners = [nodes[i] for i in SIDES[CELLS[block.kind][1]][side]]
    a, b, c = mesh.x[corners[:3]]
    normal = np.cross(b - a, c - a)
    flat = np.abs((mesh.x[nodes] - a) @ normal) < 1e-9 * np.linalg.norm(normal)
    return corners + [n for n in nodes[flat] if n not in corners]


def elements(mesh):
    """(dimension, tag of group and entity, name of group, Gmsh's type, [nodes]) of each group."""
    for tag, block in enumerate(mesh.blocks, 1):
        yield 3, tag, block.name, CELLS[block.kind][0], \
            [in_order(*CELLS[block.kind][1:], n, mesh.x) for n in block.nodes]
    for tag, (name, (cells, sides)) in enumerate(mesh.side_sets.items(), 1):
        lists = [side_nodes(mesh, e, s) for e, s in zip(cells, sides)]
        for width in sorted({len(nodes) for nodes in lists}):
            yield 2, tag, name, FACES[width], [nodes for nodes in lists if len(nodes) == width]
    for tag, (name, nodes) in enumerate(mesh.node_sets.items(), 1):
        if name not in mesh.side_sets:
            yield 0, tag, name, 15, [[n] for n in nodes]


class Writer:
    """Bytes of a file: words in lines, or numbers; i and q are 4 and 8 byte integers, d is a float."""

    def __init__(self, binary):
        self.binary, self.data = binary, b""

    def line(self, *words):
        self.data += " ".join(map(str, words)).encode() + b"\n"

    def put(self, kinds, *values):
        if self.binary:
            self.data += struct.pack("<" + kinds, *values)
        else:
            self.line(*(repr(float(v)) if k == "d" else int(v) for k, v in zip(kinds, values)))

    def end(self, name):
        self.data += (b"\n" if self.binary else b"") + b"$End" + name.encode() + b"\n"


def write_2(out, mesh, groups):
    out.line("$Nodes")
    out.line(len(mesh.x))
    for number, x in enumerate(mesh.x, 1):
        out.put("iddd", number, *x)
    out.end("Nodes")
    out.line("$Elements")
    out.line(sum(len(lists) for *_, lists in groups))
    number = 0
    for _, tag, _, kind, lists in groups:
        if out.binary:
            out.put("iii", kind, len(lists), 2)
        for nodes in lists:
            number += 1
            head = [number] if out.binary else [number, kind, 2]
            values = [*head, tag, 100 + tag, *(n + 1 for n in nodes)]
            out.put("i" * len(values), *values)
    out.end("Elements")


def write_4(out, mesh, groups):
    out.line("$Entities")
    entities = sorted({(dim, tag) for dim, tag, *_ in groups})
    out.put("qqqq", *(sum(dim == d for d, _ in entities) for dim in range(4)))
    for dim, tag in entities:
        if dim == 0:
            out.put("idddqi", 100 + tag, 0, 0, 0, 1, tag)
        else:
            out.put("iddddddqiqi", 100 + tag, 0, 0, 0, 1, 1, 1, 1, tag, 1, -(100 + tag))
    out.end("Entities")
    out.line("$Nodes")
    out.put("qqqq", 1, len(mesh.x), 1, len(mesh.x))
    out.put("iiiq", 3, 101, 0, len(mesh.x))
    for number in range(1, len(mesh.x) + 1):
        out.put("q", number)
    for x in mesh.x:
        out.put("ddd", *x)
    out.end("Nodes")
    out.line("$Elements")
    count = sum(len(lists) for *_, lists in groups)
    out.put("qqqq", len(groups), count, 1, count)
    number = 0
    for dim, tag, _, kind, lists in groups:
        out.put("iiiq", dim, 100 + tag, kind, len(lists))
        for nodes in lists:
            number += 1
            out.put("q" * (1 + len(nodes)), number, *(n + 1 for n in nodes))
    out.end("Elements")


def write(path, mesh, version, binary):
    groups = list(elements(mesh))
    out = Writer(binary)
    out.line("$MeshFormat")
    out.line(version, int(binary), 8)
    if binary:
        out.put("i", 1)
    out.end("MeshFormat")
    names = sorted({(dim, tag, name) for dim, tag, name, *_ in groups})
    out.line("$PhysicalNames")
    out.line(len(names))
    for dim, tag, name in names:
        out.line(dim, tag, f'"{name}"')
    out.line("$EndPhysicalNames")
    (write_2 if version == "2.2" else write_4)(out, mesh, groups)
    path.write_bytes(out.data)
    return path
