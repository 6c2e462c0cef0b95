"""A legal motion for the whole program before any nonlinear program: the best route of waypoints that can be driven.

What may change less may be driven as well: the routes of lesser freedoms are tried too, so that more freedom is never
slower, whatever the search misses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from time import perf_counter
from typing import Any

import numpy as np

from trajopt_cli.collision.collision_scene import collision_scene_of, turned_into
from trajopt_cli.collision.motion_collision import clear
from trajopt_cli.graph_search.by_rails import check_reach, search
from trajopt_cli.graph_search.reach import broken_between
from trajopt_cli.motion import Program, motion_name
from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, Runs, duration, stopped, timed
from trajopt_cli.plan.collision_diagnosis import blocked_place, collision_answer
from trajopt_cli.plan.detour_planner import NoClearPath, clear_motions, coordinated
from trajopt_cli.plan.other_routes import with_better_parts
from trajopt_cli.plan.rail_refinement import refine_corner_rail, refine_rail
from trajopt_cli.plan.repair import timed_in_time
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, FIXED_RAIL, Freedom, RailFreedom
from trajopt_cli.problem.detours import Detour, Numbering, with_detours
from trajopt_cli.problem.editable import Changes, everything
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.plannable import with_exact_orientation
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.progress import Progress, Report
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectories.route import Route

_PROGRAMMED_RAIL = Freedom(RailFreedom.PROGRAMMED, False, False, False, drop=False)  # quickly searched


class NoCleanPlan(Exception):
    """Every start ended with a limit passed or without convergence. A failure of the optimiser, not of the program."""


class _Slower(Exception):
    """The search's best route takes longer than is asked for."""


@dataclass(frozen=True, eq=False)
class InitialPlan:
    """A motion at rest at every stop that keeps every limit, and the route it was timed from. detours: the points that
    its problem's program has besides its own, so that it touches nothing."""

    problem: Problem
    route: Route
    iterate: Iterate
    detours: tuple[Detour, ...] = ()

    @property
    def dropped(self) -> frozenset[int]:
        """The motions left out, as numbered in the program without additional points."""
        if not self.detours:
            return self.problem.dropped
        points = sum(len(detour.points) for detour in self.detours)
        numbering = Numbering(len(self.problem.program.motions) - points, self.detours)
        return frozenset(numbering.own(index) for index in self.problem.dropped)

    @property
    def duration(self) -> float:
        """Cycle time [s]."""
        return duration(self.iterate)


@dataclass(frozen=True, eq=False)
class PlanCache:
    """Answers to questions about one program, its plant, and what may change in it; what the routes that the search
    found for them take [s]; the runs that were driven; the questions whose search was stopped; and how a plan
    that a judge refuses is repaired."""

    answers: dict[tuple[Target, Freedom], InitialPlan | Infeasible] = field(default_factory=dict)
    estimates: dict[tuple[Target, Freedom], float] = field(default_factory=dict)
    runs: Runs = field(default_factory=dict)
    stopped: set[tuple[Target, Freedom]] = field(default_factory=set)
    repair: dict[tuple[Target, Freedom], Callable[..., Any]] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class PlanRequest:
    """What is asked: a program on a plant and a target, what may change at all, and which motions may have it."""

    program: Program
    plant: Plant
    target: Target
    freedom: Freedom
    changes: Changes | None = None

    def problems(self, axes: Axes) -> list[Problem | Infeasible]:
        """The whole program, and without the motions the user lets go if there are any; each checked for reach, and for
        what its positioners turn into."""
        turned = turned_into(self.plant, self.program) if self.freedom.ways else None
        return [(check_reach(axes, one) or turned or one) if isinstance(one, Problem) else one
                for one in self.unchecked()]  # fmt: skip

    def in_first_pass(self, axes: Axes, out: Infeasible) -> Infeasible:
        """Why a cycle cannot be done, as the program meets it from its start on: that comes first to who runs it."""
        if not self.program.before:
            return out
        once = replace(self.program, motions=self.program.before, before=None, beyond=())
        first = replace(self, program=once, plant=self.plant.at_home, changes=None).problems(axes)[0]
        return replace(first, index=out.index) if isinstance(first, Infeasible) else out

    def unchecked(self) -> list[Problem | Infeasible]:
        """The same, of which some may be out of reach: where that shows anyhow."""
        changes = self.changes or everything(self.program, self.plant)
        optional = changes.droppable if self.freedom.drop else frozenset()
        return [
            build_problem(self.program, self.plant, self.freedom, self.target, changes, dropped)
            for dropped in [frozenset[int]()] + ([optional] if optional else [])
        ]

    def detoured(self, dropped: frozenset[int], detours: Sequence[Detour]) -> Problem:
        """The program with additional points, without motions, which are numbered as in the one without them."""
        changes = self.changes or everything(self.program, self.plant)
        numbering = Numbering(len(self.program.motions), detours)
        program, left = with_detours(self.program, self.plant, detours), frozenset(map(numbering.at, dropped))
        problem = build_problem(program, self.plant, self.freedom, self.target, numbering.changes(changes), left)
        assert isinstance(problem, Problem), problem  # without points it is one
        return problem

    def restricted(self) -> Iterator[PlanRequest]:
        """The same of a RAPID controller with less that may change; each has a motion that this one allows."""
        if self.target is Target.RAPID or self.plant.limits.binding_jerk is not None:
            yield from self.with_less_rail()

    def with_less_rail(self) -> Iterator[PlanRequest]:
        """The same with a rail that may move less; for a stream, too."""
        if self.freedom.rail is RailFreedom.PROGRAMMED:
            return
        fewer = [FIXED_RAIL, AS_WRITTEN]
        if self.plant.limits.binding_jerk is not None:  # in a wait a rail may need longer than with free jerk
            fewer.insert(0, Freedom(dwells=False))
        restricted = (self.freedom.and_not_more_than(one) for one in fewer)
        yield from (replace(self, freedom=one) for one in restricted if one != self.freedom)


