"""A plan solved again where a limit, a speed, a wait or a pose is a little different: from its own motion, and to first
order by the multipliers of its nonlinear program.

What the plan chose stays: configurations, the order of stops, which fly-bys are passed. The windows of the nonlinear
program are solved once more from the plan's motion, with what is different in force; runs with one progress for all
axes are timed once more, their rail positions shifted where no corner binds them. Both sides of a comparison are solved
in this way, so that what it loses against the plan itself cancels out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from trajopt_cli.collision.collision_scene import collision_scene_of
from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.motion import Program
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.interior_point import NlpResult
from trajopt_cli.nlp.mesh_refinement import Grids, MeshRefinement, NotConverged, first_iterate, on_grid
from trajopt_cli.nlp.transcription import Transcription
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, duration, timed
from trajopt_cli.plan.local_refinement import may_gain, with_fixed_runs
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.plan.subproblems import Span, Window, red_black
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.corners import passed_in
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.plan import Infeasible, Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import in_force
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import Ratios, check_leg, check_legs
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, LegMotion, PathLeg
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectories.profiles import hold, profiles
from trajopt_cli.trajectories.route import IkBranch, Route
from trajopt_cli.trajectory import hermite

# share by which a plan solved again may take longer before it begins on its own fine grid. Measured on one small cell
# with eight rails: 2e-4 as a rule, 5e-3 in another optimum.
_LATER = 0.001
# m of rail that are tried in turn where a place was moved out of the arm's reach.
_SHIFTS = (0.0, 0.002, -0.002, 0.005, -0.005, 0.01, -0.01, 0.02, -0.02, 0.05, -0.05)
_JUMPED = 0.3  # share by which first order may be off before it is told from half of that. Not measured.
_AT_END = 0.998  # share of half an axis' range from which it stands at an end.

Changed = Callable[[float], tuple[Program, Plant]]
"""The program and its plant with a share of a change made, 1 for all of it."""
_SAME = 1e-9  # m, rad: rounding of a position at the end of its range


class NotResolvable(Exception):
    """Why a plan cannot be solved again with a change, one line."""


@dataclass(frozen=True, eq=False)
class Effect:
    """What a change makes of a plan's cycle time [s].

    gain: seconds saved, negative where it costs time; None where why says what is in the way, and at least this much
    where it does besides. first_order: the same by multipliers, or, of runs with one progress for all axes, by timing
    the same path; None where there is none. active: whether the change meets anything that binds.
    """

    gain: float | None
    first_order: float | None
    active: bool = True
    why: str = ""


@dataclass(frozen=True, eq=False)
class _Motion:
    """A plan as the optimiser solves it, or the same with a change: times (M-1,) [s] of the legs."""

    axes: Axes
    problem: Problem
    route: Route
    iterate: Iterate

    def part(self, span: Span) -> tuple[Window, Route]:
        """The legs of a span as a problem of their own, and their part of the route."""
        at = slice(span[0], span[1] + 1)
        route = replace(
            self.route, q=self.route.q[at], w=self.route.w[at], labels=self.route.labels[at],
            times=self.route.times[span[0] : span[1]],
        )  # fmt: skip
        return Window.of(self.problem, self.iterate, span), route


class PlanSensitivity:
    """A plan, to be solved again with changes. duration: its cycle time [s] solved again with nothing changed.

    changes: what could change in it when it was planned.

    Raises NotResolvable where the plan itself cannot be solved again.
    """

    def __init__(self, program: Program, plant: Plant, plan: Plan, changes: Changes):
        self._changes, self._plan, self._passed = changes, plan, passed_in(program, plant, plan)
        self._dropped = frozenset(motion.index for motion in plan.motions if motion.dropped)
        self._program = program
        axes = Axes.of(plant)
        problem = self._problem(program, plant)
        route, qd = _route_of_plan(axes, problem, plan)
        grids, capped = Grids.of(problem), _capped(axes, problem, route, qd)
        cfx = tuple(label.cfx for label in route.labels)
        iterate = first_iterate(axes, problem, route.q, qd, cfx, route.times, grids, capped)
        if not problem.coordinated and self._passed:
            problem = with_fixed_runs(problem, route)
        self.motion = _Motion(axes, problem, route, iterate)
        self._formulation = Formulation(axes)
        self._parts: list[_SolvedWindow | _TimedRuns] = []
        known: dict[bytes, _SolvedWindow | None] = {}
        whole = 0, len(problem.legs)
        for span in [whole] if problem.coordinated else red_black(problem)[0]:
            window, part = self.motion.part(span)
            nlp = None
            if _refinable(axes, window):
                key = window.key()
                if key not in known:
                    found = _SolvedWindow.of(axes, self._formulation, grids, window)
                    if found is None or found.duration > (1 + _LATER) * duration(window.iterate):
                        # the coarse grid led away from the plan; the last one does not
                        nearer = replace(window, iterate=on_grid(axes, window.problem, window.iterate, grids))
                        other = _SolvedWindow.of(axes, self._formulation, grids, nearer)
                        found = min(filter(None, (found, other)), key=lambda one: one.duration, default=None)
                    known[key] = found
                nlp = known[key]
            if nlp is not None:
                self._parts.append(replace(nlp, span=span))
            elif _rail_refined(axes, window.problem):
                self._parts.append(_TimedRuns(axes, span, window.problem, part))
            else:
                for run in window.problem.runs:
                    first, last = (span[0] + k for k in run)
                    inner, route_of_run = self.motion.part((first, last))
                    self._parts.append(_TimedRuns(axes, (first, last), inner.problem, route_of_run))
        try:
            self.duration = sum(part.duration for part in self._parts)
        except NotDriven as no:
            where = problem.motion(problem.legs[no.run[0]].motion).source
            raise NotResolvable(
                f"{where}: neither the nonlinear program nor one progress for all axes leads there"
            ) from no

    def answer(self, changed: Changed, loosens: bool) -> Effect:
        """What a change makes of the plan. loosens: whether every legal motion stays legal, so that nothing can be
        lost. What cannot be solved again is an answer, too."""
        settings = self.motion.axes.settings
        try:
            whole, small = (self._changed(*changed(share)) for share in (1.0, settings.small_change))
            active = [part for part in self._parts if part.affected_by(self.motion, whole)]
            slopes = [part.first_order(self.motion, small) for part in active]
            found: dict[bytes, float] = {}
            gain, why = 0.0, ""
            for part, slope in zip(active, slopes, strict=True):
                if (
                    not part.rail_refined
                    and slope is not None
                    and abs(slope / settings.small_change) < settings.least_gain
                ):
                    continue  # it stays optimal where no multiplier says otherwise, and a law on its path
                try:
                    gain += part.duration - part.again(self.motion, whole, found)
                except (NotConverged, NotDriven) as no:
                    why = why or part.why(no)
            predicted = _predicted_gain(slopes, settings.small_change)
            if predicted is not None and abs(predicted - gain) > _JUMPED * max(abs(predicted), abs(gain)) and not why:
                nearer = self._changed(
                    *changed(settings.small_change / 2)
                )  # a law may jump where a corner takes another size
                predicted = _predicted_gain(
                    [part.first_order(self.motion, nearer) for part in active], settings.small_change / 2
                )
        except NotResolvable as no:
            return Effect(None, None, why=str(no))
        if why and not (loosens and gain > 0):
            return Effect(None, predicted, why=why)
        gain = max(gain, 0.0) if loosens else gain
        slept = not active or (predicted is not None and max(abs(predicted), abs(gain)) < settings.least_gain)
        return Effect(0.0 if slept else gain, predicted, not slept, why)

    def _problem(self, program: Program, plant: Plant) -> Problem:
        """The problem with stops where the plan stops. Raises NotResolvable."""
        problem = build_problem(program, plant, EVERYTHING, self._plan.target, self._changes, self._dropped)
        if isinstance(problem, Infeasible):
            raise NotResolvable(problem.message)
        points = (one if one.motion in self._passed else replace(one, fly_by=None) for one in problem.waypoints)
        return replace(problem, waypoints=tuple(points))

    def _changed(self, program: Program, plant: Plant) -> _Motion:
        """The plan's motion with a change: what has a pose stands and leads where the pose is now.

        Raises NotResolvable.
        """
        before = self.motion
        axes, problem = Axes.of(plant), self._problem(program, plant)
        if len(problem.legs) != len(before.problem.legs):
            raise NotResolvable("a wait of the plan would be cut in other parts; plan it anew with the change")
        legs = [  # a long wait is cut by what limits allow: by those of the plan, unless it is the wait that changes
            replace(new, duration=old.duration) if _waits_alike(self._program, program, new.motion) else new
            for old, new in zip(before.problem.legs, problem.legs, strict=True)
        ]
        problem = replace(problem, legs=tuple(legs))
        moved = [
            k
            for k, (old, new) in enumerate(zip(before.problem.waypoints, problem.waypoints, strict=True))
            if new.q is None and not np.array_equal(old.X_WF, new.X_WF)
        ]
        for shift in _SHIFTS if moved and axes.layout.has_rail else _SHIFTS[:1]:
            q, qd = _placed(axes, problem, before, moved, shift)
            legs_there = tuple(
                None if motion is None else _leg_with_change(problem, k, motion, q)
                for k, motion in enumerate(before.iterate.legs)
            )
            ways = (motion.node_arm(axes) for motion in legs_there if isinstance(motion, PathLeg))
            inside = axes.within(q[moved], _SAME).all()
            if inside and all(np.isfinite(arm).all() for arm in ways):
                route = replace(before.route, q=q)
                if not problem.coordinated and self._passed:
                    problem = with_fixed_runs(problem, route)
                return _Motion(axes, problem, route, Iterate(q, qd, before.iterate.cfx, legs_there))
        raise NotResolvable("the arm does not reach there in the plan's configuration; --search plans anew")


@dataclass(frozen=True, eq=False)
class _SolvedWindow:
    """A window of the plan solved by the nonlinear program: its clean iterate, program, answer and multipliers."""

    formulation: Formulation
    grids: Grids
    span: Span
    duration: float
    iterate: Iterate
    program: Transcription
    answer: NlpResult

    @classmethod
    def of(cls, axes: Axes, formulation: Formulation, grids: Grids, window: Window) -> _SolvedWindow | None:
        """The window solved from the motion at hand; None where that does not converge."""
        refiner = MeshRefinement(
            axes, formulation, window.problem, in_force(), grids, collision_scene_of(window.problem)
        )
        try:
            iterate = refiner.run(window.iterate)
        except NotConverged:
            return None
        assert refiner.solved is not None
        program, result = refiner.solved
        if result is None:
            return None
        span = window.first, window.last
        return cls(formulation, grids, span, duration(iterate), iterate, program, result)

    @property
    def rail_refined(self) -> bool:
        """Whether first order says too little of it."""
        return False

    def affected_by(self, before: _Motion, after: _Motion) -> bool:
        """Whether anything in the window is different."""
        return bool(_differs(before, after, self.span).any())

    def why(self, no: NotConverged | NotDriven) -> str:
        """In words."""
        return f"the nonlinear program did not converge: {no}"

    def _with_rail_moved(self, after: _Motion) -> tuple[Problem, Iterate]:
        """The window's problem and clean motion with the change."""
        window, _ = after.part(self.span)
        q, qd = self.iterate.q.copy(), self.iterate.qd.copy()
        for k, point in enumerate(window.problem.waypoints):
            if point.q is not None:
                q[k], qd[k] = point.q, window.iterate.qd[k]
        legs = tuple(
            None if motion is None else _leg_with_change(window.problem, k, motion, q)
            for k, motion in enumerate(self.iterate.legs)
        )
        return window.problem, Iterate(q, qd, self.iterate.cfx, legs)

    def first_order(self, before: _Motion, after: _Motion) -> float | None:
        """By how much the time changes [s] where the answer stays optimal: what the Lagrangian changes by at the
        answer, with its multipliers."""
        problem, iterate = self._with_rail_moved(after)
        other = Transcription(
            after.axes, self.formulation, problem, iterate, self.program.margins, self.program.tangents
        )
        change = self.program.nlp.lagrangian_change(other.nlp, self.answer)
        if not np.isfinite(change):  # it leads where the arm does not reach
            return None
        # waits in which nothing moves are no variables
        held = [(a.duration or 0.0, b.duration or 0.0) for a, b, v in
                zip(problem.legs, self.program.problem.legs, self.program.legs, strict=True) if v is None]  # fmt: skip
        return change + sum(a - b for a, b in held)

    def again(self, before: _Motion, after: _Motion, found: dict[bytes, float]) -> float:
        """The window's time [s] solved again. found: of windows that ask for the same. Raises NotConverged."""
        problem, iterate = self._with_rail_moved(after)
        key = replace(after.part(self.span)[0], iterate=iterate).key()
        if key not in found:
            refiner = MeshRefinement(
                after.axes, self.formulation, problem, in_force(), self.grids, collision_scene_of(problem)
            )
            try:
                iterate = refiner.again(iterate, self.program, self.answer)
            except NotConverged:  # from farther away, as the plan itself
                iterate = refiner.run(after.part(self.span)[0].iterate)
            found[key] = duration(iterate)
        return found[key]


