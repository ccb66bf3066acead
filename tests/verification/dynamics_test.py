# SPDX-License-Identifier: BSD-3-Clause
"""Implicit dynamics: vibration, free flight, rotation, impact, and what becomes of the energy.

A bar of n linear elements with consistent mass, fixed at one end, vibrates at
  omega_k = c sqrt(6/h^2 (1 - cos(kappa h)) / (2 + cos(kappa h))),  kappa = (2 k - 1) pi / (2 L),  c = sqrt(E/rho)
exactly. A step of the trapezoidal rule turns such a vibration by 2 atan(omega dt/2) and keeps its energy.
"""
import math
import unittest

import numpy

import scenes

LINEAR = {"model": "linear_elastic", "young": 4.0, "poisson": 0.0, "density": 1.0}
RUBBER = {"model": "neo_hookean", "young": 4.0, "poisson": 0.3, "density": 1.5}


def global_course(fields, name):
    return numpy.array([fields.globals(k)[name] for k in range(len(fields.times))])


def generalised_alpha(radius, omega, dt, steps):
    """u, v, a of u'' + omega^2 u = 0 from u = 0, v = 1, by the equations themselves."""
    m, f = (0.0, 0.0) if radius == 1 else ((2 * radius - 1) / (radius + 1), radius / (radius + 1))
    gamma = 0.5 + f - m
    beta = 0.25 * (1 + f - m)**2
    u, v, a = 0.0, 1.0, 0.0
    course = [(u, v, a)]
    for _ in range(steps):
        left = (1 - m) + (1 - f) * omega**2 * beta * dt**2
        predicted = u + dt * v + dt**2 * (0.5 - beta) * a
        new = -(m * a + omega**2 * ((1 - f) * predicted + f * u)) / left
        u, v, a = predicted + beta * dt**2 * new, v + dt * ((1 - gamma) * a + gamma * new), new
        course.append((u, v, a))
    return numpy.array(course)


