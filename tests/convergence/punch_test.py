# SPDX-License-Identifier: BSD-3-Clause
"""Flat rigid punch: share of the load away from the edge, force, growth of the largest pressure.
usage: punch_test.py [--meshes 10 20] [--formulation WORD]; faces over the half width

The edge lies on a line of the mesh or half a cell inside one, and body or punch carry the points. The
margin beyond a face within which a projection counts is taken away: beyond the rim of the punch it would
widen the punch by a hundredth of its faces.
"""
import unittest

import punch
import study

KNOWN = study.arguments([10, 20])
CONTACT = {"penalty_factor": 100, "projection_margin": 1e-6}


class Punch(unittest.TestCase):
    def study(self, shape, meshes, offset, body_primary):
        print(f"\n{shape}, edge {offset} cells inside a line, {'body' if body_primary else 'punch'} primary")
        runs = []
        for facets in meshes:
            deck = punch.scene(shape, facets, offset, body_primary, **study.contact(KNOWN, **CONTACT))
            runs.append(punch.Errors(deck))
            print(f"  {facets:3d}  {runs[-1]}", flush=True)
            self.assertGreater(runs[-1].active, 0)
        if len(meshes) > 1:
            share = study.order(meshes, [run.share for run in runs])
            growth = -study.order(meshes, [run.peak for run in runs])
            print(f"  order of the share {share:.2f}, largest pressure grows with h^-{growth:.3f}")
            self.assertGreater(growth, 0.45)  # 1/2 from the singularity
            self.assertLess(growth, 0.55)
        return runs

    def test_strip(self):
        for offset in (0, 0.5) if KNOWN.thorough else (0.5,):
            for body_primary in (True, False):
                with self.subTest(offset=offset, body_primary=body_primary):
                    runs = self.study("strip", KNOWN.meshes, offset, body_primary)
                    self.assertLess(abs(runs[-1].share), abs(runs[0].share))
                    # one cell at the edge more or less; of single nodes at the edge half a face more
                    self.assertLess(abs(runs[-1].share), (1.5 if KNOWN.nodal else 1) / KNOWN.meshes[-1])

    def test_disc(self):
        meshes = KNOWN.meshes[:len(KNOWN.meshes) - 1]
        for body_primary in (True, False) if KNOWN.thorough else (True,):
            with self.subTest(body_primary=body_primary):
                runs = self.study("disc", meshes, 0, body_primary)
                self.assertLess(abs(runs[-1].force), 0.5 / meshes[-1])


if __name__ == "__main__":
    study.main()
