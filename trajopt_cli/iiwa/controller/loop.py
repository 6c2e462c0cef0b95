"""The controller's loop against a world: what happens over time, until the end or the command that stops it."""

from __future__ import annotations

import gc
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import zip_longest
from math import degrees

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.lag import held_rows
from trajopt_cli.iiwa.controller.parameters import Command, Goal, Stop, StopKind
from trajopt_cli.iiwa.controller.rotations import Nine, nine
from trajopt_cli.iiwa.task.model import RotationLaw
from trajopt_cli.iiwa.task.world import Measured, Seven, Six, World
from trajopt_cli.limits import JointLimits

_ROUNDING = 1e-9  # of a limit, and rad: a command this little beyond it stands on it

PARTS = ("torque model", "force mapping", "regulator", "inverse kinematics", "whole")
"""What of a period is timed. The thesis' 148 us hold all but the torque model, which KUKA's cabinet computes."""


@dataclass(frozen=True, eq=False)
class LoopRun:
    """Rows k = 0..n-1 at times t = k h [s]: what was commanded for that time, and what was true then.

    x_e, x (n, 6) [m, rad]: equilibrium and regulator in the frames of that moment, v (n, 6) its rates; R (n, 3, 3): its
    orientation in the world. q_command, q (n, 7) [rad]: joints commanded for this time, and measured then.
    force_believed (n, 6) [N, Nm]: after clamps, pushes and zeroing, acting from this row to the next; contact_true
    (n, 6): the world's own, and how deep [m] the tool is in something, depth (n,). stop: why there are no more rows,
    None at the end. step_times (m, 5) [s]: how long each of the m periods took, by PARTS. world: its name.
    """

    t: Array
    x_e: Array
    x: Array
    v: Array
    R: Array
    q_command: Array
    q: Array
    force_believed: Array
    contact_true: Array
    depth: Array
    stop: Stop | None
    step_times: Array
    world: str

    def __post_init__(self) -> None:
        for name in ("t", "x_e", "x", "v", "R", "q_command", "q", "force_believed", "contact_true", "depth"):
            object.__setattr__(self, name, readonly(getattr(self, name)))
        object.__setattr__(self, "step_times", readonly(self.step_times))


@dataclass(frozen=True)
class _Row:
    x_e: Six
    x: Six
    v: Six
    R: Nine
    q_command: Seven
    force: Six
    measured: Measured


def run(
    controller: Controller,
    x_e: ArrayLike,
    world: World,
    limits: JointLimits,
    *,
    R_e: ArrayLike | None = None,
    settle: float = 0.0,
) -> LoopRun:
    """Feed the equilibrium x_e (n, 6) [m, rad], angles from R_start, one row a period, its last row for settle [s].

    R_e (n, 3, 3): its orientations in the world, which a slerp controller goes by. The loop stops, as KUKA's FRI would,
    before the first command that breaks a joint's range or speed (limits), has no inverse, or passes the angles' lock;
    the rows end with the last one whose command was sent. Raises ValueError for other shapes and for a slerp
    controller without R_e.
    """
    goals = _goals(x_e, R_e, controller.settings.rotation)
    goals += [goals[-1]] * held_rows(settle, controller.settings.h)
    q = controller.q_0
    measured = world.reset(q)
    rows: list[_Row] = []
    times: list[Sequence[float]] = []
    stop: Stop | None = None
    guard = _Guard(limits, controller.settings.h)
    with _no_collection():
        for goal, following in zip_longest(goals, goals[1:]):
            controller.adopt()
            before = controller.seen(goal).x, controller.x, controller.v, controller.X_WT[0], q
            answer = controller.feel(measured) if following is None else controller.step(goal, measured, following)
            stop = answer if isinstance(answer, Stop) else None
            if stop is None or stop.kind not in (StopKind.TORQUE, StopKind.SINGULAR):
                rows.append(_Row(*before, controller.force, measured))
            if not isinstance(answer, Command):
                break
            times.append(controller.times)
            stop = guard.refused(answer.q, q, controller.t)
            if stop is not None:
                break
            q = answer.q
            measured = world.step(q)
    return _gathered(rows, times, stop, controller.settings.h, world.name)


