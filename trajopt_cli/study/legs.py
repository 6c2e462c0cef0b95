"""The fixed-rail plan's legs: what remains to be timed when rail positions and configurations are given.

Rows that time a motion by other means than the optimiser's take from its fixed-rail plan where the rail stands at
every point and which branch the arm is in, and nothing else. Legs with corners between them, and arcs, are driven on
the course that the plan is driven on, too.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from trajopt_cli.geometry import Array, IndexArray, inverse_pose
from trajopt_cli.motion import (
    Motion,
    Move,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    SignalEvent,
    Wait,
    motion_name,
    turned_under,
)
from trajopt_cli.path.line import Line
from trajopt_cli.path_timing.sampled_path import SampledPath, course_of
from trajopt_cli.problem.acceleration_settings import acceleration_share, path_acceleration, tcp_acceleration
from trajopt_cli.problem.corners import corners_of, passed_in
from trajopt_cli.problem.decision_scope import FIXED_RAIL
from trajopt_cli.problem.detours import unfolded, with_detours
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem, build_problem
from trajopt_cli.robot.kinematics import inverse_acceleration, inverse_velocity
from trajopt_cli.settings import RUN_NODES
from trajopt_cli.study.case import Case
from trajopt_cli.trajectories.axes import Axes

_NODES = 401  # of a line's table: at 0.5 m 1.2 mm apart
_ON_BRANCH = 1e-6  # rad: axes are what a branch says
_CAPS = ("speed", "acceleration", "v_tcp", "a_tcp", "v_ori")


class BaselineLegKind(Enum):
    """How a leg moves: axes free on the way, the TCP on its line (or resting while the rail moves), or not at all."""

    JOINT = "joint"
    LINE = "line"
    HOLD = "hold"


@dataclass(frozen=True, eq=False)
class BaselineLeg:
    """From point to point. index: of its motion in the program carried out. q_0, q_1 (k,): axes at both ends, at a
    fly-by as if it stopped there.

    X_FT: tool in force. v_tcp, a_tcp, v_ori, v_rail: caps in force, infinite for none. share: of the axes' acceleration
    limits in force. duration: programmed time [s] or None. span: when the fixed-rail plan makes it [s].
    """

    index: int
    motion: Motion
    kind: BaselineLegKind
    q_0: Array
    q_1: Array
    X_FT: Array
    v_tcp: float
    a_tcp: float
    v_ori: float
    v_rail: float
    duration: float | None
    span: tuple[float, float]
    share: float = 1.0

    @property
    def name(self) -> str:
        """The motion's kind and target."""
        return motion_name(self.motion)

    @property
    def key(self) -> bytes:
        """Equal for legs that ask for the same motion."""
        numbers = np.array([self.v_tcp, self.a_tcp, self.v_ori, self.v_rail, self.share, self.duration or np.nan])
        arrays = (self.q_0, self.q_1, self.X_FT, numbers)
        return self.kind.value.encode() + b"".join(np.asarray(x).tobytes() for x in arrays)

    @property
    def lasts(self) -> float:
        """How long a leg that holds still takes [s]."""
        return self.span[1] - self.span[0] if self.duration is None else self.duration

    def refusal(self, why: str) -> Infeasible:
        """The answer no, for a reason in one clause."""
        return Infeasible(self.index, self.motion.source, f"{self.name} {why}")


@dataclass(frozen=True, eq=False)
class StopToStop:
    """The legs from one stop to the next. course: where they lead, for an arc and for legs with corners between them;
    None for a joint move, a line or a hold alone."""

    legs: tuple[BaselineLeg, ...]
    course: SampledPath | None = None

    @property
    def least(self) -> float:
        """What positioners, waits beside its moves and other robots leave it at least [s]."""
        moves = [leg.motion for leg in self.legs if isinstance(leg.motion, Move)]
        return moves[0].least if len(self.legs) == 1 == len(moves) else sum(move.partner or 0.0 for move in moves)

    @property
    def key(self) -> bytes:
        """Equal for runs that ask for the same motion."""
        led = () if self.course is None else (self.course.sigma, self.course.along.q)
        return b"".join(leg.key for leg in self.legs) + b"".join(x.tobytes() for x in led)

    @property
    def span(self) -> tuple[float, float]:
        """When the fixed-rail plan makes it [s]."""
        return self.legs[0].span[0], self.legs[-1].span[1]


