"""A legal motion made faster by the nonlinear program, window by window: whatever one does, the motion stays legal.

A window's answer counts where its dense check is clean and it is faster than what it replaces. Windows are swept until
little is gained; equal ones are solved once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from functools import partial
from time import perf_counter
from typing import Any

import numpy as np

from trajopt_cli.collision.collision_scene import collision_scene_of
from trajopt_cli.collision.merge_via_points import merge_via_points
from trajopt_cli.collision.motion_collision import clear
from trajopt_cli.graph_search.by_rails import search
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import Grids, MeshRefinement, NotConverged, Stage, first_iterate, on_grid
from trajopt_cli.path_timing.edge_times import least_time
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, duration, stopped_at_joint_moves, timed
from trajopt_cli.plan.initial_plan import InitialPlan, add
from trajopt_cli.plan.opened_corners import OpenedProblem, opened, with_even_zones
from trajopt_cli.plan.subproblems import Seam, Span, Window, ends_held, red_black
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.problem import LegKind, Problem
from trajopt_cli.problem.progress import Progress, Report
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.effort import cost
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes
from trajopt_cli.trajectories.route import Route
from trajopt_cli.workers import in_turns

_SWEEPS = 6  # of windows over one another's borders at most.
_WORTH_TRYING = 1.005  # times what it takes at least that a joint move must take before axes of their own are tried.

# Times the best first answer up to which others are solved to the end as well. Measured: without, seeds 1003 and 1014
# of benchmarks/bench_robust.py end 0.14 and 0.15 % slower, with it 1014 0.07 %.
_RIVAL = 1.003
_SAME = 1e-5  # m, rad, s, rad/s between first answers that are one. Measured: up to 5e-7, others 0.01 and more
_SAME_END = 1 + 2e-4  # times the best first answer up to which others lead to the same end

Tell = Callable[[float], None]


def refine(
    axes: Axes,
    legal: InitialPlan,
    patience: Patience,
    tell: Report,
    seconds: dict[str, float],
    max_workers: Callable[[], int] = lambda: 1,
) -> tuple[Problem, Iterate, tuple[str, ...]]:
    """The initial plan made faster by the nonlinear program.

    Where the rail may be in motion at the stops of a short program, the route of a search with such a rail is a start,
    too: of 200 moves of a pallet it led to something better in two windows of 17, for 0.01 % of the cycle and a sixth
    of all processor time. Runs with corners are opened, so that their points are passed in motion; where that gains
    nothing, or a window of it fails, they stay as they are, and so do their ends, but stops beside joint moves are
    tried, too. Joint moves by points that were added are one leg each, without the points.

    Args:
        axes: of the plant.
        legal: the initial plan.
        patience: ends the search for a faster one.
        tell: hears of faster plans.
        seconds: time spent, by phase; what is spent here is added.
        max_workers: how many processes may work now.

    Returns:
        The problem that is solved, opened where its runs are; its motion, and what a reader should know of it, one line
        each.
    """
    if not axes.robot.closed_form:
        why = (
            f"{axes.robot.name}'s wrist has an offset: its plan is searched and timed, no nonlinear program improves it"
        )
        return legal.problem, legal.iterate, (why,)
    problem, merged = merge_via_points(axes, legal.problem, legal.iterate, legal.detours)
    if patience.over:
        why = f"{patience.why()}: the first legal plan; the search for a faster one was not begun"
        return problem, merged, (why,)
    sweeps, report = WindowSweeps(axes, Grids.of(problem), patience, seconds, max_workers), SweepReport()
    solved, best, route = problem, merged, None
    base: tuple[Problem, Iterate] | None = problem, merged
    start = perf_counter()
    try:
        if any(problem.passes(k) for k in range(len(problem.waypoints))):
            base = None
            if axes.jerk is None and (runs := _opened(axes, legal, problem, merged)) is not None:
                found = sweeps.run(*runs, report, partial(_tell_best, tell, duration(best)))
                tried = [(runs[0], found)]
                if axes.layout.r > 1 and report.failed and not report.stopped:
                    held = runs[0].with_rails_held(runs[1].q)
                    tried.append((held, sweeps.run(held, runs[1], report, partial(_tell_best, tell, duration(best)))))
                for own, found in tried:
                    gained = duration(found) < duration(best) - axes.settings.least_gain
                    if gained and clear(axes, problem, own.closed(axes, found)):
                        solved, best = own, found
            if not report.stopped and (best is merged or report.failed):
                base = _stopping_start(axes, legal)
        elif axes.layout.has_rail and problem.freedom.through_stops and len(problem.legs) <= axes.settings.few_legs:
            route = search(axes, problem)
            add(seconds, "search", perf_counter() - start)
    except Stopped:
        report.stopped = True
    if base is not None:
        found = sweeps.run(*base, report, partial(_tell_best, tell, duration(best)), route)
        if duration(found) < duration(best) - axes.settings.least_gain:
            solved, best = base[0], found
    return solved, best, tuple(report.notes(best is not merged, patience))


def refine_laws(
    axes: Axes,
    legal: InitialPlan,
    patience: Patience,
    seconds: dict[str, float],
    max_workers: Callable[[], int] = lambda: 1,
) -> Iterate:
    """The initial plan of axes that share one progress under jerk limits, with faster laws on its lines and arcs.
    Arguments as in refine."""
    problem, iterate = legal.problem, legal.iterate
    held = (
        replace(point.standing(problem.layout, q), q=q) for point, q in zip(problem.waypoints, iterate.q, strict=True)
    )
    pinned = replace(problem, waypoints=tuple(held), ties=())
    sweeps = WindowSweeps(axes, Grids.of(problem), patience, seconds, max_workers)
    return sweeps.run(pinned, iterate, SweepReport(), lambda _: None)


def _tell_best(tell: Report, known: float, now: float) -> None:
    """Tell the best of two cycle times [s]."""
    tell(Progress("solve", min(known, now)))


def _tell_whole(tell: Tell, rest: float, part: float) -> None:
    """Tell the cycle time [s] of a part and of the rest."""
    tell(rest + part)


def _opened(axes: Axes, legal: InitialPlan, problem: Problem, merged: Iterate) -> tuple[OpenedProblem, Iterate] | None:
    """The problem with its runs opened and its motion; timed anew where zones of orientation are made smaller."""
    even = with_even_zones(legal.problem)
    if even is legal.problem:
        return opened(axes, problem, merged)
    with suppress(NotDriven):
        iterate = timed(axes, even, legal.route)
        if clear(axes, even, iterate):
            return opened(axes, *merge_via_points(axes, even, iterate, legal.detours))
    return None


def _stopping_start(axes: Axes, legal: InitialPlan) -> tuple[Problem, Iterate] | None:
    """The problem with stops at all fly-bys beside joint moves, and its motion; None where that is not driven."""
    stopping = stopped_at_joint_moves(legal.problem)
    with suppress(NotDriven):
        iterate = legal.iterate if stopping is legal.problem else timed(axes, stopping, legal.route)
        if iterate is legal.iterate or clear(axes, stopping, iterate):
            return merge_via_points(axes, with_fixed_runs(stopping, legal.route), iterate, legal.detours)
    return None


def with_fixed_runs(problem: Problem, route: Route) -> Problem:
    """The problem with the ends of every run with corners at rest where the route has them."""
    waypoints = list(problem.waypoints)
    for first, last in problem.runs:
        for k in range(first, last + 1) if last > first + 1 else ():
            there = waypoints[k].standing(problem.layout, route.q[k])
            waypoints[k] = replace(there, rest=not problem.passes(k), turn=None)
    return replace(problem, waypoints=tuple(waypoints))


@dataclass(frozen=True, eq=False)
class _Outcome:
    """What came of a window: its motion where that counts; whether any solve was clean; seconds per phase; whether
    patience ended before it was solved."""

    found: Iterate | None
    clean: bool
    seconds: dict[str, float]
    stopped: bool = False


@dataclass
class SweepReport:
    """Windows that were tried, and those of which no solve was clean; whether patience ended first."""

    tried: set[Span] = field(default_factory=set)
    failed: set[Span] = field(default_factory=set)
    stopped: bool = False

    def notes(self, gained: bool, patience: Patience) -> Iterator[str]:
        """What a reader should know of it, one line each."""
        if self.stopped:
            yield f"{patience.why()}: the best plan so far; the search for a faster one was not finished"
        elif self.tried and not gained:
            yield "each leg has one progress for all axes, as a RAPID controller drives it: nothing faster was found"
        if count := len(self.failed):
            parts = "its part stays" if count == 1 else "their parts stay"
            yield f"{count} of {len(self.tried)} windows failed to converge: {parts} as found without them"


class WindowSweeps:
    """Sweeps windows over the motions of one plant's problems, and remembers what came of each."""

    def __init__(
        self, axes: Axes, grids: Grids, patience: Patience, seconds: dict[str, float],
        max_workers: Callable[[], int] = lambda: 1,
    ):  # fmt: skip
        self._grids, self._max_workers = grids, max_workers
        self._axes, self._patience, self._seconds, self._formulation = axes, patience, seconds, Formulation(axes)
        self._cache: dict[bytes, _Outcome] = {}

    def run(
        self, problem: Problem, base: Iterate, report: SweepReport, tell: Tell, route: Route | None = None
    ) -> Iterate:
        """The legal motion base, faster where a window found something. tell: is told the cycle time [s] after every
        window. route: another start. Both ends of a steady cycle are held in turns with what lies opposite of them."""
        if not self._axes.robot.closed_form:
            return base
        if not problem.steady:
            return self._swept(problem, base, report, tell, route)
        iterate, now = base, np.inf
        for _ in range(_SWEEPS):
            iterate = self._swept(ends_held(problem, iterate), iterate, report, tell, route)
            before, now = now, cost(self._axes, problem, iterate.legs)
            if report.stopped or now > before * (1 - problem.plant.settings.sweep_gain):
                break
            if (seam := Seam.of(problem, iterate)) is None:
                break
            own, rest = SweepReport(), duration(iterate) - duration(seam.iterate)
            found = self._swept(seam.problem, seam.iterate, own, partial(_tell_whole, tell, rest))
            iterate, report.stopped = seam.put(found, iterate), own.stopped
        return iterate

    def _swept(
        self, problem: Problem, base: Iterate, report: SweepReport, tell: Tell, route: Route | None = None
    ) -> Iterate:
        """The same with both ends of the problem as free as they are in it."""
        iterate, (red, black) = base, red_black(problem)
        gained = dict.fromkeys((*red, *black), np.inf)  # over each window's borders since it was solved, as a share
        for _ in range(_SWEEPS):
            if report.stopped or max(gained.values()) <= problem.plant.settings.sweep_gain:
                break
            for spans, others in ((red, black), (black, red)):
                due = [span for span in spans if gained[span] > problem.plant.settings.sweep_gain]
                try:
                    before, iterate = iterate, self._side_by_side(problem, base, iterate, due, report, tell, route)
                except Stopped:
                    report.stopped = True
                    return iterate
                for first, last in due:
                    gained[first, last] = 0.0
                    was, now = (cost(self._axes, problem, one.legs[first:last]) for one in (before, iterate))
                    for span in others:
                        gained[span] += (was - now) / was if first < span[1] and span[0] < last and was else 0.0
        return iterate

    def _side_by_side(
        self, problem: Problem, base: Iterate, iterate: Iterate, spans: Sequence[Span], report: SweepReport, tell: Tell,
        route: Route | None,
    ) -> Iterate:  # fmt: skip
        """The motion after windows that share no leg, equal ones solved once."""
        few = len(problem.legs) <= problem.plant.settings.few_legs
        windows: list[tuple[Window, bytes]] = []
        tasks: dict[bytes, Callable[[Callable[[Any], None]], _Outcome]] = {}
        for window in (Window.of(problem, iterate, span) for span in spans):
            if not may_gain(self._axes, window.problem, window.iterate):
                continue
            part = slice(window.first, window.last)
            initial = all(now is then for now, then in zip(iterate.legs[part], base.legs[part], strict=True))
            key = window.key()
            windows.append((window, key))
            if key not in self._cache:
                starts = [_searched_start(self._axes, problem, window, route, self._grids)] if route and initial else []
                tasks.setdefault(key, partial(self._solve, window, starts, initial, few, key))
        saved = dict.fromkeys(tasks, 0.0)

        def hear(told: tuple[bytes, float]) -> None:
            key, gain = told
            saved[key] = gain * sum(one == key for _, one in windows)
            tell(duration(iterate) - sum(saved.values()))

        outcomes = dict(self._cache)
        if tasks and not outcomes:  # what it expresses and loads is there before other processes are forked
            begin = next(iter(tasks))
            outcomes[begin] = tasks[begin](hear)
        left = {key: task for key, task in tasks.items() if key not in outcomes}
        outcomes |= in_turns(left, hear, self._max_workers())
        for window, key in windows:
            outcome, span = outcomes[key], (window.first, window.last)
            if outcome.stopped:
                report.stopped = True
            else:
                self._cache[key] = outcome
                report.tried.add(span)
                (report.failed.discard if outcome.clean else report.failed.add)(span)
            if outcome.found is not None:
                iterate = window.put(outcome.found, iterate)
        for key in tasks:
            for phase, spent in outcomes[key].seconds.items():
                add(self._seconds, phase, spent)
        return iterate

    def _solve(
        self, window: Window, searched: Sequence[Iterate], initial: bool, few: bool, key: bytes,
        tell: Callable[[tuple[bytes, float]], None],
    ) -> _Outcome:  # fmt: skip
        """The window from the start with the best first answer and from those near it, the best of all; from the next
        one where that gains nothing.

        Args:
            window: what is asked.
            searched: starts of the search.
            initial: whether its motion is that of the initial plan: then parabolas between its ends are a start, too.
            few: whether the problem has few legs: then first answers are compared on a rough grid.
            key: of the window.
            tell: is told the key and what is saved [s].
        """
        own, problem = window.iterate, window.problem
        times = np.array([0.0 if motion is None else motion.T for motion in own.legs])
        coarse = first_iterate(self._axes, problem, own.q, own.qd, own.cfx, times, self._grids, _capped(own))
        near, seconds, clean = on_grid(self._axes, problem, own, self._grids), dict[str, float](), False
        best, least, first = None, cost(self._axes, problem, own.legs), np.inf
        try:
            starts: list[Iterate | Stage] = [near, coarse]
            if initial:
                passed = any(point.passage is not None for point in problem.waypoints)
                rough = [on_grid(self._axes, problem, own, self._grids.rough)] if few and not passed else []
                starts = [*self._first_answers(problem, [*searched, coarse, *rough], few, seconds), near]
            for start in starts:
                if isinstance(start, Stage):
                    answer = cost(self._axes, problem, start.iterate.legs)
                    first = min(first, answer)
                if best is not None and not (few and isinstance(start, Stage) and answer <= _RIVAL * first):
                    break
                if best is not None and answer <= _SAME_END * first:
                    continue
                with self._refiner(problem, seconds) as refiner, suppress(NotConverged):
                    found = refiner.run(start) if isinstance(start, Iterate) else refiner.finished(start)
                    clean = True
                    now = cost(self._axes, problem, found.legs)
                    if now < least - problem.plant.settings.least_gain and clear(self._axes, problem, found):
                        best, least = found, now
                        tell((key, cost(self._axes, problem, own.legs) - now))
                if clean and not initial:
                    break  # from a motion found before the way leads back to it
        except Stopped:
            return _Outcome(best, clean, seconds, stopped=True)
        return _Outcome(best, clean, seconds)

    def _first_answers(
        self, problem: Problem, starts: Sequence[Iterate], few: bool, seconds: dict[str, float]
    ) -> list[Stage]:
        """Stages from those starts that converge, the best first. Raises Stopped."""
        found, begun = [], list[Iterate]()
        for start in starts:
            with self._refiner(problem, seconds) as refiner, suppress(NotConverged):
                stage = refiner.begun(start)
                if any(_alike(one, stage.iterate) for one in begun):
                    continue  # where another has led already
                begun.append(stage.iterate)
                found.append(refiner.rough(stage) if few else stage)
        return sorted(found, key=lambda stage: cost(self._axes, problem, stage.iterate.legs))

    @contextmanager
    def _refiner(self, problem: Problem, seconds: dict[str, float]) -> Iterator[MeshRefinement]:
        """To solve a window's problem with; its seconds are added up."""
        refiner = MeshRefinement(
            self._axes, self._formulation, problem, self._patience, self._grids, collision_scene_of(problem)
        )
        try:
            yield refiner
        finally:
            for phase, spent in refiner.seconds.items():
                add(seconds, phase, spent)


