#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Results must not depend on axes, units, numbering or place.

Two scenes whose supports fix whole faces, so that they can be turned. Each is changed, solved and
changed back; displacements, pressures and contact forces must agree and the counts be equal.
"""
import json
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy as np
import scenes

TOLERANCE = 1e-9
# Coordinates of size 1e6 L carry round-off 1e6 * 2^-53 L = 1.1e-10 L; the prescribed approach is
# about 0.03 L, so its relative error is some 4e-9 already.
FAR = 1e6
FAR_TOLERANCE = 2e-8


def blocks_scene():
    """A soft block cantilevered from one side face, pressed by a follower pressure and a shear on a
    stiffer block with another mesh."""
    options = {"lower_size": [1.4, 1.4, 0.6], "lower_divisions": [4, 4, 2],
               "upper_size": [1, 1, 0.6], "upper_divisions": [5, 5, 3]}
    deck = {
        "materials": {"soft": {"young": 1.0, "poisson": 0.3},
                      "stiff": {"young": 3.0, "poisson": 0.2}},
        "bodies": {"lower": {"blocks": ["lower"], "material": "stiff"},
                   "upper": {"blocks": ["upper"], "material": "soft"}},
        "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                          "side": {"set": "upper_x0", "x": 0.005, "y": 0.002, "z": -0.01}},
        "loads": {"press": {"side_set": "upper_top", "pressure": 0.05},
                  "shear": {"side_set": "upper_top", "traction": [0.004, 0.007, 0.0]}},
        "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top"}},
        "time": {"steps": 2},
    }
    return "blocks", options, deck


def sphere_scene():
    """A piece of a sphere held at its top, met by a rigid plate that also turns."""
    options = {"facets": 4, "core": 0.3}
    deck = {
        "materials": {"elastic": {"young": 1.0, "poisson": 0.3}},
        "bodies": {"sphere": {"blocks": ["sphere"], "material": "elastic"},
                   "plate": {"blocks": ["plate"],
                             "rigid": {"displacement": [0.002, 0.0, 0.03],
                                       "rotation": [0.0, 0.02, 0.0], "center": [0.1, 0.0, 0.0]}}},
        "displacements": {"top": {"set": "top", "fix": ["x", "y", "z"]}},
        "contact": {"pair": {"primary": "contact", "secondary": "plate_top",
                             "enforcement": "augmented_lagrangian"}},
        "newton": {"inexact": False},  # what multipliers take over from loose solves is not what is compared
        "time": {"steps": 2},
    }
    return "sphere_plane", options, deck


def mapped(deck, vector=None, point=None, length=1.0, stiffness=1.0):
    """The deck after x -> point(x), v -> vector(v), with other units of length and pressure."""
    vector = vector or (lambda v: v)
    point = point or vector
    out = json.loads(json.dumps(deck))
    for material in out["materials"].values():
        material["young"] *= stiffness
    for body in out["bodies"].values():
        if "rigid" in body:
            rigid = body["rigid"]
            rigid["displacement"] = list(length * vector(np.array(rigid["displacement"])))
            rigid["rotation"] = list(vector(np.array(rigid["rotation"])))
            rigid["center"] = list(point(length * np.array(rigid["center"])))
    for entry in out["displacements"].values():
        if "x" in entry:
            u = length * vector(np.array([entry["x"], entry["y"], entry["z"]]))
            entry.update(zip("xyz", u))
    for load in out.get("loads", {}).values():
        if "pressure" in load:
            load["pressure"] *= stiffness
        else:
            load["traction"] = list(stiffness * vector(np.array(load["traction"])))
    return out


class Solved:
    """A run, its fields in the node order of the mesh that went in."""

    def __init__(self, folder, mesh, deck):
        exodus_edit.write(folder / "scene_mesh.exo", mesh)
        deck = scenes.merged(deck, {"mesh": {"file": "scene_mesh.exo"}})
        result = scenes.run(deck, files=[folder / "scene_mesh.exo"])
        self.u = result.fields.vector("displacement")
        self.pressure = result.fields.nodal("contact_pressure")
        self.force = result.force()
        self.max_pressure = result.contact()["max_pressure"]
        summary = result.summary
        self.counts = {key: summary[key] for key in
                       ("steps", "newton_iterations", "augmentations", "cut_backs", "unknowns")}
        self.counts["active_points"] = result.contact()["active_points"]


class Invariance:
    """The checks; a subclass gives the scene."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="abut_invariance_")
        cls.path = pathlib.Path(cls.folder.name)
        kind, options, cls.deck = cls.scene()
        cls.mesh = exodus_edit.read(scenes.mesh(cls.path / "mesh.exo", kind, **options))
        cls.base = Solved(cls.path, cls.mesh, cls.deck)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def moved(self, x):
        return exodus_edit.ExodusMesh(x, self.mesh.blocks, self.mesh.node_sets,
                                      self.mesh.side_sets)

    def compare(self, solved, vector=None, length=1.0, stiffness=1.0, place=slice(None),
                tolerance=TOLERANCE):
        """vector: turns a vector of the base scene into one of the changed scene."""
        turn = vector or (lambda v: v)
        base = self.base
        pairs = {"displacement": (solved.u[place] / length, turn(base.u)),
                 "pressure": (solved.pressure[place] / stiffness, base.pressure),
                 "force": (solved.force / (stiffness * length**2), turn(base.force))}
        worst = {}
        for name, (got, expected) in pairs.items():
            worst[name] = np.abs(got - expected).max() / np.abs(expected).max()
        print(f"{self.id().split('.', 1)[-1]}: "
              + ", ".join(f"{name} {error:.1e}" for name, error in worst.items()))
        for name, error in worst.items():
            self.assertLess(error, tolerance, name)
        self.assertEqual(solved.counts, base.counts)

    def test_the_scene_is_worth_it(self):
        base = self.base
        self.assertGreater(base.counts["active_points"], 10)
        self.assertGreater(np.abs(base.force).max(), 1e-4)
        self.assertGreater(np.abs(base.u).max(), 0.01)
        # Uneven pressure, and part of the surface open.
        self.assertGreater(base.max_pressure, 1.5 * base.pressure[base.pressure > 0].mean())

    def test_rotation(self):
        for seed in (1, 2):
            q = exodus_edit.rotation(np.random.default_rng(seed))
            turn = lambda v, q=q: v @ q.T
            with self.subTest(seed=seed):
                self.compare(Solved(self.path, self.moved(turn(self.mesh.x)),
                                    mapped(self.deck, turn)), turn)

    def test_units(self):
        for length in (1e3, 1e-6):
            for stiffness in (1e6, 1e-6):
                with self.subTest(length=length, stiffness=stiffness):
                    deck = mapped(self.deck, length=length, stiffness=stiffness)
                    self.compare(Solved(self.path, self.moved(length * self.mesh.x), deck),
                                 length=length, stiffness=stiffness)

    def test_numbering(self):
        mesh, place = exodus_edit.permute(self.mesh, np.random.default_rng(3))
        self.assertFalse(np.array_equal(place, np.arange(len(place))))
        self.compare(Solved(self.path, mesh, self.deck), place=place)

    def test_side_order(self):
        self.compare(Solved(self.path, exodus_edit.reverse_sides(self.mesh), self.deck))

    def test_place(self):
        shift = FAR * np.array([1.0, -1.0, 1.0])
        deck = mapped(self.deck, point=lambda x: x + shift)
        self.compare(Solved(self.path, self.moved(self.mesh.x + shift), deck),
                     tolerance=FAR_TOLERANCE)


class Blocks(Invariance, unittest.TestCase):
    scene = staticmethod(blocks_scene)


class Sphere(Invariance, unittest.TestCase):
    scene = staticmethod(sphere_scene)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
