# SPDX-License-Identifier: BSD-3-Clause
"""Thin bodies, all of whose surfaces are in contact sets: what faces each other through a body is no pair, and
what meets is. The answer is that of the same scene with nothing in the sets but the faces that meet."""
import math
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy

import scenes

FORMULATIONS = ("node_on_facet", "facet_on_facet", "sliding_elastic")
HEX = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
SIDES = {"y0": 0, "x1": 1, "y1": 2, "x0": 3, "z0": 4, "z1": 5}  # of Exodus, from 0


def box(origin, size, divisions):
    return divisions, lambda u: numpy.array(origin) + u * numpy.array(size)


def arch(inner, outer, divisions, angle=0.7):
    """Part of a tube about the y axis; u runs along the arc, the width and the thickness."""
    def place(u):
        phi, r = angle * (2 * u[:, 0] - 1), inner + (outer - inner) * u[:, 2]
        return numpy.stack([r * numpy.sin(phi), 0.5 * u[:, 1], r * numpy.cos(phi)], axis=1)
    return divisions, place


def fold(legs, thickness, layers, gap):
    """A sheet folded to and fro: legs of length 1, one above the other, `gap` between them; the first one's lower
    side is z0. Divisions and place, and where in u each leg lies."""
    radius, leg, turn = 0.5 * (gap + thickness), 10, 4
    along = legs * leg + (legs - 1) * turn

    def place(u):
        x = numpy.empty_like(u)
        for k, s in enumerate(numpy.rint(u[:, 0] * along).astype(int)):
            number, step = divmod(s, leg + turn)
            forth = 1 if number % 2 == 0 else -1
            start = numpy.array([0.0 if forth > 0 else 1.0, 2 * radius * number])
            if step <= leg:
                at, normal = start + [forth * step / leg, 0], numpy.array([0, forth])
            else:
                phi = math.pi * (step - leg) / turn
                centre = start + [forth, radius]
                normal = numpy.array([-math.sin(phi), forth * math.cos(phi)])
                at = centre - forth * radius * normal
            at = at + (u[k, 2] - 0.5) * thickness * normal
            x[k] = at[0], 0.2 * u[k, 1], at[1]
        return x
    legs_at = [((leg + turn) * k / along, ((leg + turn) * k + leg) / along) for k in range(legs)]
    return ([along, 1, layers], place), legs_at


def write(path, parts, sets=()):
    """One block for each part (divisions, place), with the sets PART_x0 .. PART_z1, PART_skin and skin, and `sets`:
    name -> (part, side, range of u along the first direction)."""
    mesh, elements, sides = exodus_edit.ExodusMesh(numpy.zeros((0, 3)), []), 0, {"skin": []}
    for number, (name, (divisions, place)) in enumerate(parts.items(), 1):
        n = numpy.array(divisions)
        u = numpy.stack(numpy.meshgrid(*(numpy.arange(k + 1) for k in n), indexing="ij"), axis=-1).reshape(-1, 3)
        cells = numpy.stack(numpy.meshgrid(*map(numpy.arange, n), indexing="ij"), axis=-1).reshape(-1, 3)
        corners = cells[:, None, :] + HEX
        nodes = (corners[..., 0] * (n[1] + 1) + corners[..., 1]) * (n[2] + 1) + corners[..., 2]
        mesh.blocks.append(exodus_edit.Block(name, number, "HEX8", nodes + len(mesh.x)))
        mesh.x = numpy.vstack([mesh.x, place(u / n)])
        sides[f"{name}_skin"] = []
        for side, of_cell in SIDES.items():
            axis, end = "xyz".index(side[0]), side[1] == "1"
            there = numpy.flatnonzero(cells[:, axis] == (n[axis] - 1 if end else 0))
            faces = [(elements + e, of_cell) for e in there]
            sides[f"{name}_{side}"] = faces
            sides[f"{name}_skin"] += faces
            sides["skin"] += faces
            for key, (part, of, (low, high)) in dict(sets).items():
                if (part, of) == (name, side):
                    middle = (cells[there, 0] + 0.5) / n[0]
                    sides[key] = [f for f, m in zip(faces, middle) if low < m < high]
        elements += len(cells)
    mesh.side_sets = {key: tuple(numpy.array(faces).T) for key, faces in sides.items()}
    exodus_edit.write(path, mesh)


