"""The program as the optimiser sees it: stops joined by legs, in stations that one arm configuration serves.

A stop is where the TCP rests. A leg leads from one stop to the next: a joint move, a line, or a dwell. Stops joined by
lines and dwells form a station: within it the IK branch and the turns of the joints cannot change.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from dataclasses import dataclass
from enum import Enum

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, axis_angle, inverse_pose
from trajopt_cli.motion import ConfData, Motion, MoveAbsJ, MoveExtJ, MoveJ, MoveL, Program, SignalEvent, Wait
from trajopt_cli.problem.freedom import Freedom, RailFreedom
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.plannable import demands_configuration
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import confdata_admits, solutions


class Coupling(Enum):
    """How the axes of a leg are bound to each other on the way."""

    FREE = "free"  # each axis of a joint move has its own profile, the rail moves freely along lines and waits
    COORDINATED = "coordinated"  # as a RAPID controller drives: one share of the way for all axes, rest at every stop


class LegKind(Enum):
    """How a leg moves."""

    JOINT = "joint"
    LINE = "line"
    DWELL = "dwell"


@dataclass(frozen=True, eq=False)
class Waypoint:
    """A point where the TCP rests. motion: index of the motion that ends here, -1 for the start.

    X_WF: flange pose, None where joints decide. q: all axes (k,) if the program fixes them. rail: range allowed [m].
    written: the rail value of the program as written. rest: every axis must stand still here. conf:
    the program's confdata, demanded at the written rail value; None where any configuration will do.
    """

    motion: int
    X_WF: Array
    q: Array | None
    rail: tuple[float, float]
    written: float
    rest: bool
    conf: ConfData | None = None


@dataclass(frozen=True, eq=False)
class Leg:
    """From stop `start` to stop `start + 1`. X_FT: tool in force. v_tcp, v_ori, v_rail: programmed caps (inf if none).

    duration: fixed time [s] or None. rail_moves: the rail may move during a line or dwell. chord [m], angle [rad].
    """

    motion: int
    kind: LegKind
    start: int
    X_FT: Array
    v_tcp: float
    a_tcp: float
    v_ori: float
    v_rail: float
    duration: float | None = None
    rail_moves: bool = True
    chord: float = 0.0
    angle: float = 0.0


@dataclass(frozen=True, eq=False)
class Problem:
    """Stops and legs in order; stations as (first stop, last stop); dropped: motions that take no time at all.

    target: the machine it is for; coupling: how the axes are bound to each other, which need not be as loose as the
    target allows.
    """

    plant: Plant
    program: Program
    freedom: Freedom
    waypoints: tuple[Waypoint, ...]
    legs: tuple[Leg, ...]
    stations: tuple[tuple[int, int], ...]
    dropped: frozenset[int]
    target: Target
    coupling: Coupling

    @property
    def coordinated(self) -> bool:
        """Whether all axes of a leg share one way and rest at every stop."""
        return self.coupling is Coupling.COORDINATED

    def rests(self, k: int) -> bool:
        """Whether every axis stands still at stop k."""
        return self.waypoints[k].rest or self.coordinated or not self.rail_may_pass(k)

    def rail_may_pass(self, k: int) -> bool:
        """Whether the rail may have speed at stop k: no neighbouring line or dwell holds it still."""
        near = [self.legs[i] for i in (k - 1, k) if 0 <= i < len(self.legs)]
        return self.plant.robot.has_rail and all(leg.kind is LegKind.JOINT or leg.rail_moves for leg in near)

    def motion(self, index: int) -> Motion:
        """The program's motion number index."""
        return self.program.motions[index]


def droppable(program: Program, plant: Plant) -> frozenset[int]:
    """Motions the user marked and that can go without moving another path: the next motion is a joint move.

    Where the plan must be written back (Program.writable), the text must let them go, too.
    """
    out = set()
    motions = program.motions
    for i, motion in enumerate(motions[:-1]):
        if isinstance(motion, Wait | SignalEvent) or not isinstance(motions[i + 1], MoveJ | MoveAbsJ):
            continue
        if program.writable is not None and i not in program.writable:
            continue
        if motion.optional or motion.target.lower() in plant.droppable:
            out.add(i)
    return frozenset(out)


