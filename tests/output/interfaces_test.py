#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Contact fields of the results where several interfaces or both sides of one have a node."""
import itertools
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy as np
import pressure_error
import scenes

FORMULATIONS = ("facet_on_facet", "sliding_elastic", "node_on_facet")
SCENE = {
    "mesh": {"generate": {"kind": "blocks", "lower_divisions": [4, 4, 4], "upper_divisions": [6, 6, 6]}},
    "materials": {"rubber": {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "rubber"},
               "upper": {"blocks": ["upper"], "material": "rubber"}},
    "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "head": {"set": "upper_top", "x": 0.0005, "y": 0.0, "z": -0.01}},
    "contact": {"press": {"primary": "upper_bottom", "secondary": "lower_top"}},
}
NAMES = ("contact_pressure", "contact_traction_x", "contact_traction_z", "contact_status")


def with_contacts(**contacts):
    deck = scenes.merged(SCENE, {})
    deck["contact"] = contacts
    return deck


def shown_force(fields, side):
    """Integral of contact_traction over the present faces of a side set, linear between corners."""
    x = fields.coordinates + fields.vector("displacement")
    traction = fields.vector("contact_traction")
    total = np.zeros(3)
    gauss = np.polynomial.legendre.leggauss(3)
    for corners in pressure_error.face_corners(fields, ["lower", "upper"], side):
        y, t = x[corners], traction[corners]
        if len(corners) == 3:
            total += 0.5 * np.linalg.norm(np.cross(y[1] - y[0], y[2] - y[0])) * t.mean(axis=0)
            continue
        for (r, v), (s, w) in itertools.product(zip(*gauss), repeat=2):
            signs = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
            N = (1 + signs[:, 0] * r) * (1 + signs[:, 1] * s) / 4
            dr, ds = (signs[:, 0] * (1 + signs[:, 1] * s) / 4) @ y, (signs[:, 1] * (1 + signs[:, 0] * r) / 4) @ y
            total += v * w * np.linalg.norm(np.cross(dr, ds)) * (N @ t)
    return total