@dataclass(frozen=True, eq=False)
class _TimedRuns:
    """Runs of the plan in which all axes have one progress: their route."""

    axes: Axes
    span: Span
    problem: Problem
    route: Route

    @property
    def rail_refined(self) -> bool:
        """Whether its rail is shifted, which the same path says nothing of."""
        return _rail_refined(self.axes, self.problem)

    @cached_property
    def _timed(self) -> Iterate:
        return timed(self.axes, self.problem, self.route)

    @cached_property
    def duration(self) -> float:
        """With the rail shifted as again does it [s]."""
        return min(duration(self._timed), self._with_rail_refined(self.axes, self.problem, self.route))

    @cached_property
    def _near(self) -> BoolArray:
        """What each leg comes near to, in the rows of _numbers."""
        ratios = check_legs(self.axes, self.problem.legs, [leg for leg in self._timed.legs if leg is not None])
        return np.array([_near(one, self.axes) for one in ratios])

    def _active_legs(self, before: _Motion, after: _Motion) -> BoolArray:
        """The legs on which anything is different that is near its limit."""
        return np.asarray((_differs(before, after, self.span) & self._near).any(axis=1))

    def affected_by(self, before: _Motion, after: _Motion) -> bool:
        """Whether that is so anywhere."""
        return bool(self._active_legs(before, after).any())

    def why(self, no: NotConverged | NotDriven) -> str:
        """In words."""
        if isinstance(no, NotDriven) and no.least is not None:
            return "no shorter: the rail move needs this wait or programmed time"
        return "a run of the plan cannot be driven so"

    def _on_path(self, before: _Motion, after: _Motion) -> float:
        """The time on the same path [s]: of what feels the change, timed anew. Raises NotDriven."""
        active, total = self._active_legs(before, after), 0.0
        for first, last in self.problem.runs:
            at = slice(first, last)
            if active[at].any():
                window, route = after.part((self.span[0] + first, self.span[0] + last))
                total += duration(timed(after.axes, window.problem, route))
            else:
                total += sum(leg.T for leg in self._timed.legs[at] if leg is not None)
        return total

    def first_order(self, before: _Motion, after: _Motion) -> float | None:
        """By how much the time changes on the same path [s]; None where it cannot be driven so."""
        try:
            return self._on_path(before, after) - duration(self._timed)
        except NotDriven:
            return None

    def again(self, before: _Motion, after: _Motion, found: dict[bytes, float]) -> float:
        """The time [s] with the change. found: of runs that ask for the same. Raises NotDriven."""
        window, route = after.part(self.span)
        key = window.key()
        if key not in found:
            shifted = self._with_rail_refined(after.axes, window.problem, route)
            try:
                found[key] = min(shifted, self._on_path(before, after))
            except NotDriven:
                if not np.isfinite(shifted):
                    raise
                found[key] = shifted
        return found[key]

    def _with_rail_refined(self, axes: Axes, problem: Problem, route: Route) -> float:
        """The time with the rail refined [s]; infinite where corners bind it, or where nothing is driven so."""
        if not _rail_refined(axes, problem):
            return np.inf
        try:
            return duration(timed(axes, problem, refine_rail(axes, problem, route)))
        except NotDriven:
            return np.inf


