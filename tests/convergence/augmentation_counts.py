# SPDX-License-Identifier: BSD-3-Clause
"""Linear solves that multipliers cost over penalty alone, down to a gap of 1e-4 face sizes.
usage: augmentation_counts.py [--abut PROGRAM] [--scenes paraboloid block hard_block covered_block] [--spaces ...] [--factors 1 10 100]
                              [--formulations facet_on_facet] [--gap 1e-4] [--set key=value ...]

paraboloid: a cold start, the whole approach in one step, 2 facets to the contact radius. block: a small cube on a
larger one in five steps, the softer and coarser side below is the primary, partly covered; hard_block: the stiffer and
finer one is; covered_block: moduli exchanged, the softer and finer one above is.
The gap is the largest weighted one at nodes whose faces are closed (means with the corner functions; with their dual
basis for dual multipliers), over the face size.
"""
import itertools
import re

import pressure_error
import pressure_study
import scenes
import tables


def block_on_block(lower=8, upper=7, upper_primary=False, moduli=(1, 4), **options):
    sides = ["upper_bottom", "lower_top"]
    primary, secondary = sides if upper_primary else sides[::-1]
    rubber = {"model": "neo_hookean", "poisson": 0.3}
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_divisions": [lower] * 3, "upper_size": [0.6] * 3,
                              "upper_divisions": [upper] * 3}},
        "materials": {name: {**rubber, "young": e} for name, e in zip(("lower", "upper"), moduli)},
        "bodies": {"lower": {"blocks": ["lower"], "material": "lower"},
                   "upper": {"blocks": ["upper"], "material": "upper"}},
        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "top sides": {"set": "upper_top", "fix": ["x", "y"]},
                          "top": {"set": "upper_top", "z": -0.1}},
        "contact": {"pair": {"primary": primary, "secondary": secondary, **options}},
        "time": {"steps": 5}, "output": {"points": True},
    }


SCENES = {
    "paraboloid": (lambda **o: pressure_study.deck(2, steps=1, **o), ["paraboloid", "plate"]),
    "paraboloid4": (lambda **o: pressure_study.deck(4, steps=1, **o), ["paraboloid", "plate"]),
    "block": (block_on_block, ["lower", "upper"]),
    "hard_block": (lambda **o: block_on_block(upper_primary=True, **o), ["lower", "upper"]),
    "covered_block": (lambda **o: block_on_block(upper_primary=True, moduli=(4, 1), **o), ["lower", "upper"]),
}


class Count:
    """Solves and augmentations of each step, and the weighted gap at the end."""

    def __init__(self, name, **options):
        make, blocks = SCENES[name]
        scene = make(**options)
        result = scenes.run(scene, seconds=900, quiet=False)
        self.summary = result.summary
        self.solves = sum(used["solves"] for used in result.summary["linear_solver"].values())
        self.newton = [int(n) for n in re.findall(r"^step\s.*?\s(\d+) iterations", result.output, re.M)]
        self.augmentations = [int(n) for n in re.findall(r"^step\s.*?\s(\d+) augmentations", result.output, re.M)]
        *_, points = pressure_error.read_points(next((result.folder / "results").glob("*.points.csv"))).values()
        facets = pressure_error.Facets(result.fields, blocks, scene["contact"]["pair"]["primary"], points)
        self.gap = pressure_error.weighted_gaps(facets, options.get("multipliers") == "dual")
        self.penetration = result.contact()["max_penetration_over_face_size"]

    def __str__(self):
        return (f"solves {self.solves:4d}  newton {'+'.join(map(str, self.newton)):>16s}  "
                f"augmentations {'+'.join(map(str, self.augmentations)):>12s}  "
                f"gap {self.gap:.1e}  penetration {self.penetration:.1e}")


def main():
    parser = tables.parser(__doc__, ["facet_on_facet"])
    parser.add_argument("--scenes", nargs="+", default=["paraboloid", "block", "hard_block", "covered_block"], choices=list(SCENES))
    parser.add_argument("--factors", type=float, nargs="+", default=[1, 10, 100])
    parser.add_argument("--gap", type=float, default=1e-4)
    known = tables.parse(parser)
    augmented = {"enforcement": "augmented_lagrangian", "multiplier_tolerance": 1e6, "gap_tolerance": known.gap,
                 "max_augmentations": 50}
    for name, formulation, space, factor in itertools.product(known.scenes, known.formulations, known.spaces, known.factors):
        for enforcement in ({}, augmented):
            options = {"formulation": formulation, "penalty_factor": factor, **enforcement,
                       "multipliers": space, **known.more}
            label = f"{name} {formulation} {space} f={factor:g} {'AL' if enforcement else 'penalty'}"
            tables.row(label, 60, lambda: Count(name, **options))


if __name__ == "__main__":
    main()
