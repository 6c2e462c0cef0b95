"""Programmed configurations held against the robot: can each point be reached as its confdata says, and each line run?

Every pose is looked at where its own external axes put the rail, or where the rail stands when they leave it open.
A line is followed from its start with the joints changing continuously, which is all a controller can do: it ends in
one configuration, and confdata that names another cannot be kept. Where confdata is switched off a joint move ends in
the nearest configuration, and a line where it leads.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import StrEnum
from math import pi

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose, readonly
from trajopt_cli.motion import (
    ConfData,
    Move,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
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
from trajopt_cli.problem.nearest import is_nearest, is_sure, nearest, postures
from trajopt_cli.problem.path_ik import ArmPath, Followed, follow
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plannable import demands_configuration, with_exact_orientation
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import (
    confdata,
    confdata_admits,
    confdata_numbers,
    inverse,
    representatives,
    why_unreachable,
)
from trajopt_cli.robot.turns import ON_LIMIT

_SAME = 1e-5  # rad between two ways to the same joints
_ON_LIMIT = 1e-9  # m, rad an axis may stand outside its range by rounding
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


@dataclass(frozen=True, eq=False)
class ConfigurationFinding:
    """Something wrong with one motion's configuration.

    index: its place in Program.motions. motion: instruction and target. programmed: its confdata. reachable: what
    could stand there instead, best first; () where nothing helps. rail (r,) [m]: where the rails stand at the point,
    None without one. message: all of it in words, without the place.
    """

    index: int
    source: Source
    motion: str
    misfit: Misfit
    programmed: ConfData
    reachable: tuple[ConfData, ...]
    rail: Array | None
    message: str


@dataclass(frozen=True, eq=False)
class _Point:
    """A programmed pose. rails (r,) [m]: where these stand before the move and at the pose. demanded: its confdata
    counts; off: it is switched off. reachable: there is any solution. q (6,): that in the programmed configuration."""

    index: int
    motion: PoseMove
    X_WF: Array
    rails: tuple[Array, Array]
    demanded: bool
    off: bool
    reachable: bool = False
    q: Array | None = None

    @property
    def rail(self) -> Array:
        return self.rails[1]


def check_configurations(program: Program, plant: Plant) -> tuple[ConfigurationFinding, ...]:
    r"""Everything that does not fit, in program order; at most one finding per motion.

    Under ConfJ or ConfL \Off: unreachable poses, and lines that cannot be run from the nearest configuration.
    """
    points = _points(program, plant)
    lines, _ = _walked(program, plant, points)
    found: list[ConfigurationFinding | None] = []
    for k, point in enumerate(points):
        start, along = lines.get(point.index, (None, None))
        if not point.reachable:
            found.append(_unreachable(point, plant))
        elif point.demanded and point.q is None:
            found.append(_not_as_written(point, plant, along))
        elif start is not None and along is not None:
            one = _misled(point, plant, along)
            if one is not None and k and points[k - 1].off and isinstance(points[k - 1].motion, MoveJ):
                begun = (
                    f"; confdata is off: it begins in the nearest configuration, {shown(confdata(plant.robot, start))}"
                )
                one = replace(one, message=one.message + begun)
            found.append(one)
    return tuple(one for one in found if one is not None)


def arms_as_written(program: Program, plant: Plant) -> Mapping[int, Array | None]:
    """The arm's joints (6,) after every motion as a controller takes them, by index; None where nobody knows them, as
    at confdata that cannot be had and behind lines that cannot be run."""
    return _walked(program, plant, _points(program, plant))[1]


def at_cycle(program: Program, plant: Plant) -> Plant:
    """The plant with its start where the steady cycle of a program begins as written; where nobody knows the arm's
    joints there, with those of its own start; there, where that is no place the axes can be at. plant: as the program
    finds it when it is started."""
    if program.before is None:
        return plant
    moves = [one for one in (*program.from_start.motions, *program.motions) if isinstance(one, Move)]
    rail = plant.start[plant.layout.rail]
    for move in moves:
        rail = plant.rail_after(move.extax, rail)
    known = (i for i in reversed(range(len(moves))) if _alone(moves[i], plant))
    walked = replace(program, motions=tuple(moves[next(known, 0) :]), before=None)
    arm = arms_as_written(walked, plant)[len(walked.motions) - 1]
    start = plant.layout.merge(rail, np.asarray(plant.start[plant.layout.arm] if arm is None else arm))
    limits = plant.limits
    if np.abs(start - start.clip(limits.lower, limits.upper)).max() > _ON_LIMIT or not limits.couplings.within(start):
        start = plant.start
    return replace(plant, start=readonly(start), home=plant.start)


def _alone(move: Move, plant: Plant) -> bool:
    """Whether a move itself says where the rail and the arm's joints are at its end."""
    fixed = isinstance(move, MoveAbsJ) or (isinstance(move, PoseMove) and demands_configuration(move, plant.robot))
    return fixed and all(move.extax[eax] is not None for eax in plant.rail_eaxes)


