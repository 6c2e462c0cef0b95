"""How positioners turn during a plan: in step with a line or an arc on a work object that rides on them, else
from rest to rest over the whole motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import UnitMove
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.leg_trajectories import LegMotion, shares
from trajopt_cli.trajectory import Trajectory


def turning(problem: Problem) -> list[bool]:
    """During which legs any positioner turns."""
    return [bool(_units(problem, k)) for k in range(len(problem.legs))]


def switches(problem: Problem, legs: Sequence[LegMotion]) -> list[float]:
    """The times [s] at which a unit that turns by itself begins or ends to keep its speed."""
    out, begin = [], 0.0
    for k, motion in enumerate(legs):
        for unit in _units(problem, k):
            if unit not in problem.legs[k].units:
                _, ramp, least = _fastest(unit)
                out += [begin + share * motion.T for share in (ramp / least, 1 - ramp / least)]
        begin += motion.T
    return out


def with_tables(problem: Problem, legs: Sequence[LegMotion], rows: Trajectory, bounds: Array) -> Trajectory:
    """The rows with the axes of all positioners that the program turns. bounds (L+1,): the legs' times."""
    moves = [unit for motion in problem.program.motions for unit in getattr(motion, "units", ())]
    starts = {unit.column: unit.start for unit in reversed(moves)}
    if not starts:
        return rows
    names = tuple(sorted(starts))
    q = np.tile([starts[name] for name in names], (len(rows.t), 1))
    qd = np.zeros_like(q)
    for k, motion in enumerate(legs):
        first, last = np.searchsorted(rows.t, bounds[k : k + 2])
        t = np.clip(rows.t[first : last + 1] - bounds[k], 0.0, motion.T)
        for unit in _units(problem, k):
            share, rate = shares(motion, t)[:2] if unit in problem.legs[k].units else _rest_to_rest(unit, motion.T, t)
            j = names.index(unit.column)
            q[first : last + 1, j], q[last:, j] = unit.start + share * unit.angle, unit.end
            qd[first : last + 1, j] = rate * unit.angle
            qd[[first, last], j] = 0.0
    return replace(rows, tables=Trajectory(names, rows.t, q, qd))


def _units(problem: Problem, k: int) -> tuple[UnitMove, ...]:
    units: tuple[UnitMove, ...] = getattr(problem.motion(problem.legs[k].motion), "units", ())
    return units


def _rest_to_rest(unit: UnitMove, T: float, t: Array) -> tuple[Array, Array]:
    """The fraction of its angle that a unit has turned at times t (n,), and its rate: its fastest motion in T."""
    way, (top, ramp, least) = abs(unit.angle), _fastest(unit)
    u = t * (least / T)
    rate = np.clip(np.minimum(u, least - u) / ramp, 0.0, 1.0) * top
    up, down = u < ramp, u > least - ramp
    gone = np.where(up, unit.acceleration * u**2 / 2, top * (u - ramp / 2))
    gone = np.where(down, way - unit.acceleration * np.maximum(least - u, 0.0) ** 2 / 2, gone)
    return gone / way, rate * (least / T) / way


def _fastest(unit: UnitMove) -> tuple[float, float, float]:
    """The top speed [rad/s] of a unit's fastest motion, how long it takes to reach it, and the whole [s]."""
    way = abs(unit.angle)
    top = min(unit.velocity, float(np.sqrt(unit.acceleration * way)))
    return top, top / unit.acceleration, way / top + top / unit.acceleration