class Vibration(unittest.TestCase):
    """One element along z that vibrates lengthwise: one unknown, mass rho A L/3, stiffness E A/L."""
    OMEGA = math.sqrt(3 * 4.0)

    def deck(self, radius, steps, end=5.0):
        return {
            "mesh": {"generate": {"kind": "box", "divisions": [1, 1, 1]}},
            "materials": {"elastic": LINEAR},
            "bodies": {"bar": {"blocks": ["box"], "material": "elastic", "initial_velocity": [0, 0, 1e-3]}},
            "displacements": {"foot": {"set": "z0", "fix": ["z"]},
                              "x0": {"set": "x0", "fix": ["x"]}, "x1": {"set": "x1", "fix": ["x"]},
                              "y0": {"set": "y0", "fix": ["y"]}, "y1": {"set": "y1", "fix": ["y"]}},
            "dynamics": {"spectral_radius": radius},
            "newton": {"tolerance": 1e-12},
            "time": {"end": end, "steps": steps, "adaptive": False},
        }

    def course(self, radius, steps, end=5.0):
        """Displacement, velocity, acceleration of the top over the steps, for velocity 1."""
        fields = scenes.run(self.deck(radius, steps, end)).fields
        top = fields.node_set("z1")[0]
        return 1e3 * numpy.array([[fields.nodal(f"{name}_z", k)[top] for name in ("displacement", "velocity", "acceleration")]
                                  for k in range(steps + 1)]), fields

    def test_follows_the_recurrence(self):
        """The program's steps are those of the rule, number by number."""
        for radius in (1.0, 0.8, 0.3, 0.0):
            course, _ = self.course(radius, 50)
            expected = generalised_alpha(radius, self.OMEGA, 0.1, 50)
            for i, size in enumerate((1 / self.OMEGA, 1, self.OMEGA)):
                self.assertLess(numpy.abs(course[:, i] - expected[:, i]).max(), 1e-8 * size, (radius, i))

    def test_order_two(self):
        end = 10 * math.pi / self.OMEGA  # five periods: where phase shows most
        for radius in (1.0, 0.8):
            errors = [abs(self.course(radius, n, end)[0][-1, 0]) for n in (200, 400)]
            print(f"radius {radius}: error of u {errors[0]:.2e} {errors[1]:.2e}", flush=True)
            self.assertAlmostEqual(math.log2(errors[0] / errors[1]), 2, delta=0.02)
            if radius == 1:  # the period is longer by (omega dt)^2/12
                self.assertAlmostEqual(errors[1] * self.OMEGA / (10 * math.pi) * 12 / (10 * math.pi / 400)**2, 1,
                                       delta=0.01)

    def test_energy(self):
        """The trapezoidal rule keeps it, as the ledger says; below radius 1 it decays as the recurrence does."""
        _, fields = self.course(1.0, 50)
        kinetic, stored = (global_course(fields, name) for name in ("kinetic_energy", "energy_stored"))
        start = kinetic[0]
        self.assertAlmostEqual(start, 0.5 * 1e-6 / 3, delta=1e-18)
        self.assertGreater(stored.max(), 0.9 * start)  # it does vibrate
        self.assertLess(numpy.abs(kinetic + stored - start).max(), 1e-9 * start)
        self.assertLess(numpy.abs(global_course(fields, "energy_imbalance")).max(), 1e-9 * start)
        _, fields = self.course(0.5, 50)
        total = global_course(fields, "kinetic_energy") + global_course(fields, "energy_stored")
        u, v, _ = generalised_alpha(0.5, self.OMEGA, 0.1, 50).T
        self.assertLess(numpy.abs(total / start - (v**2 + (self.OMEGA * u)**2)).max(), 1e-8)
        self.assertLess(total[-1], 0.98 * start)

    def test_newmark_by_name(self):
        """beta and gamma give Newmark's rule itself."""
        deck = scenes.merged(self.deck(1.0, 50), {"dynamics": {"beta": 0.36, "gamma": 0.7, "spectral_radius": None}})
        fields = scenes.run(deck).fields
        top, u, v, a, dt = fields.node_set("z1")[0], 0.0, 1e-3, 0.0, 0.1
        for k in range(1, 51):
            predicted = u + dt * v + dt**2 * (0.5 - 0.36) * a
            new = -self.OMEGA**2 * predicted / (1 + self.OMEGA**2 * 0.36 * dt**2)
            u, v, a = predicted + 0.36 * dt**2 * new, v + dt * (0.3 * a + 0.7 * new), new
            self.assertAlmostEqual(fields.nodal("displacement_z", k)[top], u, delta=1e-11)

    def test_cut_steps_leave_nothing(self):
        """Steps that fail for want of iterations are cut; what they lead to is a solution with such steps."""
        deck = scenes.merged(self.deck(1.0, 10), {
            "materials": {"elastic": dict(RUBBER, poisson=0)}, "time": {"adaptive": True},
            "bodies": {"bar": {"initial_velocity": [0, 0, 1.2]}}, "newton": {"max_iterations": 2}})
        result = scenes.run(deck)
        self.assertGreater(result.summary["cut_backs"], 0)
        times = result.fields.times
        self.assertGreater(len(set(numpy.round(numpy.diff(times), 9))), 1)
        top, u = result.fields.node_set("z1")[0], [0.0]
        v, a = 1.2, 0.0
        for k, dt in enumerate(numpy.diff(times), start=1):
            now = result.fields.nodal("displacement_z", k)[top]
            new = 4 / dt**2 * (now - u[-1]) - 4 / dt * v - a
            stretch = 1 + now
            self.assertAlmostEqual(0.5 * new + 2 * (stretch - 1 / stretch), 0, delta=1e-6)
            v, a = v + dt / 2 * (a + new), new
            u.append(now)
            self.assertAlmostEqual(result.fields.nodal("velocity_z", k)[top], v, delta=1e-9)


