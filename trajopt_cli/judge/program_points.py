"""The program as the judge reads it: points where the TCP must stop or which it passes, in order, and what is held
there."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import isnan, nan

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.judge.geometry import Path, angle_between, inverse_pose, turned_back, wanted_path
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import mechanism_of
from trajopt_cli.motion import (
    ExternalAxes,
    FlyBy,
    FreeTurn,
    Move,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    MoveL,
    PathMove,
    Program,
    SignalEvent,
    Source,
    Wait,
    turned_under,
)
from trajopt_cli.units import MM

_SAME_POINT = 1e-9  # m and rad: a line to the pose where it starts, a move of the redundant axis alone
_NO_WAY = 1e-6  # m: beside a shorter way of the tool there is no zone


@dataclass(frozen=True, eq=False)
class ProgramPoint:
    """Where a move ends (move None: where the program starts).

    X_WF: flange pose there, None where the joints on the way decide it (MoveExtJ, MoveAbsJ with a free rail). X_FT:
    tool in force. arm (6,) and rail (r,): axis values the program fixes, None where they are free, NaN for a rail that
    is left open. optional: it may be left out. holds: the waits that follow, with their index. fly_by: None for a stop.
    curve: the path of a move that asks for another one than a line, None where only the joints know its start. written:
    the rails [m] as the program writes them at a stop, where they are free; None for none. free: how the tool may be
    turned there; X_WF is as taught.
    """

    index: int
    move: Move | None
    source: Source | None
    name: str
    X_WF: Array | None
    X_FT: Array
    arm: Array | None
    rail: tuple[float, ...] | None
    optional: bool
    holds: tuple[tuple[int, Wait], ...] = ()
    fly_by: FlyBy | None = None
    curve: Path | None = None
    written: tuple[float, ...] | None = None
    free: FreeTurn | None = None

    @property
    def curved(self) -> bool:
        """Whether the move asks for another path than a line."""
        return isinstance(self.move, PathMove) and not isinstance(self.move, MoveL)

    @property
    def duration(self) -> float | None:
        """The programmed time of the move, or what other robots take that make it too, s."""
        if self.move is None or self.move.duration is None:
            return None
        return max(self.move.duration, self.least)

    @property
    def least(self) -> float:
        """What the positioners that turn during the move, and other robots that make it too, take at least, s."""
        if self.move is None:
            return 0.0
        return max([self.move.partner or 0.0, *(unit.least for unit in self.move.units)])

    @property
    def beside(self) -> float:
        """How long the program is busy beside the move (\\Conc), as programmed, s: the next one begins no sooner."""
        return sum(wait.beside or 0.0 for _, wait in self.holds)

    @property
    def X_WT(self) -> Array:
        """Where the tool is when the flange is at X_WF (4, 4)."""
        assert self.X_WF is not None
        return np.asarray(self.X_WF @ self.X_FT)


def may_drop(program: Program, plant: Machine, index: int) -> bool:
    """Whether the user allowed motion number index to be left out."""
    if not 0 <= index < len(program.motions):
        return False
    motion = program.motions[index]
    if isinstance(motion, Wait | SignalEvent):
        return False
    return motion.identity is None and (motion.optional or motion.target.lower() in plant.droppable)


def points_of(
    program: Program, plant: Machine, dropped: Collection[int] = (), optional: bool = False
) -> list[ProgramPoint]:
    """Start and points in program order. dropped: motions left out; optional: the file may leave out others as well,
    those that the user marked.

    A point is a stop where the program says so (fine, \\Inpos), at the last move, before a wait that waits for
    anything, beside external axes that move alone, and where a fly-by has no zone: a radius of 0 mm, or no way of the
    tool to it or on from it; between two reorientations its zone is an angle. All others are passed. A MoveAbsJ that
    is passed and leaves the rail open (9E9) is where the rail was programmed last.
    """
    points = [_start_point(program, plant)]
    alone = set[int]()  # points beside external axes that move alone
    rail = _started(plant)
    holds = list[list[tuple[int, Wait]]]([[]])
    for i, motion in enumerate(program.motions):
        if isinstance(motion, SignalEvent) or i in dropped:
            continue
        if isinstance(motion, Wait):
            holds[-1].append((i, motion))
            continue
        if isinstance(motion, MoveExtJ):
            alone |= {len(points) - 1, len(points)}
            if _programmed_rail(plant, motion.extax) is None:
                alone -= {len(points)}
                if motion.least:  # it moves no axis that this robot has, which waits for the positioner
                    time = max(motion.duration or 0.0, motion.least)
                    holds[-1].append((i, Wait(source=motion.source, written=motion.written, duration=time)))
                continue
        points.append(end_of_move(plant, i, motion, points[-1].X_FT, optional and may_drop(program, plant, i)))
        holds.append([])
        if motion.process is not None and motion.process.instruction.startswith("Spot"):  # the gun closes, at rest
            work = motion.process.instruction
            holds[-1].append((i, Wait(source=motion.source, written=motion.written, duration=0.0, condition=work)))
    points = [replace(point, holds=tuple(waits)) for point, waits in zip(points, holds, strict=True)]
    return _with_zones(plant, points, alone, rail)


def _start_point(program: Program, plant: Machine) -> ProgramPoint:
    moves = [m for m in program.motions if not isinstance(m, Wait | SignalEvent | MoveExtJ)]
    X_FT = np.asarray(moves[0].tool.X_FT) if moves else np.eye(4)
    mechanism = mechanism_of(plant)
    rail = _started(plant)
    if program.before is not None:  # the cycle of a loop begins where it ends
        last = next(m for m in reversed(program.motions) if not isinstance(m, Wait | SignalEvent))
        end = end_of_move(plant, -1, last, X_FT, optional=False)
        if end.arm is not None:
            end = replace(end, X_WF=_at_joints(plant, end.arm, rail), rail=rail)
        return replace(end, move=None, source=None, name="start", X_FT=X_FT)
    return ProgramPoint(
        -1, None, None, "start", mechanism.flange_pose(plant.start), X_FT, plant.start[-6:], rail, False
    )


def _started(plant: Machine) -> tuple[float, ...] | None:
    """Where the rails begin; None without one."""
    return tuple(plant.start[: mechanism_of(plant).rails].tolist()) or None


def end_of_move(plant: Machine, index: int, motion: Move, X_FT: Array, optional: bool) -> ProgramPoint:
    """A move's end; X_FT: the tool before it, which a MoveExtJ keeps."""
    name, wanted = f"{type(motion).__name__} {motion.target}", _programmed_rail(plant, motion.extax)
    if isinstance(motion, MoveExtJ):
        return ProgramPoint(index, motion, motion.source, name, None, X_FT, None, wanted, optional)
    X_FT = np.asarray(motion.tool.X_FT)
    if isinstance(motion, MoveAbsJ):
        X_WF = _at_joints(plant, motion.q, wanted)
        return ProgramPoint(index, motion, motion.source, name, X_WF, X_FT, motion.q, wanted, optional)
    rail, X_WF = wanted if plant.rail_fixed else None, motion.X_WT @ inverse_pose(X_FT)
    return ProgramPoint(index, motion, motion.source, name, X_WF, X_FT, None, rail, optional, free=motion.free)