def _searched_start(axes: Axes, problem: Problem, window: Window, route: Route, grids: Grids) -> Iterate:
    """The search's route between the window's ends; stations at an end in another configuration there stay as they
    are."""
    at, own = slice(window.first, window.last + 1), window.iterate
    q, qd, times = route.q[at].copy(), route.w[at].copy(), route.times[window.first : window.last].copy()
    cfx = [label.cfx for label in route.labels[at]]
    kept: set[int] = set()
    for end, point in ((0, window.problem.waypoints[0]), (len(cfx) - 1, window.problem.waypoints[-1])):
        if point.q is None:
            continue
        kept.add(end)
        if cfx[end] != own.cfx[end] or np.abs(q[end] - own.q[end])[axes.layout.arm].max() > np.pi:
            first, last = next(one for one in problem.stations if one[0] <= window.first + end <= one[1])
            kept |= {k for k in range(len(cfx)) if first <= window.first + k <= last}
    for k in kept:
        q[k], qd[k], cfx[k] = own.q[k], own.qd[k], own.cfx[k]
    for k, motion in enumerate(own.legs):
        if motion is not None and motion.T == 0.0:  # what is asked for where the motion is already
            times[k] = 0.0
        elif motion is not None and (k in kept or k + 1 in kept):
            times[k] = max(times[k], motion.T)
    return first_iterate(axes, window.problem, q, qd, tuple(cfx), times, grids, _capped(own))


