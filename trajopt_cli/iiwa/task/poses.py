"""Where a task's poses come from: its own list, or the MoveL motions of a RAPID program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, radians, sqrt
from pathlib import Path

import numpy as np

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import angles_of
from trajopt_cli.iiwa.task.document import ForceSection, PoseSection
from trajopt_cli.iiwa.task.model import AngleMeaning, Force, PathPoints, Waypoint
from trajopt_cli.motion import (
    FlyBy,
    Motion,
    MoveJ,
    MoveL,
    PathMove,
    PoseMove,
    Program,
    SignalEvent,
    Singularity,
    Source,
    Wait,
    instruction_name,
)
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.path.segment import Segment
from trajopt_cli.rapid.language.text import read_text
from trajopt_cli.rapid.reader import try_program
from trajopt_cli.rapid.zones import fly_bys
from trajopt_cli.yaml_file import line_of

_SHARE = 0.1  # of the tolerance that a chord may be away from its curve
_TURN = radians(2.0)  # from pose to pose at most, where orientations are to follow the program's
_FEWEST = 8  # pieces of a corner


def chain_of(
    moves: Sequence[PoseMove], zones: Mapping[int, FlyBy], tolerance: float
) -> tuple[Array, list[int], list[int]]:
    """Poses (n, 4, 4) of the tool from the first move's end to the last's, each within a tenth of tolerance [m] of the
    way; to which move each belongs; and which of them is the end of each move, that of a corner its middle.

    zones: the corners that are driven at ends of moves. Raises InputError for a MoveC whose points make no circle.
    """
    X, of, ends = [moves[0].X_WT[None]], [0], [0]
    ways: list[Segment] = []
    for before, move in pairwise(moves):
        assert isinstance(move, PathMove)
        ways.append(segment_of(move, before.X_WT))
    entered = 0.0
    for k, way in enumerate(ways, start=1):
        corner = None
        if k in zones and k < len(ways):
            corner = Corner.of_zone(way, ways[k], zones[k].radius, zones[k].turning)
        left = 1.0 - (corner.fraction_before if corner else 0.0)
        if left > entered:
            part = left - entered  # cut by how far chords are from it, and by what they turn
            count = max(1, ceil(way.angle * part / _TURN), ceil(part * _chords(way, tolerance)))
            shares = entered + (left - entered) * np.arange(1, count + 1) / count
            X.append(way.pose(shares))
            of += [k] * count
        if corner is None:
            ends.append(len(of) - 1)
            entered = 0.0
            continue
        half = max(_FEWEST, ceil(_chords(corner, tolerance) / 2), ceil(corner.angle / _TURN / 2))  # chords
        X.append(corner.pose(np.arange(1, 2 * half + 1) / (2 * half)))
        ends.append(len(of) - 1 + half)
        of += [k] * half + [k + 1] * half
        entered = corner.fraction_after
    return np.concatenate(X), of, ends


def _chords(segment: Segment, tolerance: float) -> float:
    """How many chords keep within a part of the tolerance of a segment."""
    bend = segment.twist_rate(np.linspace(0.0, 1.0, 9))[:, :3]
    return sqrt(float(np.linalg.norm(bend, axis=1).max()) / (8 * _SHARE * tolerance))


_SAME = 1e-12  # m, rad: rounding of one and the same target


@dataclass(frozen=True, eq=False)
class ProgramPoses:
    """What a RAPID program gives a task: its tool X_FT (4, 4), poses, v_max [m/s] and omega_max [rad/s] per segment,
    its text, notes."""

    X_FT: Array
    waypoints: Sequence[Waypoint]
    speeds: tuple[tuple[float, float], ...]
    text: str
    notes: tuple[str, ...]


def force_of(section: ForceSection | None, default: ForceSection | None, place: str) -> Force | None:
    """A pose's force; what it leaves out is the default's."""
    given = [one for one in (section, default) if one is not None]
    value = next((one.value for one in given if one.value is not None), 0.0)
    along = next((one.along for one in given if one.along is not None), "tool")
    return Force(value, along, place) if value else None


def written_waypoints(
    sections: Sequence[PoseSection],
    force: ForceSection | None,
    meaning: AngleMeaning,
    X_start: Array,
    lines: Mapping[str, int],
    file: str,
) -> tuple[Waypoint, ...]:
    """The poses of a task file's list. force: of those that say nothing else. X_start (4, 4): the tool in the world
    where the controller is switched on."""
    angles = np.zeros(3) if meaning is AngleMeaning.RELATIVE else angles_of(X_start[:3, :3])
    start = np.concatenate([X_start[:3, 3], angles])
    out: list[Waypoint] = []
    for i, section in enumerate(sections):
        place = f"{file}:{line_of(f'poses.{i}', lines)}"
        if section.by is not None:
            if not out:
                raise InputError(
                    "poses.0: 'by' adds to the pose before, and there is none; begin with 'start' or 'at'", file=place
                )
            pose = out[-1].pose + np.array(section.by)
        else:
            pose = start if section.at == "start" else np.array(section.at)
        pressed = force_of(section.force, force, place)
        out.append(Waypoint(section.name or str(i + 1), pose, place, section.dwell, force=pressed))
    if len(out) < 2:
        place = f"{file}:{line_of('poses', lines)}"
        raise InputError(f"poses: {len(out)} given; a path needs at least two", file=place)
    return tuple(out)


def program_route(
    path: Path, meaning: AngleMeaning, R_WF: Array, X_FT: Array | None, tolerance: float | None = None
) -> ProgramPoses:
    """The poses of a RAPID program's MoveL motions; the first motion, a MoveJ or a MoveL, says where the path begins.

    tolerance [m]: None for a stop at every pose; else fly-by zones are passed as its controller passes them, arcs are
    taken as well, and the poses are a chain within a tenth of it.

    R_WF (3, 3): the flange's orientation where the controller is switched on. X_FT (4, 4): the task's tool, None for
    the program's. Speeds are the programmed v_tcp and v_ori. Waits of a given length become dwells; signals (and zones
    without a tolerance) are left out and noted. Raises InputError with the place of any other motion, for modal state
    that a segment does not have, for tools that change on the path, for a task's tool that is not the program's, and
    for what a program asks that only a cell's scenario tells.
    """
    program = _program(path)
    notes = [str(warning) for warning in program.warnings]
    tool = _one_tool(program.motions, X_FT)
    R_start = R_WF @ tool[:3, :3]
    waypoints: list[Waypoint] = []
    speeds: list[tuple[float, float]] = []
    moves: list[PoseMove] = []
    zones: dict[int, FlyBy] = {}
    corners = {} if tolerance is None else fly_bys(program)
    fly_by = 0
    for index, motion in enumerate(program.motions):
        match motion:
            case SignalEvent():
                notes.append(f"{motion.source}: signal {motion.signal} is left out")
            case Wait() if motion.beside is not None:
                raise _refused(motion.source, "a wait beside a move; leave \\Conc out")
            case Wait(condition=None):
                if not waypoints:
                    raise _refused(motion.source, "a wait before the first pose; remove it")
                last = waypoints[-1]
                waypoints[-1] = Waypoint(last.name, last.pose, last.place, last.dwell + motion.duration)
            case Wait():
                raise _refused(motion.source, f"waits for {motion.condition}, which has no known length; remove it")
            case PathMove() if tolerance is None and not isinstance(motion, MoveL):
                message = f"{type(motion).__name__} is not a straight segment; give 'passing' a tolerance, under which"
                message += " arcs are followed"
                raise _refused(motion.source, message)
            case PoseMove() if isinstance(motion, MoveJ) != bool(waypoints) or isinstance(motion, MoveL):
                _check_plain(motion)
                fly_by += not motion.zone.stop
                R = motion.X_WT[:3, :3]
                angles = angles_of(R @ R_start.T if meaning is AngleMeaning.RELATIVE else R)
                pose = np.concatenate([motion.X_WT[:3, 3], angles])
                place = f"{motion.source.file}:{motion.source.line}"
                if (
                    isinstance(motion, MoveL)
                    and waypoints
                    and np.allclose(pose, waypoints[-1].pose, rtol=0, atol=_SAME)
                ):
                    notes.append(f"{place}: {motion.target} repeats the pose before; left out")
                    continue
                if waypoints:
                    speeds.append((motion.speed.v_tcp, motion.speed.v_ori))
                if index in corners and not corners[index].in_place:
                    zones[len(moves)] = corners[index]
                moves.append(motion)
                waypoints.append(Waypoint(motion.target, pose, place))
            case _:
                kind = type(motion).__name__
                message = f"{kind} is not a straight segment; a task takes MoveL, MoveC and a first MoveJ only"
                raise _refused(motion.source, message)
    if len(waypoints) < 2:
        raise InputError(f"gives {len(waypoints)} different poses; a path needs at least two", file=str(path))
    text = program.files[next(iter(program.files))].text
    if tolerance is not None:
        stopped = fly_by - len(zones)
        if stopped:
            notes.append(f"{stopped} fly-by zones are stops: the program waits or ends there, or no way leads on")
        return ProgramPoses(tool, *_sampled(moves, zones, tolerance, waypoints, meaning, R_start), text, tuple(notes))
    if fly_by:
        notes.append(f"{fly_by} fly-by zones are taken as stops: every pose is reached; with 'passing' they are passed")
    return ProgramPoses(tool, tuple(waypoints), tuple(speeds), text, tuple(notes))


def _sampled(
    moves: Sequence[PoseMove],
    zones: Mapping[int, FlyBy],
    tolerance: float,
    waypoints: Sequence[Waypoint],
    meaning: AngleMeaning,
    R_start: Array,
) -> tuple[PathPoints, tuple[tuple[float, float], ...]]:
    """The chain of poses along the moves, a stop at every end that has no zone, and v_max and omega_max of its legs."""
    X, of, ends = chain_of(moves, zones, tolerance)
    R = X[:, :3, :3]
    angles = angles_of(R @ R_start.T if meaning is AngleMeaning.RELATIVE else R)
    names = {i: moves[k].target for i, k in enumerate(of)} | {i: moves[k].target for k, i in enumerate(ends)}
    points = PathPoints(
        np.hstack([X[:, :3, 3], angles]),
        str(moves[0].source.file),
        np.array([moves[k].source.line for k in of]),
        names=names,
        dwells={i: waypoints[k].dwell for k, i in enumerate(ends) if waypoints[k].dwell > 0},
        stops=frozenset(i for k, i in enumerate(ends) if k not in zones),
    )
    return points, tuple((moves[k].speed.v_tcp, moves[k].speed.v_ori) for k in of[1:])


def _program(path: Path) -> Program:
    program, lacks = try_program([read_text(path)])
    if lacks:
        advice = "a task has no cell file to tell it; leave it out of the program"
        errors = [_refused(lack.source, f"{lack.reason}; {advice}") for lack in lacks]
        raise errors[0] if len(errors) == 1 else InputErrorGroup(errors)
    return program


def _check_plain(motion: PoseMove) -> None:
    """Raise InputError where a move asks for something besides its pose, its speed and its zone."""
    settings = motion.settings
    caps = (settings.path_acceleration, settings.path_deceleration, settings.world_acceleration)
    asked = {
        "AccSet": (settings.acceleration, settings.ramp) != (1.0, 1.0),
        "PathAccLim or WorldAccLim": caps != (None, None, None),
        "SingArea": settings.singularity is not Singularity.OFF,
        "GripLoad": settings.load is not None,
        "CirPathMode \\Wrist": settings.circle.wrist_alone,
    }
    for instruction, active in asked.items():
        if active:
            raise _refused(motion.source, f"{instruction} is active here; a task's segments have none, so take it out")
    if motion.process is not None or motion.events:
        name = instruction_name(motion)
        raise _refused(motion.source, f"{name} does more than move; a task takes plain MoveL and MoveC only")
    if motion.tool.stationary:
        raise _refused(motion.source, f"tool {motion.tool.name} stands still (robhold FALSE); a task's tool is carried")


def _one_tool(motions: Sequence[Motion], X_FT: Array | None) -> Array:
    """The one tool (4, 4) of all moves, which the task's own, if there is one, has to be."""
    found: PoseMove | None = None
    for motion in motions:
        if not isinstance(motion, PoseMove):
            continue
        if found is None:
            found = motion
        elif not np.allclose(motion.tool.X_FT, found.tool.X_FT, rtol=0, atol=_SAME):
            message = f"tool {motion.tool.name} after {found.tool.name}; a task has one tool for the whole path"
            raise _refused(motion.source, message)
    if found is None:
        return np.eye(4) if X_FT is None else X_FT
    if X_FT is not None and not np.allclose(found.tool.X_FT, X_FT, rtol=0, atol=_SAME):
        theirs, ours = (" ".join(f"{1e3 * value:g}" for value in X[:3, 3]) for X in (found.tool.X_FT, X_FT))
        message = (
            f"tool {found.tool.name} stands at {theirs} mm in the flange frame, the task's tool at {ours} mm (or is"
            " turned otherwise); leave the task's out, or correct one"
        )
        raise _refused(found.source, message)
    return found.tool.X_FT


def _refused(source: Source, message: str) -> InputError:
    return InputError(message, file=source.file, line=source.line, column=source.column)
