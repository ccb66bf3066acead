# SPDX-License-Identifier: BSD-3-Clause
"""All that there is of one run: results, summary and history."""
import pathlib
from dataclasses import dataclass

from .. import history, summary as summaries
from ..errors import InputError
from ..results import Results


@dataclass
class Run:
    path: pathlib.Path
    results: Results
    summary: dict          # empty where there is none
    summary_path: object   # None where there is none
    columns: dict          # numbers over t
    history_path: object   # None where they are those of the written steps
    notes: list            # what is missing, for the reader

    @property
    def stem(self):
        return self.path.name.partition(".exo")[0]

    @property
    def title(self):
        return self.summary.get("title") or self.results.title or self.stem


def load(path, summary_path=None):
    """The run of the results `path`; a summary that is not given is looked for. Raises InputError."""
    path = pathlib.Path(path)
    results = Results(path)
    if not results.names("nod_var"):
        raise InputError(f"{path}: is a mesh without results; give the NAME.exo that 'abut run' has written")
    notes = []
    found = summary_path or summaries.find(path)
    summary = summaries.read(found) if found else {}
    if not found:
        notes.append("There is no summary beside the results, so that status, warnings and comparisons are unknown: "
                     f"run with --summary {path.name.partition('.exo')[0]}.json.")
    columns, history_path = _columns(path, results, notes)
    if not len(results.times):
        notes.append("The file holds no step: the pictures show the mesh as it was given.")
    return Run(path, results, summary, found, columns, history_path, notes)


def _columns(path, results, notes):
    """Numbers over t, and the file that they are from; None: from the written steps of the results."""
    table = history.path_of(path)
    if table.exists():
        try:
            columns = history.read(table)
            if history.fits(columns, results):
                return columns, table
            notes.append(f"{table} is not used: it is of another run.")
        except InputError as error:
            notes.append(f"The history is not used: {error}.")
    return history.of_results(results), None