def _predicted_gain(slopes: Sequence[float | None], share: float) -> float | None:
    """What all parts save by first order [s], of what they change by with a share of the change."""
    known = [one for one in slopes if one is not None]
    return -sum(known) / share if len(known) == len(slopes) else None


def _refinable(axes: Axes, window: Window) -> bool:
    """Whether a window is one of the nonlinear program's: the search would try it, or its joint moves have nodes."""
    problem = window.problem
    if problem.coordinated or any(problem.passes(k) for k in range(len(problem.waypoints))):
        return False
    nodes = any(isinstance(motion, JointNodes) for motion in window.iterate.legs)
    return nodes or may_gain(axes, problem, window.iterate)


def _rail_refined(axes: Axes, problem: Problem) -> bool:
    """Whether a rail is shifted when runs are timed again: not where corners bind it."""
    free = any(point.free for point in problem.waypoints)
    return axes.layout.has_rail and free and not any(problem.passes(k) for k in range(len(problem.waypoints)))


# ------------------------------------------------------------------------------------------------- what is different


def _numbers(motion: _Motion, k: int) -> list[Array]:
    """What limits ask of leg k, a row for each of their columns, and its duration."""
    leg = motion.problem.legs[k]
    duration = np.array([[np.inf if leg.duration is None else leg.duration]])
    return [*(limit.numbers(leg) for limit in limits_of(motion.axes)), duration]


