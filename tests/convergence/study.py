# SPDX-License-Identifier: BSD-3-Clause
"""What the studies share: arguments, orders, and the run of a file.

usage of a study: FILE [--meshes 4 8 16] [--formulation WORD] [--spaces WORDS, of multipliers] [unittest arguments]
"""
import argparse
import math
import sys
import unittest

import numpy


def arguments(meshes):
    """meshes: of the normal tests. What is not known is left to unittest."""
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--meshes", type=int, nargs="+", default=meshes)
    parser.add_argument("--formulation")
    parser.add_argument("--spaces", nargs="+", default=[])
    known, rest = parser.parse_known_args()
    known.thorough = len(known.meshes) > 2  # beyond the normal tests
    # one pass over nodes: the pressure on meshes that do not fit keeps a defect of the mesh ratio
    known.nodal = known.formulation == "node_on_facet"
    sys.argv[1:] = rest
    return known


def contact(known, **options):
    """Options of the contact interface with the formulation that was asked for."""
    return {**options, **({"formulation": known.formulation} if known.formulation else {})}


def spaces(**per_point):
    """Options of augmented Lagrangian: a multiplier at each point with the settings given, and what a deck gets
    that asks for nothing more."""
    augmented = {"enforcement": "augmented_lagrangian"}
    return {"per_point": {**augmented, "multipliers": "per_point", **per_point}, "default": augmented}


def order(meshes, values):
    """Slope of the straight line through log(value) over log(1/mesh)."""
    return -numpy.polyfit(numpy.log(meshes), numpy.log(numpy.abs(values)), 1)[0]


def orders(meshes, values):
    """From each mesh to the next."""
    return [math.log(abs(a / b)) / math.log(n / m)
            for a, b, m, n in zip(values, values[1:], meshes, meshes[1:])]


def words(values, form=".2f"):
    return " ".join(f"{v:{form}}" for v in values)


def main():
    unittest.main()
