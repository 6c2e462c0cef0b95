"""Joints of a sequence: without jumps by whole turns, how fast they turn, every row against its limits; and what they
leave a path: their speeds and accelerations as limits of how fast it is run."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees, pi, radians

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array, inverse_pose, pose
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.iiwa.task.model import AngleMeaning, Task
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot import srs_inverse
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_inverse import ArmAngle, singularities, why_unreachable
from trajopt_cli.timing.varying_caps import Rows

_KEPT = 1 - 1e-5  # of the joints' limits: rows are printed, and the arm's own check has no more than rounding to give
RELATIVE = 1e-9
"""Share of a limit by which a motion exactly on it may exceed it."""
ROUNDING = 1e-13
"""rad: what rounding in the closed-form inverse leaves in a joint's value; over h and h^2 it is no motion."""


def continuous(q: Array, near: Array) -> Array:
    """Joints (n, 7) without jumps by whole turns, the first row's turns chosen closest to near (7,)."""
    q = np.unwrap(q, axis=0)
    return np.asarray(q + 2 * np.pi * np.round((near - q[0]) / (2 * np.pi)))


@dataclass(frozen=True, eq=False)
class Arm:
    """The arm that follows: robot, mounted in the world, its TCP at X_FT (4, 4) in the flange frame, in the
    configuration of the joints start (7,) [rad], where the controller is switched on. given: the arm angle that it
    keeps [rad], by definition; None for that of start.
    """

    robot: SrsRobot
    X_FT: Array
    start: Array
    limits: JointLimits
    definition: ArmAngle = ArmAngle.FARIA
    given: float | None = None

    @classmethod
    def of(cls, task: Task, robot: SrsRobot) -> Arm:
        """A task's, whose robot is mounted."""
        frames = task.X_FT, task.start_joints, robot.profile(task.limits)
        return cls(robot, *frames, task.definition, task.arm_angle)

    @cached_property
    def configuration(self) -> int:
        """0..7, that of start."""
        return int(srs_inverse.configuration(self.start))

    @cached_property
    def begin(self) -> float:
        """The arm angle of start [rad]."""
        return float(srs_inverse.arm_angle(self.robot, self.start, self.definition))

    @property
    def angle(self) -> float:
        """The arm angle that is kept [rad]."""
        return self.begin if self.given is None else self.given

    @property
    def how(self) -> tuple[float, ArmAngle, int]:
        """Arm angle that is kept, its definition and the configuration, as an inverse takes them."""
        return self.angle, self.definition, self.configuration

    @cached_property
    def X_start(self) -> Array:
        """The tool in the world (4, 4) at start."""
        return self.robot.forward(self.start) @ self.X_FT

    def flange(self, R: Array, p: Array) -> Array:
        """Flange poses (n, 4, 4) of a tool with orientations R (n, 3, 3) at p (n, 3) in the world."""
        return pose(R, p) @ inverse_pose(self.X_FT)

    def joints(self, X_WF: Array, angle: Array | float | None = None, near: Array | None = None) -> Array:
        """Joints (n, 7) of flange poses X_WF (n, 4, 4), continuous, from near (7,) on, None for start.

        angle: one for all or (n,) [rad], None for the one that is kept. Rows out of reach are NaN, and then nothing is
        made continuous.
        """
        how = self.angle if angle is None else angle, *self.how[1:]
        q = srs_inverse.inverse_branch(self.robot, X_WF, *how)
        return q if np.isnan(q).any() else continuous(q, self.start if near is None else near)


def speeds(q: Array, h: float) -> Array:
    """Speeds (n - 1, k) [1/s] from each row of q (n, k) to the next, h [s] apart."""
    return np.asarray(np.abs(np.diff(q, axis=0)) / h)