def _at_joints(plant: Machine, arm: Array, rail: tuple[float, ...] | None) -> Array | None:
    """The flange at an arm's joints; None where it stands on a rail that is anywhere."""
    mechanism = mechanism_of(plant)
    if mechanism.has_rail and (rail is None or any(map(isnan, rail))):
        return None
    return mechanism.flange_pose(np.r_[rail if rail and mechanism.has_rail else [], arm])


def _with_zones(
    plant: Machine, points: Sequence[ProgramPoint], alone: Collection[int], rail: tuple[float, ...] | None
) -> list[ProgramPoint]:
    """The same points with their curves and, where they are passed, their zones and places."""
    placed: list[ProgramPoint] = []  # as if all fly-bys were passed
    for point in points:
        if point.move is not None and (given := _programmed_rail(plant, point.move.extax)) is not None:
            before = rail or given
            rail = tuple(last if isnan(d) else d for d, last in zip(given, before, strict=True))
        if point.arm is not None and point.X_WF is None and _programmed_fly_by(point):
            point = replace(point, X_WF=_at_joints(plant, point.arm, rail))
        if point.curved and placed[-1].X_WF is not None:
            point = replace(point, curve=path_to(placed[-1].X_WF, point))
        point = replace(point, written=rail if point.rail is None else None)
        placed.append(point)
    paths = [_path_length(a, b) for a, b in pairwise(placed)]
    out: list[ProgramPoint] = []
    for k, point in enumerate(points):
        fly_by = None
        turning = any(one.move is not None and one.move.units for one in points[k : k + 2])  # a stop on both sides
        if 0 < k < len(points) - 1 and k not in alone and not turning:
            turns = [_turn(a, b) for a, b in pairwise(placed[k - 1 : k + 2])]
            fly_by = _fly_by(point, paths[k - 1 : k + 1], turns)
            joint = _other_frame(point.move, points[k + 1].move)
            fly_by = None if joint is None or fly_by is None else fly_by._replace(joint=joint)
        point = replace(point, written=placed[k].written if fly_by is None else None)
        if fly_by is not None:
            point = replace(point, fly_by=fly_by, X_WF=placed[k].X_WF)
        if k > 0 and out[-1].X_WF is not None:
            point = replace(point, curve=placed[k].curve)
        out.append(point)
    return out