def _alike(one: Iterate, other: Iterate) -> bool:
    """Whether two motions of a problem are one answer: at all waypoints, and in their legs' times."""
    times = ([0.0 if motion is None else motion.T for motion in each.legs] for each in (one, other))
    pairs = ((one.q, other.q), (one.qd, other.qd), tuple(times))
    return one.cfx == other.cfx and all(np.allclose(a, b, rtol=0.0, atol=_SAME) for a, b in pairs)


def _capped(iterate: Iterate) -> frozenset[int]:
    """The joint moves that have no closed form in a legal motion: they met a tool cap or a range."""
    return frozenset(k for k, motion in enumerate(iterate.legs) if isinstance(motion, JointNodes))


def may_gain(axes: Axes, piece: Problem, legal: Iterate) -> bool:
    """Whether the nonlinear program could find something gentler, as something moves; or faster: a rail is free, a tool
    may be turned, or a joint move takes longer than its axes and the tool's chord ask for."""
    if any(piece.passes(k) for k in range(len(piece.waypoints))):
        return False
    if any(leg.turn is not None for leg in piece.legs):
        return True
    if any(point.passage is not None for point in piece.waypoints):
        return piece.plant.robot.has_rail or any(leg.kind is LegKind.JOINT for leg in piece.legs)
    if piece.coordinated and any(leg.kind is LegKind.JOINT for leg in piece.legs):
        return False
    if isinstance(piece.objective, LeastEffort):
        return cost(axes, piece, legal.legs) > axes.settings.least_gain
    if axes.jerk is not None and any(leg.kind is LegKind.LINE for leg in piece.legs):
        return True
    moves = any(leg.rail_moves and leg.kind is not LegKind.JOINT for leg in piece.legs) and piece.plant.robot.has_rail
    free = any(point.free or (point.q is None and point.turn is not None) for point in piece.waypoints)
    return (
        moves
        or free
        or any(
            isinstance(motion, JointNodes)
            and _WORTH_TRYING * least_time(axes, leg, legal.q[k], legal.q[k + 1]) < motion.T
            for k, (leg, motion) in enumerate(zip(piece.legs, legal.legs, strict=True))
        )
    )
