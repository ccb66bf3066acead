# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a scene as PNG images, with legends and colour bars."""
import io

import matplotlib
import numpy as np
from matplotlib import colors
from matplotlib.figure import Figure

from .. import raster, scene as scenes, skin as skins

DPI = 120
FINER = 2           # pixels of a picture are means of so many squared
TINTS = ((0.80, 0.82, 0.85), (0.87, 0.83, 0.76), (0.77, 0.84, 0.79), (0.86, 0.79, 0.81))
STATUS = ("open", "slip", "stick")
STATUS_COLORS = ("#d5d8dc", "#f28e2b", "#4e79a7")
LIGHT = np.array([-0.35, 0.5, 0.8]) / np.linalg.norm([-0.35, 0.5, 0.8])  # right, up, to the viewer
THROUGH = 0.6       # of the colour of contact that lies behind
MOST_SURFACES = 4
SMALL = 0.15        # of the model: contact that wants a picture of its own
GOOD_PART = 0.2     # of the largest pressure
NEAR_MARGIN = 0.3   # around it
COARSE_BEHIND = 0.05  # of the size of a face
CLOSED = 0.35       # mean normals shorter than that are of surfaces that turn around
HEAD, FOOT = 40, 84    # pixels above and below the surfaces
NO_PRESSURE = 1e-3  # of the largest


def png(figure):
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=DPI)
    return buffer.getvalue()


def color_map(name):
    return matplotlib.colormaps[name]


def deformed(scene, by="pressure", near=False):
    """The deformed model; by: pressure of contact, seen through the bodies, or von_mises; near: around the contact."""
    width, height = 860, 620
    view = scenes.view_of(scene.corners.reshape(-1, 3))
    points = view.project(scene.corners[_heart(scene)] if near else scene.corners)
    frame = raster.Frame.around(points, width, height, margin=NEAR_MARGIN if near else 0.04)
    image, scale, label = (_by_pressure if by == "pressure" else _by_von_mises)(scene, view, frame.finer(FINER))
    figure = Figure(figsize=((width + 130) / DPI, height / DPI))
    axes = figure.add_axes((0, 0, width / (width + 130), 1))
    axes.imshow(_coarser(image), origin="lower", interpolation="nearest")
    axes.set_axis_off()
    _draw_triad(figure, view, width + 130, height)
    _draw_color_bar(figure, scale, label, ((width + 14) / (width + 130), 0.12, 0.02, 0.76))
    return png(figure)


def contact_is_small(scene):
    """Whether what is pressed can hardly be seen in a picture of the whole."""
    if not scene.pressed.any():
        return False
    size = [np.linalg.norm(np.ptp(x.reshape(-1, 3), axis=0)) for x in (scene.corners[_heart(scene)], scene.corners)]
    return size[0] < SMALL * size[1]


def _heart(scene):
    """(F,) faces that are pressed with a good part of the largest pressure of all."""
    pressure = np.where(scene.pressed, scene.pressure[scene.skin.corners].max(axis=1, initial=0.0), 0.0)
    return pressure >= GOOD_PART * pressure.max()


def surfaces_in_contact(scene):
    """[(name of the block, its faces of contact)], the one of most faces that are pressed first."""
    blocks, counts = np.unique(scene.skin.block[scene.pressed], return_counts=True)
    blocks = blocks[np.argsort(-counts, kind="stable")]
    return [(scene.blocks[b], np.flatnonzero(scene.faces_of_contact & (scene.skin.block == b)))
            for b in blocks[:MOST_SURFACES]]


