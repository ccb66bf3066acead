# SPDX-License-Identifier: BSD-3-Clause
"""Draws the figures of docs/theory/multipliers.md from runs of the program.
usage: make_multipliers.py [--abut PROGRAM] [--only points factors patch friction counts]
"""
import argparse
import pathlib
import re
import sys

import matplotlib
import numpy

HERE = pathlib.Path(__file__).resolve().parent
for folder in ("support", "convergence", "patch"):
    sys.path.insert(0, str(HERE.parents[1] / "tests" / folder))
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

import pressure_ratios  # noqa: E402
import pressure_study  # noqa: E402
import scenes  # noqa: E402
import turned_block  # noqa: E402

AUGMENTED = {"enforcement": "augmented_lagrangian"}
NAMES = {"per_point": "per point", "smoothed": "smoothed", "dual": "dual"}
COLORS = {"per_point": "#c0392b", "smoothed": "#2471a3", "dual": "#1e8449", "penalty": "#7f8c8d"}
FACTOR = {"per_point": 10, "smoothed": 3, "dual": 30}


def save(figure, name):
    path = HERE / f"multipliers-{name}.png"
    figure.savefig(path, dpi=110, bbox_inches="tight")
    pyplot.close(figure)
    print(path, path.stat().st_size // 1000, "kB", flush=True)


def points(spaces):
    """Pressures of points and nodes over the radius, paraboloid with 4 facets to a contact radius."""
    figure, axes = pyplot.subplots(1, len(spaces), figsize=(4 * len(spaces), 3.2), sharey=True)
    for axis, space in zip(axes, spaces):
        options = {**AUGMENTED, "multipliers": space, "penalty_factor": FACTOR[space]}
        run = pressure_study.Scores(pressure_study.deck(4, **options))
        score, facets = run.steps[-1], run.facets
        r = numpy.linspace(0, 1.4 * score.a, 400)
        axis.plot(r / score.a, score.exact(r) / score.p0, color="black", lw=1, label="Hertz")
        for x, p, mark, label in ((facets.point_x, facets.point_p, ".", "points"),
                                  (facets.current, facets.nodal, "o", "nodes")):
            s = numpy.linalg.norm(x[..., :2], axis=-1).ravel() / score.a
            near = s < 1.4
            style = {"ms": 4, "color": COLORS[space]} if mark == "." else \
                {"ms": 5, "mfc": "none", "color": "black", "mew": 0.8}
            axis.plot(s[near], p.ravel()[near] / score.p0, mark, label=label, **style)
        axis.set_title(f"{NAMES[space]}, f = {FACTOR[space]}: points {100 * run.point[-1]:.0f} %, "
                       f"nodes {100 * run.nodal[-1]:.0f} %", fontsize=9)
        axis.set_xlabel("r / a")
        axis.set_ylim(-0.05, 2.0)
    axes[0].set_ylabel("pressure / p0")
    axes[0].legend(fontsize=8)
    save(figure, "points")


def factors(spaces):
    """L2 errors over the penalty factor, 2 facets to a contact radius."""
    values = (1, 3, 10, 30, 100)
    figure, axes = pyplot.subplots(1, 2, figsize=(8.5, 3.2), sharey=True)
    for name in ("penalty", *spaces):
        rows = []
        for factor in values:
            options = {} if name == "penalty" else {**AUGMENTED, "multipliers": name}
            run = pressure_study.Scores(pressure_study.deck(2, penalty_factor=factor, **options))
            rows.append((run.point.mean(), run.nodal.mean()))
            print(f"{name} f={factor}: points {rows[-1][0]:.3f} nodes {rows[-1][1]:.3f}", flush=True)
        for axis, column in zip(axes, numpy.array(rows).T):
            axis.plot(values, 100 * column, "o-", ms=4, color=COLORS[name], label=NAMES.get(name, "penalty alone"))
    for axis, title in zip(axes, ("at the points", "averaged at the nodes")):
        axis.set(xscale="log", yscale="log", xlabel="penalty factor f", title=f"L2 error of the pressure {title}, %")
        axis.title.set_size(9)
        axis.grid(True, which="both", lw=0.3)
    axes[0].legend(fontsize=8)
    save(figure, "factors")


def patch(spaces):
    """A uniform pressure through 5 x 5 primary on 8 x 8 secondary faces."""
    figure, axes = pyplot.subplots(1, len(spaces), figsize=(3.6 * len(spaces), 3))
    for axis, space in zip(axes, spaces):
        case = "AL1" if space == "smoothed" else "AL10"
        run = pressure_ratios.Deviation(pressure_ratios.scene(5, 8, **{**pressure_ratios.CASES[case],
                                                                       "multipliers": space}))
        facets = run.facet_data
        x = facets.point_x.reshape(-1, 3)
        drawn = axis.scatter(x[:, 0], x[:, 1], c=100 * (facets.point_p.ravel() / pressure_ratios.LOAD - 1), s=90,
                             marker="s", cmap="RdBu_r", vmin=-40, vmax=40, edgecolors="grey", linewidths=0.3)
        for k in range(9):
            axis.axhline(k / 8, lw=0.3, color="black")
            axis.axvline(k / 8, lw=0.3, color="black")
        axis.set_title(f"{NAMES[space]}: points {100 * run.points[1]:.1f} %, nodes {100 * run.nodal[1]:.1f} %",
                       fontsize=9)
        axis.set(aspect="equal", xticks=[], yticks=[])
    figure.colorbar(drawn, ax=axes, label="deviation of the pressure, %", shrink=0.9)
    save(figure, "patch")


def friction(spaces):
    """Linear solves for each step of the turned block over the penalty factor."""
    values = (1, 10, 100, 1000)
    words = scenes.words_of("friction_switching")
    shown = [("penalty", word) for word in words] + \
        [(space, word) for space in spaces if space != "per_point" for word in words]
    figure, axis = pyplot.subplots(figsize=(8.5, 3.2))
    width = 0.8 / len(shown)
    for i, (space, word) in enumerate(shown):
        options = {} if space == "penalty" else {**AUGMENTED, "multipliers": space}
        for k, factor in enumerate(values):
            count = turned_block.run({"penalty_factor": factor, "friction_switching": word, **options})
            print(space, word, factor, count, flush=True)
            at = k - 0.4 + (i + 0.5) * width
            good = not count.failed and not count.stopped
            style = {"color": COLORS[space], "hatch": "" if word == "primal_dual" else "////", "edgecolor": "white"}
            label = f"{NAMES.get(space, 'penalty alone')}, {word.replace('_', ' ')}" if k == 0 else None
            axis.bar(at, count.mean if good else 0, width, label=label, **style)
            if not good:
                axis.text(at, 0.3, "fails", rotation=90, ha="center", va="bottom", fontsize=7, color=COLORS[space])
    axis.set_xticks(range(len(values)), [f"f = {v}" for v in values])
    axis.set_ylabel("linear solves for each step")
    axis.legend(fontsize=7)
    save(figure, "friction")


def counts(spaces):
    """What is left of the gap over the linear solves of a cold start, 2 facets to a contact radius."""
    figure, axes = pyplot.subplots(1, len(spaces), figsize=(3.6 * len(spaces), 3), sharex=True, sharey=True)
    for axis, space in zip(axes, spaces):
        for factor, style in ((1, ":"), (10, "--"), (100, "-")):
            deck = pressure_study.deck(2, steps=1, multipliers=space, penalty_factor=factor, gap_tolerance=1e-6,
                                       multiplier_tolerance=1e6, max_augmentations=12, **AUGMENTED)
            output = scenes.run(deck, seconds=300, quiet=False).output
            solves, history = 1, []
            for line in output.splitlines():
                if re.match(r"\s+step 1 .* newton +[1-9]", line):
                    solves += 1
                gap = re.match(r"\s+augmentation \d+ .*penetration (\S+) of a face", line)
                if gap:
                    history.append((solves, float(gap.group(1))))
            axis.semilogy(*zip(*history), style, marker="o", ms=3, color=COLORS[space], label=f"f = {factor}")
        axis.set_title(NAMES[space], fontsize=9)
        axis.set_xlabel("linear solves")
        axis.grid(True, lw=0.3)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("largest gap / face size")
    axes[0].set_ylim(1e-8, 1e-1)
    save(figure, "counts")


FIGURES = {"points": points, "factors": factors, "patch": patch, "friction": friction, "counts": counts}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--abut", default=scenes.EXECUTABLE)
    parser.add_argument("--only", nargs="+", default=list(FIGURES), choices=list(FIGURES))
    known = parser.parse_args()
    scenes.EXECUTABLE = known.abut
    spaces = [space for space in NAMES if space in scenes.words_of("multipliers")]
    for name in known.only:
        FIGURES[name](spaces)


if __name__ == "__main__":
    main()
