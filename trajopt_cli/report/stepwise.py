"""The thesis' analysis of a program as written: steps of speed, straight in carriage-relative space (Krotký 2014, 4.2).

The rail was driven apart from the arm, so the arm's own workspace looks deformed: every point stands where the carriage
sees it. In that space each move is taken as a straight line at its programmed speed from the first instant to the last,
a MoveC as its arc as far as the rail leaves it one. No robot can do that; it is an estimate of the work the program
asks for, comparable with the thesis' figures. Nothing is sped up or slowed down, so stops and fly-bys are the same in
it: every way leads through its point, and what a corner would cut off is counted.
Frames: W world, B the arm's base on its carriage, F flange, T tool centre point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, axis_angle, inverse_pose, readonly
from trajopt_cli.motion import Move, MoveAbsJ, MoveExtJ, PathMove, Program, SignalEvent, Source, Wait, motion_name
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.path.segment import Segment
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.summary import motion_label
from trajopt_cli.table import TextTable, place, seconds, tabulate
from trajopt_cli.timing.double_integrator import trapezoid_time
from trajopt_cli.units import DEG, MM

_STANDS = 1e-9  # m or rad: less is rounding of poses and no motion
_GAUSS = 64  # places at which an arc's length is summed up
_PLACES = 97  # of an arc that are kept
MODEL = (
    "steps of speed through every point, straight or along the arc in carriage-relative space, waits excluded "
    "(Krotký 2014, 4.2); not a motion a robot can do; zones change nothing, ways that corners would cut off are counted"
)


@dataclass(frozen=True, eq=False)
class StepMove:
    """One move in steps of speed.

    index: its place in Program.motions. X_BT_0, X_BT_1 (4, 4): the TCP from the carriage at both ends. X_WT_0, X_WT_1:
    the same in the world. rail_0, rail_1 [m]: the rail there that goes farthest, 0 for a robot without one. length [m],
    angle [rad]: of the way as the carriage sees it, along an arc where it is one. v_tcp [m/s]: programmed speed under
    the TCP cap, or what a programmed duration comes to; 0 where the arm stands. t_arm, t_rail [s]: what either needs, 0
    where it stands. seen, real (n, 3) [m]: places of the TCP on its way, as the carriage sees them and in the world; of
    a straight way both ends.
    """

    index: int
    source: Source
    X_BT_0: Array
    X_BT_1: Array
    X_WT_0: Array
    X_WT_1: Array
    rail_0: float
    rail_1: float
    length: float
    angle: float
    v_tcp: float
    t_arm: float
    t_rail: float
    seen: Array
    real: Array

    def __post_init__(self) -> None:
        for name in ("X_BT_0", "X_BT_1", "X_WT_0", "X_WT_1", "seen", "real"):
            object.__setattr__(self, name, readonly(getattr(self, name)))

    @property
    def duration(self) -> float:
        """Time of the move [s]; where arm and rail both move they start together, and the slower one decides."""
        return max(self.t_arm, self.t_rail)

    @property
    def velocity(self) -> Array:
        """The TCP's velocity (3,) [m/s] along the carriage's axes (thesis fig. 4.5), for t_arm; 0 where it stands.

        Its norm is v_tcp unless the turning takes longer than the way at that speed; on an arc it is the mean.
        """
        step = self.X_BT_1[:3, 3] - self.X_BT_0[:3, 3]
        return step / self.t_arm if self.t_arm > 0 else np.zeros(3)

    @property
    def velocities(self) -> tuple[Array, Array]:
        """Shares of t_arm (n,) at which the TCP is at seen, and its velocities (n-1, 3) [m/s] between them: one on a
        straight way."""
        steps = np.diff(self.seen, axis=0)
        far = np.linalg.norm(steps, axis=1)
        if len(steps) == 1 or self.t_arm == 0:
            return np.array([0.0, 1.0]), self.velocity[None]
        return np.concatenate([[0.0], np.cumsum(far)]) / far.sum(), steps * (far.sum() / far / self.t_arm)[:, None]


@dataclass(frozen=True)
class StepWait:
    """A programmed wait, counted apart. index: its place in Program.motions. duration [s], the least one if open."""

    index: int
    source: Source
    duration: float


@dataclass(frozen=True, eq=False)
class Analysis:
    """Moves and waits of a program in order. Times in s; arm + rail exceeds cycle where both move at once."""

    moves: tuple[StepMove, ...]
    waits: tuple[StepWait, ...]

    @property
    def arm(self) -> float:
        """Sum of the arm's times."""
        return sum(move.t_arm for move in self.moves)

    @property
    def rail(self) -> float:
        """Sum of the rail's times."""
        return sum(move.t_rail for move in self.moves)

    @property
    def cycle(self) -> float:
        """Time of all moves, waits excluded."""
        return sum(move.duration for move in self.moves)

    @property
    def wait(self) -> float:
        """Sum of the waits."""
        return sum(wait.duration for wait in self.waits)

    @property
    def begins(self) -> Array:
        """When each move begins and, last, when the cycle ends (n + 1,) [s], waits excluded."""
        return np.cumsum([0.0, *(move.duration for move in self.moves)])