class FreeBody(unittest.TestCase):
    """Bodies that nothing holds."""

    def deck(self, steps, spin, element="hex8"):
        return {
            "mesh": {"generate": {"kind": "box", "size": [1, 0.6, 0.4], "divisions": [3, 2, 2], "element": element,
                                  "distortion": 0.1}},
            "materials": {"rubber": RUBBER},
            "bodies": {"brick": {"blocks": ["box"], "material": "rubber", "initial_velocity": [0.3, -0.2, 0.5],
                                 "initial_angular_velocity": spin}},
            "dynamics": {},
            "newton": {"tolerance": 1e-11},
            "time": {"end": 2, "steps": steps},
        }

    def test_flight(self):
        for element in ("hex8", "tet10", "wedge6"):
            result = scenes.run(self.deck(4, [0, 0, 0], element))
            u = result.fields.vector("displacement")
            self.assertLess(numpy.abs(u - [0.6, -0.4, 1.0]).max(), 1e-12)
            mass = 1.5 * 0.24
            momentum = numpy.array(result.summary["momentum"])
            self.assertLess(numpy.abs(momentum - mass * numpy.array([0.3, -0.2, 0.5])).max(), 1e-12)
            self.assertAlmostEqual(result.summary["energy"]["kinetic"], 0.5 * mass * 0.38, delta=1e-12)

    def test_rotation(self):
        """Momentum to rounding; angular momentum to second order: the trapezoidal rule keeps it on average."""
        drift = []
        for steps in (40, 80):
            fields = scenes.run(self.deck(steps, [0.4, 1.5, 0.8])).fields
            momentum = numpy.array([global_course(fields, f"momentum_{i}") for i in "xyz"]).T
            angular = numpy.array([global_course(fields, f"angular_momentum_{i}") for i in "xyz"]).T
            self.assertLess(numpy.abs(momentum - momentum[0]).max(), 1e-10)
            drift.append(numpy.abs(angular - angular[0]).max() / numpy.linalg.norm(angular[0]))
            energy = global_course(fields, "kinetic_energy") + global_course(fields, "energy_stored")
            self.assertGreater(global_course(fields, "energy_stored").max(), 1e-4 * energy[0])  # it is stretched
            print(f"{steps} steps: angular momentum {drift[-1]:.1e}  energy {numpy.abs(energy / energy[0] - 1).max():.1e}",
                  flush=True)
        self.assertGreater(drift[0], 1e-7)
        self.assertAlmostEqual(math.log2(drift[0] / drift[1]), 2, delta=0.4)

    def test_rigid_top(self):
        """A symmetric top: its axis goes round the angular momentum L at the rate L/I1, all kept to rounding."""
        i1, i3 = 3 * (1 + 4) / 12 * 2, 3 * 2 / 12 * 2  # density 3, 1 x 1 x 2
        spin = numpy.array([0.5, 0, 1.2])
        momentum = numpy.array([i1 * spin[0], 0, i3 * spin[2]])
        velocity = numpy.array([0.2, -0.1, 0.3])
        errors = []
        for steps in (40, 80):
            deck = {
                "mesh": {"generate": {"kind": "blocks", "lower_size": [1, 1, 2], "upper_size": [0.1, 0.1, 0.1], "gap": 5,
                                      "lower_divisions": [1, 1, 1], "upper_divisions": [1, 1, 1]}},
                "materials": {"rubber": RUBBER},
                "bodies": {"top": {"blocks": ["lower"], "initial_velocity": list(velocity),
                                   "initial_angular_velocity": list(spin),
                                   "rigid": {"free": ["x", "y", "z", "rx", "ry", "rz"], "center": [0.5, 0.5, -1],
                                             "density": 3}},
                           "cube": {"blocks": ["upper"], "material": "rubber"}},
                "dynamics": {}, "newton": {"tolerance": 1e-12}, "time": {"end": 4, "steps": steps},
            }
            result = scenes.run(deck)
            fields = result.fields
            body = {name: numpy.array([global_course(fields, f"top_{name}_{i}") for i in "xyz"]).T
                    for name in ("rotation", "displacement", "velocity")}
            self.assertLess(numpy.abs(body["displacement"] - numpy.outer(fields.times, velocity)).max(), 1e-11)
            kinetic = global_course(fields, "kinetic_energy")
            self.assertAlmostEqual(kinetic[0], 3 * 0.14 + 0.5 * (i1 * 0.25 + i3 * 1.44), delta=1e-12)
            self.assertLess(numpy.abs(kinetic / kinetic[0] - 1).max(), 1e-10)
            angular = numpy.array([global_course(fields, f"angular_momentum_{i}") for i in "xyz"]).T
            self.assertLess(numpy.abs(angular - angular[0]).max(), 1e-9)
            expected = momentum + 6 * numpy.cross([0.5, 0.5, -1], velocity)
            self.assertLess(numpy.abs(angular[0] - expected).max(), 1e-12)
            axis = turned(body["rotation"][-1], [0, 0, 1])
            errors.append(numpy.linalg.norm(axis - turned(4 * momentum / i1, [0, 0, 1])))
        print(f"axis of the top {errors[0]:.1e} {errors[1]:.1e}", flush=True)
        self.assertGreater(errors[1], 1e-6)
        self.assertAlmostEqual(math.log2(errors[0] / errors[1]), 2, delta=0.1)

    def test_capped(self):
        """A brick with a rigid cap: of one that does not turn, momentum and energy are kept; of one that turns, whose
        nodes follow another rule than the brick's, to second order."""
        drift = {}
        for free, steps in ((["x", "y", "z"], 40), (["x", "y", "z", "rx", "ry", "rz"], 40),
                            (["x", "y", "z", "rx", "ry", "rz"], 80)):
            deck = scenes.merged(self.deck(steps, [0, 0, 0]), {
                "materials": {"rubber": LINEAR}, "time": {"end": 1},
                "bodies": {"cap": {"node_sets": ["x1"], "initial_velocity": [0.3, -0.2, 0.55],
                                   "rigid": {"free": free, "center": [1, 0.3, 0.2], "mass": 0.1,
                                             "moments_of_inertia": [0.01, 0.012, 0.014]}}}})
            fields = scenes.run(deck).fields
            momentum = numpy.array([global_course(fields, f"momentum_{i}") for i in "xyz"]).T
            drift[len(free), steps] = numpy.abs(momentum - momentum[0]).max() / numpy.linalg.norm(momentum[0])
            energy = global_course(fields, "energy_stored")
            kinetic = global_course(fields, "kinetic_energy")
            self.assertGreater(energy.max(), 1e-5)
            if len(free) == 3:
                self.assertLess(numpy.abs(energy + kinetic - kinetic[0]).max(), 1e-9 * kinetic[0])
            else:
                self.assertGreater(abs(fields.globals()["cap_rotation_y"]), 1e-3)
        print("momentum with a cap " + "  ".join(f"{k}: {v:.1e}" for k, v in drift.items()), flush=True)
        self.assertLess(drift[3, 40], 1e-10)
        self.assertLess(drift[6, 40], 1e-2)
        self.assertLess(drift[6, 80], 0.4 * drift[6, 40])

    def test_pendulum(self):
        """A rigid body about a fixed axis that is not its center of mass, with its weight: the energy is kept and the
        period of small swings that of the physical pendulum."""
        inertia, weight, arm = 2 * (1 + 4) / 12 + 2 * 1.0, 2 * 9.81, 1.0
        period = 2 * math.pi * math.sqrt(inertia / (weight * arm))
        deck = {
            "mesh": {"generate": {"kind": "blocks", "lower_size": [1, 1, 2], "upper_size": [0.1, 0.1, 0.1], "gap": 5,
                                  "lower_divisions": [1, 1, 1], "upper_divisions": [1, 1, 1]}},
            "materials": {"rubber": RUBBER},
            "bodies": {"rod": {"blocks": ["lower"], "initial_angular_velocity": [1e-3, 0, 0],
                               "rigid": {"free": ["rx"], "center": [0.5, 0.5, 0], "density": 1}},
                       "cube": {"blocks": ["upper"], "material": "rubber"}},
            "loads": {"weight": {"body_force": [0, 0, -9.81], "block": "lower", "curve": "always"}},
            "curves": {"always": [[0, 1], [1, 1]]},
            "dynamics": {}, "newton": {"tolerance": 1e-12}, "time": {"end": period, "steps": 200},
        }
        result = scenes.run(deck)
        angle = global_course(result.fields, "rod_rotation_x")
        self.assertAlmostEqual(angle.max() / (1e-3 * period / (2 * math.pi)), 1, delta=1e-3)
        lag = (math.pi / 100)**2 / 12 * 2 * math.pi  # of the phase: (omega dt)^2/12
        self.assertAlmostEqual(angle[-1] / angle.max(), -lag, delta=0.01 * lag + 1e-5)
        self.assertAlmostEqual(result.fields.globals()["rod_force_z"], weight, delta=1e-4 * weight)
        kinetic = global_course(result.fields, "kinetic_energy")
        self.assertLess(numpy.abs(global_course(result.fields, "energy_imbalance")).max(), 1e-5 * kinetic[0])


