#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Further fields: tensors, principal values, strains and recovered nodal stress against exact states; VTK makes one
array of a tensor."""
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy as np
import scenes

FIELDS = ["stress_tensor", "principal_stress", "strain", "nodal_stress"]
ENDS = ["xx", "yy", "zz", "xy", "yz", "zx"]
PLACES = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]
YOUNG, POISSON = 3.0, 0.25
MU, LAMBDA = YOUNG / 2 / (1 + POISSON), YOUNG * POISSON / (1 + POISSON) / (1 - 2 * POISSON)
GRADIENT = np.array([[0.03, 0.02, -0.01], [0.04, -0.05, 0.015], [-0.02, 0.005, 0.01]])
# u_i = sum of c x_j x_k, as {(j, k): c} for each i
QUADRATIC = [{(0, 0): 0.01, (1, 2): 0.02}, {(0, 1): 0.015, (2, 2): -0.01}, {(0, 2): 0.01, (1, 1): 0.005}]


def six(tensor):
    return np.array([tensor[i][j] for i, j in PLACES])


def hooke(strain):
    return LAMBDA * np.trace(strain) * np.eye(3) + 2 * MU * strain


def quadratic_gradient(x):
    """du_i/dx_j"""
    gradient = np.zeros((3, 3))
    for i, terms in enumerate(QUADRATIC):
        for (j, k), c in terms.items():
            gradient[i, j] += c * x[k]
            gradient[i, k] += c * x[j]
    return gradient


def body_force():
    """Minus the divergence of the stress, which is linear in x."""
    def stress(x):
        gradient = quadratic_gradient(x)
        return hooke(0.5 * (gradient + gradient.T))
    rest = stress(np.zeros(3))
    return -sum((stress(np.eye(3)[j]) - rest)[:, j] for j in range(3))


def box(model, element, expressions, force=None, divisions=(2, 2, 2)):
    """All faces are held at a displacement."""
    deck = {
        "mesh": {"generate": {"kind": "box", "divisions": list(divisions), "size": [1.0, 1.2, 0.8],
                              "element": element}},
        "materials": {"any": {"model": model, "young": YOUNG, "poisson": POISSON}},
        "bodies": {"all": {"blocks": ["box"], "material": "any"}},
        "displacements": {face: {"set": face, **dict(zip("xyz", expressions))}
                          for face in ("x0", "x1", "y0", "y1", "z0", "z1")},
        "newton": {"tolerance": 1e-13}, "linear_solver": {"method": "direct"}, "output": {"fields": FIELDS},
    }
    if force is not None:
        deck["loads"] = {"volume": {"body_force": [float(f) for f in force], "block": "box"}}
    return deck


def linear():
    return [" + ".join(f"({c})*{x}" for c, x in zip(row, "xyz")) for row in GRADIENT.tolist()]


def element_tensor(fields, name, block="box"):
    """(elements, 6)"""
    return np.stack([fields.element(f"{name}_{end}", block) for end in ENDS], axis=1)


def nodal_tensor(fields):
    return np.stack([fields.nodal(f"nodal_stress_{end}") for end in ENDS], axis=1)


def von_mises(s):
    return np.sqrt(0.5 * ((s[0] - s[1])**2 + (s[1] - s[2])**2 + (s[2] - s[0])**2) + 3 * (s[3:]**2).sum())


class Uniform(unittest.TestCase):
    def check(self, fields, stress, strain):
        close = lambda found, expected: np.testing.assert_allclose(
            found, np.broadcast_to(expected, found.shape), rtol=0, atol=1e-12)
        close(element_tensor(fields, "stress_tensor"), six(stress))
        close(element_tensor(fields, "strain"), six(strain))
        close(nodal_tensor(fields), six(stress))
        close(fields.nodal("nodal_von_mises"), von_mises(six(stress)))
        close(fields.element("von_mises", "box"), von_mises(six(stress)))
        principal = np.sort(np.linalg.eigvalsh(stress))[::-1]
        self.assertGreater(np.abs(np.diff(principal)).min(), 0.01)
        for which, value in zip(("max", "mid", "min"), principal):
            close(fields.element(f"principal_stress_{which}", "box"), value)
        for end in ("xx", "yy", "zz", "xy", "yz"):
            np.testing.assert_array_equal(fields.element(f"stress_{end}", "box"),
                                          fields.element(f"stress_tensor_{end}", "box"))
        np.testing.assert_array_equal(fields.element("stress_xz", "box"), fields.element("stress_tensor_zx", "box"))

    def test_small_strain(self):
        strain = 0.5 * (GRADIENT + GRADIENT.T)
        for element in ("hex8", "hex20", "hex27", "tet4", "tet10", "wedge6"):
            with self.subTest(element):
                self.check(scenes.run(box("linear_elastic", element, linear())).fields, hooke(strain), strain)

    def test_finite_strain(self):
        """Green-Lagrange strain and Cauchy stress, mu (b - I)/J + lambda ln J/J I."""
        F = np.eye(3) + 8 * GRADIENT
        J = np.linalg.det(F)
        stress = (MU * (F @ F.T - np.eye(3)) + LAMBDA * np.log(J) * np.eye(3)) / J
        expressions = [f"8*({text})*t" for text in linear()]
        for element in ("hex8", "hex20", "tet10"):
            deck = scenes.merged(box("neo_hookean", element, expressions), {"time": {"steps": 3}})
            with self.subTest(element):
                self.check(scenes.run(deck).fields, stress, 0.5 * (F.T @ F - np.eye(3)))


class Recovery(unittest.TestCase):
    def run_quadratic(self, element, **options):
        text = [" + ".join(f"({c})*{'xyz'[j]}*{'xyz'[k]}" for (j, k), c in terms.items()) for terms in QUADRATIC]
        return scenes.run(box("linear_elastic", element, text, body_force()), **options).fields

    def test_linear_stress_is_exact(self):
        for element in ("hex20", "hex27", "tet10"):
            for ranks in (1, 2):
                with self.subTest(element=element, ranks=ranks):
                    fields = self.run_quadratic(element, ranks=ranks)
                    exact = []
                    for x in fields.coordinates:
                        gradient = quadratic_gradient(x)
                        exact.append(six(hooke(0.5 * (gradient + gradient.T))))
                    exact = np.array(exact)
                    self.assertGreater(np.ptp(exact, axis=0).min(), 0.02)  # every component varies
                    np.testing.assert_allclose(nodal_tensor(fields), exact, rtol=0, atol=1e-11)

    def test_elements_of_lower_order_come_near(self):
        """hex8 and tet4 do not have this field in them: better at the nodes than in the elements, and not exact."""
        for element in ("hex8", "tet4"):
            fields = self.run_quadratic(element)
            exact = np.array([six(hooke(0.5 * (g + g.T))) for g in map(quadratic_gradient, fields.coordinates)])
            error = np.abs(nodal_tensor(fields) - exact).max()
            self.assertTrue(1e-4 < error < 0.5 * np.ptp(exact, axis=0).max(), error)

    def test_borders_of_bodies_do_not_smear(self):
        """Two bodies of one mesh, side by side, stretched by the same along their border."""
        with tempfile.TemporaryDirectory() as folder:
            path = scenes.mesh(pathlib.Path(folder) / "pair.exo", "box", size=[2, 1, 1], divisions=[4, 2, 2])
            mesh = exodus_edit.read(path)
            cells = mesh.blocks[0].nodes
            left = mesh.x[cells][:, :, 0].mean(axis=1) < 1.0
            mesh.blocks = [exodus_edit.Block("left", 1, "HEX8", cells[left]),
                           exodus_edit.Block("right", 2, "HEX8", cells[~left])]
            mesh.side_sets = {}
            exodus_edit.write(path, mesh)
            soft = {"model": "linear_elastic", "young": 1.0, "poisson": 0.0}
            deck = {"mesh": {"file": "pair.exo"}, "materials": {"soft": soft, "hard": {**soft, "young": 10.0}},
                    "displacements": {"y0": {"set": "y0", "fix": ["x", "y", "z"]},
                                      "y1": {"set": "y1", "fix": ["x", "z"], "y": 0.01}},
                    "output": {"fields": ["nodal_stress"]}}
            right = {"blocks": ["right"], "material": "hard"}
            for first, bodies in (("left", {"left": {"blocks": ["left"], "material": "soft"}, "right": right}),
                                  ("right", {"right": right, "left": {"blocks": ["left"], "material": "soft"}})):
                for ranks in (1, 2):
                    with self.subTest(first=first, ranks=ranks):
                        fields = scenes.run({**deck, "bodies": bodies}, files=[path], ranks=ranks).fields
                        x = fields.coordinates[:, 0]
                        hard = x > 1 + 1e-9 if first == "left" else x > 1 - 1e-9
                        np.testing.assert_allclose(fields.nodal("nodal_stress_yy"), np.where(hard, 0.1, 0.01),
                                                   rtol=1e-9)


class Words(unittest.TestCase):
    def test_fields_are_those_asked_for(self):
        deck = box("linear_elastic", "hex8", linear())
        for words, element, nodal in ((None, [], []), (["strain"], ["strain_" + e for e in ENDS], []),
                                      (["nodal_stress"], [], ["nodal_stress_" + e for e in ENDS] + ["nodal_von_mises"])):
            fields = scenes.run(scenes.merged(deck, {"output": {"fields": words}})).fields
            self.assertEqual(fields.names("elem_var")[8:], element)
            self.assertEqual(fields.names("nod_var")[12:], nodal)

    def test_wrong_word(self):
        run = scenes.run(scenes.merged(box("linear_elastic", "hex8", linear()), {"output": {"fields": ["strian"]}}),
                         check=False)
        self.assertEqual(run.status, 2)
        self.assertRegex(run.output, r"scene.yaml:\d+: output.fields: unknown value 'strian'.*did you mean 'strain'\?")


class Vtk(unittest.TestCase):
    def test_a_tensor_is_one_array(self):
        """In the order that VTK's filters and ParaView's labels take six components in: xx yy zz xy yz xz."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOIOSS import vtkIOSSReader
        result = scenes.run(box("linear_elastic", "hex20", linear()))
        reader = vtkIOSSReader()
        reader.AddFileName(result.result_files[0])
        reader.UpdateInformation()
        for selection in (reader.GetElementBlockFieldSelection(), reader.GetNodeBlockFieldSelection()):
            selection.EnableAllArrays()
        times = reader.GetOutputInformation(0).Get(reader.GetExecutive().TIME_STEPS())
        reader.UpdateTimeStep(times[-1])
        grid = reader.GetOutputDataObject(0).GetPartition(0, 0)
        strain = 0.5 * (GRADIENT + GRADIENT.T)
        stress = hooke(strain)
        order = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]
        for data, name, tensor in ((grid.GetCellData(), "stress_tensor_", stress),
                                   (grid.GetCellData(), "strain_", strain),
                                   (grid.GetPointData(), "nodal_stress_", stress)):
            array = vtk_to_numpy(data.GetArray(name))
            self.assertEqual(array.shape[1], 6, name)
            np.testing.assert_allclose(array, np.broadcast_to([tensor[p] for p in order], array.shape), rtol=0,
                                       atol=1e-12)
        # The six fields of every run, of which this reader makes no tensor, keep their names.
        for name in ("stress_xx", "stress_xz", "von_mises", "principal_stress_max"):
            self.assertEqual(grid.GetCellData().GetArray(name).GetNumberOfComponents(), 1)
        self.assertEqual(grid.GetPointData().GetArray("reaction_").GetNumberOfComponents(), 3)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
