"""The tool's way that a motion of a program prescribes."""

from __future__ import annotations

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.motion import Motion, MoveC, MoveL, PathMove, Wait, turned_under
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.dwell import Dwell
from trajopt_cli.path.line import Line
from trajopt_cli.path.turning import Turn, Turning, turned_back


def segment_of(motion: PathMove | Wait, X_WT: Array) -> Line | Arc | Dwell | Turning:
    """The tool's path from X_WT (4, 4), where the motion's tool, which is on the flange, stands before it.

    Of other motions only the robot knows the tool's path.

    Raises:
        InputError: a MoveC whose three points make no circle, with its place in the program.
    """
    if isinstance(motion, Wait):
        return Dwell(X_WT)
    turns = turns_of(motion)
    X_1 = turned_back(turns, motion.X_WT)
    path: Line | Arc
    match motion:
        case MoveL():
            path = Line(X_WT, X_1)
        case MoveC():
            try:
                path = Arc.through(X_WT, turned_back(turns, motion.X_WV), X_1, motion.settings.circle)
            except InputError as error:
                file, line, column = motion.source
                raise InputError(f"MoveC {motion.target}: {error}", file=file, line=line, column=column) from error
        case _:
            raise NotImplementedError(f"no segment for {type(motion).__name__}")
    return Turning(path, turns) if turns else path


def turns_of(motion: Motion) -> tuple[Turn, ...]:
    """How positioners turn the work object under a line or an arc; of other motions nothing."""
    return tuple(Turn(np.array(unit.p), np.array(unit.u), unit.angle) for unit in turned_under(motion))