@dataclass(frozen=True, eq=False)
class FixedRail:
    """program: what is carried out, without the motions the plan drops. runs: all that takes time, in order. stops: at
    how many fly-bys that could be passed the plan stops, because it is faster so."""

    program: Program
    plan: Plan
    runs: tuple[StopToStop, ...]
    stops: int = 0

    @property
    def end(self) -> Array | None:
        """Axes (k,) where it all ends; None where nothing takes time."""
        return self.runs[-1].legs[-1].q_1 if self.runs else None

    @property
    def notes(self) -> tuple[str, ...]:
        """What the plan decided besides, for the reader of a row made from it."""
        left_out = sum(motion.dropped for motion in self.plan.motions)
        told = {
            f"optional motions left out as in the fixed-rail plan: {left_out}": left_out,
            f"fly-by points that are stops as in the fixed-rail plan, which is faster so: {self.stops}": self.stops,
        }
        return tuple(line for line, count in told.items() if count)


def fixed_rail(case: Case) -> FixedRail | Infeasible:
    """The case's fixed-rail plan cut into runs, or why there is none."""
    for i, motion in enumerate(case.program.motions):
        if turned_under(motion):
            why = "is drawn on a work object that turns meanwhile; this method knows only ways that lie still"
            return Infeasible(i, motion.source, f"{motion_name(motion)} {why}")
    plan = case.solve(case.program, Target.STREAM, FIXED_RAIL)
    if isinstance(plan, Infeasible):
        return plan
    plant, there, plan = case.plant, with_detours(case.program, case.plant, plan.detours), unfolded(plan)
    kept = [motion for motion in plan.motions if not motion.dropped]
    program = replace(there, motions=tuple(there.motions[motion.index] for motion in kept))
    X_FT = np.eye(4)
    legs: list[BaselineLeg] = []
    for index, planned in enumerate(kept):
        motion = program.motions[index]
        if not isinstance(motion, Wait | SignalEvent | MoveExtJ):
            X_FT = np.asarray(motion.tool.X_FT)
        if planned.t_1 > planned.t_0:
            legs.append(_leg(plant, index, motion, X_FT, planned.q_0, planned.q_1, (planned.t_0, planned.t_1)))
    own = {motion.index: i for i, motion in enumerate(kept)}
    passed = {own[index] for index in passed_in(there, plant, plan)}
    stops = len(corners_of(program, plant).passed) - len(passed)
    return FixedRail(program, plan, tuple(_runs(program, plant, legs, passed, bool(passed) or stops > 0)), stops)


def _runs(
    program: Program, plant: Plant, legs: list[BaselineLeg], passed: Collection[int], corners: bool
) -> Iterator[StopToStop]:
    """passed: the motions at whose end the plan stops not. corners: whether there are points that could be passed."""
    if not corners and not any(isinstance(leg.motion, MoveC) for leg in legs):
        yield from (StopToStop((leg,)) for leg in legs)
        return
    problem = build_problem(program, plant, FIXED_RAIL, Target.STREAM, everything(program, plant))
    assert isinstance(problem, Problem)  # there is a plan for it
    legs = [_at_its_speed(leg, problem) for leg in legs]
    after = {leg.motion: k + 1 for k, leg in enumerate(problem.legs)}
    known = {after[leg.index]: leg.q_1 for leg in legs}
    q = np.tile(plant.start, (len(problem.waypoints), 1))
    for k in range(1, len(q)):
        q[k] = known.get(k, q[k - 1])  # a leg without a way takes no time
    cfx = [_branch(plant, axes) for axes in q]
    run: list[BaselineLeg] = []
    for leg in legs:
        run.append(leg)
        if leg.index in passed:
            continue
        ends = after[run[0].index] - 1, after[leg.index]
        course = None
        if len(run) > 1 or isinstance(leg.motion, MoveC):
            course = course_of(Axes.of(plant), problem, ends, q, cfx, RUN_NODES)
            if course is None:
                raise ValueError(f"{leg.motion.source}: {leg.name} has no course, although the fixed-rail plan has one")
        yield StopToStop(tuple(run), course)
        run = []


def _at_its_speed(leg: BaselineLeg, problem: Problem) -> BaselineLeg:
    """A leg whose programmed time stands for a speed in the plan, beside a fly-by, at that speed."""
    if leg.duration is None or not isinstance(leg.motion, Move):
        return leg
    planned = next(one for one in problem.legs if one.motion == leg.index)
    if planned.duration is not None:
        return leg
    return replace(leg, duration=None, v_tcp=planned.v_tcp, v_ori=planned.v_ori)


