"""Several rails, one at a time: one is sought while the others stand as they do on a schedule, then the next one, until
nothing is gained.

Rails shift the base and do not turn it, so holding some of them leaves the problem of one rail, its poses seen from
where the held ones have taken the base: Problem.seen and seen_along say how a pose and a path look, axes_at and ways
what else moves. That is all the search asks of a coordinate. Its work grows with the number of rails, not with the
product of their grids.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise, product

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.graph_search import reach
from trajopt_cli.graph_search.search import search as search_one
from trajopt_cli.problem.decision_scope import RailFreedom
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.problem import LegKind, Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import EdgeChecks
from trajopt_cli.trajectories.route import Route

_ROUNDS = 2  # through all rails, at most.
_LEAST = 1e-5  # s that a round must save.
_SHARES = (0.5, 0.0, 1.0, 0.25, 0.75)  # of each stroke: where rails are held to see what can be reached at all.

Refine = Callable[[Axes, Problem, Route], Route]


def by_rails(axes: Axes, problem: Problem, route: Route, refine: Refine, most: float = np.inf) -> Route:
    """A route that is refined with each rail sought in turn, the others held where the route has them. most: what it
    takes [s] at most after any turn; what takes longer is left."""
    if axes.layout.r < 2:
        return refine(axes, problem, route)
    best, since = route, 0
    for turn in range(_ROUNDS * axes.layout.r):
        i = turn % axes.layout.r
        found = refine(axes.seeking(i), problem.seeking(i, best.q), best)
        since = 0 if turn == 0 or found.cost < best.cost - _LEAST else since + 1
        if found.cost < best.cost or turn == 0:
            best = found
        if since >= axes.layout.r - 1 or best.cost > most:
            break
    return best


def search(axes: Axes, problem: Problem, avoid: EdgeChecks | None = None) -> Route | None:
    """As of graph_search.search, of any number of rails: from schedules on which they stand as written, and abreast of
    the points, the best route that is found; where there is none, the first one from places all over their strokes."""
    if axes.layout.r < 2:
        return search_one(axes, problem, avoid)
    best: Route | None = None
    for d in _schedules(axes, problem):
        for i in range(axes.layout.r):
            if (found := _sought(axes, problem, i, d, avoid)) is not None:
                best = found if best is None or found.cost < best.cost else best
                break
    if best is None:
        routes = (search_one(one, own, avoid) for one, own in one_sought(axes, problem))
        best = next((found for found in routes if found is not None), None)
    if best is None or not any(point.free for point in problem.waypoints):
        return best
    return by_rails(axes, problem, best, lambda one, own, route: search_one(one, own, avoid) or route)


def check_reach(axes: Axes, problem: Problem) -> Infeasible | None:
    """As of reach, of any number of rails, which are held in places all over their strokes."""
    if axes.layout.r < 2:
        return reach.check_reach(axes, problem)
    for first, last in problem.stations:
        why: Infeasible | None = None
        for one, own in one_sought(axes, problem):
            found = reach.unserved(one, own, first, last)
            if found is None:
                why = None
                break
            why = why or found
        if why is not None:
            return why
    return reach.dead_end(problem)


def one_sought(axes: Axes, problem: Problem) -> Iterator[tuple[Axes, Problem]]:
    """Each rail sought while the others are held, in places all over their strokes; what is given where there is one
    rail or none."""
    tried = set[tuple[int, bytes]]()
    for i, d in product(range(axes.layout.r), _tries(axes, problem)) if axes.layout.r > 1 else ():
        held = i, np.delete(d, i, axis=1).tobytes()
        if held not in tried:
            tried.add(held)
            yield axes.seeking(i), problem.seeking(i, _with_rails(axes, d))
    if not tried:
        yield axes, problem


def _sought(axes: Axes, problem: Problem, i: int, d: Array, avoid: EdgeChecks | None) -> Route | None:
    return search_one(axes.seeking(i), problem.seeking(i, _with_rails(axes, d)), avoid)


def _with_rails(axes: Axes, d: Array) -> Array:
    """Axes (M, n) of which only the rails' d (M, r) are asked for."""
    return axes.layout.merge(d, np.zeros((len(d), axes.layout.joints)))


def _tries(axes: Axes, problem: Problem) -> Iterator[Array]:
    """Schedules of all rails (M, r), the likely ones first."""
    yield from _schedules(axes, problem)
    low, high = _ranges(problem)
    if np.any(low < high):
        yield from (low + np.array(share) * (high - low) for share in product(_SHARES, repeat=axes.layout.r))


def _ranges(problem: Problem) -> tuple[Array, Array]:
    """From where to where the rails may stand at the waypoints (M, r)."""
    ends = np.array([one.ranges(problem.layout) for one in problem.waypoints])
    return ends[:, 0], ends[:, 1]


def _schedules(axes: Axes, problem: Problem) -> Iterator[Array]:
    """Where the rails stand at the waypoints (M, r): as written; and abreast, the flange seen from the base where it is
    at the start, as far as the strokes go. They stay where they must."""
    layout, points, robot = problem.layout, problem.waypoints, axes.robot
    low, high = _ranges(problem)
    written = np.array([np.insert(one.also, layout.sought, one.written) for one in points])
    yield _held_together(problem, written, low, high)
    if np.any(low < high):
        start = problem.plant.start
        away = np.array([one.X_WF[:3, 3] for one in points]) - robot.forward(start)[:3, 3]
        abreast = start[layout.rail] + away @ np.linalg.pinv(robot.rail_axes_W)
        yield _held_together(problem, abreast, low, high)


def _held_together(problem: Problem, wanted: Array, low: Array, high: Array) -> Array:
    """The wanted positions (M, r) in their ranges, the same where no rail moves between waypoints: that of one that is
    given, else the mean."""
    group = np.arange(len(wanted))
    alike = [pair for one in problem.ties for pair in pairwise(one)]
    for leg in problem.legs:
        stays = problem.freedom.rail is RailFreedom.STATION and leg.kind is not LegKind.JOINT
        if stays or not leg.rail_moves:
            alike.append((leg.start, leg.start + 1))
    for a, b in alike:
        group[group == group[b]] = group[a]
    out = np.clip(wanted, low, high)
    for number in np.unique(group):
        some = np.flatnonzero(group == number)
        given = some[np.all(low[some] == high[some], axis=1)]
        out[some] = out[given[0]] if len(given) else out[some].mean(axis=0)
    return out
