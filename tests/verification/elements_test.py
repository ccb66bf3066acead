# SPDX-License-Identifier: BSD-3-Clause
"""hex8 that locks neither in bending nor near incompressibility, beside exact values and hex20, and beside the elements
that do lock: else the scenes would show nothing."""
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy
import scenes


def box(divisions, size=(1, 1, 1), element="hex8", **more):
    return {"generate": {"kind": "box", "size": list(size), "divisions": list(divisions), "element": element, **more}}


def element(kind):
    """Element type of the mesh and keys of the body."""
    return ("hex20", {}) if kind == "hex20" else ("hex8", {"element": kind})


class Cantilever(unittest.TestCase):
    """40 x 4 x 2, E = 2600, nu = 0, force 1 at the tip: w = F L^3/(3 E I) = 3.077."""
    EXACT = 40**3 / (3 * 2600 * 4 * 2**3 / 12)

    def tip(self, divisions, kind="enhanced"):
        cell, keys = element(kind)
        return -scenes.run({
            "mesh": box(divisions, (40, 4, 2), cell),
            "materials": {"pom": {"model": "linear_elastic", "young": 2600, "poisson": 0}},
            "bodies": {"beam": {"blocks": ["box"], "material": "pom", **keys}},
            "displacements": {"root": {"set": "x0", "fix": ["x", "y", "z"]}},
            "loads": {"tip": {"side_set": "x1", "traction": [0, 0, -0.125]}},
            "verify": {"tip": scenes.probe("displacement_z", "x1")}}).quantity("tip")

    def test_bends_as_a_beam(self):
        for divisions in ((10, 1, 1), (20, 2, 2), (40, 1, 4)):
            error = self.tip(divisions) / self.EXACT - 1
            print(f"cantilever {divisions}: {error:.4f}")
            self.assertLess(abs(error), 0.02)

    def test_displacement_elements_lock_here(self):
        self.assertLess(self.tip((10, 1, 1), "displacement"), 0.4 * self.EXACT)


class Membrane(unittest.TestCase):
    """Cook's membrane, in plane strain: (0,0), (48,44), (48,60), (0,44), sheared along its right edge."""

    def tip(self, cells, kind, material):
        cell, keys = element(kind)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        mesh = scenes.mesh(pathlib.Path(folder.name) / "mesh.exo", "box", size=[48, 1, 1],
                           divisions=[cells, cells, 1], element=cell)
        cook = exodus_edit.read(mesh)
        x, share = cook.x[:, 0].copy(), cook.x[:, 1].copy()
        cook.x[:, 1] = 44 / 48 * x + share * (44 - 28 / 48 * x)
        exodus_edit.write(mesh, cook)
        return scenes.run({
            "mesh": {"file": "mesh.exo"}, "materials": {"soft": material},
            "bodies": {"membrane": {"blocks": ["box"], "material": "soft", **keys}},
            "displacements": {"wall": {"set": "x0", "fix": ["x", "y"]}, "front": {"set": "z0", "fix": ["z"]},
                              "back": {"set": "z1", "fix": ["z"]}},
            "loads": {"shear": {"side_set": "x1", "traction": [0, 1 / 16, 0]}},
            "verify": {"tip": scenes.probe("displacement_y", "x1")}}, files=[mesh]).quantity("tip")

    def test_follows_hex20(self):
        """Near a half hex20 converges slowly as well: there the reference is what it tends to with 6, 12 and 24 cells,
        17.198, 18.053, 18.359 and 27.333, 28.838, 29.568."""
        linear = {"model": "linear_elastic", "young": 1}
        for material, limit in (({**linear, "poisson": 0.3}, None), ({**linear, "poisson": 0.4999}, 18.53),
                                ({"young": 0.3, "poisson": 0.4999}, 30.26)):
            hex20 = self.tip(12, "hex20", material)
            expected = limit or hex20
            error = self.tip(16, "enhanced", material) / expected - 1
            locked = self.tip(16, "displacement", material) / expected - 1
            print(f"membrane, {material}: {expected:.3f}, hex20 with 12 cells {hex20 / expected - 1:.4f}, enhanced with "
                  f"16 {error:.4f}, displacement {locked:.4f}")
            self.assertLess(abs(error), 0.02)
            self.assertLess(locked, -0.3 if limit else -0.02)


