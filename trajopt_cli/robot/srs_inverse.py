"""All joint solutions of a flange pose at an arm angle in closed form: eight configurations of a seven-axis arm.

A configuration is (q2 < 0) + 2 (q4 < 0) + 4 (q6 < 0), as in Faria et al. 2018 (zero counts as positive). What fixes the
elbow on its circle about the line from shoulder S to wrist centre W is the arm angle; ArmAngle says how it is counted.

With n = SW / |SW|, b the unit vector across n towards the elbow and t = n x b, all axes of the arm are sums of these
three: axis 3 is cos(a) n + sin(a) b with a the triangle's angle at the shoulder, axis 5 is cos(w) n - sin(w) b with w
its angle at the wrist, and axis 4 is -t, or t in the branches with q4 < 0. Flipping the sign of q2, q4 or q6 turns the
joint before it and the joint after it by half a turn; so one solution gives all eight.

At singularities the answer is finite and its pose right; where two joints turn about one line, the first is set to 0:
q2 = 0 gives q1 = 0 and q6 = 0 gives q5 = 0 (in the partner configuration, where q2 or q6 would be negative, pi), and
the joint after takes the whole turn. At q4 = 0 the elbow lies on the line SW and b is where it would bend to, so q3 and
q5 stay defined. With W on axis 1 its azimuth is taken as 0, as in Faria et al.; with W in S (a fully folded arm of
equal links) n is the base's z.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from math import degrees, pi

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.srs import JOINTS, SrsLengths, SrsRobot
from trajopt_cli.robot.turns import broken_limits, close_at_pi, half_turn

CONFIGURATIONS = 8
_CHUNK = 1024  # poses at once: few enough for work arrays of 8 kB, enough to hide what a NumPy call costs
NEAR = 1e-12  # m of W from axis 1 or from S, sin q2 or sin q6: below, an angle is a convention
STRETCH = 1e-12  # m that |SW| may exceed the stretched arm by, or miss the folded one by: rounding

_Vector = tuple[Array, Array, Array]


class ArmAngle(Enum):
    """How the arm angle is counted: a right-hand angle about S -> W, in (-pi, pi].

    Both count from a half plane through S and W that is upright: it holds the base's z direction.
    """

    FARIA = "faria"
    """From the elbow of the arm with q3 = 0 and the same sign of q4 that reaches the same W (Faria et al. 2018).

    For q4 >= 0 that elbow lies below the line SW, for q4 < 0 above it: at one angle the configurations with q4 >= 0 and
    those with q4 < 0 hold the elbow on opposite sides."""
    SWIVEL = "swivel"
    """From the base's +z, as seen along SW; the same for every configuration, which then all share one elbow.

    swivel = faria + pi for q4 >= 0, swivel = faria for q4 < 0."""


@dataclass(frozen=True)
class Singularity:
    """A sample (index) near a singularity: its name, how near it is (value), in unit "rad" or "m"."""

    index: int
    name: str
    value: float
    unit: str


def inverse(robot: SrsRobot, X_WF: Array, arm_angle: Array | float, definition: ArmAngle) -> Array:
    """Joints (n, 8, 7) [rad] of flange poses X_WF (n, 4, 4) at arm angles (n,) or one for all [rad].

    The second index is the configuration. NaN where the wrist centre is out of reach; joint limits are not applied.
    q1, q3, q5, q7 lie in (-pi, pi], q2, q4, q6 in [-pi, pi].
    """
    X_WF, psi = _checked(X_WF, arm_angle)
    out = np.empty((CONFIGURATIONS, JOINTS, len(X_WF)))
    sides = np.array([elbow_side(definition, 0), elbow_side(definition, 2)] if definition is ArmAngle.FARIA else [1.0])
    for part in _chunks(len(X_WF)):
        q = _all_positive(robot, X_WF[part], psi[part], sides[:, None])
        _spread(q, out[..., part].reshape(2, 2, 2, JOINTS, -1))  # a view: the first axis is only split
    return out.transpose(2, 0, 1)


def inverse_branch(
    robot: SrsRobot, X_WF: Array, arm_angle: Array | float, definition: ArmAngle, configuration: int
) -> Array:
    """Joints (n, 7) of one configuration, 0..7: that column of inverse, for long sequences.

    Several arm angles (k, n) at each pose give joints (k, n, 7); what does not depend on them is worked out once.
    """
    X_WF, psi = _checked(X_WF, arm_angle, 2)
    before, negative = flips(configuration)
    out = np.empty((JOINTS, *psi.shape))
    side = np.array([[elbow_side(definition, configuration)]])
    for part in _chunks(len(X_WF)):
        q = _all_positive(robot, X_WF[part], psi[..., part].reshape(-1, part.stop - part.start), side)
        q = q.reshape(JOINTS, *psi.shape[:-1], -1)
        for i in range(0, JOINTS, 2):
            out[i, ..., part] = half_turn(q[i]) if before[i // 2] else q[i]
        for i in range(1, JOINTS, 2):
            out[i, ..., part] = -q[i] if negative[i // 2] else q[i]
    return np.moveaxis(out, 0, -1)


def configuration(q: Array) -> IndexArray:
    """The configurations (...) of joints q (..., 7): (q2 < 0) + 2 (q4 < 0) + 4 (q6 < 0)."""
    q = np.asarray(q, dtype=np.float64)
    bits: IndexArray = (q[..., 1::2] < 0).astype(np.intp) @ np.array([1, 2, 4])
    return bits


def arm_angle(robot: SrsRobot, q: Array, definition: ArmAngle) -> Array:
    """Arm angles (...) in (-pi, pi] of joints q (..., 7); at singularities as inverse takes them."""
    q = np.asarray(q, dtype=np.float64)
    _, a, o = robot.axes_and_points(q)
    _, _, b_0, t_0 = _line(o[:, 6] - o[:, 0])
    t = np.where(q[..., 3] < 0, 1.0, -1.0) * a[:, 3]
    out = np.arctan2(-sum(t[i] * b_0[i] for i in range(3)), sum(t[i] * t_0[i] for i in range(3)))
    if definition is ArmAngle.FARIA:
        out = np.where(q[..., 3] < 0, out, out - np.copysign(pi, out))
    return np.where(out <= -pi, pi, out)


def singularities(robot: SrsRobot, q: Array, margin: float) -> list[Singularity]:
    """Where joints q (n, 7) come within margin [rad, or m for the wrist centre] of a singularity at fixed arm angle.

    One entry per singularity and stretch of samples in a row within the margin, at its nearest sample; by index.
    """
    q = np.asarray(q, dtype=np.float64)
    _, _, o = robot.axes_and_points(q)
    measures = (
        ("joint_2 = 0: joint_1 and joint_3 turn about one line", np.abs(q[:, 1]), "rad"),
        ("elbow stretched: joint_4 = 0", np.abs(q[:, 3]), "rad"),
        ("joint_6 = 0: joint_5 and joint_7 turn about one line", np.abs(q[:, 5]), "rad"),
        ("wrist centre on axis 1: the arm angle has no reference", np.hypot(o[0, 6], o[1, 6]), "m"),
    )
    found = []
    for name, values, unit in measures:
        inside = np.concatenate([[False], values <= margin, [False]])
        edges = np.flatnonzero(inside[1:] != inside[:-1])
        for first, end in edges.reshape(-1, 2).tolist():
            nearest = first + int(np.argmin(values[first:end]))
            found.append(Singularity(nearest, name, float(values[nearest]), unit))
    return sorted(found, key=lambda one: one.index)


def why_unreachable(robot: SrsRobot, X_WF: Array, arm_angle: float, definition: ArmAngle, limits: JointLimits) -> str:
    """The reason, in one clause, why no configuration reaches a flange pose X_WF (4, 4) at an arm angle within limits.

    The wrist centre too far from or too near to the shoulder, or the joint limits every configuration breaks. Raises
    ValueError for a pose that one reaches.
    """
    L, X_BF = robot.lengths, np.linalg.inv(robot.X_WB) @ np.asarray(X_WF, dtype=np.float64)
    distance = float(np.linalg.norm(X_BF[:3, 3] - L.wf * X_BF[:3, 2] - [0, 0, L.bs]))
    bend = float(np.max(np.abs([limits.lower[3], limits.upper[3]])))
    if distance > L.se + L.ew + STRETCH:
        return f"wrist centre out of reach: {distance:.6g} m from the shoulder, at most {L.se + L.ew:.6g} m"
    least = float(np.sqrt(L.se**2 + L.ew**2 + 2 * L.se * L.ew * np.cos(min(bend, pi))))
    if distance < least - STRETCH:
        at = f"with {robot.axis_names[3]} at {degrees(min(bend, pi)):.6g}°"
        return f"wrist centre too near: {distance:.6g} m from the shoulder, at least {least:.6g} m {at}"
    q = inverse(robot, np.asarray(X_WF)[None], arm_angle, definition)[0]
    branches = {f"configuration {i}": joints for i, joints in enumerate(q)}
    said = broken_limits(branches, robot.axis_names, limits.lower, limits.upper)
    if said is None:
        raise ValueError("why_unreachable: a configuration reaches the pose within the limits")
    return f"at arm angle {degrees(arm_angle):.6g}° {said}"


def _checked(X_WF: Array, arm_angle: Array | float, most: int = 1) -> tuple[Array, Array]:
    """Poses and their arm angles, an array of so many dimensions at most."""
    X_WF, psi = np.asarray(X_WF, dtype=np.float64), np.asarray(arm_angle, dtype=np.float64)
    if X_WF.ndim != 3 or X_WF.shape[1:] != (4, 4):
        raise ValueError(f"X_WF has shape {X_WF.shape}, wanted (n, 4, 4)")
    if psi.ndim > most or psi.shape[-1:] not in ((), (len(X_WF),)):
        raise ValueError(f"arm_angle has shape {psi.shape}, wanted one number or ({len(X_WF)},)")
    return X_WF, psi if psi.ndim else np.broadcast_to(psi, (len(X_WF),))


def _chunks(n: int) -> Iterator[slice]:
    for start in range(0, n, _CHUNK):
        yield slice(start, min(start + _CHUNK, n))


def elbow_side(definition: ArmAngle, configuration: int) -> float:
    """-1 where the elbow lies opposite the swivel angle: an angle of FARIA with q4 >= 0."""
    return -1.0 if definition is ArmAngle.FARIA and not configuration & 2 else 1.0


def flips(configuration: int) -> tuple[tuple[bool, ...], tuple[bool, ...]]:
    """Against the configuration 0 with the same elbow: is q1, q3, q5, q7 half a turn on; is q2, q4, q6 negative."""
    if not 0 <= configuration < CONFIGURATIONS:
        raise ValueError(f"configuration {configuration}, wanted 0..{CONFIGURATIONS - 1}")
    b2, b4, b6 = (bool(configuration & bit) for bit in (1, 2, 4))
    return (b2, b2 != b4, b4 != b6, b6), (b2, b4, b6)


def _spread(q: Array, out: Array) -> None:
    """Put all configurations of _all_positive's q (7, m, n) into out (q6 < 0, q4 < 0, q2 < 0, 7, n)."""
    turned = half_turn(q[0::2])
    same, other = q[:, 0], q[:, -1]  # with q4 >= 0, with q4 < 0
    out[:, :, 0, 0], out[:, :, 1, 0] = q[0], turned[0]
    out[:, :, 0, 1], out[:, :, 1, 1] = q[1], -q[1]
    out[:, 0, 0, 2], out[:, 0, 1, 2] = same[2], turned[1, 0]
    out[:, 1, 0, 2], out[:, 1, 1, 2] = turned[1, -1], other[2]
    out[:, 0, :, 3], out[:, 1, :, 3] = same[3], -other[3]
    out[0, 0, :, 4], out[1, 0, :, 4] = same[4], turned[2, 0]
    out[0, 1, :, 4], out[1, 1, :, 4] = turned[2, -1], other[4]
    out[0, :, :, 5], out[1, :, :, 5] = q[5][:, None], -q[5][:, None]
    out[0, :, :, 6], out[1, :, :, 6] = q[6][:, None], turned[3][:, None]


