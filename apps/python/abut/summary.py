# SPDX-License-Identifier: BSD-3-Clause
"""The summary of a run: what `abut run --summary FILE.json` writes, as a dict."""
import json
import pathlib
import re

from .errors import InputError

LARGEST = 100e6  # bytes of a file that may be a summary


def read(path):
    """The dict of one summary. Raises InputError."""
    try:
        summary = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path}: the summary cannot be read: {error.strerror}") from None
    except ValueError as error:
        raise InputError(f"{path}: the summary is damaged, or none: {error}") from None
    if not is_summary(summary):
        raise InputError(f"{path}: is no summary of a run, which has 'status' and 'deck'")
    return summary


def is_summary(value):
    return isinstance(value, dict) and "status" in value and "deck" in value


def find(results):
    """Path of the summary beside the results NAME.exo that speaks of them; None where there is none.

    The newest that names the file; of summaries without the name, NAME.json or the one of a deck NAME.
    """
    results = pathlib.Path(results)
    stem = results.name.split(".exo")[0]
    told, guessed = [], []
    for path in results.parent.glob("*.json"):
        try:
            summary = read(path) if path.stat().st_size < LARGEST else {}
        except InputError:
            continue
        if "results" in summary:
            told += [path] if same_run(summary["results"], results.name) else []
        elif summary and stem in (path.stem, pathlib.Path(summary["deck"]).stem):
            guessed.append(path)
    return max(told or guessed, key=lambda path: path.stat().st_mtime, default=None)


def same_run(named, given):
    """Whether two names of files are of one run: those of its ranks differ in the end alone."""
    return re.sub(r"\.\d+\.\d+$", "", named) == re.sub(r"\.\d+\.\d+$", "", given)