def unsure_nearest(program: Program, plant: Plant, plan: Plan | None = None) -> Iterator[str]:
    r"""A line where joint moves under ConfJ \Off, as written or as planned, end in the nearest configuration by one
    measure and not by another."""
    off = {i: motion for i, motion in enumerate(program.motions) if isinstance(motion, MoveJ) and _is_off(motion)}
    ends: list[tuple[int, Array, Array, Array | None]] = []
    arm, rails = plant.layout.arm, plant.layout.rail
    if plan is not None:
        planned = [one for one in plan.motions if one.index in off and not one.dropped and is_nearest(plant, one)]
        ends = [(p.index, plant.robot.forward(p.q_1), p.q_1[rails], p.q_0[arm]) for p in planned]
    elif off:
        points, arms = _points(program, plant), {-1: plant.start[arm], **arms_as_written(program, plant)}
        known = [p for p in points if p.index in off and arms[p.index] is not None]
        ends = [(p.index, p.X_WF, p.rail, arms[p.index - 1]) for p in known]
    doubtful = (off[i] for i, X_WF, rail, q in ends if q is not None and not is_sure(plant, X_WF, rail, q))
    if places := [*dict.fromkeys(str(motion.source) for motion in doubtful)]:
        more = f" and {len(places) - 1} more" if len(places) > 1 else ""
        yield (
            f"{places[0]}{more}: confdata is off, and which configuration is the nearest depends on how a controller"
            r" measures that, which is not published; ConfJ \On and confdata make it sure"
        )


def _points(program: Program, plant: Plant) -> list[_Point]:
    rail = plant.start[plant.layout.rail]
    points = []
    for index, motion in enumerate(program.motions):
        if isinstance(motion, Wait | SignalEvent):
            continue
        before, rail = rail, plant.rail_after(motion.extax, rail)
        if isinstance(motion, PoseMove):
            X_WF = motion.X_WT @ inverse_pose(motion.tool.X_FT)
            demanded, off = demands_configuration(motion, plant.robot), _is_off(motion)
            points.append(_Point(index, motion, X_WF, (before, rail), demanded, off))
    return [*_reached(points, plant)]


def _is_off(motion: PoseMove) -> bool:
    return not (motion.settings.conf_j if isinstance(motion, MoveJ) else motion.settings.conf_l)


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


