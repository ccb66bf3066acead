#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies, joints and dynamics in pieces."""
import pathlib
import shutil
import tempfile
import unittest
from math import pi

import chain
import exodus_edit
import scenes
from contact_restart_test import with_contact
from mechanisms import FREE, bar, free_body, hinge, mesh_of

TOLERANCE = 1e-12


def kind_of(name):
    """force of upper_force_x: what sizes are compared in."""
    return (name[:-2] if name[-2:] in ("_x", "_y", "_z") else name).rsplit("_", 1)[-1]


class Bodies(chain.Restarted):
    def pieces_are_the_whole(self, label, deck, vectors=("displacement",), files=()):
        whole = chain.one_piece(deck, files=files)
        pieces = chain.in_pieces(deck, files=files)
        most = self.same_end(whole, pieces[-1], TOLERANCE, vectors=vectors)
        self.same_course(whole, pieces, TOLERANCE)
        last, there = whole.fields.globals(), pieces[-1].fields.globals()
        size = {}
        for name, value in last.items():
            size[kind_of(name)] = max(size.get(kind_of(name), 1e-12), abs(value))
        for name, value in last.items():
            self.assertAlmostEqual(there[name], value, delta=10 * TOLERANCE * size[kind_of(name)], msg=name)
        print(f"{label}: difference {most:.1e}, {whole.summary['newton_iterations']} iterations", flush=True)
        return whole

    def rigid_upper(self, **rigid):
        deck = scenes.merged(with_contact(friction=0.3, penalty=20), {
            "displacements": {"press": None, "slide": None},
            "bodies": {"upper": {"material": None, "rigid": {"center": [1, 0.5, 0.7], **rigid}}}})
        return deck

    def test_rigid_body_under_forces(self):
        """Unknown rotations about all axes, which add up over steps; a hold that begins on the way."""
        deck = self.rigid_upper(free=FREE, force=[0.004, 0.002, -0.05], moment=[0.002, 0.001, 0.004],
                                holds={"late": {"x": 0.01, "from": 0.375, "relative": True}})
        whole = self.pieces_are_the_whole("rigid body", deck)
        self.assertGreater(abs(whole.summary["rigid_bodies"]["upper"]["rotation"][2]), 1e-4)

    def test_linkage(self):
        """More than a whole turn: angles that only the course of the run knows."""
        a, b, c, d = (0.0, 0.0), (0.8, 0.6), (3.0, 2.4), (3.5, 0.0)
        mesh = mesh_of({"crank": bar(a, b), "coupler": bar(b, c), "rocker": bar(d, c)})
        deck = {
            "mesh": {"file": "linkage.exo"},
            "bodies": {"crank": free_body("crank", (0.1, 0.2)), "coupler": free_body("coupler", b),
                       "rocker": free_body("rocker", c, moment=[0, 0, 7.0], load_curve="one")},
            "joints": {"drive": hinge("revolute", ["ground", "crank"], a, rotation=2.5 * pi),
                       "b": hinge("revolute", ["crank", "coupler"], b),
                       "c": hinge("spherical", ["coupler", "rocker"], c),
                       "d": hinge("cylindrical", ["ground", "rocker"], d)},
            "curves": {"one": [[0, 1], [1, 1]]}}
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        exodus_edit.write(folder / "linkage.exo", mesh)
        whole = self.pieces_are_the_whole("linkage", deck, files=[folder / "linkage.exo"])
        self.assertGreater(whole.summary["joints"]["drive"]["rotation"], 2.4 * pi)

    def dynamic(self, radius):
        return scenes.merged(with_contact(friction=0.3, enforcement="penalty", penalty_factor=1.0), {
            "materials": {"soft": {"density": 1.0}, "stiff": {"density": 1.0}},
            "bodies": {"upper": {"initial_velocity": [0.1, 0.02, -0.2]}},
            "displacements": {"press": None, "slide": None},
            "dynamics": {"spectral_radius": radius}})

    def test_dynamics(self):
        """Impact with friction; below radius 1 the forces of the last step are part of the next."""
        for radius in (1.0, 0.6, 0.0):
            with self.subTest(radius=radius):
                whole = self.pieces_are_the_whole(f"dynamics, radius {radius:g}", self.dynamic(radius),
                                                  ("displacement", "velocity", "acceleration"))
                self.assertGreater(whole.contact()["friction_dissipation"], 0.0)

    def test_rigid_body_in_flight(self):
        """A heavy turning body lands on a moved block, whose ground is led."""
        deck = scenes.merged(self.dynamic(0.7), {
            "displacements": {"bottom": {"fix": None, "x": 0.05, "y": 0.0, "z": 0.02, "curve": "shake"}},
            "curves": {"shake": [[0, 0], [0.375, 1], [1, 0.3]]},
            "bodies": {"upper": {"material": None, "initial_angular_velocity": [0.1, 0.3, 0.5],
                                 "rigid": {"free": FREE, "center": [1, 0.5, 0.7], "density": 1.0}}}})
        self.pieces_are_the_whole("rigid body in flight", deck, ("displacement", "velocity", "acceleration"))


if __name__ == "__main__":
    unittest.main(warnings="ignore")
