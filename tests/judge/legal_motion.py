"""Small legal motions in our own file format, made without the optimiser: the judge's tests start from these.

A motion is a list of pieces, each a function of time with switches; rows are a grid plus every boundary and switch.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from tcp_motion import forward_acceleration, inverse_velocity

from trajopt_cli.findings import Report
from trajopt_cli.geometry import Array, axis_angle, pose, rotation_about
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import (
    NO_EXTERNAL_AXES,
    ConfData,
    Hold,
    Motion,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    Source,
    Span,
    Speed,
    Tool,
    Wait,
    Written,
    Zone,
)
from trajopt_cli.path.line import Line
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import inverse
from trajopt_cli.robot.model import load_robot
from trajopt_cli.trajectory import Trajectory

HOME = np.array([0, 0, 0, 0, 0, np.pi / 6])
DOWN = rotation_about([0, 1, 0], np.pi)
TOOL = Tool("tool0", np.eye(4))
V500 = Speed("v500", 0.5, np.radians(500), 5.0, np.radians(1000))
V2500 = Speed("v2500", 2.5, np.radians(500), 5.0, np.radians(1000))
FINE = Zone("fine", True)
CONF = ConfData(0, 0, 0, 0)
_WRITTEN = Written(Span("t.mod", 0, 1))


@cache
def plant_with_rail(rail_fixed: bool = False, free_speed: bool = False) -> Plant:
    robot = load_robot("irb140_rail")
    base = robot.profile()
    limits = JointLimits(
        base.names,
        np.r_[-0.2, base.lower[1:]],
        np.r_[2.2, base.upper[1:]],
        np.r_[1.0, base.velocity[1:]],
        np.array([3.0, 15, 12.5, 20, 40, 40, 60]),
    )
    return Plant(robot, limits, TcpCaps(2.5, 20.0), np.r_[0.0, HOME], (0,), rail_fixed, free_speed, frozenset())


@cache
def plant_without_rail() -> Plant:
    robot = load_robot("irb140")
    return Plant(robot, robot.profile(), TcpCaps(2.5, 20.0), HOME, (), False, False, frozenset())


def eax(rail: float | None) -> tuple[float | None, ...]:
    return NO_EXTERNAL_AXES if rail is None else (rail * 1e3, None, None, None, None, None)


def _common(line: int, target: str, speed: Speed, rail: float | None) -> dict[str, object]:
    source = Source("cell.mod", line, 5)
    return dict(source=source, written=_WRITTEN, target=target, speed=speed, zone=FINE, extax=eax(rail))


def move_j(line: int, target: str, X: Array, rail: float | None = None, speed: Speed = V2500, **more: object) -> MoveJ:
    return MoveJ(**{**_common(line, target, speed, rail), "tool": TOOL, **more}, X_WT=X, conf=CONF)


def move_l(line: int, target: str, X: Array, rail: float | None = None, speed: Speed = V500, **more: object) -> MoveL:
    return MoveL(**{**_common(line, target, speed, rail), "tool": TOOL, **more}, X_WT=X, conf=CONF)


def home(line: int, rail: float | None = 0.0) -> MoveAbsJ:
    return MoveAbsJ(**_common(line, "j_home", V2500, rail), q=HOME, tool=TOOL)


def move_ext(line: int, rail: float) -> MoveExtJ:
    return MoveExtJ(**_common(line, "j_rail", V2500, rail))


def wait(line: int, duration: float, condition: str | None = None, hold: Hold | None = None) -> Wait:
    source = Source("cell.mod", line, 5)
    return Wait(source=source, written=_WRITTEN, duration=duration, condition=condition, hold=hold)


def program(*motions: Motion) -> Program:
    return Program("main", tuple(motions), {})


def down(x: float, y: float, z: float, turn: float = 0.0) -> Array:
    return pose(rotation_about([0, 0, 1], turn) @ DOWN, [x, y, z])


@dataclass(frozen=True)
class Piece:
    """t in [0, T] -> q, qd (m, k). switches: times inside (0, T) where an acceleration jumps."""

    T: float
    at: Callable[[Array], tuple[Array, Array]]
    switches: tuple[float, ...] = ()


def trapezoid(v: float, a: float) -> tuple[float, Callable[[Array], tuple[Array, Array]], tuple[float, ...]]:
    """Share 0..1 from rest to rest with speed and acceleration of the share: T, (s, s'), switches."""
    ramp = min(v / a, np.sqrt(1 / a))
    peak = a * ramp
    T = 1 / peak + ramp

    def at(t: Array) -> tuple[Array, Array]:
        early, late = np.minimum(t, ramp), np.maximum(t - (T - ramp), 0.0)
        s = a * early**2 / 2 + peak * np.maximum(np.minimum(t, T - ramp) - ramp, 0) + peak * late - a * late**2 / 2
        return s, a * (early - late)

    return T, at, (ramp, T - ramp) if T - 2 * ramp > 1e-4 else (T / 2,)


def joint_move(plant: Plant, q_0: Array, q_1: Array, share: float = 1.0) -> Piece:
    """Straight in the joints, one profile as fast as axes and TCP allow (share of the greatest acceleration)."""
    way = np.abs(q_1 - q_0) + 1e-300
    v, a = float(np.min(plant.limits.velocity / way)), float(np.min(plant.limits.acceleration / way)) * share
    for _ in range(2):  # a second look, because the profile's shape changes with the first
        T, at, _ = trapezoid(v, a)
        times = np.linspace(0, T, 2000)
        s, sd = at(times)
        sdd = np.gradient(sd, times)
        q, qd, qdd = (q_0 + s[:, None] * (q_1 - q_0), *(x[:, None] * (q_1 - q_0) for x in (sd, sdd)))
        J = plant.robot.jacobian(q)
        V = (J @ qd[..., None])[..., 0]
        speed = np.linalg.norm(V[:, :3], axis=1).max()
        turning = np.linalg.norm(V[:, 3:], axis=1).max()
        acceleration = np.linalg.norm(forward_acceleration(plant.robot, q, qd, qdd)[:, :3], axis=1).max()
        slower = max(
            speed / (0.99 * plant.tcp.speed),
            np.sqrt(acceleration / (0.98 * plant.tcp.acceleration)),
            turning / (0.99 * V2500.v_ori),
            1.0,
        )
        v, a = v / slower, a / slower**2
    T, at, switches = trapezoid(v, a)

    def q_at(t: Array) -> tuple[Array, Array]:
        s, sd = at(t)
        return q_0 + s[:, None] * (q_1 - q_0), sd[:, None] * (q_1 - q_0)

    return Piece(T, q_at, switches)


def quintic(q_0: Array, v_0: Array, q_1: Array, v_1: Array, T: float) -> Piece:
    """Each axis a quintic with speeds at both ends and no acceleration there."""
    c = q_1 - q_0
    k3, k4, k5 = 10 * c - 6 * v_0 * T - 4 * v_1 * T, -15 * c + 8 * v_0 * T + 7 * v_1 * T, 6 * c - 3 * (v_0 + v_1) * T

    def at(t: Array) -> tuple[Array, Array]:
        u = (t / T)[:, None]
        q = q_0 + u * (v_0 * T + u * u * (k3 + u * (k4 + u * k5)))
        return q, v_0 + u * u * (3 * k3 + u * (4 * k4 + u * 5 * k5)) / T

    return Piece(T, at)


def arm_at(plant: Plant, X: Array, rail: Array | None, branch: int = 0) -> Array:
    """Axes (n, k) of poses on one branch, joints 4 and 6 without jumps."""
    q = inverse(plant.robot, X, rail)[:, branch]
    assert np.isfinite(q).all()
    q = np.unwrap(q, axis=0)
    return q if rail is None else np.c_[rail, q]


def line_move(
    plant: Plant,
    X_0: Array,
    X_1: Array,
    rail: Callable[[Array, Array], tuple[Array, Array]] | None,
    v: float,
    a: float,
    branch: int = 0,
    profile: tuple[float, Callable[[Array], tuple[Array, Array]], tuple[float, ...]] | None = None,
) -> Piece:
    """TCP on the line; rail(s or t.., s') gives position and speed of the rail. v, a of the share of the way."""
    T, at, switches = profile or trapezoid(v, a)
    chord = X_1[:3, 3] - X_0[:3, 3]
    axis, angle = axis_angle(X_0[:3, :3].T @ X_1[:3, :3])
    omega = X_0[:3, :3] @ axis * angle

    def q_at(t: Array) -> tuple[Array, Array]:
        s, sd = at(t)
        d, dd = (None, None) if rail is None else rail(t, np.c_[s, sd])
        q = arm_at(plant, Line(X_0, X_1).pose(s), d, branch)
        return q, inverse_velocity(plant.robot, q, sd[:, None] * np.r_[chord, omega], dd)

    return Piece(T, q_at, switches)


def hold(q: Array, T: float) -> Piece:
    return Piece(T, lambda t: (np.tile(q, (len(t), 1)), np.zeros((len(t), len(q)))))


def self_motion(
    plant: Plant, X: Array, rail: Callable[[Array], tuple[Array, Array]], T: float, **more: object
) -> Piece:
    """The TCP rests, the rail moves: rail(t) -> d, d'."""

    def at(t: Array) -> tuple[Array, Array]:
        d, dd = rail(t)
        q = arm_at(plant, np.tile(X, (len(t), 1, 1)), d)
        return q, inverse_velocity(plant.robot, q, np.zeros((len(t), 6)), dd)

    return Piece(T, at, **more)


def judged(program: Program, plant: Plant, *given: object, **more: object) -> Report:
    """What the judge says of a robot that is not held against itself, which takes a quarter of its time; no advice."""
    bare = replace(plant, robot=replace(plant.robot, self_pairs=()))
    return verify(program, bare, *given, **{"advice": False, **more})  # type: ignore[arg-type]


def rows_of(plant: Plant, pieces: Sequence[Piece], step: float = 4e-3, grid_only: bool = False) -> Trajectory:
    """Rows of all pieces: our own format, or (grid_only) the bare grid and the exact end."""
    starts = np.cumsum([0.0] + [piece.T for piece in pieces])
    marks = [starts]
    if not grid_only:
        marks += [start + np.array(piece.switches) for start, piece in zip(starts, pieces, strict=False)]
    marked = np.unique(np.concatenate(marks)) if not grid_only else np.array([0.0, starts[-1]])
    grid = np.arange(int(starts[-1] / step) + 1) * step
    after = np.searchsorted(marked[1:-1], grid) + 1
    near = np.minimum(np.abs(grid - marked[after - 1]), np.abs(grid - marked[after])) < 1e-5
    t = np.unique(np.r_[grid[~near], marked])
    q, qd = np.empty((len(t), len(plant.limits.names))), np.empty((len(t), len(plant.limits.names)))
    which = np.clip(np.searchsorted(starts, t, side="right") - 1, 0, len(pieces) - 1)
    for i, piece in enumerate(pieces):
        rows = which == i
        q[rows], qd[rows] = piece.at(np.clip(t[rows] - starts[i], 0, piece.T))
    return Trajectory(plant.limits.names, t, q, qd)


@dataclass(frozen=True)
class Case:
    plant: Plant
    program: Program
    pieces: tuple[Piece, ...]

    @property
    def starts(self) -> Array:
        """Start of every piece, and the end of the last, s."""
        return np.cumsum([0.0] + [piece.T for piece in self.pieces])

    def rows(self, **more: object) -> Trajectory:
        return rows_of(self.plant, self.pieces, **more)

    def swap(self, **pieces: Piece) -> Case:
        """The same with other pieces, by index: swap(p2=...)."""
        new = list(self.pieces)
        for name, piece in pieces.items():
            new[int(name[1:])] = piece
        return replace(self, pieces=tuple(new))


A_IN, A = down(0.5, 0.1, 0.45), down(0.5, 0.1, 0.37)
B_IN, B = down(0.5, 0.3, 0.45), down(0.45, 0.3, 0.40, 0.4)


def rail_share(d_0: float, d_1: float) -> Callable[[Array, Array], tuple[Array, Array]]:
    return lambda _, s: (d_0 + s[:, 0] * (d_1 - d_0), s[:, 1] * (d_1 - d_0))


def rapid_case(plant: Plant | None = None) -> Case:
    """Two stations; every axis rests at every stop, the rail in proportion to the path: legal for both targets."""
    return _rapid_case(plant or plant_with_rail())


@cache
def _rapid_case(plant: Plant) -> Case:
    d = [0.05, 0.08, 0.08, 0.12, 0.25, 0.28, 0.28 + 3.0 * 0.3**2 / 4]  # the last ride at full acceleration
    q = [arm_at(plant, X[None], np.array([rail]))[0] for X, rail in
         zip([A_IN, A, A, A_IN, B_IN, B, B], d, strict=True)]  # fmt: skip
    ride = trapezoid(1e9, 4 / 0.3**2)  # a triangle of 0.3 s
    motions = program(
        move_j(11, "p_a_in", A_IN, d[0]),
        move_l(12, "p_a", A, d[1]),
        wait(13, 0.1),
        move_l(14, "p_a_out", A_IN, d[3]),
        move_j(15, "p_b_in", B_IN, d[4]),
        move_l(16, "p_b", B, d[5]),
        wait(17, 0.3),
        home(18),
    )
    ride_back = self_motion(
        plant, B, lambda t: tuple(x * (d[6] - d[5]) + y for x, y in zip(ride[1](t), (d[5], 0.0), strict=True)), ride[0],
        switches=ride[2],
    )  # fmt: skip
    pieces = (
        joint_move(plant, plant.start, q[0]),
        line_move(plant, A_IN, A, rail_share(d[0], d[1]), 6.0, 60.0),
        hold(q[2], 0.1),
        line_move(plant, A, A_IN, rail_share(d[2], d[3]), 6.0, 60.0),
        joint_move(plant, q[3], q[4]),
        line_move(plant, B_IN, B, rail_share(d[4], d[5]), 5.0, 40.0),
        ride_back,
        joint_move(plant, q[6], plant.start),
    )
    return Case(plant, motions, pieces)


@cache
def stream_case() -> Case:
    """What only a stream can do, and every kind of move: the rail passes through two stops with speed, drives in a
    wait, a wait on a signal, a programmed move of the rail under a resting TCP, external axes alone, home."""
    plant = plant_with_rail()
    rate, d_0 = 0.1, 0.05
    q_a = arm_at(plant, A_IN[None], np.array([d_0]))[0]
    v_a = inverse_velocity(plant.robot, q_a[None], np.zeros((1, 6)), np.array([rate]))[0]
    share = trapezoid(5.0, 40.0)
    d_1 = d_0 + rate * share[0]
    stop_time = 0.2
    d_2 = d_1 + rate * stop_time / 2
    ride = trapezoid(1e9, 4 / 0.3**2)
    d_3 = d_2 - 0.03
    q_3 = arm_at(plant, A[None], np.array([d_3]))[0]
    q_4 = q_3 + np.r_[0.02, np.zeros(6)]
    motions = program(
        move_j(11, "p_a_in", A_IN),
        move_l(12, "p_a", A, d_0),
        wait(13, stop_time),
        wait(14, 0.05, "di_ready"),
        move_l(15, "p_b", A, d_3, duration=0.3),
        move_ext(16, d_3 + 0.02),
        home(17),
    )
    pieces = (
        quintic(plant.start, np.zeros(7), q_a, v_a, 0.8),
        line_move(plant, A_IN, A, lambda t, _: (d_0 + rate * t, np.full(len(t), rate)), 0, 0, profile=share),
        self_motion(
            plant, A, lambda t: (d_1 + rate * t - rate * t * t / (2 * stop_time), rate * (1 - t / stop_time)), stop_time
        ),
        hold(arm_at(plant, A[None], np.array([d_2]))[0], 0.05),
        self_motion(
            plant, A, lambda t: (d_2 + ride[1](t)[0] * (d_3 - d_2), ride[1](t)[1] * (d_3 - d_2)), ride[0],
            switches=ride[2],
        ),
        joint_move(plant, q_3, q_4),
        joint_move(plant, q_4, plant.start),
    )  # fmt: skip
    return Case(plant, motions, pieces)


HELD_RAILS = (0.05, 0.08, 0.11)


@cache
def held_case() -> Case:
    """A rail that is held on a line, in a wait, on a joint move and in a wait that follows a ride without a programmed
    time; free in the waits between: legal for both targets."""
    plant = plant_with_rail()
    d_0, d_1, d_2 = HELD_RAILS
    q_in, q_a, q_free, q_b, q_end = (
        arm_at(plant, X[None], np.array([d]))[0] for X, d in ((A_IN, d_0), (A, d_0), (A, d_1), (B_IN, d_1), (B_IN, d_2))
    )
    motions = program(
        move_j(11, "p_a_in", A_IN, d_0),
        move_l(12, "p_a", A, d_0, hold=Hold.PROGRAM),
        wait(13, 0.1, hold=Hold.GRIPPER),
        wait(14, 0.3),
        move_j(15, "p_b_in", B_IN, d_1, hold=Hold.CELL),
        move_l(16, "p_b_in", B_IN, d_2),
        wait(17, 0.1, hold=Hold.GRIPPER),
        home(18),
    )
    pieces = (
        joint_move(plant, plant.start, q_in),
        line_move(plant, A_IN, A, rail_share(d_0, d_0), 6.0, 60.0),
        hold(q_a, 0.1),
        ride(plant, A, d_0, d_1),
        joint_move(plant, q_free, q_b),
        ride(plant, B_IN, d_1, d_2),
        hold(q_end, 0.1),
        joint_move(plant, q_end, plant.start),
    )
    return Case(plant, motions, pieces)


def ride(plant: Plant, X: Array, d_0: float, d_1: float, T: float = 0.3) -> Piece:
    """The TCP rests, the rail goes from rest to rest as a triangle of speed."""
    T, at, switches = trapezoid(1e9, 4 / T**2)

    def rail(t: Array) -> tuple[Array, Array]:
        s, sd = at(t)
        return d_0 + s * (d_1 - d_0), sd * (d_1 - d_0)

    return self_motion(plant, X, rail, T, switches=switches)


def swayed(plant: Plant, X: Array, d: float, T: float, way: float) -> Piece:
    """The TCP rests for a time T, the rail goes away and comes back, smoothly."""

    def rail(t: Array) -> tuple[Array, Array]:
        phase = np.pi * t / T
        return d + way * np.sin(phase) ** 2, way * np.pi / T * np.sin(2 * phase)

    return self_motion(plant, X, rail, T)


@cache
def bench_case() -> Case:
    """Six axes on a bench, a tool 0.1 m long: joint moves, a line, a pure reorientation, a wait."""
    plant = plant_without_rail()
    tool = Tool("grip", pose(np.eye(3), [0.02, 0.0, 0.1]))
    flange = [X @ np.linalg.inv(tool.X_FT) for X in (B_IN, B)]
    X_up, X_low = B_IN, B
    X_turned = pose(X_low[:3, :3] @ rotation_about([0, 0, 1], 0.3), X_low[:3, 3])
    q = [arm_at(plant, X[None], None)[0] for X in (*flange, X_turned @ np.linalg.inv(tool.X_FT))]
    motions = program(
        move_j(11, "p_up", X_up, tool=tool),
        move_l(12, "p_low", X_low, tool=tool),
        move_l(13, "p_turned", X_turned, tool=tool),
        wait(14, 0.05),
        replace(home(15, None), tool=tool),
    )
    pieces = (
        joint_move(plant, plant.start, q[0], 0.5),
        tool_line(plant, X_up, X_low, tool, 4.0, 30.0),
        tool_line(plant, X_low, X_turned, tool, 4.0, 30.0),
        hold(q[2], 0.05),
        joint_move(plant, q[2], plant.start, 0.5),
    )
    return Case(plant, motions, pieces)


def tool_line(plant: Plant, X_0: Array, X_1: Array, tool: Tool, v: float, a: float) -> Piece:
    """A line of the tool's centre point, six axes."""
    T, at, switches = trapezoid(v, a)
    chord = X_1[:3, 3] - X_0[:3, 3]
    axis, angle = axis_angle(X_0[:3, :3].T @ X_1[:3, :3])
    twist = np.r_[chord, X_0[:3, :3] @ axis * angle]

    def q_at(t: Array) -> tuple[Array, Array]:
        s, sd = at(t)
        q = arm_at(plant, Line(X_0, X_1).pose(s) @ np.linalg.inv(tool.X_FT), None)
        return q, inverse_velocity(plant.robot, q, sd[:, None] * twist, None, tool.X_FT)

    return Piece(T, q_at, switches)


def faster(piece: Piece, factor: float) -> Piece:
    """The same path, every speed times factor."""

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = piece.at(np.minimum(t * factor, piece.T))
        return q, qd * factor

    return Piece(piece.T / factor, at, tuple(s / factor for s in piece.switches))


def nudged(plant: Plant, piece: Piece, twist: Sequence[float], height: float) -> Piece:
    """The TCP displaced by height * twist (m, rad) in the middle of the piece, smoothly, the rail as it is."""

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = piece.at(t)
        phase = np.pi * np.clip(t / piece.T, 0, 1)
        bump, rate = height * np.sin(phase) ** 2, height * np.pi / piece.T * np.sin(2 * phase)
        rail = np.zeros(len(t)) if plant.robot.has_rail else None
        unit = inverse_velocity(plant.robot, q, np.tile(np.asarray(twist, dtype=float), (len(t), 1)), rail)
        return q + unit * bump[:, None], qd + unit * rate[:, None]

    return Piece(piece.T, at, piece.switches)
