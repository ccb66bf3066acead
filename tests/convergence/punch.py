# SPDX-License-Identifier: BSD-3-Clause
"""Rigid flat punch without friction on an elastic half-space, strip or disc of half width a = 1.

Sadowsky 1928: p = P'/(pi sqrt(a^2 - x^2)). Boussinesq: p = P/(2 pi a sqrt(a^2 - r^2)), P = 2 a E* delta.
The pressure is not square integrable; the load within 0.9 a and the approach are measured.
"""
import math

import numpy

import scenes

YOUNG, POISSON = 1.0, 0.3
MODULUS = YOUNG / (1 - POISSON**2)
APPROACH = 1e-3
INNER = 0.9
SIZE = {"strip": 100.0, "disc": 10.0}  # the strip without, the disc with the far field of its force
EXACT_SHARE = {"strip": 2 / math.pi * math.asin(INNER), "disc": 1 - math.sqrt(1 - INNER**2)}
EXACT_FORCE = 2 * MODULUS * APPROACH  # of the whole disc


def far_field():
    """Displacements of a half-space z < 0 under the point force -EXACT_FORCE e_z (Boussinesq 1885)."""
    factor = EXACT_FORCE * (1 + POISSON) / (2 * math.pi * YOUNG)
    square = "(x^2+y^2+z^2+1e-30)"  # not zero under the force, where nothing is prescribed but symmetry
    distance = f"sqrt{square}"
    lateral = f"t*{factor!r}/{distance}*(-z/{square}-{1 - 2 * POISSON!r}/({distance}-z))"
    return {"x": f"{lateral}*x", "y": f"{lateral}*y",
            "z": f"-t*{factor!r}/{distance}*({2 * (1 - POISSON)!r}+z^2/{square})"}


def scene(shape, facets, offset=0.0, body_primary=True, **contact):
    strip = shape == "strip"
    divisions = (1 if strip else 32) if body_primary else 2 * facets
    generate = {"kind": "punch", "shape": shape, "facets": facets, "offset": offset, "size": SIZE[shape],
                "growth": 1.4, "max_size": SIZE[shape], "punch_divisions": divisions,
                "thickness": 1 / facets}
    displacements = {"x0": {"set": "x0", "fix": ["x"]}, "y0": {"set": "y0", "fix": ["y"]}}
    if strip:
        displacements["y1"] = {"set": "y1", "fix": ["y"]}
        for name in ("side", "bottom"):
            displacements[name] = {"set": name, "fix": ["x", "z"]}
    else:
        field = far_field()
        for name in ("side", "bottom"):
            displacements[name] = {"set": name, **field}
        # no two entries may differ where their sets meet, so symmetry is written as the same field
        displacements["x0"] = {"set": "x0", "x": field["x"]}
        displacements["y0"] = {"set": "y0", "y": field["y"]}
    sides = ["contact", "punch_bottom"]
    primary, secondary = sides if body_primary else sides[::-1]
    return {
        "mesh": {"generate": generate},
        "materials": {"elastic": {"model": "linear_elastic", "young": YOUNG, "poisson": POISSON}},
        "bodies": {"body": {"blocks": ["body"], "material": "elastic"},
                   "punch": {"blocks": ["punch"], "rigid": {"displacement": [0, 0, -APPROACH]}}},
        "displacements": displacements,
        "contact": {"pair": {"primary": primary, "secondary": secondary, **contact}},
    }


class Errors:
    """Share of the load within 0.9 a, force of a disc over the exact one, largest pressure over the mean."""

    def __init__(self, deck):
        result = scenes.run(deck, seconds=300)
        fields, contact = result.fields, deck["contact"]["pair"]
        generate = deck["mesh"]["generate"]
        strip = generate["shape"] == "strip"
        nodes = fields.node_set(contact["primary"])
        nodes = nodes[numpy.abs(fields.coordinates[nodes, 1]) < 1e-12]
        nodes = nodes[numpy.argsort(fields.coordinates[nodes, 0])]
        x, p = fields.coordinates[nodes, 0], fields.nodal("contact_pressure")[nodes]
        force = abs(result.force()[2])
        self.load = force / generate["thickness"] if strip else force / (math.pi / 2)
        self.share = self.within(x, p, strip) / self.load / EXACT_SHARE[generate["shape"]] - 1
        self.force = 4 * force / EXACT_FORCE - 1
        self.peak = numpy.max(p) / (self.load if strip else 2 * self.load)
        self.active = result.contact()["active_points"]
        self.unknowns = result.summary["unknowns"]

    @staticmethod
    def within(x, p, strip, pieces=2000):
        """Load of the piecewise linear pressure between 0 and 0.9 a, per length or per radian."""
        edges = numpy.linspace(0, INNER, pieces + 1)
        middle = (edges[1:] + edges[:-1]) / 2
        return numpy.sum(numpy.interp(middle, x, p) * (1 if strip else middle)) * INNER / pieces

    def __str__(self):
        return (f"share within 0.9 a {self.share:+.5f}  force of a disc {self.force:+.5f}  "
                f"largest over mean pressure {self.peak:.4f}  ({self.unknowns} unknowns, "
                f"{self.active} points)")