def find_initial_plan(
    axes: Axes, question: PlanRequest, memory: PlanCache, patience: Patience, tell: Report, seconds: dict[str, float]
) -> InitialPlan | Infeasible:
    """The fastest legal motion of the question's own routes and of those with less freedom. memory: what was found for
    other questions about the same program; what is found here is added. patience: ends the search once there is a
    motion; with a time limit the RAPID controller's is first looked for with the programmed rail. Raises NoCleanPlan,
    and Stopped where there is a motion, but none of this question."""
    start = perf_counter()
    tell(Progress("reach"))
    known = memory.answers.get((question.target, question.freedom))
    problems = question.unchecked()
    if not isinstance(known, InitialPlan):
        with suppress(Stopped):  # then what is known of lesser freedoms is in reach
            problems = question.problems(axes)
    open_ = [one for one in problems if isinstance(one, Problem)]
    add(seconds, "reach", perf_counter() - start)
    if not open_:
        assert isinstance(problems[0], Infeasible)
        return question.in_first_pass(axes, problems[0])
    own: InitialPlan | Infeasible | NoCleanPlan | Stopped
    tell(Progress("search"))
    others = [*question.restricted()]
    if others and patience.limit is not None:
        if not patience.settled:
            others.append(replace(question, freedom=question.freedom.and_not_more_than(_PROGRAMMED_RAIL)))
        with suppress(Stopped):  # what is quickly found comes first
            for less in reversed(others):
                found = _of_restricted(axes, question, less, open_, memory, patience, tell, seconds)
                if found is not None and clear(axes, found.problem, found.iterate):
                    patience.settle()
    try:
        own = known or _search_and_time(axes, question, open_, memory, patience, tell, seconds)
    except (NoCleanPlan, Stopped) as failure:
        own = failure
    best = own if isinstance(own, InitialPlan) else None
    estimate = memory.estimates.get((question.target, question.freedom), np.inf)
    alike = best is not None and not best.detours and axes.jerk is None  # what a search estimates, jerk apart
    most = estimate * (1 + axes.settings.worth) if alike else np.inf
    for less in others:
        near = list[InitialPlan]()
        try:
            found = _of_restricted(
                axes, question, less, open_, memory, patience, tell, seconds, isinstance(own, NoCleanPlan),
                np.inf if less.freedom == AS_WRITTEN else most,  # that is asked for anyhow
            )  # fmt: skip
            if found is not None and (best is None or found.duration < best.duration):
                near.append(found)
                near += _with_rail_freed(axes, found, memory.runs, seconds)
        except Stopped:
            memory.stopped.add((question.target, question.freedom))
        near = [one for one in near if clear(axes, one.problem, one.iterate)]
        best = min([*near, *([best] if best else [])], key=lambda one: one.duration, default=None)
    if isinstance(own, Stopped):
        memory.stopped.add((question.target, question.freedom))
    if best is None and isinstance(own, NoCleanPlan | Stopped):
        raise own
    if best is None:
        assert isinstance(own, Infeasible)
        return own
    memory.answers[question.target, question.freedom] = best
    if question.target is Target.RAPID and question.freedom == EVERYTHING:
        patience.settle()
    return best


