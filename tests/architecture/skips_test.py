# SPDX-License-Identifier: BSD-3-Clause
"""A file of which every test skips itself ends with 77; one with a test that ran does not."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUNNER = pathlib.Path(__file__).resolve().parents[1] / "support" / "run_tests.py"
TEST = "class {}(unittest.TestCase):\n    def test(self):\n        {}\n"
SKIPS, PASSES, FAILS = "self.skipTest('why')", "self.assertTrue(True)", "self.fail()"


class Skips(unittest.TestCase):
    def status(self, *bodies, decorator=""):
        tests = "".join(decorator + TEST.format(f"Case{i}", body) for i, body in enumerate(bodies))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "some_test.py"
            file.write_text(f"import unittest\n{tests}unittest.main()\n", encoding="utf-8")
            return subprocess.run([sys.executable, "-B", RUNNER, file], capture_output=True, check=False).returncode

    def test_all_skipped(self):
        self.assertEqual(self.status(SKIPS, SKIPS), 77)
        self.assertEqual(self.status(PASSES, decorator="@unittest.skip('why')\n"), 77)

    def test_some_ran(self):
        self.assertEqual(self.status(SKIPS, PASSES), 0)
        self.assertEqual(self.status(PASSES), 0)

    def test_failures_stay_failures(self):
        self.assertEqual(self.status(SKIPS, FAILS), 1)


if __name__ == "__main__":
    unittest.main()
