#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a run leaves on disk: names, times, ids, parts of a parallel run, the summary; VTK opens it."""
import pathlib
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

import exodus_edit
import netCDF4
import numpy as np
import scenes

NODAL = ["displacement_x", "displacement_y", "displacement_z", "contact_pressure", "contact_gap",
         "contact_traction_x", "contact_traction_y", "contact_traction_z", "contact_status",
         "reaction_x", "reaction_y", "reaction_z"]
ELEMENT = ["stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_xz", "von_mises",
           "energy"]
GLOBAL = ["steps", "newton_iterations", "augmentations", "cut_backs", "work_in", "energy_stored", "energy_penalty",
          "energy_friction", "energy_imbalance", "audit_overlap", "audit_overlap_over_face_size",
          "audit_unseen_overlap", "audit_tension", "audit_cone", "audit_balance",
          *(f"pair_{name}_{axis}" for name in ("force", "moment") for axis in "xyz"),
          *("pair_" + name for name in ("area", "points", "stick_points", "slip_points", "gap_max", "gap_mean",
                                        "penetration_max", "penetration_mean", "pressure_max", "slip_max")),
          *(f"{place}_{name}_{axis}" for place in ("bottom", "top") for name in ("reaction", "reaction_moment")
            for axis in "xyz")]
SUMMARY = ["status", "deck", "title", "results", "ranks", "unknowns", "steps", "t", "extrapolated_steps", "newton_iterations", "augmentations",
           "linear_iterations", "linear_solver", "cut_backs", "wall_seconds", "phase_seconds", "waiting_seconds", "peak_memory_mb",
           "contact", "energy", "penalty_error", "audit", "verify", "warnings", "convergence"]
PHASES = ["search", "contact", "solid", "assembly", "linear_solve", "output"]
CONTACT = ["formulation", "enforcement", "active_points", "stick_points", "slip_points", "force",
           "max_pressure", "max_penetration", "max_penetration_over_face_size", "max_slip", "flips",
           "friction_dissipation", "penalty_energy", "penalty_error", "penetration_over_approach", "initial_overlap",
           "shifted_points", "max_shift", "penalty_factor", "primary", "secondary", "choices"]

DECK = {
    "title": "Two blocks",
    "mesh": {"file": "blocks.exo"},
    "materials": {"soft": {"young": 1.0, "poisson": 0.3}, "stiff": {"young": 4.0, "poisson": 0.2}},
    "bodies": {"lower": {"blocks": ["lower"], "material": "stiff"},
               "upper": {"blocks": ["upper"], "material": "soft"}},
    "displacements": {"bottom": {"set": "lower_bottom", "fix": ["x", "y", "z"]},
                      "top": {"set": "upper_top", "x": 0.01, "y": 0.0, "z": -0.1, "curve": "press"}},
    "curves": {"press": [[0, 0], [0.5, 0.8], [2, 1]]},
    "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top"}},
    "time": {"end": 2, "steps": 4},
    "verify": {"force": {"quantity": "force_z", "place": "pair", "expected": 0.05, "tolerance": 1}},
}


def xml(name, value, indent=""):
    """A Teuchos parameter list of a deck."""
    if isinstance(value, dict):
        inner = "".join(xml(key, entry, indent + "  ") for key, entry in value.items())
        return f"{indent}<ParameterList name={quoteattr(name)}>\n{inner}{indent}</ParameterList>\n"
    if isinstance(value, list) and isinstance(value[0], list):
        rows = ", ".join(str(x) for row in value for x in row)
        text, kind = f"{len(value)}x{len(value[0])}:{{{rows}}}", "TwoDArray(double)"
    elif isinstance(value, list):
        text = "{" + ", ".join(str(x) for x in value) + "}"
        kind = "Array(string)" if isinstance(value[0], str) else "Array(double)"
    else:
        text, kind = str(value), {str: "string", int: "int", float: "double"}[type(value)]
    return f"{indent}<Parameter name={quoteattr(name)} type={quoteattr(kind)} value={quoteattr(text)}/>\n"