class SeveralInterfaces(unittest.TestCase):
    def same(self, fields, expected, names=NAMES, nodes=slice(None)):
        for name in names:
            size = np.abs(expected.nodal(name)).max()
            np.testing.assert_allclose(fields.nodal(name)[nodes], expected.nodal(name)[nodes], rtol=0,
                                       atol=1e-9 * size, err_msg=name)

    def test_one_that_never_touches_changes_nothing(self):
        for formulation, friction in itertools.product(FORMULATIONS, (0.0, 0.5)):
            options = {"formulation": formulation, "friction": friction}
            press = {"primary": "upper_bottom", "secondary": "lower_top", **options}
            alone = scenes.run(with_contacts(press=press), ranks=1)
            if friction:
                self.assertIn(2.0, alone.fields.nodal("contact_status"))
            others = {"primary": "upper_bottom", "secondary": "lower_x0", **options}
            beside = {"primary": "upper_x1", "secondary": "lower_x0", **options}
            for ranks in (1, 2):
                with self.subTest(ranks=ranks, **options):
                    both = scenes.run(with_contacts(press=press, others=others, beside=beside), ranks=ranks)
                    self.assertEqual(both.contact("others")["active_points"], 0)
                    self.assertGreater(alone.contact("press")["active_points"], 0)
                    self.same(both.fields, alone.fields)
                    primary = alone.fields.node_set("upper_bottom")
                    self.assertAlmostEqual(both.fields.nodal("contact_pressure")[primary].max(),
                                           both.contact("press")["max_pressure"], delta=1e-12)

    def test_pieces_of_a_surface_show_what_the_whole_shows(self):
        """upper_bottom in two halves, and twice with shares of the penalty."""
        with tempfile.TemporaryDirectory() as folder:
            path = scenes.mesh(pathlib.Path(folder) / "blocks.exo", "blocks", **{
                "lower_divisions": [4, 4, 4], "upper_divisions": [6, 6, 6]})
            mesh = exodus_edit.read(path)
            elements, sides = mesh.side_sets["upper_bottom"]
            upper = next(b for b in mesh.blocks if b.name == "upper")
            first = mesh.num_elements - len(upper.nodes)
            left = mesh.x[upper.nodes[elements - first]].mean(axis=1)[:, 0] < 0.5
            mesh.side_sets["left"] = elements[left], sides[left]
            mesh.side_sets["right"] = elements[~left], sides[~left]
            exodus_edit.write(path, mesh)
            side = {"secondary": "lower_top", "penalty": 60.0}
            whole, halves, shares = (
                scenes.run(scenes.merged(with_contacts(**contacts), {"mesh": {"generate": None, "file": "blocks.exo"}}),
                           files=[path])
                for contacts in ({"a": {"primary": "upper_bottom", **side}},
                                 {"a": {"primary": "left", **side}, "b": {"primary": "right", **side}},
                                 {"a": {"primary": "upper_bottom", **side, "penalty": 20.0},
                                  "b": {"primary": "upper_bottom", **side, "penalty": 40.0}}))
        for run in (halves, shares):
            self.assertGreater(min(abs(run.force(name)[2]) for name in "ab"), 1e-3)
            self.same(run.fields, whole.fields)

    def test_long_names_are_written_whole(self):
        side = {"primary": "upper_bottom", "secondary": "lower_top"}
        names = [f"a_name_of_more_than_thirty_two_characters_{i}" for i in (1, 2)]
        run = scenes.run(with_contacts(**{names[0]: {**side, "penalty": 20.0}, names[1]: {**side, "penalty": 40.0}}))
        values = run.fields.globals()
        for name in names:
            self.assertEqual(values[name + "_force_z"], run.force(name)[2])
        self.assertNotEqual(run.force(names[0])[2], run.force(names[1])[2])

    def test_both_sides_carry_the_force(self):
        for formulation, element, ranks in itertools.product(FORMULATIONS, ("hex8", "tet4", "hex20"), (1, 2)):
            if (formulation, element) == ("node_on_facet", "hex20"):
                continue  # does not converge here
            with self.subTest(formulation=formulation, element=element, ranks=ranks):
                run = scenes.run(scenes.merged(SCENE, {
                    "mesh": {"generate": {"element": element, "lower_divisions": [3, 3, 2],
                                          "upper_divisions": [4, 4, 2]}},
                    "contact": {"press": {"formulation": formulation, "friction": 0.3}}}), ranks=ranks)
                force = run.force("press")
                self.assertGreater(force[2], 1e-3)
                np.testing.assert_allclose(shown_force(run.fields, "lower_top"), -force,
                                           atol=1e-4 * np.abs(force).max())
                np.testing.assert_allclose(shown_force(run.fields, "upper_bottom"), force,
                                           atol=1e-4 * np.abs(force).max())

    def test_pressure_is_the_stress_of_matching_meshes(self):
        """Two passes, and self-contact of both surfaces as one, share a pressure between their sides."""
        with tempfile.TemporaryDirectory() as folder:
            path = scenes.mesh(pathlib.Path(folder) / "blocks.exo", "blocks", **{
                "lower_divisions": [3, 3, 3], "upper_divisions": [3, 3, 3]})
            mesh = exodus_edit.read(path)
            mesh.side_sets["both"] = tuple(np.concatenate([mesh.side_sets[name][i] for name in
                                                           ("lower_top", "upper_bottom")]) for i in (0, 1))
            exodus_edit.write(path, mesh)
            for contact in ({"primary": "upper_bottom", "secondary": "lower_top"},
                            {"primary": "upper_bottom", "secondary": "lower_top", "two_pass": True},
                            {"primary": "both", "secondary": "both"}):
                with self.subTest(**contact):
                    deck = with_contacts(press=contact)
                    deck["mesh"] = {"file": "blocks.exo"}
                    deck["displacements"]["head"]["x"] = 0.0
                    run = scenes.run(deck, files=[path])
                    stress = -run.fields.element("stress_zz", "upper").mean()
                    self.assertGreater(stress, 0.004)
                    for side, sign in (("upper_bottom", 1), ("lower_top", -1)):
                        nodes = run.fields.node_set(side)
                        np.testing.assert_allclose(run.fields.nodal("contact_pressure")[nodes], stress, rtol=1e-3)
                        np.testing.assert_allclose(run.fields.nodal("contact_traction_z")[nodes], sign * stress,
                                                   rtol=1e-3)


if __name__ == "__main__":
    unittest.main()
