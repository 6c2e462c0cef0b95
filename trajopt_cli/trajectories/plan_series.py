"""What pictures and pages of a plan are drawn from: everything over time, once, in SI."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, inverse_pose
from trajopt_cli.motion import MoveAbsJ, MoveExtJ, MoveJ, PoseMove, Program, Wait
from trajopt_cli.problem.corners import corners_of, passed_in
from trajopt_cli.problem.detours import unfolded, with_detours
from trajopt_cli.problem.loads import loads_of
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.tool_turns import turned
from trajopt_cli.robot.dynamics import Dynamics
from trajopt_cli.trajectory import hermite

_EDGE = 1 + 1e-6  # of a zone: its edge is inside
_STANDS = 1e-6  # m: the tool's centre point in a zone between turns in place


@dataclass(frozen=True, eq=False)
class TimedMotion:
    """A move or a wait of the plan that was not dropped: from t_0 to t_1 [s], its motion, the tool in force.

    q_1 (k,): axes at its point. zone [m]: how near the tool comes to a point that it passes in a corner; t_1 is then in
    the middle of that. 0 at a stop.
    """

    t_0: float
    t_1: float
    motion: PoseMove | MoveAbsJ | MoveExtJ | Wait
    X_FT: Array
    q_1: Array
    zone: float = 0.0

    @property
    def passed(self) -> bool:
        """Whether the plan does not stop at its end."""
        return self.zone > 0

    @property
    def added(self) -> bool:
        """Whether it leads to a point that the plan adds on a way around obstacles."""
        return not isinstance(self.motion, Wait) and bool(self.motion.detour)

    @property
    def name(self) -> str:
        """The target as the program writes it; "" for a wait."""
        return "" if isinstance(self.motion, Wait) else self.motion.target


@dataclass(frozen=True, eq=False)
class PlanSeries:
    """A plan sampled at both ends of every interval between its rows, so that each jump of an acceleration is whole.

    t (n,) [s]; q, qd, qdd (n, k); X_WT (n, 4, 4) and V_WT (n, 6) of the TCP with the tool in force. legs in order.
    """

    program: Program
    plant: Plant
    plan: Plan
    below: str
    legs: tuple[TimedMotion, ...]
    t: Array
    q: Array
    qd: Array
    qdd: Array
    X_WT: Array
    V_WT: Array

    @property
    def rail(self) -> Array:
        """Where the carriage stands in the world (n, 3) [m], from the rail's 0; zeros without a rail."""
        return self.plant.robot.way_at(self.q)

    @property
    def rail_speed(self) -> Array:
        """The carriage's velocity in the world (n, 3) [m/s]."""
        return self.plant.robot.way_at(self.qd)

    @property
    def moves(self) -> list[TimedMotion]:
        """The legs that move."""
        return [leg for leg in self.legs if not isinstance(leg.motion, Wait)]

    def during(self, leg: TimedMotion) -> slice:
        """The samples of a leg, both ends included."""
        return slice(int(np.searchsorted(self.t, leg.t_0)), int(np.searchsorted(self.t, leg.t_1, side="right")))

    @cached_property
    def points(self) -> Array:
        """The points that the moves lead to (m, 3) [m], as programmed: those that are passed lie beside the path."""
        X_WT = [self.plant.robot.forward(leg.q_1) @ leg.X_FT for leg in self.moves]
        return np.reshape([X[:3, 3] for X in X_WT], (-1, 3))

    @cached_property
    def passed(self) -> BoolArray:
        """Which of them are passed (m,)."""
        return np.array([leg.passed for leg in self.moves], dtype=bool)

    @cached_property
    def added(self) -> BoolArray:
        """Which of them the plan has added (m,)."""
        return np.array([leg.added for leg in self.moves], dtype=bool)

    @cached_property
    def corners(self) -> list[slice]:
        """The samples inside the zones of the points that are passed, in order."""
        out = []
        for leg, point in zip(self.moves, self.points, strict=True):
            if leg.passed:
                near = np.linalg.norm(self.X_WT[:, :3, 3] - point, axis=1) <= leg.zone * _EDGE
                middle = self.at(leg.t_1)
                before, after = np.flatnonzero(~near[:middle]), np.flatnonzero(~near[middle:])
                first = int(before[-1]) if before.size else 0
                out.append(slice(first, middle + int(after[0]) + 1 if after.size else len(near)))
        return out

    def at(self, time: float) -> int:
        """The last sample not after time [s]."""
        return max(int(np.searchsorted(self.t, time, side="right")) - 1, 0)


