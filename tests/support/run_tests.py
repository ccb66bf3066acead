# SPDX-License-Identifier: BSD-3-Clause
"""Runs a unittest file as if it were started by itself; exit status 77 when every test skipped itself.

usage: run_tests.py FILE [arguments of the file]
"""
import pathlib
import runpy
import sys
import unittest

ALL_SKIPPED = 77  # what ctest is told to count as skipped; unittest itself ends with 0


def only_skipped(result):
    """Whether tests were skipped and none did anything. A skipped class is in no count of tests that ran."""
    skipped = sum(isinstance(test, unittest.TestCase) for test, _ in result.skipped)
    return bool(result.skipped) and result.wasSuccessful() and result.testsRun == skipped


class Program(unittest.TestProgram):
    def runTests(self):  # pylint: disable=invalid-name
        try:
            super().runTests()
        except SystemExit:
            if only_skipped(self.result):
                sys.exit(ALL_SKIPPED)
            raise


def main():
    file = pathlib.Path(sys.argv[1]).resolve()
    sys.argv = sys.argv[1:]
    sys.path.insert(0, str(file.parent))
    unittest.main = Program
    runpy.run_path(str(file), run_name="__main__")


if __name__ == "__main__":
    main()