def _line(u: Array) -> tuple[Array, _Vector, _Vector, _Vector]:
    """Of u = SW (3, ...) [m]: its length, its direction n, b_0 across it and up, and t_0 = n x b_0."""
    ahead = np.sqrt(u[0] * u[0] + u[1] * u[1])
    d = np.sqrt(ahead * ahead + u[2] * u[2])
    with np.errstate(invalid="ignore", divide="ignore"):
        c, s = u[0] / ahead, u[1] / ahead  # azimuth
        rise, out = u[2] / d, ahead / d
    on_axis = ahead < NEAR
    if on_axis.any():
        c, s = np.where(on_axis, 1.0, c), np.where(on_axis, 0.0, s)
        in_shoulder = d < NEAR
        rise, out = np.where(in_shoulder, 1.0, rise), np.where(in_shoulder, 0.0, out)
    return d, (out * c, out * s, rise), (-rise * c, -rise * s, out), (s, -c, 0.0 * c)


def _triangle(lengths: SrsLengths, d: Array) -> tuple[Array, Array, Array, Array, Array]:
    """Of |SW| = d: q4 >= 0, cosine and sine of the angle at the shoulder, of the angle at the wrist; NaN if none."""
    se, ew = lengths.se, lengths.ew
    far, near = se + ew, abs(se - ew)
    d = np.where((d > far + STRETCH) | (d < near - STRETCH), np.nan, np.maximum(d, 1e-150))
    # Roots of 1 - cos q4 and 1 + cos q4, from products: differences of squares would lose the stretched arm.
    less = np.sqrt(np.maximum((far - d) * (far + d), 0.0) / (2 * se * ew))
    more = np.sqrt(np.maximum((d - near) * (d + near), 0.0) / (2 * se * ew))
    q4 = 2.0 * np.arctan2(less, more)
    sine = less * more / d
    skew = (se - ew) * (se + ew) / d
    return q4, (d + skew) / (2 * se), ew * sine, (d - skew) / (2 * ew), se * sine