def turned(vector, point):
    """A point turned by a rotation vector."""
    vector, point = numpy.array(vector), numpy.array(point, float)
    angle = numpy.linalg.norm(vector)
    axis = vector / angle
    return (math.cos(angle) * point + math.sin(angle) * numpy.cross(axis, point)
            + (1 - math.cos(angle)) * axis.dot(point) * axis)


class Led(unittest.TestCase):
    def test_ramp_and_hold(self):
        """A foot that moves along a ramp and stops: its rates come to rest, and so does what they do to the bar."""
        deck = scenes.merged(Vibration().deck(1.0, 40, 4.0), {
            "bodies": {"bar": {"initial_velocity": [0, 0, 0]}},
            "displacements": {"foot": {"set": "z0", "fix": None, "z": 0.01, "curve": "ramp"}},
            "curves": {"ramp": [[0, 0], [1, 1], [4, 1]]}})
        fields = scenes.run(deck).fields
        foot, top = fields.node_set("z0")[0], fields.node_set("z1")[0]
        for k in range(10):
            self.assertAlmostEqual(fields.nodal("velocity_z", k)[foot], 0.01, delta=1e-12)
            self.assertAlmostEqual(fields.nodal("acceleration_z", k)[foot], 0, delta=1e-10)
        self.assertLess(abs(fields.nodal("acceleration_z", 40)[foot]), 1e-10)
        late = [fields.nodal("acceleration_z", k)[top] for k in range(12, 41)]
        u = [fields.nodal("displacement_z", k)[top] - 0.01 for k in range(12, 41)]
        for a, d in zip(late[8:], u[8:]):  # the bar vibrates freely then
            self.assertAlmostEqual(a, -12 * d, delta=1e-7)


    def test_starts(self):
        """A foot that starts smoothly or with a jolt, and what its velocity is taken for."""
        for motion, curve, velocity in (("0.01*sin(t)", None, 0.01), ("0.01*t^2", None, 0), (0.01, "jump", 0.1)):
            change = {"set": "z0", "fix": None, "z": motion}
            if curve:
                change["curve"] = curve
            deck = scenes.merged(Vibration().deck(1.0, 40, 4.0), {
                "bodies": {"bar": {"initial_velocity": [0, 0, 0]}}, "displacements": {"foot": change},
                "curves": {"jump": [[0, 0], [1e-9, 1], [4, 1]]}})
            fields = scenes.run(deck).fields
            foot = fields.node_set("z0")[0]
            self.assertAlmostEqual(fields.nodal("velocity_z", 0)[foot], velocity, delta=2e-5)
            u, t = fields.nodal("displacement_z", 40)[foot], fields.times[-1]
            self.assertAlmostEqual(u, {0.01: 0.01 * math.sin(t), 0: 0.01 * t**2, 0.1: 0.01}[velocity], delta=1e-15)
            exact = {0.01: -0.01 * math.sin(t), 0: 0.02, 0.1: 0}[velocity]
            self.assertAlmostEqual(fields.nodal("acceleration_z", 40)[foot], exact, delta=1e-4)


    def test_prescribed_body(self):
        """What moves a rigid body along t^2 is its mass times 2, and does the work of its kinetic energy."""
        times = [0.1 * k for k in range(11)]
        deck = {
            "mesh": {"generate": {"kind": "blocks", "lower_size": [1, 1, 2], "upper_size": [0.1, 0.1, 0.1], "gap": 5,
                                  "lower_divisions": [1, 1, 1], "upper_divisions": [1, 1, 1]}},
            "materials": {"rubber": RUBBER},
            "bodies": {"sled": {"blocks": ["lower"], "rigid": {"displacement": [1, 0, 0], "curve": "square",
                                                               "density": 3}},
                       "cube": {"blocks": ["upper"], "material": "rubber"}},
            "curves": {"square": [[t, t * t] for t in times]},
            "dynamics": {}, "time": {"end": 1, "steps": 10},
        }
        fields = scenes.run(deck).fields
        # It starts with the mean slope of the first piece, so that differences settle after a few steps.
        self.assertAlmostEqual(fields.globals()["sled_force_x"], 6 * 2, delta=1e-3)
        self.assertAlmostEqual(fields.globals()["sled_velocity_x"], 2, delta=1e-4)
        self.assertAlmostEqual(fields.globals()["kinetic_energy"], 0.5 * 6 * 4, delta=1e-2)
        self.assertAlmostEqual(fields.globals()["momentum_x"], 12, delta=1e-3)


