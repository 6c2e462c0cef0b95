"""The tool's way that a motion of a program prescribes."""

from __future__ import annotations

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import MoveC, MoveL, Wait
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.carried import Carried
from trajopt_cli.path.dwell import Dwell
from trajopt_cli.path.line import Line


def segment_of(motion: MoveL | MoveC | Wait, X_WT: Array) -> Line | Arc | Dwell | Carried:
    """The way from X_WT (4, 4), where the motion's tool stands before it.

    Of other motions only the robot knows the tool's way.

    Raises:
        InputError: a MoveC whose three points make no circle, with its place in the program.
    """
    match motion:
        case Wait():
            return Dwell(X_WT)
        case MoveL():
            return _carried(motion, X_WT) if motion.tool.stationary else Line(X_WT, motion.X_WT)
        case MoveC():
            try:
                if motion.tool.stationary:
                    return _carried(motion, X_WT)
                return Arc.through(X_WT, motion.X_WV[:3, 3], motion.X_WT)
            except InputError as error:
                file, line, column = motion.source
                raise InputError(f"MoveC {motion.target}: {error}", file=file, line=line, column=column) from error


def _carried(motion: MoveL | MoveC, X_WT: Array) -> Carried:
    X_FT = motion.tool.X_FT
    return Carried.to(X_WT @ inverse_pose(X_FT), motion.X_WT, X_FT, motion.X_WV if isinstance(motion, MoveC) else None)
