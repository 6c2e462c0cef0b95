"""Torques of a plant's axes against their limits, by pinocchio: along paths as TOPP wants them, and in samples.

tau = M(q) q'' + C(q, q') q' + g(q): all but gravity g grows with the square of how fast a motion is driven. So the
measure of a torque is what it has beyond gravity as a share of what gravity leaves: at most 1 where |tau| <= limit, and
like an acceleration's ratio 1/k^2 times as much in k times the time. Rails without a limit have shares of zero.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.problem.problem import Leg
from trajopt_cli.robot.dynamics import GRAVITY, Dynamics, ToolLoad
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits.limit import Limit, MotionSamples, NodeMotion, PathRows, PathSamples, Row
from trajopt_cli.units import slides


class JointTorque(Limit):
    """|tau| <= limit, as what it has beyond gravity by what gravity leaves."""

    name = "torque"
    order = 2.0
    apart = True

    def __init__(self, axes: Axes):
        super().__init__(axes)
        limit = axes.plant.limits.binding_torque
        assert limit is not None
        self.limit = limit
        self.limited = tuple(int(i) for i in np.flatnonzero(np.isfinite(limit)))
        self._known: dict[tuple[float, ...], tuple[Dynamics, Dynamics]] = {}

    @classmethod
    def in_force(cls, axes: Axes) -> bool:
        """See Limit."""
        return axes.plant.limits.binding_torque is not None

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        return self.limit[:, None]

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        return [f"{name} torque" for name in self.axes.names]

    def _dynamics(self, load: ToolLoad | None) -> tuple[Dynamics, Dynamics]:
        """The robot with a load, under gravity and without."""
        key = () if load is None else load.numbers
        if key not in self._known:
            robot = self.axes.plant.robot
            with_load, floating = (Dynamics(robot, load, gravity, robot.rotor) for gravity in (GRAVITY, 0.0))
            self._known[key] = with_load, floating
        return self._known[key]

    def holds(self, leg: Leg, q: Array) -> BoolArray:
        """See Limit."""
        still = self._dynamics(leg.load)[0].gravity_torque(q)
        return np.asarray(np.all(np.abs(still) < self.limit, axis=1))

    def why_not(self, leg: Leg, q: Array) -> str | None:
        """See Limit."""
        tau = self._dynamics(leg.load)[0].gravity_torque(q)
        worst = int(np.argmax(np.abs(tau) / self.limit))
        if abs(tau[worst]) < self.limit[worst]:
            return None
        name = self.axes.names[worst]
        unit = "N" if slides(name) else "Nm"
        return f"{name} cannot hold the arm, {abs(tau[worst]):.4g} {unit} of {self.limit[worst]:.4g} {unit}"

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit."""
        s, found = motion.sample, np.empty_like(motion.sample.q)
        for load, at in _by_load(motion.legs, motion.number):
            standing, floating = self._dynamics(load)
            rest = standing.gravity_torque(s.q[at]) / self.limit
            found[at] = of_room(floating.torque(s.q[at], s.qd[at], s.qdd[at]) / self.limit, rest)
        return found

    def used(self, motion: MotionSamples) -> Array:
        """|tau| / limit, gravity included."""
        s, found = motion.sample, np.empty_like(motion.sample.q)
        for load, at in _by_load(motion.legs, motion.number):
            found[at] = np.abs(self._dynamics(load)[0].torque(s.q[at], s.qd[at], s.qdd[at])) / self.limit
        return found

    def path_rows(self, path: PathSamples) -> PathRows:
        """See Limit; rests are what gravity asks for."""
        slopes, bends, rests = (np.empty_like(path.q) for _ in range(3))
        for load, at in _by_load(path.legs, path.number):
            standing, floating = self._dynamics(load)
            q, dq = path.q[at], path.dq[at]
            slopes[at] = floating.torque(q, np.zeros_like(q), dq)
            bends[at] = floating.torque(q, dq, path.ddq[at])
            rests[at] = standing.gravity_torque(q)
        return PathRows.of_acceleration(slopes / self.limit, bends / self.limit, rests / self.limit)

    def node_kind(self, leg: Leg) -> Hashable:
        """See Limit."""
        return self.limited

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """What the flange carries, the limits, and the margin of what gravity leaves of them."""
        from trajopt_cli.robot.symbolic_dynamics import LOAD

        return {"load": (LOAD,), "limit": (self.axes.n,), "share": (self.axes.n,)}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """See Limit."""
        from trajopt_cli.robot.symbolic_dynamics import load_parameters

        limit = np.nan_to_num(self.limit, posinf=1.0)
        return {"load": np.tile(load_parameters(leg.load), (len(margin), 1)), "limit": np.tile(limit, (len(margin), 1)),
                "share": margin}  # fmt: skip

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """moving / (share limit T^2) + g / limit with the torques beyond gravity, by tau, and gravity's g."""
        import casadi as ca

        from trajopt_cli.robot.symbolic_dynamics import torques

        robot, still = self.axes.plant.robot, ca.SX.zeros(self.axes.n)
        own = (robot.pin_model, node.q)
        rest = torques(*own, still, still, GRAVITY, p.load, robot.rotor)
        out: list[Row] = []
        for qdd in node.qdds:
            moving = torques(*own, node.qd, qdd, 0.0, p.load, robot.rotor) / (node.T * node.T)
            for i in self.limited:
                out.append((moving[i] / (p.limit[i] * p.share[i]) + rest[i] / p.limit[i], -1.0, 1.0))
        return out


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
