"""From a chain of six revolute joints to the arm it is: the lines of its axes at q = 0 give lengths, signs and offsets.

Any link frames will do. The canonical base keeps the base link's height on axis 1. What is free is chosen so that ABB's
chains come out as they are: up is where axis 2 lies on axis 1, forward where axis 2 stands off axis 1 (where it does
not, where the wrist centre is at q = 0), axis 4 points to the wrist centre, axis 6 out of it, axis 5 as the joint does.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.robot.arm import Arm
from trajopt_cli.robot.urdf import UrdfJoint

OFF = 1e-9  # rad or m that axes may be off the structure the closed form needs: ten printed digits
_NOISE = 1e-12  # rad, m or a matrix entry: nearer to 0, 1 or a right angle a number is one with rounding upon it
_SHORTEST = 1e-6  # m of lower and upper arm


@dataclass(frozen=True, eq=False)
class _Lines:
    """Unit axes u (6, 3), the steps (7, 3) [m] from each joint's origin to the next, the base link's first, and the
    flange's rotation (3, 3); all at q = 0, seen from the base link."""

    names: list[str]
    u: Array
    steps: Array
    R: Array

    @classmethod
    def of(cls, chain: list[UrdfJoint]) -> _Lines:
        # Steps, not positions: a difference of positions would round what the file says exactly.
        R, u, steps = np.eye(3), [], []
        for joint in chain:
            steps.append(R @ joint.X[:3, 3])
            R = _clean(R @ joint.X[:3, :3])
            if joint.kind != "fixed":
                u.append(_clean(_unit(R @ joint.axis)))
        return cls([joint.name for joint in chain], np.array(u), _clean(np.array(steps)), R)


def arm_from_chain(chain: list[UrdfJoint], file: str) -> Arm:
    """The arm of six revolute joints and the fixed flange joint, in that order, whatever their frames.

    Raises InputError where the axes are not those of an arm whose axes 2 and 3 are parallel and at right angles to axis
    1, and whose axes 4 and 5 meet.
    """
    lines = _Lines.of(chain)
    _check_directions(lines, file)
    u, steps = lines.u, lines.steps
    z = _facing(u[0], u[0] @ steps[0] + u[0] @ steps[1], u[0][2])
    t4 = u[3] @ steps[4]  # along axis 4 from its joint's origin to the wrist centre
    wrist = _clean(steps[3] + t4 * u[3])  # from the origin of joint 3
    _check_wrist(lines, t4, file)
    aside = np.cross(u[1], z)
    x = _facing(_clean(_unit(aside)), aside @ steps[1], aside @ (steps[1] + steps[2] + wrist), aside[0])
    y = np.cross(z, x)
    lower = _Planar(x @ steps[2], z @ steps[2])
    x4 = _facing(u[3], u[3] @ wrist)
    z4 = np.cross(x4, y)
    t23 = np.arctan2(-(z @ x4), x @ x4)
    y5 = u[4]
    z5 = np.cross(x4, y5)
    tail = steps[5] + steps[6]
    x6 = _facing(u[5], u[5] @ tail, u[5] @ lines.R[:, 2])
    R_BK = np.column_stack([np.cross(y5, x6), y5, x6])
    c4 = x6 @ tail
    onward = steps[4] - t4 * u[3] + steps[5]  # from the wrist centre to joint 6
    aside_6 = _small(onward - (onward @ x6) * x6)  # to axis 6
    beside = steps[4] - t4 * u[3] + tail - c4 * x6 - aside_6  # from the canonical flange to the flange
    X_BO, X_KF = np.eye(4), np.eye(4)
    X_BO[:3, :3] = np.column_stack([x, y, z])
    X_BO[:3, 3] = steps[0] - (steps[0] @ z) * z
    X_KF[:3, :3], X_KF[:3, 3] = R_BK.T @ lines.R, R_BK.T @ beside
    offsets = [0.0, lower.angle, t23 - lower.angle]
    offsets += [np.arctan2(z4 @ y5, y @ y5), np.arctan2(-(z5 @ x6), x4 @ x6), 0.0]
    signs = np.sign([z @ u[0], y @ u[1], y @ u[2], x4 @ u[3], 1.0, x6 @ u[5]])
    lengths = {
        "a1": x @ steps[1],
        "a2": -(z4 @ wrist),
        "b": y @ steps[1] + y @ steps[2] + y @ wrist,
        "c1": z @ steps[0] + z @ steps[1],
        "c2": lower.length,
        "c3": x4 @ wrist,
        "c4": c4,
    }
    arm = Arm(
        **{name: float(_clean(np.array(length))) for name, length in lengths.items()},
        signs=signs,
        offsets=_right_angles(np.array(offsets)),
        middles=np.zeros(6),
        X_BO=_clean(X_BO),
        X_KF=_clean(X_KF),
        wrist=_clean(np.array([0.0, y5 @ aside_6, np.cross(x6, y5) @ aside_6])),
    )
    for what, length in (("axes 2 and 3 are", arm.c2), ("the wrist centre and axis 3 are", arm.upper)):
        if length < _SHORTEST:
            raise InputError(f"{what} {length * 1e3:.6g} mm apart, at least {_SHORTEST * 1e3:g}: {_NEED}", file=file)
    return _with_middles(arm, chain)


