"""The controller's loop against a world: what happens over time, until the end or the command that stops it."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import zip_longest
from math import degrees
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.impedance import ImpedanceController
from trajopt_cli.iiwa.controller.lag import held_rows
from trajopt_cli.iiwa.controller.parameters import Command, Goal, Stop, StopKind
from trajopt_cli.iiwa.controller.rotations import Nine, nine
from trajopt_cli.iiwa.task.model import RotationLaw
from trajopt_cli.iiwa.task.world import Seven, World
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


def run(
    controller: Controller | ImpedanceController,
    x_e: ArrayLike,
    world: World,
    limits: JointLimits,
    *,
    R_e: ArrayLike | None = None,
    wrench: ArrayLike | None = None,
    settle: float = 0.0,
) -> LoopRun:
    """Feed the equilibrium x_e (n, 6) [m, rad], angles from R_start, one row a period, its last row for settle [s].

    R_e (n, 3, 3): its orientations in the world, which a slerp controller goes by. wrench (n, 6) [N, Nm]: what the tool
    is told to press with besides, None for nothing. The loop stops, as KUKA's FRI would,
    before the first command that breaks a joint's range or speed (limits), has no inverse, or passes the angles' lock;
    the rows end with the last one whose command was sent.
    """
    x_e = np.asarray(x_e, dtype=np.float64)
    told = np.zeros_like(x_e) if wrench is None else np.asarray(wrench, dtype=np.float64)
    turns: list[Nine | None] = [None] * len(x_e)
    if controller.settings.rotation is RotationLaw.SLERP:
        turns = [nine(R) for R in np.asarray(R_e, dtype=np.float64).reshape(-1, 9).tolist()]
    goals = [Goal(tuple(x), R, tuple(F)) for x, R, F in zip(x_e.tolist(), turns, told.tolist(), strict=True)]
    goals += [goals[-1]] * held_rows(settle, controller.settings.h)
    command = controller.q_0
    measured = world.reset(command)
    rows: list[tuple[Any, ...]] = []
    times: list[Sequence[float]] = []
    stop: Stop | None = None
    refused = _guard(limits, controller.settings.h)
    with _no_collection():
        for goal, following in zip_longest(goals, goals[1:]):
            controller.adopt(measured)
            before = controller.seen(goal).x, controller.x, controller.v, controller.X_WT[0], command
            answer = controller.feel(measured) if following is None else controller.step(goal, measured, following)
            stop = answer if isinstance(answer, Stop) else None
            if stop is None or stop.kind not in (StopKind.TORQUE, StopKind.SINGULAR):
                rows.append((*before, measured.q, controller.force, measured.contact, measured.depth))
            if not isinstance(answer, Command):
                break
            times.append(controller.times)
            stop = refused(answer.q, command, controller.t)
            if stop is not None:
                break
            command = answer.q
            measured = world.step(answer.torque or command)
    shapes = (6,), (6,), (6,), (3, 3), (7,), (7,), (6,), (6,), ()
    values = zip(*rows, strict=True) if rows else [()] * len(shapes)
    x_e, x, v, R, sent, q, force, contact, depth = (
        np.reshape(np.array(one, dtype=np.float64), (-1, *shape)) for one, shape in zip(values, shapes, strict=True)
    )
    t = np.asarray(np.arange(len(rows)) * controller.settings.h, dtype=np.float64)
    step_times = np.array(times).reshape(len(times), len(PARTS))
    return LoopRun(t, x_e, x, v, R, sent, q, force, contact, depth, stop, step_times, world.name)


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


def _guard(limits: JointLimits, h: float) -> Callable[[Seven, Seven, float], Stop | None]:
    """What FRI checks of every command q for time t after the one before: joints within their ranges, and no faster
    than they may turn. Of what it refuses the joint furthest beyond its range, or else its speed."""
    ranges = list(zip(limits.lower.tolist(), limits.upper.tolist(), strict=True))
    speeds: list[float] = limits.velocity.tolist()

    def refused(q: Seven, before: Seven, t: float) -> Stop | None:
        far, i = max((max(low - x, x - high), i) for i, (x, (low, high)) in enumerate(zip(q, ranges, strict=True)))
        if far > _ROUNDING:
            name, limit = limits.names[i], ranges[i][q[i] > ranges[i][0]]
            message = (
                f"at {t:.3f} s {name} would go to {degrees(q[i]):.4f}°, limit {degrees(limit):g}°; "
                "shift the path, change the arm angle, or keep the force smaller"
            )
            return Stop(t, StopKind.POSITION, name, q[i], limit, "rad", message)
        rates = (abs(value - last) / h for value, last in zip(q, before, strict=True))
        used, i, rate = max((rate / speeds[i], i, rate) for i, rate in enumerate(rates))
        if used <= 1 + _ROUNDING:
            return None
        message = (
            f"at {t:.3f} s {limits.names[i]} would turn at {degrees(rate):.4g}°/s, limit {degrees(speeds[i]):g}°/s; "
            "slow the segment down, lower the stiffness, or keep away from singular poses"
        )
        return Stop(t, StopKind.SPEED, limits.names[i], rate, speeds[i], "rad/s", message)

    return refused
