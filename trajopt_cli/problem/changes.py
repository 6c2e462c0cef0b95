"""What a plan may change of a program, said once for all who ask: the optimiser, its baselines and the export.

A machine that follows a stream can be given any plan. A plan for the RAPID controller must fit into the program's text;
which motions that leaves is known to the export, before anything is planned.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise

from trajopt_cli.motion import Motion, Move, MoveAbsJ, MoveJ, Program
from trajopt_cli.problem.plant import Plant


class Loops(StrEnum):
    """What a plan for the RAPID controller makes of what runs several times."""

    KEEP = "keep"  # it stays, and one target has one rail position and configuration in all passes
    UNROLL = "unroll"  # where the passes differ, it is written out motion by motion, in the values of this run


@dataclass(frozen=True)
class Changes:
    """Motions, by index. values: those that can have another rail position and configuration, or, for a wait, in which
    the rail can move. ties: those of them that must have the same, as one text serves them all: all passes of a loop or
    a routine through one target. droppable: those that can be left out. kept: why the others stay as programmed, a line
    each."""

    values: frozenset[int]
    ties: tuple[tuple[int, ...], ...] = ()
    droppable: frozenset[int] = frozenset()
    kept: tuple[str, ...] = ()


def everything(program: Program, plant: Plant) -> Changes:
    """All that the user lets change, for a plan that nobody writes back into the program."""
    return Changes(frozenset(range(len(program.motions))), droppable=droppable(program, plant))


def may_go(motion: Motion, plant: Plant) -> bool:
    """Whether the user lets a motion be left out, in the program or in the cell file."""
    return isinstance(motion, Move) and (motion.optional or motion.target.lower() in plant.droppable)


def droppable(program: Program, plant: Plant) -> frozenset[int]:
    """Motions the user lets go and that can, without moving another path: the next motion is a joint move."""
    motions = program.motions
    return frozenset(
        i
        for i, (motion, following) in enumerate(pairwise(motions))
        if may_go(motion, plant) and isinstance(following, MoveJ | MoveAbsJ)
    )
