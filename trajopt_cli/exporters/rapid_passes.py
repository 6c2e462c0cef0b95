"""Passes of a loop or a routine that one text serves: one literal, or one target declared for a computed one.

They can be given other values than programmed, but all of them the same. So a loop stays a loop, however often it runs.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence, Set

import numpy as np

from trajopt_cli.exporters.rapid_targets import PoseMove, confdata_counts
from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Motion, Move, MoveExtJ, Program, Span, Wait

_SAME = 1e-9  # m and entries of rotations: the same place

Passes = tuple[int, ...]


def passes(program: Program, bound: Set[int], computed: Set[int]) -> list[Passes]:
    """The moves that can refer to no other target, in groups that one text serves.

    bound: those moves. computed: moves that a new target can stand in for.
    """
    found: dict[Span, list[int]] = {}
    for i, motion in enumerate(program.motions):
        if isinstance(motion, Move) and i in bound:
            span = motion.written.aggregate or (motion.written.statement if i in computed else None)
            if span is not None:
                found.setdefault(span, []).append(i)
    behind = _moves_behind(program)
    return [
        tuple(group)
        for group in found.values()
        if _one_place(program, group)
        and not any(isinstance(behind[i], MoveExtJ) for i in group)
        and all(_confdata_counts(program.motions[i]) for i in group)
    ]


def resting(program: Program, dwells: Set[int], groups: Collection[Passes]) -> list[Passes]:
    """The waits that run several times in whose place one line can stand: all of them follow the same passes.

    dwells: the waits that a line can stand in for.
    """
    runs = Counter(motion.written.statement for motion in program.motions)
    group_of = {i: number for number, group in enumerate(groups) for i in group}
    found: dict[Span, list[tuple[int, int | None]]] = {}
    before: int | None = None
    for i, motion in enumerate(program.motions):
        if isinstance(motion, Move):
            before = group_of.get(i)
        elif isinstance(motion, Wait) and runs[motion.written.statement] > 1:
            found.setdefault(motion.written.statement, []).append((i, before if i in dwells else None))
    return [
        tuple(i for i, _ in waits)
        for waits in found.values()
        if waits[0][1] is not None and len({number for _, number in waits}) == 1
    ]


def _moves_behind(program: Program) -> Sequence[Move | None]:
    behind: list[Move | None] = []
    following: Move | None = None
    for motion in reversed(program.motions):
        behind.append(following)
        following = motion if isinstance(motion, Move) else following
    return behind[::-1]


def _one_place(program: Program, group: Sequence[int]) -> bool:
    """Whether all passes bring the flange to one place, with the same offset of the external axes."""
    first, *others = (program.motions[i] for i in group)
    assert isinstance(first, Move)
    for motion in others:
        assert isinstance(motion, Move)
        if type(motion) is not type(first) and not (isinstance(motion, PoseMove) and isinstance(first, PoseMove)):
            return False
        if motion.settings.eax_offset != first.settings.eax_offset or motion.extax != first.extax:
            return False
        poses = [one for one in (motion, first) if isinstance(one, PoseMove)]
        if len({one.conf for one in poses}) > 1:
            return False
        if poses and np.abs(_flange(poses[0]) - _flange(poses[-1])).max() > _SAME:
            return False
    return True


def _flange(motion: PoseMove) -> Array:
    return motion.X_WT @ inverse_pose(motion.tool.X_FT)


def _confdata_counts(motion: Motion) -> bool:
    """Whether a move needs no switch of its own to end in another configuration."""
    return not isinstance(motion, PoseMove) or confdata_counts(motion)
