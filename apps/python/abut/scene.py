# SPDX-License-Identifier: BSD-3-Clause
"""The deformed skin of a model at one step, with what contact does on it."""
from dataclasses import dataclass

import numpy as np

from . import skin as skins
from .raster import View

THIN = 0.25  # of the extent across: a model that is a slice


@dataclass
class Scene:
    """Nodal arrays are (nodes,) or (nodes, 3), of the current configuration."""
    skin: skins.Skin
    x: np.ndarray
    displacement: np.ndarray
    pressure: np.ndarray
    traction: np.ndarray
    status: np.ndarray
    gap: np.ndarray
    pressed: np.ndarray    # (F,) faces that contact presses on
    von_mises: np.ndarray  # (F,) of the element behind each face; zeros where the file has none
    blocks: list
    t: float

    @property
    def corners(self):
        return self.x[self.skin.corners]

    @property
    def faces_of_contact(self):
        """(F,) those that are pressed or may be: contact looks at all of their corners."""
        looked_at = (self.status > 0) | (self.gap != 0)
        return self.pressed | looked_at[self.skin.corners].all(axis=1)

    @property
    def bulges(self):
        """How far middles of edges are from the straight (F, 4, 3); None where all edges are straight."""
        middles = self.skin.middles
        if not len(middles) or middles.max() < 0:
            return None
        straight = (self.corners + np.roll(self.corners, -1, axis=1)) / 2
        return np.where(middles[..., None] >= 0, self.x[middles] - straight, 0.0)


def read(results, step=-1):
    """The scene of a step of Results; of a file without steps, the mesh."""
    count = len(results.node_map)

    def nodal(name):
        return results.nodal(name, step) if results.has_nodal(name) else np.zeros(count)

    def vector(name):
        return np.stack([nodal(f"{name}_{axis}") for axis in "xyz"], axis=1)

    skin = skins.outer_faces(results)
    displacement = vector("displacement")
    x = results.coordinates + displacement
    traction, status = vector("contact_traction"), nodal("contact_status")
    steps = results.times
    return Scene(skin, x, displacement, nodal("contact_pressure"), traction, status, nodal("contact_gap"),
                 skins.pressed(skin, x, traction, status), _von_mises(results, skin, step), results.blocks,
                 float(steps[step]) if len(steps) else 0.0)


def _von_mises(results, skin, step):
    values = np.zeros(len(skin))
    if "von_mises" not in results.names("elem_var") or not len(results.times):
        return values
    for index, name in enumerate(results.blocks):
        own = skin.block == index
        if own.any():
            values[own] = results.element("von_mises", name, step)[skin.element[own]]
    return values


def view_of(x):
    """An oblique view from the right, front and above; of a slice, nearly along its thin direction."""
    extent = np.ptp(x, axis=0)
    thin = int(np.argmin(extent))
    if extent[thin] > THIN * np.sort(extent)[1]:
        return View((0.7, -1.0, 0.55), (0, 0, 1))
    upward = np.eye(3)[1 if thin == 2 else 2]
    toward = np.full(3, 0.22)
    toward[thin] = 1.0
    return View(toward * np.where(np.arange(3) == 1, -1, 1), upward)


def view_along(normal, x):
    """A look at a surface with this outward mean normal (3,), nearly along an axis being along it."""
    axis = int(np.argmax(np.abs(normal)))
    if abs(normal[axis]) > 0.99 * np.linalg.norm(normal):
        normal = np.eye(3)[axis] * np.sign(normal[axis])
    upward = np.eye(3)[1 if axis == 2 else 2]
    view = View(normal, upward)
    wide = np.ptp(view.project(x).reshape(-1, 3), axis=0)
    if wide[1] > 1.5 * wide[0]:  # long surfaces lie
        view = View(normal, view.right)
    return view