def deck(parts, foot, head, down, contact, formulation, **more):
    out = {
        "mesh": {"file": "thin.exo"}, "materials": {"soft": {"model": "neo_hookean", "young": 1, "poisson": 0.3}},
        "bodies": {name: {"blocks": [name], "material": "soft"} for name in parts},
        "displacements": {"foot": {"set": foot, "fix": ["x", "y", "z"]},
                          "head": {"set": head, "fix": ["x", "y"], "z": -down},
                          **{f"{name}_{axis}": {"set": f"{name}_{axis}0", "fix": [axis]}
                             for name in list(parts)[1:-1] for axis in "xy"}},
        "contact": {f"c{k}": {"primary": one, "secondary": other, "formulation": formulation}
                    for k, (one, other) in enumerate(contact)},
        "verify": {"foot": scenes.probe("reaction_z", place=foot)}}
    return scenes.merged(out, more)


# parts from below, how far the uppermost one is pressed down, least thickness; z1 of each meets z0 of the next.
PLATE, SMALL, FINE = [4, 4, 2], [2, 2, 1], [6, 6, 2]
STACKS = {
    "two plates": ({"a": box([0, 0, -.1], [1, 1, .1], PLATE), "b": box([0, 0, 0], [1, 1, .1], FINE)}, 1e-3, .1),
    "one layer": ({"a": box([0, 0, -.05], [1, 1, .05], [3, 3, 1]), "b": box([0, 0, 0], [1, 1, .05], [4, 4, 1])},
                  1e-3, .05),
    "plate on block": ({"a": box([0, 0, -1], [1, 1, 1], PLATE), "b": box([0, 0, 0], [1, 1, .02], FINE)}, 2e-3, .02),
    "block on plate": ({"a": box([0, 0, -.02], [1, 1, .02], PLATE), "b": box([0, 0, 0], [1, 1, 1], FINE)}, 2e-3, .02),
    "small on large": ({"a": box([0, 0, -.1], [3, 3, .1], FINE), "b": box([.9, 1.2, 0], [1, 1, .1], PLATE)}, 1e-3, .1),
    "strip on block": ({"a": box([0, 0, -1], [3, 3, 1], FINE), "b": box([.4, 1, 0], [.2, 1, .3], SMALL)}, 1e-3, .2),
    "flush at the rim": ({"a": box([0, 0, -1], [3, 3, 1], FINE), "b": box([2, 1, 0], [1, 1, .2], SMALL)}, 1e-3, .2),
    "over the rim": ({"a": box([0, 0, -.2], [3, 3, .2], FINE), "b": box([2.2, 1, 0], [1, 1, .1], PLATE)}, 1e-3, .1),
    "apart": ({"a": box([0, 0, -.1], [1, 1, .1], PLATE), "b": box([0, 0, .004], [1, 1, .1], FINE)}, 5e-3, .1),
    "one deep step": ({"a": box([0, 0, -1], [1, 1, 1], PLATE), "b": box([.2, .2, .1], [.6, .6, .02], FINE)}, .13, .02),
    "between blocks": ({"a": box([0, 0, -1], [1, 1, 1], SMALL), "b": box([0, 0, 0], [1, 1, .03], PLATE),
                        "c": box([0, 0, .03], [1, 1, 1], [3, 3, 2])}, 5e-3, .03),
    "three plates": ({"a": box([0, 0, -.1], [1, 1, .1], PLATE), "b": box([0, 0, 0], [1, 1, .1], FINE),
                      "c": box([0, 0, .1], [1, 1, .1], [5, 5, 1])}, 2e-3, .1),
    "nested shells": ({"a": arch(1, 1.05, [10, 2, 1]), "b": arch(1.05, 1.1, [10, 2, 1])}, 1e-3, .05),
}


