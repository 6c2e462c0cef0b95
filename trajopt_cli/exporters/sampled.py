"""Motions that are rows and nothing else, one every period, at another rate: no faster, no harder, never outside."""

from __future__ import annotations

import math

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.joint import check_rate
from trajopt_cli.trajectory import Trajectory

_WHOLE = 1e-9  # share of a period by which rows may miss their place


def period_of(trajectory: Trajectory) -> float:
    """The period [s] of rows that stand on a grid. Raises InputError where they do not."""
    t = trajectory.t
    h = trajectory.duration / (len(t) - 1)
    if np.abs(t - t[0] - np.arange(len(t)) * h).max() > 1e-6 * h:
        raise InputError("the joints' rows stand on no grid of one period; make them again with trajopt iiwa joints")
    return h


def at_rate(trajectory: Trajectory, rate: float) -> tuple[Trajectory, str]:
    """Rows at rate [Hz] and the exact end, and what to know of them.

    Every m-th row where the rate is an m-th of the rows' own. Else a curve of constant acceleration around every row,
    the second difference there (the quadratic B-spline with the rows as its control points): its speeds are means of
    the rows' steps and its positions of the rows, so that it keeps each limit that the rows keep. It passes a row at up
    to acceleration times period squared over 8, rests at both ends, and takes one period more.

    Raises InputError as resample.
    """
    check_rate(trajectory, rate)
    h, n = period_of(trajectory), len(trajectory.t)
    every = 1 / (rate * h)
    if round(every) >= 1 and abs(every - round(every)) <= _WHOLE * n:
        rows = np.unique(np.r_[np.arange(0, n, round(every)), n - 1])
        qd = None if trajectory.qd is None else trajectory.qd[rows]
        return Trajectory(trajectory.names, trajectory.t[rows], trajectory.q[rows], qd), ""
    duration = trajectory.duration + h
    t = np.arange(math.floor(duration * rate) + 1) / rate
    t = np.append(t[t <= duration - min(1e-5, 0.5 / rate)], duration)
    x = np.concatenate([trajectory.q[:1], trajectory.q, trajectory.q[-1:]])  # a row before and one behind, at rest
    u = t / h - 0.5
    i = np.clip(np.rint(u), 0, n - 1).astype(np.intp)
    w = (u - i)[:, None]
    before, here, after = x[i], x[i + 1], x[i + 2]
    q = before * (0.5 - w) ** 2 / 2 + here * (0.75 - w * w) + after * (0.5 + w) ** 2 / 2
    qd = (after * (0.5 + w) - before * (0.5 - w) - 2 * w * here) / h
    q[0], q[-1], qd[0], qd[-1] = x[0], x[-1], 0.0, 0.0
    off = float(np.abs(np.diff(x, n=2, axis=0)).max()) / 8
    note = f"between the rows: within their limits, {off:.1e} rad beside them at most, {1e3 * h:g} ms longer"
    return Trajectory(trajectory.names, trajectory.t[0] + t, q, qd), note
