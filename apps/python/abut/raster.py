# SPDX-License-Identifier: BSD-3-Clause
"""Which face of a surface is seen at each pixel, without a display: numpy alone.

Faces are sampled more finely than the pixels, and the sample nearest to the viewer wins each pixel. Unlike faces sorted
by their distance this is right for any sizes and any order, and it carries the place within the face along.
"""
from dataclasses import dataclass

import numpy as np

SAMPLES_PER_PIXEL = 1.5  # along an edge: no pixel of a face is left out
MOST_SAMPLES = 256       # along an edge of a piece
CHUNK = 1_000_000        # samples at a time


class View:
    """A parallel projection. `toward` points from the model to the viewer; units of the picture are those of x."""

    def __init__(self, toward, upward):
        self.toward = np.asarray(toward, float) / np.linalg.norm(toward)
        right = np.cross(upward, self.toward)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.toward, self.right)

    def project(self, x):
        """(..., 3): right, up, nearness to the viewer."""
        return np.asarray(x) @ np.stack([self.right, self.up, self.toward], axis=1)


@dataclass
class Frame:
    """The rectangle of the picture: left, bottom, units for each pixel, and its size in pixels."""
    left: float
    bottom: float
    unit: float
    width: int
    height: int

    @classmethod
    def around(cls, points, width, height, margin=0.04):
        """Holds the projected points (..., 3) in the middle."""
        low, high = points.reshape(-1, 3).min(axis=0)[:2], points.reshape(-1, 3).max(axis=0)[:2]
        unit = max(np.max((high - low) / (np.array([width, height]) * (1 - 2 * margin))), 1e-300)
        left, bottom = (low + high) / 2 - unit * np.array([width, height]) / 2
        return cls(left, bottom, unit, width, height)

    @property
    def extent(self):
        """left, right, bottom, top in units."""
        return (self.left, self.left + self.unit * self.width, self.bottom, self.bottom + self.unit * self.height)

    def finer(self, factor):
        return Frame(self.left, self.bottom, self.unit / factor, self.width * factor, self.height * factor)


@dataclass
class Seen:
    """What is seen at each pixel, rows from the bottom up."""
    face: np.ndarray   # (height, width), -1: nothing
    u: np.ndarray      # place within the face, 0 to 1 from corner 0 to corner 1
    v: np.ndarray      # and from corner 0 to corner 3
    depth: np.ndarray  # nearness to the viewer


@dataclass
class Pieces:
    """Squares of the faces' (u, v) with corners and bulges of their own, in pixels."""
    face: np.ndarray     # (P,)
    low: np.ndarray      # (P, 2) u and v of corner 0
    size: float          # of u and v
    corners: np.ndarray  # (P, 4, 3)
    bulges: object       # (P, 4, 3), None: straight

    def part(self, chosen):
        return Pieces(self.face[chosen], self.low[chosen], self.size, self.corners[chosen],
                      None if self.bulges is None else self.bulges[chosen])


def look(corners, bulges, frame, cull=True):
    """What is seen of faces with projected corners (F, 4, 3). Returns Seen.

    bulges (F, 4, 3): how far the middles of the edges 01, 12, 23, 30 are from the straight; None: all are straight.
    cull: leave out faces that turn their back to the viewer.
    """
    scale = np.array([1 / frame.unit, 1 / frame.unit, 1.0])
    pixels = (np.asarray(corners, float) - [frame.left, frame.bottom, 0.0]) * scale
    pieces = Pieces(np.arange(len(pixels)), np.zeros((len(pixels), 2)), 1.0, pixels,
                    None if bulges is None else np.asarray(bulges) * scale)
    if cull:
        pieces = pieces.part(_faces_viewer(pixels))
    count = frame.width * frame.height
    seen = Seen(np.full(count, -1, np.int32), np.zeros(count, np.float32), np.zeros(count, np.float32),
                np.full(count, -np.inf))
    while len(pieces.face):
        pieces = pieces.part(_in_frame(pieces, frame))
        samples = _sample_counts(pieces.corners)
        large = samples.max(axis=1, initial=0) > MOST_SAMPLES
        _put_all(seen, pieces.part(~large), samples[~large], frame)
        pieces = _quarters(pieces.part(large))  # most of a face may be outside of the frame
    shape = frame.height, frame.width
    return Seen(*(a.reshape(shape) for a in (seen.face, seen.u, seen.v, seen.depth)))


def _faces_viewer(pixels):
    a, b = pixels[:, 2] - pixels[:, 0], pixels[:, 3] - pixels[:, 1]
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] > 0


def _in_frame(pieces, frame):
    flat = pieces.corners[..., :2]
    slack = 0.0 if pieces.bulges is None else np.abs(pieces.bulges).max(axis=(1, 2), initial=0.0)[:, None]
    low, high = flat.min(axis=1) - slack, flat.max(axis=1) + slack
    return ((high >= 0) & (low < [frame.width, frame.height])).all(axis=1)


