"""The fixed-rail plan cut into runs: what remains to be timed when rail positions and configurations are given.

Rows that time a motion by other means than the optimiser's take from its fixed-rail plan where the rail stands at
every point and which branch the arm is in, and nothing else. Legs and limits are those of the problem that the plan
answers, and paths of the tool the sampled paths that it is timed on.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.motion import Motion, Move, Program, motion_name, turned_under
from trajopt_cli.path_timing.sampled_path import SampledPath, sample_path
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.corners import corners_of, passed_in
from trajopt_cli.problem.decision_scope import FIXED_RAIL
from trajopt_cli.problem.detours import unfolded, with_detours
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.study.case import Case
from trajopt_cli.trajectories.axes import Axes, AxisLimits
from trajopt_cli.trajectories.dense_check import motion_samples
from trajopt_cli.trajectories.leg_trajectories import Sample
from trajopt_cli.trajectories.limits.joint_acceleration import JointAcceleration
from trajopt_cli.trajectories.limits.tool_limit import ToolLimit

_LINE_NODES = 400  # of a line or an arc alone: at 0.5 m 1.2 mm apart
_ON_BRANCH = 1e-6  # rad: axes are what a branch says


@dataclass(frozen=True, eq=False)
class BaselineLeg:
    """A leg of the problem between axes q_0, q_1 (k,), at a fly-by as if it stopped there. motion, index: in the
    program carried out. span: when the fixed-rail plan makes it [s]. cfx: the branch that q_0 is nearest to."""

    leg: Leg
    motion: Motion
    q_0: Array
    q_1: Array
    span: tuple[float, float]
    cfx: int

    @property
    def X_FT(self) -> Array:
        """The tool in force (4, 4)."""
        return self.leg.X_FT

    @property
    def duration(self) -> float | None:
        """Its programmed time [s]."""
        return self.leg.duration

    @property
    def holds(self) -> bool:
        """Whether nothing moves."""
        return not np.any(self.q_1 != self.q_0)

    @property
    def on_line(self) -> bool:
        """Whether the TCP keeps to its path, or rests while the rail moves; else axes are free on the way."""
        return self.leg.kind is not LegKind.JOINT and not self.holds

    @property
    def curved(self) -> bool:
        """Whether the TCP goes along a curve."""
        return self.leg.segment is not None and not self.leg.segment.straight

    @property
    def key(self) -> bytes:
        """Equal for legs that ask for the same motion."""
        return self.leg.key + self.q_0.tobytes() + self.q_1.tobytes()

    @property
    def lasts(self) -> float:
        """How long a leg that holds still takes [s]."""
        return self.span[1] - self.span[0] if self.leg.duration is None else self.leg.duration

    def refusal(self, why: str) -> Infeasible:
        """The answer no, for a reason in one clause."""
        return Infeasible(self.leg.motion, self.motion.source, f"{motion_name(self.motion)} {why}")

    def too_short(self, who: str, needs: float) -> Infeasible | None:
        """The answer no where the programmed time is less than what who needs [s]; None where it is not."""
        T = self.leg.duration
        if T is None or needs <= T * (1 + 1e-9):
            return None
        return self.refusal(f"cannot be made in {T:g} s: {who} needs {needs:.4f} s")


@dataclass(frozen=True, eq=False)
class StopToStop:
    """The legs from one stop to the next. path: where they lead; None for a joint move or a hold alone."""

    legs: tuple[BaselineLeg, ...]
    path: SampledPath | None = None

    @property
    def by_parts(self) -> bool:
        """Whether it is timed part by part of its path: legs with corners between them, and arcs."""
        return len(self.legs) > 1 or (self.path is not None and self.legs[0].curved)

    @property
    def least(self) -> float:
        """What positioners, waits beside its moves and other robots leave it at least [s]."""
        moves = [leg.motion for leg in self.legs if isinstance(leg.motion, Move)]
        return moves[0].least if len(self.legs) == 1 == len(moves) else sum(move.partner or 0.0 for move in moves)

    @property
    def key(self) -> bytes:
        """Equal for runs that ask for the same motion."""
        sampled = () if self.path is None else (self.path.sigma, self.path.along.q)
        return b"".join(leg.key for leg in self.legs) + b"".join(x.tobytes() for x in sampled)

    @property
    def span(self) -> tuple[float, float]:
        """When the fixed-rail plan makes it [s]."""
        return self.legs[0].span[0], self.legs[-1].span[1]

    def number(self, legs: IndexArray) -> IndexArray:
        """Which of the legs (n,) are those of these numbers in the problem."""
        return np.searchsorted([one.leg.start for one in self.legs], legs, side="right") - 1

    def leg_at(self, t: Array) -> IndexArray:
        """Which of the legs (n,) is driven at times t (n,) [s] of the fixed-rail plan."""
        return np.searchsorted([leg.span[1] for leg in self.legs[:-1]], t, side="right")


@dataclass(frozen=True, eq=False)
class FixedRail:
    """program: what is carried out, without the motions the plan drops. runs: all that takes time, in order. stops: at
    how many fly-bys that could be passed the plan stops, because it is faster so."""

    axes: Axes
    program: Program
    plan: Plan
    runs: tuple[StopToStop, ...]
    stops: int

    @property
    def notes(self) -> tuple[str, ...]:
        """What the plan decided besides, for the reader of a row made from it."""
        left_out = sum(motion.dropped for motion in self.plan.motions)
        lines = {
            f"optional motions left out as in the fixed-rail plan: {left_out}": left_out,
            f"fly-by points that are stops as in the fixed-rail plan, which is faster so: {self.stops}": self.stops,
        }
        return tuple(line for line, count in lines.items() if count)


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
    problem = build_problem(program, plant, FIXED_RAIL, Target.STREAM, everything(program, plant))
    assert isinstance(problem, Problem)  # there is a plan for it
    q = [kept[0].q_0]
    for leg in problem.legs:
        planned = kept[leg.motion]
        q.append(planned.q_1 if planned.t_1 > planned.t_0 else q[-1])  # a leg without a way takes no time
    branches = [_branch(plant, axes) for axes in q]
    cfx = [number if off < _ON_BRANCH else -1 for number, off in branches]
    own = {motion.index: i for i, motion in enumerate(kept)}
    passed = {own[index] for index in passed_in(there, plant, plan)}
    stops = len(corners_of(program, plant).passed) - len(passed)
    axes, runs, legs = Axes.of(plant), list[StopToStop](), dict[int, BaselineLeg]()  # of the run, by number
    for k, leg in enumerate(problem.legs):
        motion, span = program.motions[leg.motion], (kept[leg.motion].t_0, kept[leg.motion].t_1)
        if span[1] > span[0]:
            legs[k] = BaselineLeg(leg, motion, q[k], q[k + 1], span, branches[k][0])
        if legs and (leg.motion not in passed or k + 1 == len(problem.legs)):
            run, path = StopToStop(tuple(legs.values())), None
            if len(legs) > 1 or run.legs[0].on_line:
                nodes = plant.settings.run_nodes if len(legs) > 1 or run.legs[0].curved else _LINE_NODES
                path = sample_path(axes, problem, (min(legs), max(legs) + 1), np.array(q), cfx, nodes, ramps=False)
                if path is None:
                    why = f"{motion_name(motion)} has no path, although the fixed-rail plan has one"
                    raise ValueError(f"{motion.source}: {why}")
            runs.append(replace(run, path=path))
            legs = {}
    return FixedRail(axes, program, plan, tuple(runs), stops)


def _branch(plant: Plant, q: Array) -> tuple[int, float]:
    """The branch (cfx) that axes (k,) are nearest to, and how far they are off it [rad]."""
    layout = plant.robot.layout
    found = plant.robot.branches(plant.robot.forward(q)[None], q[None, layout.rail])[0]
    off = found - q[layout.arm]
    apart = np.nan_to_num(np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max(axis=1), nan=np.inf)
    return int(np.argmin(apart)), float(apart.min())


@dataclass(frozen=True, eq=False)
class Use:
    """The largest shares of limits that a motion uses at samples (n,): of any axis' speed and acceleration, of the
    TCP's speed and turning, and of its acceleration. moving (n,): the TCP's speed itself."""

    speed: Array
    acceleration: Array
    tcp_speed: Array
    tcp_acceleration: Array
    moving: Array

    @property
    def slowing(self) -> float:
        """By what factor the motion must be slowed down as a whole to use its limits to 1 at most."""
        hardest = max(self.acceleration.max(), self.tcp_acceleration.max())
        return float(max(self.speed.max(), self.tcp_speed.max(), np.sqrt(hardest)))


def use_of(
    axes: Axes, legs: Sequence[BaselineLeg], caps: AxisLimits, number: IndexArray, q: Array, qd: Array, qdd: Array
) -> Use:
    """Use of limits at samples q, qd, qdd (n, k) of legs, to which numbers (n,) they belong; caps: a row a leg."""
    own, at_once = caps.at(number), np.zeros(1, dtype=np.intp)
    sample = Sample(np.zeros(len(q)), q, qd, qdd)
    motion = replace(motion_samples(axes, [leg.leg for leg in legs], number, sample, at_once), caps=own)
    speed, acceleration, turning = ToolLimit(axes).ratios(motion).T
    return Use(
        np.max(np.abs(qd) / own.velocity, axis=1),
        np.max(JointAcceleration(axes).ratios(motion), axis=1),
        np.maximum(speed, turning),
        acceleration,
        np.linalg.norm(motion.tool[:, 0, :3], axis=1),
    )


def caps_of(axes: Axes, run: StopToStop) -> AxisLimits:
    """What is in force on the legs of a run, a row each."""
    return axes.caps([leg.leg for leg in run.legs])
