# SPDX-License-Identifier: BSD-3-Clause
"""The outer faces of the elements of a mesh."""
from dataclasses import dataclass

import numpy as np

from .errors import InputError

# Corners of the sides in the order of Exodus, seen from outside against the clock; triangles repeat the last one.
HEX = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7))
TET = ((0, 1, 3, 3), (1, 2, 3, 3), (0, 3, 2, 2), (0, 2, 1, 1))
WEDGE = ((0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1, 1), (3, 4, 5, 5))
# Edges whose middles are the nodes behind the corners.
HEX_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4))
TET_EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
CELLS = {8: (HEX, ()), 20: (HEX, HEX_EDGES), 27: (HEX, HEX_EDGES), 4: (TET, ()), 10: (TET, TET_EDGES), 6: (WEDGE, ())}


@dataclass
class Skin:
    """F faces as quadrilaterals whose edges may be curved; a triangle has its last two corners in one node."""
    corners: np.ndarray  # (F, 4) nodes
    middles: np.ndarray  # (F, 4) nodes in the middles of the edges 01, 12, 23, 30; -1: none
    block: np.ndarray    # (F,) index into the names of the blocks
    element: np.ndarray  # (F,) index within the block

    def part(self, chosen):
        return Skin(self.corners[chosen], self.middles[chosen], self.block[chosen], self.element[chosen])

    def __len__(self):
        return len(self.corners)


def _tables(nodes):
    """Local corners (sides, 4) and middles (sides, 4), -1 where there is none, of cells with so many nodes."""
    if nodes not in CELLS:
        raise InputError(f"elements of {nodes} nodes are not known here")
    sides, edges = CELLS[nodes]
    middle = {frozenset(edge): nodes_before + i for i, edge in enumerate(edges)
              for nodes_before in [8 if sides is HEX else 4]}
    middles = [[middle.get(frozenset((side[k], side[(k + 1) % 4])), -1) for k in range(4)] for side in sides]
    return np.array(sides), np.array(middles)


def outer_faces(results):
    """The faces of all blocks that belong to one element alone."""
    corners, middles, block, element = [np.zeros((0, 4), int)], [np.zeros((0, 4), int)], [], []
    for index, name in enumerate(results.blocks):
        cells = results.connectivity(name)
        if not len(cells):
            continue
        sides, edges = _tables(cells.shape[1])
        corners.append(cells[:, sides].reshape(-1, 4))
        middles.append(np.where(edges >= 0, cells[:, edges], -1).reshape(-1, 4))
        element.append(np.repeat(np.arange(len(cells)), len(sides)))
        block.append(np.full(len(cells) * len(sides), index))
    skin = Skin(np.concatenate(corners), np.concatenate(middles), np.concatenate(block or [np.zeros(0, int)]),
                np.concatenate(element or [np.zeros(0, int)]))
    return skin.part(_alone(skin.corners))


def _alone(corners):
    """Indices of the faces whose set of corners occurs once."""
    if not len(corners):
        return np.zeros(0, int)
    order = corners.astype(np.int64) + 1
    order[order[:, 3] == order[:, 2], 3] = 0  # which node a triangle repeats is chance
    order.sort(axis=1)
    size = order.max() + 1
    high, low = order[:, 0] * size + order[:, 1], order[:, 2] * size + order[:, 3]
    place = np.lexsort((low, high))
    same = (high[place][1:] == high[place][:-1]) & (low[place][1:] == low[place][:-1])
    twice = np.zeros(len(place), bool)
    twice[1:] |= same
    twice[:-1] |= same
    return np.sort(place[~twice])


def normals(x):
    """(F, 3) normals, as long as twice the areas, of faces with corners (F, 4, 3)."""
    return np.cross(x[:, 2] - x[:, 0], x[:, 3] - x[:, 1])


def pressed(skin, x, traction, status):
    """Whether a face (F,) is pressed on: a corner is in contact and traction there points into the body.

    x, traction (nodes, 3), status (nodes,). Walls beside a contact have corners in it too, but no such traction.
    """
    corners = skin.corners
    into = -np.einsum("fad,fd->fa", traction[corners], normals(x[corners]))
    across = np.linalg.norm(traction[corners], axis=2) * np.linalg.norm(normals(x[corners]), axis=1)[:, None]
    touching = status[corners] > 0
    return touching.any(axis=1) & ((into * touching).sum(axis=1) > 0.5 * (across * touching).sum(axis=1))
