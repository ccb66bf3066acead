# SPDX-License-Identifier: BSD-3-Clause
"""Puts the report of a run together."""
import datetime
import pathlib

import numpy as np

from .. import scene as scenes
from ..errors import InputError
from . import charts, convergence, page, pictures
from .run import load

MOST_ROWS = 400  # of the table of steps
ENFORCED = {"active_points": "points in contact", "stick_points": "of them sticking", "slip_points": "of them slipping",
            "max_pressure": "largest nodal pressure", "max_penetration": "largest penetration",
            "max_penetration_over_face_size": "largest penetration / face size", "max_slip": "longest way slipped",
            "penalty_error": "penalty error", "friction_dissipation": "lost to friction"}


def write_report(results, output=None, summary=None):
    """Writes the page and returns its path; NAME.html beside the results if not given. Raises InputError."""
    run = load(results, summary)
    place = pathlib.Path(output) if output else run.path.with_name(run.stem + run.path.name.partition(".exo")[2] + ".html")
    _protect(place)
    scene = scenes.read(run.results)
    parts = [_head(run, scene), _why(run, scene), _warnings(run), _pictures(run, scene), _contact_surfaces(scene),
             _curves(run), _convergence(run), _verify(run), _contacts(run), _costs(run), _files(run, place)]
    text = page.page(run.title, *parts)
    try:
        place.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"{place}: the report cannot be written: {error.strerror}") from None
    return place


def _protect(place):
    """Only a report is written over."""
    if place.is_dir() or (place.exists() and page.GENERATOR.encode() not in place.read_bytes()[:500]):
        raise InputError(f"the report would overwrite '{place}', which is none; give another name with -o")


def _head(run, scene):
    status = run.summary.get("status")
    kind = {"converged": "ok", "stopped": "failed"}.get(status, "unknown")
    results = run.results
    facts = [("status", [page.badge(status or "unknown, there is no summary", kind)]),
             ("deck", run.summary.get("deck", "unknown")),
             ("last state", f"t = {scene.t:.6g}, {len(results.times)} states written"),
             ("nodes", len(results.node_map)), ("elements", results.num_elements),
             ("unknowns", run.summary.get("unknowns")), ("ranks", run.summary.get("ranks")),
             ("steps", run.summary.get("steps")), ("wall time", _seconds(run.summary.get("wall_seconds"))),
             ("memory", _megabytes(run.summary.get("peak_memory_mb"))),
             ("report made", datetime.datetime.now().strftime("%Y-%m-%d %H:%M"))]
    rows = [(name, [page.number(value) if not isinstance(value, list) else value[0]])
            for name, value in facts if value is not None]
    notes = "".join(f'<p class="note">{page.text(note)}</p>' for note in run.notes)
    return (f"<h1>{page.text(run.title)}</h1>" + page.section(
        "facts", "The run", page.table((), rows), notes,
        '<p class="note">abut knows no units: all numbers are in the units of the model.</p>'))


def _why(run, scene):
    if run.summary.get("status") != "stopped":
        return ""
    return page.section("reason", "Why it stopped", f'<div class="reason">{page.text(run.summary.get("reason", ""))}</div>',
                        f'<p>Pictures and curves go up to the last converged state, t = {scene.t:.6g}.</p>')


def _warnings(run):
    if not run.summary:
        return ""
    warnings = run.summary.get("warnings", [])
    items = "".join(f"<li>{page.text(warning)}</li>" for warning in warnings)
    return page.section("warnings", "Warnings", f'<ul class="warnings">{items}</ul>' if items else "<p>None.</p>")


def _pictures(run, scene):
    if not len(scene.skin):
        return page.section("pictures", "Deformed mesh", "<p>The mesh has no solid elements.</p>")
    size = np.ptp(run.results.coordinates, axis=0)
    moved = np.linalg.norm(scene.displacement, axis=1).max()
    about = (f"Displacements are drawn as they are; the largest is {moved:.4g}, the model measures "
             f"{size[0]:.4g} by {size[1]:.4g} by {size[2]:.4g} (model units).")
    caption = f"State at t = {scene.t:.6g}. Contact that lies behind shows through the bodies. " + about
    if not scene.pressed.any():
        caption = f"State at t = {scene.t:.6g}. No face is in contact. " + about
    stress = "Von Mises stress of the average over each element, in the same view."
    images = []
    for near in (False, True) if pictures.contact_is_small(scene) else (False,):
        images.append(page.figure(pictures.deformed(scene, near=near), "The contact in the same view." if near else caption,
                                  f"deformed mesh with contact pressure{', near' if near else ''}"))
        if scene.von_mises.any():
            images.append(page.figure(pictures.deformed(scene, "von_mises", near), stress,
                                      f"deformed mesh with von Mises stress{', near' if near else ''}"))
    return page.section("pictures", "Deformed mesh", *images)


def _contact_surfaces(scene):
    images = []
    for name, faces in pictures.surfaces_in_contact(scene):
        image, turns = pictures.contact_surface(scene, faces)
        way = "The surface turns around, so that it is seen obliquely from both sides." if turns else \
            "Seen from outside the body, along the mean normal of what is pressed."
        images.append(page.figure(image, f"Surface of block '{name}' in contact. {way} Status is that of nodes; without "
                                  "friction what touches slips. A side whose faces are much larger than the other's shows "
                                  "a mean.", f"contact surface of {name}"))
    return page.section("contact-surface", "Contact surface", *(images or ["<p>Nothing is in contact in this state.</p>"]))


