# SPDX-License-Identifier: BSD-3-Clause
"""What scripts share that print a row for each run of a scene with other options."""
import argparse

import scenes


def parser(text, formulations):
    """Arguments of all tables: the program, formulations, spaces of multipliers, further options of the interface."""
    result = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("--abut", default=scenes.EXECUTABLE)
    result.add_argument("--formulations", nargs="+", default=formulations)
    result.add_argument("--spaces", nargs="+")
    result.add_argument("--set", nargs="+", default=[], metavar="KEY=VALUE")
    return result


def parse(arguments):
    """The arguments given; `spaces` are all if none is, `more` are the options of --set."""
    known = arguments.parse_args()
    scenes.EXECUTABLE = known.abut
    known.spaces = known.spaces or scenes.words_of("multipliers")
    known.more = scenes.settings(known.set)
    return known


def row(label, width, run):
    """Prints what `run` returns, or the last line of why it failed."""
    try:
        text = str(run())
    except scenes.RunFailed as failure:
        text = " " + str(failure).strip().splitlines()[-1]
    print(f"{label:{width}s}{text}", flush=True)
