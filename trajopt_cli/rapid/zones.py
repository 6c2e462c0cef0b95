"""How large the corners of fly-by points really are: a zone ends at the middle of the way to the next point."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Motion, MoveAbsJ, MoveC, MoveExtJ, MoveJ, MoveL, Program, SignalEvent, Wait
from trajopt_cli.rapid.data.courses import arc, radius
from trajopt_cli.rapid.data.frames import Vector


def effective_radii(program: Program) -> tuple[float | None, ...]:
    """The radius [m] of the corner at the end of each motion, in the order of program.motions.

    At most half the way from the point before and half the way to the next one, arcs along the arc; 0 at a stop, at the
    last move, before a wait, and for what is no move. None for a fly-by whose own place, or a neighbour's, only the
    robot knows (MoveAbsJ, MoveExtJ). Signals between two moves change nothing: they are set on the way.
    """
    radii: list[float | None] = [0.0] * len(program.motions)
    way_in: float | None = None  # from the point before to the point at last; None where nobody knows
    last: tuple[int, float] | None = None  # a fly-by that waits for its way out: index, radius
    X_WF: Array | None = None
    for index, motion in enumerate(program.motions):
        match motion:
            case SignalEvent():
                continue
            case Wait():
                if motion.duration > 0 or motion.condition is not None:
                    last = None  # radii holds 0 for it
                continue
        way = way_length(motion, X_WF)
        if last is not None:
            before, wanted = last
            radii[before] = None if way is None or way_in is None else min(wanted, way / 2, way_in / 2)
        X_WF = _flange(motion)
        way_in = way
        last = None if motion.zone.stop else (index, motion.zone.radius)
    return tuple(radii)


def _flange(motion: Motion) -> Array | None:
    """X_WF at the end of a move, None where only the robot knows."""
    match motion:
        case MoveJ() | MoveL() | MoveC():
            return motion.X_WT @ inverse_pose(motion.tool.X_FT)
        case _:
            return None


def way_length(motion: Motion, X_WF: Array | None) -> float | None:
    """Length [m] of the tool's way over the work, from the flange at X_WF to the end of a motion."""
    match motion:
        case MoveAbsJ() | MoveExtJ():
            return None
        case MoveJ() | MoveL() | MoveC() if X_WF is not None:
            if motion.tool.stationary:  # the work moves: its points pass the tool
                start, end = (inverse_pose(X_WF) @ motion.X_WT)[:3, 3], motion.tool.X_FT[:3, 3]
                via = None
            else:
                start, end = (X_WF @ motion.tool.X_FT)[:3, 3], motion.X_WT[:3, 3]
                via = motion.X_WV[:3, 3] if isinstance(motion, MoveC) else None
            course = arc(_vector(start), _vector(via), _vector(end)) if via is not None else None
            if course is not None:
                return radius(course, _vector(start)) * course.angle
            return float(np.linalg.norm(end - start))
    return None


def _vector(p: Array) -> Vector:
    x, y, z = p.tolist()
    return x, y, z
