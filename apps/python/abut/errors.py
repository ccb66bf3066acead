# SPDX-License-Identifier: BSD-3-Clause
"""What is said to a user who gave a file that cannot be used."""


class InputError(Exception):
    """The text names the file and what was expected of it."""
