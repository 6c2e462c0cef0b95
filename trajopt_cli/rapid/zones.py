"""How large the corners of fly-by points really are: a zone ends at the middle of the way to the next point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import dist

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import (
    NO_EXTERNAL_AXES,
    ExternalAxes,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    SignalEvent,
    Tool,
    Wait,
)
from trajopt_cli.path.circle import Point, arc_length, circle_through


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


def ways(program: Program, kinematics: Kinematics | None = None) -> list[float | None]:
    """Length [m] of the tool's way over the work to the end of each motion, in the order of program.motions.

    Of MoveJ as if it were a line. None for what is no move to a pose, and where the start is not known: at the
    beginning and after moves to joints only kinematics tell it.
    """
    out: list[float | None] = []
    place, extax = None, NO_EXTERNAL_AXES
    if kinematics is not None:
        q, extax = kinematics.start
        place = _Place(kinematics.forward(q, extax), None)
    for motion in program.motions:
        match motion:
            case Wait() | SignalEvent():
                out.append(None)
                continue
            case MoveJ() | MoveL() | MoveC():
                out.append(None if place is None else _length(motion, place))
                place = _Place(motion.X_WT, motion.tool)
            case MoveAbsJ() | MoveExtJ():
                out.append(None)
                place = None
        if kinematics is not None:
            extax = _taken_over(extax, motion.extax)
            if isinstance(motion, MoveAbsJ):
                place = _Place(kinematics.forward(motion.q, extax), None)
    return out


def effective_radii(program: Program, lengths: Sequence[float | None] | None = None) -> tuple[float | None, ...]:
    """The radius [m] of the corner at the end of each motion, in the order of program.motions.

    At most half the way from the point before and half the way to the next one, arcs along the arc; 0 at a stop, at the
    last move, before a wait, and for what is no move. None for a fly-by whose own place, or a neighbour's, only the
    robot knows (MoveAbsJ, MoveExtJ). Signals between two moves change nothing: they are set on the way. lengths: what
    ways() gives, if it is known already.
    """
    lengths = ways(program) if lengths is None else lengths
    radii: list[float | None] = [0.0] * len(program.motions)
    way_in: float | None = None  # from the point before to the point at last; None where nobody knows
    last: tuple[int, float] | None = None  # a fly-by that waits for its way out: index, radius
    for index, motion in enumerate(program.motions):
        match motion:
            case SignalEvent():
                continue
            case Wait():
                if motion.duration > 0 or motion.condition is not None:
                    last = None  # radii holds 0 for it
                continue
        way = lengths[index]
        if last is not None:
            before, wanted = last
            radii[before] = None if way is None or way_in is None else min(wanted, way / 2, way_in / 2)
        way_in = way
        last = None if motion.zone.stop else (index, motion.zone.radius)
    return tuple(radii)


def _length(motion: MoveJ | MoveL | MoveC, place: _Place) -> float:
    start = _point(place.seen_by(motion.tool)[:3, 3])
    end = _point(motion.X_WT[:3, 3])
    if isinstance(motion, MoveC) and not motion.tool.stationary:  # else the work moves: its points pass the tool
        course = circle_through(start, _point(motion.X_WV[:3, 3]), end)
        if course is not None:
            return arc_length(course, start)
    return dist(start, end)


def _taken_over(before: ExternalAxes, given: ExternalAxes) -> ExternalAxes:
    a, b, c, d, e, f = (old if new is None else new for old, new in zip(before, given, strict=True))
    return (a, b, c, d, e, f)


def _point(p: Array) -> Point:
    x, y, z = p.tolist()
    return x, y, z
