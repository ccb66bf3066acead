# SPDX-License-Identifier: BSD-3-Clause
"""Pressures of a paraboloid pressed on a plane, or on a second elastic body whose mesh does not fit.
usage: pressure_study.py [--abut PROGRAM] [--meshes 2 4] [--formulations ...] [--spaces ...] [--cases f10 f100 AL AL1]
                         [--element hex8] [--loads 1] [--set key=value ...] [--two-bodies RATIO:FACETS ...]

Meshes count facets for each contact radius a = 0.05. With more than one load the contact edge moves through one
facet and the errors are means over the loads (largest in brackets). Columns in per cent: facets (mean over points; L2
over all, r < 0.9 a; n-facet: mean of nodal values), nodal field (L2, inner, at the center), points, force, counts.
"""
import itertools

import numpy

import pressure_error
import scenes
import tables
import turned_block

RADIUS, CONTACT, APPROACH, POISSON = 1, 0.05, 0.0031, 0.3
SCORES = ("facet", "facet_inner", "nodal_facet", "nodal", "nodal_inner", "center", "point", "point_inner")


def case(name):
    """f10: penalty with that factor. AL10: multipliers with that factor; AL: down to a change of 1e-3."""
    if name == "AL":
        return {**case("AL10"), "multiplier_tolerance": 1e-3, "max_augmentations": 50}
    number = float(name.lstrip("fAL"))
    augmented = {"enforcement": "augmented_lagrangian"} if name.startswith("AL") else {}
    return {**augmented, "penalty_factor": number}


def loads(facets, count):
    """Approaches, growing. The last one is APPROACH if there is only one; a grows by one facet over several."""
    if count == 1:
        return [APPROACH]
    return [APPROACH * ((facets - 0.5 + (i + 0.5) / count) / facets)**2 for i in range(count)]


def deck(facets, element="hex8", approaches=(APPROACH,), steps=2, **options):
    """The last approaches are one step each, after steps - 1 to reach the first."""
    count = steps - 1 + len(approaches)
    curve = [[0, 0]] + [[(steps + i) / count, value / approaches[-1]] for i, value in enumerate(approaches)]
    fix = {"x0": ["x"], "y0": ["y"], "top": ["x", "y"]}
    displacements = {f"{name} fixed": {"set": name, "fix": axes} for name, axes in fix.items()}
    displacements["top"] = {"set": "top", "z": -approaches[-1], "curve": "press"}
    return {
        "mesh": {"generate": {"kind": "paraboloid", "radius": RADIUS, "core": 2 * CONTACT, "facets": 2 * facets,
                              "element": element}},
        "materials": {"rubber": {"model": "neo_hookean", "young": 1, "poisson": POISSON}},
        "bodies": {"plate": {"blocks": ["plate"], "rigid": {}}, "ball": {"blocks": ["paraboloid"], "material": "rubber"}},
        "displacements": displacements,
        "curves": {"press": curve},
        "contact": {"pair": {"primary": "contact", "secondary": "plate_top", **options}},
        "time": {"steps": count}, "output": {"points": True},
    }


def two_bodies(ratio, facets, plate_facets, stiff_primary=False, **more):
    """The plate is elastic, its modulus `ratio` times that of the ball, plate_facets to a contact radius.
    The approach is that of the same force on a rigid plate, shared by both."""
    scene = deck(facets, **more)
    scene["mesh"]["generate"]["plate_facets"] = round(2 * plate_facets)
    plate = {"model": "neo_hookean", "young": ratio, "poisson": POISSON}
    scene["materials"]["plate"] = plate
    scene["bodies"]["plate"] = {"blocks": ["plate"], "material": "plate"}
    scene["displacements"]["bottom"] = {"set": "plate_bottom", "fix": ["x", "y", "z"]}
    if stiff_primary:
        pair = scene["contact"]["pair"]
        pair["primary"], pair["secondary"] = pair["secondary"], pair["primary"]
    return scene


def modulus(scene):
    """E* of the two bodies of a scene."""
    return 1 / sum((1 - m["poisson"]**2) / m["young"] for m in scene["materials"].values())


class Scores:
    """Scores of the written steps from `first` on: arrays by name, and what the run took."""

    def __init__(self, scene, first=2, seconds=1800):
        result = scenes.run(scene, seconds=seconds, quiet=False)
        fields = result.fields
        points = list(pressure_error.read_points(next((result.folder / "results").glob("*.points.csv"))).values())
        side = scene["contact"]["pair"]["primary"]
        self.steps = []
        for step in range(first, len(fields.times)):
            facets = pressure_error.Facets(fields, ["paraboloid", "plate"], side, points[step], step)
            force = abs(fields.globals(step)["pair_force_z"])
            self.steps.append(pressure_error.HertzScore(facets, force, RADIUS, modulus(scene)))
        self.facets = facets
        self.summary, self.seconds = result.summary, result.seconds
        self.force = self.steps[-1].force

    def __getattr__(self, name):
        return numpy.array([getattr(step, name) for step in self.steps])

    def __str__(self):
        cells = []
        for name in SCORES:
            values = 100 * getattr(self, name)
            cells.append(f"{values.mean():7.2f}" + (f" ({numpy.abs(values).max():5.1f})" if len(values) > 1 else ""))
        s = self.summary
        return ("".join(cells) + f"  a/h {self.facets_per_radius[-1]:.2f}  F {self.force:.6e}  newton {s['newton_iterations']} "
                f"augmentations {s['augmentations']}  penetration {s['contact']['pair']['max_penetration_over_face_size']:.1e}"
                f"  unknowns {s['unknowns']}  {self.seconds:.0f} s")


def main():
    parser = tables.parser(__doc__, turned_block.FORMULATIONS)
    parser.add_argument("--meshes", type=int, nargs="+", default=[2, 4])
    parser.add_argument("--cases", nargs="+", default=["f10", "f100", "AL"])
    parser.add_argument("--element", default="hex8")
    parser.add_argument("--loads", type=int, default=1)
    parser.add_argument("--two-bodies", nargs="+", default=[], metavar="RATIO:FACETS")
    parser.add_argument("--stiff-primary", action="store_true")
    known = tables.parse(parser)
    print(f"{'':50s}" + "".join(f"{name:>{7 if known.loads == 1 else 15}s}" for name in
                                 ("facet", "inner", "n-facet", "nodal", "inner", "center", "points", "inner")))
    for formulation, space, word, mesh in itertools.product(known.formulations, known.spaces, known.cases, known.meshes):
        options = {"formulation": formulation, **case(word), "multipliers": space, **known.more}
        scene_options = {"element": known.element, "approaches": loads(mesh, known.loads), **options}
        scene_list = [(two_bodies(float(b.split(":")[0]), mesh, float(b.split(":")[1]), known.stiff_primary,
                                  **scene_options), b) for b in known.two_bodies] or [(deck(mesh, **scene_options), "")]
        for scene, name in scene_list:
            tables.row(f"{formulation} {space} {word} {name} nf={mesh}", 50, lambda: Scores(scene))


if __name__ == "__main__":
    main()
