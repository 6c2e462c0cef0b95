"""All joint solutions of a flange pose in closed form: eight branches named by ABB's cfx, and their turns.

cfx = 4 (wrist centre behind axis 1) + 2 (wrist centre behind the lower arm) + 1 (axis 5 < 0). The algebra is in the
canonical angles t of robot.arm, with e = t3 + bend for the elbow: behind the lower arm cos e < 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from math import cos, floor, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.limits import JointLimits
from trajopt_cli.motion import ConfData
from trajopt_cli.robot import offset_wrist, parallel_arm
from trajopt_cli.robot.arm import Arm, elbow_angle, wrist_section
from trajopt_cli.robot.parallel_arm import ParallelArm
from trajopt_cli.robot.structure import NO_CONFDATA
from trajopt_cli.robot.turns import ON_LIMIT, broken_limits, close_at_pi, half_turn

if TYPE_CHECKING:
    from trajopt_cli.robot.model import RobotModel

BRANCHES = 8
_FACING = np.array([[1.0], [-1.0]])  # before and behind, along the axis a branch bit stands on
_CHUNK = 512  # poses at once: work arrays of 16 kB stay in cache, and small enough for the heap to keep between calls
_SINGULAR = 1e-12  # sin q5, or m of the wrist centre from axis 1: below, the angle is a convention
_WEAK = 1e-3  # sin q5: above, q4 and q6 found each for itself are right to 1e-13
_STRETCH = 1e-12  # how far |sin q3| may exceed 1 by rounding at the stretched or folded elbow
_ON_QUADRANT = 1e-9  # rad below a multiple of 90 deg that still counts as on it
_QUADRANT_DOUBT = 1e-6  # rad from a quadrant's or a branch's border within which RAPID's rounding may fall either way


def inverse(robot: RobotModel, X_WF: Array, rail: Array | None = None) -> Array:
    """Joints (n, 8, 6) [rad] of flange poses X_WF (n, 4, 4), by branch: index cfx, NaN rows where there is none; 16
    branches of a wrist with an offset, of which two have one cfx.

    rail (n,): rail positions [m], needed with a rail. Joints lie within half a turn of arm.middles, the lower end left
    out; joint limits are not applied. At singularities the answer is finite and its pose right: t4 = 0 where t5 = 0
    (its partner branch has t4 = pi), t1 = 0 (its partner pi) where the wrist centre stands on axis 1 and may.
    """
    X_WF = np.asarray(X_WF, dtype=np.float64)
    if X_WF.ndim != 3 or X_WF.shape[1:] != (4, 4):
        raise ValueError(f"X_WF has shape {X_WF.shape}, wanted (n, 4, 4)")
    n = len(X_WF)
    X_WO = robot.X_WO0
    if not robot.arm.canonical_flange:
        X_WF = X_WF @ inverse_pose(robot.arm.X_KF)
    p = X_WF[:, :3, 3].T - X_WO[:3, 3, None]
    if robot.rail_axis_W is not None:
        if rail is None:
            raise ValueError(f"robot {robot.name} rides a rail: give rail (n,)")
        p = p - robot.rail_axis_W[:, None] * np.broadcast_to(np.asarray(rail, dtype=np.float64), (n,))
    R_OW = X_WO[:3, :3].T
    out = np.empty((BRANCHES if robot.arm.closed_form else 2 * BRANCHES, 6, n))
    for start in range(0, n, _CHUNK):
        part = slice(start, min(start + _CHUNK, n))
        R_OK = R_OW @ X_WF[part, :3, :3].transpose(1, 2, 0).reshape(3, -1)
        inverse_arm(robot.arm, R_OW @ p[:, part], R_OK.reshape(3, 3, -1), out[..., part])
    return out.transpose(2, 0, 1)


def inverse_arm(arm: Arm, p_OK: Array, R_OK: Array, out: Array) -> None:
    """Put joints by cfx of canonical flange positions (3, n) [m] and rotations (3, 3, n), frame O, into out (8, 6, n).

    Poses come last so that every step runs over contiguous blocks. Results go straight to out, and the two halves are
    functions of their own so that their work arrays die early: memory given back to the system and fetched again page
    by page costs as much as the arithmetic.
    """
    split = out.reshape(2, 2, 2, 6, -1)  # behind axis 1, behind the lower arm, t5 < 0; a view, axes are only split
    if arm.closed_form:
        with np.errstate(invalid="ignore", divide="ignore"):
            w = p_OK - arm.c4 * R_OK[:, 2]
            t1, radius, c1, s1 = _shoulder(arm, w)
            if isinstance(arm, ParallelArm):
                _parallel(arm, w, R_OK, (t1, radius, c1, s1), split)
            else:
                c23, s23 = _elbow(arm, t1, radius - arm.a1, w[2:] - arm.c1, split)
                _wrist(R_OK, c1[:, None], s1[:, None], c23, s23, split)
    else:
        out[:] = offset_wrist.angles(arm, p_OK, R_OK, inverse_arm)
    _as_joints(arm, out)


def _shoulder(arm: Arm, w: Array) -> tuple[Array, Array, Array, Array]:
    """t1 (2, n) of wrist centres w (3, n), how far before axis 1 they are (2, n), and cos, sin t1 (2, n) or (1, n).

    Without an offset b the shoulder behind is the one before turned by half a turn: cos, sin t1 are then those before.
    """
    square = w[0] * w[0] + w[1] * w[1]
    reach = np.sqrt(square)
    if arm.b:
        # The arm's plane passes axis 1 at b; the wrist centre lies in it, radius before axis 1 or behind it.
        over = reach - abs(arm.b)
        over[over < -_SINGULAR] = np.nan
        radius = _FACING * np.sqrt(np.maximum(over, 0.0) * (reach + abs(arm.b)))
        c1 = (radius * w[0] + arm.b * w[1]) / square
        s1 = (radius * w[1] - arm.b * w[0]) / square
        t1 = np.arctan2(s1, c1)
        close_at_pi(t1)
    else:
        c1, s1 = w[0] / reach, w[1] / reach
        on_axis = reach < _SINGULAR
        if on_axis.any():
            c1[on_axis], s1[on_axis] = 1.0, 0.0
        radius = _FACING * reach
        before = np.arctan2(s1, c1)
        close_at_pi(before)
        t1 = np.stack([before, half_turn(before)])
        c1, s1 = c1[None], s1[None]
    return t1, radius, c1, s1


def _elbow(arm: Arm, t1: Array, ahead: Array, up: Array, out: Array) -> tuple[Array, Array]:
    """Put t1, and t2 and t3 of wrist centres ahead and up of axis 2 in the arm's own plane, (2, n) or (1, n) of both
    shoulders, into out; cos, sin of t2 + t3 (2, 2, n)."""
    distance2 = ahead * ahead + up * up
    s3 = (arm.c2**2 + arm.upper**2 - distance2) / (2 * arm.c2 * arm.upper)
    s3[np.abs(s3) > 1 + _STRETCH] = np.nan
    s3 = np.maximum(np.minimum(s3, 1.0), -1.0)
    c3 = np.sqrt((1 - s3) * (1 + s3))
    out[..., 0, :] = (t1 + 0 * s3)[:, None, None]  # NaN where the branch has no solution: its whole row says so
    e = np.arctan2(s3, c3)
    out[:, 0, :, 2] = (e - arm.bend)[:, None]
    e = -pi - e
    e[e <= -1.5 * pi] = 0.5 * pi  # -270 deg is +90 deg
    out[:, 1, :, 2] = (e - arm.bend)[:, None]
    along, ahead, up, s3, distance2 = (a[:, None] for a in (arm.c2 - arm.upper * s3, ahead, up, s3, distance2))
    c3 = _FACING * c3[:, None]  # (2 shoulders, 2 elbows, n), as all that follows; the elbow's sign is cos e's
    across = arm.upper * c3
    y2, x2 = along * ahead - across * up, along * up + across * ahead
    out[..., 1, :] = np.arctan2(y2, x2)[:, :, None]
    y2 /= distance2
    x2 /= distance2
    if arm.bend:
        cb, sb = cos(arm.bend), sin(arm.bend)
        c3, s3 = c3 * cb + s3 * sb, s3 * cb - c3 * sb  # of t3
    return x2 * c3 - y2 * s3, y2 * c3 + x2 * s3


def _parallel(arm: ParallelArm, w: Array, R_OK: Array, shoulder: tuple[Array, Array, Array, Array], out: Array) -> None:
    """Put all joints of wrist centres w (3, n) and rotations (3, 3, n) into out: see robot.parallel_arm. shoulder: what
    _shoulder found."""
    for place, (ahead, up, t234, t5, t6) in enumerate(_both_sides(arm, w, R_OK, shoulder)):
        part = out[:, :, place : place + 1]
        _elbow(arm, shoulder[0], ahead, up, part)
        t4 = t234[:, None, None] - part[..., 1, :] - part[..., 2, :]
        part[..., 3, :] = t4 - 2 * pi * np.ceil((t4 - pi) / (2 * pi))
        for i, t in ((4, t5), (5, t6)):
            part[..., i, :] = t[:, None, None] + 0 * t4


def _both_sides(
    arm: ParallelArm, w: Array, R_OK: Array, shoulder: tuple[Array, Array, Array, Array]
) -> Iterator[tuple[Array, Array, Array, Array, Array]]:
    """What parallel_arm.bent finds on either side of axis 5."""
    _, radius, c1, s1 = shoulder
    if len(c1) == 1:
        c1, s1 = _FACING * c1, _FACING * s1
    up = np.broadcast_to(R_OK[2][:, None], (3, *c1.shape))
    R_1K = np.stack([c1 * R_OK[0][:, None] + s1 * R_OK[1][:, None], c1 * R_OK[1][:, None] - s1 * R_OK[0][:, None], up])
    centre = radius - arm.a1, np.broadcast_to(w[2] - arm.c1, radius.shape)
    return (parallel_arm.bent(arm, R_1K, centre, side) for side in (1, -1))


def _wrist(R_OK: Array, c1: Array, s1: Array, c23: Array, s23: Array, out: Array) -> None:
    """Put t4, t5, t6 into out. R_36 = (Rz(t1) Ry(t2 + t3))^T [z, y, -x] of the flange, which adds Ry(90 deg)."""
    # The flange's axes x, y, z in the frame axis 1 carries: ahead (3, 2 shoulders, 1, n), up (3, n); z aside.
    ahead = c1 * R_OK[0][:, None, None] + s1 * R_OK[1][:, None, None]
    aside = c1 * R_OK[1, 2] - s1 * R_OK[0, 2]
    facing = _FACING if len(c1) == 1 else np.ones((2, 1))
    if len(c1) == 1:
        ahead, aside = ahead * _FACING[:, None], aside * _FACING[:, None]
    up = R_OK[2]
    t4, t5, t6 = (out[:, :, 0, i] for i in (3, 4, 5))
    bend = s23 * ahead[2] + c23 * up[2]
    np.arctan2(aside, -bend, out=t4)
    bend *= bend
    bend += aside * aside
    np.sqrt(bend, out=bend)
    np.arctan2(bend, c23 * ahead[2] - s23 * up[2], out=t5)
    np.arctan2(c23 * ahead[1] - s23 * up[1], s23 * up[0] - c23 * ahead[0], out=t6)
    weak = bend < _WEAK
    if weak.any():
        # t4 and t6 are rounding here, each for itself, but exact in sum: take t6 from the turn that t4 leaves.
        straight = bend[weak] < _SINGULAR
        t4[weak] = np.where(straight, 0.0, t4[weak])
        t5[weak] = np.where(straight, np.where(t5[weak] < 1, 0.0, pi), t5[weak])
        shoulder, _, n = np.nonzero(weak)
        s, c, s4, c4 = s23[weak], c23[weak], np.sin(t4[weak]), np.cos(t4[weak])
        own = shoulder % len(c1)
        sine, cosine = (
            c4 * facing[shoulder, 0] * (c1[own, 0, n] * R_OK[1, i, n] - s1[own, 0, n] * R_OK[0, i, n])
            + s4 * (s * ahead[i, shoulder, 0, n] + c * up[i, n])
            for i in (0, 1)
        )
        t6[weak] = np.arctan2(sine, cosine)
    np.negative(t5, out=out[:, :, 1, 4])
    turns = out[:, :, 0, 3::2]  # t4 and t6
    close_at_pi(turns)
    out[:, :, 1, 3::2] = half_turn(turns)


def _as_joints(arm: Arm, out: Array) -> None:
    """Make joints of canonical angles (8, 6, n), in place, each within half a turn of its middle."""
    if arm.coupled:
        out[:, 2] += out[:, 1] - arm.offsets[1]
    for i in arm.converted:
        q = arm.signs[i] * (out[:, i] - arm.offsets[i])
        out[:, i] = q - 2 * pi * np.ceil((q - arm.middles[i] - pi) / (2 * pi))


def representatives(q: Array, lower: Array, upper: Array) -> Array:
    """All of q + 2 pi k (m, 6) within the range of every joint, smallest first, joint_1 the slowest to change.

    q, lower, upper (6,) in rad. A value at most 1e-9 rad outside a limit is put on it: rounding of the inverse.
    """
    choices = []
    for value, low, high in zip(q.tolist(), lower.tolist(), upper.tolist(), strict=True):
        if value != value:
            return np.empty((0, len(q)))
        turns = range(
            -floor((value - low + ON_LIMIT) / (2 * pi)),
            floor((high + ON_LIMIT - value) / (2 * pi)) + 1,
        )
        choices.append([min(max(value + 2 * pi * k, low), high) for k in turns])
    return np.array(list(product(*choices))).reshape(-1, len(q))


def solutions(robot: RobotModel, X_WF: Array, rail: float | None, limits: JointLimits) -> list[tuple[int, Array]]:
    """Every (cfx, joints (6,)) within limits that puts the flange at X_WF (4, 4), turns included; [] if there is none.

    rail [m] is needed with a rail, and a rail position outside its limits has no solutions. Where two branches meet
    (stretched elbow) the solution stands once, under the smaller cfx.
    """
    if robot.has_rail and rail is not None and not _within(rail, limits.lower[0], limits.upper[0]):
        return []
    branches = inverse(robot, X_WF[None], None if rail is None else np.array([rail]))[0]
    found: dict[tuple[float, ...], tuple[int, Array]] = {}
    for cfx, branch in enumerate(branches):
        turned = representatives(branch, limits.lower[-6:], limits.upper[-6:])
        for q in turned[limits.couplings.arm(robot.layout.arm).within(turned)]:
            found.setdefault(tuple(q.tolist()), (cfx, q))
    return list(found.values())


def _within(value: float, low: float, high: float) -> bool:
    return bool(low - ON_LIMIT <= value <= high + ON_LIMIT)


def confdata(robot: RobotModel, q: Array) -> ConfData:
    """RAPID confdata of arm joints q (6,) [rad]: cf1, cf4, cf6 = floor(angle / 90 deg), cfx as above.

    A value less than 1e-9 rad below a multiple of 90 deg counts as on it, so that rounding does not flip a quadrant.
    Of an arm with a parallel linkage, which is no serial link robot, cfx is the quadrant of axis 2 (RAPID reference
    manual, confdata).
    """
    (numbers,) = confdata_numbers(robot, q[None]).tolist()
    return ConfData(*numbers)


def confdata_numbers(robot: RobotModel, q: Array) -> IndexArray:
    """The same of many joints (n, 6): cf1, cf4, cf6 and cfx (n, 4)."""
    out = np.floor((q[:, [0, 3, 5, 1]] + _ON_QUADRANT) / (pi / 2)).astype(np.intp)
    if not robot.arm.coupled:
        wrist, lower_arm, axis_5 = branch_margins(robot.arm, q)
        out[:, 3] = 4 * (wrist < 0) + 2 * (lower_arm < 0) + (axis_5 < 0)
    return out


def branch_of(arm: Arm, q: Array) -> int:
    """The number in 0..7 of the branch that joints q (6,) [rad] are on: cfx of a serial arm."""
    wrist, lower_arm, axis_5 = branch_margins(arm, q)
    return int(4 * (wrist < 0) + 2 * (lower_arm < 0) + 1 * (axis_5 < 0))


def branch_margins(arm: Arm, q: Array) -> tuple[Array, Array, Array]:
    """What cfx takes the signs of, of joints (..., 6): wrist centre before axis 1 [m], before the lower arm (the cosine
    of the elbow), axis 5 [rad]. Axis 5 counts from where axis 6 runs on along axis 4; all turns of it alike."""
    t5 = arm.angles(q)[..., 4]
    return wrist_section(arm, q)[0], np.cos(elbow_angle(arm, q)), t5 - 2 * pi * np.round(t5 / (2 * pi))


def folded(arm: Arm, q: Array) -> BoolArray:
    """Whether joints (..., 6) have axis 4 point behind the lower arm, where a parallelogram does not go."""
    return np.asarray(np.cos(arm.angles(q)[..., 2]) < -_QUADRANT_DOUBT)


def confdata_admits(robot: RobotModel, conf: ConfData | Array, q: Array) -> BoolArray:
    """Whether a target with this confdata (its four numbers may be an array (..., 4)) may be reached with arm joints q
    (..., 6) [rad].

    Quadrants and branch must be those of q. Only within 1e-6 rad (of a multiple of 90 deg for cf1, cf4, cf6; of a
    branch's border for a bit of cfx; 1e-6 m for the wrist centre before axis 1), where the rounding of a printed
    target decides, the neighbour is taken too. Always so for a robot without a rule for confdata. Of an arm with a
    parallel linkage cfx is not looked at: axis 4 points before the lower arm, as a parallelogram has it.
    """
    if robot.confdata_rule == NO_CONFDATA:
        return np.ones(q.shape[:-1], dtype=bool)
    named = np.asarray(conf.numbers if isinstance(conf, ConfData) else conf)
    angle, low = q[..., [0, 3, 5]], named[..., :3] * (pi / 2)
    with np.errstate(invalid="ignore"):
        ok = np.all((angle >= low - _QUADRANT_DOUBT) & (angle < low + pi / 2 + _QUADRANT_DOUBT), axis=-1)
        if robot.arm.coupled:
            return np.asarray(ok & ~folded(robot.arm, q))
        for bit, margin in zip((4, 2, 1), branch_margins(robot.arm, q), strict=True):
            behind = (named[..., 3].astype(np.intp) & bit) > 0
            ok = ok & ((np.abs(margin) <= _QUADRANT_DOUBT) | (behind == (margin < 0)))
    return np.asarray(ok)


def why_unreachable(robot: RobotModel, X_WF: Array, rail: float | None, limits: JointLimits) -> str:
    """The reason, in one clause, why solutions() of this flange pose is empty.

    The rail outside its stroke; the wrist centre too far from or too near to axis 2; or the joint limits every branch
    breaks. Raises ValueError for a pose that has solutions.
    """
    if robot.has_rail and rail is not None and not _within(rail, limits.lower[0], limits.upper[0]):
        low, high = limits.lower[0], limits.upper[0]
        return f"{robot.axis_names[0]} = {rail:.6g} m, outside its stroke {low:.6g}..{high:.6g} m"
    if solutions(robot, X_WF, rail, limits):
        raise ValueError("why_unreachable: the pose has solutions")
    branches = inverse(robot, X_WF[None], None if rail is None else np.array([rail]))[0]
    alive = {f"cfx {cfx}": q for cfx, q in enumerate(branches) if not np.isnan(q).any()}
    if not alive:
        return _outside_workspace(robot, X_WF, rail)
    said = broken_limits(alive, robot.axis_names[-6:], limits.lower[-6:], limits.upper[-6:])
    return said or _broken_couplings(robot, alive, limits)


def _broken_couplings(robot: RobotModel, branches: Mapping[str, Array], limits: JointLimits) -> str:
    """Which range of a sum of joints keeps the branches out that are within the ranges of each joint."""
    lower, upper = limits.lower[-6:], limits.upper[-6:]
    rows = limits.couplings.arm(robot.layout.arm).rows
    found = []
    for branch, raw in branches.items():
        for q in representatives(raw, lower, upper):
            sums = zip(limits.coupled, (rows @ q).tolist(), strict=True)
            found.append(max((max(c.lower - v, v - c.upper), branch, c.name, v, c.lower, c.upper) for c, v in sums))
    _, branch, name, value, low, high = min(found)
    return f"every branch breaks a limit: nearest {name} = {np.degrees(value):.6g}° ({branch}), range" + (
        f" {np.degrees(low):.6g}..{np.degrees(high):.6g}°"
    )


def _outside_workspace(robot: RobotModel, X_WF: Array, rail: float | None) -> str:
    arm = robot.arm
    if not arm.closed_form:
        return "no posture was found that reaches it (its wrist has an offset, so postures are sought step by step)"
    X_WO = robot.canonical_base(0.0 if rail is None else rail)
    X_WK = X_WF @ inverse_pose(arm.X_KF)
    w = X_WO[:3, :3].T @ (X_WK[:3, 3] - arm.c4 * X_WK[:3, 2] - X_WO[:3, 3])
    reach, up = float(np.hypot(w[0], w[1])), float(w[2]) - arm.c1
    if reach < abs(arm.b):
        return f"wrist centre {reach:.6g} m from axis 1, at least the arm's offset of {abs(arm.b):.6g} m"
    if isinstance(arm, ParallelArm):
        return _out_of_reach_of_two(arm, w, X_WO[:3, :3].T @ X_WK[:3, :3])
    reach = float(np.sqrt((reach - abs(arm.b)) * (reach + abs(arm.b))))
    near, far = float(np.hypot(reach - arm.a1, up)), float(np.hypot(reach + arm.a1, up))
    outer, inner = arm.c2 + arm.upper, abs(arm.c2 - arm.upper)
    if near > outer:
        return f"wrist centre outside the outer workspace: {near:.6g} m from axis 2, at most {outer:.6g} m"
    # Facing forward it is too near; facing backward too near or too far.
    return (
        f"wrist centre inside the inner workspace: {near:.6g} m from axis 2, at least {inner:.6g} m"
        f" (turned by half a turn {far:.6g} m, at most {outer:.6g} m)"
    )


def _out_of_reach_of_two(arm: ParallelArm, w: Array, R_OK: Array) -> str:
    """Where axis 4 would have to be, of the four places that wrist centre (3,) and flange leave it, the nearest to what
    axes 2 and 3 reach."""
    shoulder = _shoulder(arm, w[:, None])
    places = [np.hypot(ahead, up) for ahead, up, *_ in _both_sides(arm, w[:, None], R_OK[..., None], shoulder)]
    inner, outer = abs(arm.c2 - arm.c3), arm.c2 + arm.c3
    far = min(np.ravel(places).tolist(), key=lambda r: max(inner - r, r - outer))
    return f"axis 4 outside the workspace: {far:.6g} m from axis 2 at best, in reach are {inner:.6g} to {outer:.6g} m"
