# SPDX-License-Identifier: BSD-3-Clause
"""A stiff block with sharp edges pressed into a larger soft one."""


def deck(lower, upper, depth=0.1, steps=5):
    """lower, upper: cells along an edge of each. Elements and linear solves take nearly all of the time."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": [1] * 3, "lower_divisions": [round(lower)] * 3,
                              "upper_size": [0.6] * 3, "upper_divisions": [round(upper)] * 3}},
        "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 4.0, "poisson": 0.3}},
        "bodies": {"lower": {"blocks": ["lower"], "material": "soft"},
                   "upper": {"blocks": ["upper"], "material": "stiff"}},
        "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "head": {"set": "upper_top", "fix": ["x", "y"], "z": -depth}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "enforcement": "penalty",
                             "penalty_factor": 10}},
        "newton": {"displacement_tolerance": 1e-3},
        "time": {"steps": steps},
    }
