"""Which fly-by points are passed, how large their corners really are, and which are stops all the same and why.

A zone ends at the middle of the way to the next point. What is written for orientation and external axes reaches as
far as the zone of the tool centre point at least, and counts with the smallest share of the ways (RAPID, zonedata).
Between two lines that turn the tool in place the zone is an angle (zone_ori); where only one does there is none, and
where the coordinate system changes the corner is joint interpolated (RAPID reference manual, Positioning during program
execution: Corner paths when changing the interpolation method, Interpolation when changing coordinate system).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from math import dist
from typing import NamedTuple

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, axis_angle, inverse_pose
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import (
    NO_EXTERNAL_AXES,
    ExternalAxes,
    FlyBy,
    Motion,
    Move,
    MoveAbsJ,
    MoveExtJ,
    MoveL,
    PathMove,
    PoseMove,
    Program,
    SignalEvent,
    Tool,
    Wait,
    Zone,
)
from trajopt_cli.path.of_motion import segment_of, turns_of
from trajopt_cli.path.segment import POINT, Segment
from trajopt_cli.path.turning import turned_back
from trajopt_cli.rapid.execution.position import merged
from trajopt_cli.units import MM

# [m], [rad] A shorter way has no corner: seven digits of a num tell points 10 m away no better. Nor frames.
NO_WAY = 1e-6


@dataclass(frozen=True, eq=False)
class _Place:
    """Where the robot stands: X_WT of its tool, or of the flange where tool is None."""

    X_WT: Array
    tool: Tool | None

    def seen_by(self, tool: Tool) -> Array:
        """Where another tool's centre point stands meanwhile."""
        if self.tool is tool:  # most motions: nothing to multiply
            return self.X_WT
        X_WF = self.X_WT if self.tool is None else self.X_WT @ inverse_pose(self.tool.X_FT)
        return X_WF @ tool.X_FT


class _Way(NamedTuple):
    """From one point to the next, of the tool of the motion that goes there.

    length [m], angle [rad] of its reorientation, travel [m] of the external axis that goes farthest.
    """

    length: float
    angle: float
    travel: float


def ways(program: Program, kinematics: Kinematics | None = None) -> list[float | None]:
    """Length [m] of the tool's way over the work to the end of each motion, in the order of program.motions.

    Of joint moves as if they were lines. None for what moves no tool, and where an end is not known: that of the start
    and of moves to joints only kinematics tell.
    """
    out: list[float | None] = [None] * len(program.motions)
    for index, motion, start, end, _ in moves_with_places(program, kinematics):
        if start is not None and end is not None and not isinstance(motion, MoveExtJ):
            out[index] = _length(motion, start, end)
    return out


def effective_radii(program: Program, lengths: Sequence[float | None] | None = None) -> tuple[float | None, ...]:
    """The radius [m] of the corner at the end of each motion, in the order of program.motions.

    At most half the way from the point before and half the way to the next one, arcs along the arc; 0 at a stop, also
    at a fly-by that is one (see stopped_fly_bys), and for what is no move. None for a fly-by whose own place, or a
    neighbour's, only the robot knows, and between turns in place. lengths: what ways() gives, if it is known already.
    """
    lengths = ways(program) if lengths is None else lengths
    radii: list[float | None] = [0.0] * len(program.motions)
    turning = turns_in_place(program, None, lengths)
    for index, move, after, reason in _programmed(program, lengths, turning):
        if after is not None and reason is None:
            before, behind = lengths[index], lengths[after]
            if before is None or behind is None or index in turning:
                radii[index] = None
            else:
                radii[index] = min(move.zone.radius, before / 2, behind / 2)
    return tuple(radii)


def fly_bys(
    program: Program, kinematics: Kinematics | None = None, lengths: Sequence[float | None] | None = None
) -> dict[int, FlyBy]:
    """The corners of the fly-by points that are passed, by the index of the motion that ends there.

    Positions take the programmed radius; orientations path_ori, external axes path_eax, both no less than the radius;
    all at most half of the shorter way. Where ori or leax is given and a smaller share of what turns or travels on one
    of the ways, it counts instead, still no less than the radius. Travel is that of the robot's own axes, all linear,
    as programmed; kinematics tell which they are, without them there is none. Between turns in place all three are the
    angle ori [rad], at most half of the smaller turn, or leax where that is a smaller share. Points whose ways only the
    robot knows are left out. lengths: what ways() gives, if it is known already.
    """
    lengths = ways(program, kinematics) if lengths is None else lengths
    turning = turns_in_place(program, kinematics, lengths)
    found = _programmed(program, lengths, turning)
    passed = {index: (move, after) for index, move, after, reason in found if after is not None and reason is None}
    wanted = {*passed, *(after for _, after in passed.values())}
    known: dict[int, _Way] = {}
    for index, motion, start, end, travel in moves_with_places(program, kinematics):
        length = lengths[index]
        if index in wanted and length is not None and start and end and not isinstance(motion, MoveExtJ):
            known[index] = _Way(length, _angle(motion, start, end), travel)
    out = {}
    for index, (move, after) in passed.items():
        if index in known and after in known:
            zone = (_turned if index in turning else _fly_by)(move.zone, (known[index], known[after]))
            out[index] = zone._replace(joint=changes_frame(move, program.motions[after]))
    return out


