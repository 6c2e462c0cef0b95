"""What the joints leave a path: their speeds and accelerations as limits of how fast it is run."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.joint_checks import Arm, accelerations, position_excess, speeds
from trajopt_cli.iiwa.task.model import AngleMeaning
from trajopt_cli.robot.srs_inverse import why_unreachable
from trajopt_cli.timing.varying_caps import Rows

_KEPT = 1 - 1e-5  # of the joints' limits: rows are printed, and the arm's own check has no more than rounding to give


class Untimed(Exception):
    """No timing helps: the arm cannot go there at its fixed arm angle. The message names the place and the limit."""


@dataclass(frozen=True, eq=False)
class ArmOnPath:
    """An arm that is to follow a path. meaning: how the path's angles count; near (7,): joints from which turns are
    counted on, None for the arm's start."""

    arm: Arm
    meaning: AngleMeaning
    near: Array | None = None

    def joints(self, path: Array, R: Array | None, place: str) -> Array:
        """Joints (n, 7) [rad] of poses (n, 6), orientations R (n, 3, 3) where the angles do not say them; place: of the
        poses, for messages. Raises Untimed for a pose out of reach and a joint out of its range."""
        arm, limits = self.arm, self.arm.limits
        R = rotation(path[:, 3:]) if R is None else R
        X_WF = arm.flange(R @ arm.X_start[:3, :3] if self.meaning is AngleMeaning.RELATIVE else R, path[:, :3])
        q = arm.joints(X_WF, near=self.near)
        lost = np.isnan(q).any(axis=1)
        if lost.any():
            row = int(np.argmax(lost))
            why = why_unreachable(arm.robot, X_WF[row], arm.angle, arm.definition, limits)
            raise Untimed(f"{place}, {_share(row, q)}: {why}; move the pose")
        excess = position_excess(q, limits)
        row, j = (int(i) for i in np.unravel_index(np.argmax(excess), excess.shape))
        if excess[row, j] > 0:
            limit = limits.upper[j] if q[row, j] > limits.upper[j] else limits.lower[j]
            raise Untimed(
                f"{place}, {_share(row, q)}: {limits.names[j]} would be at {degrees(q[row, j]):.4g}°, limit"
                f" {degrees(limit):.6g}°; no timing helps: give another arm_angle, begin with other joints or move the"
                " pose"
            )
        return q

    def on(self, q: Array, s: Array) -> tuple[Array, Rows]:
        """The greatest rate (n,) that the joints' speeds allow between places s (n + 1,) of a path with joints
        q (n + 1, 7), and the rows of their accelerations."""
        first = np.gradient(q, s, axis=0)
        second = np.gradient(first, s, axis=0)
        used = (np.abs(first) / (_KEPT * self.arm.limits.velocity)).max(axis=1)
        with np.errstate(divide="ignore"):
            top = 1 / np.maximum(used[:-1], used[1:])
        rows = (np.stack([x[:-1], x[1:]]) / (_KEPT * self.arm.limits.acceleration) for x in (first, second))
        slopes, bends = rows
        return top, (slopes, bends)

    def shares(self, q: Array, h: float) -> Iterator[Array]:
        """What rows q (n, 7), h [s] apart and at rest at both ends, use of the limits of speed (n - 1,) and
        acceleration (n - 2,)."""
        yield (speeds(q, h) / (_KEPT * self.arm.limits.velocity)).max(axis=1)
        used = (accelerations(q, h) / (_KEPT * self.arm.limits.acceleration)).max(axis=1)
        used[1] = max(used[:2])
        used[-2] = max(used[-2:])
        yield used[1:-1]

    def fastest(self, q: Array, place: str) -> str:
        """Where and which joint moves farthest from one row to the next, as what prevents a timing."""
        limits, step = self.arm.limits, np.abs(np.diff(q, axis=0))
        row, j = (int(i) for i in np.unravel_index(np.argmax(step / limits.velocity), step.shape))
        return (
            f"{place}, {_share(row, q)}: {limits.names[j]} turns by {degrees(step[row, j]):.3g}° at one place of"
            " the path, as at a singularity; no timing helps: move the pose, or give another arm_angle"
        )


def _share(row: int, q: Array) -> str:
    return f"{100 * row / (len(q) - 1):.0f} % of the way"