_NEED = (
    "six axes are served whose axes 2 and 3 are parallel to each other and at right angles to axis 1, and whose axes 4"
    " and 5 meet"
)


def _check_directions(lines: _Lines, file: str) -> None:
    """Raise InputError for axes that are not parallel, or not at right angles, to each other where they must be."""

    def say(i: int, j: int, what: str, off: float) -> InputError:
        names = f"'{lines.names[i]}' and '{lines.names[j]}'"
        return InputError(
            f"axes {i + 1} and {j + 1} ({names}) are {np.degrees(off):.6g}° from {what}, at most"
            f" {np.degrees(OFF):.1g}°: {_NEED}; right angles in a URDF need twelve digits (1.57079632679)",
            file=file,
        )

    u = lines.u
    off = float(np.arcsin(min(float(np.linalg.norm(np.cross(u[1], u[2]))), 1.0)))
    if off > OFF:
        raise say(1, 2, "parallel", off)
    if float(np.linalg.norm(np.cross(u[2], u[3]))) <= OFF:
        names = ", ".join(f"'{name}'" for name in lines.names[1:4])
        raise InputError(f"axes 2, 3 and 4 ({names}) are parallel, as on Universal Robots' arms: {_NEED}", file=file)
    for i, j in ((0, 1), (2, 3), (3, 4), (4, 5)):
        off = float(np.arcsin(min(abs(float(u[i] @ u[j])), 1.0)))
        if off > OFF:
            raise say(i, j, "a right angle", off)


def _check_wrist(lines: _Lines, t4: float, file: str) -> None:
    """Raise InputError where axes 4 and 5 do not meet. t4: see arm_from_chain."""
    u, steps = lines.u, lines.steps
    gap = abs(steps[4] @ np.cross(u[3], u[4]))
    if gap > OFF:
        raise InputError(
            f"the wrist: axis 5 passes axis 4 by {gap * 1e3:.6g} mm, at most {OFF * 1e3:g}: {_NEED}", file=file
        )


def _small(v: Array) -> Array:
    """A vector (3,) [m], zero where it is shorter than OFF."""
    return v if float(np.linalg.norm(v)) > OFF else np.zeros(3)


@dataclass(frozen=True)
class _Planar:
    """The lower arm at q = 0: how far axis 3 is forward of axis 2 and above it [m]."""

    ahead: float
    up: float

    @property
    def length(self) -> float:
        return float(np.hypot(self.ahead, self.up))

    @property
    def angle(self) -> float:
        return float(np.arctan2(_clean(np.array(self.ahead)), _clean(np.array(self.up))))


def _facing(direction: Array, *votes: float) -> Array:
    """A direction (3,) or the one against it, whichever makes the first vote positive that is not zero."""
    decided = [vote for vote in votes if abs(vote) > OFF]
    return -direction if decided and decided[0] < 0 else direction


def _with_middles(arm: Arm, chain: list[UrdfJoint]) -> Arm:
    """The arm with what its inverse gives its joints around: the closed form's own middles where they are the joints'
    too and the ranges lie around them, else the middles of the ranges."""
    lower, upper = (np.array([getattr(joint, end) for joint in chain[:6]]) for end in ("lower", "upper"))
    own, natural = (lower + upper) / 2, arm.natural_middles
    plain = (arm.signs == 1) & (arm.offsets == 0)
    around = (lower >= natural - np.pi) & (upper <= natural + np.pi) | (np.abs(own - natural) < OFF)
    return replace(arm, middles=np.where(plain & around, natural, own))


def _unit(v: Array) -> Array:
    return np.asarray(v / np.linalg.norm(v))


def _clean(values: Array) -> Array:
    """Numbers without rounding next to 0 and +-1, so that what is exact in the file stays so."""
    near = np.round(values)
    return np.where((np.abs(values - near) < _NOISE) & (np.abs(near) <= 1), near, values) + 0.0


def _right_angles(angles: Array) -> Array:
    """Angles in (-pi, pi], put on the right angle they are next to by rounding."""
    angles = angles - 2 * np.pi * np.ceil((angles - np.pi - _NOISE) / (2 * np.pi))
    quarters = np.round(angles / (np.pi / 2))
    return np.where(np.abs(angles - quarters * (np.pi / 2)) < _NOISE, quarters * (np.pi / 2), angles) + 0.0