def _fly_by(point: ProgramPoint, paths: Sequence[float | None], turns: Sequence[float | None]) -> FlyBy | None:
    """The zone of a point between two ways [m]; None where it is a stop. turns [rad]: of ways that only turn the tool,
    between which the zone is zone_ori. Else angular and linear sizes (zone_ori, zone_leax), which make its parts for
    orientation and external axes smaller at most, are not counted."""
    waits = any(wait.duration > 0 or wait.in_position or stands_for(wait) for _, wait in point.holds)
    half = min((path for path in paths if path is not None), default=np.inf) / 2
    if point.move is None or not _programmed_fly_by(point) or waits:
        return None
    zone = point.move.zone
    if all(turn is not None for turn in turns):
        angle = min(zone.ori, *(turn / 2 for turn in turns if turn is not None))
        return FlyBy(angle, angle, angle, in_place=True) if angle > 0 else None
    if 2 * half < _NO_WAY:
        return None
    radius, turning, external = (min(max(size, zone.radius), half) for size in (0.0, zone.path_ori, zone.path_eax))
    return FlyBy(radius, turning, external) if radius > 0 else None


def stands_for(wait: Wait) -> bool:
    """Whether the robot stands until a condition holds: not where it is waited for beside a move."""
    return wait.condition is not None and (wait.beside is None or wait.in_position)


def _programmed_fly_by(point: ProgramPoint) -> bool:
    return point.move is not None and not isinstance(point.move, MoveExtJ) and not point.move.zone.stop


def _path_length(a: ProgramPoint, b: ProgramPoint) -> float | None:
    """The tool's path from point to point [m], along a curve, else the chord; None where only the joints know an end.
    Such an end makes no zone smaller."""
    if b.curve is not None:
        return b.curve.length
    if a.X_WF is None or b.X_WF is None:
        return None
    return float(np.linalg.norm((a.X_WF @ b.X_FT - b.X_WT)[:3, 3]))


def _turn(a: ProgramPoint, b: ProgramPoint) -> float | None:
    """How far [rad] a line from point to point turns the tool whose centre point stands; None for any other move."""
    path = _path_length(a, b)
    if not isinstance(b.move, MoveL) or a.X_WF is None or path is None or path >= _NO_WAY:
        return None
    angle = float(angle_between((a.X_WF @ b.X_FT)[:3, :3], b.X_WT[:3, :3]))
    return angle if angle > _NO_WAY else None


def _other_frame(move: Move | None, after: Move | None) -> bool | None:
    """Whether another coordinate system is in force after a point, so that its corner is joint interpolated: another
    tool centre point, or between lines and arcs another work object, told by their frames (by name where the robot
    holds it). None for a stationary tool, whose points are stops."""
    if move is None or after is None or isinstance(move, MoveExtJ) or isinstance(after, MoveExtJ):
        return False
    if not np.array_equal(move.tool.X_FT, after.tool.X_FT):
        return None if move.tool.stationary or after.tool.stationary else True
    if not isinstance(move, PathMove) or not isinstance(after, PathMove):
        return False
    same_name = move.wobj.lower() == after.wobj.lower()
    if move.X_WO is None or after.X_WO is None:
        return not same_name
    moved = float(np.abs(np.asarray(move.X_WO) - np.asarray(after.X_WO)).max()) > _NO_WAY
    return moved and not (same_name and (move.settings.displaced or after.settings.displaced))


def path_to(X_WF_before: Array, point: ProgramPoint) -> Path:
    """The path of a move that prescribes one, from where the flange is before it.

    Raises InputError where there is none, with its place in the program.
    """
    X_0, move = X_WF_before @ point.X_FT, point.move
    assert isinstance(move, PathMove)
    return wanted_path(move, X_0, turned_back(turned_under(move), point.X_WT), X_0[None, :3, :3])


def stays(point: ProgramPoint, X_WF_before: Array) -> bool:
    """Whether the move is a line to the pose where it starts: the TCP rests, only the redundant axis moves."""
    if not isinstance(point.move, MoveL) or point.X_WF is None or turned_under(point.move):
        return False
    X, Y = X_WF_before @ point.X_FT, point.X_WF @ point.X_FT
    angle = angle_between(X[:3, :3], Y[:3, :3])
    return bool(np.linalg.norm(X[:3, 3] - Y[:3, 3]) < _SAME_POINT and angle < _SAME_POINT)


def _programmed_rail(plant: Machine, extax: ExternalAxes) -> tuple[float, ...] | None:
    """The rails [m] that external axes ask for, NaN for one that they leave open; None where they leave open all."""
    values = [extax[eax] for eax in plant.rail_eaxes]
    if all(value is None for value in values):
        return None
    return tuple(nan if value is None else value * MM for value in values)


def obeys_programmed_speed(point: ProgramPoint, plant: Machine) -> bool:
    """Whether the move's programmed TCP speed and reorientation cap it.

    A programmed time replaces the speed; external axes alone know only v_leax (RAPID reference: MoveL \\T, MoveExtJ).
    """
    if point.move is None or point.duration is not None or isinstance(point.move, MoveExtJ):
        return False
    return not (plant.free_speed and isinstance(point.move, MoveJ | MoveAbsJ))