def _branch(plant: Plant, q: Array) -> int:
    """The branch (cfx) that axes (k,) are on; -1 at a singularity, where they are on none."""
    layout = plant.robot.layout
    found = plant.robot.branches(plant.robot.forward(q)[None], layout.place(q[None]))[0]
    off = found - q[layout.arm]
    apart = np.nan_to_num(np.abs(off - _whole_turns(off)).max(axis=1), nan=np.inf)
    return int(np.argmin(apart)) if apart.min() < _ON_BRANCH else -1


def _leg(
    plant: Plant, index: int, motion: Motion, X_FT: Array, q_0: Array, q_1: Array, span: tuple[float, float]
) -> BaselineLeg:
    """A leg with the caps that the judge holds against it."""
    v_tcp, a_tcp, v_ori, v_rail, duration = plant.tcp.speed, plant.tcp.acceleration, np.inf, np.inf, None
    kind, share = BaselineLegKind.HOLD, 1.0
    if isinstance(motion, Wait | SignalEvent):
        duration = motion.duration if isinstance(motion, Wait) else None
    else:
        duration = None if motion.duration is None else max(motion.duration, motion.least)
        moves = bool(np.abs(q_1 - q_0).max() > 0)
        kind = (
            BaselineLegKind.HOLD
            if not moves
            else BaselineLegKind.LINE
            if isinstance(motion, MoveL | MoveC)
            else BaselineLegKind.JOINT
        )
        a_tcp, share = tcp_acceleration(motion, plant.tcp), acceleration_share(motion)
        a_tcp = min(a_tcp, *(path_acceleration(motion, plant.tcp) or (a_tcp,)))  # these rows know no other cap
        free = plant.free_speed and isinstance(motion, MoveJ | MoveAbsJ)
        if duration is None and not free:  # a programmed time replaces the speed
            v_rail = motion.speed.v_leax or np.inf
            if not isinstance(motion, MoveExtJ):
                v_tcp, v_ori = min(v_tcp, motion.speed.v_tcp), motion.speed.turning
    return BaselineLeg(index, motion, kind, q_0, q_1, X_FT, v_tcp, a_tcp, v_ori, v_rail, duration, span, share)


@dataclass(frozen=True, eq=False)
class LegLimits:
    """Limits in force: of the axes' speeds and accelerations (k,), of the TCP's speed, acceleration and turning. At n
    samples all of them may differ, (n, k) and (n,), and the tool, (n, 4, 4)."""

    speed: Array
    acceleration: Array
    v_tcp: Array | float
    a_tcp: Array | float
    v_ori: Array | float
    X_FT: Array


def caps_of(plant: Plant, leg: BaselineLeg) -> LegLimits:
    """What is in force on a leg; the rail's speed is the programmed one."""
    speed, rail = np.array(plant.limits.velocity), plant.layout.rail
    speed[rail] = np.minimum(speed[rail], leg.v_rail)
    return LegLimits(speed, plant.limits.acceleration * leg.share, leg.v_tcp, leg.a_tcp, leg.v_ori, leg.X_FT)


def caps_in(plant: Plant, run: StopToStop, t: Array) -> LegLimits:
    """What is in force at times t (n,) [s] of the fixed-rail plan."""
    i = np.searchsorted([leg.span[1] for leg in run.legs[:-1]], t, side="right")
    return caps_on([caps_of(plant, leg) for leg in run.legs], i)


def caps_on(caps: Sequence[LegLimits], i: IndexArray) -> LegLimits:
    """What is in force on each of these legs (n,) of a run, of whose legs caps are."""
    arrays = {name: np.array([getattr(one, name) for one in caps])[i] for name in _CAPS}
    tools = np.array([one.X_FT for one in caps])
    return LegLimits(**arrays, X_FT=tools[0] if (tools == tools[0]).all() else tools[i])


@dataclass(frozen=True, eq=False)
class Use:
    """The largest shares of limits that a motion uses at samples (n,): of any axis' speed and acceleration, of the
    TCP's speed and turning, and of its acceleration."""

    speed: Array
    acceleration: Array
    tcp_speed: Array
    tcp_acceleration: Array

    @property
    def any_speed(self) -> Array:
        """Of speeds (n,), axes or TCP."""
        return np.maximum(self.speed, self.tcp_speed)

    @property
    def any_acceleration(self) -> Array:
        """Of accelerations (n,), axes or TCP."""
        return np.maximum(self.acceleration, self.tcp_acceleration)

    @property
    def slowing(self) -> float:
        """By what factor the motion must be slowed down as a whole to use its limits to 1 at most."""
        return max(float(self.any_speed.max()), float(np.sqrt(self.any_acceleration.max())))


