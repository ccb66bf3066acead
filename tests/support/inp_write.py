# SPDX-License-Identifier: BSD-3-Clause
"""Writes meshes as Abaqus and CalculiX have them.

A mesh is an exodus_edit.ExodusMesh; blocks become element sets, side sets surfaces, node sets node sets.
"""
from msh_write import SIDES, in_order

# Abaqus' manual, "Solid elements": edges whose middles come next, and the corners of S1, S2, ...
HEX_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
TET_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
CELLS = {"HEX8": ("C3D8", 8, []), "HEX20": ("C3D20", 8, HEX_EDGES), "TETRA4": ("C3D4", 4, []),
         "TETRA10": ("C3D10", 4, TET_EDGES), "WEDGE6": ("C3D6", 6, [])}
FACES = {8: [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)],
         4: [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)],
         6: [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)]}


def face(corners, side):
    """Number of the face with the corners of this side of Exodus II."""
    wanted = set(SIDES[corners][side])
    return 1 + next(i for i, f in enumerate(FACES[corners]) if set(f) == wanted)


def listed(numbers):
    return "".join(",\n".join(", ".join(map(str, numbers[i:i + 10])) for i in range(0, len(numbers), 10))) + "\n"


def text(mesh):
    out = "*NODE\n" + "".join(f"{n}, {x!r}, {y!r}, {z!r}\n" for n, (x, y, z) in enumerate(mesh.x.tolist(), 1))
    number, kinds = 1, []
    for block in mesh.blocks:
        kind, corners, middles = CELLS[block.kind]
        out += f"*ELEMENT, TYPE={kind}, ELSET={block.name}\n"
        for nodes in block.nodes:
            out += listed([number] + [n + 1 for n in in_order(corners, middles, nodes, mesh.x)])
            kinds.append(corners)
            number += 1
    for name, nodes in mesh.node_sets.items():
        out += f"*NSET, NSET={name}\n" + listed([n + 1 for n in nodes])
    for name, (cells, sides) in mesh.side_sets.items():
        out += f"*SURFACE, NAME={name}\n" + "".join(f"{e + 1}, S{face(kinds[e], s)}\n" for e, s in zip(cells, sides))
    return out
