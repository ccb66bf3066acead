# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in which contact and search take much of the time: thin or rigid bodies, many points.

SCENES[name](size) is a deck; size multiplies the cells along an edge. The decks keep to keys that have meant the same
for long, so that an older program reads them too.
"""

import block_on_block

ELASTIC = {"young": 1.0, "poisson": 0.3}
AUGMENTED = {"enforcement": "augmented_lagrangian"}
PRESS, SLIDE = 0.01, (0.06, 0.025)


def blocks(cells, element="hex8"):
    """A thin plate on a wider one, whose meshes do not fit."""
    return {"generate": {"kind": "blocks", "element": element,
                         "lower_size": [1.4, 1.4, 0.1], "lower_divisions": [round(1.2 * cells)] * 2 + [1],
                         "upper_size": [1, 1, 0.1], "upper_divisions": [round(cells)] * 2 + [1]}}


def curves(steps):
    """Pressed in the first step, led across in the others."""
    return {"press": [[0, 0], [1 / steps, 1]], "slide": [[1 / steps, 0], [1, 1]]}


def elastic_plates(cells, element="hex8", steps=6, **contact):
    """The upper plate is moved at its top, the lower one is held at its foot."""
    return {
        "mesh": blocks(cells, element),
        "materials": {"elastic": ELASTIC},
        "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("lower", "upper")},
        "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "press": {"set": "upper_top", "z": -PRESS, "curve": "press"},
                          "lead": {"set": "upper_top", "x": SLIDE[0], "y": SLIDE[1], "curve": "slide"}},
        "curves": curves(steps),
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
        "time": {"steps": steps},
    }


def rigid_plates(cells, steps=48, **contact):
    """The same of rigid bodies, pressed by a force: hardly any linear solve."""
    upper = {"displacement": [*SLIDE, 0], "curve": "slide", "free": ["z"], "force": [0, 0, -PRESS],
             "load_curve": "press"}
    return {
        "mesh": blocks(cells),
        "bodies": {"lower": {"blocks": ["lower"], "rigid": {}}, "upper": {"blocks": ["upper"], "rigid": upper}},
        "curves": curves(steps),
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "penalty": 10, **contact}},
        "time": {"steps": steps},
    }


def ball(facets, steps=8, **contact):
    """A paraboloid, fine all over its face and coarse above, pressed on a rigid plate."""
    return {
        "mesh": {"generate": {"kind": "paraboloid", "radius": 1, "core": 0.3, "size": 0.3, "facets": round(facets),
                              "growth": 2, "max_size": 0.3, "depth": 0}},
        "materials": {"elastic": ELASTIC},
        "bodies": {"ball": {"blocks": ["paraboloid"], "material": "elastic"}, "plate": {"blocks": ["plate"], "rigid": {}}},
        "displacements": {"symmetry x": {"set": "x0", "fix": ["x"]}, "symmetry y": {"set": "y0", "fix": ["y"]},
                          "top": {"set": "top", "fix": ["x", "y"]}, "press": {"set": "top", "z": -0.03}},
        "contact": {"pair": {"primary": "contact", "secondary": "plate_top", **contact}},
        "time": {"steps": steps},
    }


SCENES = {
    "facet_friction": lambda size: elastic_plates(24 * size, friction=0.3, points=6),
    "ray_friction": lambda size: elastic_plates(24 * size, formulation="sliding_elastic", friction=0.3, points=6),
    "quadratic_friction": lambda size: elastic_plates(10 * size, element="hex20", friction=0.3, points=6),
    "dual_friction": lambda size: elastic_plates(16 * size, friction=0.3, points=6, multipliers="dual", **AUGMENTED),
    "dual_ball": lambda size: ball(24 * size, points=6, multipliers="dual", **AUGMENTED),
    "smoothed_ball": lambda size: ball(24 * size, points=6, multipliers="smoothed", **AUGMENTED),
    "punch": lambda size: block_on_block.deck(16 * size, 13 * size),
    "rigid_facets": lambda size: rigid_plates(64 * size),
    "rigid_nodes": lambda size: rigid_plates(48 * size, formulation="node_on_facet"),
}