def plans_with_less_rail(
    axes: Axes, question: PlanRequest, legal: InitialPlan, memory: PlanCache, seconds: dict[str, float]
) -> Iterator[InitialPlan]:
    """Legal motions of the same problem whose rail moves less, and which may take longer."""
    own = [one for one in question.unchecked() if isinstance(one, Problem) and one.dropped == legal.dropped]
    for less in question.with_less_rail():
        found = _of_restricted(axes, question, less, own, memory, Patience(), lambda _: None, seconds)
        if found is not None:
            yield found


def _of_restricted(
    axes: Axes, question: PlanRequest, less: PlanRequest, problems: Sequence[Problem], memory: PlanCache,
    patience: Patience, tell: Report, seconds: dict[str, float], may_detour: bool = False, most: float = np.inf,
) -> InitialPlan | None:  # fmt: skip
    """The legal motion of a question with less freedom as one of these problems', which are of this one; None where
    there is none, or where it asks for the same. may_detour: points may be added to the program, which takes time.
    most: as in initial_plan_of."""
    mine = {one.dropped: one for one in problems}
    asked = [one for one in less.unchecked() if isinstance(one, Problem) and one.dropped in mine]
    if all(_varies(one) == _varies(mine[one.dropped]) for one in asked):
        return None
    name = less.target, less.freedom
    if name not in memory.answers:
        try:
            found = _search_and_time(axes, less, asked, memory, patience, tell, seconds, may_detour, most)
        except (NoCleanPlan, _Slower):
            return None
        if isinstance(found, InitialPlan) or may_detour:
            memory.answers[name] = found
    else:
        found = memory.answers[name]
    if not isinstance(found, InitialPlan):
        return None
    if found.detours:
        return replace(found, problem=question.detoured(found.dropped, found.detours))
    return replace(found, problem=mine[found.problem.dropped])


def _search_and_time(
    axes: Axes, question: PlanRequest, problems: Sequence[Problem], memory: PlanCache, patience: Patience, tell: Report,
    seconds: dict[str, float], may_detour: bool = True, most: float = np.inf,
) -> InitialPlan | Infeasible:  # fmt: skip
    """initial_plan_of a question's problems; what its route takes is kept. may_detour: points may be added. Raises
    NoCleanPlan and _Slower."""
    name = question.target, question.freedom

    def keep(cost: float) -> None:
        memory.estimates.setdefault(name, cost)

    asked = question if may_detour else None
    return initial_plan_of(axes, problems, patience, tell, seconds, memory.runs, keep, asked, most)


def _varies(problem: Problem) -> tuple[object, ...]:
    """What differs between problems of one program and target with different freedoms."""
    free = not all(point.pinned for point in problem.waypoints)
    points = tuple((point.rail, point.others, point.conf, point.rest) for point in problem.waypoints)
    return points, tuple(leg.rail_moves for leg in problem.legs), free and problem.freedom.rail is RailFreedom.STATION


def _with_rail_freed(axes: Axes, found: InitialPlan, runs: Runs, seconds: dict[str, float]) -> Iterator[InitialPlan]:
    """The motion of a lesser freedom with its rail refined in the freedom at hand."""
    start = perf_counter()
    for route in _with_rail_refined(axes, found.problem, found.route, Times()):
        try:
            yield replace(found, route=route, iterate=timed(axes, found.problem, route, runs))
        except NotDriven:
            continue
    add(seconds, "timing", perf_counter() - start)