def accelerations(q: Array, h: float, stops: bool = True) -> Array:
    """Accelerations (n, k) [1/s2] at the rows of q (n, k): second differences; from rest and to rest at the ends.

    Who stands at the first row and is at the second h later needs 2 |step| / h^2 at least, and so at the end. stops:
    whether the last row is an end at all; else the motion goes on and nothing is known of that row, which counts as 0.
    """
    step = np.diff(q, axis=0)
    inside = np.diff(step, axis=0)
    end = 2 * step[-1:] if stops else np.zeros_like(step[-1:])
    return np.asarray(np.abs(np.concatenate([2 * step[:1], inside, end])) / (h * h))


def central_speeds(q: Array, h: float) -> Array:
    """Signed speeds (n, k) [1/s] of q (n, k): central differences, 0 in the first and last row, where the arm rests."""
    qd = np.zeros_like(q)
    qd[1:-1] = (q[2:] - q[:-2]) / (2 * h)
    return qd


def position_excess(q: Array, limits: JointLimits) -> Array:
    """How far q (..., k) lies outside the limits, negative inside."""
    return np.asarray(np.maximum(q - limits.upper, limits.lower - q))


def passes(q: Array, h: float, limits: JointLimits) -> bool:
    """Whether rows q (n, k), h [s] apart, keep every position and speed limit: what the controller's loop stops at."""
    in_range = position_excess(q, limits) <= RELATIVE * (limits.upper - limits.lower)
    slow = speeds(q, h) <= limits.velocity * (1 + RELATIVE) + 2 * ROUNDING / h
    return bool(in_range.all() and slow.all())


ELBOW = 3
"""Index of joint_4: it follows from the pose alone, whatever the arm angle."""
SINGULAR_WITHIN = radians(1.0)
"""rad from a singularity (m where the wrist centre nears axis 1) within which it is worth a note."""
CLOSE_POSITION = radians(2.0)
"""rad from a position limit within which a joint that keeps it is worth a note."""
CLOSE_SPEED = 0.95
"""Share of a speed limit above which a joint that keeps it is worth a note."""

POSITION, SPEED, ACCELERATION = "position", "speed", "acceleration"
_UNITS = {POSITION: "°", SPEED: "°/s", ACCELERATION: "°/s²"}

Place = Callable[[int], str]
"""Where a row stands on the way, for people."""


def place_of(equilibrium: Equilibrium, row: int) -> str:
    """Where a row stands on the way: `b -> c, 45 % of the way`, or `standing at b`."""
    piece = next(piece for piece in equilibrium.pieces if piece.first <= row <= piece.last)
    if piece.dwell:
        return f"standing at {piece.origin}"
    pose = equilibrium.pose
    whole = pose[piece.last] - pose[piece.first]
    axis = int(np.argmax(np.abs(whole)))
    share = 0.0 if whole[axis] == 0 else float((pose[row] - pose[piece.first])[axis] / whole[axis])
    return f"{piece.origin} -> {piece.goal}, {100 * max(0.0, share):.0f} % of the way"


def check_joints(
    q: Array, h: float, limits: JointLimits, place: Place, free: bool, stops: bool = True
) -> tuple[Finding, ...]:
    """The worst case of position, then speed, then acceleration of every joint of q (n, k), rows h [s] apart.

    Value and limit in rad, rad/s, rad/s2, messages in degrees with what to do next. A speed's time is that of the row
    its step begins at; the motion begins at rest and, if stops, ends so. free: whether the arm angle was allowed to
    move.
    """
    excess, joints = position_excess(q, limits), range(len(limits.names))
    kinds = [
        (SPEED, speeds(q, h), limits.velocity, 2 * ROUNDING / h),
        (ACCELERATION, accelerations(q, h, stops), limits.acceleration, 4 * ROUNDING / (h * h)),
    ]

    def found(check: str, j: int, row: int, value: float, limit: float, passed: bool, remedy: str) -> Finding:
        unit = {POSITION: "rad", SPEED: "rad/s", ACCELERATION: "rad/s2"}[check]
        one = Finding(check, limits.names[j], value, limit, unit, passed, row * h, None)
        return one if passed else replace(one, message=f"{broken_limit(one, place(row))}; {remedy}")

    out = []
    for j in joints:
        low, high, row = float(limits.lower[j]), float(limits.upper[j]), int(np.argmax(excess[:, j]))
        value, remedy = float(q[row, j]), _remedy(POSITION, j, free)
        turned = value - 2 * pi * np.sign(value)
        if low <= turned <= high:
            remedy = f"{degrees(turned):.6g}° would be inside, but is a whole turn away; {remedy}"
        passed = bool(excess[row, j] <= RELATIVE * (high - low))
        out.append(found(POSITION, j, row, value, high if value - high >= low - value else low, passed, remedy))
    for check, values, tops, noise in kinds:
        for j in joints:
            row, top = int(np.argmax(values[:, j])), float(tops[j])
            value = float(values[row, j])
            out.append(found(check, j, row, value, top, value <= top * (1 + RELATIVE) + noise, _remedy(check, j, free)))
    return tuple(out)


