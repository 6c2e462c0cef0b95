"""Programmed configurations held against the robot: can each point be reached as its confdata says, and each line run?

Every pose is looked at where its own external axes put the rail, or where the rail stands when they leave it open.
A line is followed from its start with the joints changing continuously, which is all a controller can do: it ends in
one configuration, and confdata that names another cannot be kept.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import astuple, dataclass
from enum import StrEnum
from itertools import product
from math import floor, pi

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.motion import (
    ConfData,
    MoveAbsJ,
    PathMove,
    PoseMove,
    Program,
    SignalEvent,
    Source,
    Wait,
    motion_name,
    turned_under,
)
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.problem.path_ik import ArmPath, Followed, follow
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plannable import demands_configuration, with_exact_orientation
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import (
    branch_margins,
    confdata,
    confdata_admits,
    folded,
    inverse,
    representatives,
    why_unreachable,
)
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.turns import ON_LIMIT

_DOUBT = 1e-6  # rad or m, as in confdata_admits: where rounding decides, the neighbour is right too
_SAME = 1e-5  # rad between two ways to the same joints
_CHUNK = 4000  # poses at once: 60 MB of work arrays
_LISTED = 6  # confdata in a message; the finding has them all
_TOLD = 20  # changed configurations in an answer; the files have them all
_FAR = 0.5 * np.pi / 180  # rad: joints that differ less are not told of


class Misfit(StrEnum):
    """What does not fit."""

    POSE = "unreachable pose"
    CONFDATA = "unreachable confdata"
    FLIP = "flip"
    SINGULAR = "singularity"
    LIMIT = "joint limit"
    REACH = "out of reach on the way"


@dataclass(frozen=True)
class ConfigurationFinding:
    """Something wrong with one motion's configuration.

    index: its place in Program.motions. motion: instruction and target. programmed: its confdata. reachable: what
    could stand there instead, best first; () where nothing helps. rail [m]: where the rail stands at the point, None
    without one. message: all of it in words, without the place.
    """

    index: int
    source: Source
    motion: str
    misfit: Misfit
    programmed: ConfData
    reachable: tuple[ConfData, ...]
    rail: float | None
    message: str


@dataclass(frozen=True, eq=False)
class _Point:
    """A programmed pose. demanded: its confdata counts."""

    index: int
    motion: PoseMove
    X_WF: Array
    rail: float
    demanded: bool


@dataclass(frozen=True, eq=False)
class _Poses:
    """Of poses (n,): whether there is any solution; joints (n, 6) in the programmed configuration, NaN for none.

    others: what there would be instead, by row, where the programmed configuration counts and is not to be had.
    """

    reachable: BoolArray
    joints: Array
    others: Mapping[int, tuple[ConfData, ...]]


def check_configurations(program: Program, plant: Plant) -> tuple[ConfigurationFinding, ...]:
    r"""Everything that does not fit, in program order; at most one finding per motion.

    Under ConfJ or ConfL \Off only unreachable poses are told.
    """
    points = _points(program, plant)
    poses = _reached(points, plant)
    found: dict[int, ConfigurationFinding] = {}
    for point, reachable in zip(points, poses.reachable, strict=True):
        if not reachable:
            found[point.index] = _unreachable(point, plant)
    lines = _lines(program, plant, points, poses)
    followed = dict(zip((index for index, _ in lines), follow(plant, [line for _, line in lines]), strict=True))
    for k, point in enumerate(points):
        if not point.demanded or not poses.reachable[k]:
            continue
        along = followed.get(point.index)
        if np.isnan(poses.joints[k, 0]):
            found[point.index] = _not_as_written(point, plant, poses.others[k], along)
        elif along is not None and (finding := _misled(point, plant, poses.joints[k], along)) is not None:
            found[point.index] = finding
    return tuple(found[index] for index in sorted(found))


def _points(program: Program, plant: Plant) -> list[_Point]:
    rail = float(plant.layout.place(plant.start))
    points = []
    for index, motion in enumerate(program.motions):
        if isinstance(motion, Wait | SignalEvent):
            continue
        given = plant.rail_value(motion.extax)
        rail = rail if given is None else given
        if isinstance(motion, PoseMove):
            X_WF = motion.X_WT @ inverse_pose(motion.tool.X_FT)
            points.append(_Point(index, motion, X_WF, rail, demands_configuration(motion, plant.robot)))
    return points


def changed_configurations(program: Program, plant: Plant, plan: Plan) -> tuple[str, ...]:
    """The moves whose confdata counts and that a plan ends in another configuration, a line each, alike passes once."""
    lines: dict[str, None] = {}
    for planned in plan.motions:
        motion = program.motions[planned.index]
        if planned.dropped or not isinstance(motion, PoseMove) or not demands_configuration(motion, plant.robot):
            continue
        arm = np.asarray(planned.q_1[plant.layout.arm])
        if not confdata_admits(plant.robot, motion.conf, arm):
            now = shown(confdata(plant.robot, arm))
            lines[f"{motion.source}: {motion_name(motion)}: confdata {shown(motion.conf)} → {now}"] = None
    more = (f"and {len(lines) - _TOLD} more moves in another configuration",) if len(lines) > _TOLD else ()
    return (*[*lines][:_TOLD], *more)


# ------------------------------------------------------------------------------------------------------- the points


def _turned(plant: Plant, q: Array) -> tuple[Array, BoolArray]:
    """All turns (..., 6, K) of joints q (..., 6) and which of them are within the limits."""
    low, high = plant.limits.lower[-6:, None], plant.limits.upper[-6:, None]
    most = int(np.ceil(max(np.abs(low).max(), np.abs(high).max()) / (2 * np.pi)))
    turned = q[..., None] + 2 * np.pi * np.arange(-most, most + 1)
    with np.errstate(invalid="ignore"):
        return turned, (turned >= low - ON_LIMIT) & (turned <= high + ON_LIMIT)


def _reached(points: Sequence[_Point], plant: Plant) -> _Poses:
    reachable, joints = np.zeros(len(points), dtype=bool), np.full((len(points), plant.layout.joints), np.nan)
    others = {}
    for start in range(0, len(points), _CHUNK):
        part = slice(start, start + _CHUNK)
        some = points[part]
        rail = np.array([point.rail for point in some])
        q = _branches(plant, np.array([point.X_WF for point in some]), rail)
        turned, inside = _turned(plant, q)
        reachable[part] = inside.any(axis=-1).all(axis=-1).any(axis=-1)
        conf = np.array([astuple(point.motion.conf) for point in some], dtype=np.intp)
        joints[part] = _as_programmed(plant, q, turned, inside, conf)
        for k in np.flatnonzero(np.isnan(joints[part, 0]) & reachable[part]).tolist():
            if some[k].demanded:
                others[start + k] = _alternatives(plant.robot, q[k], turned[k], inside[k])
    return _Poses(reachable, joints, others)


def _branches(plant: Plant, X_WF: Array, rail: Array) -> Array:
    """All branches (n, 8, 6) of poses, NaN rows also where the rail is outside its stroke, or no turn of the joints
    keeps the ranges of their sums."""
    if not plant.robot.has_rail:
        return inverse(plant.robot, X_WF)
    q = np.array(inverse(plant.robot, X_WF, rail))
    low, high = plant.layout.place(plant.limits.lower), plant.layout.place(plant.limits.upper)
    q[(rail < low - ON_LIMIT) | (rail > high + ON_LIMIT)] = np.nan
    couplings = plant.limits.couplings.arm(plant.layout.arm)
    if couplings:
        lower, upper = (ends[plant.layout.arm] for ends in (plant.limits.lower, plant.limits.upper))
        for place in np.ndindex(q.shape[:2]):
            if not couplings.within(representatives(q[place], lower, upper)).any():
                q[place] = np.nan
    return q


def _as_programmed(plant: Plant, q: Array, turned: Array, inside: BoolArray, conf: IndexArray) -> Array:
    """Joints (n, 6) in configuration conf (n, 4) out of branches q (n, 8, 6), NaN where there are none.

    confdata_admits for all of them at once.
    """
    admitted = inside.copy()
    with np.errstate(invalid="ignore"):
        for column, joint in ((0, 0), (1, 3), (2, 5)):
            low = conf[:, column, None, None] * (np.pi / 2)
            angle = turned[:, :, joint]
            admitted[:, :, joint] &= (angle >= low - _DOUBT) & (angle < low + np.pi / 2 + _DOUBT)
        margins = branch_margins(plant.robot.arm, q)
        ok: BoolArray = np.asarray(admitted.any(axis=-1).all(axis=-1))
        if plant.robot.linkage:
            ok = ok & ~folded(plant.robot.arm, q)
        for bit, margin in zip(() if plant.robot.linkage else (4, 2, 1), margins, strict=False):
            named = (conf[:, 3, None] & bit) > 0
            ok = np.asarray(ok & ((np.abs(margin) <= _DOUBT) | (named == (margin < 0))))
    # where two branches meet, the one that is named
    own = np.equal(np.arange(q.shape[1]) % 8, conf[:, 3, None])
    branch = np.argmax(ok.astype(np.intp) + (ok & own), axis=1)
    n = np.arange(len(q))
    turn = np.argmax(admitted[n, branch], axis=-1)
    joints = np.take_along_axis(turned[n, branch], turn[..., None], axis=-1)[..., 0]
    return np.where(np.any(ok, axis=1)[:, None], joints, np.nan)


def _alternatives(robot: RobotModel, q: Array, turned: Array, inside: BoolArray) -> tuple[ConfData, ...]:
    """Every confdata to be had at a pose, from its branches (8, 6), also turned (8, 6, K), the least turned first."""
    found, ok = [], inside.any(axis=-1).all(axis=-1)
    if robot.linkage:
        ok &= ~folded(robot.arm, q)
    for branch in np.flatnonzero(ok).tolist():
        quadrants = [
            {floor((angle + ON_LIMIT) / (pi / 2)) for angle in turned[branch, joint][inside[branch, joint]].tolist()}
            for joint in (0, 3, 5, *([1] if robot.linkage else []))
        ]
        found += [(*conf, branch)[:4] for conf in product(*quadrants)]
    found.sort(key=lambda conf: (sum(map(abs, conf[:3])), conf))
    return tuple(ConfData(*conf) for conf in found)


# -------------------------------------------------------------------------------------------------------- the lines


def _lines(program: Program, plant: Plant, points: Sequence[_Point], poses: _Poses) -> list[tuple[int, ArmPath]]:
    """The lines and arcs whose configuration counts and whose start joints are known, by index of the motion."""
    at = {point.index: k for k, point in enumerate(points)}
    wanted = {
        point.index
        for point in points
        if point.demanded
        and isinstance(point.motion, PathMove)
        and not (point.motion.tool.stationary or turned_under(point.motion))
    }
    robot = plant.robot
    lines: list[tuple[int, ArmPath]] = []
    if not wanted:
        return lines
    now: Array | None = plant.start[plant.layout.arm]
    rail = float(plant.layout.place(plant.start))
    X_WF: Array | None = None  # the flange as programmed; None where only the joints tell
    for index, motion in enumerate(program.motions):
        if isinstance(motion, Wait | SignalEvent):
            continue
        before, given = rail, plant.rail_value(motion.extax)
        rail = rail if given is None else given
        if isinstance(motion, MoveAbsJ):
            now, X_WF = motion.q, None
        elif index in at:
            k = at[index]
            if index in wanted and now is not None and poses.reachable[k]:
                assert isinstance(motion, PathMove)
                if X_WF is None:
                    X_WF = robot.forward(np.r_[before, now] if robot.has_rail else now)
                with suppress(InputError):  # no circle: a refusal of its own
                    path = segment_of(motion, X_WF @ motion.tool.X_FT)
                    lines.append((index, ArmPath(path, motion.tool.X_FT, (before, rail), now)))
            now, X_WF = _after(points[k], plant, poses.joints[k], now), points[k].X_WF
        else:  # MoveExtJ: the arm holds
            X_WF = None
    return lines


def _after(point: _Point, plant: Plant, joints: Array, now: Array | None) -> Array | None:
    """Arm joints after a move: as programmed, or the nearest where confdata does not count; None for unknown."""
    if point.demanded:
        return None if np.isnan(joints[0]) else joints
    if now is None:
        return None
    turned, inside = _turned(plant, _branches(plant, point.X_WF[None], np.array([point.rail]))[0])
    away = np.where(inside, np.abs(turned - now[:, None]), np.inf)
    choice = np.argmin(away, axis=-1)
    least = np.take_along_axis(away, choice[..., None], axis=-1)[..., 0]
    branch = int(np.argmin(np.linalg.norm(least, axis=-1)))
    if not np.isfinite(least[branch]).all():
        return None
    return np.asarray(np.take_along_axis(turned[branch], choice[branch, :, None], axis=-1)[:, 0])


# ----------------------------------------------------------------------------------------------------- in words


def _finding(
    point: _Point, plant: Plant, misfit: Misfit, text: str, reachable: tuple[ConfData, ...] = ()
) -> ConfigurationFinding:
    motion, name = point.motion, motion_name(point.motion)
    rail = point.rail if plant.robot.has_rail else None
    return ConfigurationFinding(
        point.index, motion.source, name, misfit, motion.conf, reachable, rail, f"{name} {text}"
    )


def shown(conf: ConfData) -> str:
    """confdata as RAPID writes it."""
    return f"[{','.join(map(str, astuple(conf)))}]"


def _where(point: _Point, plant: Plant) -> str:
    return f" with the rail at {point.rail * 1e3:.6g} mm" if plant.robot.has_rail else ""


def _unreachable(point: _Point, plant: Plant) -> ConfigurationFinding:
    rail = point.rail if plant.robot.has_rail else None
    why = why_unreachable(plant.robot, point.X_WF, rail, plant.limits)
    return _finding(point, plant, Misfit.POSE, f"cannot be reached{_where(point, plant)}: {why}")


def _not_as_written(
    point: _Point, plant: Plant, others: tuple[ConfData, ...], along: Followed | None
) -> ConfigurationFinding:
    listed = ", ".join(shown(conf) for conf in others[:_LISTED])
    more = f" and {len(others) - _LISTED} more" if len(others) > _LISTED else ""
    text = (
        f"cannot be reached in confdata {shown(point.motion.conf)}{_where(point, plant)}; reachable with {listed}{more}"
    )
    if along is not None and along.whole:
        leads = confdata(plant.robot, along.end)
        others = (leads, *(conf for conf in others if conf != leads))
        text += f"; the line leads to {shown(leads)}"
    return _finding(point, plant, Misfit.CONFDATA, text, others)


def _misled(point: _Point, plant: Plant, joints: Array, along: Followed) -> ConfigurationFinding | None:
    """What is wrong with a line to a point that can be reached in joints as programmed; None for nothing."""
    names = plant.limits.names[plant.layout.arm]
    if along.lost is not None:
        return _finding(point, plant, Misfit.REACH, f"cannot run as a line: {along.at(along.lost)} it is out of reach")
    if along.singular is not None:
        text = f"passes a singularity {along.at(along.singular)}: {along.what(names)}; tilt the tool or use MoveJ"
        text += with_exact_orientation(point.motion)
        return _finding(point, plant, Misfit.SINGULAR, text)
    if along.beyond is not None:
        joint, share, limit = along.beyond
        text = (
            f"drives {names[joint]} past its limit {np.degrees(limit):.6g}° {along.at(share)};"
            " start the line with that axis turned back (confdata of the point before)"
        )
        return _finding(point, plant, Misfit.LIMIT, text)
    if np.abs(along.end - joints).max() <= _SAME or confdata_admits(plant.robot, point.motion.conf, along.end):
        return None
    leads = confdata(plant.robot, along.end)
    turns = ", ".join(
        f"{axis} by {np.degrees(value):+.0f}°"
        for axis, value in zip(names, joints - along.end, strict=True)
        if abs(value) > _FAR
    )
    other = 0 if plant.robot.linkage else leads.cfx ^ point.motion.conf.cfx  # of a linkage it names no branch
    parts = [part for bit, part in ((4, "shoulder"), (2, "elbow"), (1, "wrist")) if other & bit]
    flip = f"the {' and '.join(parts)} would have to flip" if parts else "the wrist would have to wind"
    text = (
        f"leads from its start to confdata {shown(leads)}, and {shown(point.motion.conf)} is programmed: {flip} on top"
        f" of the line's own motion ({turns}); write {shown(leads)} there, or use MoveJ"
    )
    text += "" if other & 6 else with_exact_orientation(point.motion)  # the wrist alone
    return _finding(point, plant, Misfit.FLIP, text, (leads,))