class Impact(unittest.TestCase):
    """A bar flies into an equal one at rest: they touch for 2 L/c and exchange their velocities."""
    N, SPEED, GAP = 40, 0.01, 0.005

    def deck(self, radius, **contact):
        return {
            "mesh": {"generate": {"kind": "blocks", "lower_size": [0.1, 0.1, 1], "lower_divisions": [1, 1, self.N],
                                  "upper_size": [0.1, 0.1, 1], "upper_divisions": [1, 1, self.N], "gap": self.GAP}},
            "materials": {"elastic": {"model": "linear_elastic", "young": 1, "poisson": 0, "density": 1}},
            "bodies": {"target": {"blocks": ["lower"], "material": "elastic"},
                       "shot": {"blocks": ["upper"], "material": "elastic", "initial_velocity": [0, 0, -self.SPEED]}},
            "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", **contact}},
            "dynamics": {"spectral_radius": radius},
            "time": {"end": 3, "steps": 240},
        }

    def measure(self, radius, **contact):
        result = scenes.run(self.deck(radius, **contact), seconds=300)
        fields = result.fields
        times = fields.times
        momentum = global_course(fields, "momentum_z")
        force = -global_course(fields, "pair_force_z")
        self.assertLess(numpy.abs(momentum - momentum[0]).max(), 1e-9 * abs(momentum[0]))
        shot = numpy.unique(fields.connectivity("upper"))
        target = numpy.unique(fields.connectivity("lower"))
        touch = times[numpy.abs(force) > 0.02 * numpy.abs(force).max()]
        plateau = numpy.abs(force)[(times > touch[0] + 0.5) & (times < touch[0] + 1.5)].mean()
        # The mean velocity over the nodes' lengths is the momentum of a bar over its mass.
        length = numpy.ones(self.N + 1)
        length[[0, -1]] = 0.5
        def mean(nodes):
            v, z = fields.nodal("velocity_z")[nodes], fields.coordinates[nodes, 2]
            weight = numpy.where((abs(z - z.min()) < 1e-9) | (abs(z - z.max()) < 1e-9), 0.5, 1)
            return (weight * v).sum() / weight.sum()
        energy = global_course(fields, "kinetic_energy") + global_course(fields, "energy_stored")
        out = {"touch": touch[-1] - touch[0], "shot": mean(shot) / self.SPEED, "target": mean(target) / self.SPEED,
               "force": plateau / (0.5 * 0.01 * self.SPEED), "energy": energy[-1] / energy[0],
               "imbalance": abs(global_course(fields, "energy_imbalance")).max() / energy[0],
               "bodily": 0.5 * 0.01 * self.SPEED**2 * (mean(shot)**2 + mean(target)**2) / self.SPEED**2 / energy[0]}
        print(f"radius {radius} {contact}  " + "  ".join(f"{k} {v:.4f}" for k, v in out.items()), flush=True)
        return out

    def check(self, out):
        h = 1 / self.N
        self.assertAlmostEqual(out["touch"], 2, delta=2 * h)
        self.assertAlmostEqual(out["force"], 1, delta=h)
        self.assertAlmostEqual(out["target"], -1, delta=h)
        self.assertAlmostEqual(out["shot"], 0, delta=h)

    def test_soft_penalty(self):
        """A contact as stiff as its elements: the bars take on each other's velocity, and hardly any energy is lost."""
        out = self.measure(1.0, penalty_factor=1)
        self.check(out)
        self.assertAlmostEqual(out["energy"], 1, delta=2e-3)
        out = self.measure(0.8, penalty_factor=1)
        self.check(out)
        self.assertLess(out["energy"], 1)
        self.assertGreater(out["energy"], 0.99)

    def test_stiff_penalty(self):
        """Faces that close within a step overlap by speed times step: a stiff penalty makes that into energy, which
        the trapezoidal rule keeps. A spectral radius below 1 takes it away again."""
        gain = {radius: self.measure(radius)["energy"] - 1 for radius in (1.0, 0.8, 0.5)}
        self.assertGreater(gain[1.0], 0.1)
        self.assertLess(gain[0.8], 0.3 * gain[1.0])
        self.assertLess(gain[0.5], 0)
        self.assertGreater(gain[0.5], -0.02)


