# SPDX-License-Identifier: BSD-3-Clause
"""How uniform a uniform pressure comes out through flat meshes that do not fit.
usage: pressure_ratios.py [--abut PROGRAM] [--ratios 8:7 5:8 ...] [--elements hex8 hex20 tet10] [--spaces ...]
                          [--cases f1 f10 f100 AL1 AL10 AL] [--formulations facet_on_facet] [--set key=value ...]

Ratios are faces of the primary to faces of the secondary along an edge of the unit square. Cells: root mean square
(largest) deviation from the mean in per cent, of the points, of the nodal pressure.
"""
import itertools

import numpy

import contact_patch_test
import pressure_error
import scenes
import tables

LOAD = contact_patch_test.P0
MULTIPLIERS = {"enforcement": "augmented_lagrangian", "max_augmentations": 200}
CASES = {
    "f1": {"penalty_factor": 1},
    "f10": {"penalty_factor": 10},
    "f100": {"penalty_factor": 100},
    "AL1": {"penalty_factor": 1, **MULTIPLIERS},
    "AL10": {"penalty_factor": 10, **MULTIPLIERS},
    "AL": {"penalty_factor": 10, "multiplier_tolerance": 1e-5, **MULTIPLIERS},
}


def scene(primary, secondary, element="hex8", young=(1.0, 1.0), **options):
    deck = contact_patch_test.scene(primary, secondary, poisson=0.3, element=element, young=young)
    del deck["verify"]
    deck["contact"]["pair"].update(options)
    deck["newton"]["tolerance"] = 1e-10
    deck["output"] = {"points": True}
    return deck


class Deviation:
    """Deviations of the points' and the nodal pressure from the load: root mean squares and largest values [1]."""

    def __init__(self, deck, seconds=600):
        result = scenes.run(deck, seconds=seconds, quiet=False)
        *_, last = pressure_error.read_points(next((result.folder / "results").glob("*.points.csv"))).values()
        facets = pressure_error.Facets(result.fields, ["lower", "upper"], "upper_bottom", last)
        self.points = self.of(facets.point_p / LOAD - 1)
        self.nodal = self.of(numpy.unique(numpy.stack([facets.corners.ravel(), facets.nodal.ravel()]), axis=1)[1]
                             / LOAD - 1)
        self.facets = self.of(facets.mean / LOAD - 1)
        self.facet_data = facets
        self.active = result.contact()["active_points"]
        self.all_points = facets.point_p.size
        self.summary, self.seconds, self.fields = result.summary, result.seconds, result.fields

    @staticmethod
    def of(deviation):
        return float(numpy.sqrt(numpy.mean(deviation**2))), float(numpy.max(numpy.abs(deviation)))

    def __str__(self):
        return "  ".join(f"{100 * rms:6.2f} ({100 * most:6.2f})" for rms, most in (self.points, self.nodal)) + \
            f"  newton {self.summary['newton_iterations']} augmentations {self.summary['augmentations']}"


def main():
    parser = tables.parser(__doc__, ["facet_on_facet"])
    parser.add_argument("--ratios", nargs="+", default=["8:7", "12:8", "5:8", "8:27", "27:8"])
    parser.add_argument("--elements", nargs="+", default=["hex8"])
    parser.add_argument("--cases", nargs="+", default=list(CASES))
    known = tables.parse(parser)
    print(f"{'':60s}{'points':^17s}{'nodal':^17s}")
    for element, formulation, space, case, ratio in itertools.product(
            known.elements, known.formulations, known.spaces, known.cases, known.ratios):
        primary, secondary = map(int, ratio.split(":"))
        options = {"formulation": formulation, **CASES[case], "multipliers": space, **known.more}
        tables.row(f"{element} {formulation} {space} {case} {ratio}", 60,
                   lambda: Deviation(scene(primary, secondary, element, **options)))


if __name__ == "__main__":
    main()