def _sample_counts(pixels):
    """(P, 2) samples along u and v, of few different numbers."""
    def longest(first, second):
        return np.maximum(*(np.linalg.norm(pixels[:, b, :2] - pixels[:, a, :2], axis=1) for a, b in (first, second)))

    lengths = np.stack([longest((0, 1), (3, 2)), longest((0, 3), (1, 2))], axis=1)
    needed = np.maximum(SAMPLES_PER_PIXEL * lengths, 1.0)
    return np.ceil(2 ** (np.ceil(2 * np.log2(needed)) / 2)).astype(np.int64)


def _place(u, v, pieces):
    """(3, P, S) points of the pieces at u, v (S,) within them."""
    shape = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])
    x = np.einsum("as,pad->dps", shape, pieces.corners)
    if pieces.bulges is not None:
        bubble = 4 * np.stack([u * (1 - u) * (1 - v), u * v * (1 - v), u * (1 - u) * v, (1 - u) * v * (1 - v)])
        x += np.einsum("as,pad->dps", bubble, pieces.bulges)
    return x


def _quarters(pieces):
    parts = []
    for low in ((0, 0), (0.5, 0), (0.5, 0.5), (0, 0.5)):
        u, v = np.array([0, 1, 1, 0]) / 2 + low[0], np.array([0, 0, 1, 1]) / 2 + low[1]
        corners = _place(u, v, pieces).transpose(1, 2, 0)
        bulges = None
        if pieces.bulges is not None:
            middle = _place((u + np.roll(u, -1)) / 2, (v + np.roll(v, -1)) / 2, pieces).transpose(1, 2, 0)
            bulges = middle - (corners + np.roll(corners, -1, axis=1)) / 2
        parts.append((pieces.face, pieces.low + pieces.size * np.array(low), corners, bulges))
    face, low, corners, bulges = zip(*parts)
    return Pieces(np.concatenate(face), np.concatenate(low), pieces.size / 2, np.concatenate(corners),
                  None if pieces.bulges is None else np.concatenate(bulges))


def _put_all(seen, pieces, samples, frame):
    """Puts the samples (P, 2) of pieces, those of one number together."""
    kinds, kind = np.unique(samples, axis=0, return_inverse=True)
    for i, (m, n) in enumerate(kinds):
        group = np.flatnonzero(kind == i)
        for part in np.array_split(group, -(-len(group) * m * n // CHUNK)):
            _put(seen, pieces.part(part), m, n, frame)


def _put(seen, pieces, m, n, frame):
    """Puts m x n samples of each piece where they are nearer than what is there."""
    u, v = ((np.arange(k) + 0.5) / k for k in (m, n))
    u, v = (a.ravel() for a in np.meshgrid(u, v, indexing="ij"))
    x = _place(u, v, pieces).reshape(3, -1)
    column, row = np.floor(x[0]).astype(np.int64), np.floor(x[1]).astype(np.int64)
    kept = np.flatnonzero((column >= 0) & (column < frame.width) & (row >= 0) & (row < frame.height))
    place = row[kept] * frame.width + column[kept]
    nearer = x[2][kept] > seen.depth[place]
    kept, place = kept[nearer], place[nearer]
    order = np.argsort(x[2][kept], kind="stable")  # of several in one pixel the last, the nearest, stays
    kept, place = kept[order], place[order]
    piece, sample = kept // len(u), kept % len(u)
    seen.depth[place] = x[2][kept]
    seen.face[place] = pieces.face[piece]
    seen.u[place] = pieces.low[piece, 0] + pieces.size * u[sample]
    seen.v[place] = pieces.low[piece, 1] + pieces.size * v[sample]


def between_corners(seen, values):
    """Values (F, 4) of the corners at each pixel; nan where nothing is seen."""
    a = values[np.maximum(seen.face, 0)]
    u, v = seen.u, seen.v
    result = (1 - u) * (1 - v) * a[..., 0] + u * (1 - v) * a[..., 1] + u * v * a[..., 2] + (1 - u) * v * a[..., 3]
    return np.where(seen.face >= 0, result, np.nan)


def nearest_corner(seen, values):
    """Values (F, 4) of the nearest corner at each pixel; nan where nothing is seen."""
    corner = np.where(seen.v < 0.5, np.where(seen.u < 0.5, 0, 1), np.where(seen.u < 0.5, 3, 2))
    result = values[np.maximum(seen.face, 0), corner]
    return np.where(seen.face >= 0, result, np.nan)


def pixels_to_edge(seen, corners, unit):
    """(height, width) pixels from the nearest edge of the face that is seen, and the face's own size in pixels."""
    def edge(a, b):
        return (np.linalg.norm(corners[:, b, :2] - corners[:, a, :2], axis=1) / unit)[np.maximum(seen.face, 0)]

    along_u = (1 - seen.v) * edge(0, 1) + seen.v * edge(3, 2)
    along_v = (1 - seen.u) * edge(0, 3) + seen.u * edge(1, 2)
    nearest = np.minimum(np.minimum(seen.u, 1 - seen.u) * along_u, np.minimum(seen.v, 1 - seen.v) * along_v)
    return nearest, np.minimum(along_u, along_v)
