# SPDX-License-Identifier: BSD-3-Clause
"""Two elastic cylinders, pressed together in one step from touch by a hundredth to a tenth of their radius.
usage: cold_start_test.py [unittest arguments] [--meshes 6 12]: faces over the half width of contact, about

The predicted state overlaps by up to twenty times what the springs of the penalty carry at a pressure of E. From there
Newton with full springs walks the contact's edge from face to face, up to 92 iterations and 4 cuts on 24 faces; with
springs as soft as the bodies first (SolveKind::approach) it takes 7 to 14, and they do not grow with the mesh. The law at
nodes (dual) takes 8 to 15 in facet_on_facet on the meshes asked here; on finer ones, and in sliding_elastic, it still
cuts steps."""
import math
import unittest

import scenes
import study

RADIUS = 0.5
KNOWN = study.arguments([6, 12])
WAYS = {
    "penalty": {},
    "smoothed": {"enforcement": "augmented_lagrangian", "multipliers": "smoothed"},
    "dual": {"enforcement": "augmented_lagrangian", "multipliers": "dual"},
}
FINEST = {"dual": 12}  # faces up to which no step is cut; the others have no limit


def deck(approach, faces, **contact):
    core = 1.2 * math.sqrt(RADIUS * approach)
    upper = max(2, round(0.6 * faces))
    generate = {"kind": "two_cylinders", "core": core, "upper_facets": upper, "lower_facets": max(2, 2 * upper // 3),
                "growth": 1.4, "thickness": core / upper}
    fixed = {"symmetry": ["x0", "x"], "front": ["y0", "y"], "back": ["y1", "y"], "bottom": ["lower_bottom", "z"]}
    displacements = {name: {"set": where, "fix": [axis]} for name, (where, axis) in fixed.items()}
    displacements["top"] = {"set": "upper_top", "z": -2 * approach}
    return {
        "mesh": {"generate": generate},
        "materials": {"elastic": {"model": "neo_hookean", "young": 1, "poisson": 0.3}},
        "bodies": {name: {"blocks": [name], "material": "elastic"} for name in ("upper", "lower")},
        "displacements": displacements,
        "contact": {"pair": {"primary": "upper_contact", "secondary": "lower_contact", **contact}},
    }


class ColdStart(unittest.TestCase):
    def press(self, formulation, way, bound):
        for approach in (0.005, 0.02, 0.05):
            forces = []
            for faces in (n for n in KNOWN.meshes if n <= FINEST.get(way, math.inf)):
                with self.subTest(formulation=formulation, way=way, approach=approach, faces=faces):
                    scene = deck(approach, faces, formulation=formulation, **WAYS[way])
                    result = scenes.run(scene, seconds=300)
                    s = result.summary
                    last = len(result.fields.times) - 1
                    force = abs(result.fields.globals(last)["pair_force_z"]) / scene["mesh"]["generate"]["thickness"]
                    print(f"{formulation:16s} {way:8s} approach {approach:5.3f}, {faces:2d} faces: "
                          f"{s['newton_iterations']:2d} iterations, {s['cut_backs']} cuts, force {force:.5f}", flush=True)
                    self.assertEqual(s["cut_backs"], 0)
                    self.assertLessEqual(s["newton_iterations"], bound)
                    forces.append(force)
            if not forces:
                continue
            with self.subTest(formulation=formulation, way=way, approach=approach):
                self.assertGreater(min(forces), 0.15 * approach)  # they do press
                self.assertLess(max(forces) / min(forces), 1.1)  # and end in one state

    def test_cold_steps(self):
        for formulation in ("facet_on_facet", "sliding_elastic"):
            for way in WAYS:
                if (formulation, way) != ("sliding_elastic", "dual"):
                    self.press(formulation, way, 25)


if __name__ == "__main__":
    study.main()
