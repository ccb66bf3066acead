#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Nodes of a side set are the same on any number of ranks, those at its edge too.

The set ends where the mesh is cut between ranks, so that a rank owns nodes at its edge without a face of it.
"""
import pathlib
import tempfile
import unittest

import exodus_edit
import numpy as np
import scenes

DECK = {
    "mesh": {"file": "quarter.exo"},
    "materials": {"a": {"model": "linear_elastic", "young": 1, "poisson": 0.3}},
    "bodies": {"a": {"blocks": ["box"], "material": "a"}},
    "displacements": {"foot": {"set": "z0", "fix": ["x", "y", "z"]}, "head": {"set": "quarter", "z": -0.1}},
    "verify": {"count": scenes.probe("displacement_z", "quarter"), "force": scenes.probe("reaction_z", "quarter"),
               "foot": scenes.probe("reaction_z", "z0")},
}


class SideSets(unittest.TestCase):
    def test_prescribed_nodes_at_the_edge_of_a_part(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "quarter.exo"
            mesh = exodus_edit.read(scenes.mesh(path, "box", divisions=[6, 6, 3]))
            elements, sides = mesh.side_sets["z1"]
            center = mesh.x[mesh.blocks[0].nodes[elements]].mean(axis=1)
            inside = (center[:, :2] < 0.5).all(axis=1)
            mesh.side_sets["quarter"] = elements[inside], sides[inside]
            exodus_edit.write(path, mesh)
            one = scenes.run(DECK, ranks=1, files=[path])
            self.assertEqual(len(np.unique(mesh.blocks[0].nodes[elements[inside]][:, 4:])), 16)
            for ranks in (2, 4):
                more = scenes.run(DECK, ranks=ranks, files=[path])
                for name in ("count", "force", "foot"):
                    self.assertAlmostEqual(more.quantity(name), one.quantity(name), delta=1e-10, msg=(ranks, name))


if __name__ == "__main__":
    unittest.main(warnings="ignore")
