# SPDX-License-Identifier: BSD-3-Clause
"""A command run with a time limit."""
import os
import signal
import subprocess


def execute(line, seconds, folder=None, environment=None):
    """Exit status (None after too long; every process is ended then) and all that was printed.

    What went to stderr stands behind what went to stdout: how the two fall between each other, and where
    mpiexec cuts the one to let the other pass, is chance.
    """
    started = subprocess.Popen(line, cwd=folder, env={**os.environ, **(environment or {})},
                               text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               start_new_session=True)
    try:
        printed, errors = started.communicate(timeout=seconds)
        return started.returncode, joined(printed, errors)
    except subprocess.TimeoutExpired:
        os.killpg(started.pid, signal.SIGKILL)
        return None, joined(*started.communicate())


def joined(printed, errors):
    """Both, the second on lines of its own."""
    return printed + ("\n" if errors and printed and not printed.endswith("\n") else "") + errors
