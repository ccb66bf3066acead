# SPDX-License-Identifier: BSD-3-Clause
"""Phase times of whole scenes, of one program or of two in turn.
usage: bench.py [--abut PROGRAM] [--against PROGRAM] [--scenes facet_friction ...] [--runs 5] [--size 1]
                [--ranks 1] [--output FOLDER]

Each scene of bench_scenes.py is run --runs times; with --against each run is followed by one of the
other program, so that a machine that is now fast and now slow favours none. Times are seconds on the processor: a
phase's wall seconds times the part of its run in which the program had a processor. `share` is of the whole program,
`ratio` that of the first program over the other one's, of the least times and of the medians. Where the two needed
different numbers of linear solves the ratios are those of the times per solve, and a line says so.
FOLDER/scenes.json holds every run.
"""
import argparse
import json
import pathlib
import resource
import shutil
import statistics

import bench_scenes
import scenes

COUNTS = ("newton_iterations", "augmentations", "linear_iterations", "cut_backs")
PHASES = ("search", "contact", "solid", "assembly", "linear_solve")
BOTH, WHOLE = "search + contact", "program"
ROWS = ("search", "contact", BOTH, "solid", "assembly", "linear_solve", WHOLE)


class Run:
    """What one run counted and how long it was on the processor [s]."""

    def __init__(self, program, deck, seconds, ranks):
        scenes.EXECUTABLE = str(program)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        result = scenes.run(deck, ranks=ranks, seconds=seconds)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.processor = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
        self.wall = result.seconds
        self.unknowns = result.summary["unknowns"]
        self.active_points = sum(c["active_points"] for c in result.summary["contact"].values())
        self.counts = {key: result.summary[key] for key in COUNTS}
        had = min(1.0, self.processor / (ranks * self.wall))
        self.seconds = {phase: had * result.summary["phase_seconds"][phase] for phase in PHASES}
        self.seconds[BOTH] = self.seconds["search"] + self.seconds["contact"]
        self.seconds[WHOLE] = self.processor


class Comparison:
    """Runs of one scene: (programs)(runs)."""

    def __init__(self, deck, programs, runs, seconds, ranks):
        self.runs = [[] for _ in programs]
        for _ in range(runs):
            for made, program in zip(self.runs, programs):
                made.append(Run(program, deck, seconds, ranks))

    @property
    def same_counts(self):
        return all(made[0].counts == self.runs[0][0].counts for made in self.runs)

    def seconds(self, program, row, of=min):
        return of(run.seconds[row] for run in self.runs[program])

    def ratio(self, row, of=min):
        """First program over the second, per linear solve if these differ; None without a second."""
        if len(self.runs) < 2:
            return None
        first, second = (self.seconds(i, row, of) / (1 if self.same_counts else made[0].counts["linear_iterations"])
                         for i, made in enumerate(self.runs))
        return first / second if second > 0 else None

    def record(self):
        return {"programs": [[vars(run) for run in made] for made in self.runs], "same_counts": self.same_counts,
                "ratios": {row: {"of_least": self.ratio(row), "of_medians": self.ratio(row, statistics.median)}
                           for row in ROWS} if len(self.runs) > 1 else {}}

    def lines(self, name):
        first = self.runs[0][0]
        yield f"{name}: {first.unknowns} unknowns, {first.active_points} active points"
        for label, made in zip(("", "against: "), self.runs):
            if not label or not self.same_counts:
                yield "  " + label + ", ".join(f"{n} {key.replace('_', ' ')}" for key, n in made[0].counts.items())
        if not self.same_counts:
            yield "  the numbers of iterations differ: ratios are per linear solve"
        titles = ["least", "median", "share"] + ["against", "median", "ratio", "medians"] * (len(self.runs) > 1)
        yield f"  {'seconds':16s}" + "".join(f"{title:>9s}" for title in titles)
        for row in ROWS:
            yield f"  {row:16s}" + "".join(self.cells(row))

    def cells(self, row):
        median = statistics.median
        yield f"{self.seconds(0, row):9.3f}{self.seconds(0, row, median):9.3f}"
        yield f"{self.seconds(0, row) / self.seconds(0, WHOLE):9.0%}"
        if len(self.runs) > 1:
            yield f"{self.seconds(1, row):9.3f}{self.seconds(1, row, median):9.3f}"
            for ratio in (self.ratio(row), self.ratio(row, median)):
                yield f"{ratio:9.3f}" if ratio else f"{'':9s}"


def found(program):
    """Its path: runs have a working folder of their own."""
    path = shutil.which(program)
    if path is None:
        raise SystemExit(f"bench.py: no program '{program}'")
    return pathlib.Path(path).resolve()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--abut", default=scenes.EXECUTABLE)
    parser.add_argument("--against", help="another build of the program")
    parser.add_argument("--scenes", nargs="+", default=list(bench_scenes.SCENES), choices=list(bench_scenes.SCENES),
                        metavar="SCENE", help=", ".join(bench_scenes.SCENES))
    parser.add_argument("--runs", type=int, default=5, help="of each scene and program")
    parser.add_argument("--size", type=float, default=1.0, help="multiplies the cells along an edge")
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=600.0, help="time limit of a run")
    parser.add_argument("--output", type=pathlib.Path, help="folder of scenes.json")
    known = parser.parse_args()
    programs = [found(program) for program in (known.abut, known.against) if program]
    records = {}
    for name in known.scenes:
        comparison = Comparison(bench_scenes.SCENES[name](known.size), programs, known.runs, known.seconds, known.ranks)
        print("\n".join(comparison.lines(name)), flush=True)
        records[name] = comparison.record()
    if known.output:
        known.output.mkdir(parents=True, exist_ok=True)
        (known.output / "scenes.json").write_text(json.dumps(records, indent=1) + "\n")


if __name__ == "__main__":
    main()