def _all_positive(robot: SrsRobot, X_WF: Array, psi: Array, sides: Array) -> Array:
    """Joints (7, m, n) with q2, q4, q6 >= 0 at swivel angles psi (n,), the elbow on m sides (m, 1) of the line: +-1;
    or at m swivel angles (m, n) each, the elbow on one side (1, 1).

    Poses come last, so that every step runs over contiguous blocks. Shoulder and wrist are functions of their own so
    that their work arrays die early: memory that the heap gives back and fetches again costs as much as the arithmetic.
    """
    lengths, R_BW = robot.lengths, robot.X_WB[:3, :3].T
    R = (R_BW @ X_WF[:, :3, :3].transpose(1, 2, 0).reshape(3, -1)).reshape(3, 3, -1)
    u = R_BW @ (X_WF[:, :3, 3].T - robot.X_WB[:3, 3, None]) - lengths.wf * R[:, 2]
    u[2] -= lengths.bs
    q = np.empty((JOINTS, *np.broadcast_shapes(sides.shape, psi.shape)))
    d, n, b, t = _line(u)
    c, s = np.cos(psi), np.sin(psi)
    b, t = _sum(c, b, s, t), _sum(c, t, -s, b)
    q[3], c_s, s_s, c_w, s_w = _triangle(lengths, d)
    with np.errstate(invalid="ignore", divide="ignore"):
        _shoulder(n, b, t, c_s, s_s, sides, q)
        _wrist(R, n, b, t, c_w, s_w, sides, q)
    close_at_pi(q[0::2])
    return q


