# SPDX-License-Identifier: BSD-3-Clause
"""Curves of a run as PNG images. t is the load parameter, or the time of dynamics."""
import re

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from .pictures import png

MOST_PANELS = 8
NOTHING = 1e-6         # of the largest of a panel: a curve that is nothing to see
ROUNDING = 1e-10       # of the largest force of a run: a force that is zero
MOST_ITERATIONS = 600  # whose residuals are drawn; of longer runs the last
ENERGIES = {"work_in": "work done on the model", "energy_stored": "stored in bodies",
            "energy_penalty": "in the penalty", "energy_friction": "lost to friction", "kinetic_energy": "kinetic",
            "energy_imbalance": "imbalance"}
NUMBERS = (("_area", "area in contact", "area"), ("_pressure_max", "largest nodal pressure", "pressure"),
           ("_penetration_max", "deepest penetration", "length"))
MOST_CURVES = 10       # of a panel
FORCE = re.compile(r"(.+)_(force|reaction)_([xyz])")


def forces(columns):
    """Components of each contact force and reaction over t, and what is left out; None where there is none."""
    groups = {}
    for name in columns:
        match = FORCE.fullmatch(name)
        if match:
            groups.setdefault(match.group(1, 2), {})[match.group(3)] = columns[name]
    zero = ROUNDING * _largest(curve for parts in groups.values() for curve in parts.values())
    groups = {key: parts for key, parts in groups.items() if _largest(parts.values()) > zero}
    shown, left_out = list(groups.items())[:MOST_PANELS], list(groups)[MOST_PANELS:]
    if not shown:
        return None, []
    figure, panels = _panels(len(shown))
    for panel, ((name, kind), parts) in zip(panels, shown):
        largest = _largest(parts.values())
        for axis, color in zip("xyz", ("tab:red", "tab:green", "tab:blue")):
            if axis in parts and np.max(np.abs(parts[axis])) > NOTHING * largest:
                panel.plot(columns["t"], parts[axis], color=color, marker=_marker(columns["t"]), markersize=3,
                           label=f"{kind} {axis}")
        _finish(panel, f"{kind} of {name}", "force (model units)")
    return png(figure), [" ".join(key) for key in left_out]


def energies(columns):
    """Where the work went over t; None where the columns have no energies."""
    known = {name: label for name, label in ENERGIES.items() if name in columns and np.any(columns[name])}
    known.update({name: name[len("energy_"):].replace("_", " ") for name in columns
                  if name.startswith("energy_") and name not in known and np.any(columns[name])})
    largest = _largest(columns[name] for name in known)
    if not largest > 0:
        return None
    figure, (panel,) = _panels(1)
    for name, label in known.items():
        if np.max(np.abs(columns[name])) > NOTHING * largest:
            panel.plot(columns["t"], columns[name], marker=_marker(columns["t"]), markersize=2.5, label=label,
                       linestyle="--" if name == "work_in" else "-", linewidth=2.2 if name == "work_in" else 1.4)
    _finish(panel, "energy", "energy (model units)")
    return png(figure)


def contact_numbers(columns):
    """Area, largest pressure and deepest penetration of each interface over t; None where the columns have none."""
    shown = [(title, ordinate, {name[:-len(end)]: columns[name] for name in columns
                                if name.endswith(end) and np.any(columns[name])}) for end, title, ordinate in NUMBERS]
    shown = [(title, ordinate, curves) for title, ordinate, curves in shown if curves]
    if not shown:
        return None
    figure, panels = _panels(len(shown))
    for panel, (title, ordinate, curves) in zip(panels, shown):
        for name, curve in list(curves.items())[:MOST_CURVES]:
            panel.plot(columns["t"], curve, marker=_marker(columns["t"]), markersize=3, label=name)
        _finish(panel, title, f"{ordinate} (model units)")
    return png(figure)


