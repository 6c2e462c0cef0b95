"""Repair of a plan where it is broken, leg by leg: what is legal elsewhere stays as it is.

A leg that has less time than its way takes goes less far with the rail. Where the rows of a file pass a limit between
them, the legs there from one rest to the next are driven a hair slower; where one among them has a time of its own, and
is entered or left in motion, they are solved again with less of every limit. So are those that a judge refuses.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.collision.collision_scene import collision_scene_of
from trajopt_cli.collision.motion_collision import clear
from trajopt_cli.geometry import Array
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import Grids, MeshRefinement, NotConverged, slowed
from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, Runs, duration
from trajopt_cli.plan.detour_planner import NoClearPath, timed_clear
from trajopt_cli.plan.ladder import Judged
from trajopt_cli.plan.output_rows import motions_of, rows_of
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.plan.subproblems import Span, Window
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.route import Route
from trajopt_cli.trajectory import Trajectory

_SHORTENINGS = 3  # times that the way in one leg is shortened
_ROW_ROUNDS = 16  # of mending rows; each is twice as strong as the one before it
_REFUSALS = 6  # of a judge after which nothing is driven slower any more. Not measured.
_MOST_LESS = 0.25  # of every limit that is left unused where a motion is mended at most. Not measured.
_HAIR = 1e-4  # share of its time that a shortened leg has to spare
_SAME = 1e-9  # m, rad
_ROWS = "the file's rows would have passed a limit"


def timed_in_time(
    axes: Axes, problem: Problem, route: Route, runs: Runs | None, room: Axes, known: Times
) -> tuple[Route, Iterate | NoClearPath]:
    """A route as timed; where a leg has less time than it takes, one whose rail goes as far in that leg as can be
    driven, and elsewhere what suits that best.

    Args:
        axes, problem, route, runs: as in timed_clear.
        room: axes in whose ranges rail positions are looked for.
        known: as in leg_times.

    Returns:
        The route that was driven, and what timed_clear says of it.

    Raises:
        NotDriven: where no way is short enough, or none is what is wrong.
    """
    asked, tries = problem, Counter[int]()
    while True:
        try:
            return route, timed_clear(axes, problem, route, runs)
        except NotDriven as said:
            k = said.run[0]
            has = problem.legs[k].duration
            tries[k] += 1
            if said.least is None or has is None or tries[k] > _SHORTENINGS:
                raise
            if said.least > axes.settings.hopeless * has:  # the route's rail was refined to be the least late
                raise
            shorter = refine_rail(room, asked, route, known)
            if np.abs(shorter.q - route.q).max() < _SAME:  # the few nodes it is timed on there say that it fits
                legs = list(asked.legs)
                legs[k] = replace(legs[k], duration=(legs[k].duration or has) * has / said.least * (1 - _HAIR))
                asked = replace(asked, legs=tuple(legs))
                shorter = refine_rail(room, asked, route, known)
                if np.abs(shorter.q - route.q).max() < _SAME:
                    raise
            route = shorter


@dataclass(frozen=True, eq=False)
class Repaired:
    """A motion with its rows and the boundaries of its legs (L + 1,) [s], and what a reader should know of it."""

    iterate: Iterate
    rows: tuple[Trajectory, Array]
    notes: tuple[str, ...]


def with_legal_rows(axes: Axes, problem: Problem, iterate: Iterate, patience: Patience) -> Repaired | None:
    """A clean motion whose rows keep every limit between them, too: as it is, or mended where they do not; None where
    that cannot be."""
    took = duration(iterate)
    rounds = Counter[Span]()
    for _ in range(_ROW_ROUNDS):
        trajectory, bounds, over = rows_of(axes, problem, iterate)
        if not len(over):
            notes = _told(problem, rounds, duration(iterate) / took - 1, _ROWS) if rounds else ()
            return Repaired(iterate, (trajectory, bounds), notes)
        found = _gentler_at(axes, problem, iterate, over, 1 - axes.settings.start, rounds, patience)
        if found is None:
            return None
        iterate = found
    return None


def repaired(
    axes: Axes, problem: Problem, iterate: Iterate, notes: tuple[str, ...], first: tuple[Problem, Iterate] | None,
    patience: Patience, planned: Callable[[Problem, Repaired], Plan], judged: Judged, judge: Callable[[Plan], Judged],
) -> Judged:  # fmt: skip
    """A plan that a judge refuses, repaired: slower where it is too fast, else the first legal motion.

    Args:
        problem, iterate, notes: what was planned.
        first: the first legal motion and its problem, None where it is that.
        planned: makes a plan of a motion.
        judged: the plan and what the judge says of it.
        judge: judges another one.

    Returns:
        The last plan that was judged: the first legal one where any is.
    """
    took, left, rounds, hair = duration(iterate), _REFUSALS, Counter[Span](), 1 - axes.settings.start
    while not judged.report.legal:
        over, why, left = np.array(judged.report.excesses).T, judged.report.refusal, left - 1
        slower = None
        if len(over) and left >= 0:
            times = np.concatenate([over[0] - axes.settings.row_step, over[0] + axes.settings.row_step])
            slower = _gentler_at(axes, problem, iterate, times, max(over[1].max(), hair), rounds, patience)
        if slower is not None and (first is None or duration(slower) < duration(first[1])):
            iterate, told = (
                slower,
                _told(problem, rounds, duration(slower) / took - 1, f"as it was found the plan {why}"),
            )
        elif first is not None:
            (problem, iterate), first, rounds, told = first, None, Counter(), ()
            notes = (f"the plan is the first legal one: the faster one, of {took:.3f} s, {why}",)
        else:
            break
        if (mended := with_legal_rows(axes, problem, iterate, patience)) is not None:
            judged = judge(planned(problem, replace(mended, notes=(*notes, *told, *mended.notes))))
    return judged


def _told(problem: Problem, spans: Iterable[Span], longer: float, why: str) -> tuple[str, ...]:
    """Where the motion is slower than found, by what share of the cycle, and why."""
    where = ", ".join(str(problem.motion(problem.legs[first].motion).source) for first, _ in sorted(spans))
    return (f"{where}: slower there, by {100 * max(longer, 0.0):.2g} % of the cycle: {why}",)


def _gentler_at(
    axes: Axes,
    problem: Problem,
    iterate: Iterate,
    times: Array,
    share: float,
    rounds: Counter[Span],
    patience: Patience,
) -> Iterate | None:
    """The motion with a share less of every limit around some times [s], twice as much at each further round; None
    where no such motion is found, or nothing moves then."""
    motions = motions_of(iterate)
    at = np.unique(np.searchsorted(np.cumsum([motion.T for motion in motions[:-1]]), times, side="right")).tolist()
    legs = [k for k in at if not motions[k].resting().all()]
    for span in sorted({_from_rest_to_rest(problem, iterate, k) for k in legs}):
        less = min(share * 2.0 ** rounds[span], _MOST_LESS)
        rounds[span] += 1
        found = _gentler(axes, problem, iterate, span, [k for k in legs if span[0] <= k < span[1]], less, patience)
        if found is None:
            return None
        iterate = found
    return iterate if legs else None


def _from_rest_to_rest(problem: Problem, iterate: Iterate, k: int) -> Span:
    """The legs around leg k, itself among them, from a waypoint at rest to the next one."""
    at_rest = [not problem.passes(i) and not iterate.qd[i].any() for i in range(len(problem.waypoints))]
    first = next((i for i in range(k, 0, -1) if at_rest[i]), 0)
    return first, next((i for i in range(k + 1, len(problem.legs)) if at_rest[i]), len(problem.legs))


def _gentler(
    axes: Axes, problem: Problem, iterate: Iterate, span: Span, legs: Sequence[int], share: float, patience: Patience
) -> Iterate | None:
    """The motion with a span so much slower, or with so much less of every limit on some of its legs; None where no
    such motion is found."""
    window = Window.of(problem, iterate, span)
    timed = any(leg.duration is not None for leg in window.problem.legs)
    if not timed and not isinstance(problem.objective, LeastEffort):
        return window.put(slowed(window.problem, window.iterate, 1 + share), iterate)
    beside, first = problem.plant.settings.window_overlap // 2, span[0]
    near = max(first, legs[0] - beside), min(span[1], legs[-1] + 1 + beside)
    if near != span:  # the ends are held in motion
        window, first = Window.of(problem, iterate, near), near[0]
    if any(window.problem.passes(k) for k in range(len(window.problem.waypoints))):
        return None
    scene = collision_scene_of(window.problem)
    refiner = MeshRefinement(axes, Formulation(axes), window.problem, patience, Grids.of(problem), scene)
    try:
        found = refiner.tightened(window.iterate, [k - first for k in legs], 1 - 2 * share)
    except (NotConverged, Stopped):
        return None
    return window.put(found, iterate) if clear(axes, window.problem, found) else None
