"""Torques of a plant's axes against their limits, by pinocchio: along courses as TOPP wants them, and in samples.

tau = M(q) q'' + C(q, q') q' + g(q): all but gravity g grows with the square of how fast a motion is driven. So the
measure of a torque is what it has beyond gravity as a share of what gravity leaves: at most 1 where |tau| <= limit, and
like an acceleration's ratio 1/k^2 times as much in k times the time. Rails without a limit have shares of zero.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.limits import TcpCaps
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg
from trajopt_cli.robot.dynamics import GRAVITY, Dynamics, ToolLoad
from trajopt_cli.trajectories.limits.limit import Limit, MotionSamples, NodeMotion, PathRows, PathSamples, Row


class Columns(NamedTuple):
    """At places of a course (m, n): |slopes u + bends x + rest| <= 1 with u the second derivative of the course's
    parameter and x its squared rate; rest is what gravity asks for."""

    slopes: Array
    bends: Array
    rest: Array


@dataclass(frozen=True, eq=False)
class Torques:
    """limit (n,): of the axes [Nm, N], inf for none. bodies: the same robot without rotors' gravity, see Dynamics."""

    plant: Plant
    limit: Array
    _known: dict[tuple[float, ...], tuple[Dynamics, Dynamics]] = field(default_factory=dict)

    @classmethod
    def of(cls, plant: Plant) -> Torques | None:
        """Those of a plant, None where no torque is limited."""
        limit = plant.limits.binding_torque
        return None if limit is None else cls(plant, limit)

    @property
    def limited(self) -> tuple[int, ...]:
        """Which axes have a limit."""
        return tuple(int(i) for i in np.flatnonzero(np.isfinite(self.limit)))

    def dynamics(self, load: ToolLoad | None) -> tuple[Dynamics, Dynamics]:
        """The robot with a load, under gravity and without."""
        key = () if load is None else load.numbers
        if key not in self._known:
            robot = self.plant.robot
            with_load, floating = (Dynamics(robot, load, gravity, robot.rotor) for gravity in (GRAVITY, 0.0))
            self._known[key] = with_load, floating
        return self._known[key]

    def columns(self, legs: Sequence[Leg], number: IndexArray, q: Array, dq: Array, ddq: Array) -> Columns:
        """At places (m, n) of courses with first and second derivatives, on the legs with numbers (m,)."""
        slopes, bends, rest = (np.empty_like(q) for _ in range(3))
        for load, at in _by_load(legs, number):
            standing, floating = self.dynamics(load)
            still = np.zeros_like(q[at])
            slopes[at] = floating.torque(q[at], still, dq[at])
            bends[at] = floating.torque(q[at], dq[at], ddq[at])
            rest[at] = standing.gravity_torque(q[at])
        return Columns(slopes / self.limit, bends / self.limit, rest / self.limit)

    def ratios(self, legs: Sequence[Leg], number: IndexArray, q: Array, qd: Array, qdd: Array) -> Array:
        """Shares (m, n) of what gravity leaves, at samples (m, n) of the legs with numbers (m,)."""
        found = np.empty_like(q)
        for load, at in _by_load(legs, number):
            standing, floating = self.dynamics(load)
            rest = standing.gravity_torque(q[at]) / self.limit
            found[at] = of_room(floating.torque(q[at], qd[at], qdd[at]) / self.limit, rest)
        return found

    def used(self, legs: Sequence[Leg], number: IndexArray, q: Array, qd: Array, qdd: Array) -> Array:
        """|tau| / limit (m, n), gravity included, at samples of the legs with numbers (m,)."""
        found = np.empty_like(q)
        for load, at in _by_load(legs, number):
            found[at] = np.abs(self.dynamics(load)[0].torque(q[at], qd[at], qdd[at])) / self.limit
        return found

    def holds(self, load: ToolLoad | None, q: Array) -> BoolArray:
        """At which axes (m, n) all of them can hold the arm at rest (m,)."""
        still = self.dynamics(load)[0].gravity_torque(q)
        return np.asarray(np.all(np.abs(still) < self.limit, axis=1))

    def too_heavy(self, leg: Leg, q: Array) -> str | None:
        """Which axis cannot hold the arm at axes q (n,) on a leg, in words; None where all can."""
        tau = self.dynamics(leg.load)[0].gravity_torque(q)
        worst = int(np.argmax(np.abs(tau) / self.limit))
        if abs(tau[worst]) < self.limit[worst]:
            return None
        name = self.plant.limits.names[worst]
        unit = "N" if name == "rail" else "Nm"
        return f"{name} cannot hold the arm, {abs(tau[worst]):.4g} {unit} of {self.limit[worst]:.4g} {unit}"


