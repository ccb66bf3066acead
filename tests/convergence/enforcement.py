# SPDX-License-Identifier: BSD-3-Clause
"""What penalty and multipliers make of scenes of several kinds: error, what the run states of it, and what it takes.
usage: enforcement.py [--abut PROGRAM] [--scenes ...] [--set key=value ...]

A row of Markdown for each scene: the error of a force, in brackets the penalty_error that the run states, Newton
iterations and seconds. The reference is the exact force where there is one, else that of multipliers at points on the
same mesh, closed with eight augmentations or more.
"""
import argparse

import cold_start_test
import scenes

WAYS = {
    "penalty": {},
    "penalty, f = 100": {"penalty_factor": 100},
    "per_point": {"enforcement": "augmented_lagrangian", "multipliers": "per_point"},
    "dual": {"enforcement": "augmented_lagrangian", "multipliers": "dual"},
}
CLOSED = {"enforcement": "augmented_lagrangian", "multipliers": "per_point", "min_augmentations": 8}
ELASTIC = {"model": "linear_elastic", "young": 1.0, "poisson": 0.3}


def pressed(lower, upper, approach, material, sizes=((1, 1, 1), (1, 1, 1)), **contact):
    """Two blocks, the upper one pressed down."""
    return {
        "mesh": {"generate": {"kind": "blocks", "lower_size": list(sizes[0]), "lower_divisions": list(lower),
                              "upper_size": list(sizes[1]), "upper_divisions": list(upper)}},
        "materials": {"elastic": material},
        "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("lower", "upper")},
        "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "head": {"set": "upper_top", "fix": ["x", "y"], "z": -approach}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
    }


def blocks(**contact):
    return pressed((4, 4, 4), (6, 6, 6), 0.01, {**ELASTIC, "poisson": 0.0}, **contact)


def stiff_stack(**contact):
    """One element deep each, pressed by a hundred thousandth of it."""
    return pressed((2, 2, 1), (3, 3, 1), 1e-5, {**ELASTIC, "young": 2e5, "poisson": 0.0}, **contact)


def rubber(**contact):
    """Nearly incompressible, squeezed by 30 %, with friction."""
    deck = pressed((1, 1, 1), (6, 6, 4), 1.8, {"model": "mooney_rivlin", "c1": 0.5, "bulk": 1000},
                   ((12, 12, 1), (10, 10, 6)), friction=0.3, **contact)
    deck["bodies"]["lower"] = {"blocks": ["lower"], "rigid": {}}
    del deck["displacements"]["foot"]
    return {**deck, "time": {"steps": 10}}


def cylinders(**contact):
    return cold_start_test.deck(0.005, 12, **contact)


def sphere(**contact):
    return {
        "mesh": {"generate": {"kind": "sphere_plane", "facets": 6, "core": 0.1, "growth": 2, "max_size": 0.4}},
        "materials": {"elastic": ELASTIC},
        "bodies": {"body": {"blocks": ["sphere"], "material": "elastic"},
                   "plate": {"blocks": ["plate"], "rigid": {"displacement": [0, 0, 0.0025]}}},
        "displacements": {name: {"set": name, "fix": [axis]}
                          for name, axis in (("x0", "x"), ("y0", "y"), ("top", "z"))},
        "contact": {"pair": {"primary": "contact", "secondary": "plate_top", **contact}},
    }


def press_fit(**contact):
    return {
        "mesh": {"generate": {"kind": "rings", "inner_radius": 20, "interface_radius": 30, "outer_radius": 45,
                              "thickness": 5, "inner_theta": 16, "outer_theta": 24, "inner_r": 6, "outer_r": 8}},
        "materials": {"steel": {**ELASTIC, "young": 210000}},
        "bodies": {name: {"blocks": [name], "material": "steel"} for name in ("inner", "outer")},
        "displacements": {name: {"set": name, "fix": [name[0]]} for name in ("x0", "y0", "z0")},
        "contact": {"pair": {"primary": "inner_outer", "secondary": "outer_inner", "interference": 0.05, **contact}},
    }


def slope(**contact):
    """A block pressed on a plane and pushed along it until it slides."""
    deck = pressed((4, 4, 1), (3, 3, 2), 0, ELASTIC, ((3, 3, 1), (1, 1, 0.25)), friction=0.3, **contact)
    deck["bodies"]["lower"] = {"blocks": ["lower"], "rigid": {}}
    deck["displacements"] = {"guide": {"set": "upper_top", "x": 0.01, "y": 0, "curve": "slide"}}
    deck["loads"] = {"weight": {"block": "upper", "body_force": [-4e-5, 0, -4e-4], "curve": "weight"}}
    deck["curves"] = {"weight": [[0, 0], [0.25, 1]], "slide": [[0.25, 0], [1, 1]]}
    return {**deck, "time": {"steps": 4}}


