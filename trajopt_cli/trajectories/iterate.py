"""A candidate for the whole problem, and the limits in force on its nodes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import LegMotion
from trajopt_cli.trajectories.limits import limits_of


@dataclass(frozen=True, eq=False)
class Iterate:
    """A candidate: axes q and velocities qd (M, n) at the waypoints, IK branch of each (-1 where joints are fixed).
    qdd (M, n): accelerations, which matter where jerk is limited; None for zeros."""

    q: Array
    qd: Array
    cfx: tuple[int, ...]
    legs: tuple[LegMotion | None, ...]
    qdd: Array | None = None

    def part(self, points: Sequence[int], legs: Sequence[int]) -> Iterate:
        """Of some waypoints and legs, by their numbers."""
        qdd = None if self.qdd is None else self.qdd[[*points]]
        cfx, own = tuple(self.cfx[k] for k in points), tuple(self.legs[k] for k in legs)
        return Iterate(self.q[[*points]], self.qd[[*points]], cfx, own, qdd)

    def put(self, points: Sequence[int], legs: Sequence[int], found: Iterate) -> Iterate:
        """The same with a part as found."""
        q, qd, qdd = self.q.copy(), self.qd.copy(), self.qdd
        q[[*points]], qd[[*points]] = found.q, found.qd
        cfx = dict(enumerate(self.cfx)) | dict(zip(points, found.cfx, strict=True))
        own = dict(enumerate(self.legs)) | dict(zip(legs, found.legs, strict=True))
        if found.qdd is not None:
            qdd = np.zeros_like(q) if qdd is None else qdd.copy()
            qdd[[*points]] = found.qdd
        return Iterate(q, qd, tuple(cfx.values()), tuple(own.values()), qdd)


@dataclass
class Margins:
    """The back-off of one leg: what of each limit is in force at its nodes, tightened where a dense check found an
    excess: (N+1, w) by the limit's name, which is an attribute as well.

    push (N,): the same of the rail's acceleration in each interval of a dwell. room (N+1,): what is asked for between
    bodies beyond the distance wanted [m].
    """

    by_name: dict[str, Array]
    push: Array
    room: Array

    def __getattr__(self, name: str) -> Array:
        if name.startswith("_") or name == "by_name" or name not in self.by_name:
            raise AttributeError(name)
        return self.by_name[name]

    @classmethod
    def full(cls, axes: Axes, N: int, on_path: bool) -> Margins:
        """Of N intervals, nothing tightened but for rounding; on_path: of a line, an arc or a dwell."""
        starts = [(limit, limit.start if on_path else limit.start_on_grid) for limit in limits_of(axes)]
        margins = {limit.name: np.full((N + 1, len(limit.orders)), start) for limit, start in starts}
        return cls(margins, np.ones(N), np.zeros(N + 1))

    def refined(self) -> Margins:
        """The same margins on twice as many intervals; a new node takes the smaller neighbour's."""

        def double(x: Array) -> Array:
            out = np.empty((2 * len(x) - 1, x.shape[1]))
            out[::2] = x
            out[1::2] = np.minimum(x[:-1], x[1:])
            return out

        finer = {name: double(one) for name, one in self.by_name.items()}
        return Margins(finer, np.repeat(self.push, 2), -double(-self.room[:, None])[:, 0])
