"""The tool's way that a motion of a program prescribes."""

from __future__ import annotations

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.motion import MoveC, MoveL, Wait
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.dwell import Dwell
from trajopt_cli.path.line import Line


def segment_of(motion: MoveL | MoveC | Wait, X_WT: Array) -> Line | Arc | Dwell:
    """The way from X_WT (4, 4), where the motion's tool stands before it.

    Of other motions only the robot knows the tool's way.

    Raises:
        InputError: a MoveC whose three points make no circle, with its place in the program.
    """
    match motion:
        case Wait():
            return Dwell(X_WT)
        case MoveL():
            return Line(X_WT, motion.X_WT)
        case MoveC():
            try:
                return Arc.through(X_WT, motion.X_WV[:3, 3], motion.X_WT)
            except InputError as error:
                file, line, column = motion.source
                raise InputError(f"MoveC {motion.target}: {error}", file=file, line=line, column=column) from error
