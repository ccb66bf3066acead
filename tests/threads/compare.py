#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two outputs of kernel_results: every array to the given share of its largest value, and
those whose names end in ! value by value. Usage: compare.py A B TOLERANCE"""
import sys

import numpy


def arrays(path):
    values, result, first = numpy.fromfile(path + ".bin"), {}, 0
    with open(path + ".txt") as names:
        for line in names:
            name, count = line.split()
            result[name] = values[first:first + int(count)]
            first += int(count)
    assert first == len(values), path
    return result


def difference(name, a, b):
    """Relative to the largest value; infinite for what must be equal and is not."""
    if a.shape != b.shape or not (numpy.isfinite(a).all() and numpy.isfinite(b).all()):
        return numpy.inf
    most = numpy.abs(a - b).max(initial=0.0)
    if name.endswith("!"):
        return 0.0 if most == 0.0 else numpy.inf
    return most / max(numpy.abs(a).max(initial=0.0), numpy.finfo(float).tiny)


def main(first, second, tolerance):
    a, b = arrays(first), arrays(second)
    if not a or a.keys() != b.keys():
        sys.exit("not the same arrays")
    differences = {name: difference(name, a[name], b[name]) for name in a}
    wrong = {name: d for name, d in differences.items() if d > float(tolerance)}
    for name, d in wrong.items():
        print(f"{name} ({len(a[name])} values): {d:.1e}")
    name, most = max(differences.items(), key=lambda item: item[1])
    print(f"{len(a)} arrays, {sum(map(len, a.values()))} values, {len(wrong)} beyond {tolerance}; "
          f"largest difference {most:.1e} in {name}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
