"""An arm angle that moves: the redundant freedom of seven joints, used to stay away from limits and singularities.

Dynamic programming over a grid of stages in time and cells of arm angle finds the cheapest path; moving averages
smooth it; every row of the result is then checked. What one pair of grids misses, the next finer one is tried on.
"""

from __future__ import annotations

from functools import partial
from math import pi, radians

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.iiwa.task.arm_map import FREE, ArmTask, Blocked, NoPlan, cheapest, fans, stages
from trajopt_cli.iiwa.task.joint_checks import ELBOW
from trajopt_cli.iiwa.task.joint_rows import RELATIVE, accelerations, passes, position_excess, speeds
from trajopt_cli.limits import JointLimits

_GRIDS = ((0.1, 360), (0.05, 720), (0.025, 720))
"""Stage [s] and cells per turn, coarse first."""
_FEWEST_STAGES = 20  # so that a short motion, too, has stages to turn in
_SINGULAR = radians(10.0)  # rad of joint_2 or joint_6 from zero where nearness costs as much as 70 % of a joint's range
_MOTION = 4.0  # cost of joint speed against that of nearness to limits: above one, a path that rests more
_WINDOWS = (1.0, 0.5, 0.25, 0.12, 0.06)
"""s: widths of the moving average, smoothest first."""
_BETTER = 0.99  # a smoother path is kept unless the next one's accelerations are this share of its own
_PASSES = 3  # averages of averages: a corner of the path becomes an arc whose acceleration is continuous


def find_path(task: ArmTask) -> tuple[Array, Array] | NoPlan:
    """Arm angles (n,) [rad] without jumps and joints (n, 7) [rad] of an arm whose poses are all in reach.

    The arm angle begins at that of the start joints and rests at both ends. Of the smooth paths that keep positions and
    speeds, the first whose accelerations pass too (or are no worse than the elbow's, which no arm angle changes),
    otherwise the one with the least.
    """
    h, limits, begin, n = task.h, task.limits, task.begin, len(task.X_WF)
    best: tuple[float, Array, Array] | None = None
    failure = NoPlan(0, "")
    for stage, cells in _GRIDS:
        rows = stages(n, max(_FEWEST_STAGES, int(np.ceil((n - 1) * h / stage))))
        cell = 2 * pi / cells
        grid = np.asarray(begin + cell * np.arange(cells), dtype=np.float64)
        every = fans(task, rows, grid)
        nodes = cheapest(every, np.diff(rows) * h, limits, cell, partial(_holding, limits=limits), _driving)
        if isinstance(nodes, Blocked):
            failure = NoPlan(int(rows[nodes.stage]), nodes.why)
            continue
        for window in _WINDOWS:
            angles = _smooth(np.asarray(begin + cell * nodes, dtype=np.float64), rows, n, round(window / h))
            q = task.joints(angles)
            if not passes(q, h, limits):
                failure = NoPlan(_first_broken(q, h, limits), "the one found on a grid, made smooth, breaks a limit")
                continue
            used = (accelerations(q, h) / limits.acceleration).max(axis=0)
            worst = float(used.max())
            if worst <= max(1.0, float(used[ELBOW])) * (1 + RELATIVE):
                return angles, q
            if best is None or worst < _BETTER * best[0]:
                best = worst, angles, q
    return failure if best is None else best[1:]


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
    """Angles (n,) of a smooth path near nodes (K + 1,) at rows: moving averages of width rows over straight pieces.

    The ends are mirrored, so the path rests there. What the average takes from the first value is given back, fading
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
