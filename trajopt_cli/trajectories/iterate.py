"""A candidate for the whole problem, and the limits in force on its nodes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.settings import START, START_JERK
from trajopt_cli.trajectories.leg_trajectories import LegMotion


@dataclass(frozen=True, eq=False)
class Iterate:
    """A candidate: axes q and velocities qd (M, n) at the waypoints, IK branch of each (-1 where joints are fixed).
    qdd (M, n): accelerations, which matter where jerk is limited; None for zeros."""

    q: Array
    qd: Array
    cfx: tuple[int, ...]
    legs: tuple[LegMotion | None, ...]
    qdd: Array | None = None


@dataclass
class Margins:
    """The back-off of one leg: limits in force at its nodes as shares of the true ones, tightened where a dense check
    found an excess.

    velocity, acceleration (N+1, n); position (N+1, n): of half the range, about its middle; tool (N+1, 3): speed,
    acceleration, reorientation. push (N,): the rail's acceleration in each interval of a dwell. jerk, torque (N+1, n).
    room (N+1,): no share, but what is asked for between bodies beyond the distance wanted [m].
    """

    velocity: Array
    acceleration: Array
    position: Array
    tool: Array
    push: Array
    jerk: Array
    torque: Array
    room: Array

    @classmethod
    def full(cls, N: int, n: int, joints: float) -> Margins:
        """Of N intervals and n axes, nothing tightened but for rounding. joints: share of their limits."""
        share = np.full((N + 1, n), joints)
        return cls(
            share, share.copy(), np.ones((N + 1, n)), np.full((N + 1, 3), START), np.ones(N),
            np.full((N + 1, n), START_JERK), np.full((N + 1, n), START), np.zeros(N + 1),
        )  # fmt: skip

    def refined(self) -> Margins:
        """The same shares on twice as many intervals; a new node takes the smaller neighbour's."""

        def double(x: Array) -> Array:
            out = np.empty((2 * len(x) - 1, x.shape[1]))
            out[::2] = x
            out[1::2] = np.minimum(x[:-1], x[1:])
            return out

        return Margins(
            double(self.velocity), double(self.acceleration), double(self.position), double(self.tool),
            np.repeat(self.push, 2), double(self.jerk), double(self.torque), -double(-self.room[:, None])[:, 0],
        )  # fmt: skip
