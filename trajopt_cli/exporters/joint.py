"""Joint positions at a fixed rate, for machines that follow a stream."""

from __future__ import annotations

import math

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.trajectory import Trajectory, hermite

LOWEST_RATE = 1.0  # Hz: rows farther apart are no motion
HIGHEST_RATE = 1e5  # Hz; no controller listens faster, and a row takes some 300 bytes
MOST_ROWS = 5_000_000  # 1.5 GB of text, more than an hour at 1 kHz
_AT_ONCE = 100_000  # rows that are worked out at once
_SAME = 1e-9  # of a period
_SHORTEST_INTERVAL = 1e-5  # s, what our own files promise; a shorter last step is joined with the one before it


def resample(trajectory: Trajectory, rate: float, rests: bool = True) -> Trajectory:
    """The same motion at rate [Hz]: rows at t_0 + k / rate, and the exact end as last row. rests: False leaves the
    first and the last row of a time in which nothing moves, for files whose rows carry their times.

    Between the rows of trajectory the motion is the cubic Hermite, so a position here is the motion's own. Raises
    InputError for a rate outside (0, 1e5] Hz, for more than MOST_ROWS rows, and for a trajectory without speeds.
    """
    _check_hertz(rate)
    trajectory = trajectory.whole
    if trajectory.qd is None:
        raise InputError("the trajectory has no speed columns; resampling needs them")
    ticks = [(0, math.floor(trajectory.duration * rate))] if rests else _moving(trajectory, rate)
    check_rate(trajectory, rate, sum(last - first for first, last in ticks))
    t = trajectory.t[0] + np.concatenate([np.arange(first, last + 1) for first, last in ticks]) / rate
    t = np.append(t[t <= trajectory.t[-1] - min(_SHORTEST_INTERVAL, 0.5 / rate)], trajectory.t[-1])
    q, qd = between_rows(trajectory, t)
    q[-1], qd[-1] = trajectory.q[-1], trajectory.qd[-1]
    for array in (t, q, qd):
        array.setflags(write=False)  # nobody has to copy them
    return Trajectory(trajectory.names, t, q, qd).apart


def between_rows(trajectory: Trajectory, t: Array) -> tuple[Array, Array]:
    """Positions and speeds (n, k) at times t (n,), worked out a part at a time."""
    q, qd = (np.empty((len(t), len(trajectory.names))) for _ in range(2))
    for part in (slice(i, i + _AT_ONCE) for i in range(0, len(t), _AT_ONCE)):
        q[part], qd[part], _ = hermite(trajectory, t[part])
    return q, qd


def _moving(trajectory: Trajectory, rate: float) -> list[tuple[int, int]]:
    """First and last of the numbers k of rows at t_0 + k / rate, without those in the middle of a rest."""
    assert trajectory.qd is not None
    still = np.asarray(~trajectory.qd.any(axis=1))
    rest = still[1:] & still[:-1] & (trajectory.q[1:] == trajectory.q[:-1]).all(axis=1)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], rest, [False]])))
    since = trajectory.t - trajectory.t[0]
    out, first = list[tuple[int, int]](), 0
    for begin, end in since[edges].reshape(-1, 2).tolist():
        last, behind = math.ceil(begin * rate - _SAME), math.floor(end * rate + _SAME)
        if behind > last + 1:
            out.append((first, last))
            first = behind
    return [*out, (first, math.floor(trajectory.duration * rate))]


def check_rate(trajectory: Trajectory, rate: float, rows: float | None = None) -> None:
    """Raise InputError for a rate outside [1, 1e5] Hz, and for one that makes more than MOST_ROWS rows; as many as
    duration times rate for None."""
    _check_hertz(rate)
    rows = trajectory.duration * rate if rows is None else rows
    if rows > MOST_ROWS:
        slowest = math.floor(rate * MOST_ROWS / rows * 10) / 10
        raise InputError(
            f"{trajectory.duration:.0f} s at {rate:g} Hz are {rows:.0f} rows, at most {MOST_ROWS}: give a rate of"
            f" {slowest:g} Hz or less, or take the results folder's own CSV, which has two rows where nothing moves"
        )


def _check_hertz(rate: float) -> None:
    if not (math.isfinite(rate) and LOWEST_RATE <= rate <= HIGHEST_RATE):
        raise InputError(f"rate {rate:g} Hz lies outside [1, {HIGHEST_RATE:g}] Hz; 1000 suits most controllers")