@contextmanager
def _no_collection() -> Iterator[None]:
    """Python's collector stops everything for tens of ms when many rows are kept; the loop leaves it nothing to do."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


class _Guard:
    """What FRI checks of every command: joints within their ranges, and no faster than they may turn."""

    def __init__(self, limits: JointLimits, h: float) -> None:
        self._names, self._h = limits.names, h
        self._ranges = list(zip(limits.lower.tolist(), limits.upper.tolist(), strict=True))
        self._speeds: list[float] = limits.velocity.tolist()

    def refused(self, q: Seven, before: Seven, t: float) -> Stop | None:
        """The joint furthest beyond its range, or else its speed, of a command for time t; None: it may be sent."""
        far, i = max((max(low - value, value - high), i) for i, (value, (low, high)) in self._joints(q))
        if far > _ROUNDING:
            low, high = self._ranges[i]
            return self._beyond_range(i, q[i], low if q[i] < low else high, t)
        paces = (abs(value - last) / self._h for value, last in zip(q, before, strict=True))
        share, i, pace = max((pace / self._speeds[i], i, pace) for i, pace in enumerate(paces))
        return self._too_fast(i, pace, t) if share > 1 + _ROUNDING else None

    def _joints(self, q: Seven) -> enumerate[tuple[float, tuple[float, float]]]:
        return enumerate(zip(q, self._ranges, strict=True))

    def _beyond_range(self, i: int, value: float, limit: float, t: float) -> Stop:
        name = self._names[i]
        message = (
            f"at {t:.3f} s {name} would go to {degrees(value):.4f}°, limit {degrees(limit):g}°; "
            "shift the path, change the arm angle, or keep the force smaller"
        )
        return Stop(t, StopKind.POSITION, name, value, limit, "rad", message)

    def _too_fast(self, i: int, pace: float, t: float) -> Stop:
        name, limit = self._names[i], self._speeds[i]
        message = (
            f"at {t:.3f} s {name} would turn at {degrees(pace):.4g}°/s, limit {degrees(limit):g}°/s; "
            "slow the segment down, lower the stiffness, or keep away from singular poses"
        )
        return Stop(t, StopKind.SPEED, name, pace, limit, "rad/s", message)


def _goals(x_e: ArrayLike, R_e: ArrayLike | None, law: RotationLaw) -> list[Goal]:
    rows = np.asarray(x_e, dtype=np.float64)
    n = len(rows)
    if rows.shape != (n, 6) or n == 0:
        raise ValueError(f"x_e has shape {rows.shape}, wanted (n, 6) with n >= 1")
    if law is RotationLaw.TAIT_BRYAN:
        return [Goal(tuple(row)) for row in rows.tolist()]
    turns = np.asarray(np.nan if R_e is None else R_e, dtype=np.float64)
    if turns.shape != (n, 3, 3):
        raise ValueError(f"R_e has shape {turns.shape}, wanted ({n}, 3, 3): slerp goes by the orientations")
    return [Goal(tuple(row), nine(R)) for row, R in zip(rows.tolist(), turns.reshape(n, 9).tolist(), strict=True)]


def _gathered(
    rows: Sequence[_Row], times: Sequence[Sequence[float]], stop: Stop | None, h: float, world: str
) -> LoopRun:
    n = len(rows)

    def column(values: Sequence[Sequence[float]], *shape: int) -> Array:
        return np.array(values, dtype=np.float64).reshape(n, *shape)

    return LoopRun(
        t=np.asarray(np.arange(n) * h, dtype=np.float64),
        x_e=column([row.x_e for row in rows], 6),
        x=column([row.x for row in rows], 6),
        v=column([row.v for row in rows], 6),
        R=column([row.R for row in rows], 3, 3),
        q_command=column([row.q_command for row in rows], 7),
        q=column([row.measured.q for row in rows], 7),
        force_believed=column([row.force for row in rows], 6),
        contact_true=column([row.measured.contact for row in rows], 6),
        depth=np.array([row.measured.depth for row in rows]),
        stop=stop,
        step_times=np.array(times).reshape(len(times), len(PARTS)),
        world=world,
    )
