"""How far the rail goes in a wait of a fixed time, from rest to rest, with the arm holding the tool meanwhile."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.problem.problem import Leg
from trajopt_cli.timing.point_to_point import rest_time
from trajopt_cli.timing.topp import fastest_laws
from trajopt_cli.trajectories.axes import Axes

_NODES = 17  # of a way that is timed


def farthest(axes: Axes, leg: Leg, d: Array, arm: Array) -> IndexArray:
    """The number of the rail position farthest on that is reached in time, by TOPP along the way between.

    Args:
        axes, leg: the wait, which has a duration.
        d: rail positions (n,) [m], evenly increasing.
        arm: its joints there in some configurations (c, n, joints), NaN where the tool's place is out of reach.

    Returns:
        One (c, n) for each position, at least its own; back from there takes as long.
    """
    assert leg.duration is not None
    here, n = np.isfinite(arm).all(axis=-1), len(d)
    of = np.broadcast_to(np.arange(n), here.shape).copy()
    if n < 2:
        return of
    dq = np.full((*here.shape, axes.n), np.nan)
    q = axes.layout.join(np.broadcast_to(d, here.shape)[here], arm[here])
    dq[here] = axes.layout.join(np.ones(len(q)), axes.self_motion(q)[..., axes.layout.sought])
    steps = np.diff(dq, axis=1) / (d[1] - d[0])
    ahead, behind = np.pad(steps, ((0, 0), (0, 1), (0, 0)), "edge"), np.pad(steps, ((0, 0), (1, 0), (0, 0)), "edge")
    ddq = np.where(np.isnan(ahead), behind, np.where(np.isnan(behind), ahead, (ahead + behind) / 2))
    gap = np.minimum.accumulate(np.where(here, n, of)[:, ::-1], axis=1)[:, ::-1]  # the next place out of reach
    most = float(axes.layout.place(axes.velocity_on(leg))) * leg.duration / (d[1] - d[0])
    low, high = of, np.minimum(gap - 1, of + int(min(most, n)))
    while (left := high > low).any():
        c, i = np.nonzero(left)
        middle = (low[c, i] + high[c, i] + 1) // 2
        fits = _times(axes, leg, d, dq[c], ddq[c], i, middle) <= leg.duration
        low[c, i], high[c, i] = np.where(fits, middle, low[c, i]), np.where(fits, high[c, i], middle - 1)
    return low


def _times(axes: Axes, leg: Leg, d: Array, dq: Array, ddq: Array, i: IndexArray, j: IndexArray) -> Array:
    """Least times (m,) between rail positions number i and j (m,). dq, ddq (m, n, axes): by the rail's position."""
    s, row = np.linspace(0, 1, _NODES), np.arange(len(i))[:, None]
    at = i[:, None] + s * (j - i)[:, None]
    whole = np.minimum(at.astype(int), len(d) - 2)
    f, way = (at - whole)[..., None], (d[j] - d[i])[:, None, None]

    def between(x: Array) -> Array:
        return np.where(f > 0, x[row, whole] * (1 - f) + x[row, np.minimum(whole + 1, j[:, None])] * f, x[row, whole])

    rates, bends = between(dq) * way, between(ddq) * way**2
    V, A = axes.velocity_on(leg), axes.acceleration
    top = (V / np.maximum(np.abs(rates), 1e-12)).min(axis=-1)
    slopes, bends = rates / A, np.nan_to_num(bends / A)
    times = fastest_laws(s, top, (slopes[:, :-1], bends[:, :-1]), (slopes[:, 1:], bends[:, 1:]), 0.0, 0.0).durations
    if axes.jerk is None:
        return times
    span = np.maximum(np.abs(rates).mean(axis=1), 1e-12)
    return np.maximum(times, rest_time(np.ones(len(i)), *((x / span).min(axis=1) for x in (V, A, axes.jerk))))