def editable(program: Program) -> frozenset[int]:
    """Motions whose text can carry a plan of their own.

    Where nobody has looked closer (Program.writable): the target is a literal, and the statement runs only once.
    """
    if program.writable is not None:
        return program.writable
    runs = Counter(motion.written.statement for motion in program.motions)
    out = set()
    for i, motion in enumerate(program.motions):
        literal = isinstance(motion, Wait) or getattr(motion.written, "aggregate", None) is not None
        if literal and runs[motion.written.statement] == 1:
            out.add(i)
    return frozenset(out)


def build_problem(
    program: Program, plant: Plant, freedom: Freedom, target: Target, dropped: Collection[int] = ()
) -> Problem | Infeasible:
    """Stops and legs of a program under a freedom, or why a fixed position is out of range.

    A rapid plan must be written back into the program: motions that cannot be edited keep their rail and confdata.
    """
    free = editable(program) if target is Target.RAPID else frozenset(range(len(program.motions)))
    robot = plant.robot
    rail_range = (float(plant.limits.lower[0]), float(plant.limits.upper[0])) if robot.has_rail else (0.0, 0.0)
    pinned_rail = freedom.rail is RailFreedom.PROGRAMMED or plant.rail_fixed
    written = float(plant.start[0]) if robot.has_rail else 0.0
    stops = [Waypoint(-1, robot.forward(plant.start), plant.start, (written, written), written, True)]
    legs: list[Leg] = []

    def pose_stop(index: int, X_WF: Array, conf: ConfData | None) -> Waypoint:
        rail = rail_range if index in free and not pinned_rail else (written, written)
        asked = None if freedom.configuration and index in free else conf
        return Waypoint(index, X_WF, None, rail, written, not freedom.through_stops, asked)

    def joint_stop(index: int, q: Array, source: object) -> Waypoint:
        for name, value, low, high in zip(plant.limits.names, q, plant.limits.lower, plant.limits.upper, strict=True):
            if not low - 1e-9 <= value <= high + 1e-9:
                raise _OutOfRange(index, name, value, low, high)
        return Waypoint(index, robot.forward(q), q, (written, written), written, True)

    try:
        for i, motion in enumerate(program.motions):
            if isinstance(motion, SignalEvent) or i in dropped:
                continue
            if isinstance(motion, Wait):
                previous = stops[-1]
                rest = motion.condition is not None
                if motion.duration == 0.0:
                    if rest:
                        stops[-1] = _resting(previous)
                    continue
                legs.append(
                    Leg(
                        i, LegKind.DWELL, len(stops) - 1, np.eye(4), np.inf, np.inf, np.inf, np.inf,
                        duration=motion.duration,
                        rail_moves=freedom.dwells and previous.rail[0] < previous.rail[1] and i in free,
                    )
                )  # fmt: skip
                stops.append(
                    Waypoint(i, previous.X_WF, previous.q, previous.rail, written, rest or previous.rest, previous.conf)
                )
                continue
            given = plant.rail_value(motion.extax)
            if given is not None:
                if not rail_range[0] - 1e-9 <= given <= rail_range[1] + 1e-9 and (
                    pinned_rail or isinstance(motion, MoveAbsJ | MoveExtJ)
                ):
                    raise _OutOfRange(i, plant.limits.names[0], given, *rail_range)
                written = given
            speed = motion.speed
            uncapped = plant.free_speed and isinstance(motion, MoveJ | MoveAbsJ)
            caps = (np.inf, np.inf, np.inf) if uncapped else (speed.v_tcp, speed.v_ori, speed.v_leax)
            X_FT = np.eye(4) if isinstance(motion, MoveExtJ) else motion.tool.X_FT
            kind, chord, angle, moves = LegKind.JOINT, 0.0, 0.0, True
            if isinstance(motion, MoveAbsJ):
                stops.append(joint_stop(i, np.r_[[written] if robot.has_rail else [], motion.q], motion.source))
            elif isinstance(motion, MoveExtJ):
                arm = _arm_as_written(stops[-1], plant)
                if isinstance(arm, Infeasible):
                    return arm
                stops[-1] = Waypoint(
                    stops[-1].motion, stops[-1].X_WF, arm, (float(arm[0]),) * 2, float(arm[0]), stops[-1].rest
                )
                stops.append(joint_stop(i, np.r_[written, arm[1:]], motion.source))
                caps = (np.inf, np.inf, speed.v_leax)
            else:
                X_WF = motion.X_WT @ inverse_pose(X_FT)
                if isinstance(motion, MoveL):
                    X_0 = stops[-1].X_WF @ X_FT
                    chord = float(np.linalg.norm(motion.X_WT[:3, 3] - X_0[:3, 3]))
                    angle = axis_angle(X_0[:3, :3].T @ motion.X_WT[:3, :3])[1]
                    kind, moves = LegKind.LINE, freedom.lines and robot.has_rail
                    if chord < 1e-9 and angle < 1e-9:
                        kind, chord, angle, moves = LegKind.DWELL, 0.0, 0.0, robot.has_rail
                stops.append(pose_stop(i, X_WF, motion.conf if demands_configuration(motion) else None))
                moves = moves or (robot.has_rail and _apart(stops[-2].rail, stops[-1].rail))
            legs.append(
                Leg(
                    i, kind, len(stops) - 2, X_FT, min(caps[0], plant.tcp.speed), plant.tcp.acceleration, caps[1],
                    caps[2], duration=motion.duration, rail_moves=moves, chord=chord, angle=angle,
                )
            )  # fmt: skip
    except _OutOfRange as out:
        source = program.motions[out.index].source
        return Infeasible(out.index, source, f"{source}: {_name(program.motions[out.index])} {out}")
    stops[-1] = _resting(stops[-1])
    coupling = Coupling.COORDINATED if target is Target.RAPID else Coupling.FREE
    stations = _stations(legs, len(stops))
    return Problem(plant, program, freedom, tuple(stops), tuple(legs), stations, frozenset(dropped), target, coupling)


