"""The other routes of branches, turns and rail positions that a search found, timed as well: the best one is kept.

A search estimates what lines take; so the second best route may be the best one. Where others differ, a few stations
are refined by themselves, which costs no more in a long program than in a short one.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from trajopt_cli.graph_search.search import window
from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import OtherPart, Route

_GAIN = 1e-5  # s that another part must save
_LAST = 0.004  # m, the last step that the rail is refined with to see that


def with_better_parts(axes: Axes, problem: Problem, route: Route, refined: Route, known: Times) -> Route | None:
    """A route, refined, with the other parts that the search found in place of its own where they take less time.

    Args:
        axes: of the plant.
        problem: whose route it is.
        route: as the search found it.
        refined: the same with its rail refined.
        known: as in leg_times.

    Returns:
        The route, refined as a whole; None where no other part takes less.
    """
    best = refined
    for part in route.others:
        best = _with_part(axes, problem, best, part, known)
    return None if best is refined else refine_rail(axes, problem, best, known)


def _with_part(axes: Axes, problem: Problem, best: Route, part: OtherPart, known: Times) -> Route:
    """The route with another part in place of its own, the stations beside it refined with it, if that takes less."""
    station = next(i for i, (first, _) in enumerate(problem.stations) if first == part.first)
    behind = next(i for i, (_, last) in enumerate(problem.stations) if last == part.last)
    begin = problem.stations[station - 2][1] if station > 1 else 0
    end = problem.stations[behind + 2][0] if behind + 2 < len(problem.stations) else len(problem.legs)
    q, labels, at = best.q.copy(), [*best.labels], slice(part.first, part.last + 1)
    q[at], labels[at] = part.q, part.labels
    some, legs = slice(begin, end + 1), slice(begin, end)
    tried = Route(q[some], np.zeros_like(q[some]), tuple(labels[some]), best.times[legs], np.inf)
    own = window(problem, begin, end, best.q[begin], best.q[end])
    now = float(best.times[legs].sum())
    most = now + axes.settings.worth * min(now, axes.settings.near_span)
    found = refine_rail(axes, own, tried, known, last=_LAST, most=most)
    if found.cost >= now - _GAIN:
        return best
    q[some], labels[some], times = found.q, found.labels, best.times.copy()
    times[legs] = found.times
    return replace(best, q=q, labels=tuple(labels), times=times, cost=float(times.sum()))
