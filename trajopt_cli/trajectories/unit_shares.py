"""How far positioners have turned during a motion: in step with a line or an arc on a work object that rides on them,
else from rest to rest over the whole of it."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import UnitMove
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.leg_trajectories import LegMotion, shares


def units_of(problem: Problem, k: int) -> tuple[UnitMove, ...]:
    """The axes that turn during leg k."""
    units: tuple[UnitMove, ...] = getattr(problem.motion(problem.legs[k].motion), "units", ())
    return units


def unit_shares(problem: Problem, k: int, motion: LegMotion, t: Array) -> tuple[Array, Array]:
    """What the axes have turned of their angles (m, U) at times t (m,) of leg k's motion, and the rate of that."""
    out = np.zeros((2, len(units_of(problem, k)), len(t)))
    for i, unit in enumerate(units_of(problem, k)):
        steps = unit in problem.legs[k].units
        out[:, i] = shares(motion, t)[:2] if steps else _rest_to_rest(unit, motion.T, t)
    return out[0].T, out[1].T


def _rest_to_rest(unit: UnitMove, T: float, t: Array) -> tuple[Array, Array]:
    """The fraction of its angle that a unit has turned at times t (n,), and its rate: its fastest motion in T."""
    way, (top, ramp, least) = abs(unit.angle), fastest(unit)
    u = t * (least / T)
    rate = np.clip(np.minimum(u, least - u) / ramp, 0.0, 1.0) * top
    up, down = u < ramp, u > least - ramp
    gone = np.where(up, unit.acceleration * u**2 / 2, top * (u - ramp / 2))
    gone = np.where(down, way - unit.acceleration * np.maximum(least - u, 0.0) ** 2 / 2, gone)
    return gone / way, rate * (least / T) / way


def fastest(unit: UnitMove) -> tuple[float, float, float]:
    """The top speed [rad/s] of a unit's fastest motion, how long it takes to reach it, and the whole [s]."""
    way = abs(unit.angle)
    top = min(unit.velocity, float(np.sqrt(unit.acceleration * way)))
    return top, top / unit.acceleration, way / top + top / unit.acceleration
