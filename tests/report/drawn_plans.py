"""Small plans made without the optimiser: bang-bang joint moves from rest to rest, and a wait between them."""

from __future__ import annotations

from dataclasses import dataclass
from io import BytesIO
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import (
    NO_EXTERNAL_AXES,
    ConfData,
    MoveAbsJ,
    MoveJ,
    Program,
    Source,
    Span,
    Speed,
    Tool,
    Wait,
    Written,
    Zone,
)
from trajopt_cli.problem.corners import Corners
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import inverse
from trajopt_cli.robot.model import load_robot
from trajopt_cli.runs.summary import Summary, summary
from trajopt_cli.trajectory import Trajectory

HOME = np.array([0, 0, 0, 0, 0, np.pi / 6])
DOWN = rotation_about([0, 1, 0], np.pi)
TOOL = Tool("tTip", pose(np.eye(3), [0, 0, 0.05]))
V = Speed("v800", 0.8, 8.7, 5.0, 17.0)
PAUSE = 0.4  # s

_SAVE = Figure.savefig


def as_svg(figure: Figure, file: BytesIO, **how: Any) -> None:
    """In place of Figure.savefig: SVG, and of the rail PNG, which comes from the same figure in the same way."""
    if how["format"] == "svg" or how["metadata"]["Title"] == "cell: rail":
        _SAVE(figure, file, **how)


@dataclass(frozen=True)
class Drawn:
    program: Program
    plant: Plant
    plan: Plan


def drawn(rail: bool) -> Drawn:
    """Home, a point over a table, a wait, a second point, home; the rail moves with the joints."""
    robot = load_robot("irb140_rail" if rail else "irb140")
    base = robot.profile()
    lower, upper = np.array(base.lower), np.array(base.upper)
    if rail:
        lower[0], upper[0] = -0.2, 1.2
    limits = JointLimits(base.names, lower, upper, base.velocity, base.acceleration)
    start = np.r_[[0.0] if rail else [], HOME]
    plant = Plant(robot, limits, TcpCaps(2.5, 20.0), start, (0,) if rail else (), False, False, frozenset())
    X = [pose(DOWN, [0.45, y, 0.35]) for y in ((0.1, 0.7) if rail else (-0.2, 0.2))]
    rails = (0.15, 0.5) if rail else (None, None)
    q = [start, *(_axes(plant, X_WT, d) for X_WT, d in zip(X, rails, strict=True)), start]
    motions = (_move(1, "p_one", X[0]), _wait(2), _move(3, "p_two", X[1]), _home(4))
    pieces = [_bang(limits, q[0], q[1]), _hold(q[1]), _bang(limits, q[1], q[2]), _bang(limits, q[2], q[3])]
    rows, planned, t = [], [], 0.0
    for i, (motion, (times, p, v)) in enumerate(zip(motions, pieces, strict=True)):
        last = len(times) if i == 3 else len(times) - 1
        rows.append((t + times[:last], p[:last], v[:last]))
        planned.append(PlannedMotion(i, motion.source, t, t + times[-1], p[0], p[-1], "joint_1 acceleration"))
        t += times[-1]
    trajectory = Trajectory(base.names, *(np.concatenate(column) for column in zip(*rows, strict=True)))
    plan = Plan(Target.STREAM, trajectory, tuple(planned), 0.5 * t, "none")
    return Drawn(Program("main", motions, {}), plant, plan)


def many(count: int) -> Drawn:
    """Joint moves to and fro over a table, without a rail, to targets with long names."""
    few = drawn(rail=False)
    plant = few.plant
    X = [pose(DOWN, [0.4 + 0.002 * k, 0.25 - 0.5 * (k % 10) / 9, 0.25 + 0.1 * (k % 2)]) for k in range(count)]
    q = [plant.start, *(_axes(plant, X_WT, None) for X_WT in X)]
    names = [f"p_station_{k:02d}_left_magazine_position_{k:02d}" for k in range(count)]
    motions = tuple(_move(k, name, X_WT) for k, (name, X_WT) in enumerate(zip(names, X, strict=True)))
    rows, planned, t = [], [], 0.0
    for i, motion in enumerate(motions):
        times, p, v = _bang(plant.limits, q[i], q[i + 1])
        last = len(times) if i == count - 1 else len(times) - 1
        rows.append((t + times[:last], p[:last], v[:last]))
        planned.append(PlannedMotion(i, motion.source, t, t + times[-1], p[0], p[-1], "joint_1 acceleration"))
        t += times[-1]
    names_of_axes = plant.limits.names
    trajectory = Trajectory(names_of_axes, *(np.concatenate(column) for column in zip(*rows, strict=True)))
    plan = Plan(Target.RAPID, trajectory, tuple(planned), None, "none")
    return Drawn(Program("main", motions, {}), plant, plan)


def _axes(plant: Plant, X_WT: Array, rail: float | None) -> Array:
    X_WF = X_WT @ np.linalg.inv(TOOL.X_FT)
    q = inverse(plant.robot, X_WF[None], None if rail is None else np.array([rail]))[0, 0]
    assert np.isfinite(q).all()
    return np.r_[[] if rail is None else [rail], q]


def _bang(limits: JointLimits, q_0: Array, q_1: Array) -> tuple[Array, Array, Array]:
    """Half accelerating, half braking: the axis that needs longest is at its full acceleration, or top speed."""
    way = np.abs(q_1 - q_0)
    T = float(max(np.max(2 * np.sqrt(way / limits.acceleration)), np.max(2 * way / limits.velocity)))
    t = np.linspace(0, T, 2 * int(np.ceil(T / 2e-3)) + 1)
    a = 4 * (q_1 - q_0) / T**2
    late = np.maximum(t - T / 2, 0)
    s = t**2 / 2 - late**2
    return t, q_0 + s[:, None] * a, (t - 2 * late)[:, None] * a


def _hold(q: Array) -> tuple[Array, Array, Array]:
    t = np.linspace(0, PAUSE, 101)
    return t, np.tile(q, (101, 1)), np.zeros((101, len(q)))


_WRITTEN = Written(Span("t.mod", 0, 1))


def _move(line: int, name: str, X: Array) -> MoveJ:
    return MoveJ(
        source=Source("t.mod", line, 1), written=_WRITTEN, target=name, speed=V, zone=Zone("fine", True),
        extax=NO_EXTERNAL_AXES, X_WT=X, conf=ConfData(0, 0, 0, 0), tool=TOOL,
    )  # fmt: skip


def _wait(line: int) -> Wait:
    return Wait(source=Source("t.mod", line, 1), written=_WRITTEN, duration=PAUSE)


def _home(line: int) -> MoveAbsJ:
    return MoveAbsJ(
        source=Source("t.mod", line, 1), written=_WRITTEN, target="j_home", speed=V, zone=Zone("fine", True),
        extax=NO_EXTERNAL_AXES, q=HOME, tool=TOOL,
    )  # fmt: skip


def summarized(program: Program, plant: Any, plans: Any, before: Plan | str, notes: Any = ()) -> Summary:
    """What the pipeline says of them."""
    kept = dict.fromkeys(Target, ())
    passed = dict.fromkeys(Target, 0)
    return summary(program, plant, Target.STREAM, plans, before, kept, Corners({}, {}), passed, ["a warning"], notes)