def analyse(program: Program, plant: Plant) -> Analysis:
    """Every move of the program in steps of speed, from the cell's start on; nothing is dropped.

    The arm needs max(length / v_tcp, angle / v_ori) in carriage-relative space, v_tcp under the plant's TCP speed cap.
    The rail stands where the move's external axes say, or stays; it needs its least time from rest to rest under its
    limits and the programmed v_leax. A programmed duration replaces both. Whether a point is in reach is not asked.
    Raises InputError, placed in the program, where something must move at a programmed speed of 0.
    """
    robot = plant.robot
    X_BF = inverse_pose(robot.base_at(plant.start)) @ robot.forward(plant.start)
    rail = plant.start[plant.layout.rail]
    X_FT: Array = np.eye(4)  # a MoveExtJ names no tool; the one before stays in force
    moves, waits, beside = [], [], 0.0  # what waits beside the last move (\Conc) take longer than it [s]
    for i, motion in enumerate(program.motions):
        match motion:
            case Wait() if motion.settles:
                continue
            case Wait():
                waits.append(StepWait(i, motion.source, motion.duration + beside))
                beside = 0.0
                continue
            case SignalEvent():
                continue
            case MoveExtJ():
                pass
            case _:
                X_FT = motion.tool.X_FT
        rail_1 = plant.rail_after(motion.extax, rail)
        X_BT_0 = X_BF @ X_FT
        X_BT_1 = _target(motion, plant, rail_1, X_BF) @ X_FT
        moves.append(_step(i, motion, plant, (X_BT_0, X_BT_1), (rail, rail_1)))
        beside = max(motion.beside - moves[-1].duration, 0.0)
        X_BF, rail = X_BT_1 @ inverse_pose(X_FT), rail_1
    return Analysis(tuple(moves), tuple(waits))


def _target(motion: Move, plant: Plant, rail: Array, X_BF: Array) -> Array:
    """The flange X_BF (4, 4) at the end of a move, the rail then being at rail; X_BF: before it."""
    X_BW = inverse_pose(plant.robot.base(rail))
    match motion:
        case MoveExtJ():
            return X_BF
        case MoveAbsJ():
            return X_BW @ plant.robot.forward(np.r_[rail, motion.q])
        case _:
            return X_BW @ motion.X_WT @ inverse_pose(motion.tool.X_FT)


def _step(index: int, motion: Move, plant: Plant, X_BT: tuple[Array, Array], rail: tuple[Array, Array]) -> StepMove:
    X_BT_0, X_BT_1 = X_BT
    X_WB_0, X_WB_1 = (plant.robot.base(position) for position in rail)
    X_WT_0, X_WT_1 = X_WB_0 @ X_BT_0, X_WB_1 @ X_BT_1
    length = float(np.linalg.norm(X_BT_1[:3, 3] - X_BT_0[:3, 3]))
    seen, real = (np.array([X_0[:3, 3], X_1[:3, 3]]) for X_0, X_1 in (X_BT, (X_WT_0, X_WT_1)))
    angle = axis_angle(X_BT_0[:3, :3].T @ X_BT_1[:3, :3])[1]
    if isinstance(motion, PathMove) and not (path := segment_of(motion, X_WT_0)).straight:
        length, seen, real = _along(path, plant, rail)
        angle = path.angle
    ways = np.abs(rail[1] - rail[0])
    way = float(ways.max(initial=0.0))
    rail_0, rail_1 = (float(d[np.argmax(ways)]) if len(ways) else 0.0 for d in rail)
    v_tcp = min(motion.speed.v_tcp, plant.tcp.speed)
    if max(length, angle) <= _STANDS:
        length = angle = v_tcp = t_arm = 0.0
    elif motion.duration is not None:
        t_arm = motion.duration
        v_tcp = length / t_arm
    else:
        t_arm = max(
            _time(motion, length, v_tcp, "TCP speed"), _time(motion, angle, motion.speed.v_ori, "reorientation speed")
        )
    if motion.partner is not None and motion.partner > t_arm:
        t_arm, v_tcp = motion.partner, length / motion.partner
    if way <= _STANDS:
        t_rail = 0.0
    elif motion.duration is not None:
        t_rail = motion.duration
    else:
        _time(motion, way, motion.speed.v_leax, "speed of linear external axes")
        top, a_rail = plant.limits.velocity[plant.layout.rail], plant.limits.acceleration[plant.layout.rail]
        t_rail = float(np.max(trapezoid_time(ways, np.minimum(motion.speed.v_leax, top), a_rail)))
    return StepMove(
        index, motion.source, X_BT_0, X_BT_1, X_WT_0, X_WT_1, rail_0, rail_1,
        length=length, angle=angle, v_tcp=v_tcp, t_arm=t_arm, t_rail=t_rail, seen=seen, real=real,
    )  # fmt: skip


