# SPDX-License-Identifier: BSD-3-Clause
"""A command run with a time limit."""
import os
import signal
import subprocess


def execute(line, seconds, folder=None, environment=None):
    """Exit status (None after too long; every process is ended then) and all that was printed."""
    started = subprocess.Popen(line, cwd=folder, env={**os.environ, **(environment or {})},
                               text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True)
    try:
        output, _ = started.communicate(timeout=seconds)
        return started.returncode, output
    except subprocess.TimeoutExpired:
        os.killpg(started.pid, signal.SIGKILL)
        output, _ = started.communicate()
        return None, output
