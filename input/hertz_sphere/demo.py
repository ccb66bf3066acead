#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Hertz deck, prints its errors, draws the pressure beside the exact curve and writes a report."""
import argparse
import json
import os
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "apps" / "python"))
from abut.results import Results

RADIUS = 0.05  # of the contact
PEAK = 0.03497911  # of the pressure


def run(program, ranks, folder):
    """Solves the deck; returns its summary."""
    environment = dict(
        os.environ,
        OMP_NUM_THREADS="1",
        OPENBLAS_NUM_THREADS="1",
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    )
    summary = folder / "summary.json"
    command = [
        "mpiexec", "--oversubscribe", "-np", str(ranks), program, "run",
        str(HERE / "hertz_sphere.yaml"), "--output-dir", str(folder), "--summary", str(summary),
    ]
    status = subprocess.call(command, env=environment)
    if status != 0:
        sys.exit(status)
    return json.loads(summary.read_text())


def pressures(exodus):
    """Radius and contact pressure of the sphere's nodes that carry some, at the last step."""
    results = Results(exodus)
    sphere, pressure = results.node_set("contact"), results.nodal("contact_pressure")
    touched = sphere[pressure[sphere] > 0]
    x = (results.coordinates + results.vector("displacement"))[touched]
    return np.hypot(x[:, 0], x[:, 1]), pressure[touched]


def draw(exodus, picture):
    """Computed nodal pressure over the radius, with Hertz's curve."""
    r, p = pressures(exodus)
    exact = np.linspace(0, RADIUS, 400)
    figure, axes = plt.subplots(figsize=(6.4, 4))
    axes.plot(r / RADIUS, p / PEAK, ".", markersize=4, color="tab:blue", label="abut, nodes")
    axes.plot(exact / RADIUS, np.sqrt(1 - (exact / RADIUS) ** 2), color="black", linewidth=1,
              label="Hertz")
    axes.set_xlabel("radius / contact radius")
    axes.set_ylabel("contact pressure / peak pressure")
    axes.set_title("Elastic sphere on a rigid plane, 16 facets per contact radius")
    axes.set_xlim(0, 1.2)
    axes.set_ylim(0, 1.15)
    axes.grid(alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(picture, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--abut", required=True, help="the program")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--output-dir", default="results/hertz_sphere")
    arguments = parser.parse_args()
    folder = pathlib.Path(arguments.output_dir)
    folder.mkdir(parents=True, exist_ok=True)
    program = str(pathlib.Path(arguments.abut).resolve())
    summary = run(program, arguments.ranks, folder)
    exodus, picture = folder / "hertz_sphere.exo", folder / "pressure.png"
    draw(exodus, picture)
    print(f"\n{'quantity':<16} {'abut':>12} {'Hertz':>12} {'error':>8}")
    for entry in summary["verify"]:
        error = entry["value"] / entry["expected"] - 1
        print(f"{entry['name']:<16} {entry['value']:>12.6g} {entry['expected']:>12.6g} {error:>+8.2%}")
    print(f"\nsolved in {summary['wall_seconds']:.1f} s on {summary['ranks']} ranks, "
          f"{summary['unknowns']} unknowns")
    print(f"results for ParaView: {exodus}\npicture:              {picture}")
    sys.stdout.flush()
    if subprocess.call([program, "report", str(exodus)]) != 0:  # says itself where the page is, or why there is none
        sys.exit("the report was not written")
    if not all(entry["ok"] for entry in summary["verify"]):
        sys.exit("the result is not within the tolerances of the deck")


if __name__ == "__main__":
    main()