def _differs(before: _Motion, after: _Motion, span: Span) -> BoolArray:
    """What is different on each leg of a span, in the rows of _numbers; all of them where its poses are."""
    out = []
    for k in range(*span):
        pairs = zip(before.problem.waypoints[k : k + 2], after.problem.waypoints[k : k + 2], strict=True)
        moved = any(not np.array_equal(a.X_WF, b.X_WF) for a, b in pairs)
        moved |= before.problem.legs[k].units != after.problem.legs[k].units
        both = zip(_numbers(before, k), _numbers(after, k), strict=True)
        out.append(np.concatenate([(a != b).any(axis=1) for a, b in both]) | moved)
    return np.array(out)


def _near(ratios: Ratios, axes: Axes) -> BoolArray:
    """What a leg comes near to, in the rows of _numbers. Where it stays away from a limit it does so after a small
    shift of the rail, too."""
    near = {True: axes.settings.active, False: _AT_END}
    reached = [ratios.by_name[one.name].max(axis=0) >= near[one.order > 0] for one in limits_of(axes)]
    return np.concatenate([*reached, [True]])


def _placed(axes: Axes, problem: Problem, before: _Motion, moved: list[int], shift: float) -> tuple[Array, Array]:
    """Axes and velocities (M, n) at all waypoints where some of them were moved, their rail by a shift [m]; NaN where
    the arm does not reach."""
    q, qd, layout = before.route.q.copy(), before.iterate.qd.copy(), axes.layout
    for k in moved:
        d = q[k, layout.rail] + shift
        arm = axes.inverse(problem.waypoints[k].X_WF[None], d[None])[0, before.iterate.cfx[k]]
        q[k] = layout.merge(d, arm + 2 * np.pi * np.round((q[k, layout.arm] - arm) / (2 * np.pi)))
        if np.isfinite(arm).all():
            qd[k, layout.arm] = axes.self_motion(q[k]) @ qd[k, layout.rail]
    return q, qd


