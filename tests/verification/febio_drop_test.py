# SPDX-License-Identifier: BSD-3-Clause
"""An imported model of dynamics: a rigid cube dropped on a plate."""
import pathlib
import shutil
import tempfile
import unittest

import numpy

import scenes
from febio_cubes import CORNERS, EXACT


def dropped(control, cells=6, height=0.05):
    """A rigid cube above a plate of cells x cells elements whose rim is clamped; all with their weight."""
    number = cells + 1
    nodes = [(x / cells * 3, y / cells * 3, z) for z in (-0.25, 0) for y in range(number) for x in range(number)]
    plate = [(o + x + number * y + 1, o + x + 1 + number * y + 1, o + x + 1 + number * (y + 1) + 1,
              o + x + number * (y + 1) + 1) for o in (0, number**2) for y in range(cells) for x in range(cells)]
    bottom, top = plate[:cells**2], plate[cells**2:]
    first = len(nodes) + 1
    nodes += [(1 + x, 1 + y, z + height) for z in (0, 1) for x, y in CORNERS]
    rim = [i + 1 for i, (x, y, _) in enumerate(nodes[:first - 1]) if x in (0, 3) or y in (0, 3)]
    text = "".join(f'<node id="{i}">{x},{y},{z}</node>' for i, (x, y, z) in enumerate(nodes, start=1))
    elements = "".join(f'<elem id="{i}">{",".join(map(str, below + above))}</elem>'
                       for i, (below, above) in enumerate(zip(bottom, top), start=1))
    faces = "".join(f'<quad4 id="{i}">{",".join(map(str, face))}</quad4>' for i, face in enumerate(top, start=1))
    cube = list(range(first, first + 8))
    under = ",".join(map(str, reversed(cube[:4])))
    return f'''<?xml version="1.0" encoding="UTF-8"?>
<febio_spec version="4.0"><Module type="solid"/>{control}
  <Material>
    <material id="1" name="plate" type="neo-Hookean"><density>1</density><E>500</E><v>0.4</v></material>
    <material id="2" name="cube" type="rigid body"><density>1</density></material>
  </Material>
  <Mesh><Nodes name="all">{text}</Nodes>
    <Elements type="hex8" name="plate">{elements}</Elements>
    <Elements type="hex8" name="cube"><elem id="999">{",".join(map(str, cube))}</elem></Elements>
    <NodeSet name="rim">{",".join(map(str, rim))}</NodeSet>
    <Surface name="over">{faces}</Surface><Surface name="under"><quad4 id="1">{under}</quad4></Surface>
    <SurfacePair name="pair"><primary>over</primary><secondary>under</secondary></SurfacePair>
  </Mesh>
  <MeshDomains><SolidDomain name="plate" mat="plate"/><SolidDomain name="cube" mat="cube"/></MeshDomains>
  <Boundary><bc name="rim" node_set="rim" type="zero displacement">
    <x_dof>1</x_dof><y_dof>1</y_dof><z_dof>1</z_dof></bc></Boundary>
  <Rigid><rigid_bc name="guide" type="rigid_fixed"><rb>cube</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof>
    <Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc></Rigid>
  <Loads><body_load name="weight" type="const"><z>1</z></body_load></Loads>
  <Contact><contact name="land" surface_pair="pair" type="sliding-facet-on-facet"><penalty>200</penalty>
    <two_pass>1</two_pass></contact></Contact>
</febio_spec>
'''


class Dropped(unittest.TestCase):
    def run_dropped(self, rule="", steps=60, ranks=None):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="abut_drop_"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        file = folder / "drop.feb"
        file.write_text(dropped(f'''<Control><analysis>DYNAMIC</analysis><time_steps>{steps}</time_steps>
          <step_size>{1.5 / steps}</step_size><solver type="solid">{EXACT}{rule}</solver></Control>'''))
        status, output = scenes.execute([scenes.EXECUTABLE, "import", str(file), "--output-dir", str(folder)], 60)
        self.assertEqual(status, 0, output)
        deck = folder / "drop.yaml"
        deck.write_text(deck.read_text() + "newton: {tolerance: 1e-11}\n")
        return scenes.run(deck, files=[folder / "drop.exo"], ranks=ranks)

    def test_falls_and_bounces(self):
        """The cube falls freely, z = - t^2/2, lands on the plate, and what it loses in height is work of its weight:
        the ledger closes to second order in the step."""
        imbalances = []
        for steps in (60, 120):
            result = self.run_dropped(steps=steps)
            fields = result.fields
            height = numpy.array([fields.globals(k)["cube_displacement_z"] for k in range(len(fields.times))])
            force = numpy.array([fields.globals(k)["land_force_z"] for k in range(len(fields.times))])
            falling = fields.times < 0.25  # 0.05 takes 0.316
            numpy.testing.assert_allclose(height[falling], -0.5 * fields.times[falling]**2, rtol=0, atol=1e-12)
            self.assertTrue((force[falling] == 0).all())
            self.assertGreater(abs(force).max(), 1)  # more than the weight of the cube
            self.assertLess(height.min(), -0.055)    # the plate gives way
            lowest = height.argmin()
            self.assertGreater(height[lowest:].max(), height.min() + 0.02)  # it comes up again
            energy = result.summary["energy"]
            imbalances.append(max(abs(fields.globals(k)["energy_imbalance"]) for k in range(len(fields.times))) / 0.05)
            self.assertGreater(energy["kinetic"] + energy["stored"], 0.01)
        print(f"imbalance over the energy of the fall {imbalances[0]:.1e} {imbalances[1]:.1e}", flush=True)
        self.assertLess(imbalances[1], 0.05)
        self.assertLess(imbalances[1], 0.5 * imbalances[0])

    def test_two_ranks(self):
        one, two = (self.run_dropped("<rhoi>0.7</rhoi>", ranks=n) for n in (1, 2))
        order = [numpy.argsort(r.fields.node_map) for r in (one, two)]
        u = [r.fields.vector("displacement")[o] for r, o in zip((one, two), order)]
        self.assertGreater(abs(u[0]).max(), 0.01)
        numpy.testing.assert_allclose(u[0], u[1], rtol=0, atol=1e-10)


if __name__ == "__main__":
    unittest.main()
