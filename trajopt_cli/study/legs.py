"""The fixed-rail plan's legs: what remains to be timed when rail positions and configurations are given.

Rows that time a motion by other means than the optimiser's take from its fixed-rail plan where the rail stands at
every stop and which branch the arm is in, and nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Motion, MoveAbsJ, MoveExtJ, MoveJ, MoveL, Program, SignalEvent, Wait, motion_name
from trajopt_cli.path.line import Line
from trajopt_cli.problem.freedom import FIXED_RAIL
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.kinematics import inverse_acceleration, inverse_velocity
from trajopt_cli.study.case import Case

_NODES = 401  # of a line's table: at 0.5 m 1.2 mm apart
_POINT = 1e-9  # m, rad: a line to where it starts


class LegKind(Enum):
    """How a leg moves: axes free on the way, the TCP on its line (or resting while the rail moves), or not at all."""

    JOINT = "joint"
    LINE = "line"
    HOLD = "hold"


@dataclass(frozen=True, eq=False)
class Leg:
    """From rest to rest. index: of its motion in the program carried out. q_0, q_1 (k,): axes at both ends.

    X_FT: tool in force. v_tcp, a_tcp, v_ori, v_rail: caps in force, infinite for none. duration: programmed time [s] or
    None. span: when the fixed-rail plan makes it [s].
    """

    index: int
    motion: Motion
    kind: LegKind
    q_0: Array
    q_1: Array
    X_FT: Array
    v_tcp: float
    a_tcp: float
    v_ori: float
    v_rail: float
    duration: float | None
    span: tuple[float, float]

    @property
    def name(self) -> str:
        """The motion's kind and target."""
        return motion_name(self.motion)

    @property
    def key(self) -> bytes:
        """Equal for legs that ask for the same motion."""
        numbers = np.array(
            [self.v_tcp, self.a_tcp, self.v_ori, self.v_rail, np.nan if self.duration is None else self.duration]
        )
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
class FixedRail:
    """program: what is carried out, without the motions the plan drops. legs: all that takes time, in order."""

    program: Program
    plan: Plan
    legs: tuple[Leg, ...]

    @property
    def notes(self) -> tuple[str, ...]:
        """What the plan decided besides, for the reader of a row made from it; one line or none."""
        left_out = sum(motion.dropped for motion in self.plan.motions)
        return (f"optional motions left out as in the fixed-rail plan: {left_out}",) if left_out else ()


def fixed_rail(case: Case) -> FixedRail | Infeasible:
    """The case's fixed-rail plan cut into legs, or why there is none."""
    plan = case.solve(case.program, Target.STREAM, FIXED_RAIL)
    if isinstance(plan, Infeasible):
        return plan
    kept = [motion for motion in plan.motions if not motion.dropped]
    program = replace(case.program, motions=tuple(case.program.motions[motion.index] for motion in kept))
    plant = case.plant
    X_FT = np.eye(4)
    legs = []
    for index, planned in enumerate(kept):
        motion = program.motions[index]
        if not isinstance(motion, Wait | SignalEvent | MoveExtJ):
            X_FT = np.asarray(motion.tool.X_FT)
        if planned.t_1 > planned.t_0:
            legs.append(_leg(plant, index, motion, X_FT, planned.q_0, planned.q_1, (planned.t_0, planned.t_1)))
    return FixedRail(program, plan, tuple(legs))


def _leg(
    plant: Plant, index: int, motion: Motion, X_FT: Array, q_0: Array, q_1: Array, span: tuple[float, float]
) -> Leg:
    """A leg with the caps that the judge holds against it."""
    v_tcp, a_tcp, v_ori, v_rail, duration = plant.tcp.speed, plant.tcp.acceleration, np.inf, np.inf, None
    kind = LegKind.HOLD
    if isinstance(motion, Wait | SignalEvent):
        duration = motion.duration if isinstance(motion, Wait) else None
    else:
        duration = motion.duration
        moves = bool(np.abs(q_1 - q_0).max() > 0)
        kind = LegKind.HOLD if not moves else LegKind.LINE if isinstance(motion, MoveL) else LegKind.JOINT
        free = plant.free_speed and isinstance(motion, MoveJ | MoveAbsJ)
        if duration is None and not free:  # a programmed time replaces the speed
            v_rail = motion.speed.v_leax
            if not isinstance(motion, MoveExtJ):
                v_tcp, v_ori = min(v_tcp, motion.speed.v_tcp), motion.speed.v_ori
    return Leg(index, motion, kind, q_0, q_1, X_FT, v_tcp, a_tcp, v_ori, v_rail, duration, span)


def speed_limits(plant: Plant, leg: Leg) -> Array:
    """Speed limits (k,) of the axes on a leg: their own and the rail's programmed one."""
    limits = np.array(plant.limits.velocity)
    rail = plant.layout.rail
    limits[rail] = np.minimum(limits[rail], leg.v_rail)
    return limits


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


def use_of(plant: Plant, leg: Leg, q: Array, qd: Array, qdd: Array) -> Use:
    """Use of a leg's limits at samples q, qd, qdd (n, k)."""
    J = plant.robot.jacobian(q, leg.X_FT)
    V = (J @ qd[..., None])[..., 0]
    A = (J[:, :3] @ qdd[..., None])[..., 0]
    A += (plant.robot.jacobian_rate(q, qd, leg.X_FT)[:, :3] @ qd[..., None])[..., 0]
    moving, turning = np.linalg.norm(V[:, :3], axis=1), np.linalg.norm(V[:, 3:], axis=1)
    return Use(
        np.max(np.abs(qd) / speed_limits(plant, leg), axis=1),
        np.max(np.abs(qdd) / plant.limits.acceleration, axis=1),
        np.maximum(moving / leg.v_tcp, turning / leg.v_ori),
        np.linalg.norm(A, axis=1) / leg.a_tcp,
    )


@dataclass(frozen=True, eq=False)
class JointsOnLine:
    """The joints on a line leg over the share s of its way, the rail in proportion; exact on the leg's branch.

    line: the tool's. s (n,): the table's places. q (n, k) there.
    """

    plant: Plant
    leg: Leg
    line: Line
    cfx: int
    s: Array
    q: Array

    @classmethod
    def of(cls, plant: Plant, leg: Leg) -> JointsOnLine:
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


def _rail_at(plant: Plant, leg: Leg, s: Array) -> Array:
    d_0, d_1 = (plant.robot.layout.place(q) for q in (leg.q_0, leg.q_1))
    return d_0 + s * (d_1 - d_0)


def _branches(plant: Plant, leg: Leg, line: Line, s: Array) -> Array:
    """Joints (m, branches, joints) of all branches at shares s (m,) of the line."""
    X_WF = line.pose(s) @ inverse_pose(leg.X_FT)
    return plant.robot.branches(X_WF, _rail_at(plant, leg, s))
