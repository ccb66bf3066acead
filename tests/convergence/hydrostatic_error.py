# SPDX-License-Identifier: BSD-3-Clause
"""Two bodies of one material under the displacement (stretch - 1) X: the stress is hydrostatic, so a
frictionless interface of any shape carries the same pressure everywhere.

The outer faces of the box are rollers that move; the state has no shear stress, so they do not disturb it.
"""
import math

import numpy

import scenes

YOUNG, POISSON = 1.0, 0.3
SHEAR = YOUNG / (2 * (1 + POISSON))
LAME = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
THICKNESS = 0.25  # of the slabs, along y


def exact_pressure(stretch, model):
    """Force per current area, as results report it."""
    if model == "linear_elastic":  # the law gives force per reference area
        return (3 * LAME + 2 * SHEAR) * (1 - stretch) / stretch**2
    return -(SHEAR * (stretch**2 - 1) + LAME * 3 * math.log(stretch)) / stretch**3


def scene(shape, fine, coarse, stretch=0.9, model="neo_hookean", element="hex8", upper_primary=True,
          steps=1, **contact):
    """shape: options of the interface mesh; fine cells over the width above, coarse ones below."""
    solid = shape["shape"] == "sphere"
    depth = 1.0 if solid else THICKNESS
    low, high = shape.get("lower_height", 1.0), shape.get("upper_height", 1.0)
    generate = {"kind": "interface", "width": 1, "depth": depth, "element": element,
                "lower_divisions": [coarse, coarse if solid else 1, coarse],
                "upper_divisions": [fine, fine if solid else 1, fine], **shape}
    strain = stretch - 1
    displacements = {"bottom": {"set": "lower_bottom", "z": -strain * low},
                     "top": {"set": "upper_top", "z": strain * high}}
    for body in ("lower", "upper"):
        for axis, length in (("x", 1.0), ("y", depth)):
            displacements[f"{body}_{axis}0"] = {"set": f"{body}_{axis}0", axis: 0}
            displacements[f"{body}_{axis}1"] = {"set": f"{body}_{axis}1", axis: strain * length}
    sides = ["upper_bottom", "lower_top"]
    primary, secondary = sides if upper_primary else sides[::-1]
    return {
        "mesh": {"generate": generate},
        "materials": {"rubber": {"model": model, "young": YOUNG, "poisson": POISSON}},
        "bodies": {body: {"blocks": [body], "material": "rubber"} for body in ("lower", "upper")},
        "displacements": displacements,
        "contact": {"pair": {"primary": primary, "secondary": secondary, **contact}},
        "time": {"steps": steps},
    }


def mass_matrix(x):
    """Of piecewise linear functions over the points of an axis."""
    m = numpy.zeros((len(x), len(x)))
    for i, h in enumerate(numpy.diff(x)):
        m[i:i + 2, i:i + 2] += h / 6 * numpy.array([[2, 1], [1, 2]])
    return m


class Errors:
    """Errors of the nodal pressures on the primary surface, linear between all of its nodes, relative to
    the exact pressure: L2, largest, mean; stress error, root mean square over the elements. Of cells
    with curved faces only slabs are measured: the nodes of their faces make no grid."""

    def __init__(self, deck, stretch, model):
        self.result = result = scenes.run(deck, seconds=300)
        fields = result.fields
        exact = exact_pressure(stretch, model)
        nodes = fields.node_set(deck["contact"]["pair"]["primary"])
        x = fields.coordinates[nodes]
        if deck["mesh"]["generate"]["shape"] != "sphere":  # the pressure is the same across a slab
            nodes, x = nodes[x[:, 1] < 1e-9], x[x[:, 1] < 1e-9]
        axes = [numpy.unique(numpy.round(x[:, d], 9)) for d in range(2)]
        place = [numpy.searchsorted(axis, x[:, d] - 1e-6) for d, axis in enumerate(axes)]
        error = numpy.full([len(axis) for axis in axes], numpy.nan)
        error[place[0], place[1]] = fields.nodal("contact_pressure")[nodes] / exact - 1
        mass = [mass_matrix(axis) if len(axis) > 1 else numpy.eye(1) for axis in axes]
        area = numpy.sum(mass[0]) * numpy.sum(mass[1])
        self.pressure = math.sqrt(numpy.einsum("ij,ik,jl,kl", error, *mass, error) / area)
        self.mean = numpy.sum(mass[0] @ error @ mass[1]) / area
        self.largest = numpy.max(numpy.abs(error))
        self.inside = numpy.max(numpy.abs(error[1:-1, 1:-1] if len(axes[1]) > 1 else error[1:-1]))
        self.stress = self.stress_error(fields, exact)
        self.active = result.contact()["active_points"]
        self.unknowns = result.summary["unknowns"]
        self.augmentations = result.summary["augmentations"]

    @staticmethod
    def stress_error(fields, exact):
        squares, count = 0.0, 0
        for block in ("lower", "upper"):
            for name in ("xx", "yy", "zz", "xy", "yz", "xz"):
                normal = name[0] == name[1]
                values = fields.element(f"stress_{name}", block) + (exact if normal else 0.0)
                squares += numpy.sum(values**2) * (1 if normal else 2)
            count += len(values)
        return math.sqrt(squares / count / 3) / exact

    def __str__(self):
        return (f"pressure L2 {self.pressure:.5f}  max {self.largest:.5f} (inside {self.inside:.5f})  "
                f"mean {self.mean:+.5f}  stress {self.stress:.5f}  "
                f"({self.unknowns} unknowns, {self.augmentations} augmentations)")
