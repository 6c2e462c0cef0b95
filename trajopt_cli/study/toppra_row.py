"""Row `toppra`: the fixed-rail plan's path, timed anew from stop to stop with TOPP-RA.

The path is the plan's own, with the plan's time as its parameter: there the plan's timing is rate 1, and nothing is
singular where all axes rest. Axes' limits are columns, the caps on the TCP too: its speed and turning bound the rate,
its acceleration is held in twelve directions of the plane it can lie in. Between its points TOPP-RA does not look, so
every run is laid out in rows a millisecond apart, and what these use too much is taken away by slowing the run down as
a whole. (Tightening limits around each excess instead gains 0.01 %, for three times the time.)
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.search import search
from trajopt_cli.path_timing.path_derivatives import PathDerivatives
from trajopt_cli.path_timing.path_timing import but_torques, path_rows, samples_of, stacked
from trajopt_cli.plan.tool_turns import best_sampled_turns
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import FIXED_RAIL
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.tool_turns import turn_groups, turned
from trajopt_cli.study.case import Answer, Attempt, Case, NotApplicable
from trajopt_cli.study.fixed_rail import FixedRail, StopToStop, caps_of, fixed_rail, use_of
from trajopt_cli.study.rows import SAFE, Piece, apart, attempt_of, each_once, hold, rows_of
from trajopt_cli.timing.topp import TimeLaw, fastest_laws
from trajopt_cli.trajectories.axes import Axes, AxisLimits
from trajopt_cli.trajectories.dense_check import motion_samples
from trajopt_cli.trajectories.leg_trajectories import Sample
from trajopt_cli.trajectories.limits.limit import Limit, PathRows
from trajopt_cli.trajectories.limits.tool_limit import ToolLimit
from trajopt_cli.trajectory import Trajectory, hermite

STEP = 1e-3  # s of the plan between the points of TOPP-RA; every switch of the plan is one besides
_DIRECTIONS = np.arange(12) * np.pi / 12  # of the plane in which the TCP's acceleration lies
_RATES = (1.0, 0.999, 0.997, 0.99, 0.98, 0.95, 0.9)  # shares of the greatest rate at the ends that are tried
_FASTEST = 10.0  # rate that stands for no bound
_JUMP = 1e-3  # share of an axis' acceleration whose change in a row makes it a switch
_SLIVER = 2e-5  # s; where corners touch, rounding leaves ways of less between them
_BESIDE = 1e-8  # s from a row: its other side


def toppra(case: Case) -> Answer:
    """The fixed-rail plan's path timed with TOPP-RA, every stop a stop. Infeasible where a programmed time is too short
    for it, or where there is no fixed-rail plan."""
    given = fixed_rail(case)
    if isinstance(given, Infeasible):
        return given
    found = each_once(given.runs, partial(_piece, given))
    kept = sum(not timed for _, timed in found)
    notes = ["the fixed-rail plan's path; only its timing is TOPP-RA's"]
    if kept:
        notes.append(f"TOPP-RA finds no timing for {kept} of {len(given.runs)} runs: they keep the plan's")
    return attempt_of(case, given, [piece for piece, _ in found], notes)


def _piece(given: FixedRail, run: StopToStop) -> tuple[Piece | Infeasible, bool]:
    """The run timed, or why its programmed time cannot be kept; and whether TOPP-RA did it."""
    leg = run.legs[0]
    if leg.holds:
        return hold(leg.q_0, leg.lasts), True
    path = _Path.of(given, run)
    found = _timed(path)
    plans = TimeLaw(path.s, np.ones_like(path.s))
    law, T = found or plans, leg.duration if len(run.legs) == 1 else None
    if T is not None:
        if law.duration > T * (1 + 1e-9):  # by a hair, where the plan itself takes no longer than it may
            law = plans
        if (no := leg.too_short("TOPP-RA", law.duration)) is not None:
            return leg.too_short("TOPP-RA", (found or plans).duration) or no, True
        law = law.slowed(T / law.duration)
    return Piece(law.duration, law.times, partial(_run, path, law)), law is not plans


@dataclass(frozen=True, eq=False)
class _Path:
    """A run of the plan: s is the plan's time from the run's begin; its points (n,) are those of TOPP-RA."""

    axes: Axes
    run: StopToStop
    trajectory: Trajectory
    s: Array

    @classmethod
    def of(cls, given: FixedRail, run: StopToStop) -> _Path:
        (t_0, t_1), trajectory = run.span, given.plan.trajectory
        inside = (trajectory.t > t_0 + 1e-9) & (trajectory.t < t_1 - 1e-9)
        t = np.r_[t_0, trajectory.t[inside], t_1]
        if run.by_parts:
            t = np.r_[t[:-1][np.diff(t) > _SLIVER], t_1]
            t[0] = t_0
        jumps = np.zeros(len(t), dtype=bool)
        left, right = (hermite(trajectory, t[1:-1] + side)[2] for side in (-_BESIDE, _BESIDE))
        jumps[1:-1] = (np.abs(right - left) > _JUMP * given.axes.acceleration).any(axis=1)
        jumps[[0, -1]] = True
        ends = np.array([leg.span[1] for leg in run.legs])
        jumps[np.abs(t[:, None] - ends).argmin(axis=0)] = True  # rows, but for rounding
        marks = t[jumps]
        wanted = np.concatenate(
            [np.linspace(a, b, max(int((b - a) / (STEP)), 1) + 1)[1:-1] for a, b in pairwise(marks)]
        )
        return cls(given.axes, run, trajectory, np.unique(np.r_[marks, wanted]) - t_0)

    @cached_property
    def limits(self) -> list[Limit]:
        """What is asked of it."""
        others = [limit for limit in but_torques(self.axes) if not isinstance(limit, ToolLimit)]
        return [*others, ToolLimit(self.axes, _DIRECTIONS)]

    @cached_property
    def caps(self) -> AxisLimits:
        """Limits in force on each leg."""
        return caps_of(self.axes, self.run)

    def at(self, s: Array) -> tuple[Array, Array, Array]:
        """Axes, their first and second derivatives (m, k) at s (m,)."""
        t_0, t_1 = self.run.span
        return hermite(self.trajectory, np.clip(t_0 + s, t_0, t_1))

    def rows(self, s: Array, middles: Array) -> PathRows:
        """What limits ask for at s (m,), on the legs that are driven at middles (m,)."""
        number, legs = self.run.leg_at(self.run.span[0] + middles), [leg.leg for leg in self.run.legs]
        q, dq, ddq = self.at(s)
        tool = motion_samples(self.axes, legs, number, Sample(s, q, dq, ddq), number[:1]).tool
        along = PathDerivatives(q, dq, ddq, tool[:, 0, :3], tool[:, 0, 3:], tool[:, 1, :3], np.zeros((len(s), 2)))
        return stacked(path_rows(self.limits, samples_of(self.axes, legs, number, along)))

    @cached_property
    def top(self) -> Array:
        """Greatest rate (n,) that axis speeds, TCP speed and turning allow at the points; where two legs meet, of
        both."""
        sides = [self.rows(self.s, self.s + side).top.min(axis=1) for side in (-_BESIDE, _BESIDE)]
        return np.asarray(np.minimum(np.minimum(*sides), _FASTEST))


def _run(path: _Path, law: TimeLaw, t: Array) -> tuple[Array, Array]:
    s, rate, _ = law.at(t)
    q, first, _ = path.at(s)
    return q, first * rate[:, None]


def _timed(path: _Path) -> TimeLaw | None:
    """The fastest law by TOPP-RA, None where it finds none; slowed down until the cubics between the rows of a file
    keep all limits."""
    law = _fastest(path)
    if law is None:
        return None
    piece = Piece(law.duration, law.times, partial(_run, path, law))
    rows = rows_of(path.trajectory.names, [piece], path.run.legs[-1].q_1)
    t = np.r_[rows.t[:-1] + 1e-9, (rows.t[:-1] + rows.t[1:]) / 2, rows.t[1:] - 1e-9]
    now, motion = path.run.span[0] + law.at(t)[0], hermite(rows, t)
    tools = {leg.leg.X_FT.tobytes() for leg in path.run.legs}
    sides = (0.0,) if len(tools) == 1 else (-STEP, 0.0, STEP)  # about where a tool changes rows are of either
    numbers = [path.run.leg_at(np.clip(now + side, *path.run.span)) for side in sides]
    slowing = [use_of(path.axes, path.run.legs, path.caps, number, *motion).slowing for number in numbers]
    return law.slowed(max(1.0, *(one / SAFE for one in slowing)))


def _fastest(path: _Path) -> TimeLaw | None:
    """TOPP-RA's law. All axes rest at the ends, whatever the rate there: the greatest that leads anywhere is taken."""
    middles = (path.s[:-1] + path.s[1:]) / 2
    rows = [path.rows(path.s[:-1] + _BESIDE, middles), path.rows(path.s[1:] - _BESIDE, middles)]
    first, last = (
        min(float(path.top[i]), float(np.sqrt(1 / max(np.abs(one.bends[i]).max(), 1 / _FASTEST**2))))
        for i, one in zip((0, -1), rows, strict=True)
    )
    # a rest is part of a cap on ramps, never of gravity: what it leaves at least holds either way
    begins, ends = [tuple((x / (1 - np.abs(one.rests)))[None] for x in (one.slopes, one.bends)) for one in rows]
    for share in _RATES:
        law = fastest_laws(path.s, path.top[None], begins, ends, first * share, last * share).law(0)
        if law is not None and apart(law.times):
            return law
    return None


def sampled_turn(case: Case) -> Answer:
    """The program with sampled turns, its fixed-rail plan's path timed with TOPP-RA, every stop a stop."""
    program, plant = case.program, case.plant
    axes, problem = Axes.of(plant), build_problem(program, plant, FIXED_RAIL, Target.STREAM)
    if isinstance(problem, Infeasible) or (route := search(axes, problem)) is None:
        return NotApplicable("as taught the targets are not all in reach")
    groups = turn_groups(problem, everything(program, plant))
    angles, route = best_sampled_turns(axes, groups, route, by_way=True)
    if route is None:
        return NotApplicable("no route leads through sampled turns")
    answer = toppra(replace(case, program=turned(program, groups.turns(angles))))
    if not isinstance(answer, Attempt):
        return answer
    return replace(answer, program=program, notes=("turns sampled every 15 degrees, where joints go least far",))
