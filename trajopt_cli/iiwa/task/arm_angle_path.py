"""An arm angle that moves: the redundant freedom of seven joints, used to stay away from limits and singularities.

Dynamic programming over a grid of stages in time and cells of arm angle finds the cheapest course; moving averages
make it smooth; every row of the result is then checked. What one pair of grids misses, the next finer one is tried on.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import pi, radians

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.iiwa.task.arm_map import FREE, Blocked, cheapest, fans, stages
from trajopt_cli.iiwa.task.joint_checks import ELBOW, Place
from trajopt_cli.iiwa.task.joint_rows import RELATIVE, accelerations, joints_along, passes, position_excess, speeds
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_inverse import ArmAngle, arm_angle

_GRIDS = ((0.1, 360), (0.05, 720), (0.025, 720))
"""Stage [s] and cells per turn, coarse first."""
_FEWEST_STAGES = 20  # so that a short motion, too, has stages to turn in
_SINGULAR = radians(10.0)  # rad of joint_2 or joint_6 from zero where nearness costs as much as 70 % of a joint's range
_MOTION = 4.0  # cost of joint speed against that of nearness to limits: above one, a course that rests more
_WINDOWS = (1.0, 0.5, 0.25, 0.12, 0.06)
"""s: widths of the moving average, smoothest first."""
_BETTER = 0.99  # a smoother course is kept unless the next one's accelerations are this share of its own
_PASSES = 3  # averages of averages: a corner of the course becomes an arc whose acceleration is continuous


@dataclass(frozen=True, eq=False)
class ArmCourse:
    """Arm angles (n,) [rad] without jumps, and the joints q (n, 7) [rad] that keep position and speed limits."""

    arm_angle: Array
    q: Array


@dataclass(frozen=True)
class NoCourse:
    """None was found: the time [s] at which it fails, and why."""

    time: float
    message: str


def find_course(
    robot: SrsRobot,
    X_WF: Array,
    h: float,
    limits: JointLimits,
    definition: ArmAngle,
    configuration: int,
    start: Array,
    place: Place,
) -> ArmCourse | NoCourse:
    """A course of the arm angle along flange poses X_WF (n, 4, 4), h [s] apart, all of them in reach.

    It begins at the arm angle of the start joints (7,) and rests at both ends; the configuration stays. Of the smooth
    courses that keep positions and speeds, the first whose accelerations pass too (or are no worse than the elbow's,
    which no arm angle changes), otherwise the one with the least. place: names a row for people.
    """
    begin = float(arm_angle(robot, start, definition))
    best: tuple[float, ArmCourse] | None = None
    failure = NoCourse(0.0, "")
    for stage, cells in _GRIDS:
        count = max(_FEWEST_STAGES, int(np.ceil((len(X_WF) - 1) * h / stage)))
        rows = stages(len(X_WF), count)
        cell = 2 * pi / cells
        grid = np.asarray(begin + cell * np.arange(cells), dtype=np.float64)
        every = fans(robot, X_WF[rows], definition, configuration, grid)
        nodes = cheapest(every, np.diff(rows) * h, limits, cell, partial(_holding, limits=limits), _driving)
        if isinstance(nodes, Blocked):
            row = int(rows[nodes.stage])
            failure = NoCourse(row * h, f"at t = {row * h:.3f} s ({place(row)}) {nodes.why}")
            continue
        for window in _WINDOWS:
            angles = _smooth(np.asarray(begin + cell * nodes, dtype=np.float64), rows, len(X_WF), round(window / h))
            course = ArmCourse(angles, joints_along(robot, X_WF, angles, definition, configuration, start))
            if not passes(course.q, h, limits):
                row = _first_broken(course.q, h, limits)
                at = f"t = {row * h:.3f} s ({place(row)})"
                failure = NoCourse(row * h, f"the one found on a grid, made smooth, breaks a limit at {at}")
                continue
            used = (accelerations(course.q, h) / limits.acceleration).max(axis=0)
            worst = float(used.max())
            if worst <= max(1.0, float(used[ELBOW])) * (1 + RELATIVE):
                return course
            if best is None or worst < _BETTER * best[0]:
                best = worst, course
    return failure if best is None else best[1]


def _driving(share: Array) -> Array:
    """Cost per second (...) of joint speeds that are these shares (7, ...) of their limits."""
    squares = np.minimum(share * share, 1 - 1e-3)  # at its very speed limit a joint costs much, but not all
    return np.asarray(_MOTION * (squares / (1 - squares)).sum(axis=0))


def _holding(q: Array, limits: JointLimits) -> Array:
    """Cost per second (...) of standing at q (..., 7): nearness to position limits and singularities; inf outside."""
    half = (limits.upper - limits.lower) / 2
    used = np.square((q - (limits.upper + limits.lower) / 2) / half)
    outside = np.any(position_excess(q, limits) > RELATIVE * 2 * half, axis=-1)
    used = np.minimum(used[..., FREE], 1 - 1e-6)  # the elbow's share is the same at every arm angle
    with np.errstate(divide="ignore"):
        singular = np.square(np.sin(_SINGULAR) / np.sin(q[..., [1, 5]]))
    cost = (used / (1 - used)).sum(axis=-1) + np.minimum(singular, 1e6).sum(axis=-1)
    return np.where(outside, np.inf, cost)


def _smooth(nodes: Array, rows: IndexArray, n: int, width: int) -> Array:
    """Angles (n,) of a smooth course near nodes (K + 1,) at rows: moving averages of width rows over straight pieces.

    The ends are mirrored, so the course rests there. What the average takes from the first value is given back, fading
    out over the time that the averages look ahead.
    """
    half = max(1, min(width // 2, (n - 1) // (2 * _PASSES)))
    reach = _PASSES * half
    begin = nodes[0]
    out = np.pad(np.interp(np.arange(n), rows, nodes - begin), reach, mode="reflect")
    for _ in range(_PASSES):
        total = np.concatenate([[0.0], np.cumsum(out)])
        out = (total[2 * half + 1 :] - total[: -2 * half - 1]) / (2 * half + 1)
    u = np.clip(np.arange(n) / (2 * reach), 0.0, 1.0)
    fading = 1 - u * u * u * (10 - u * (15 - 6 * u))
    return np.asarray(begin + out - out[0] * fading)


def _first_broken(q: Array, h: float, limits: JointLimits) -> int:
    broken = np.asarray(np.any(position_excess(q, limits) > RELATIVE * (limits.upper - limits.lower), axis=1))
    broken[:-1] |= np.any(speeds(q, h) > limits.velocity * (1 + RELATIVE), axis=1)
    return int(np.argmax(broken))