def _reached(points: Sequence[_Point], plant: Plant) -> Iterator[_Point]:
    """The points with what reaches them: in their own configuration, else only whether anything does."""
    low, high = plant.limits.lower[plant.layout.arm], plant.limits.upper[plant.layout.arm]
    for start in range(0, len(points), _CHUNK):
        some = points[start : start + _CHUNK]
        branches = _branches(plant, np.array([one.X_WF for one in some]), np.array([one.rail for one in some]))
        conf = np.array([one.motion.conf.numbers for one in some])[:, None]
        middle = np.broadcast_to((low + high) / 2, branches.shape).copy()
        found = _turned_to(middle, branches)
        with np.errstate(invalid="ignore"):
            reachable = np.all((found >= low - ON_LIMIT) & (found <= high + ON_LIMIT), axis=-1)
            middle[..., [0, 3, 5]] = (conf[..., :3] + 0.5) * (pi / 2)
            found = _turned_to(middle, branches)
            ok = np.all((found >= low - ON_LIMIT) & (found <= high + ON_LIMIT), axis=-1)
        ok &= confdata_admits(plant.robot, conf, found)
        # where two branches meet, the one that is named
        own = np.equal(np.arange(branches.shape[1]) % 8, conf[..., 3])
        branch = np.argmax(ok.astype(np.intp) + (ok & own), axis=1)
        for k, one in enumerate(some):
            q = found[k, branch[k]] if ok[k].any() else None
            yield replace(one, reachable=bool(reachable[k].any()), q=q)


def _turned_to(middle: Array, q: Array) -> Array:
    """Joints by whole turns as near as can be to others."""
    return np.asarray(q + 2 * np.pi * np.round((middle - q) / (2 * np.pi)))


def _branches(plant: Plant, X_WF: Array, rail: Array) -> Array:
    """All branches (n, 8, 6) of poses, NaN rows also where a rail (n, r) is outside its stroke, or no turn of the
    joints keeps the ranges of their sums."""
    if not plant.robot.has_rail:
        return inverse(plant.robot, X_WF)
    q = np.array(inverse(plant.robot, X_WF, rail))
    low, high = plant.limits.lower[plant.layout.rail], plant.limits.upper[plant.layout.rail]
    q[((rail < low - ON_LIMIT) | (rail > high + ON_LIMIT)).any(axis=1)] = np.nan
    couplings = plant.limits.couplings.arm(plant.layout.arm)
    if couplings:
        lower, upper = (ends[plant.layout.arm] for ends in (plant.limits.lower, plant.limits.upper))
        for place in np.ndindex(q.shape[:2]):
            if not couplings.within(representatives(q[place], lower, upper)).any():
                q[place] = np.nan
    return q


def reachable_confdata(plant: Plant, X_WF: Array, rail: Array | float | None, asked: ConfData) -> tuple[ConfData, ...]:
    """Every confdata to be had at a pose, the nearest to what is asked first."""
    found = np.unique(confdata_numbers(plant.robot, postures(plant, X_WF, rail)), axis=0)
    apart = np.abs(found - asked.numbers)
    order = np.lexsort((*found.T[::-1], apart.sum(axis=1), np.count_nonzero(apart, axis=1)))
    return tuple(ConfData(*conf) for conf in found[order].tolist())


def listed(confs: Sequence[ConfData]) -> str:
    """What can be reached, in words."""
    more = f" and {len(confs) - _LISTED} more" if len(confs) > _LISTED else ""
    return f"reachable with {', '.join(map(shown, confs[:_LISTED]))}{more}"


# -------------------------------------------------------------------------------------------------------- the lines


def _walked(
    program: Program, plant: Plant, points: Sequence[_Point]
) -> tuple[dict[int, tuple[Array, Followed | None]], dict[int, Array | None]]:
    r"""The lines and arcs whose start joints are known, with these, followed, by index of the motion; and the arm's
    joints after every motion, None for unknown.

    A line under ConfL \Off is first taken to end nearest to its start; where it leads elsewhere all behind it is walked
    once more.
    """
    known: dict[int, tuple[Array, Followed | None]] = {}
    while True:
        ends, lines = _walk(program, plant, points, known)
        new = {i: line for i, line in lines.items() if i not in known or np.abs(known[i][0] - line.q).max() > _SAME}
        if not new:
            return {i: known[i] for i in lines}, ends
        for (i, line), along in zip(new.items(), follow(plant, [*new.values()]), strict=True):
            known[i] = line.q, along


