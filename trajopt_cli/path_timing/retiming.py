"""A motion timed anew on its own path: how long it takes where the true limits are others than it was planned with.

The path is the motion's rows, and the parameter is their time: the motion itself has the rate 1, and nothing is
singular where all axes rest. What the program times, as waits and moves with \\T, lasts at least as long as it says. A
limit of jerk is not asked, for it has no rows on a path.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.path_timing.path_derivatives import PathDerivatives
from trajopt_cli.path_timing.path_timing import path_rows, samples_of, stacked
from trajopt_cli.problem.problem import Leg
from trajopt_cli.timing.topp import fastest_laws
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import motion_samples
from trajopt_cli.trajectories.leg_trajectories import Sample
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectory import Trajectory

_STEP = 5e-3  # s between places of a path at least, besides rows at which an acceleration jumps
_PLACES = (
    8000  # of a long path, about. Measured on 400 joint moves of 218 s: ends within 0.15 % of those with all, in a
)
# quarter of the time.
_JUMP = 1e-2  # share of an axis' acceleration by which it changes at a row that is such a jump
_STANDS = 1e-9  # rad/s or m/s of an axis that rests
_LINK = 1e-9  # of the parameter, in which the rate may be another one where all axes rest
_FASTEST = 1e3  # rate that stands for no bound


@dataclass(frozen=True, eq=False)
class MotionPath:
    """Rows of a motion that rests at both ends, with speeds. axes, legs: those it was planned with; ends (L,): when
    each leg is over, from the first row on [s]."""

    rows: Trajectory
    axes: Axes
    legs: Sequence[Leg]
    ends: Array

    def duration(self, axes: Axes, legs: Sequence[Leg], paced: bool = False) -> float:
        """How long it takes [s] under the limits of other axes and legs; infinite where it cannot be driven at all.
        paced: it is nowhere driven faster than it is."""
        rows = stacked(path_rows(limits_of(axes), samples_of(axes, legs, self._number, self._along)))
        link, N = self._link, len(self._link)
        slopes, bends, rests = (
            np.where(link[:, None], 0.0, one.reshape(2, N, -1)) for one in (rows.slopes, rows.bends, rows.rests)
        )
        tops = np.where(np.tile(link, 2), _FASTEST, np.min(rows.top, axis=1, initial=_FASTEST))
        own = np.diff(self.ends, prepend=0.0)  # what the program times lasts so long
        least = np.array([leg.least if leg.duration is None else T for leg, T in zip(legs, own, strict=True)])
        kept = [paced or bool(leg.units) for leg in legs] | ((least > 0) & ~self._apart)
        begin, end = np.where(kept[self._number], np.minimum(tops, 1.0), tops).reshape(2, N)
        top = np.minimum(np.append(begin, _FASTEST), np.insert(end, 0, _FASTEST))
        asked = (slopes, bends, rests) if np.any(rests) else (slopes, bends)
        begins, ends = (tuple(one[side : side + 1] for one in asked) for side in (0, 1))
        rates = fastest_laws(self._s, top[None], begins, ends, np.inf, np.inf).rates[0]
        times = 2 * np.diff(self._s) / (rates[1:] + rates[:-1])
        return float(np.maximum(np.bincount(self._number[:N], times, len(legs)), least).sum())

    @cached_property
    def _bends(self) -> tuple[Array, Array]:
        """Accelerations (n-1, k) where each interval of the rows begins and where it ends."""
        h, q, v = np.diff(self.rows.t)[:, None], np.diff(self.rows.q, axis=0), self.rows.qd
        assert v is not None
        sag, rise = q / h - v[:-1], v[1:] - v[:-1]
        return (6 * sag - 2 * rise) / h, (4 * rise - 6 * sag) / h

    @cached_property
    def _nodes(self) -> IndexArray:
        """The rows that are places of the path; those where all axes rest are there twice."""
        t, qd, (begin, end) = self.rows.t - self.rows.t[0], self.rows.qd, self._bends
        assert qd is not None
        kept = np.diff(np.floor(t / max(_STEP, t[-1] / _PLACES)), prepend=-1.0) > 0
        kept[1:-1] |= (np.abs(begin[1:] - end[:-1]) > _JUMP * self.axes.acceleration).any(axis=1)
        rests = np.abs(qd).max(axis=1) < _STANDS
        kept |= rests
        kept[np.searchsorted(t, self.ends[:-1] - _LINK)] = True
        kept[-1] = True
        at = np.flatnonzero(kept)
        return np.repeat(at, np.where(rests[at], 2, 1))

    @cached_property
    def _link(self) -> BoolArray:
        """Which intervals between nodes are none: all axes rest there."""
        return np.diff(self._nodes) == 0

    @cached_property
    def _apart(self) -> BoolArray:
        """Which legs (L,) begin and end where all axes rest, so that they may wait there."""
        t = self.rows.t[self._nodes[:-1]] - self.rows.t[0]
        rests = self._link[np.searchsorted(t, self.ends - _LINK)]
        return rests & np.insert(rests[:-1], 0, True)

    @cached_property
    def _s(self) -> Array:
        return np.append(0.0, np.cumsum(np.where(self._link, _LINK, np.diff(self.rows.t[self._nodes]))))

    @cached_property
    def _number(self) -> IndexArray:
        """The leg of every interval, for the places where they begin and then for those where they end."""
        t = self.rows.t[self._nodes] - self.rows.t[0]
        number = np.searchsorted(self.ends, (t[:-1] + t[1:]) / 2)
        return np.tile(np.minimum(number, len(self.legs) - 1), 2)

    @cached_property
    def _along(self) -> PathDerivatives:
        """The path where intervals begin and then where they end."""
        first, last, (begin, end) = self._nodes[:-1], self._nodes[1:], self._bends
        at, top = np.append(first, last), len(begin) - 1
        assert self.rows.qd is not None
        q, dq = self.rows.q[at], self.rows.qd[at]
        ddq = np.vstack([begin[np.minimum(first, top)], end[np.maximum(last - 1, 0)]])
        sample = Sample(self.rows.t[at], q, dq, ddq)
        tool = motion_samples(self.axes, self.legs, self._number, sample, self._number[:1]).tool
        turned = np.array([bool(leg.units) for leg in self.legs])[self._number]
        tool[turned] = 0.0  # against work that turns: the rate 1, which it is driven with at most, keeps its caps
        return PathDerivatives(q, dq, ddq, tool[:, 0, :3], tool[:, 0, 3:], tool[:, 1, :3], np.zeros((len(at), 2)))
