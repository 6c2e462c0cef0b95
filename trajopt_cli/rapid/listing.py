"""What `trajopt parse` shows: one row per motion, in the units of RAPID, and sums over the program."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, wxyz_from_rotation
from trajopt_cli.motion import (
    ConfData,
    ExternalAxes,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    SignalEvent,
    Source,
    Wait,
)
from trajopt_cli.units import DEG, MM


@dataclass(frozen=True)
class Row:
    """One motion. None where the motion has no such part.

    index: its place in Program.motions. target: as written; of a wait its condition, of a signal event the signal.
    position: world, mm. orientation: world, unit quaternion w x y z. joints: deg. speed: TCP speed, mm/s. duration:
    seconds of a wait, or the programmed time of a move. value: what a signal is set to.
    """

    index: int
    source: Source
    instruction: str
    target: str | None = None
    position: tuple[float, float, float] | None = None
    orientation: tuple[float, float, float, float] | None = None
    joints: tuple[float, ...] | None = None
    speed: str | None = None
    v_tcp: float | None = None
    zone: str | None = None
    stop: bool | None = None
    tool: str | None = None
    wobj: str | None = None
    extax: ExternalAxes | None = None
    conf: ConfData | None = None
    duration: float | None = None
    optional: bool = False
    value: float | None = None


@dataclass(frozen=True)
class Listing:
    """line_length: of all straight lines whose start the program tells, mm. fly_by: zones that are no stops."""

    rows: tuple[Row, ...]
    line_length: float
    fly_by: int


def describe(program: Program) -> Listing:
    """The program's motions as rows, the sum of its line lengths, and how many zones will be planned as stops.

    A line after a joint move has no start in the program's text, so its length is not counted.
    """
    rows, length, fly_by = [], 0.0, 0
    X_WF: Array | None = None  # the flange before the motion; another tool there has another centre point
    for index, motion in enumerate(program.motions):
        match motion:
            case MoveJ() | MoveL():
                if isinstance(motion, MoveL) and X_WF is not None:
                    chord = motion.X_WT[:3, 3] - (X_WF @ motion.tool.X_FT)[:3, 3]
                    length += float(np.linalg.norm(chord)) / MM
                X_WF = motion.X_WT @ inverse_pose(motion.tool.X_FT)
                row = _pose_row(index, motion)
            case MoveAbsJ() | MoveExtJ():
                X_WF = None
                row = _joint_row(index, motion)
            case Wait():
                name = _instruction(program, motion)
                row = Row(index, motion.source, name, target=motion.condition, duration=motion.duration)
            case SignalEvent():
                name = _instruction(program, motion)
                row = Row(index, motion.source, name, target=motion.signal, value=motion.value)
        fly_by += row.stop is False
        rows.append(row)
    return Listing(tuple(rows), length, fly_by)


def _instruction(program: Program, motion: Wait | SignalEvent) -> str:
    """The instruction's name as the program spells it."""
    statement = motion.written.statement
    match = re.match(r"\w+", program.files[statement.file].text[statement.start :])
    return match[0] if match else type(motion).__name__


def _pose_row(index: int, motion: MoveJ | MoveL) -> Row:
    x, y, z = (float(value) / MM for value in motion.X_WT[:3, 3])
    w, i, j, k = (float(value) for value in wxyz_from_rotation(motion.X_WT[:3, :3]))
    return Row(
        index,
        motion.source,
        type(motion).__name__,
        target=motion.target,
        position=(x, y, z),
        orientation=(w, i, j, k),
        speed=motion.speed.name,
        v_tcp=motion.speed.v_tcp / MM,
        zone=motion.zone.name,
        stop=motion.zone.stop,
        tool=motion.tool.name,
        wobj=motion.wobj,
        extax=motion.extax,
        conf=motion.conf,
        duration=motion.duration,
        optional=motion.optional,
    )


def _joint_row(index: int, motion: MoveAbsJ | MoveExtJ) -> Row:
    arm = isinstance(motion, MoveAbsJ)
    return Row(
        index,
        motion.source,
        type(motion).__name__,
        target=motion.target,
        joints=tuple(float(value) / DEG for value in motion.q) if isinstance(motion, MoveAbsJ) else None,
        speed=motion.speed.name,
        v_tcp=motion.speed.v_tcp / MM if arm else None,
        zone=motion.zone.name,
        stop=motion.zone.stop,
        tool=motion.tool.name if isinstance(motion, MoveAbsJ) else None,
        extax=motion.extax,
        duration=motion.duration,
        optional=motion.optional,
    )
