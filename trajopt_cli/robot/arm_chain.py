"""From a chain of six revolute joints to the arm it is: the lines of its axes at q = 0 give lengths, signs and offsets.

Any link frames will do. The canonical base keeps the base link's height on axis 1. What is free is chosen so that ABB's
chains come out as they are: up is where axis 2 lies on axis 1, forward where axis 2 stands off axis 1 (where it does
not, where the wrist centre is at q = 0), axis 4 points to the wrist centre, axis 6 out of it, axis 5 as the joint does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.robot.arm import Arm
from trajopt_cli.robot.parallel_arm import ParallelArm
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
    def of(cls, chain: Sequence[UrdfJoint]) -> _Lines:
        # Steps, not positions: a difference of positions would round what the file says exactly.
        R, u, steps = np.eye(3), [], []
        for joint in chain:
            steps.append(R @ joint.X[:3, 3])
            R = _clean(R @ joint.X[:3, :3])
            if joint.kind != "fixed":
                u.append(_clean(_unit(R @ joint.axis)))
        return cls([joint.name for joint in chain], np.array(u), _clean(np.array(steps)), R)


def arm_from_chain(chain: Sequence[UrdfJoint], file: str, coupled: bool = False) -> Arm:
    """The arm of six revolute joints and the fixed flange joint, in that order, whatever their frames. coupled: see
    Arm; the range of joint 3 in the chain is then that of the coupled one.

    Raises InputError where the axes are not those of an arm whose axes 2 and 3 are parallel and at right angles to axis
    1, and whose axes 4 and 5 meet; of one whose axis 4 is parallel to them too axes 5 and 6.
    """
    return _arm(tuple(chain), file, coupled)


@lru_cache(32)  # by the joints themselves: a URDF that has not changed gives the same ones again
def _arm(chain: tuple[UrdfJoint, ...], file: str, coupled: bool) -> Arm:
    lines = _Lines.of(chain)
    parallel = _check_directions(lines, file)
    arm = _parallel(lines, file) if parallel else _with_a_wrist(lines, file)
    beyond = "axes 4 and 3 are" if parallel else "the wrist centre and axis 3 are"
    for what, length in (("axes 2 and 3 are", arm.c2), (beyond, arm.upper)):
        if length < _SHORTEST:
            raise InputError(f"{what} {length * 1e3:.6g} mm apart, at least {_SHORTEST * 1e3:g}: {_NEED}", file=file)
    return _with_middles(replace(arm, coupled=coupled), chain)


def _with_a_wrist(lines: _Lines, file: str) -> Arm:
    """The arm whose axis 4 runs along the forearm. Raises InputError where axes 4 and 5 do not meet."""
    u, steps = lines.u, lines.steps
    z = _facing(u[0], u[0] @ steps[0] + u[0] @ steps[1], u[0][2])
    t4 = u[3] @ steps[4]  # along axis 4 from its joint's origin to the wrist centre
    wrist = _clean(steps[3] + t4 * u[3])  # from the origin of joint 3
    _check_wrist(lines, file)
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
    X_BC, X_KF = np.eye(4), np.eye(4)
    X_BC[:3, :3] = np.column_stack([x, y, z])
    X_BC[:3, 3] = steps[0] - (steps[0] @ z) * z
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
    return Arm(
        **{name: float(_clean(np.array(length))) for name, length in lengths.items()},
        signs=signs,
        offsets=_right_angles(np.array(offsets)),
        middles=np.zeros(6),
        coupled=False,
        X_BC=_clean(X_BC),
        X_KF=_clean(X_KF),
        wrist=_clean(np.array([0.0, y5 @ aside_6, np.cross(x6, y5) @ aside_6])),
    )


def _parallel(lines: _Lines, file: str) -> ParallelArm:
    """The arm whose axis 4 is parallel to axes 2 and 3. Raises InputError where axes 5 and 6 do not meet."""
    u, steps = lines.u, lines.steps
    gap = abs(steps[5] @ np.cross(u[4], u[5]))
    if gap > OFF:
        message = f"the wrist: axis 6 passes axis 5 by {gap * 1e3:.6g} mm, at most {OFF * 1e3:g}: {_NEED}"
        raise InputError(message, file=file)
    z = _facing(u[0], u[0] @ steps[0] + u[0] @ steps[1], u[0][2])
    t5 = u[4] @ steps[5]  # along axis 5 from its joint's origin to the wrist centre
    wrist = _clean(steps[4] + t5 * u[4])  # from the origin of joint 4
    aside = np.cross(u[1], z)
    x = _facing(_clean(_unit(aside)), aside @ steps[1], aside @ (steps[1] + steps[2] + steps[3] + wrist), aside[0])
    y = np.cross(z, x)
    lower = _Planar(x @ steps[2], z @ steps[2])
    t23 = np.arctan2(-(z @ steps[3]), x @ steps[3])
    z5 = u[4]
    t234, x5 = np.arctan2(x @ z5, z @ z5), np.cross(y, z5)
    tail = steps[5] - t5 * u[4] + steps[6]  # from the wrist centre to the flange
    y6 = _facing(u[5], u[5] @ tail, u[5] @ lines.R[:, 2])
    t_5 = np.arctan2(-(x5 @ y6), y @ y6)
    R_BK = np.column_stack([np.cross(y6, z5), -z5, y6])
    c4 = y6 @ tail
    X_BC, X_KF = np.eye(4), np.eye(4)
    X_BC[:3, :3] = np.column_stack([x, y, z])
    X_BC[:3, 3] = steps[0] - (steps[0] @ z) * z
    X_KF[:3, :3], X_KF[:3, 3] = R_BK.T @ lines.R, R_BK.T @ (tail - c4 * y6)
    lengths = {
        "a1": x @ steps[1],
        "a2": 0.0,
        "b": y @ (steps[1] + steps[2] + steps[3] + wrist),
        "c1": z @ steps[0] + z @ steps[1],
        "c2": lower.length,
        "c3": float(np.hypot(x @ steps[3], z @ steps[3])),
        "c4": c4,
    }
    return ParallelArm(
        **{name: float(_clean(np.array(length))) for name, length in lengths.items()},
        signs=np.sign([z @ u[0], y @ u[1], y @ u[2], y @ u[3], 1.0, y6 @ u[5]]),
        offsets=_right_angles(np.array([0.0, lower.angle, t23 - lower.angle, t234 - t23, t_5, 0.0])),
        middles=np.zeros(6),
        coupled=False,
        X_BC=_clean(X_BC),
        X_KF=_clean(X_KF),
        wrist=_clean(np.array([x5 @ wrist, 0.0, z5 @ wrist])),
    )


_NEED = (
    "six axes are served whose axes 2 and 3 are parallel to each other and at right angles to axis 1, and whose axes 4"
    " and 5 meet, or, where axis 4 is parallel to them too, axes 5 and 6"
)


def _check_directions(lines: _Lines, file: str) -> bool:
    """Whether axis 4 is parallel to axes 2 and 3. Raises InputError for axes that are not parallel, or not at right
    angles, to each other where they must be."""

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
    turned = float(np.arcsin(min(float(np.linalg.norm(np.cross(u[2], u[3]))), 1.0)))
    parallel = turned < np.pi / 4  # meant to be, and then held to it
    if parallel and turned > OFF:
        raise say(2, 3, "parallel", turned)
    for i, j in ((0, 1), *(() if parallel else ((2, 3),)), (3, 4), (4, 5)):
        off = float(np.arcsin(min(abs(float(u[i] @ u[j])), 1.0)))
        if off > OFF:
            raise say(i, j, "a right angle", off)
    return parallel


def _check_wrist(lines: _Lines, file: str) -> None:
    """Raise InputError where axes 4 and 5 do not meet."""
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


def _with_middles(arm: Arm, chain: Sequence[UrdfJoint]) -> Arm:
    """The arm with what its inverse gives its joints around: the closed form's own middles where they are the joints'
    too and the ranges lie around them, else the middles of the ranges."""
    lower, upper = (np.array([getattr(joint, end) for joint in chain[:6]]) for end in ("lower", "upper"))
    own, natural = (lower + upper) / 2, arm.natural_middles
    plain = (arm.signs == 1) & (arm.offsets == 0) & ([True] * 2 + [not arm.coupled] + [True] * 3)
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