class Peer(unittest.TestCase):
    def test_block_on_membrane(self):
        """A rigid block falls on a clamped plate and bounces: the scene of FEBio's case co30, whose own reference is the
        root of the sum of squared displacements at the end, of free nodes and the block, 4.7322272. It is of
        iterations that stop at corrections of 1e-3."""
        deck = {
            "mesh": {"generate": {"kind": "blocks", "lower_size": [5, 5, 0.1], "lower_divisions": [25, 25, 1],
                                  "upper_size": [1, 1, 1], "upper_divisions": [10, 10, 10], "gap": 1.27392}},
            "materials": {"soft": {"young": 500, "poisson": 0.4, "density": 1}},
            "bodies": {"plate": {"blocks": ["lower"], "material": "soft"},
                       "block": {"blocks": ["upper"],
                                 "rigid": {"free": ["z"], "density": 1, "center": [2.5, 2.5, 1.77392]}}},
            "displacements": {side: {"set": f"lower_{side}", "fix": ["x", "y", "z"]} for side in ("x0", "x1", "y0", "y1")},
            "loads": {block: {"body_force": [0, 0, -1], "block": block, "curve": "always"} for block in ("lower", "upper")},
            "curves": {"always": [[0, 1], [1, 1]]},
            # The peer adds the forces of two passes up.
            "contact": {"land": {"primary": "upper_bottom", "secondary": "lower_top", "formulation": "facet_on_facet",
                                 "penalty": 200, "two_pass": True}},
            "dynamics": {}, "time": {"end": 5, "steps": 50},
        }
        result = scenes.run(deck, seconds=300)
        fields = result.fields
        force = [fields.globals(k)["land_force_z"] for k in range(51)]
        self.assertGreater(max(map(abs, force)), 1)
        self.assertEqual(force[-1], 0)  # it has left again
        plate = numpy.unique(fields.connectivity("lower"))
        norm = math.sqrt((fields.vector("displacement")[plate]**2).sum() + fields.globals()["block_displacement_z"]**2)
        print(f"norm {norm:.5f}  iterations {result.summary['newton_iterations']}", flush=True)
        self.assertAlmostEqual(norm / 4.7322272, 1, delta=2e-3)