def contact_surface(scene, faces):
    """Pressure and status of the part of a block's faces that is in contact, from outside along its mean normal.

    Returns the image and whether the surface turns around, so that it is seen obliquely.
    """
    pressed = faces[scene.pressed[faces]]
    outward = skins.normals(scene.corners[pressed])
    mean = outward.sum(axis=0) / np.linalg.norm(outward, axis=1).sum()
    turns = np.linalg.norm(mean) < CLOSED
    view = scenes.view_of(scene.x[scene.skin.corners[pressed]].reshape(-1, 3)) if turns else \
        scenes.view_along(mean, scene.x[scene.skin.corners[pressed]])
    points = view.project(scene.corners[pressed])
    wide, high = np.ptp(points.reshape(-1, 3), axis=0)[:2]
    width = 420
    height = int(np.clip(width * high / max(wide, 1e-300), 170, 420))
    frame = raster.Frame.around(points, width, height, margin=0.09)
    fine = frame.finer(FINER)
    shown = faces if not turns else pressed
    corners, bulges = view.project(scene.corners[shown]), _turned(scene, view, shown)
    seen = raster.look(corners, bulges, fine, cull=not turns)
    figure = Figure(figsize=((2 * width + 350) / DPI, (height + FOOT + HEAD) / DPI))
    pressure = raster.between_corners(seen, scene.pressure[scene.skin.corners[shown]])
    kind = raster.nearest_corner(seen, scene.status[scene.skin.corners[shown]])
    scale = _scale(scene.pressure[scene.skin.corners[pressed]])
    images = (_shade(seen, corners, fine, _colored(pressure, scale), mild=True),
              _shade(seen, corners, fine, _status_colored(kind), mild=True))
    lefts = (96, width + 266)
    for image, left, title in zip(images, lefts, ("contact pressure", "status")):
        axes = figure.add_axes((left / (2 * width + 350), FOOT / (height + FOOT + HEAD), width / (2 * width + 350),
                                height / (height + FOOT + HEAD)))
        axes.imshow(_coarser(image), origin="lower", interpolation="nearest", extent=frame.extent, aspect="auto")
        axes.set_title(title, fontsize=9)
        _label_plane(axes, view, turns, first=left == lefts[0])
    _draw_color_bar(figure, scale, "pressure", ((width + 108) / (2 * width + 350), FOOT / (height + FOOT + HEAD), 0.014,
                                                height / (height + FOOT + HEAD)))
    handles = [matplotlib.patches.Patch(facecolor=c, edgecolor="#666", label=n) for c, n in zip(STATUS_COLORS, STATUS)]
    figure.legend(handles=handles, loc="lower right", ncol=3, fontsize=8, frameon=False)
    return png(figure), turns


def _label_plane(axes, view, turns, first):
    """Numbers of the axes, named where they are axes of the model."""
    if turns:
        axes.set_axis_off()
        return
    axes.tick_params(labelsize=7)
    axes.locator_params(nbins=5)
    for direction, axis, word in ((view.right, axes.xaxis, "to the right"), (view.up, axes.yaxis, "upwards")):
        along = int(np.argmax(np.abs(direction)))
        if abs(direction[along]) < 0.999:
            axis.set_label_text(f"{word} (model units)", fontsize=8)
            axis.set_major_formatter("{x:.4g}")
            continue
        axis.set_major_formatter(lambda value, _, sign=np.sign(direction[along]): f"{sign * value + 0.0:.4g}")
        axis.set_label_text(f"{'xyz'[along]} (model units)", fontsize=8)
    if not first:
        axes.set_ylabel("")


def _by_pressure(scene, view, frame):
    """Bodies in tints, contact in colours; contact that lies behind shows through."""
    corners, bulges = view.project(scene.corners), _turned(scene, view, slice(None))
    seen = raster.look(corners, bulges, frame)
    scale = _scale(scene.pressure[scene.skin.corners])
    tints = np.array(TINTS)[scene.skin.block % len(TINTS)]
    image = tints[np.maximum(seen.face, 0)]
    image = _shade(seen, corners, frame, np.where(seen.face[..., None] >= 0, image, 1.0))
    chosen = np.flatnonzero(scene.pressed)
    if len(chosen):
        behind = COARSE_BEHIND * np.sqrt(np.linalg.norm(skins.normals(scene.corners[chosen]), axis=1))
        moved = corners[chosen] - behind[:, None, None] * [0, 0, 1]  # of two sides the finer one shows
        contact = raster.look(moved, None if bulges is None else bulges[chosen], frame, cull=False)
        pressure = raster.between_corners(contact, scene.pressure[scene.skin.corners[chosen]])
        there = np.nan_to_num(pressure) > NO_PRESSURE * scale.vmax
        size = np.ptp(corners.reshape(-1, 3), axis=0).max()
        in_front = contact.depth + behind[np.maximum(contact.face, 0)] >= seen.depth - 1e-4 * size
        weight = np.where(there, np.where(in_front, 1.0, THROUGH), 0.0)[..., None]
        colored = _shade(contact, corners[chosen], frame, _colored(pressure, scale), mild=True)
        image = (1 - weight) * image + weight * colored
    return image, scale, "contact pressure"


