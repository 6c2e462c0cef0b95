"""How positioners turn during a plan: in step with a line or an arc on a work object that rides on them, else
from rest to rest over the whole motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.leg_trajectories import LegMotion
from trajopt_cli.trajectories.unit_shares import fastest, unit_shares, units_of
from trajopt_cli.trajectory import Trajectory


def turning(problem: Problem) -> list[bool]:
    """During which legs any positioner turns."""
    return [bool(units_of(problem, k)) for k in range(len(problem.legs))]


def switches(problem: Problem, legs: Sequence[LegMotion]) -> list[float]:
    """The times [s] at which a unit that turns by itself begins or ends to keep its speed."""
    out, begin = [], 0.0
    for k, motion in enumerate(legs):
        for unit in units_of(problem, k):
            if unit not in problem.legs[k].units:
                _, ramp, least = fastest(unit)
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
        share, rate = unit_shares(problem, k, motion, t)
        for i, unit in enumerate(units_of(problem, k)):
            j = names.index(unit.column)
            q[first : last + 1, j], q[last:, j] = unit.start + share[:, i] * unit.angle, unit.end
            qd[first : last + 1, j] = rate[:, i] * unit.angle
            qd[[first, last], j] = 0.0
    return replace(rows, tables=Trajectory(names, rows.t, q, qd))
