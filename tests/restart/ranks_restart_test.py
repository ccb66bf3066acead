#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pieces on other numbers of ranks: what the owners write is named by nodes, faces, bodies and joints."""
import unittest

import bodies_restart_test
import chain
import scenes
from contact_restart_test import ENFORCEMENTS, with_contact

TOLERANCE = 1e-10
COUNTS = ("steps", "augmentations", "cut_backs", "unknowns")  # iterations are a matter of rounding


class Ranks(chain.Restarted):
    def on_ranks(self, label, deck, ranks, vectors=("displacement",)):
        whole = chain.one_piece(deck, ranks=1)
        pieces = chain.in_pieces(deck, ranks)
        most = self.same_end(whole, pieces[-1], TOLERANCE, COUNTS, vectors)
        print(f"{label} on {ranks} ranks: difference {most:.1e}", flush=True)

    def test_contact(self):
        for formulation, enforcement, friction, ranks in (
                ("facet_on_facet", "dual", 0.3, (1, 2, 1, 4)),
                ("sliding_elastic", "per_point", 10.0, (2, 1, 4, 2)),
                ("node_on_facet", "smoothed", 0.3, (1, 4, 2, 1)),
                ("facet_on_facet", "penalty", 10.0, (2, 2, 1, 2))):
            with self.subTest(formulation=formulation, enforcement=enforcement, friction=friction):
                self.on_ranks(f"{formulation} {enforcement} mu {friction:g}",
                              with_contact(formulation=formulation, friction=friction, **ENFORCEMENTS[enforcement]),
                              ranks)

    def test_dynamics(self):
        self.on_ranks("dynamics", bodies_restart_test.Bodies().dynamic(0.6), (1, 2, 4, 1), ("displacement", "velocity", "acceleration"))

    def test_same_file_on_any_number(self):
        """Rows are written by their names: a state does not show on how many ranks it was reached."""
        deck = scenes.merged(with_contact(friction=0.3), {"output": {"checkpoint": {"every": 1000}}})
        pieces = [chain.in_pieces(deck, (ranks,), (2,))[0] for ranks in (1, 4)]
        self.assertEqual(*(chain.facts(chain.checkpoint(p))["arrays"] for p in pieces))


if __name__ == "__main__":
    unittest.main(warnings="ignore")
