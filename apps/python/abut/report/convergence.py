# SPDX-License-Identifier: BSD-3-Clause
"""What each step of a run has cost."""

COUNTS = ("newton_iterations", "augmentations", "cut_backs")


def steps_of(summary, columns):
    """[{step, t, newton_iterations, augmentations, cut_backs, residuals}] and the residuals of attempts that failed last.

    From the summary; where it is missing or older, from the counters of the written steps, then without residuals.
    """
    told = (summary or {}).get("convergence")
    if told:
        return told["steps"], told.get("failed_residuals", [])
    if "steps" not in columns or len(columns["t"]) < 2:
        return [], []
    counts = {name: [int(n) for n in columns.get(name, [0] * len(columns["t"]))] for name in ("steps", *COUNTS)}
    steps = []
    for i in range(1, len(columns["t"])):
        steps.append({"step": counts["steps"][i], "t": float(columns["t"][i]),
                      **{name: counts[name][i] - counts[name][i - 1] for name in COUNTS}})
    return steps, []