def _remedy(check: str, j: int, free: bool) -> str:
    slower = "lower v_max or omega_max there"
    if check == ACCELERATION:
        return "profile trapezoid or s-curve ramps what profile thesis steps; if it does already, lower a_max"
    if j == ELBOW:
        other = "move the path away from the base or towards it" if check == POSITION else slower
        return f"the pose alone decides this joint, no arm angle helps: {other}"
    if free:
        return "begin with other joints, or move the path" if check == POSITION else slower
    other = "begin with other joints" if check == POSITION else slower
    return f"let the arm angle move (--arm-angle free) or {other}"


def broken_limit(finding: Finding, place: str) -> str:
    """What a joint exceeds, by how much, when and where, without what to do about it."""
    unit = _UNITS[finding.check]
    printed, limit = apart(degrees(finding.value), degrees(finding.limit))
    at = f"t = {finding.time:.3f} s ({place})"
    return f"{finding.subject} {finding.check} {printed}{unit} at {at}, limit {limit}{unit}"


def apart(value: float, limit: float) -> tuple[str, str]:
    """Both numbers with so many digits that they differ in print when they differ."""
    for n in range(6, 17):
        texts = f"{value:.{n}g}", f"{limit:.{n}g}"
        if texts[0] != texts[1]:
            return texts
    return texts


def stops_loop(findings: tuple[Finding, ...]) -> tuple[Finding, ...]:
    """The findings that the controller's loop stops at: a position or a speed past its limit."""
    return tuple(finding for finding in findings if not finding.passed and finding.check != ACCELERATION)


def remarks(robot: SrsRobot, q: Array, h: float, limits: JointLimits, place: Place) -> Iterator[str]:
    """Singularities passed, each with time and distance, and joints that keep a limit, but only just."""
    for one in singularities(robot, q, SINGULAR_WITHIN):
        near = f"{degrees(one.value):.3g}°" if one.unit == "rad" else f"{1e3 * one.value:.3g} mm"
        yield (
            f"singularity, {one.name}: within {near} at t = {one.index * h:.3f} s ({place(one.index)});"
            " joints turn fast near it, and the fixed configuration cannot pass to its other side"
        )
    excess, speed = position_excess(q, limits), speeds(q, h)
    for j, name in enumerate(limits.names):
        row = int(np.argmax(excess[:, j]))
        if -CLOSE_POSITION < excess[row, j] <= RELATIVE * (limits.upper[j] - limits.lower[j]):
            limit = limits.upper[j] if q[row, j] > 0 else limits.lower[j]
            yield (
                f"{name} comes within {degrees(max(-excess[row, j], 0.0)):.3g}° of its limit {degrees(limit):.6g}°"
                f" at t = {row * h:.3f} s ({place(row)})"
            )
        row = int(np.argmax(speed[:, j]))
        used = float(speed[row, j] / limits.velocity[j])
        if CLOSE_SPEED < used <= 1 + RELATIVE:
            yield f"{name} uses {100 * used:.1f} % of its speed limit at t = {row * h:.3f} s ({place(row)})"


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
