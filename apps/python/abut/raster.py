# SPDX-License-Identifier: BSD-3-Clause
"""Which face of a surface is seen at each pixel, without a display: numpy alone.

Faces are sampled more finely than the pixels, and the sample nearest to the viewer wins each pixel. Unlike faces sorted
by their distance this is right for any sizes and any order, and it carries the place within the face along.
"""
from dataclasses import dataclass

import numpy as np

SAMPLES_PER_PIXEL = 1.5  # along an edge: no pixel of a face is left out
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


def look(corners, bulges, frame, cull=True):
    """What is seen of faces with projected corners (F, 4, 3). Returns Seen.

    bulges (F, 4, 3): how far the middles of the edges 01, 12, 23, 30 are from the straight; None: all are straight.
    cull: leave out faces that turn their back to the viewer.
    """
    pixels = np.array(corners, float)
    pixels[..., 0] = (pixels[..., 0] - frame.left) / frame.unit
    pixels[..., 1] = (pixels[..., 1] - frame.bottom) / frame.unit
    scale = np.array([1 / frame.unit, 1 / frame.unit, 1.0])
    count = frame.width * frame.height
    seen = Seen(np.full(count, -1, np.int32), np.zeros(count, np.float32), np.zeros(count, np.float32),
                np.full(count, -np.inf))
    faces = np.flatnonzero(_may_be_seen(pixels, frame, cull))
    samples = _sample_counts(pixels[faces])
    kinds, kind = np.unique(samples, axis=0, return_inverse=True)
    for i, (m, n) in enumerate(kinds):
        group = faces[kind == i]
        for part in np.array_split(group, -(-len(group) * m * n // CHUNK)):
            _put(seen, part, pixels[part], None if bulges is None else bulges[part] * scale, m, n, frame)
    shape = frame.height, frame.width
    return Seen(*(a.reshape(shape) for a in (seen.face, seen.u, seen.v, seen.depth)))


def _may_be_seen(pixels, frame, cull):
    """Inside of the frame, and turned to the viewer."""
    low, high = pixels[..., :2].min(axis=1), pixels[..., :2].max(axis=1)
    inside = (high[:, 0] >= 0) & (low[:, 0] < frame.width) & (high[:, 1] >= 0) & (low[:, 1] < frame.height)
    if not cull:
        return inside
    a, b = pixels[:, 2] - pixels[:, 0], pixels[:, 3] - pixels[:, 1]
    return inside & (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] > 0)


def _sample_counts(pixels):
    """(F, 2) samples along u and v, of few different numbers."""
    def longest(first, second):
        return np.maximum(*(np.linalg.norm(pixels[:, b, :2] - pixels[:, a, :2], axis=1) for a, b in (first, second)))

    lengths = np.stack([longest((0, 1), (3, 2)), longest((0, 3), (1, 2))], axis=1)
    needed = np.maximum(SAMPLES_PER_PIXEL * lengths, 1.0)
    return np.ceil(2 ** (np.ceil(2 * np.log2(needed)) / 2)).astype(int)


def _put(seen, faces, pixels, bulges, m, n, frame):
    """Puts m x n samples of each of the faces where they are nearer than what is there."""
    u, v = ((np.arange(k) + 0.5) / k for k in (m, n))
    u, v = (a.ravel() for a in np.meshgrid(u, v, indexing="ij"))
    shape = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])
    x = np.einsum("as,fad->dfs", shape, pixels)
    if bulges is not None:
        bubble = 4 * np.stack([u * (1 - u) * (1 - v), u * v * (1 - v), u * (1 - u) * v, (1 - u) * v * (1 - v)])
        x += np.einsum("as,fad->dfs", bubble, bulges)
    x = x.reshape(3, -1)
    column, row = np.floor(x[0]).astype(np.int64), np.floor(x[1]).astype(np.int64)
    kept = np.flatnonzero((column >= 0) & (column < frame.width) & (row >= 0) & (row < frame.height))
    place = row[kept] * frame.width + column[kept]
    nearer = x[2][kept] > seen.depth[place]
    kept, place = kept[nearer], place[nearer]
    order = np.argsort(x[2][kept], kind="stable")  # of several in one pixel the last, the nearest, stays
    kept, place = kept[order], place[order]
    seen.depth[place] = x[2][kept]
    seen.face[place] = faces[kept // len(u)]
    seen.u[place], seen.v[place] = u[kept % len(u)], v[kept % len(u)]


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