def initial_plan_of(
    axes: Axes, problems: Sequence[Problem], patience: Patience, tell: Report, seconds: dict[str, float],
    runs: Runs | None = None, searched: Callable[[float], None] = lambda _: None, question: PlanRequest | None = None,
    most: float = np.inf,
) -> InitialPlan | Infeasible:  # fmt: skip
    """That of the problem with the fastest route that can be driven; each one timed is told, and the first one of a
    stream is an answer. Where none can, as an axis would leave its range between the places that the search looks at,
    with narrower ranges. Where what is found touches something, the search is asked for what does not. runs: as in
    timed. searched: hears what the best route of a search takes [s], the first one in the whole ranges. question: whose
    problems they are, to add points to its program. most: what the best route of a search takes [s] at most. Raises
    NoCleanPlan, and _Slower where that takes longer."""
    settings = axes.settings
    failure: tuple[Problem, NotDriven] | None = None
    touched: NoClearPath | None = None
    for room in settings.range_shares:
        start = perf_counter()
        narrow, known = axes.narrowed(room), Times()
        routes = [(search(narrow, coordinated(problem)), coordinated(problem), problem) for problem in problems]
        if costs := [route.cost for route, _, _ in routes if route is not None]:
            searched(min(costs))
            if min(costs) > most:
                raise _Slower
        found = [
            (_with_rail_refined(narrow, bound, route, known), route, bound, problem)
            for route, bound, problem in routes
            if route is not None
        ]
        add(seconds, "search", perf_counter() - start)
        hopeless = bool(found)  # with less room it takes no less
        for tried, route, bound, problem in sorted(found, key=lambda one: one[0][0].cost):
            iterates: list[InitialPlan] = []
            for coupled in dict.fromkeys((bound, problem)):
                if coupled is not bound:  # a rail that suits free axes; but that for one progress may be the better one
                    if iterates and patience.over:
                        break
                    start = perf_counter()
                    with suppress(Stopped):
                        tried = _with_rail_refined(narrow, coupled, route, known)
                    add(seconds, "search", perf_counter() - start)
                start = perf_counter()
                for one in _and_other_route(narrow, coupled, route, tried, known, patience):
                    try:
                        one, iterate = timed_in_time(axes, problem, one, runs, narrow, known)
                    except Stopped:
                        if not iterates:
                            raise
                        break
                    except NotDriven as said:
                        failure = failure or (problem, said)
                        wanted = problem.legs[said.run[0]].duration
                        hopeless &= (
                            said.least is not None and wanted is not None and said.least > settings.hopeless * wanted
                        )
                        continue
                    if isinstance(iterate, NoClearPath):
                        touched = touched or iterate
                        continue
                    iterates.append(InitialPlan(problem, one, iterate))
                    if not problem.coordinated:
                        patience.answer()
                    tell(Progress("timing", iterates[-1].duration))
                add(seconds, "timing", perf_counter() - start)
            if iterates:
                return min(iterates, key=lambda one: one.duration)
        if touched is not None and question is not None:
            start = perf_counter()
            tell(Progress("ways around"))
            blocked = [blocked_place(axes, problem) for problem in problems]
            if None not in blocked:
                assert blocked[0] is not None
                return blocked[0]
            detoured = _with_detours(narrow, question, problems, known, runs, patience)
            add(seconds, "ways around", perf_counter() - start)
            if isinstance(detoured, InitialPlan):
                tell(Progress("timing", detoured.duration))
                return detoured
            touched = _better_diagnosis(touched, detoured)
            if failure is None:  # with less room there is no more
                break
        if failure is None and touched is None:
            return _no_route(problems[0].program, any(problem.ties for problem in problems))
        if hopeless:
            break
    if touched is not None:
        return collision_answer(axes, touched, runs)
    assert failure is not None
    return _not_driven(axes, *failure)


def _with_detours(
    axes: Axes, question: PlanRequest, problems: Sequence[Problem], known: Times, runs: Runs | None, patience: Patience
) -> InitialPlan | NoClearPath | None:
    """The fastest motion found that touches nothing, and where the time is over the first one; or what the best one
    touches."""
    changes = question.changes or everything(question.program, question.plant)
    found: list[InitialPlan] = []
    failure: NoClearPath | None = None

    def shifted(problem: Problem, route: Route) -> list[Route]:
        near = refine_rail(axes, problem, route, known, collision_scene_of(problem))
        return [*dict.fromkeys([near, refine_corner_rail(axes, problem, near)])]

    for problem in problems:
        try:
            for one in clear_motions(
                axes, coordinated(problem), problem, changes.straight, changes.detours, question.detoured, shifted, runs
            ):
                found.append(InitialPlan(one.problem, one.route, one.iterate, one.detours))
                if question.target is Target.RAPID and question.freedom == EVERYTHING:
                    patience.settle()
        except NoClearPath as said:
            failure = said
        except NotDriven:
            continue
        except Stopped:
            if not found:
                raise
    return min(found, key=lambda one: one.duration, default=failure)


