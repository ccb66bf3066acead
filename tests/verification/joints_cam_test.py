# SPDX-License-Identifier: BSD-3-Clause
"""A cam on a hinge, a follower on a guide, contact between them."""
import pathlib
import shutil
import tempfile
import unittest
from math import cos, pi, sin, sqrt

import numpy

import scenes
from mechanisms import FORCE, Scene, brick, free_body, hinge, mesh_of, vector


class Cam(Scene):
    """A round cam turns about a point off its center and lifts a flat follower against a spring."""
    RADIUS, OFF, FACETS, STEPS, STIFFNESS, PENALTY = 1.0, 0.3, 96, 24, 10.0, 1e4

    def cam(self):
        """A ring of bricks about (OFF, 0)."""
        nodes, cells = [], []
        for i in range(self.FACETS):
            a = 2 * pi * i / self.FACETS
            for r in (0.4, self.RADIUS):
                for z in (-0.1, 0.1):
                    nodes.append((self.OFF + r * cos(a), r * sin(a), z))
            n, m = 4 * i, 4 * ((i + 1) % self.FACETS)
            # bottom: inner, outer, next outer, next inner; side 2 is the outer face
            cells.append((n, n + 2, m + 2, m, n + 1, n + 3, m + 3, m + 1))
        return nodes, cells

    def blocks(self):
        return {"cam": self.cam(),
                "follower": brick((0, self.RADIUS + 0.1, 0), (4, 0.2, 0.2))}

    def scene(self):
        low = self.RADIUS
        mesh = mesh_of(self.blocks(), {"rim": [("cam", i, 1) for i in range(self.FACETS)],
                                       "flat": [("follower", 0, 0)]})
        deck = {
            "bodies": {"cam": free_body("cam", (self.OFF, 0.0)),
                       "follower": free_body("follower", (0, low + 0.1))},
            "joints": {"drive": hinge("revolute", ["ground", "cam"], (0, 0), rotation=2 * pi),
                       "guide": {"kind": "prismatic", "bodies": ["ground", "follower"],
                                 "axis": [0, 1, 0], "origin": [0, low + 0.1, 0]},
                       "spring": {"kind": "spring", "bodies": ["follower", "ground"],
                                  "from": [0, low + 0.2, 0], "to": [0, low + 2.2, 0],
                                  "stiffness": self.STIFFNESS, "free_length": 2.5}},
            "contact": {"pair": {"primary": "rim", "secondary": "flat",
                                 "formulation": "sliding_elastic", "penalty": self.PENALTY,
                                 "reach": 30}},
            "time": {"steps": self.STEPS}}
        return mesh, deck

    def test_lift_and_forces(self):
        self.check(self.solve(*self.scene()))

    def test_same_on_all_ranks(self):
        one, here = self.solve(*self.scene(), ranks=1), self.solve(*self.scene())
        self.same(one, here, self.STEPS, self.STIFFNESS)

    def febio(self):
        """The same from a FEBio file; its ground is a rigid body that is fixed."""
        blocks = {**self.blocks(), "frame": brick((0, -3, 0), 0.5)}
        nodes, parts, first, element = [], [], {}, 0
        for name, (x, cells) in blocks.items():
            first[name] = len(nodes) + 1
            nodes += [",".join(f"{v:.17g}" for v in point) for point in x]
            elements = ""
            for cell in cells:
                element += 1
                ids = ",".join(str(first[name] + n) for n in cell)
                elements += f'<elem id="{element}">{ids}</elem>'
            parts.append(f'<Elements type="hex8" name="{name}">{elements}</Elements>')
        nodes = "".join(f'<node id="{i}">{x}</node>' for i, x in enumerate(nodes, 1))
        faces = [(c[1], c[2], c[6], c[5]) for c in blocks["cam"][1]]
        rim = "".join(f'<quad4 id="{i}">' + ",".join(str(first["cam"] + n) for n in face) +
                      "</quad4>" for i, face in enumerate(faces, 1))
        flat = ",".join(str(first["follower"] + n) for n in (0, 1, 5, 4))
        materials = "".join(f'<material id="{i}" name="rigid {name}" type="rigid body">'
                            "<density>1</density></material>" for i, name in enumerate(blocks, 1))
        domains = "".join(f'<SolidDomain name="{name}" mat="rigid {name}"/>' for name in blocks)
        penalties = "<tolerance>0</tolerance><force_penalty>1e6</force_penalty>" \
                    "<moment_penalty>1e6</moment_penalty>"
        top = self.RADIUS + 0.2
        return f'''<?xml version="1.0" encoding="UTF-8"?>
<febio_spec version="4.0"><Module type="solid"/>
<Control><time_steps>{self.STEPS}</time_steps><step_size>{1 / self.STEPS:.17g}</step_size>
<solver type="solid"><dtol>0</dtol></solver></Control>
<Material>{materials}</Material>
<Mesh><Nodes name="all">{nodes}</Nodes>{"".join(parts)}
<Surface name="rim">{rim}</Surface><Surface name="flat"><quad4 id="1">{flat}</quad4></Surface>
<SurfacePair name="pair"><primary>rim</primary><secondary>flat</secondary></SurfacePair></Mesh>
<MeshDomains>{domains}</MeshDomains>
<Rigid>
<rigid_bc name="held" type="rigid_fixed"><rb>rigid frame</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof>
<Rz_dof>1</Rz_dof><Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>
<rigid_connector name="drive" type="rigid revolute joint">{penalties}
<body_a>rigid frame</body_a><body_b>rigid cam</body_b><joint_origin>0,0,0</joint_origin>
<rotation_axis>0,0,1</rotation_axis><transverse_axis>1,0,0</transverse_axis>
<prescribed_rotation>1</prescribed_rotation><rotation lc="1">{2 * pi:.17g}</rotation>
<moment>0</moment></rigid_connector>
<rigid_connector name="guide" type="rigid prismatic joint">{penalties}
<body_a>rigid frame</body_a><body_b>rigid follower</body_b>
<joint_origin>0,{self.RADIUS + 0.1},0</joint_origin><translation_axis>0,1,0</translation_axis>
<transverse_axis>1,0,0</transverse_axis></rigid_connector>
<rigid_connector name="spring" type="rigid spring"><body_a>rigid follower</body_a>
<body_b>rigid frame</body_b><k>{self.STIFFNESS}</k><insertion_a>0,{top},0</insertion_a>
<insertion_b>0,{top + 2},0</insertion_b><free_length>2.5</free_length></rigid_connector>
</Rigid>
<Contact><contact name="pair" surface_pair="pair" type="sliding-elastic"><penalty>{self.PENALTY}</penalty>
<search_radius>5</search_radius></contact></Contact>
<LoadData><load_controller id="1" type="loadcurve"><points><pt>0,0</pt><pt>1,1</pt></points>
</load_controller></LoadData></febio_spec>'''

    def test_from_febio(self):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / "cam.feb").write_text(self.febio())
        top = self.RADIUS + 2.2
        status, output = scenes.execute([scenes.EXECUTABLE, "import", str(folder / "cam.feb"),
                                         "--output-dir", str(folder)], 60)
        self.assertEqual(status, 0, output)
        self.assertIn("abut holds joints exactly", (folder / "cam.import.txt").read_text())
        result = scenes.run(folder / "cam.yaml", files=[folder / "cam.exo"])
        self.check(result)
        # What holds the frame balances what its three joints carry.
        for step in range(1, self.STEPS + 1):
            found = result.fields.globals(step)
            force = vector(found, "drive_force") + vector(found, "guide_force") - \
                vector(found, "spring_force")
            self.close(vector(found, "rigid_frame_force"), force, 1e-12)
            self.assertGreater(found["drive_force_y"], 1.0)
            at = numpy.array([0, self.RADIUS + 0.1 + found["guide_translation"], 0])
            moment = vector(found, "drive_moment") + vector(found, "guide_moment") + \
                numpy.cross(at, vector(found, "guide_force")) - \
                numpy.cross([0, top, 0], vector(found, "spring_force"))
            self.close(vector(found, "rigid_frame_moment"), moment, 1e-12)

    def check(self, result):
        self.assertEqual(result.summary["cut_backs"], 0)
        sagitta = self.RADIUS * (1 - cos(pi / self.FACETS))
        lifts = []
        for step in range(1, self.STEPS + 1):
            found = result.fields.globals(step)
            lift, angle = found["guide_translation"], 2 * pi * step / self.STEPS
            press = self.STIFFNESS * (0.5 + lift)
            self.close(found["spring_force_y"], press, FORCE)
            self.close(found["pair_force_y"], -press, FORCE)
            self.close(found["drive_moment_z"], press * self.OFF * cos(angle), FORCE)
            self.close(vector(found, "guide_force"), 0, FORCE)
            # A circle in a flat bed of springs, of a width of 0.2: force 4/3 w eps d sqrt(2 R d).
            depth = (press / (4 / 3 * 0.2 * self.PENALTY * sqrt(2 * self.RADIUS)))**(2 / 3)
            self.close(lift, self.OFF * sin(angle) - depth, sagitta)
            lifts.append(lift)
        self.assertGreater(max(lifts) - min(lifts), 1.9 * self.OFF)
        self.assertGreater(result.contact()["active_points"], 0)


if __name__ == "__main__":
    unittest.main()