def beam(**contact):
    """A heavy beam lifted from a rigid floor at its end."""
    deck = pressed((1, 1, 1), (40, 1, 1), 0, {**ELASTIC, "poisson": 0.0}, ((2.1, 0.04, 0.1), (2, 0.02, 0.02)),
                   **contact)
    deck["mesh"]["generate"]["element"] = "hex20"
    deck["bodies"]["lower"] = {"blocks": ["lower"], "rigid": {}}
    deck["displacements"] = {"far": {"set": "upper_x0", "fix": ["x"]}, "front": {"set": "upper_y0", "fix": ["y"]},
                             "lifted": {"set": "upper_x1", "z": 0.01}}
    deck["loads"] = {"weight": {"block": "upper", "body_force": [0, 0, -3.8580247e-6], "curve": "weight"}}
    return {**deck, "curves": {"weight": [[0, 1], [1, 1]]}}


def iron(**contact):
    """A block ten times as stiff pressed into a soft one and drawn along it."""
    deck = pressed((10, 4, 3), (3, 4, 3), 0.05, {**ELASTIC, "model": "neo_hookean"}, ((3, 1, 1), (0.9, 0.8, 0.8)),
                   friction=0.2, **contact)
    deck["mesh"]["generate"]["shift"] = 0.3
    deck["materials"]["hard"] = {"young": 10.0, "poisson": 0.3}
    deck["bodies"]["upper"]["material"] = "hard"
    deck["contact"]["pair"].update(primary="lower_top", secondary="upper_bottom")
    deck["displacements"]["head"] = {"set": "upper_top", "y": 0, "z": -0.05, "curve": "press"}
    deck["displacements"]["draw"] = {"set": "upper_top", "x": 1.0, "curve": "draw"}
    deck["curves"] = {"press": [[0, 0], [0.2, 1]], "draw": [[0.2, 0], [1, 1]]}
    return {**deck, "time": {"steps": 10}}


SCENES = {  # deck, exact force or None, its component
    "blocks of the README": (blocks, 0.005, 2),
    "stiff stack": (stiff_stack, 1.0, 2),
    "rubber block": (rubber, None, 2),
    "two cylinders": (cylinders, None, 2),
    "sphere on a plane": (sphere, None, 2),
    "press fit": (press_fit, None, 0),
    "block on a slope": (slope, -0.3e-4, 0),
    "beam lifted off": (beam, 2.1604938e-9, 2),
    "iron drawn": (iron, None, 0),
}


class Row:
    """Runs of one scene in all ways."""

    def __init__(self, name, more):
        make, exact, component = SCENES[name]
        self.name = name
        self.component = component
        runs = {way: self.run(make, {**options, **more}) for way, options in WAYS.items()}
        if exact is None:
            exact = self.force(self.run(make, {**CLOSED, **more}))
        self.cells = {way: self.cell(run, exact) for way, run in runs.items()}

    @staticmethod
    def run(make, options):
        return scenes.run(make(**options), seconds=600, check=False)

    def force(self, run):
        return run.force()[self.component]

    def cell(self, run, exact):
        s = run.summary
        if run.status != 0:
            return f"stops, {s['newton_iterations']} it." if s else "stops"
        cuts = f", {s['cut_backs']} cuts" if s["cut_backs"] else ""
        error = 100 * abs(self.force(run) / exact - 1)
        stated = 100 * s["penalty_error"]
        return f"{error:.2g} % ({stated:.2g}), {s['newton_iterations']}{cuts}, {s['wall_seconds']:.1f} s"

    def __str__(self):
        return f"| {self.name} | " + " | ".join(self.cells.values()) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--abut", default=scenes.EXECUTABLE)
    parser.add_argument("--scenes", nargs="+", default=list(SCENES), choices=list(SCENES))
    parser.add_argument("--set", nargs="+", default=[], metavar="KEY=VALUE")
    known = parser.parse_args()
    scenes.EXECUTABLE = known.abut
    print("| scene | " + " | ".join(WAYS) + " |\n" + "|---" * (1 + len(WAYS)) + "|")
    for name in known.scenes:
        print(Row(name, scenes.settings(known.set)), flush=True)


if __name__ == "__main__":
    main()