def _by_von_mises(scene, view, frame):
    corners = view.project(scene.corners)
    seen = raster.look(corners, _turned(scene, view, slice(None)), frame)
    scale = _scale(scene.von_mises, "viridis")
    values = np.where(seen.face >= 0, scene.von_mises[np.maximum(seen.face, 0)], np.nan)
    bare = np.array([not scene.von_mises[scene.skin.block == b].any() for b in range(len(scene.blocks))])
    is_bare = (seen.face >= 0) & bare[scene.skin.block[np.maximum(seen.face, 0)]]  # rigid, or not in the results
    image = np.where(is_bare[..., None], TINTS[0], _colored(values, scale))
    return _shade(seen, corners, frame, image, mild=True), scale, "von Mises stress"


def _turned(scene, view, faces):
    """Bulges of the edges in the axes of the view."""
    bulges = scene.bulges
    return None if bulges is None else view.project(bulges[faces])


def _scale(values, name="YlOrRd"):
    largest = float(np.max(values)) if np.size(values) else 0.0
    scale = matplotlib.cm.ScalarMappable(colors.Normalize(0.0, largest if largest > 0 else 1.0), color_map(name))
    scale.vmax = scale.norm.vmax
    return scale


def _colored(values, scale):
    """(height, width, 3); white where there is nothing."""
    image = scale.to_rgba(np.nan_to_num(values))[..., :3]
    return np.where(np.isnan(values)[..., None], 1.0, image)


def _status_colored(kind):
    table = np.array([colors.to_rgb(c) for c in STATUS_COLORS])
    image = table[np.clip(np.nan_to_num(kind), 0, 2).astype(int)]
    return np.where(np.isnan(kind)[..., None], 1.0, image)


def _shade(seen, corners, frame, image, mild=False):
    """Darkens what is turned away from the light and draws the edges of elements; mild keeps colours readable."""
    if not len(corners):
        return image
    normal = skins.normals(corners)
    normal = normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    light = np.abs(normal @ LIGHT)[np.maximum(seen.face, 0)]
    light = 0.9 + 0.1 * light if mild else 0.62 + 0.4 * light
    away, size = raster.pixels_to_edge(seen, corners, frame.unit)
    line = np.clip(1.3 - away / FINER * 1.3, 0, 1) * np.clip((size / FINER - 3) / 9, 0, 1) * 0.45
    shaded = np.clip(image * (light * (1 - line))[..., None], 0, 1)
    return np.where(seen.face[..., None] >= 0, shaded, image)


def _coarser(image):
    height, width, _ = image.shape
    return image.reshape(height // FINER, FINER, width // FINER, FINER, 3).mean(axis=(1, 3))


def _draw_color_bar(figure, scale, label, place):
    bar = figure.colorbar(scale, cax=figure.add_axes(place))
    bar.ax.tick_params(labelsize=8)
    bar.formatter.set_powerlimits((-3, 4))
    bar.set_label(f"{label} (model units)", fontsize=9)


def _draw_triad(figure, view, width, height):
    """The axes of the model in the lower left corner."""
    size = 42
    axes = figure.add_axes((0.008, 0.008, 2.4 * size / width, 2.4 * size / height))
    axes.set_xlim(-1.2, 1.2)
    axes.set_ylim(-1.2, 1.2)
    axes.set_axis_off()
    for name, tip, color in zip("xyz", view.project(np.eye(3)), ("#c0392b", "#1e8449", "#2456a6")):
        if np.hypot(*tip[:2]) < 0.08:
            continue
        axes.annotate("", xy=tip[:2] * 0.8, xytext=(0, 0), arrowprops={"arrowstyle": "->", "color": color, "lw": 1.4})
        axes.text(*(tip[:2] * 1.02), name, color=color, fontsize=9, ha="center", va="center")
