"""What a plan may change of a program, said once for all who ask: the optimiser, its baselines and the export.

A machine that follows a stream can be given any plan. A plan for the RAPID controller must fit into the program's text;
which motions that leaves is known to the export, before anything is planned.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import pairwise

from trajopt_cli.motion import Motion, Move, MoveAbsJ, MoveJ, Program
from trajopt_cli.problem.plant import Plant


class Loops(StrEnum):
    """What a plan for the RAPID controller makes of what runs several times."""

    KEEP = "keep"  # it stays; a statement has one rail position and configuration, but for counters of FOR loops
    UNROLL = "unroll"  # a routine has a copy for each of its calls, where these differ


@dataclass(frozen=True)
class Changes:
    """Motions, by index. values: those that can have another rail position and configuration, or, for a wait, in which
    the rail can move. ties: those of them that must have the same, as one text serves them all: all passes of a loop or
    a routine through one target. droppable: those that can be left out. kept: why the others stay as programmed, a line
    each. detours: the joint moves before which points may be added, in groups that must have the same ones, as one text
    serves them all. straight: why the other joint moves can have none, in words."""

    values: frozenset[int]
    ties: tuple[tuple[int, ...], ...] = ()
    droppable: frozenset[int] = frozenset()
    kept: tuple[str, ...] = ()
    detours: tuple[tuple[int, ...], ...] = ()
    straight: Mapping[int, str] = field(default_factory=dict)


def everything(program: Program, plant: Plant) -> Changes:
    """All that the user lets change, for a plan that nobody writes back into the program."""
    whys = {i: why_straight(motion) for i, motion in enumerate(program.motions) if isinstance(motion, MoveJ | MoveAbsJ)}
    return Changes(
        frozenset(range(len(program.motions))),
        droppable=droppable(program, plant),
        detours=tuple((i,) for i, why in whys.items() if why is None),
        straight={i: why for i, why in whys.items() if why is not None},
    )


def why_straight(motion: Motion) -> str | None:
    r"""Why a motion can have no points added before it, whatever its text looks like; None where it can."""
    if not isinstance(motion, MoveJ | MoveAbsJ):
        return "it is no joint move"
    if motion.units:
        return "a positioner turns on the way"
    if motion.identity is not None:
        return r"other robots move together with it (\ID)"
    if motion.duration is not None:
        return r"its time is programmed (\T)"
    if any(event.from_start or event.distance or event.time for event in motion.events):
        return "something is triggered on the way"
    if motion.tool.stationary or (isinstance(motion, MoveJ) and motion.X_WO is None):
        return "its tool or work object is no fixed frame"
    return None


def may_go(motion: Motion, plant: Plant) -> bool:
    """Whether the user lets a motion be left out, in the program or in the cell file."""
    asked = isinstance(motion, Move) and (motion.optional or motion.target.lower() in plant.droppable)
    return asked and getattr(motion, "identity", None) is None  # other robots wait for it


def droppable(program: Program, plant: Plant) -> frozenset[int]:
    """Motions the user lets go and that can, without moving another path: the next motion is a joint move, and no
    positioner waits for the motion. Outputs that drive the rail are no motions."""
    motions = [(i, one) for i, one in enumerate(program.motions) if not getattr(one, "drives_rail", False)]
    return frozenset(
        i
        for (i, motion), (_, following) in pairwise(motions)
        if may_go(motion, plant) and isinstance(following, MoveJ | MoveAbsJ) and not getattr(motion, "units", ())
    )