def use_of(plant: Plant, caps: LegLimits, q: Array, qd: Array, qdd: Array) -> Use:
    """Use of limits at samples q, qd, qdd (n, k)."""
    V, A = tool_rates(plant, caps.X_FT, q, qd, qdd)
    moving, turning = np.linalg.norm(V[:, :3], axis=1), np.linalg.norm(V[:, 3:], axis=1)
    return Use(
        np.max(np.abs(qd) / caps.speed, axis=1),
        np.max(np.abs(qdd) / caps.acceleration, axis=1),
        np.maximum(moving / caps.v_tcp, turning / caps.v_ori),
        np.linalg.norm(A, axis=1) / caps.a_tcp,
    )


def tool_rates(plant: Plant, X_FT: Array, q: Array, dq: Array, ddq: Array) -> tuple[Array, Array]:
    """The TCP's twist (n, 6) and the second derivative of its position (n, 3), by whatever dq and ddq (n, k) are by.
    X_FT: (4, 4) or (n, 4, 4)."""
    motion = np.empty((len(q), 2, 6))
    tools, which = np.unique(np.reshape(X_FT, (-1, 16)), axis=0, return_inverse=True)
    for i, tool in enumerate(tools):
        rows = np.broadcast_to(which.ravel() == i, len(q))
        motion[rows] = plant.robot.differential(q[rows], tool.reshape(4, 4)).motion(dq[rows], ddq[rows])
    return motion[:, 0], motion[:, 1, :3]


@dataclass(frozen=True, eq=False)
class JointsOnLine:
    """The joints on a line leg over the share s of its way, the rail in proportion; exact on the leg's branch.

    line: the tool's. s (n,): the table's places. q (n, k) there.
    """

    plant: Plant
    leg: BaselineLeg
    line: Line
    cfx: int
    s: Array
    q: Array

    @classmethod
    def of(cls, plant: Plant, leg: BaselineLeg) -> JointsOnLine:
        """The line between a leg's ends, on the branch that q_0 is on."""
        line = Line(plant.robot.forward(leg.q_0) @ leg.X_FT, plant.robot.forward(leg.q_1) @ leg.X_FT)
        s = np.linspace(0.0, 1.0, _NODES)
        start = _branches(plant, leg, line, s[:1])[0]
        joints = leg.q_0[plant.robot.layout.arm]
        turned = start + _whole_turns(joints - start)
        cfx = int(np.nanargmin(np.abs(turned - joints).max(axis=1)))
        arm = _branches(plant, leg, line, s)[:, cfx]
        arm = np.unwrap(arm, axis=0)
        arm += _whole_turns(joints - arm[0])
        return cls(plant, leg, line, cfx, s, plant.robot.layout.join(_rail_at(plant, leg, s), arm))

    def positions(self, s: Array) -> Array:
        """Axes (m, k) at shares s (m,)."""
        arm = _branches(self.plant, self.leg, self.line, s)[:, self.cfx]
        near = np.column_stack([np.interp(s, self.s, column) for column in self.q[:, self.plant.robot.layout.arm].T])
        rail = _rail_at(self.plant, self.leg, s)
        return self.plant.robot.layout.join(rail, arm + _whole_turns(near - arm))

    def slopes(self, q: Array) -> Array:
        """dq/ds (m, k) at axes q (m, k) on the line."""
        return inverse_velocity(self.plant.robot, q, self.line.twist(np.zeros(len(q))), self._rail_way, self.leg.X_FT)

    def bends(self, q: Array, slopes: Array) -> Array:
        """d2q/ds2 (m, k) there."""
        still = np.zeros((len(q), 6))
        return inverse_acceleration(self.plant.robot, q, slopes, still, 0.0, self.leg.X_FT)

    @property
    def _rail_way(self) -> float:
        return float(self.plant.robot.layout.place(self.leg.q_1 - self.leg.q_0))


def _whole_turns(difference: Array) -> Array:
    return np.asarray(2 * np.pi * np.round(difference / (2 * np.pi)))


def _rail_at(plant: Plant, leg: BaselineLeg, s: Array) -> Array:
    d_0, d_1 = (plant.robot.layout.place(q) for q in (leg.q_0, leg.q_1))
    return d_0 + s * (d_1 - d_0)


def _branches(plant: Plant, leg: BaselineLeg, line: Line, s: Array) -> Array:
    """Joints (m, branches, joints) of all branches at shares s (m,) of the line."""
    X_WF = line.pose(s) @ inverse_pose(leg.X_FT)
    return plant.robot.branches(X_WF, _rail_at(plant, leg, s))
