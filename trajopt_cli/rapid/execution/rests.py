"""Waits that have begun before: a line that goes nowhere, as an export has it before a wait in which the rail moves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajopt_cli.motion import Motion, Move, MoveAbsJ, MoveL, PoseMove, Wait
from trajopt_cli.rapid.execution.context import Context

_SAME = 1e-6  # m, entries of rotations, s


def count_rests(motions: Sequence[Motion]) -> None:
    """Take the time of such a line off the least time of the wait behind it. The motions are still the run's own."""
    motions = [one for one in motions if not (isinstance(one, Wait) and one.settles)]
    for before, line, wait in zip(motions, motions[1:], motions[2:], strict=False):
        signal = isinstance(wait, Wait) and wait.condition is not None
        if signal and isinstance(before, Move) and isinstance(line, MoveL):
            assert isinstance(wait, Wait)
            left = wait.duration - _rested(before, line)
            object.__setattr__(wait, "duration", left if left > _SAME else 0.0)


def settle_before(run: Context) -> None:
    """The last motion is a line with a time: where it stands for a wait, axes settle before it as before the wait."""
    line = run.motions[-1]
    before = next((one for one in reversed(run.motions) if isinstance(one, Move) and one is not line), None)
    if isinstance(line, MoveL) and before is not None:
        run.position.place()
        if _rested(before, line):
            run.settle_stop(behind=1)
            run.unsettled, run.looked_at = None, len(run.motions)


def _rested(before: Move, line: MoveL) -> float:
    """The time [s] of a line in which one external axis alone goes elsewhere; 0 of any other."""
    if line.duration is None or line.units:
        return 0.0
    there = isinstance(before, PoseMove) and np.abs(before.X_WT - line.X_WT).max() <= _SAME
    there = there or (isinstance(before, MoveAbsJ) and "crobt(" in line.target.lower())
    others = sum(one != other for one, other in zip(before.extax, line.extax, strict=True))
    return line.duration if there and others == 1 else 0.0