def _waits_alike(before: Program, after: Program, index: int) -> bool:
    return before.motions[index] is after.motions[index]


# -------------------------------------------------------------------------------------------- from a plan to an iterate


def _route_of_plan(axes: Axes, problem: Problem, plan: Plan) -> tuple[Route, Array]:
    """Axes and configurations of the plan at the waypoints with times of the legs, and velocities (M, n) there."""
    motions = {motion.index: motion for motion in plan.motions}
    ends = np.empty(len(problem.legs))
    last = {leg.motion: k for k, leg in enumerate(problem.legs)}
    for k, leg in enumerate(problem.legs):
        ends[k] = motions[leg.motion].t_1 if last[leg.motion] == k else ends[k - 1] if k else 0.0
        if last[leg.motion] != k:
            ends[k] = (ends[k - 1] if k else 0.0) + (leg.duration or 0.0)
    start = float(plan.trajectory.t[0])
    q, qd, _ = hermite(plan.trajectory, np.concatenate([[start], start + ends]))
    for k, leg in enumerate(problem.legs):
        if last[leg.motion] == k:
            q[k + 1] = motions[leg.motion].q_1
    labels = []
    for k, point in enumerate(problem.waypoints):
        if point.q is not None:
            q[k] = point.q
        if problem.rests(k) or problem.passes(k):
            qd[k] = 0.0
        cfx = -1
        if point.q is None:
            branches = axes.inverse(point.X_WF[None], q[k : k + 1, axes.layout.rail])[0]
            off = branches - q[k, axes.layout.arm]
            off = np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max(axis=1)
            cfx = int(np.argmin(np.where(np.isfinite(off), off, np.inf)))
        labels.append(IkBranch(cfx, np.zeros(axes.n - axes.layout.r)))
    times = np.diff(ends, prepend=0.0)
    rail = np.zeros_like(q)
    return Route(q, rail, tuple(labels), times, float(times.sum())), qd


