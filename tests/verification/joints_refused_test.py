# SPDX-License-Identifier: BSD-3-Clause
"""What joints cannot do is refused, or stops the run, with the name of the joint."""
import unittest

import scenes
from mechanisms import POSITION, Scene, bar, brick, free_body, hinge, mesh_of


class Refused(Scene):
    def deck(self, **joint):
        self.mesh = mesh_of({"link": bar((0, 0), (1, 0)), "rail": bar((0, 1), (1, 1))})
        return {"bodies": {"link": free_body("link", (0, 0)),
                           "rail": {"blocks": ["rail"], "rigid": {}}},
                "joints": {"pin": {**hinge("revolute", ["rail", "link"], (0, 0), rotation=1.0),
                                   **joint}},
                "time": {"steps": 2}}

    def expect(self, message, changes=None, status=2, command="check", **joint):
        deck = scenes.merged(self.deck(**joint), changes or {})
        result = self.solve(self.mesh, deck, command=command, check=False)
        self.assertEqual(result.status, status, result.output)
        self.assertRegex(result.output, message)

    def test_deck(self):
        self.expect("the deck is valid", status=0)
        self.expect(r"joints\.pin\.kind: .*revolut'.*did you mean 'revolute'", kind="revolut")
        self.expect(r"joints\.pin\.bodies: 'lik' is not a name under bodies", bodies=["lik", "rail"])
        self.expect(r"joints\.pin\.bodies: expected the names of two", bodies=["link", "link"])
        self.expect(r"joints\.pin\.bodies: expected the names of two", bodies=["link"])
        self.expect(r"joints\.pin\.axis: expected a direction", axis=[0, 0, 0])
        self.expect(r"joints\.pin\.moment: the rotation is prescribed", moment=2)
        self.expect(r"joints\.pin\.translation: unknown key", translation=2)
        self.expect(r"joints\.pin\.curve: 'up' is not a name under curves", curve="up")
        self.expect(r"linear_solver\.method: joints need a direct solver",
                    {"linear_solver": {"method": "krylov"}})
        self.expect(r"joints\.s\.to: the spring has no length",
                    {"joints": {"s": {"kind": "spring", "bodies": ["link", "ground"],
                                      "from": [0, 0, 0], "to": [0, 0, 0], "stiffness": 1}}})
        self.expect(r"bodies: the motion of all bodies is prescribed",
                    {"bodies": {"link": {"rigid": {"free": None}}}})
        self.expect(r"verify\.v\.place: 'pn' is not a name under joints",
                    {"verify": {"v": scenes.probe("joint_rotation", "pn")}})

    def test_what_a_joint_leaves_free_is_told(self):
        self.expect(r"body 'link' is free to move: rotation about z through \(.*, 0\)\.",
                    {"joints": {"pin": {"rotation": None}}})

    def test_joints_that_contradict_each_other(self):
        """The run stops with the joint's name; what holds twice without contradiction runs."""
        second = hinge("revolute", ["ground", "link"], (0, 0))
        self.expect("^$", {"joints": {"second": second}}, status=0, command="run")
        second["origin"] = [1, 0, 0]
        self.expect(r"Joint 'pin' cannot hold its rotation about its axis: other joints",
                    {"joints": {"second": second}}, status=1, command="run")

    def test_dead_point(self):
        """A slider cannot drive its crank from where all three joints lie on a line."""
        mesh = mesh_of({"crank": bar((0, 0), (1, 0)), "rod": bar((1, 0), (3, 0)),
                        "slider": brick((3, 0, 0), 0.3)})
        deck = {"bodies": {name: free_body(name, (0, 0)) for name in ("crank", "rod", "slider")},
                "joints": {"a": hinge("revolute", ["ground", "crank"], (0, 0)),
                           "b": hinge("revolute", ["crank", "rod"], (1, 0)),
                           "c": hinge("revolute", ["rod", "slider"], (3, 0)),
                           "drive": {"kind": "prismatic", "bodies": ["ground", "slider"],
                                     "axis": [1, 0, 0], "origin": [3, 0, 0], "translation": -0.5}}}
        result = self.solve(mesh, deck, check=False)
        self.assertEqual(result.status, 2)
        self.assertRegex(result.output, "is free to move: ")

    def test_steps_of_more_than_half_a_turn_are_cut(self):
        deck = self.deck(rotation=8.0)
        result = self.solve(self.mesh, scenes.merged(deck, {"verify": {
            "turn": scenes.probe("joint_rotation", "pin"),
            "body": scenes.probe("rigid_rotation_z", "link"),
            "moment": scenes.probe("joint_moment_z", "pin")}}))
        self.close(result.quantity("turn"), 8.0, POSITION)
        self.close(result.quantity("body"), 8.0, POSITION)
        self.assertGreater(result.summary["cut_backs"], 0)


if __name__ == "__main__":
    unittest.main()