def _walk(
    program: Program,
    plant: Plant,
    points: Sequence[_Point],
    known: Mapping[int, tuple[Array, Followed | None]],
) -> tuple[dict[int, Array | None], dict[int, ArmPath]]:
    """The arm's joints after every motion, and the lines and arcs from known joints. known: lines that were followed,
    and from where."""
    at = {point.index: point for point in points}
    ends: dict[int, Array | None] = {}
    lines: dict[int, ArmPath] = {}
    now: Array | None = plant.start[plant.layout.arm]
    rail = plant.start[plant.layout.rail]
    X_WF: Array | None = None  # the flange as programmed; None where only the joints tell
    for index, motion in enumerate(program.motions):
        if isinstance(motion, MoveAbsJ):
            now, X_WF = motion.q, None
        elif isinstance(motion, MoveExtJ):  # the arm holds
            X_WF = None
        elif isinstance(motion, PoseMove):
            point, along = at[index], None
            if isinstance(motion, PathMove) and _can_follow(point) and now is not None:
                if X_WF is None:
                    X_WF = plant.robot.forward(plant.layout.merge(rail, now))
                with suppress(InputError):  # no circle: a refusal of its own
                    path = segment_of(motion, X_WF @ motion.tool.X_FT)
                    lines[index] = ArmPath(path, motion.tool.X_FT, point.rails, now)
                    start, found = known.get(index, (now, None))
                    along = found if np.abs(start - now).max() <= _SAME else None
            now, X_WF = _after(point, plant, now, along), point.X_WF
        if isinstance(motion, Move):
            rail = plant.rail_after(motion.extax, rail)
        ends[index] = now
    return ends, lines


def _can_follow(point: _Point) -> bool:
    """Whether a path lies still and leads into reach, and its configuration does not stay open."""
    motion = point.motion
    return point.reachable and (point.demanded or point.off) and not (motion.tool.stationary or turned_under(motion))


def _after(point: _Point, plant: Plant, now: Array | None, along: Followed | None) -> Array | None:
    """Arm joints after a move: as programmed, where its line leads, or the nearest; None for unknown."""
    if point.demanded:
        return point.q
    if now is None or not point.off or (along is not None and not along.whole):
        return None
    if along is not None:
        return along.end
    return next(iter(nearest(plant, point.X_WF, point.rail, now[None])), None)


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
    return f"[{','.join(map(str, conf.numbers))}]"


def _where(point: _Point, plant: Plant) -> str:
    return plant.at_rail(point.rail)


def _unreachable(point: _Point, plant: Plant) -> ConfigurationFinding:
    why = why_unreachable(plant.robot, point.X_WF, point.rail, plant.limits)
    return _finding(point, plant, Misfit.POSE, f"cannot be reached{_where(point, plant)}: {why}")


def _not_as_written(point: _Point, plant: Plant, along: Followed | None) -> ConfigurationFinding:
    others = reachable_confdata(plant, point.X_WF, point.rail, point.motion.conf)
    text = f"cannot be reached in confdata {shown(point.motion.conf)}{_where(point, plant)}; {listed(others)}"
    if along is not None and along.whole:
        leads = confdata(plant.robot, along.end)
        others = (leads, *(conf for conf in others if conf != leads))
        text += f"; the line leads to {shown(leads)}"
    return _finding(point, plant, Misfit.CONFDATA, text, others)


def _misled(point: _Point, plant: Plant, along: Followed) -> ConfigurationFinding | None:
    """What is wrong with a line to a point that can be reached as programmed; None for nothing."""
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
    q = point.q if point.demanded else None
    if q is None or np.abs(along.end - q).max() <= _SAME or confdata_admits(plant.robot, point.motion.conf, along.end):
        return None
    leads = confdata(plant.robot, along.end)
    turns = ", ".join(
        f"{axis} by {np.degrees(value):+.0f}°"
        for axis, value in zip(names, q - along.end, strict=True)
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