class ThinBodies(unittest.TestCase):
    def run_thin(self, parts, scene, sets=()):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "thin.exo"
            write(path, parts, sets)
            return scenes.run(scene, files=[path], seconds=120)

    def deepest(self, result):
        return max(c["max_penetration"] for c in result.summary["contact"].values())

    def stack(self, parts, down, thinnest, formulation):
        """Pairs of whole skins, each with each, and one skin of all: as the pairs of faces that meet."""
        names = list(parts)
        foot, head = f"{names[0]}_z0", f"{names[-1]}_z1"
        meeting = [(f"{b}_z0", f"{a}_z1") for a, b in zip(names, names[1:])]
        skins = [(f"{b}_skin", f"{a}_skin") for i, a in enumerate(names) for b in names[i + 1:]]
        right = self.run_thin(parts, deck(parts, foot, head, down, meeting, formulation))
        self.assertGreater(right.quantity("foot"), 0)
        got = self.run_thin(parts, deck(parts, foot, head, down, skins, formulation))
        self.assertAlmostEqual(got.quantity("foot") / right.quantity("foot"), 1, delta=1e-3)
        if formulation != "node_on_facet":  # nodes on edges are points of the side faces too
            self.assertLessEqual(got.summary["newton_iterations"], right.summary["newton_iterations"] + 2)
        if len(names) == 2:
            none = self.run_thin(parts, deck(parts, foot, head, down, [(head, foot)], formulation))
            self.assertEqual(none.contact("c0")["active_points"], 0)
        # both sides carry points, so that the springs are twice as stiff
        whole = self.run_thin(parts, deck(parts, foot, head, down, [("skin", "skin")], formulation))
        self.assertAlmostEqual(whole.quantity("foot") / right.quantity("foot"), 1, delta=0.2)
        self.assertLess(self.deepest(whole), 0.05 * thinnest)

    def test_stacks(self):
        for name, (parts, down, thinnest) in STACKS.items():
            for formulation in FORMULATIONS:
                with self.subTest(scene=name, formulation=formulation):
                    self.stack(parts, down, thinnest, formulation)

    def test_a_squeezed_plate_does_not_meet_itself(self):
        for layers in (1, 2, 4):
            parts = {"a": box([0, 0, 0], [1, 1, .05], [6, 6, layers])}
            for formulation in FORMULATIONS:
                with self.subTest(layers=layers, formulation=formulation):
                    scene = deck(parts, "a_z0", "a_z1", 0.03, [("skin", "skin")], formulation, time={"steps": 6})
                    result = self.run_thin(parts, scene)
                    self.assertEqual(result.contact("c0")["active_points"], 0)
                    self.assertTrue(any("never touched" in text for text in result.summary["warnings"]))

    def folded(self, legs, thickness, layers, formulation):
        """The head comes down until the legs meet: two legs as the pair of their inner sides would; more of them
        meet at their ends too, so that there is no such pair."""
        gap = 0.06
        shape, at = fold(legs, thickness, layers, gap)
        parts = {"a": shape}
        upper = "z1" if legs % 2 else "z0"
        sets = {"foot": ("a", "z0", at[0]), "head": ("a", upper, at[-1]),
                "over": ("a", "z1", at[0]), "under": ("a", "z1", at[1])}
        close = gap + 0.1 * thickness if legs == 2 else 0.8 * (legs - 1) * gap
        scene = lambda *pair: deck(parts, "foot", "head", close, [pair], formulation, time={"steps": 8})
        got = self.run_thin(parts, scene("skin", "skin"), sets)
        self.assertGreater(got.contact("c0")["active_points"], 0)
        self.assertLess(self.deepest(got), 0.1 * thickness)
        if legs == 2:
            right = self.run_thin(parts, scene("under", "over"), sets)
            self.assertAlmostEqual(got.quantity("foot") / right.quantity("foot"), 1, delta=0.15)

    def test_folded_sheets_meet_where_their_legs_do(self):
        for legs, thickness, layers in ((2, 0.05, 1), (2, 0.1, 2), (3, 0.05, 2), (4, 0.05, 1)):
            for formulation in FORMULATIONS:
                with self.subTest(legs=legs, layers=layers, formulation=formulation):
                    self.folded(legs, thickness, layers, formulation)


if __name__ == "__main__":
    unittest.main()
