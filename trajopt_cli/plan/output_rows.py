"""From leg motions to the rows of a file: a row at every boundary and every switch, a millisecond grid between.

What moves for longer than a minute, and a cycle of more than ten, has a wider grid, whole milliseconds and 20 of them
at most. A rest of a minute or more has no grid: the cubic between its first row and its last stays where it is.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.path_timing.positioner_timing import switches, turning, with_tables
from trajopt_cli.problem.problem import Problem
from trajopt_cli.settings import Settings
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import LegMotion, samples
from trajopt_cli.trajectory import Trajectory

_DENSER = 6  # times that rows are put between rows where the cubic passes a limit.
_RESIDUAL = 1e-14  # rad or m: rounding of a position in a row.
_SAME_TIME = 1e-09  # s; boundaries nearer than this are one row.
_LONG_MOTION = 60.0  # s; a motion that takes longer has rows as many times farther apart.
_LONG_CYCLE = 600.0  # s; the same of a cycle: 10,000 moves of a pallet, an hour, would have 6 million rows, 1.5 GB.
_ROWS_WIDEST = 20  # row_step: the judge wants rows every 20 ms.


def rows_of(axes: Axes, problem: Problem, iterate: Iterate) -> tuple[Trajectory, Array, Array]:
    """The rows and leg boundaries [s] of a clean iterate, denser where the cubic between two rows would pass a limit;
    and the times (m,) [s] where it does however dense they are."""
    legs, end, busy = motions_of(iterate), _end(problem, iterate), turning(problem)
    more = switches(problem, legs)
    for last in range(_DENSER, -1, -1):
        trajectory, bounds = output_rows(axes, legs, end, more, busy)
        over = _passing(axes, trajectory)
        gaps, middles = np.diff(trajectory.t)[over], (trajectory.t[over] + trajectory.t[over + 1]) / 2
        if not len(over) or not last or gaps.min() < 2 * axes.settings.least_row_step:
            break
        more += list(middles)
    return with_tables(problem, legs, trajectory, bounds), bounds, middles


def output_rows(
    axes: Axes, legs: list[LegMotion], end: Array, more: Sequence[float] = (), busy: Sequence[bool] | None = None
) -> tuple[Trajectory, Array]:
    """The trajectory of all legs in order, and the leg boundaries' times (L+1,).

    end (n,): axes at the end, written into the last row exactly. more: times [s] that get a row as well. busy: legs (L)
    during which something else moves, so that there is a grid where the axes rest.
    """
    bounds = np.concatenate([[0.0], np.cumsum([leg.T for leg in legs])])
    grids = busy or [False] * len(legs)
    long = float(bounds[-1]) / _LONG_CYCLE
    ordered = np.sort(np.array(more, dtype=np.float64))
    ordered = ordered[np.diff(ordered, prepend=-np.inf) > _SAME_TIME]  # two units may switch at once but for rounding
    inside = np.split(ordered, np.searchsorted(ordered, bounds))[1:-1]
    times = [
        _leg_rows(leg, bounds[i : i + 2], inside[i], grids[i], max(leg.T / _LONG_MOTION, long), axes.settings)[:-1]
        for i, leg in enumerate(legs)
    ]
    t = np.concatenate([*times, bounds[-1:]])
    q, qd = np.empty((len(t), axes.n)), np.empty((len(t), axes.n))
    q[-1], qd[-1] = end, 0.0
    for at, sample in samples(axes, legs, [np.clip(t - bounds[i], 0.0, legs[i].T) for i, t in enumerate(times)]):
        q[at], qd[at] = sample.q, sample.qd
    for array in (t, q, qd):
        array.setflags(write=False)
    return Trajectory(axes.robot.axis_names, t, q, qd), bounds


def _leg_rows(leg: LegMotion, ends: Array, more: Array, busy: bool, apart: float, settings: Settings) -> Array:
    """Row times of one leg: its breaks, those of more and every grid time that keep their distance from them. more
    (m,): within the leg. apart: how many times as far apart grid times are."""
    start, end = ends
    breaks = start + leg.breaks()
    breaks[0], breaks[-1] = start, end
    keep = np.concatenate([[True], np.diff(breaks) > _SAME_TIME])
    keep[-1] = True
    breaks = breaks[keep]
    if len(breaks) > 2 and breaks[-1] - breaks[-2] <= _SAME_TIME:
        breaks = np.delete(breaks, -2)
    marks = np.unique(np.concatenate([breaks, more[_apart(more, breaks, settings.least_row_step)]]))
    every = settings.row_step * float(np.clip(np.ceil(apart), 1, _ROWS_WIDEST))
    even = ~leg.resting() | busy | (np.diff(leg.breaks()) < settings.long_rest)
    grid = _grid(start + leg.breaks(), even, every)
    return np.unique(
        np.concatenate([marks, grid[_apart(grid, marks, settings.least_row_step) & (grid > start) & (grid < end)]])
    )


def _apart(times: Array, marks: Array, least: float) -> BoolArray:
    """Which times (n,) are not too near to any mark, those in order."""
    at = np.searchsorted(marks, times)
    before, after = marks[np.clip(at - 1, 0, len(marks) - 1)], marks[np.clip(at, 0, len(marks) - 1)]
    return np.asarray(np.minimum(np.abs(times - before), np.abs(times - after)) >= least)


def _grid(breaks: Array, even: BoolArray, every: float) -> Array:
    """The grid times from break to break (N+1,) where rows are even (N,), so many row steps apart."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], even, [False]])))
    ticks = [
        np.arange(np.ceil(breaks[a] / every - 1e-9), np.floor(breaks[b] / every + 1e-9) + 1)
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]
    return every * np.concatenate([np.zeros(0), *ticks])