def iterations(steps):
    """Newton iterations and augmentations of each step as bars, cuts marked; None where no step needed any.

    steps: see convergence.steps_of.
    """
    if not any(step["newton_iterations"] or step["cut_backs"] for step in steps):
        return None
    figure, (panel,) = _panels(1, wide=True)
    number = np.array([step["step"] for step in steps])
    newton = np.array([step["newton_iterations"] for step in steps])
    panel.bar(number, newton, width=0.85, color="#4e79a7", label="Newton iterations")
    augmentations = np.array([step["augmentations"] for step in steps])
    if augmentations.any():
        panel.bar(number, augmentations, width=0.4, color="#f28e2b", label="augmentations")
    cut = [(step["step"], step["newton_iterations"], step["cut_backs"]) for step in steps if step["cut_backs"]]
    if cut:
        panel.plot([c[0] for c in cut], [c[1] for c in cut], "v", color="#c0392b", markersize=7,
                   label="the step was cut before")
        for place, height, times in cut if len(cut) <= 40 else []:
            panel.annotate(str(times), (place, height), textcoords="offset points", xytext=(0, 6), ha="center",
                           fontsize=7, color="#c0392b")
    panel.set_xlim(number[0] - 0.6, number[-1] + 0.6)
    panel.set_ylim(0, max(1.0, 1.18 * newton.max()))
    panel.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    panel.yaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    _finish(panel, "", "count", "step")
    return png(figure)


def residuals(steps, failed):
    """Residuals of all iterates one behind the other, a line for each solve. None where there are none.

    steps as in iterations, with `residuals`; failed: solves of attempts after the last converged step.
    """
    solves = [(step["step"], solve) for step in steps for solve in step.get("residuals", [])]
    solves += [(None, solve) for solve in failed]
    while len(solves) > 1 and sum(len(solve) for _, solve in solves) > MOST_ITERATIONS:
        solves.pop(0)
    if not any(value for _, solve in solves for value in solve):  # a start in balance has none
        return None
    figure, (panel,) = _panels(1, wide=True)
    place, before, labelled = 0, "", set()
    for step, solve in solves:
        values = np.array([np.nan if value is None else value for value in solve], float)
        values[values <= 0] = np.nan
        color, label = ("#c0392b", "did not converge") if step is None else ("#4e79a7", "converged step")
        panel.semilogy(np.arange(len(solve)) + place, values, ".-", color=color, linewidth=1, markersize=4,
                       label=None if label in labelled else label)
        labelled.add(label)
        if step != before and len({s for s, _ in solves}) <= 60:
            panel.axvline(place - 0.5, color="#bbb", linewidth=0.8, zorder=0)
            if len({s for s, _ in solves}) <= 25:
                panel.annotate("failed" if step is None else str(step), (place - 0.3, 0.02), fontsize=7, color="#777",
                               xycoords=("data", "axes fraction"))
        before = step
        place += len(solve)
    panel.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    first = "" if len(solves) == sum(len(s.get("residuals", [])) for s in steps) + len(failed) else ", of the last solves"
    _finish(panel, "", "residual / reference force", f"Newton iterate{first} (grey: step)")
    return png(figure)


def _largest(curves):
    return max((float(np.nanmax(np.abs(curve))) for curve in curves if len(curve)), default=0.0)


def _marker(t):
    return "o" if len(t) <= 60 else None


def _panels(count, wide=False):
    """A figure and its axes, two beside each other."""
    columns = 1 if wide or count == 1 else 2
    rows = -(-count // columns)
    figure = Figure(figsize=(8.2 if wide or count > 1 else 5.6, 2.9 * rows), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for empty in panels[count:]:
        empty.set_axis_off()
    return figure, list(panels[:count])


def _finish(panel, title, ordinate, abscissa="t"):
    if title:
        panel.set_title(title, fontsize=10)
    panel.set_xlabel(abscissa, fontsize=9)
    panel.set_ylabel(ordinate, fontsize=9)
    panel.tick_params(labelsize=8)
    if panel.get_yscale() == "linear":
        panel.ticklabel_format(axis="y", scilimits=(-3, 4))
    panel.grid(alpha=0.3)
    if panel.get_legend_handles_labels()[0]:
        panel.legend(fontsize=8, framealpha=0.85)
