#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs `abut check DECK` and `abut run DECK` and holds both against the deck's first line, a comment
`expect: REGEX`.

The program must end with status 2, say what REGEX asks for, say it once however many ranks run, and
leave no results.
usage: run_invalid_deck.py [--seconds N] [--check-only] DECK -- PROGRAM...   (PROGRAM: [mpiexec ...] abut)
"""
import argparse
import os
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import process  # noqa: E402  found by the line above


def expectation(deck):
    with open(deck, encoding="utf-8") as lines:
        first = lines.readline().strip()
    match = re.fullmatch(r"(?:#|<!--) expect: (.*?)(?: -->)?", first)
    if not match:
        sys.exit(f"{deck}: the first line must be '# expect: REGEX', got '{first}'")
    return match.group(1)


def faults(status, output, regex, seconds):
    found = len(re.findall(regex, output))
    if status is None:
        yield f"still running after {seconds} s"
    elif status != 2:
        yield f"exit status {status}, expected 2"
    if found != 1:
        yield f"expected the message once, found it {found} times: {regex}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--check-only", action="store_true")
    parser.add_argument("deck")
    parser.add_argument("program", nargs="+")
    arguments = parser.parse_args()
    regex = expectation(arguments.deck)
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="abut_invalid_") as folder:
        commands = [["check"], ["run", "--output-dir", folder]]
        for command in commands[:1] if arguments.check_only else commands:
            status, output = process.execute(
                arguments.program + command + [arguments.deck], arguments.seconds)
            found = list(faults(status, output, regex, arguments.seconds))
            found += [f"left {path}" for path in os.listdir(folder)]
            if found:
                print(f"abut {command[0]}:", "\n".join(found), "\n--- output:\n" + output)
            wrong += len(found)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