def _curves(run):
    image, left_out = charts.forces(run.columns)
    source = "Every step, from the history." if run.history_path else "At the states that the results hold."
    caption = source + " Contact forces act on the primary surface."
    if left_out:
        caption += f" Not drawn: {', '.join(left_out)}."
    parts = [page.figure(image, caption, "forces over t")] if image else ["<p>No force acts in this run.</p>"]
    numbers = charts.contact_numbers(run.columns)
    parts += [page.figure(numbers, source, "contact over t")] if numbers else []
    energy = charts.energies(run.columns)
    parts += [page.figure(energy, source + " What is stored, in the penalty and lost to friction makes up the work; "
                          "the imbalance is what is missing.", "energy over t")] if energy else []
    return page.section("curves", "Force and energy", *parts)


def _convergence(run):
    steps, failed = convergence.steps_of(run.summary, run.columns)
    bars, lines = charts.iterations(steps), charts.residuals(steps, failed)
    parts = [page.figure(bars, "Cost of each step; a number above a triangle counts the cuts before it.",
                         "iterations of each step")] if bars else []
    parts += [page.figure(lines, "Residuals of Newton's method, a line for each solve; attempts that were cut are among "
                          "those of their step.", "residuals")] if lines else []
    if steps and not bars:
        parts.append("<p>Every step converged where its prediction led: no Newton iteration was needed.</p>")
    if steps:
        rows = [(s["step"], s["t"], s["newton_iterations"], s["augmentations"], s["cut_backs"], _last_residual(s))
                for s in steps[-MOST_ROWS:]]
        parts.append(page.table(("step", "t", "Newton iterations", "augmentations", "cuts", "last residual"), rows))
    return page.section("convergence", "Convergence", *(parts or ["<p>No step has converged.</p>"]))


def _last_residual(step):
    solves = step.get("residuals") or [[]]
    return solves[-1][-1] if solves[-1] else ""


def _verify(run):
    entries = run.summary.get("verify", [])
    rows = [(e["name"], e["value"], e["expected"], e["tolerance"],
             [page.badge("ok", "ok") if e["ok"] else page.badge("failed", "failed")]) for e in entries]
    head = ("quantity", "value", "expected", "tolerance", "")
    return page.section("verify", "Comparisons of the deck", page.table(head, rows)) if entries else ""


def _contacts(run):
    parts = []
    for name, contact in run.summary.get("contact", {}).items():
        sides = f": {contact['primary']} on {contact['secondary']}" if "primary" in contact else ""
        rows = [("formulation", contact.get("formulation")), ("enforcement", contact.get("enforcement")),
                ("force on the primary", ", ".join(f"{x:.6g}" for x in contact.get("force", [])))]
        rows += [(label, contact[key]) for key, label in ENFORCED.items() if key in contact]
        choices = "".join(f"<pre>{page.text(line)}</pre>" for line in contact.get("choices", []))
        parts.append(f"<h3>{page.text(name)}{page.text(sides)}</h3>{choices}{page.table((), rows)}")
    for key, title in (("audit", "Audit of the contact"), ("model", "Choices of the model")):
        parts += _generic(run.summary.get(key), title)
    return page.section("model", "Contact and model choices", *parts) if parts else ""


def _generic(value, title):
    """Of a summary: an object as two columns, a list of objects as a table."""
    if not value:
        return []
    if isinstance(value, dict):
        return [f"<h3>{title}</h3>", page.table((), [(key, _plain(entry)) for key, entry in value.items()])]
    head = list(value[0])
    return [f"<h3>{title}</h3>", page.table(head, [[_plain(row.get(key, "")) for key in head] for row in value])]


def _plain(value):
    return value if isinstance(value, (int, float)) and not isinstance(value, bool) else str(value)


def _costs(run):
    phases = run.summary.get("phase_seconds")
    if not phases:
        return ""
    rows = [(name.replace("_", " "), f"{seconds:.3g} s") for name, seconds in phases.items()]
    for name, use in run.summary.get("linear_solver", {}).items():
        rows.append((f"linear solver: {name}", f"{use['systems']} systems, {use['iterations']} iterations, "
                     f"{use['setups']} setups, {use['seconds']:.3g} s"))
    return page.section("costs", "Where the time went", page.table((), rows))


def _files(run, place):
    rows = [("results for ParaView", str(part.path)) for part in run.results.parts[:8]]
    if len(run.results.parts) > 8:
        rows.append(("", f"and {len(run.results.parts) - 8} more, one of each rank"))
    rows += [("summary", str(run.summary_path))] if run.summary_path else []
    rows += [("history", str(run.history_path))] if run.history_path else []
    beside = run.path.resolve().parent
    others = sorted(path for path in beside.glob(f"{run.stem}.*") if path.suffix in (".csv", ".checkpoint")
                    and path.name != getattr(run.history_path, "name", ""))
    rows += [("beside them", str(run.path.parent / path.name)) for path in others]
    further = sorted(beside.glob(f"{run.stem}.exo-s*")) if run.path.name.endswith(".exo") else []
    rows += [("the run went on in", str(run.path.parent / path.name)) for path in further]
    return page.section("files", "Files", page.table((), rows + [("this report", str(place))]))


def _seconds(value):
    if value is None:
        return None
    return f"{value:.3g} s" if value < 120 else f"{value / 60:.1f} min"


def _megabytes(value):
    return None if value is None else f"{value:.0f} MB"