class Ranks(unittest.TestCase):
    def test_same_on_all(self):
        """A block that is thrown on a plate and slides with friction, clamped to a rigid cap that turns with it."""
        deck = {
            "mesh": {"generate": {"kind": "blocks", "lower_size": [3, 3, 0.5], "lower_divisions": [4, 4, 2],
                                  "upper_size": [1, 1, 1], "upper_divisions": [3, 3, 3], "gap": 0.01}},
            "materials": {"rubber": RUBBER},
            "bodies": {"plate": {"blocks": ["lower"], "material": "rubber"},
                       "block": {"blocks": ["upper"], "material": "rubber", "initial_velocity": [0.5, 0, -0.4],
                                 "initial_angular_velocity": [0, 0, 0.4]},
                       "cap": {"node_sets": ["upper_top"], "initial_velocity": [0.5, 0, -0.4],
                               "initial_angular_velocity": [0, 0, 0.4],
                               "rigid": {"free": ["x", "y", "z", "rx", "ry", "rz"], "center": [1.5, 1.5, 1.01],
                                         "mass": 0.5, "moments_of_inertia": [0.1, 0.1, 0.15]}}},
            "displacements": {"floor": {"set": "lower_bottom", "fix": ["x", "y", "z"]}},
            "contact": {"pair": {"primary": "upper_bottom", "secondary": "lower_top", "friction": 0.3}},
            "dynamics": {"spectral_radius": 0.8}, "check": "tangent",
            "newton": {"tolerance": 1e-11}, "time": {"end": 0.4, "steps": 16},
        }
        results = [scenes.run(deck, ranks=n, quiet=False, seconds=120) for n in (1, 2, 4)]
        first = results[0]
        self.assertGreater(first.contact()["slip_points"], 0)
        errors = [float(line.split("error")[1].split()[0]) for line in first.output.splitlines()
                  if line.startswith("tangent of inertia")]
        self.assertEqual(len(errors), first.summary["steps"])
        self.assertLess(max(errors), 1e-6)
        turned_cap = max(abs(first.fields.globals()[f"cap_rotation_{i}"]) for i in "xyz")
        self.assertGreater(turned_cap, 1e-3)
        for other in results[1:]:
            order = [numpy.argsort(r.fields.node_map) for r in (first, other)]
            for name in ("displacement", "velocity", "acceleration"):
                a, b = (r.fields.vector(name)[o] for r, o in zip((first, other), order))
                self.assertGreater(numpy.abs(a).max(), 0.01)
                self.assertLess(numpy.abs(a - b).max(), 1e-10 * max(1, numpy.abs(a).max()), name)