class Block(unittest.TestCase):
    """Cubes pressed on each other whose volume hardly changes."""

    def force(self, kind):
        cell, keys = element(kind)
        body = {"material": "rubber", **keys}
        return scenes.run({
            "mesh": {"generate": {"kind": "blocks", "lower_divisions": [4] * 3, "upper_divisions": [6] * 3,
                                  "element": cell}},
            "materials": {"rubber": {"young": 1, "poisson": 0.4999}},
            "bodies": {"lower": {"blocks": ["lower"], **body}, "upper": {"blocks": ["upper"], **body}},
            "displacements": {"foot": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                              "head": {"set": "upper_top", "fix": ["x", "y"], "z": -0.01}},
            "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top",
                                 "enforcement": "augmented_lagrangian"}}}, seconds=300).force()[2]

    def test_contact_of_nearly_incompressible_blocks(self):
        expected, found, locked = self.force("hex20"), self.force("enhanced"), self.force("displacement")
        print(f"blocks: hex20 {expected:.5f}, enhanced {found / expected - 1:.4f}, "
              f"displacement {locked / expected - 1:.2f}")
        self.assertLess(abs(found / expected - 1), 0.02)
        self.assertGreater(locked, 2 * expected)


def least_corner(result):
    """The smallest det F at corners of hex8 elements: the volume of their edges over what it was."""
    start, nodes = result.fields.coordinates, result.fields.connectivity("box")
    ends = ([1, 0, 3, 2, 5, 4, 7, 6], [3, 2, 1, 0, 7, 6, 5, 4], [4, 5, 6, 7, 0, 1, 2, 3])
    volumes = [numpy.linalg.det(numpy.stack([x[nodes[:, end]] - x[nodes] for end in ends], axis=-1))
               for x in (start, start + result.fields.vector("displacement"))]
    return (volumes[1] / volumes[0]).min()


class Compression(unittest.TestCase):
    """A cube of neo-Hookean material pressed to two fifths of its height."""

    def press(self, cells, kind, poisson, grip, by=0.6, **mesh):
        cell, keys = element(kind)
        held = ["x", "y"] if grip else []
        displacements = {"foot": {"set": "z0", "fix": ["z", *held]},
                         "head": {"set": "z1", "z": -by, **({"fix": held} if grip else {})}}
        if not grip:
            displacements.update({"x": {"set": "x0", "fix": ["x"]}, "y": {"set": "y0", "fix": ["y"]}})
        return scenes.run({
            "mesh": box([cells] * 3, element=cell, **mesh),
            "materials": {"soft": {"young": 1, "poisson": poisson}},
            "bodies": {"cube": {"blocks": ["box"], "material": "soft", **keys}},
            "displacements": displacements, "time": {"steps": 6},
            "verify": {"force": scenes.probe("reaction_z", "z1")}}, seconds=120)

    def test_free_cube_stays_homogeneous(self):
        """On a mesh of crooked elements: no hourglass mode grows."""
        result = self.press(4, "enhanced", 0.3, False, distortion=0.3)
        x, u = result.fields.coordinates, result.fields.vector("displacement")
        gradient = numpy.linalg.lstsq(numpy.hstack([x, numpy.ones((len(x), 1))]), u, rcond=None)[0]
        rest = u - x @ gradient[:3] - gradient[3]
        self.assertLess(numpy.abs(rest).max(), 1e-8)
        self.assertGreater(gradient[0, 0], 0.2)

    def test_gripped_cube_bulges_smoothly(self):
        """Nodes on vertical lines of the middle section bulge once: the second difference keeps its sign. Elements at the
        edges of the grips, where the side rolls over them, are pressed nearly flat at a corner and do not fold."""
        for poisson in (0.3, 0.49):
            result = self.press(8, "enhanced", poisson, True)
            x = result.fields.coordinates + result.fields.vector("displacement")
            start = result.fields.coordinates
            line = numpy.flatnonzero((start[:, 0] > 0.999) & (abs(start[:, 1] - 0.5) < 1e-6))
            bulge = x[line[numpy.argsort(start[line, 2])], 0]
            corner = least_corner(result)
            print(f"gripped cube, nu {poisson}: force {-result.quantity('force'):.4f}, bulge {bulge.max():.4f}, least det "
                  f"F at corners {corner:.4f}")
            self.assertGreater(corner, 0)
            self.assertLess(corner, 0.3)
            self.assertEqual(result.summary["cut_backs"], 0)
            self.assertTrue((numpy.diff(bulge, 2)[1:-1] < 0).all())
            self.assertGreater(bulge.max(), 1.15)

    def test_gripped_cube_is_as_stiff_as_hex20(self):
        """Pressed by .4, where the edges of the grips tell little: hex20 has .6575 with 4 and .6455 with 6 cells, but 1.313
        and 1.197 when pressed by .6."""
        expected = self.press(6, "hex20", 0.3, True, 0.4).quantity("force")
        self.assertAlmostEqual(self.press(8, "enhanced", 0.3, True, 0.4).quantity("force") / expected, 1, delta=0.02)
        self.assertGreater(self.press(4, "displacement", 0.3, True, 0.4).quantity("force") / expected, 1.05)


if __name__ == "__main__":
    unittest.main()