def _sum(c: Array, a: _Vector, s: Array, b: _Vector) -> _Vector:
    return c * a[0] + s * b[0], c * a[1] + s * b[1], c * a[2] + s * b[2]


def _shoulder(n: _Vector, b: _Vector, t: _Vector, cosine: Array, sine: Array, sides: Array, q: Array) -> None:
    """Put q1, q2, q3 into q. Frame 3 in the base is x = side cos b - sin n, y = side t, z = cos n + side sin b."""
    bent, flat = sides * sine, sides * cosine
    c, s = _ball(*_sum(cosine, n, bent, b), q[0], q[1])
    x_0, x_1 = flat * b[0] - sine * n[0], flat * b[1] - sine * n[1]
    np.arctan2(c * x_1 - s * x_0, sides * (c * t[1] - s * t[0]), out=q[2])


def _wrist(R: Array, n: _Vector, b: _Vector, t: _Vector, cosine: Array, sine: Array, sides: Array, q: Array) -> None:
    """Put q5, q6, q7 into q. Frame 4 in the base is x = side cos b + sin n, y = side t, z = cos n - side sin b."""
    R = R[:, :, None]
    along, across, aside = (v[0] * R[0] + v[1] * R[1] + v[2] * R[2] for v in (n, b, t))  # the flange's axes in n, b, t
    bent, flat = sides * sine, sides * cosine
    x, y, z = flat * across[2] + sine * along[2], sides * aside[2], cosine * along[2] - bent * across[2]
    c, s = _ball(x, y, z, q[4], q[5])
    c *= sides
    y, x = (c * aside[i] - s * (flat * across[i] + sine * along[i]) for i in range(2))
    np.arctan2(y, x, out=q[6])


def _ball(x: Array, y: Array, z: Array, turn: Array, tilt: Array) -> tuple[Array, Array]:
    """Put the angles of a direction into turn and tilt: azimuth, and from z in [0, pi]; the azimuth's cos and sin."""
    r = np.sqrt(x * x + y * y)
    np.arctan2(r, z, out=tilt)
    c, s = x / r, y / r
    on_axis = r < NEAR
    if on_axis.any():
        c[on_axis], s[on_axis] = 1.0, 0.0
    np.arctan2(s, c, out=turn)
    return c, s
