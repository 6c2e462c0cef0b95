"""A leg between two stops under jerk limits, before any nonlinear program: one profile of Ruckig's along its path.

Its speed, acceleration and jerk are constants for the whole path, in a ratio that is searched; what it then passes
of any limit says by how much it has to be slowed down as a whole, which is legal. A joint move that meets no cap of
the tool has the least time there is.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path_timing.path_timing import but_torques, rows_on, stacked
from trajopt_cli.path_timing.sampled_path import sample_path
from trajopt_cli.problem.problem import LegKind, Problem
from trajopt_cli.timing.point_to_point import PointToPoint, point_to_point
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_leg
from trajopt_cli.trajectories.leg_trajectories import JointNodes, PathLeg

_SMOOTH_STEP = 0.6  # by which its constants are scaled at first, one after the other.
_SMOOTH_LAST = 0.9  # and at last.

Shares = tuple[float, float, float]

_ATTEMPTS = 40  # hairs by which a profile is made softer until its switches stand apart


def smooth(axes: Axes, problem: Problem, k: int, q: Array, cfx: Sequence[int]) -> PathLeg | JointNodes | None:
    """The motion of leg k between axes q[k], q[k + 1] at rest, as fast as was found; None where the arm cannot follow
    or leaves its ranges. A programmed time is not considered."""
    assert axes.jerk is not None
    leg = problem.legs[k]
    tries = [_along(axes, problem, k, q, cfx)]
    if leg.kind is LegKind.JOINT and not problem.coordinated:
        tries.append(_each(axes, problem, k, q))
    return min((one for one in tries if one is not None), key=lambda one: one.T, default=None)


def _each(axes: Axes, problem: Problem, k: int, q: Array) -> JointNodes | None:
    """A joint move with a profile for each axis."""
    settings = axes.settings
    leg, jerk = problem.legs[k], axes.jerk
    assert jerk is not None
    V, A = axes.velocity_on(leg) * settings.safe, axes.acceleration_on(leg) * settings.safe
    soft = 1.0
    for _ in range(_ATTEMPTS):
        move = point_to_point(q[k], q[k + 1], V, A * soft, jerk * settings.safe_jerk * soft)
        if _apart(move, axes.settings.switches_apart):
            break
        soft *= 1 - 1e-3
    else:
        return None
    grid = _grid(move, axes.settings.switches_apart)
    at, rates, _ = move.at(grid * move.duration)
    at[-1], rates[-1] = q[k + 1], 0.0
    v = rates * move.duration
    motion = JointNodes(move.duration, grid, at, v, np.diff(v, axis=0) / np.diff(grid)[:, None])
    ratios = check_leg(axes, leg, motion)
    return motion.slowed(ratios.times_slower()) if ratios.position.max() <= 1 + 1e-9 else None


def _along(axes: Axes, problem: Problem, k: int, q: Array, cfx: Sequence[int]) -> PathLeg | JointNodes | None:
    """One profile along the path, with the ratio of its constants that was found best."""
    settings = axes.settings
    leg = problem.legs[k]
    path = sample_path(axes, problem, (k, k + 1), q, cfx, settings.run_nodes // 2)
    if path is None:
        return None
    rows = stacked(rows_on(axes, problem, path, but_torques(axes)))
    L, dq = float(path.sigma[-1]), np.abs(path.along.dq).max(axis=0)
    assert axes.jerk is not None
    with np.errstate(divide="ignore"):
        caps = np.array([rows.top.min(), 1 / np.abs(rows.slopes).max(), np.min(axes.jerk / dq)]) * settings.safe
    if not np.isfinite(caps).all() or not (caps > 0).all():
        return None

    def tried(shares: Shares) -> tuple[float, float, PathLeg | JointNodes] | None:
        """The time it takes slowed down until it is legal, how much slower, and the motion as it is."""
        soft = 1.0
        for _ in range(_ATTEMPTS):
            v, a, j = (caps * shares * np.array([1.0, soft, soft]))[:, None]
            move = point_to_point(np.zeros(1), np.array([L]), v, a, j)
            if _apart(move, axes.settings.switches_apart):
                break
            soft *= 1 - 1e-3
        else:
            return None
        motion = _motion_of(axes, problem, k, q, cfx, move, L)
        ratios = check_leg(axes, leg, motion)
        if ratios.position.max() > 1 + 1e-6:
            return None
        times = ratios.times_slower()
        return motion.T * times, times, motion

    shares: Shares = 1.0, 1.0, 1.0
    known = {shares: tried(shares)}
    best, step = known[shares], _SMOOTH_STEP
    while best is not None and best[1] > 1.0 and step < _SMOOTH_LAST:
        near = [(shares[0] * step**x, shares[1] * step**y, shares[2] * step**z) for x, y, z in _DIRECTIONS]
        for one in near:
            if one not in known:
                known[one] = tried(one)
        found = [(result, one) for one in near if (result := known[one]) is not None]
        first = min(found, key=lambda pair: pair[0][0], default=None)
        if first is not None and first[0][0] < best[0]:
            best, shares = first
        else:
            step = float(np.sqrt(step))
    return None if best is None else best[2].slowed(best[1])


_DIRECTIONS = [one for one in product((-1, 0, 1), repeat=3) if sum(map(abs, one)) == 1]


def _motion_of(
    axes: Axes, problem: Problem, k: int, q: Array, cfx: Sequence[int], move: PointToPoint, L: float
) -> PathLeg | JointNodes:
    """Leg k with all axes on one profile over the length L."""
    leg, T, grid = problem.legs[k], move.duration, _grid(move, axes.settings.switches_apart)
    at, rates, _ = move.at(grid * T)
    s, v = at[:, 0] / L, rates[:, 0] * T / L
    s[0], s[-1], v[0], v[-1] = 0.0, 1.0, 0.0, 0.0
    a = np.diff(v) / np.diff(grid)
    way = q[k + 1] - q[k]
    if leg.kind is LegKind.JOINT:
        return JointNodes(T, grid, q[k] + s[:, None] * way, v[:, None] * way, a[:, None] * way)
    rail = axes.layout.rail
    return PathLeg(
        T, problem.segment(k), leg.X_FT, cfx[k] if cfx[k] >= 0 else cfx[k + 1], q[k, axes.layout.arm],
        grid, s, v, a, q[k, rail] + s[:, None] * way[rail], v[:, None] * way[rail], a[:, None] * way[rail],
    )  # fmt: skip


def _grid(move: PointToPoint, least: float) -> Array:
    """Its switches in scaled time."""
    times = move.switches / move.duration
    grid = times[np.concatenate([[True], np.diff(times) > least / 2 / move.duration])]
    grid[-1] = 1.0
    return grid


def _apart(move: PointToPoint, least: float) -> bool:
    """Whether no two switches nearly but not quite coincide."""
    gaps = np.diff(move.switches)
    return not np.any((gaps > 1e-12) & (gaps < least))