class JointTorque(Limit):
    """|tau| <= limit, as what it has beyond gravity by what gravity leaves."""

    name = "torque"
    order = 2.0
    apart = True

    def labels(self, leg: Leg, tcp: TcpCaps) -> list[str]:
        """See Limit."""
        return [f"{name} torque" for name in self.axes.names]

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit."""
        sample = motion.sample
        return self._torques.ratios(motion.legs, motion.number, sample.q, sample.qd, sample.qdd)

    def used(self, motion: MotionSamples) -> Array:
        """|tau| / limit, gravity included."""
        sample = motion.sample
        return self._torques.used(motion.legs, motion.number, sample.q, sample.qd, sample.qdd)

    def path_rows(self, path: PathSamples) -> PathRows:
        """See Limit."""
        found = self._torques.columns(path.legs, path.number, path.q, path.dq, path.ddq)
        return PathRows.of_acceleration(found.slopes, found.bends, found.rest)

    def node_kind(self, leg: Leg) -> Hashable:
        """See Limit."""
        return self._torques.limited

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """What the flange carries, the limits, and the margin of what gravity leaves of them."""
        from trajopt_cli.robot.symbolic_dynamics import LOAD

        return {"load": (LOAD,), "limit": (self.axes.n,), "share": (self.axes.n,)}

    def node_values(self, leg: Leg, margin: Array, on_path: bool) -> Mapping[str, Array]:
        """See Limit."""
        from trajopt_cli.robot.symbolic_dynamics import load_parameters

        limit = np.nan_to_num(self._torques.limit, posinf=1.0)
        return {"load": np.tile(load_parameters(leg.load), (len(margin), 1)), "limit": np.tile(limit, (len(margin), 1)),
                "share": margin}  # fmt: skip

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """moving / (share limit T^2) + g / limit with the torques beyond gravity, by tau, and gravity's g."""
        import casadi as ca

        from trajopt_cli.robot.symbolic_dynamics import torques

        robot, still = self._torques.plant.robot, ca.SX.zeros(self.axes.n)
        own = (robot.pin_model, node.q)
        rest = torques(*own, still, still, GRAVITY, p.load, robot.rotor)
        out: list[Row] = []
        for qdd in node.qdds:
            moving = torques(*own, node.qd, qdd, 0.0, p.load, robot.rotor) / (node.T * node.T)
            for i in self._torques.limited:
                out.append((moving[i] / (p.limit[i] * p.share[i]) + rest[i] / p.limit[i], -1.0, 1.0))
        return out

    @property
    def _torques(self) -> Torques:
        assert self.axes.torque is not None
        return self.axes.torque


def of_room(moving: Array, rest: Array) -> Array:
    """What a torque has beyond gravity as a share of what gravity leaves, both as shares of the limit; UNREACHED where
    it leaves nothing."""
    room = np.where(moving > 0, 1 - rest, 1 + rest)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(np.abs(rest) < 1, np.abs(moving) / room, Limit.unreached))


def _by_load(legs: Sequence[Leg], number: IndexArray) -> Iterator[tuple[ToolLoad | None, IndexArray]]:
    """Each load and its places among those of legs with numbers (m,)."""
    names = [() if leg.load is None else leg.load.numbers for leg in legs]
    for name in dict.fromkeys(names):
        at = np.flatnonzero(np.array([one == name for one in names])[number])
        if len(at):
            yield legs[names.index(name)].load, at
