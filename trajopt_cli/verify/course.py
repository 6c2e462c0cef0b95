"""The program as the judge reads it: points where the TCP must stop, in order, and what is held there."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import ExternalAxes, Move, MoveAbsJ, MoveExtJ, MoveJ, MoveL, Program, SignalEvent, Source, Wait
from trajopt_cli.units import MM
from trajopt_cli.verify.geometry import angle_between, inverse_pose
from trajopt_cli.verify.machine import Machine
from trajopt_cli.verify.mechanism import mechanism_of

_SAME_POINT = 1e-9  # m and rad: a line to the pose where it starts, a move of the redundant axis alone


@dataclass(frozen=True, eq=False)
class Stop:
    """Where a move ends (move None: where the program starts).

    X_WF: flange pose there, None where the joints on the way decide it (MoveExtJ, MoveAbsJ with a free rail). X_FT:
    tool in force. arm (6,) and rail: axis values the program fixes, None where they are free. optional: it may be left
    out. holds: the waits that follow, with their index.
    """

    index: int
    move: Move | None
    source: Source | None
    name: str
    X_WF: Array | None
    X_FT: Array
    arm: Array | None
    rail: float | None
    optional: bool
    holds: tuple[tuple[int, Wait], ...] = ()

    @property
    def duration(self) -> float | None:
        """The programmed time of the move, s."""
        return None if self.move is None else self.move.duration


def may_drop(program: Program, plant: Machine, index: int) -> bool:
    """Whether the user allowed motion number index to be left out."""
    if not 0 <= index < len(program.motions):
        return False
    motion = program.motions[index]
    if isinstance(motion, Wait | SignalEvent):
        return False
    return motion.optional or motion.target.lower() in plant.droppable


def stops_of(program: Program, plant: Machine, dropped: Collection[int] | None) -> list[Stop]:
    """Start and stops in program order. dropped: motions left out; None: the file may leave out optional ones."""
    moves = [m for m in program.motions if not isinstance(m, Wait | SignalEvent | MoveExtJ)]
    X_FT = np.asarray(moves[0].tool.X_FT) if moves else np.eye(4)
    mechanism = mechanism_of(plant)
    has_rail = mechanism.has_rail
    rail = float(plant.start[0]) if has_rail else None
    start = Stop(-1, None, None, "start", mechanism.flange_pose(plant.start), X_FT, plant.start[-6:], rail, False)
    stops, holds = [start], list[list[tuple[int, Wait]]]([[]])
    for i, motion in enumerate(program.motions):
        if isinstance(motion, SignalEvent) or (dropped is not None and i in dropped):
            continue
        if isinstance(motion, Wait):
            holds[-1].append((i, motion))
            continue
        name = f"{type(motion).__name__} {motion.target}"
        optional = dropped is None and may_drop(program, plant, i)
        wanted = _rail(plant, motion.extax)
        arm: Array | None = None
        X_WF: Array | None = None
        if isinstance(motion, MoveExtJ):
            if wanted is None:
                continue  # it moves no axis that this robot has
            rail = wanted
        elif isinstance(motion, MoveAbsJ):
            X_FT, arm, rail = motion.tool.X_FT, motion.q, wanted
            known = rail is not None or not has_rail
            if known:
                X_WF = mechanism.flange_pose(np.r_[[rail] if has_rail else [], arm])
        else:
            X_FT, rail = motion.tool.X_FT, wanted if plant.rail_fixed else None
            X_WF = motion.X_WT @ inverse_pose(X_FT)
        stops.append(Stop(i, motion, motion.source, name, X_WF, X_FT, arm, rail, optional))
        holds.append([])
    return [replace(stop, holds=tuple(waits)) for stop, waits in zip(stops, holds, strict=True)]


def stays(stop: Stop, X_WF_before: Array) -> bool:
    """Whether the move is a line to the pose where it starts: the TCP rests, only the redundant axis moves."""
    if not isinstance(stop.move, MoveL) or stop.X_WF is None:
        return False
    X, Y = X_WF_before @ stop.X_FT, stop.X_WF @ stop.X_FT
    angle = angle_between(X[:3, :3], Y[:3, :3])
    return bool(np.linalg.norm(X[:3, 3] - Y[:3, 3]) < _SAME_POINT and angle < _SAME_POINT)


def _rail(plant: Machine, extax: ExternalAxes) -> float | None:
    """The rail [m] that external axes ask for, None where they leave it open or there is none."""
    value = None if plant.rail_eax is None else extax[plant.rail_eax]
    return None if value is None else value * MM


def obeys_programmed_speed(stop: Stop, plant: Machine) -> bool:
    """Whether the move's programmed TCP speed and reorientation cap it.

    A programmed time replaces the speed; external axes alone know only v_leax (RAPID reference: MoveL \\T, MoveExtJ).
    """
    if stop.move is None or stop.duration is not None or isinstance(stop.move, MoveExtJ):
        return False
    return not (plant.free_speed and isinstance(stop.move, MoveJ | MoveAbsJ))
