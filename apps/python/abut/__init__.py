# SPDX-License-Identifier: BSD-3-Clause
"""Results of abut in Python.

abut.results  mesh and fields of Exodus files        abut.report  the page that `abut report` writes
abut.summary  the JSON that --summary asks for
abut.history  numbers over the run                   docs/user/results.md shows them in use
"""
