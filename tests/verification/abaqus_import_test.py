#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Abaqus and CalculiX decks become the meshes and scenes that they are: exact solutions of small ones."""
import pathlib
import tempfile
import unittest

import exodus_edit
import inp_write
import numpy as np
import scenes

CORPUS = pathlib.Path(__file__).resolve().parents[1] / "fuzz" / "corpus"


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="abut_inp_")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def take(self, text, name="model"):
        """Imports a text; the deck that comes of it."""
        file = self.path / f"{name}.inp"
        file.write_text(text)
        status, output = scenes.execute([scenes.EXECUTABLE, "import", str(file), "--output-dir", str(self.path)], 60)
        self.assertEqual(status, 0, output)
        return self.path / f"{name}.yaml"

    def run_text(self, text, verify="", name="model"):
        deck = self.take(text, name)
        deck.write_text(deck.read_text() + verify)
        return scenes.run(deck, files=[deck.with_suffix(".exo")])

    def blocks(self, **options):
        return exodus_edit.read(scenes.mesh(self.path / "blocks.exo", "blocks", **options))


class Meshes(Case):
    def test_each_cell_is_its_exodus_twin(self):
        for cell in ("hex8", "hex20", "tet4", "tet10", "wedge6"):
            with self.subTest(cell):
                twin = self.blocks(lower_divisions=[2, 1, 1], upper_divisions=[1, 2, 1], element=cell)
                self.take(inp_write.text(twin) + "*ELSET, ELSET=all\nlower, upper\n"
                          "*MATERIAL, NAME=m\n*ELASTIC\n1., 0.\n*SOLID SECTION, ELSET=lower, MATERIAL=m\n"
                          "*SOLID SECTION, ELSET=upper, MATERIAL=m\n*STEP\n*STATIC\n*END STEP\n")
                mesh = exodus_edit.read(self.path / "model.exo")
                np.testing.assert_array_equal(mesh.x, twin.x)
                self.assertEqual([b.name for b in mesh.blocks], [b.name for b in twin.blocks])
                for a, b in zip(mesh.blocks, twin.blocks):
                    np.testing.assert_array_equal(a.nodes, b.nodes)
                self.assertEqual(sorted(mesh.side_sets), sorted(twin.side_sets))
                for name, (cells, sides) in twin.side_sets.items():
                    self.assertEqual(sorted(zip(*mesh.side_sets[name])), sorted(zip(cells, sides)), name)
                for name, nodes in twin.node_sets.items():
                    self.assertEqual(sorted(mesh.node_sets[name]), sorted(nodes), name)

    def test_the_files_of_the_corpus_run(self):
        files = sorted(CORPUS.glob("*.inp"))
        self.assertGreater(len(files), 2)
        for file in files:
            with self.subTest(file.name):
                result = self.run_text(file.read_text(), name=file.stem)
                self.assertEqual(result.summary["status"], "converged")


MATERIAL = "*MATERIAL, NAME=m\n{law}\n*SOLID SECTION, ELSET=lower, MATERIAL=m\n*SOLID SECTION, ELSET=upper, MATERIAL=m\n"
ELASTIC = MATERIAL.format(law="*ELASTIC\n100., 0.")