def _capped(axes: Axes, problem: Problem, route: Route, qd: Array) -> frozenset[int]:
    """The joint moves that the plan does not drive in closed form."""
    settings = axes.settings

    def closed(k: int, leg: Leg) -> bool:
        ends = route.q[k], qd[k], route.q[k + 1], qd[k + 1]
        limits = axes.velocity_on(leg), axes.acceleration_on(leg)
        with suppress(ValueError):  # switches that a file could not tell apart
            motion = profiles(*ends, *limits, leg.duration or 0.0, problem.coordinated, settings)
            legal = check_leg(axes, leg, motion).worst <= 1 + settings.closed_form_excess
            return legal and route.times[k] - settings.least_gain < motion.T
        return False

    return frozenset(k for k, leg in enumerate(problem.legs) if leg.kind is LegKind.JOINT and not closed(k, leg))


def _leg_with_change(problem: Problem, k: int, motion: LegMotion, q: Array) -> LegMotion:
    """A leg's motion where its poses and its duration are the problem's now, between axes q (M, n)."""
    leg = problem.legs[k]
    if leg.kind is LegKind.DWELL and isinstance(motion, JointProfiles):
        return hold(leg.duration or 0.0, q[k])
    if isinstance(motion, PathLeg):
        rail, tau = problem.plant.layout.rail, motion.grid[:, None]
        moved = (1 - tau) * (q[k, rail] - motion.d[0]) + tau * (q[k + 1, rail] - motion.d[-1])
        motion = replace(motion, segment=problem.segment(k), d=motion.d + moved)
    if leg.duration is None or not isinstance(motion, PathLeg | JointNodes):
        return motion
    return replace(motion, T=leg.duration)