def _along(path: Segment, plant: Plant, rail: tuple[Array, Array]) -> tuple[float, Array, Array]:
    """A path as the carriage sees it, the rail going in proportion: its length, and places on it from there and in the
    world (n, 3)."""
    x, weight = np.polynomial.legendre.leggauss(_GAUSS)
    carried = plant.robot.way_at(rail[1] - rail[0])
    length = float(weight @ np.linalg.norm(path.twist((1 + x) / 2)[:, :3] - carried, axis=1)) / 2
    s = np.linspace(0.0, 1.0, _PLACES)
    X_WT = path.pose(s)
    X_BT = inverse_pose(plant.robot.base_at(rail[0] + s[:, None] * (rail[1] - rail[0]))) @ X_WT
    return length, X_BT[:, :3, 3], X_WT[:, :3, 3]


def _time(motion: Move, way: float, speed: float, what: str) -> float:
    """way / speed, refusing to move at no speed."""
    if way <= _STANDS:
        return 0.0
    if speed <= 0:
        source = motion.source
        raise InputError(
            f"{motion_name(motion)}: {motion.speed.name} gives {what} 0; a speed above 0 is needed",
            file=source.file, line=source.line, column=source.column,
        )  # fmt: skip
    return way / speed


def analysis_record(program: Program, analysis: Analysis) -> dict[str, Any]:
    """The analysis as plain data; velocities are those of the TCP along the carriage's axes."""
    return {
        "model": MODEL,
        "moves": [_move_record(program, move) for move in analysis.moves],
        "waits": [
            {"index": wait.index, "source": str(wait.source), "duration_s": wait.duration} for wait in analysis.waits
        ],
        "arm_s": analysis.arm,
        "rail_s": analysis.rail,
        "cycle_s": analysis.cycle,
        "waits_s": analysis.wait,
    }


def _move_record(program: Program, move: StepMove) -> dict[str, Any]:
    instruction, target = motion_label(program, move.index)
    return {
        "index": move.index,
        "source": str(move.source),
        "instruction": instruction,
        "target": target,
        "carriage_from_mm": [float(value) / MM for value in move.X_BT_0[:3, 3]],
        "carriage_to_mm": [float(value) / MM for value in move.X_BT_1[:3, 3]],
        "world_from_mm": [float(value) / MM for value in move.X_WT_0[:3, 3]],
        "world_to_mm": [float(value) / MM for value in move.X_WT_1[:3, 3]],
        "rail_from_mm": move.rail_0 / MM,
        "rail_to_mm": move.rail_1 / MM,
        "length_mm": move.length / MM,
        "turn_deg": move.angle / DEG,
        "speed_mm_s": move.v_tcp / MM,
        "velocity_mm_s": [float(value) / MM for value in move.velocity],
        "arm_s": move.t_arm,
        "rail_s": move.t_rail,
        "duration_s": move.duration,
    }


def analysis_table(name: str, program: Program, analysis: Analysis) -> TextTable:
    """One line per move and wait, in program order; a wait's time stands in a column of its own."""

    def of_move(text: Callable[[StepMove], str]) -> Callable[[StepMove | StepWait], str]:
        return lambda one: "" if isinstance(one, StepWait) else text(one)

    def axis(i: int) -> Callable[[StepMove | StepWait], str]:
        return of_move(lambda one: _figure(float(one.velocity[i]) / MM))

    entries: list[StepMove | StepWait] = [*analysis.moves, *analysis.waits]
    return tabulate(
        f"{name}: as written, in steps of speed; lengths and axis speeds as the carriage sees them",
        sorted(entries, key=lambda one: one.index),
        {
            "~place": lambda one: place(one.source),
            "instruction": lambda one: motion_label(program, one.index)[0],
            "~target": lambda one: motion_label(program, one.index)[1],
            ">time [s]": of_move(lambda one: seconds(one.duration)),
            ">wait [s]": lambda one: seconds(one.duration) if isinstance(one, StepWait) else "",
            ">length [mm]": of_move(lambda one: _figure(one.length / MM)),
            ">turn [deg]": of_move(lambda one: _figure(one.angle / DEG)),
            ">rail by [mm]": of_move(lambda one: _figure((one.rail_1 - one.rail_0) / MM)),
            ">programmed [mm/s]": of_move(lambda one: _figure(one.v_tcp / MM)),
            **{f">{name} [mm/s]": axis(i) for i, name in enumerate("xyz")},
        },
    )


def sums(analysis: Analysis) -> Iterator[str]:
    """The sums, a line each; where arm and rail move at once the cycle counts the slower of the two."""
    both = analysis.arm + analysis.rail - analysis.cycle
    yield f"arm {analysis.arm:.3f} s"
    yield f"rail {analysis.rail:.3f} s"
    yield f"cycle {analysis.cycle:.3f} s" + (f", arm + rail - both at once {both:.3f} s" if both > 1e-9 else "")
    yield f"waits {analysis.wait:.3f} s, apart"


def _figure(value: float) -> str:
    """One decimal; what stands still stays blank."""
    return f"{value:.1f}" if abs(value) >= 0.05 else ""
