"""Joint positions at a fixed rate, for machines that follow a stream."""

from __future__ import annotations

import math

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.trajectory import Trajectory, hermite

LOWEST_RATE = 1.0  # Hz: rows farther apart are no motion
HIGHEST_RATE = 1e5  # Hz; no controller listens faster, and a row takes some 300 bytes
MOST_ROWS = 5_000_000  # 1.5 GB of text, more than an hour at 1 kHz
_SHORTEST_INTERVAL = 1e-5  # s, what our own files promise; a shorter last step is joined with the one before it


def resample(trajectory: Trajectory, rate: float) -> Trajectory:
    """The same motion at rate [Hz]: rows at t_0 + k / rate, and the exact end as last row.

    Between the rows of trajectory the motion is the cubic Hermite, so a position here is the motion's own. Raises
    InputError for a rate outside (0, 1e5] Hz, for more than MOST_ROWS rows, and for a trajectory without speeds.
    """
    check_rate(trajectory, rate)
    if trajectory.qd is None:
        raise InputError("the trajectory has no speed columns; resampling needs them")
    t = trajectory.t[0] + np.arange(math.floor(trajectory.duration * rate) + 1) / rate
    t = np.append(t[t <= trajectory.t[-1] - min(_SHORTEST_INTERVAL, 0.5 / rate)], trajectory.t[-1])
    q, qd, _ = hermite(trajectory, t)
    q[-1], qd[-1] = trajectory.q[-1], trajectory.qd[-1]
    tables = None if trajectory.tables is None else resample(trajectory.tables, rate)
    return Trajectory(trajectory.names, t, q, qd, tables)


def check_rate(trajectory: Trajectory, rate: float) -> None:
    """Raise InputError for a rate outside [1, 1e5] Hz, and for one that makes more than MOST_ROWS rows."""
    if not (math.isfinite(rate) and LOWEST_RATE <= rate <= HIGHEST_RATE):
        raise InputError(f"rate {rate:g} Hz lies outside [1, {HIGHEST_RATE:g}] Hz; 1000 suits most controllers")
    if trajectory.duration * rate > MOST_ROWS:
        rows, slowest = trajectory.duration * rate, math.floor(MOST_ROWS / trajectory.duration * 10) / 10
        raise InputError(
            f"{trajectory.duration:.0f} s at {rate:g} Hz are {rows:.0f} rows, at most {MOST_ROWS}: give a rate of"
            f" {slowest:g} Hz or less, or take the results folder's own CSV, which has two rows where nothing moves"
        )
