"""An arm's joints: limits by divided differences, one configuration, one arm angle, no jumps, rest at both ends."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.samples import Poses, worst
from trajopt_cli.iiwa.judge.task_order import JudgedArm, Order
from trajopt_cli.iiwa.judge.tolerances import ARM_ANGLE, BETWEEN, FOLLOW, JOINT, REST, ROUNDING, START
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.findings import finding
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.judge.samples import second_differences
from trajopt_cli.judge.tolerances import COMPUTED
from trajopt_cli.trajectory import Trajectory

SIGNED = (1, 3, 5)
"""Joints 2, 4 and 6: their signs are the configuration."""
_COLLINEAR = 1e-9  # m: an elbow or a vertical this near the line from shoulder to wrist has no direction from it


def elbow_circle(mechanism: Mechanism, q: Array) -> tuple[Array, Array]:
    """Swivel angles (n,) [rad] at joints q (n, 7), and how far (n,) [m] the elbow stands off the line from shoulder S
    to wrist centre W (0 where there is no angle).

    S, E and W are where axes 1 and 2, 3 and 4, 5 and 6 meet. The angle goes right-handed about S -> W, from the half
    plane that holds the base's z direction to the one that holds the elbow.
    """
    X, J = mechanism.flange(q)
    axes = J[:, 3:]  # (n, 3, 7): unit, in the world
    # the flange turns about axis i with speed J_i = a_i x (p - o_i): a point of the axis is p + a_i x J_i
    points = X[:, :3, 3, None] + np.cross(axes, J[:, :3], axis=1)
    S, E, W = (_meeting(axes, points, i) for i in (0, 2, 4))
    along = W - S
    reach = np.linalg.norm(along, axis=1, keepdims=True)
    n = along / np.where(reach > 0, reach, 1.0)
    up, out = axes[:, :, 0], E - S  # axis 1 is the base's z
    up, out = (v - np.sum(v * n, axis=1, keepdims=True) * n for v in (up, out))
    angle = np.arctan2(np.sum(n * np.cross(up, out), axis=1), np.sum(up * out, axis=1))
    off = np.minimum(np.linalg.norm(out, axis=1), np.linalg.norm(up, axis=1) * reach[:, 0])
    return np.asarray(angle), np.where(off > _COLLINEAR, off, 0.0)


def arm_angles(mechanism: Mechanism, q: Array, swivel: bool) -> tuple[Array, Array]:
    """As elbow_circle, counted as the task does. Faria's angle is that from the elbow of an arm with q3 = 0 and the
    same sign of q4: upright above S -> W where q4 is negative, and below it else."""
    angle, off = elbow_circle(mechanism, q)
    return angle if swivel else angle - np.where(q[:, 3] < 0, 0.0, np.pi), off


def wrapped(angle: Array | float) -> Array:
    """Within half a turn of 0."""
    return np.asarray(angle - 2 * np.pi * np.rint(np.asarray(angle) / (2 * np.pi)))


def configuration(q: Array) -> int:
    """(q2 < 0) + 2 (q4 < 0) + 4 (q6 < 0) at joints q (7,)."""
    return sum(int(q[joint] < 0) << bit for bit, joint in enumerate(SIGNED))


def _meeting(axes: Array, points: Array, i: int) -> Array:
    """Where axes i and i + 1 meet (n, 3): the point of the first that is nearest to the second."""
    a, b = axes[:, :, i], axes[:, :, i + 1]
    between = points[:, :, i + 1] - points[:, :, i]
    cosine = np.sum(a * b, axis=1, keepdims=True)
    along = np.sum(between * (a - cosine * b), axis=1, keepdims=True) / (1 - cosine * cosine)
    return np.asarray(points[:, :, i] + along * a)


_TURN = np.pi  # rad: a joint that moves this far from row to row has jumped


def check_limits(arm: JudgedArm, rows: Trajectory, resolution: Resolution | None) -> Iterator[Finding]:
    """Position, speed and acceleration of every joint, jumps, and the speed columns where there are any."""
    t, q, gaps = rows.t, rows.q, np.diff(rows.t)
    half = np.full(q.shape[1], COMPUTED) if resolution is None else np.maximum(resolution.q.max(axis=0) / 2, COMPUTED)
    off_t = 0.0 if resolution is None else float(np.max(resolution.t))
    step = np.diff(q, axis=0)
    speed, doubt_v = step / gaps[:, None], 2 * half / gaps.min()
    for j, name in enumerate(rows.names):
        low, high = float(arm.lower[j]), float(arm.upper[j])
        outside = np.maximum(q[:, j] - high, low - q[:, j])
        row = int(np.argmax(outside))
        bound = high if q[row, j] - high >= low - q[row, j] else low
        passed = bool(outside[row] <= JOINT * (high - low) + half[j])
        yield finding("joint position", name, q[row, j], bound, "rad", passed, time=float(t[row]), words="position")
        row = int(np.argmax(np.abs(step[:, j])))
        size = abs(float(step[row, j]))
        note = ": a jump; whole turns and other branches are other joints"
        yield finding("jump", name, size, _TURN, "rad", size < _TURN, time=float(t[row + 1]), note=note)
        row = int(np.argmax(np.abs(speed[:, j])))
        size, most = abs(float(speed[row, j])), float(arm.velocity[j])
        passed = size <= most * (1 + JOINT) + doubt_v[j] + size * off_t / float(gaps[row])
        yield finding("joint speed", name, size, most, "rad/s", passed, time=float(t[row]), words="speed")
        yield _acceleration(arm, rows, j, half[j], off_t)
    if rows.qd is not None:
        yield from _speed_columns(arm, rows, speed, doubt_v, resolution)


def _acceleration(arm: JudgedArm, rows: Trajectory, j: int, half: float, off_t: float) -> Finding:
    """The greatest second divided difference less its doubt, over one gap or several; from rest and to rest at the
    ends: who is at a step's end after a gap has needed twice the step over the gap's square."""
    t, x = rows.t, rows.q[:, j]
    most = float(arm.acceleration[j])
    found: list[tuple[float, float, float]] = []  # less its doubt, as it is, when
    for lag, values, doubt in second_differences(t, x[:, None], np.array([half]), off_t):
        sizes = np.abs(values[:, 0])
        row = int(np.argmax(sizes - doubt[:, 0]))
        found.append((float(sizes[row] - doubt[row, 0]), float(sizes[row]), float(t[row + lag])))
    for a, b in ((0, 1), (-1, -2)):
        gap = abs(float(t[a] - t[b]))
        size = 2 * abs(float(x[a] - x[b])) / gap**2
        found.append((size - 4 * half / gap**2, size, float(t[a])))
    sure, size, time = max(found)
    passed = sure <= most * (1 + JOINT)
    return finding("joint acceleration", rows.names[j], size, most, "rad/s2", passed, time=time, words="acceleration")


def _speed_columns(
    arm: JudgedArm, rows: Trajectory, speed: Array, doubt: Array, resolution: Resolution | None
) -> Iterator[Finding]:
    """Speed columns: within the limits, between the speeds of the steps beside their row but for what the joint's
    acceleration may change in half a gap, and rest in the first and in the last row."""
    assert rows.qd is not None
    printed = np.zeros(len(rows.names)) if resolution is None else resolution.qd.max(axis=0) / 2
    before, after = np.concatenate([0 * speed[:1], speed]), np.concatenate([speed, 0 * speed[-1:]])
    low, high = np.minimum(before, after), np.maximum(before, after)
    for j, name in enumerate(rows.names):
        most = float(arm.acceleration[j] * np.diff(rows.t).max() / 2 + doubt[j] + printed[j])
        off = np.maximum(np.maximum(rows.qd[:, j] - high[:, j], low[:, j] - rows.qd[:, j]), 0.0)
        words = "speed differs from that of its positions by"
        yield worst("speed column", name, off, most, "rad/s", rows.t, words=words)
        row = int(np.argmax(np.abs(rows.qd[:, j])))
        value, most = abs(float(rows.qd[row, j])), float(arm.velocity[j])
        passed = value <= most * (1 + JOINT) + printed[j]
        yield finding("joint speed", name, value, most, "rad/s", passed, time=float(rows.t[row]), words="speed")
    for what, row in (("first row", 0), ("last row", -1)):
        j = int(np.argmax(np.abs(rows.qd[row])))
        value, most = abs(float(rows.qd[row, j])), REST + printed[j]
        yield finding(
            what, rows.names[j], value, most, "rad/s", value <= most, time=float(rows.t[row]),
            words=f"is not at rest in the {what}:",
        )  # fmt: skip


def check_posture(
    order: Order, rows: Trajectory, reported: tuple[float, float] | None, first_is_start: bool
) -> Iterator[Finding]:
    """One configuration, that of the start, and one arm angle: the task's, else that of the start.

    reported: least and greatest [rad] between which the maker says it moves instead. first_is_start: the first pose is
    the tool's at the start's joints.
    """
    q, t, start = rows.q, rows.t, order.start_joints
    wanted = configuration(start)
    for bit, j in enumerate(SIGNED):
        sign = -1.0 if wanted >> bit & 1 else 1.0
        row = int(np.argmin(sign * q[:, j]))
        value = float(sign * q[row, j])
        side = "negative" if sign < 0 else "positive"
        yield finding(
            "configuration", rows.names[j], sign * value, 0.0, "rad", value >= -ROUNDING, time=float(t[row]),
            bound="wanted", words="leaves the start's configuration:", note=f" or {side}",
        )  # fmt: skip
    angle, off = arm_angles(order.arm.mechanism, q, order.swivel)
    at_start = arm_angles(order.arm.mechanism, start[None], order.swivel)[0]
    fixed = float(at_start[0]) if order.arm_angle is None else order.arm_angle
    doubt = np.where(off > 0, 10 * ROUNDING / np.maximum(off, 1e-300), np.inf)
    moves = reported is not None and reported[1] - reported[0] > ARM_ANGLE
    if moves or order.arm_angle_free:
        if reported is not None:
            middle, half = (reported[0] + reported[1]) / 2, (reported[1] - reported[0]) / 2
            off = np.maximum(np.abs(wrapped(angle - middle)) - half - doubt, 0.0)
            yield worst("arm angle range", "elbow", off, ARM_ANGLE, "rad", t, words="leaves its reported range by")
    else:
        off = np.maximum(np.abs(wrapped(angle - fixed)) - doubt, 0.0)
        yield worst("arm angle", "elbow", off, ARM_ANGLE, "rad", t, words="is off its value by")
    if first_is_start and order.arm_angle is None:
        j = int(np.argmax(np.abs(q[0] - start)))
        off = np.abs(q[:1, j] - start[j])
        yield worst("start joints", rows.names[j], off, START, "rad", t, words="is off the task's start by")


def check_follows(tool: Poses, wanted: Poses) -> Iterator[Finding]:
    """The tool at the joints of every row against the pose of that row."""
    for check, off, unit, doubt in _apart("tool {}", tool, wanted.p, wanted.q):
        yield worst(check, "TCP", off, FOLLOW, unit, tool.t, doubt, words="is off its pose by")


def check_between(between: Poses, rows: Poses) -> Iterator[Finding]:
    """The tool half way between two rows' joints (n-1 poses) against half way between the rows' poses."""
    p = (rows.p[:-1] + rows.p[1:]) / 2
    half = turns.logarithm(turns.product(turns.conjugate(rows.q[:-1]), rows.q[1:])) / 2
    q = turns.product(rows.q[:-1], turns.exponential(half))
    for check, off, unit, _ in _apart("{} between rows", between, p, q):
        yield worst(check, "TCP", off, BETWEEN, unit, between.t, words="leaves the path between two rows by")


def _apart(check: str, tool: Poses, p: Array, q: Array) -> Iterator[tuple[str, Array, str, Array]]:
    """How far a tool is from positions p and rotations q, and what its digits leave in doubt."""
    yield check.format("position"), np.linalg.norm(tool.p - p, axis=1), "m", tool.off_p
    yield check.format("orientation"), turns.angle_between(tool.q, q), "rad", tool.off_q
