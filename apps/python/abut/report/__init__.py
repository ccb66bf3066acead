# SPDX-License-Identifier: BSD-3-Clause
"""`abut report`: one HTML page of a run."""
