"""The tool's path that a motion of a program prescribes."""

from __future__ import annotations

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.motion import Motion, MoveC, MoveL, PathMove, turned_under
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.line import Line
from trajopt_cli.path.segment import Segment
from trajopt_cli.path.turning import Turn, Turning, turned_back


def segment_of(motion: PathMove, X_WT: Array) -> Segment:
    """The tool's path from X_WT (4, 4), where the motion's tool, which is on the flange, stands before it.

    Raises:
        InputError: there is none, as of a MoveC whose three points make no circle; with its place in the program.
    """
    turns = turns_of(motion)
    try:
        path = _path(motion, X_WT, turns)
    except InputError as error:
        file, line, column = motion.source
        name = type(motion).__name__
        raise InputError(f"{name} {motion.target}: {error}", file=file, line=line, column=column) from error
    return Turning(path, turns) if turns else path


def _path(motion: PathMove, X_0: Array, turns: tuple[Turn, ...]) -> Segment:
    """The same where positioners keep the work object as it stands at the start."""
    X_1 = turned_back(turns, motion.X_WT)
    match motion:
        case MoveL():
            return Line(X_0, X_1)
        case MoveC():
            return Arc.through(X_0, turned_back(turns, motion.X_WV), X_1, motion.settings.circle)
    raise NotImplementedError(f"no segment for {type(motion).__name__}")


def turns_of(motion: Motion) -> tuple[Turn, ...]:
    """How positioners turn the work object under a path; of other motions nothing."""
    return tuple(map(Turn.of, turned_under(motion)))