class Check(unittest.TestCase):
    def test_masses(self):
        deck = scenes.merged(Vibration().deck(1.0, 1), {
            "displacements": None,
            "bodies": {"cap": {"node_sets": ["z1"], "rigid": {"free": ["z"], "mass": 2.5}}}})
        result = scenes.run(deck, command="check")
        self.assertIn("mass 1\n", result.output)
        self.assertIn("mass 2.5\n", result.output)
        self.assertIn("none has to be held", result.output)


class Refused(unittest.TestCase):
    def expect(self, changes, *words):
        result = scenes.run(scenes.merged(Vibration().deck(1.0, 1), changes), check=False)
        self.assertEqual(result.status, 2, result.output)
        for word in words:
            self.assertIn(word, result.output)

    def test_messages(self):
        self.expect({"materials": {"elastic": {"density": None}}}, "materials.elastic", "density")
        self.expect({"materials": {"elastic": {"density": 0}}}, "density", "> 0")
        self.expect({"dynamics": None}, "initial_velocity", "dynamics")
        self.expect({"dynamics": {"spectral_radius": 1.5}}, "spectral_radius", "<= 1")
        self.expect({"dynamics": {"spectral_radius": 0.5, "beta": 0.3}}, "beta", "spectral_radius")
        self.expect({"dynamics": {"gamma": 0.9}}, "gamma", "2 beta")
        cap = {"node_sets": ["z1"], "rigid": {"free": ["z"]}}
        self.expect({"bodies": {"cap": cap}}, "bodies.cap", "mass")
        cap = {"node_sets": ["z1"], "rigid": {"free": ["rx"], "mass": 1}}
        self.expect({"bodies": {"cap": cap}}, "moments_of_inertia")
        cap = {"node_sets": ["z1"], "rigid": {"density": 1}}
        self.expect({"bodies": {"cap": cap}}, "density", "mass")
        cap = {"node_sets": ["z1"], "rigid": {"mass": 1}, "initial_velocity": [0, 0, 1]}
        self.expect({"bodies": {"cap": cap}}, "initial_velocity", "prescribed")


if __name__ == "__main__":
    unittest.main()
