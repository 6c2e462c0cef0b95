r"""Waits beside a move (\Conc): which of their time passes during the move, and what is left of it at its end.

RAPID, argument \Conc of the move instructions: what follows is executed while the robot moves, as soon as the move
starts. So a wait there costs nothing where the move lasts as long, and what is longer is waited for at the end. A
fly-by point is passed only where the wait is over when its zone begins, at the programmed speed; else it is a stop. Of
a move that starts in a corner only the way between the zones is counted: its real time is no shorter. Where the tool
turns in place, the way is the angle.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import axis_angle
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import Motion, Move, MoveAbsJ, MoveExtJ, MoveJ, Program, SignalEvent, Wait, motion_name
from trajopt_cli.rapid.zones import NO_WAY, moves_with_places, turns_in_place, ways
from trajopt_cli.scenario import Scenario
from trajopt_cli.units import MM
from trajopt_cli.warnings import ProgramWarning, WarningKind

_ROUNDING = 1e-9  # s


def laid_beside(program: Program, scenario: Scenario, kinematics: Kinematics | None) -> Program:
    r"""The program with its waits behind \Conc laid beside the moves.

    Wait.duration becomes what is left of it, Wait.in_position says where it makes a stop of a fly-by, Move.beside how
    long a move from stop to stop has to last. Reported is where more time is taken than the controller may need.
    """
    motions = [*program.motions]
    if not any(isinstance(one, Wait) and one.beside is not None for one in motions):
        return program
    lengths, still = ways(program, kinematics), set(_still(program, kinematics))
    turning = turns_in_place(program, kinematics, lengths)
    notices: dict[ProgramWarning, None] = {}
    rests, size = True, 0.0  # whether the point before is a stop for sure, and its zone [m], [rad] where it is none
    turns = False  # whether the move before turns in place: beside one that does not it ends at a stop
    for i, move in enumerate(motions):
        if isinstance(move, Wait):
            rests |= move.stops
        if isinstance(move, Wait | SignalEvent):
            continue
        rests |= isinstance(move, MoveExtJ) or bool(move.units) or turns != (i in turning)
        turns = i in turning
        zone = move.zone.ori if turns else move.zone.radius
        passed = not move.zone.stop and not isinstance(move, MoveExtJ)
        waits = _waits_beside(motions, i)
        total = sum(wait.beside or 0.0 for wait in waits.values())
        if move.optional or move.target.lower() in scenario.droppable:  # the move may be left out, its waits may not
            for k, wait in waits.items():
                motions[k] = replace(wait, beside=None)
        elif total:
            way = turning.get(i, lengths[i] or 0.0)
            rate = _least_time(move, way, move.speed.turning if turns else move.speed.v_tcp, scenario.free_speed)
            out = way - (0.0 if rests else min(size, way / 2))  # to the point
            left, stands = 0.0, passed
            if passed and total <= (out - min(zone, way / 2)) * rate + _ROUNDING:
                stands = False
            elif rests and i not in still and move.duration is None and not move.constant_speed:
                motions[i] = replace(move, beside=total)
            else:
                sure = move.duration if rests and move.duration else out * rate
                left = max(total - sure, 0.0)
            if left and not rests:
                what = f"{left:.6g} of {total:.6g} s beside {motion_name(move)} (\\Conc) are added behind it: only"
                what += " its way between the zones counts; a controller may need less"
                notices[ProgramWarning(WarningKind.ASSUMED, what, move.source)] = None
            for k, wait in reversed(waits.items()):
                own = min(left, wait.beside or 0.0)
                left -= own
                motions[k] = replace(wait, duration=own, in_position=stands)
        rests, size = not passed, zone
    return replace(program, motions=tuple(motions), warnings=(*program.warnings, *notices))


def _waits_beside(motions: Sequence[Motion], index: int) -> dict[int, Wait]:
    """The waits beside a move, by their index."""
    out: dict[int, Wait] = {}
    for k, one in enumerate(motions[index + 1 :], index + 1):
        if isinstance(one, Wait) and one.beside is not None:
            out[k] = one
        elif not isinstance(one, SignalEvent):
            break
    return out


def _least_time(move: Move, way: float, speed: float, free_speed: bool) -> float:
    """What a move takes at least per unit of its way [m], [rad], at its programmed speed; 0 where nothing caps that."""
    if move.units or way < NO_WAY or isinstance(move, MoveExtJ):
        return 0.0
    if move.duration is not None:
        return move.duration / way
    free = free_speed and isinstance(move, MoveJ | MoveAbsJ)
    return 1 / speed if speed > 0 and not free else 0.0


def _still(program: Program, kinematics: Kinematics | None) -> Iterator[int]:
    """The moves that move nothing, as far as is known: they may take no time at all."""
    for index, move, start, end, travel in moves_with_places(program, kinematics):
        if move.units or travel * MM > NO_WAY:
            continue
        if isinstance(move, MoveExtJ) or start is None or end is None:
            yield index
            continue
        X_0, X_1 = start.seen_by(move.tool), end.seen_by(move.tool)
        turned = axis_angle(X_0[:3, :3].T @ X_1[:3, :3])[1]
        if np.linalg.norm(X_1[:3, 3] - X_0[:3, 3]) < NO_WAY and turned < NO_WAY:
            yield index
