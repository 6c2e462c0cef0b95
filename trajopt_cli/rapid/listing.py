"""What `trajopt parse` shows: one row per motion, in the units of RAPID, and sums over the program."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, wxyz_from_rotation
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import (
    DEFAULT_SETTINGS,
    NO_EXTERNAL_AXES,
    ConfData,
    ExternalAxes,
    Happens,
    Hold,
    Motion,
    Move,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    PathEvent,
    PathMove,
    PoseMove,
    Program,
    Settings,
    SignalEvent,
    Singularity,
    Source,
    Wait,
    instruction_name,
)
from trajopt_cli.rapid.zones import effective_radii, fly_bys, stopped_fly_bys, ways
from trajopt_cli.units import DEG, MM

Triple = tuple[float, float, float]
_WORD = re.compile(r"\w+")


@dataclass(frozen=True)
class Row:
    """One motion in mm, deg, mm/s, deg/s. None where the motion has no such part.

    index: its place in Program.motions. instruction: as written; kind: what it is to the robot ("MoveL", "Wait",
    "SignalEvent"). target: as written; of a wait its condition, of a signal event the signal. position: world.
    orientation: world, unit quaternion w x y z. via: the point an arc goes through. joints: of the arm. speed, zone:
    their names. v_tcp and the rest: their figures, VelSet and \\V included. radius: programmed, of a fly-by;
    effective_radius: what the ways to its neighbours leave of it, 0 at a stop, None where only the robot tells, and
    between turns in place, where the zone is effective_angle (deg).
    stop_reason: why a fly-by is a stop all the same. extax: mm or deg; extax_kept: where axes stand meanwhile that the
    robot has and extax leaves open. duration: seconds of a wait (at least, where a condition ends it), or the
    programmed time of a move. value: what a signal is set to. length: of a line or an arc whose start is known.
    settings: what differs from the default, by the name of the instruction. process: what an instruction of a process
    has besides, by parameter. hold: why the rail stands still. constant_speed:
    whether its programmed speed should be kept from end to end. detour: around what an additional point leads. beside:
    seconds of a wait that runs beside the move before it, of which duration is then left at its end.
    """

    index: int
    source: Source
    instruction: str
    kind: str
    target: str | None = None
    position: Triple | None = None
    orientation: tuple[float, float, float, float] | None = None
    via: Triple | None = None
    joints: tuple[float, ...] | None = None
    speed: str | None = None
    v_tcp: float | None = None
    v_ori: float | None = None
    v_leax: float | None = None
    v_reax: float | None = None
    zone: str | None = None
    stop: bool | None = None
    criterion: str | None = None
    radius: float | None = None
    effective_radius: float | None = None
    effective_angle: float | None = None
    stop_reason: str | None = None
    tool: str | None = None
    wobj: str | None = None
    extax: ExternalAxes | None = None
    extax_kept: ExternalAxes | None = None
    conf: ConfData | None = None
    duration: float | None = None
    value: float | None = None
    length: float | None = None
    optional: bool = False
    settings: Mapping[str, Any] = field(default_factory=dict)
    events: tuple[PathEvent, ...] = ()
    process: tuple[tuple[str, str], ...] = ()
    hold: Hold | None = None
    constant_speed: bool = False
    detour: tuple[str, ...] = ()
    beside: float | None = None


@dataclass(frozen=True)
class Listing:
    """line_length, arc_length: of all lines and arcs whose start is known, mm; unmeasured: how many are not.

    fly_by: zones that are no stops.
    """

    rows: tuple[Row, ...]
    line_length: float
    arc_length: float
    unmeasured: int
    fly_by: int


def describe(program: Program, kinematics: Kinematics | None = None) -> Listing:
    """The program's motions as rows, and sums over them.

    A line after a joint move has no start in the program's text; only kinematics tell it.
    """
    lengths = ways(program, kinematics)
    quaternions = _quaternions(program.motions)
    spelled = _Spelling(program)
    radii = effective_radii(program, lengths)
    stopped = stopped_fly_bys(program, kinematics, lengths)
    zones = fly_bys(program, kinematics, lengths) if None in radii else {}
    settings: dict[int, dict[str, Any]] = {}  # by identity: thousands of motions share one
    at = NO_EXTERNAL_AXES if kinematics is None else kinematics.start[1]
    rows = []
    for index, motion in enumerate(program.motions):
        if isinstance(motion, Wait):
            row = Row(
                index, motion.source, _instruction(program, motion), "Wait",
                target=motion.condition, duration=motion.duration, hold=motion.hold, beside=motion.beside,
            )  # fmt: skip
        elif isinstance(motion, SignalEvent):
            row = Row(
                index, motion.source, _instruction(program, motion), "SignalEvent",
                target=spelled.signal(motion.signal, motion), value=motion.value,
            )  # fmt: skip
        else:
            known = settings.get(id(motion.settings))
            if known is None:
                known = settings[id(motion.settings)] = differing(motion.settings)
            if motion.identity is not None:
                known = known | {"ID": motion.identity}
            row = _move_row(index, motion, quaternions.get(index), lengths[index], radii[index], known)
            if motion.events:
                row = replace(row, events=tuple(spelled.event(event, motion) for event in motion.events))
            if index in zones and zones[index].in_place:
                row = replace(row, effective_angle=zones[index].turning / DEG)
            if index in stopped:
                row = replace(row, stop_reason=stopped[index])
            kept = tuple(old if new is None else None for old, new in zip(at, motion.extax, strict=True))
            if any(value is not None for value in kept):
                row = replace(row, extax_kept=kept)
            # of the robot's own axes; those that it does not have stay None
            moved = zip(at, motion.extax, strict=True)
            at = tuple(old if new is None or old is None else new for old, new in moved)
        rows.append(row)
    lines = sum(row.length for row in rows if row.kind == "MoveL" and row.length is not None)
    arcs = sum(row.length for row in rows if row.kind == "MoveC" and row.length is not None)
    unmeasured = sum(row.kind in ("MoveL", "MoveC") and row.length is None for row in rows)
    return Listing(tuple(rows), lines, arcs, unmeasured, sum(row.stop is False for row in rows))


def differing(settings: Settings) -> dict[str, Any]:
    """What differs from the default, by the name of the instruction that sets it, in its own units."""
    out: dict[str, Any] = {}
    for word, on in (("ConfJ", settings.conf_j), ("ConfL", settings.conf_l)):
        if not on:
            out[word] = "Off"
    if settings.singularity is not Singularity.OFF:
        out["SingArea"] = settings.singularity.value
    if settings.circle is not DEFAULT_SETTINGS.circle:
        out["CirPathMode"] = settings.circle.value
    if (settings.acceleration, settings.ramp) != (1.0, 1.0):
        out["AccSet"] = [settings.acceleration * 100, settings.ramp * 100]
    if (settings.path_acceleration, settings.path_deceleration) != (None, None):
        out["PathAccLim"] = [settings.path_acceleration, settings.path_deceleration]
    if settings.world_acceleration is not None:
        out["WorldAccLim"] = settings.world_acceleration
    if settings.override != 1.0 or settings.v_max is not None:
        out["VelSet"] = [settings.override * 100, None if settings.v_max is None else settings.v_max / MM]
    if settings.load is not None:
        out["GripLoad"] = settings.load.name
    if any(settings.eax_offset):
        out["EOffs"] = list(settings.eax_offset)
    if settings.displaced:
        out["PDisp"] = "On"
    return out


class _Spelling:
    """Signals as the program spells them; the run knows them in lower case only."""

    def __init__(self, program: Program):
        self._files = program.files
        self._known: dict[str, str] = {}

    def signal(self, name: str, motion: Motion) -> str:
        """As its first statement has it, else as any file has it first; lower case where none does (an alias' own)."""
        found = self._known.get(name)
        if found is None:
            span = motion.written.statement
            texts = [self._files[span.file].text[span.start : span.end]]
            texts += [file.text for file in self._files.values()]
            word = re.compile(rf"\b{re.escape(name)}\b", re.IGNORECASE)
            found = next((match[0] for text in texts if (match := word.search(text))), name)
            self._known[name] = found
        return found

    def event(self, event: PathEvent, motion: Motion) -> PathEvent:
        if event.kind is not Happens.SIGNAL:
            return event
        return replace(event, name=self.signal(event.name, motion))


def _instruction(program: Program, motion: Wait | SignalEvent) -> str:
    """The instruction's name as the program spells it."""
    statement = motion.written.statement
    match = _WORD.match(program.files[statement.file].text, statement.start)
    return match[0] if match else type(motion).__name__


def _quaternions(motions: Sequence[Motion]) -> dict[int, list[float]]:
    """Orientation w x y z by index, of all poses at once."""
    poses = {i: m.X_WT for i, m in enumerate(motions) if isinstance(m, PoseMove)}
    if not poses:
        return {}
    return dict(zip(poses, wxyz_from_rotation(np.array([*poses.values()])[:, :3, :3]).tolist(), strict=True))


def _point(p: Array) -> Triple:
    x, y, z = p.tolist()
    return (x / MM, y / MM, z / MM)


def _move_row(
    index: int,
    motion: Move,
    quaternion: list[float] | None,
    length: float | None,
    effective: float | None,
    settings: Mapping[str, Any],
) -> Row:
    pose = motion if isinstance(motion, PoseMove) else None
    w, x, y, z = quaternion or (0.0,) * 4
    speed, zone = motion.speed, motion.zone
    return Row(
        index,
        motion.source,
        instruction_name(motion),
        type(motion).__name__,
        target=motion.target,
        position=None if pose is None else _point(pose.X_WT[:3, 3]),
        orientation=None if pose is None else (w, x, y, z),
        via=_point(motion.X_WV[:3, 3]) if isinstance(motion, MoveC) else None,
        joints=tuple(value / DEG for value in motion.q.tolist()) if isinstance(motion, MoveAbsJ) else None,
        speed=speed.name,
        v_tcp=None if isinstance(motion, MoveExtJ) else speed.v_tcp / MM,
        v_ori=None if isinstance(motion, MoveExtJ) else speed.v_ori / DEG,
        v_leax=speed.v_leax / MM,
        v_reax=speed.v_reax / DEG,
        zone=zone.name,
        stop=zone.stop,
        criterion=zone.criterion,
        radius=None if zone.stop else zone.radius / MM,
        effective_radius=None if effective is None else effective / MM,
        tool=None if isinstance(motion, MoveExtJ) else motion.tool.name,
        wobj=None if isinstance(motion, MoveExtJ) else motion.wobj,
        extax=motion.extax,
        conf=None if pose is None else pose.conf,
        duration=motion.duration,
        length=length / MM if length is not None and isinstance(motion, PathMove) else None,
        optional=motion.optional,
        settings=settings,
        events=motion.events,
        process=motion.process.data if motion.process else (),
        hold=motion.hold,
        constant_speed=motion.constant_speed,
        detour=motion.marked,
    )
