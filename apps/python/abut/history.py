# SPDX-License-Identifier: BSD-3-Clause
"""Numbers over a run: {column: (steps,)}, the first column being t.

    from abut import history
    columns = history.read("blocks.history.csv")
    pyplot.plot(columns["t"], columns["press_force_z"])
"""
import csv
import pathlib

import numpy as np

from .errors import InputError


def read(path):
    """Columns of a NAME.history.csv. A last line that was cut off is left out. Raises InputError."""
    try:
        with open(path, newline="", encoding="utf-8", errors="replace") as file:
            rows = [row for row in csv.reader(file) if row]
    except OSError as error:
        raise InputError(f"{path}: the history cannot be read: {error.strerror}") from None
    if not rows or rows[0][0] != "t":
        raise InputError(f"{path}: expected a table whose first column is 't'")
    names, lines = rows[0], rows[1:]
    if lines and len(lines[-1]) < len(names):
        lines.pop()
    try:
        table = np.array([[float(word) for word in line] for line in lines]).reshape(len(lines), len(names))
    except ValueError as error:
        raise InputError(f"{path}: the table is damaged: {error}") from None
    return dict(zip(names, table.T))


def fits(columns, results):
    """Whether the history is that of the results: it has all of their steps."""
    return bool(np.isin(results.times, columns["t"]).all())


def of_results(results):
    """The same from the global variables of an Exodus file: at its written steps alone."""
    return {"t": np.array(results.times), **results.global_columns()}


def path_of(results):
    """Where the history of the results NAME.exo is, and of further parts of theirs."""
    results = pathlib.Path(results)
    return results.with_name(results.name.partition(".exo")[0] + ".history.csv")