class Output(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="abut_output_")
        cls.path = pathlib.Path(cls.folder.name)
        cls.mesh_path = scenes.mesh(cls.path / "blocks.exo", "blocks")
        mesh = exodus_edit.read(cls.mesh_path)
        random = np.random.default_rng(5)
        mesh.node_map = 1000 + random.permutation(3 * len(mesh.x))[:len(mesh.x)]
        mesh.element_map = 500000 + random.permutation(mesh.num_elements)
        mesh.blocks[0].id, mesh.blocks[1].id = 70, 30
        exodus_edit.write(cls.mesh_path, mesh)
        cls.mesh = mesh
        cls.run_ = scenes.run(DECK, files=[cls.mesh_path])

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_names_and_times(self):
        fields = self.run_.fields
        self.assertEqual(fields.names("nod_var"), NODAL)
        self.assertEqual(fields.names("elem_var"), ELEMENT)
        self.assertEqual(fields.names("glo_var"), GLOBAL)
        np.testing.assert_array_equal(fields.times, [0.0, 0.5, 1.0, 1.5, 2.0])
        top = fields.node_set("upper_top")
        for step, factor in enumerate([0.0, 0.8, 0.8 + 0.2 / 3, 0.8 + 0.4 / 3, 1.0]):
            np.testing.assert_allclose(fields.nodal("displacement_z", step)[top], -0.1 * factor,
                                       rtol=1e-14)

    def test_fields_make_sense(self):
        fields, contact = self.run_.fields, self.run_.contact()
        pressure, gap = fields.nodal("contact_pressure"), fields.nodal("contact_gap")
        primary = fields.node_set("upper_bottom")
        self.assertTrue((pressure[primary] > 0).all())
        self.assertTrue((gap[primary] < 0).all())
        self.assertEqual(np.count_nonzero(pressure), len(primary) + len(fields.node_set("lower_top")))
        self.assertAlmostEqual(pressure[primary].max(), contact["max_pressure"], delta=1e-12)
        np.testing.assert_array_equal(fields.nodal("contact_status")[primary], 1)
        # The primary surface looks down and is pushed up.
        self.assertTrue((fields.nodal("contact_traction_z")[primary] > 0).all())
        self.assertGreater(self.run_.force()[2], 0.0)
        values = fields.globals()
        np.testing.assert_array_equal([values["pair_force_" + axis] for axis in "xyz"],
                                      self.run_.force())
        for name in ("steps", "newton_iterations", "augmentations", "cut_backs"):
            self.assertEqual(values[name], self.run_.summary[name])
        self.assertTrue((fields.element("stress_zz", "lower") < 0).all())
        self.assertTrue((fields.element("energy", "upper") > 0).all())
        self.assertEqual(np.abs(fields.element("von_mises", "upper", 0)).max(), 0.0)

    def test_ids_and_names_of_the_input_are_kept(self):
        output = exodus_edit.read(self.run_.result_files[0])
        np.testing.assert_array_equal(output.node_map, self.mesh.node_map)
        np.testing.assert_array_equal(output.element_map, self.mesh.element_map)
        np.testing.assert_array_equal(output.x, self.mesh.x)
        self.assertEqual([(b.name, b.id, b.kind) for b in output.blocks],
                         [("lower", 70, "HEX8"), ("upper", 30, "HEX8")])
        for got, expected in zip(output.blocks, self.mesh.blocks):
            np.testing.assert_array_equal(got.nodes, expected.nodes)
        self.assertEqual(sorted(output.side_sets), sorted(self.mesh.side_sets))
        # IOSS, through which ParaView reads, takes each name once: see stress_test.py.
        self.assertEqual(sorted(output.node_sets), sorted(name + "_nodes" for name in self.mesh.node_sets))
        self.assertEqual(sorted(self.mesh.node_sets), sorted(self.mesh.side_sets))

    def test_one_file_of_two_ranks_equals_that_of_one(self):
        two = scenes.run(DECK, ranks=2, files=[self.mesh_path])
        self.assertEqual(len(two.result_files), 1)
        a, b = self.run_.fields, two.fields
        for key in ("node_map", "element_map", "coordinates", "times"):
            np.testing.assert_array_equal(getattr(a, key), getattr(b, key))
        for name in NODAL:
            np.testing.assert_allclose(b.nodal(name), a.nodal(name), rtol=0,
                                       atol=1e-11 * max(1e-3, np.abs(a.nodal(name)).max()))
        for block in ("lower", "upper"):
            for name in ELEMENT:
                np.testing.assert_allclose(b.element(name, block), a.element(name, block), rtol=0,
                                           atol=1e-11)

    def test_per_rank_files_cover_the_mesh_once(self):
        run = scenes.run(scenes.merged(DECK, {"output": {"files": "per_rank"}}), ranks=3,
                         files=[self.mesh_path])
        self.assertEqual([pathlib.Path(p).name for p in run.result_files],
                         [f"scene.exo.3.{rank}" for rank in range(3)])
        elements, nodes = [], {}
        for path in run.result_files:
            part = exodus_edit.read(path)
            fields = scenes.Fields(path)
            self.assertEqual([b.name for b in part.blocks], ["lower", "upper"])
            self.assertEqual(fields.names("nod_var"), NODAL)
            np.testing.assert_array_equal(fields.times, self.run_.fields.times)
            elements += list(part.element_map)
            for node, x in zip(part.node_map, part.x):
                np.testing.assert_array_equal(nodes.setdefault(node, x), x)
        self.assertEqual(sorted(elements), sorted(self.mesh.element_map))
        self.assertEqual(sorted(nodes), sorted(self.mesh.node_map))

    def test_more_ranks_than_elements(self):
        deck = scenes.merged(DECK, {"mesh": {"file": None, "generate": {
            "kind": "blocks", "lower_divisions": [1, 1, 1], "upper_divisions": [1, 1, 1]}},
            "output": {"files": "per_rank"}})
        run = scenes.run(deck, ranks=4)
        self.assertEqual(len(run.result_files), 4)
        elements = []
        for path in run.result_files:
            with netCDF4.Dataset(path) as part:
                np.testing.assert_array_equal(part["time_whole"][:], self.run_.fields.times)
                elements.append(len(part.dimensions["num_elem"]) if "num_elem" in part.dimensions else 0)
        self.assertEqual(sorted(elements), [0, 0, 1, 1])

    def test_vtk_opens_it(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOExodus import vtkExodusIIReader
        reader = vtkExodusIIReader()
        reader.SetFileName(self.run_.result_files[0])
        reader.UpdateInformation()
        names = [reader.GetPointResultArrayName(i)
                 for i in range(reader.GetNumberOfPointResultArrays())]
        # VTK makes vectors of names that end in x, y, z.
        self.assertEqual(sorted(names), ["contact_gap", "contact_pressure", "contact_status",
                                         "contact_traction_", "displacement_", "reaction_"])
        self.assertEqual(sorted(reader.GetElementBlockArrayName(i).split()[0]
                                for i in range(reader.GetNumberOfElementBlockArrays())),
                         ["lower", "upper"])
        for name in names:
            reader.SetPointResultArrayStatus(name, 1)
        reader.SetApplyDisplacements(0)
        info = reader.GetExecutive().GetOutputInformation(0)
        times = info.Get(reader.GetExecutive().TIME_STEPS())
        np.testing.assert_array_equal(times, [0.0, 0.5, 1.0, 1.5, 2.0])
        reader.GetExecutive().SetUpdateTimeStep(0, times[-1]) if hasattr(
            reader.GetExecutive(), "SetUpdateTimeStep") else reader.SetTimeStep(len(times) - 1)
        reader.Update()
        blocks = reader.GetOutput().GetBlock(0)
        count, deepest = 0, 0.0
        for i in range(blocks.GetNumberOfBlocks()):
            grid = blocks.GetBlock(i)
            count += grid.GetNumberOfCells()
            u = vtk_to_numpy(grid.GetPointData().GetArray("displacement_"))
            self.assertEqual(u.shape[1], 3)
            deepest = min(deepest, u[:, 2].min())
        self.assertEqual(count, self.mesh.num_elements)
        self.assertAlmostEqual(deepest, -0.1, delta=1e-14)

    def test_summary_keys(self):
        summary = self.run_.summary
        self.assertEqual(list(summary), SUMMARY)
        self.assertEqual(list(summary["phase_seconds"]), PHASES)
        self.assertEqual(list(summary["contact"]), ["pair"])
        self.assertEqual(list(summary["contact"]["pair"]), CONTACT)
        self.assertEqual(len(summary["contact"]["pair"]["force"]), 3)
        self.assertEqual([list(entry) for entry in summary["verify"]],
                         [["name", "value", "expected", "tolerance", "ok"]])
        self.assertEqual(summary["status"], "converged")
        self.assertEqual(summary["unknowns"], 3 * len(self.mesh.x))
        self.assertGreater(summary["peak_memory_mb"], 1)
        self.assertGreaterEqual(summary["wall_seconds"], sum(summary["phase_seconds"].values()) / 2)
        least, most = summary["waiting_seconds"]
        self.assertTrue(0.0 < least <= most < summary["wall_seconds"])

    def test_cost_of_the_linear_solver(self):
        deck = scenes.merged(DECK, {"linear_solver": {"method": "krylov"}})
        use = scenes.run(deck, files=[self.mesh_path]).summary["linear_solver"]["krylov with multigrid"]
        self.assertGreater(min(use["setup_seconds"], use["apply_seconds"]), 0.0)
        self.assertLess(use["setup_seconds"] + use["apply_seconds"], use["seconds"])

    def test_xml_and_yaml_give_identical_results(self):
        path = self.path / "scene.xml"
        path.write_text(xml("abut", DECK))
        other = scenes.run(path, files=[self.mesh_path])
        with netCDF4.Dataset(self.run_.result_files[0]) as a, \
                netCDF4.Dataset(other.result_files[0]) as b:
            self.assertEqual(list(a.variables), list(b.variables))
            for name in a.variables:
                a[name].set_auto_mask(False)
                b[name].set_auto_mask(False)
                if "qa_records" not in name:
                    np.testing.assert_array_equal(a[name][:], b[name][:], name)
        for key in ("steps", "newton_iterations", "contact"):
            self.assertEqual(self.run_.summary[key], other.summary[key])


if __name__ == "__main__":
    unittest.main(warnings="ignore")