class _OutOfRange(Exception):
    def __init__(self, index: int, axis: str, value: float, low: float, high: float):
        unit, factor = ("mm", 1e3) if axis == "rail" else ("deg", 180 / np.pi)
        super().__init__(
            f"asks for {axis} = {value * factor:.6g} {unit}, range {low * factor:.6g}..{high * factor:.6g} {unit}"
        )
        self.index = index


def _apart(a: tuple[float, float], b: tuple[float, float]) -> bool:
    """Whether two ranges of the rail have no position in common, so that it has to move between them."""
    return a[1] < b[0] or b[1] < a[0]


def _name(motion: Motion) -> str:
    return f"{type(motion).__name__} {getattr(motion, 'target', '')}".strip()


def _resting(stop: Waypoint) -> Waypoint:
    return Waypoint(stop.motion, stop.X_WF, stop.q, stop.rail, stop.written, True, stop.conf)


def _arm_as_written(stop: Waypoint, plant: Plant) -> Array | Infeasible:
    """All axes at a stop as the program writes it: its rail value and its confdata."""
    if stop.q is not None:
        return stop.q
    rail = stop.written if plant.robot.has_rail else None
    for _, q in solutions(plant.robot, stop.X_WF, rail, plant.limits):
        if stop.conf is None or confdata_admits(plant.robot, stop.conf, q):
            return np.asarray(np.r_[[] if rail is None else [rail], q])
    raise InputError(
        "MoveExtJ holds the arm's joints, but the point before it cannot be reached with its confdata at its own rail"
        " value; correct eax or confdata there"
    )


def _stations(legs: list[Leg], n_stops: int) -> tuple[tuple[int, int], ...]:
    starts = [0] + [leg.start + 1 for leg in legs if leg.kind is LegKind.JOINT]
    ends = [start - 1 for start in starts[1:]] + [n_stops - 1]
    return tuple(zip(starts, ends, strict=True))