def _passing(axes: Axes, trajectory: Trajectory) -> IndexArray:
    """The intervals between rows in which the cubic Hermite passes an axis' velocity or acceleration by more than what
    rounding does to rows that stand near each other: less than the judge grants for it, also late in a cycle."""
    assert trajectory.qd is not None
    eps, over = float(np.finfo(np.float64).eps), np.zeros(len(trajectory.t) - 1, dtype=bool)
    for first in range(0, len(over), axes.settings.batch):
        rows = slice(first, first + axes.settings.batch + 1)
        t, q, qd = trajectory.t[rows], trajectory.q[rows], trajectory.qd[rows]
        h = np.diff(t)[:, None]
        c, change, top = np.diff(q, axis=0) / h, np.diff(qd, axis=0) / h, np.maximum(np.abs(qd[1:]), np.abs(qd[:-1]))
        # far along a rail there is more of it, and the pieces of a profile add theirs up; late in a cycle times have
        # fewer digits, which matters as much as an axis moves meanwhile
        off, late = _RESIDUAL + 64 * eps * np.abs(q[1:]), 4 * eps * t[1:, None]
        noise = (6 * (off / h + np.abs(c) * late / h) + np.abs(change) * late) / h
        bend = 6 * (c - (qd[1:] + qd[:-1]) / 2) / h  # from the middle's acceleration to that at either end
        lower, upper = axes.plant.limits.acceleration_at(q)
        # the mean acceleration between two speeds is judged by itself, too, and rounding does less to it
        speeds = (np.abs(change) * late + 8 * eps * top) / h
        passed = top > axes.velocity * (1 + 1e-6)
        for qdd, end in ((change + bend, slice(None, -1)), (change - bend, slice(1, None))):
            passed |= np.maximum(qdd - upper[end] * (1 + 1e-6), -qdd - lower[end] * (1 + 1e-6)) > noise
        most = np.where(change > 0, np.maximum(upper[1:], upper[:-1]), np.maximum(lower[1:], lower[:-1]))
        passed |= np.abs(change) > most * (1 + 1e-6) + speeds
        over[first : first + len(h)] = passed.any(axis=1)
    return np.flatnonzero(over)


def _end(problem: Problem, iterate: Iterate) -> Array:
    stop = problem.waypoints[-1]
    return stop.q if stop.q is not None else iterate.q[-1]


def motions_of(iterate: Iterate) -> list[LegMotion]:
    """The motions of its legs, in order."""
    return [motion for motion in iterate.legs if motion is not None]
