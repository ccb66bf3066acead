# SPDX-License-Identifier: BSD-3-Clause
"""Failed steps and linear solves of a block pressed, sheared and turned on a rough plate.
usage: turned_block.py [--abut PROGRAM] [--factors 1 10 100 1000] [--formulations ...] [--spaces ...]
                       [--switching ...] [--enforcements ...] [--set key=value ...]

A step that fails is cut, so that the rest of the path is still seen: `2 of 12 fail` counts the steps of the deck
that did not converge at once, `stops at 7` that no cut helped. The other cells hold linear solves for each step,
the predictor's included, and in brackets those of the worst step.
"""
import itertools
import pathlib
import re

import scenes
import tables

DECK = pathlib.Path(__file__).resolve().parents[2] / "input/friction_switching/turned_block.yaml"
STEPS = 12
FORMULATIONS = ("node_on_facet", "facet_on_facet", "sliding_elastic")
ENFORCEMENTS = ("penalty", "augmented_lagrangian")


def deck(options, adaptive=False):
    """The deck with more options of its interface."""
    text = DECK.read_text()
    for old, new in (("friction: 0.3}", "friction: 0.3, " + ", ".join(f"{k}: {v}" for k, v in options.items()) + "}"),
                     ("adaptive: false", f"adaptive: {str(adaptive).lower()}, max_cuts: 3")):
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    return re.sub(r"^verify:.*", "", text, flags=re.S | re.M)


class Count:
    """What a run took: solves of each step of the deck, the failed ones, where it stopped."""

    def __init__(self, result):
        failed = {float(t) for t in re.findall(r"The step to t = (\S+) is cut", result.output)}
        self.failed = len({-int(-t * STEPS // 1) for t in failed})
        reached = re.findall(r"^step\s+\d+\s+t = (\S+)", result.output, re.M)
        self.stopped = 0 if result.status == 0 else int(float(reached[-1]) * STEPS + 1e-6) + 1 if reached else 1
        # Newton's iterations and the predictor of each solved step; cut steps are in the total alone
        self.steps = [int(n) + 1 for n in re.findall(r"^step\s.*?\s(\d+) iterations", result.output, re.M)]
        self.residuals = re.findall(r"newton\s+\d+\s+residual (\S+)", result.output)
        self.augmentations = [int(n) for n in re.findall(r"^step\s.*?\s(\d+) augmentations", result.output, re.M)]
        self.result = result

    @property
    def mean(self):
        return sum(self.steps) / STEPS

    def __str__(self):
        if self.stopped:
            return f"stops at {self.stopped}"
        if self.failed:
            return f"{self.failed} of {STEPS} fail"
        return f"{self.mean:.2f} ({max(self.steps)})"


def run(options, adaptive=True, seconds=300):
    return Count(scenes.run(deck(options, adaptive), seconds=seconds, quiet=False, check=False))


def main():
    parser = tables.parser(__doc__, FORMULATIONS)
    parser.add_argument("--factors", type=float, nargs="+", default=[1, 10, 100, 1000])
    parser.add_argument("--enforcements", nargs="+", default=ENFORCEMENTS)
    parser.add_argument("--switching", nargs="+")
    known = tables.parse(parser)
    keys = {"formulation": known.formulations, "enforcement": known.enforcements, "multipliers": known.spaces,
            "friction_switching": known.switching or scenes.words_of("friction_switching")}
    print(f"{'':76s}" + "".join(f"{'f = %g' % f:>16s}" for f in known.factors))
    for words in itertools.product(*keys.values()):
        row = []
        for factor in known.factors:
            options = {**dict(zip(keys, words)), "penalty_factor": factor, **known.more}
            row.append(run(options))
        print(f"{' '.join(words):76s}" + "".join(f"{str(cell):>16s}" for cell in row), flush=True)


if __name__ == "__main__":
    main()
