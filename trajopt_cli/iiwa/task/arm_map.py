"""A map of the redundant freedom: what every arm angle means at stages of a path, and the cheapest path through it.

A cell is forbidden where a joint is out of its range, a step where a joint's mean speed exceeds its limit. The joints
are taken as the inverse gives them, within half a turn, so a step across half a turn is forbidden as too fast: right
for ranges that end before it, and on the safe side for wider ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import pi, radians
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.iiwa.task.joint_checks import ELBOW, RELATIVE, Arm, position_excess
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.srs import JOINTS
from trajopt_cli.robot.srs_inverse import inverse_branch

FREE = [j for j in range(JOINTS) if j != ELBOW]
"""The joints that an arm angle moves: joint_4 follows from the pose alone."""
_RATE = radians(90.0)  # rad/s: the fastest arm angle looked at; a joint with such a speed is near its limit anyway

Cost = Callable[[Array], Array]


@dataclass(frozen=True)
class NoPlan:
    """None was found: the row of the sequence, or the stage of the map, at which it fails, and why."""

    row: int
    message: str


@dataclass(frozen=True, eq=False)
class ArmTask:
    """What an arm follows: flange poses X_WF (n, 4, 4), h [s] apart."""

    arm: Arm
    X_WF: Array
    h: float

    def joints(self, angles: Array | float) -> Array:
        """Joints (n, 7) at arm angles (n,) or one [rad], continuous."""
        return self.arm.joints(self.X_WF, angles)


@dataclass(frozen=True, eq=False)
class ArmMap:
    """Joints q (K + 1, m, 7) [rad] of one configuration at rows (K + 1,) of a sequence and arm angles delta (m,) [rad].

    delta: one turn, the first is the start joints' own. on_axis (K + 1,) [m]: how far the wrist centre is from axis 1,
    where the arm angle has no reference.
    """

    rows: IndexArray
    delta: Array
    q: Array
    on_axis: Array

    @property
    def cell(self) -> float:
        """Width of a cell [rad]."""
        return 2 * pi / len(self.delta)


def arm_map(task: ArmTask, rows: IndexArray, cells: int) -> ArmMap:
    """The map of what the arm follows at rows, one turn in cells, from the arm angle of the start joints on."""
    arm = task.arm
    delta = np.asarray(arm.begin + 2 * pi / cells * np.arange(cells), dtype=np.float64)
    how = delta[:, None], arm.definition, arm.configuration
    q = np.array([inverse_branch(arm.robot, X[None], *how)[:, 0] for X in task.X_WF[rows]])
    wrist = arm.robot.axes_and_points(q[:, 0])[2][:, 6]
    return ArmMap(rows, delta, q, np.asarray(np.hypot(wrist[0], wrist[1])))


def stages(n: int, count: int) -> IndexArray:
    """At most count + 1 rows of n, evenly spread, both ends among them."""
    return np.unique(np.round(np.linspace(0, n - 1, count + 1)).astype(np.intp))


def margins(q: Array, limits: JointLimits) -> Array:
    """Least distance (...) [rad] of joints q (..., 7) from a position limit, joint_4 left out; negative outside."""
    return np.asarray(-position_excess(q, limits)[..., FREE].max(axis=-1))


def cheapest(
    fans: Iterator[Array], dt: Array, limits: JointLimits, cell: float, hold: Cost, drive: Cost, join: Any = np.add
) -> IndexArray | NoPlan:
    """Cells (K + 1,), counted on over whole turns, of the cheapest path from cell 0: the best there is on this grid.

    fans: the joints (m, 7) of every cell, stage after stage, K + 1 of them. dt (K,) [s]: time from stage to stage.
    cell [rad]: width of one. hold: from joints (m, 7) to what standing there costs per second, inf where it is
    forbidden. drive: from mean speeds (7, m, o), as shares of their limits, to what a step costs per second. join:
    np.add; np.maximum, with costs that are no rates, finds the path whose worst stage is best.
    """
    before = next(fans)
    cells = len(before)
    if not np.isfinite(hold(before[:1])[0]):
        return NoPlan(0, f"the arm angle of the start joints breaks a range: {_outside(before[:1], limits)}")
    most = min(max(1, int(_RATE * dt.max() / cell)), (cells - 1) // 2)
    offsets = np.arange(-most, most + 1)
    origin = (np.arange(cells)[:, None] - offsets) % cells  # [j, o]: the cell that leads to j by offset o
    cost = np.where(np.arange(cells) == 0, 0.0 if join is np.add else hold(before), np.inf)
    came: list[IndexArray] = []
    for k, q in enumerate(fans):
        rate = dt[k] if join is np.add else 1.0
        held = hold(q)
        # joints first in memory: what is taken over them then runs over long rows
        share = np.ascontiguousarray(before.T).take(origin, axis=1)
        share -= np.ascontiguousarray(q.T)[:, :, None]
        np.abs(share, out=share)
        share /= (limits.velocity * dt[k])[:, None, None]
        total = join(cost[origin], rate * drive(share))
        total[share.max(axis=0) > 1 + RELATIVE] = np.inf
        came.append(np.argmin(total, axis=1))
        cost = join(total[np.arange(cells), came[-1]], rate * held)
        if not np.isfinite(cost).any():
            if not np.isfinite(held).any():
                return NoPlan(k + 1, f"no arm angle keeps every joint in its range: {_outside(q, limits)}")
            return NoPlan(k + 1, "no arm angle that keeps every joint in its range can be reached in time")
        before = q
    back = [int(np.argmin(cost))]
    for origins in reversed(came):
        back.append(back[-1] - int(offsets[origins[back[-1] % cells]]))
    out = np.array(back[::-1])
    return np.asarray(out - out[0])


def _outside(q: Array, limits: JointLimits) -> str:
    """Which joints of q (m, 7) are out of range, the most frequent first."""
    out = position_excess(q, limits) > 0
    counts = out.sum(axis=0)
    order = [int(j) for j in np.argsort(-counts, kind="stable") if counts[j]]
    return ", ".join(
        f"{limits.names[j]}" + (f" at {100 * counts[j] / len(q):.0f} % of them" if len(q) > 1 else "") for j in order
    )
