# SPDX-License-Identifier: BSD-3-Clause
"""The table in time that a run leaves, NAME.history.csv, and two scenes to look at it."""
import csv
import json
import pathlib

import numpy

import scenes

TIGHT = {"newton": {"tolerance": 1e-13}, "linear_solver": {"method": "direct"}}

COLUMN = {
    "mesh": {"generate": {"kind": "blocks", "lower_divisions": [2, 2, 2], "upper_divisions": [3, 3, 2]}},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 4.0, "poisson": 0.2}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "stiff"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "head": {"set": "upper_top", "fix": ["x", "y"], "z": -0.1}},
    "contact": {"press": {"primary": "upper_bottom", "secondary": "lower_top"}},
    "time": {"steps": 3}, **TIGHT,
}
# Pressed, then drawn along; a traction and a body force beside; two entries share an edge.
SLIDE = scenes.merged(COLUMN, {
    "curves": {"down": [[0, 0], [0.5, 1], [2, 1]], "along": [[0, 0], [0.5, 0], [1, 1]]},
    "displacements": {"head": None,
                      "down": {"set": "upper_top", "fix": ["y"], "z": -0.05, "curve": "down"},
                      "drawn": {"set": "upper_top", "x": 0.1, "curve": "along"},
                      "side": {"set": "upper_y0", "fix": ["y"]}},
    "contact": {"press": {"friction": 0.2}},
    "loads": {"wind": {"traction": [0.002, 0.0, -0.001], "side_set": "upper_x0"},
              "weight": {"body_force": [0, 0, -0.01], "block": "upper"}},
    "time": {"steps": 6}})


def path_of(result):
    """Of a run that scenes.run has made."""
    return next((pathlib.Path(result.folder) / "results").glob("*.history.csv"))


def read(path):
    """{column: values over the rows}, in the order of the file."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    assert all(len(row) == len(names) for row in rows), path
    return dict(zip(names, numpy.array(rows, float).reshape(-1, len(names)).T))


def columns(path):
    """What the columns are, from the file beside the table."""
    return json.loads(pathlib.Path(path).with_suffix(".json").read_text(encoding="utf-8"))


def vector(table, name):
    """(rows, 3)"""
    return numpy.stack([table[f"{name}_{axis}"] for axis in "xyz"], axis=1)
