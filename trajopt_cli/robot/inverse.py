"""All joint solutions of a flange pose in closed form: eight branches named by ABB's cfx, and their turns.

cfx = 4 (wrist centre behind axis 1) + 2 (wrist centre behind the lower arm) + 1 (axis 5 < 0). The algebra is in the
canonical angles t of robot.arm, with e = t3 + bend for the elbow: behind the lower arm cos e < 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from math import floor, pi
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose, moved_by
from trajopt_cli.limits import JointLimits
from trajopt_cli.motion import ConfData
from trajopt_cli.robot import offset_wrist, parallel_arm
from trajopt_cli.robot.arm import Arm, elbow_angle, wrist_section
from trajopt_cli.robot.parallel_arm import ParallelArm
from trajopt_cli.robot.structure import NO_CONFDATA
from trajopt_cli.robot.turns import ON_LIMIT, broken_limits

if TYPE_CHECKING:
    from trajopt_cli.robot.model import RobotModel

BRANCHES = 8
_ON_QUADRANT = 1e-9  # rad below a multiple of 90 deg that still counts as on it
_QUADRANT_DOUBT = 1e-6  # rad from a quadrant's or a branch's border within which RAPID's rounding may fall either way


def inverse(robot: RobotModel, X_WF: Array, rail: Array | None = None, cfx: IndexArray | int | None = None) -> Array:
    """Joints (n, 8, 6) [rad] of flange poses X_WF (n, 4, 4), by branch: index cfx, NaN rows where there is none; 16
    branches of a wrist with an offset, of which two have one cfx. Joints (n, 6) of one branch each with cfx (n,) or ().

    rail (n, r), or (n,) of one: rail positions [m], needed with a rail. Joints lie within half a turn of arm.middles,
    the lower end left out; joint limits are not applied. At singularities the answer is finite and its pose right: t4 =
    0 where t5 = 0 (its partner branch has t4 = pi), t1 = 0 (its partner pi) where the wrist centre stands on axis 1 and
    may. Raises ValueError for poses of another shape, a rail without positions and numbers that no branch has.
    """
    X_WF, arm = np.asarray(X_WF, dtype=np.float64), robot.arm
    if X_WF.ndim != 3 or X_WF.shape[1:] != (4, 4):
        raise ValueError(f"X_WF has shape {X_WF.shape}, wanted (n, 4, 4)")
    if robot.has_rail and rail is None:
        raise ValueError(f"robot {robot.name} rides a rail: give rail (n, {robot.layout.r})")
    way = np.broadcast_to(robot.way(rail), (len(X_WF), 3))
    branches = BRANCHES if arm.closed_form else 2 * BRANCHES
    one = None if cfx is None else np.broadcast_to(np.asarray(cfx, dtype=np.int64), (len(X_WF),))
    if one is not None and np.any((one < 0) | (one >= branches)):
        raise ValueError(f"branches {one.min()} to {one.max()}: they are 0 to {branches - 1}")
    if arm.closed_form:
        return closed_form(arm, X_WF, robot.X_WC0, way, one)
    t = offset_wrist.angles(arm, inverse_pose(moved_by(robot.X_WC0, way)) @ X_WF @ inverse_pose(arm.X_KF), closed_form)
    q = arm.joints(t)
    q -= 2 * pi * np.ceil((q - arm.middles - pi) / (2 * pi))
    return q if one is None else q[np.arange(len(q)), one]


def closed_form(arm: Arm, X_WF: Array, X_WC: Array, way: Array | None = None, cfx: IndexArray | None = None) -> Array:
    """The same of an arm that has one, its canonical base at X_WC (4, 4) with the rails at 0; way (n, 3): how far they
    have taken it [m]. Compiled: robot.inverse_loops."""
    from trajopt_cli.native.loops import loops  # LLVM with it: not for who only loads a robot

    n = len(X_WF)
    out = np.empty((n, BRANCHES if cfx is None else 1, 6))
    which = np.broadcast_to(np.int64(-1), (n,)) if cfx is None else cfx
    way = np.zeros((n, 3)) if way is None else way
    fill = loops("trajopt_cli.robot.inverse_loops")["fill_joints"]
    fill(arm.numbers, X_WC, way, inverse_pose(arm.X_KF), X_WF, which, np.empty((6, 6)), out)
    return out if cfx is None else out[:, 0]


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


def solutions(
    robot: RobotModel, X_WF: Array, rail: Array | float | None, limits: JointLimits
) -> list[tuple[int, Array]]:
    """Every (cfx, joints (6,)) within limits that puts the flange at X_WF (4, 4), turns included; [] if there is none.

    rail [m], (r,) or that of one, is needed with a rail, and a position outside its limits has no solutions. Where two
    branches meet (stretched elbow) the solution stands once, under the smaller cfx.
    """
    if rail is not None and _beyond(robot, rail, limits) is not None:
        return []
    branches = inverse(robot, X_WF[None], None if rail is None else np.array([rail]))[0]
    found: dict[tuple[float, ...], tuple[int, Array]] = {}
    for cfx, branch in enumerate(branches):
        turned = representatives(branch, limits.lower[-6:], limits.upper[-6:])
        for q in turned[limits.couplings.arm(robot.layout.arm).within(turned)]:
            found.setdefault(tuple(q.tolist()), (cfx, q))
    return list(found.values())


def _beyond(robot: RobotModel, rail: Array | float, limits: JointLimits) -> int | None:
    """The first of the rails that a position (r,) is outside the stroke of; None where there is none."""
    ends = zip(np.ravel(rail)[: robot.layout.r], limits.lower, limits.upper, strict=False)
    return next((i for i, (d, low, high) in enumerate(ends) if not low - ON_LIMIT <= d <= high + ON_LIMIT), None)


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


def why_unreachable(robot: RobotModel, X_WF: Array, rail: Array | float | None, limits: JointLimits) -> str:
    """The reason, in one clause, why solutions() of this flange pose is empty.

    The rail outside its stroke; the wrist centre too far from or too near to axis 2; or the joint limits every branch
    breaks. Raises ValueError for a pose that has solutions.
    """
    if rail is not None and (i := _beyond(robot, rail, limits)) is not None:
        low, high = limits.lower[i], limits.upper[i]
        return f"{robot.axis_names[i]} = {np.ravel(rail)[i]:.6g} m, outside its stroke {low:.6g}..{high:.6g} m"
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


def _outside_workspace(robot: RobotModel, X_WF: Array, rail: Array | float | None) -> str:
    arm = robot.arm
    if not arm.closed_form:
        return "no posture was found that reaches it (its wrist has an offset, so postures are sought step by step)"
    X_WC = moved_by(robot.X_WC0, robot.way(rail))
    X_WK = X_WF @ inverse_pose(arm.X_KF)
    w = X_WC[:3, :3].T @ (X_WK[:3, 3] - arm.c4 * X_WK[:3, 2] - X_WC[:3, 3])
    reach, up = float(np.hypot(w[0], w[1])), float(w[2]) - arm.c1
    if reach < abs(arm.b):
        return f"wrist centre {reach:.6g} m from axis 1, at least the arm's offset of {abs(arm.b):.6g} m"
    if isinstance(arm, ParallelArm):
        return _out_of_reach_of_two(arm, w, X_WC[:3, :3].T @ X_WK[:3, :3])
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
    radius = np.sqrt(w[0] ** 2 + w[1] ** 2 - arm.b**2) * np.array([1, -1, 1, -1])
    c, s = (radius * w[0] + arm.b * w[1]), (radius * w[1] - arm.b * w[0])
    R_1O = np.zeros((4, 3, 3))
    R_1O[:, 0, 0], R_1O[:, 0, 1], R_1O[:, 1, 0], R_1O[:, 1, 1], R_1O[:, 2, 2] = c, s, -s, c, w[0] ** 2 + w[1] ** 2
    centre = np.column_stack([radius - arm.a1, np.full(4, w[2] - arm.c1)])
    places = parallel_arm.bent(arm, R_1O / R_1O[:, 2:, 2:] @ R_OK, centre, np.array([1.0, 1.0, -1.0, -1.0]))[:, :2]
    inner, outer = abs(arm.c2 - arm.c3), arm.c2 + arm.c3
    far = min(np.hypot(*places.T).tolist(), key=lambda r: max(inner - r, r - outer))
    return f"axis 4 outside the workspace: {far:.6g} m from axis 2 at best, in reach are {inner:.6g} to {outer:.6g} m"