def _better_diagnosis(touched: NoClearPath, detoured: NoClearPath | None) -> NoClearPath:
    """What tells best why there is no plan: the motion by points that touches something; else the one without, at the
    leg where routes end that touch nothing."""
    if detoured is None or detoured.iterate is not None:
        return detoured or touched
    legs = tuple(k for k in detoured.legs if k in touched.legs) if detoured.problem is touched.problem else ()
    return NoClearPath(touched.problem, legs, touched.iterate, touched.route) if legs else touched


def _with_rail_refined(axes: Axes, problem: Problem, route: Route, known: Times) -> list[Route]:
    """The route with its rail refined, leg by leg; with corners also as if every fly-by was a stop, as small corners
    are nearly that, and a leg alone does not see how the rail bends in them. known: as in leg_times."""
    asked = dict.fromkeys([problem, stopped(problem) if axes.layout.has_rail else problem])
    return [refine_corner_rail(axes, problem, refine_rail(axes, one, route, known)) for one in asked]


def _and_other_route(
    axes: Axes, problem: Problem, route: Route, tried: Sequence[Route], known: Times, patience: Patience
) -> Iterator[Route]:
    """Refined routes, and once these are driven the first of them with other parts that the search found, if they take
    less time. known: as in leg_times."""
    yield from tried
    better: Route | None = None
    with suppress(Stopped):
        better = None if patience.over else with_better_parts(axes, problem, route, tried[0], known)
    if better is not None:
        yield refine_corner_rail(axes, problem, better)


def _not_driven(axes: Axes, problem: Problem, failure: NotDriven) -> Infeasible:
    """The answer no where a leg has less time than it takes, passes a singularity, or is out of reach between the nodes
    of the search. Raises NoCleanPlan where it is for none of them."""
    leg = problem.legs[failure.run[0] if failure.singular is None else failure.singular.leg]
    motion = problem.motion(leg.motion)
    if failure.least is not None:
        text = f"has {leg.duration:g} s and takes {failure.least:.3f} s as fast as was found; give it more time"
    elif (heavy := _too_heavy(axes, problem, failure.run)) is not None:
        text = f"cannot be driven: {heavy}; take a lighter tool or load, or bring the point nearer"
    elif failure.singular is not None:
        elbow, wrist = axes.robot.singularity_margins(failure.singular.q[axes.layout.arm])
        what = "the wrist singularity (axes 4 and 6 parallel)" if wrist < 1 - elbow else "the stretched or folded elbow"
        p = (axes.forward(failure.singular.q) @ leg.X_FT)[:3, 3] * 1e3
        text = (
            f"passes {what} at [{p[0]:.1f}, {p[1]:.1f}, {p[2]:.1f}] mm, where no speed is low enough; tilt the tool,"
            f" shift the way, or use MoveJ{with_exact_orientation(motion)}"
        )
    elif (broken := broken_between(axes, problem, range(*failure.run))) is not None:
        return broken
    else:
        raise NoCleanPlan(f"{motion.source}: no way of driving it from {motion_name(motion)} on was found")
    return Infeasible(leg.motion, motion.source, f"{motion_name(motion)} {text}")


def _too_heavy(axes: Axes, problem: Problem, run: tuple[int, int]) -> str | None:
    """Which axis cannot hold the arm at a point of a run in any posture, in words; a rail that is free there stands in
    the middle of its room."""
    for k in range(*run):
        for point in problem.waypoints[k : k + 2]:
            postures = [point.q]
            if point.q is None:
                rail = np.mean(point.ranges(problem.layout), axis=0)
                found = axes.robot.solutions(point.X_WF, rail, problem.plant.limits)
                postures = [axes.layout.merge(rail, arm) for _, arm in found]
            for limit in limits_of(axes):
                heavy = [limit.why_not(problem.legs[k], q) for q in postures if q is not None]
                if heavy and all(heavy):
                    return heavy[0]
    return None


def _no_route(program: Program, tied: bool) -> Infeasible:
    index = len(program.motions) - 1
    source = program.motions[index].source
    why = "no route of configurations connects the start with the program's end"
    if tied:
        why += ", each target of a loop or routine in one configuration for all passes; --loops unroll asks for less"
    return Infeasible(index, source, why)


def add(total: dict[str, float], phase: str, spent: float) -> None:
    """Add seconds to a phase."""
    total[phase] = total.get(phase, 0.0) + spent