def follow(program: Program, plant: Plant, plan: Plan, title: str, times: Array | None = None) -> PlanSeries:
    """Sample a plan. title: the program's name for people. times (n,) [s]: inside it, in order; None for both ends of
    every interval. Raises ValueError for a trajectory without speeds."""
    program = turned(program, plan.turns)
    legs = legs_of(program, plant, plan)
    rows = plan.trajectory.t
    if times is None:
        times = np.append(np.column_stack([rows[:-1], before(rows[1:])]).ravel(), rows[-1])
    t = times
    q, qd, qdd = hermite(plan.trajectory, t)
    X_WF = plant.robot.forward(q)
    X_WT, V_WT = np.empty_like(X_WF), np.empty((len(t), 6))
    for tool, part in _tools(legs, t, first_tool(program)):
        X_WT[part] = X_WF[part] @ tool
        V_WT[part] = plant.robot.differential(q[part], tool).velocity(qd[part])
    below = f"{title} · {plan.target.in_words} · cycle {plan.duration:.3f} s"
    return PlanSeries(program, plant, plan, below, legs, t, q, qd, qdd, X_WT, V_WT)


def before(times: Array) -> Array:
    """The last numbers before times: of a row, it still belongs to the interval that ends there."""
    return np.nextafter(times, -np.inf)


def first_tool(program: Program) -> Array:
    """X_FT (4, 4) of the first move with a tool: a program may wait, or move external axes, before that; then that tool
    counts from the start."""
    tools = (m.tool.X_FT for m in program.motions if isinstance(m, PoseMove | MoveAbsJ))
    return next(tools, np.eye(4))


def legs_of(program: Program, plant: Plant, plan: Plan) -> tuple[TimedMotion, ...]:
    """The moves and waits of a plan that take time, in order; a way around obstacles has a leg to each point of it."""
    program, plan = with_detours(program, plant, plan.detours), unfolded(plan)
    legs: list[TimedMotion] = []
    passed = passed_in(program, plant, plan)
    zones = corners_of(program, plant, {motion.index for motion in plan.motions if motion.dropped}).passed
    X_FT = first_tool(program)
    for planned in plan.motions:
        motion = program.motions[planned.index]
        if planned.dropped or not isinstance(motion, PoseMove | MoveAbsJ | MoveExtJ | Wait):
            continue
        if isinstance(motion, PoseMove | MoveAbsJ):
            X_FT = motion.tool.X_FT
        if planned.t_1 > planned.t_0:
            zone = 0.0
            if planned.index in passed:
                zone = _STANDS if zones[planned.index].in_place else zones[planned.index].radius
            legs.append(TimedMotion(planned.t_0, planned.t_1, motion, X_FT, planned.q_1, zone))
    return tuple(legs)


def _tools(legs: tuple[TimedMotion, ...], t: Array, first: Array) -> list[tuple[Array, slice]]:
    """Each tool and the samples it is in force for, without a gap. first: where there are no legs."""
    if not legs:
        return [(first, slice(0, len(t)))]
    cuts = [0, *(int(np.searchsorted(t, leg.t_0)) for leg in legs[1:]), len(t)]
    return [(leg.X_FT, slice(a, b)) for leg, a, b in zip(legs, cuts, cuts[1:], strict=False)]


def target_flange(leg: TimedMotion) -> Array | None:
    """The flange pose X_WF (4, 4) a leg ends in, where the program names a pose; None for joints and waits."""
    if isinstance(leg.motion, PoseMove):
        return leg.motion.X_WT @ inverse_pose(leg.motion.tool.X_FT)
    return None


def programmed_speed(plant: Plant, motion: object) -> float | None:
    """The TCP speed [m/s] a motion is held to; None for waits, \\T, external axes and where the cell frees it."""
    if isinstance(motion, Wait | MoveExtJ):
        return None
    if isinstance(motion, MoveJ | MoveAbsJ) and plant.free_speed:
        return None
    return None if motion.duration is not None else motion.speed.v_tcp  # type: ignore[attr-defined]


def torques_along(series: PlanSeries) -> Array:
    """Torques (n, k) [Nm, N for a rail] of all axes at the samples, with what is carried there."""
    robot = series.plant.robot
    carried = dict(zip(map(id, series.program.motions), loads_of(series.program), strict=True))
    out = np.zeros_like(series.q)
    for leg in series.legs:
        at = series.during(leg)
        dynamics = Dynamics(robot, carried[id(leg.motion)], rotor=robot.rotor)
        out[at] = dynamics.torque(series.q[at], series.qd[at], series.qdd[at])
    return out