class Scenes(Case):
    """Two unit cubes on each other, meshed differently: lower_bottom, lower_top, upper_bottom, upper_top."""

    def two(self):
        return inp_write.text(self.blocks(lower_divisions=[2, 2, 2], upper_divisions=[3, 3, 3]))

    def nested(self):
        """Each upper face lies on one lower face: then the points carry a constant traction exactly."""
        return inp_write.text(self.blocks(lower_divisions=[2, 2, 2], upper_divisions=[4, 4, 2]))

    def test_a_slope_is_a_spring_between_the_surfaces(self):
        for kind in ("SURFACE TO SURFACE", "NODE TO SURFACE"):
            result = self.run_text(self.nested() + ELASTIC + f"""*CONTACT PAIR, INTERACTION=soft, TYPE={kind}
upper_bottom, lower_top
*SURFACE INTERACTION, NAME=soft
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
200.
*BOUNDARY
lower_bottom, 1, 3
upper_top, 1, 2
*STEP
*STATIC
*BOUNDARY
upper_top, 3, 3, -0.01
*END STEP
""")
            contact, = result.summary["contact"].values()
            self.assertGreater(contact["active_points"], 8)
            self.assertAlmostEqual(contact["force"][2], 0.01 / (1 / 100 + 1 / 100 + 1 / 200), delta=1e-6)

    def test_friction_at_a_rigid_plate_of_facets(self):
        """Pressed down by 2 and pulled along: friction is 0.3 of that, once all points slip."""
        mesh = inp_write.text(self.blocks(lower_divisions=[2, 2, 2], upper_divisions=[2, 2, 2]))
        lower = mesh.index("*ELEMENT, TYPE=C3D8, ELSET=lower")
        result = self.run_text(mesh[:lower] + """*NODE
901, -1., -1., 0.
902, 3., -1., 0.
903, 3., 2., 0.
904, -1., 2., 0.
*ELEMENT, TYPE=R3D4, ELSET=plate
901, 901, 902, 903, 904
*SURFACE, NAME=floor
plate, SPOS
*RIGID BODY, ELSET=plate, REF NODE=901
""" + mesh[lower:].replace("TYPE=C3D8, ELSET=upper", "TYPE=C3D8I, ELSET=upper") + ELASTIC + """*CONTACT PAIR, INTERACTION=rub, TYPE=SURFACE TO SURFACE
upper_bottom, floor
*SURFACE INTERACTION, NAME=rub
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
1000.
*FRICTION
0.3
*BOUNDARY
901, 1, 6
lower_bottom, 1, 3
lower_top, 1, 3
upper_top, 1, 2
*STEP
*STATIC
*DSLOAD
upper_top, P, 2.
*END STEP
*STEP
*STATIC
0.2, 1.
*BOUNDARY
upper_top, 1, 1, 0.1
*END STEP
""")
        contact, = result.summary["contact"].values()
        self.assertEqual(contact["stick_points"], 0)
        self.assertAlmostEqual(contact["force"][2], 2.0, delta=1e-6)
        self.assertAlmostEqual(abs(contact["force"][0]), 0.6, delta=1e-6)

    def test_a_tie_carries_a_uniform_pull(self):
        result = self.run_text(self.nested() + ELASTIC + """*TIE, NAME=glue
upper_bottom, lower_top
*BOUNDARY
lower_bottom, 1, 3
*STEP
*STATIC
*DSLOAD
upper_top, P, -1.
*END STEP
""")
        u = result.fields.vector("displacement")
        z = result.fields.coordinates[:, 2]
        np.testing.assert_allclose(u[:, 2], 0.01 * (z - z.min()), atol=1e-9)
        self.assertGreater(result.summary["contact"]["glue"]["active_points"], 0)

    def test_rubber_in_uniaxial_tension(self):
        """P = 2 C10 (l - 1/l^2) of neo-Hooke; Ogden of exponent 2 is the same law, D1 = 0 nearly so."""
        stretch, modulus = 1.2, 0.5
        expected = 2 * modulus * (stretch - 1 / stretch ** 2)
        for law in ("NEO HOOKE\n.5, .002", "NEO HOOKE\n.5", "MOONEY-RIVLIN\n.5, 0., .002", "OGDEN, N=1\n1., 2., .002"):
            result = self.run_text(
                self.two() + MATERIAL.format(law=f"*HYPERELASTIC, {law}") + """*TIE, NAME=glue
upper_bottom, lower_top
*BOUNDARY
lower_bottom, ZSYMM
lower_x0, XSYMM
lower_y0, YSYMM
upper_x0, XSYMM
upper_y0, YSYMM
*STEP, NLGEOM
*STATIC
.5, 1.
*BOUNDARY
upper_top, 3, 3, 0.4
*END STEP
""", "verify:\n  pull: {quantity: reaction_z, place: upper_top, expected: %r, relative_tolerance: 3e-3}\n" % expected)
            check, = result.summary["verify"]
            self.assertTrue(check["ok"], (law, check))

    def test_a_coupled_node_turns_a_face(self):
        """The upper face turns by 0.01 about z: a twist of the whole column, whose ends stay flat."""
        result = self.run_text(self.two() + ELASTIC + """*NODE
999, 0.5, 0.5, 1.
*TIE, NAME=glue
upper_bottom, lower_top
*COUPLING, CONSTRAINT NAME=grip, REF NODE=999, SURFACE=upper_top
*KINEMATIC
*BOUNDARY
lower_bottom, 1, 3
999, 1, 5
*STEP
*STATIC
*BOUNDARY
999, 6, 6, 0.01
*END STEP
""")
        x, u = result.fields.coordinates, result.fields.vector("displacement")
        top = x[:, 2] > 0.999
        np.testing.assert_allclose(u[top, 0], -0.01 * (x[top, 1] - 0.5), atol=1e-4)
        np.testing.assert_allclose(u[top, 1], 0.01 * (x[top, 0] - 0.5), atol=1e-4)
        self.assertGreater(np.abs(u[~top]).max(), 1e-3)

    def test_what_falls_falls(self):
        """Constant acceleration, which the rule in time has exactly."""
        result = self.run_text(self.two() + MATERIAL.format(law="*ELASTIC\n100., 0.\n*DENSITY\n2.")
                               + """*INITIAL CONDITIONS, TYPE=VELOCITY
upper_all, 3, 1.
*NSET, NSET=upper_all, ELSET=upper
*BOUNDARY
lower_bottom, 1, 3
lower_top, 1, 3
*STEP
*DYNAMIC, ALPHA=0., DIRECT
0.1, 1.
*DLOAD
upper, GRAV, 10., 0., 0., -1.
*END STEP
""")
        z, u = result.fields.coordinates[:, 2], result.fields.vector("displacement")
        self.assertEqual(result.summary["steps"], 10)
        np.testing.assert_allclose(u[z > 0.01, 2], 1.0 - 5.0, atol=1e-6)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