def stopped_fly_bys(
    program: Program, kinematics: Kinematics | None = None, lengths: Sequence[float | None] | None = None
) -> dict[int, str]:
    """Why a programmed fly-by is a stop, in words, by the index of its motion; those that are passed are left out.

    Without kinematics a point is taken to be passed where only they tell that no way leads to it or on from it.
    lengths: what ways() gives, if it is known already.
    """
    lengths = ways(program, kinematics) if lengths is None else lengths
    found = _programmed(program, lengths, turns_in_place(program, kinematics, lengths))
    return {index: reason for index, _, _, reason in found if reason is not None}


def turns_in_place(
    program: Program, kinematics: Kinematics | None, lengths: Sequence[float | None]
) -> dict[int, float]:
    """The lines on which the tool turns and its centre point stands, by their index: how far [rad]."""
    short = {index for index, length in enumerate(lengths) if length is not None and length < NO_WAY}
    if not any(isinstance(program.motions[index], MoveL) for index in short):
        return {}
    out = {}
    for index, motion, start, end, _ in moves_with_places(program, kinematics):
        if index in short and isinstance(motion, MoveL) and start is not None and end is not None:
            R_0, R_1 = start.seen_by(motion.tool)[:3, :3], end.seen_by(motion.tool)[:3, :3]
            if (angle := axis_angle(R_0.T @ R_1)[1]) > NO_WAY:
                out[index] = angle
    return out


def changes_frame(move: Motion, after: Motion) -> bool:
    """Whether the corner between two moves is joint interpolated as the coordinate system changes there: another tool
    centre point, or between lines and arcs another work object.

    By their frames, not by their names; a program displacement is no other work object. Held work objects have no
    frame in the world: their names tell.
    """
    if isinstance(move, MoveExtJ | Wait | SignalEvent) or isinstance(after, MoveExtJ | Wait | SignalEvent):
        return False
    if not _same(move.tool, after.tool):
        return True
    if not isinstance(move, PathMove) or not isinstance(after, PathMove):
        return False
    alike = move.wobj.lower() == after.wobj.lower()
    if move.X_WO is None or after.X_WO is None:
        return not alike
    displaced = move.settings.displaced or after.settings.displaced
    return not (alike and displaced) and bool(np.abs(move.X_WO - after.X_WO).max() > NO_WAY)


def _fly_by(zone: Zone, sides: tuple[_Way, _Way]) -> FlyBy:
    half = min(way.length for way in sides) / 2
    radius = min(zone.radius, half)

    def reach(path: float, size: float, turns: Sequence[float]) -> float:
        shares = [size / turn * way.length for turn, way in zip(turns, sides, strict=True) if size > 0 and turn > POINT]
        return max(radius, min(max(path, zone.radius), half, *shares))

    turning = reach(zone.path_ori, zone.ori, [way.angle for way in sides])
    return FlyBy(radius, turning, reach(zone.path_eax, zone.leax, [way.travel for way in sides]))


def _turned(zone: Zone, sides: tuple[_Way, _Way]) -> FlyBy:
    """Between two turns in place."""
    shares = [zone.leax / way.travel * way.angle for way in sides if zone.leax > 0 and way.travel > POINT]
    angle = min(zone.ori, *(way.angle / 2 for way in sides), *shares)
    return FlyBy(angle, angle, angle, in_place=True)


def _programmed(
    program: Program, lengths: Sequence[float | None], turning: Mapping[int, float]
) -> Iterator[tuple[int, Move, int | None, str | None]]:
    """Every programmed fly-by: index and move, the index of the next move, and why it is a stop, None where passed.
    turning: the lines that turn the tool in place.

    Signals between two moves change nothing: they are set on the way.
    """
    last: tuple[int, Move] | None = None  # a fly-by that waits for its way out
    for index, motion in enumerate(program.motions):
        match motion:
            case SignalEvent():
                continue
            case Wait():
                if last is not None and motion.stops:
                    why = "a wait follows" if motion.beside is None else "a wait beside its move lasts longer"
                    yield *last, None, why
                    last = None
                continue
        if last is not None:
            in_place = last[0] in turning and index in turning
            yield *last, index, _reason(last[1], motion, lengths[last[0]], lengths[index], in_place)
        last = None if motion.zone.stop else (index, motion)
    if last is not None:
        yield *last, None, "no move follows"


def _reason(move: Move, after: Move, way_in: float | None, way_out: float | None, in_place: bool) -> str | None:
    """Why the end of a move is a stop although another move follows. in_place: both only turn the tool."""
    if isinstance(move, MoveExtJ) or isinstance(after, MoveExtJ):
        return f"external axes alone move {'to it' if isinstance(move, MoveExtJ) else 'next'}"
    if move.units or after.units:
        return f"a positioner turns {'on the way to it' if move.units else 'next'}"
    if in_place:
        return None if move.zone.ori > 0 else "its zone is 0 deg"
    if move.zone.radius == 0:
        return "its zone is 0 mm"
    if way_in is not None and way_in < NO_WAY:
        return "its move has no length"
    if way_out is not None and way_out < NO_WAY:
        return "the next move has no length"
    return None


def _same(a: Tool, b: Tool) -> bool:
    """Whether two motions have one tool centre point; a stationary tool is made anew for every target."""
    if a is b or a.stationary or b.stationary:
        return a.stationary == b.stationary and a.name == b.name
    return np.array_equal(a.X_FT, b.X_FT)


def moves_with_places(
    program: Program, kinematics: Kinematics | None
) -> Iterator[tuple[int, Move, _Place | None, _Place | None, float]]:
    """Every move: its index, where the robot stands before and after it, and the external axes' travel [m]."""
    place, extax = None, NO_EXTERNAL_AXES
    if kinematics is not None:
        q, extax = kinematics.start
        place = _Place(kinematics.forward(q, extax), None)
    for index, motion in enumerate(program.motions):
        if isinstance(motion, Wait | SignalEvent):
            continue
        start, before, extax = place, extax, merged(extax, motion.extax)
        match motion:
            case PoseMove():
                place = _Place(motion.X_WT, motion.tool)
            case MoveAbsJ():
                place = None if kinematics is None else _Place(kinematics.forward(motion.q, extax), None)
            case MoveExtJ():
                place = None if kinematics is None or place is None else _carried(kinematics, place, before, extax)
        yield index, motion, start, place, _travel(kinematics, before, extax)


def _carried(kinematics: Kinematics, place: _Place, before: ExternalAxes, extax: ExternalAxes) -> _Place:
    """Where an arm stands that external axes took along: they move every pose of it alike."""
    q, _ = kinematics.start
    X_01 = kinematics.forward(q, extax) @ inverse_pose(kinematics.forward(q, before))
    return _Place(X_01 @ place.X_WT, place.tool)


def _travel(kinematics: Kinematics | None, before: ExternalAxes, extax: ExternalAxes) -> float:
    if kinematics is None:
        return 0.0
    own = zip(kinematics.start[1], before, extax, strict=True)
    return max((abs(b - a) * MM for has, a, b in own if has is not None and a is not None and b is not None), default=0)


def _length(motion: PoseMove | MoveAbsJ, before: _Place, after: _Place) -> float:
    if curve := _curve(motion, before):
        return curve.length
    X_1 = turned_back(turns_of(motion), after.seen_by(motion.tool))  # as a table under it stands at the start
    return dist(before.seen_by(motion.tool)[:3, 3].tolist(), X_1[:3, 3].tolist())


def _angle(motion: PoseMove | MoveAbsJ, before: _Place, after: _Place) -> float:
    """Reorientation [rad] on the way."""
    if curve := _curve(motion, before):
        return curve.angle
    return axis_angle(before.seen_by(motion.tool)[:3, :3].T @ after.seen_by(motion.tool)[:3, :3])[1]


def _curve(motion: PoseMove | MoveAbsJ, before: _Place) -> Segment | None:
    """The path of a motion that prescribes another one than a line."""
    if isinstance(motion, PathMove) and not isinstance(motion, MoveL) and not motion.tool.stationary:
        with suppress(InputError):  # what is no circle is refused where it is planned
            return segment_of(motion, before.seen_by(motion.tool))
    return None  # of a stationary tool the work moves: its points pass the tool
