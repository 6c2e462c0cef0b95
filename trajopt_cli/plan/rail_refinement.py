"""Where the rail stands at the waypoints of a route: positions near those at hand that the least time is found at.

Between two stops they decide everything else. They are refined by dynamic programming over a few positions beside
those at hand, with every leg timed along its way, in steps that shrink until nothing is gained; at corners, where a leg
alone does not say how fast it is passed, they are shifted with whole runs timed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import groupby, pairwise, product

import numpy as np

from trajopt_cli.collision.collision_scene import CollisionScene
from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.graph_search.by_rails import by_rails
from trajopt_cli.graph_search.search import best_route
from trajopt_cli.graph_search.shared_states import shared
from trajopt_cli.path.hermite import natural_spline
from trajopt_cli.path_timing.edge_times import Pairs, Times, leg_times, short
from trajopt_cli.path_timing.path_parameterized_plan import about
from trajopt_cli.problem.decision_scope import RailFreedom
from trajopt_cli.problem.problem import LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import Route

_REFINE_ROUNDS = 40  # at most.
_TOGETHER_FIRST, _TOGETHER_LAST = 0.08, 0.004  # m, steps of several rails at once.
_REFINE_LOOK = 3  # of them after which it shows whether a route may become the best one.
_LEAST_POLISH = 1e-05  # s that a shift must save.
# steps beside a rail position that are tried. Measured on twenty random programs: only the nearest ones at steps below
# 5 mm gave up to 0.03 % more time, 0.007 % on average, in 0.8 of the time.
_REFINE_OFFSETS = (-2.0, -1.0, 0.0, 1.0, 2.0)
_CALM = 0.001  # s per metre of it and squared slope of the rail that is charged there.
# Measured from seven starts of four programs: only those of one run gave up to 0.49 % more time, 3 likewise; 5 the
# same within 0.01 %.
_TOGETHER = 4  # neighbouring points at most that are shifted together, across stops too.
_CARRY_LOOKS = 6  # of the lines between two such positions that are timed at most.
# steps by which both ends of a leg are shifted otherwise at most. Measured on ten programs: 0.002 % faster on average
# than with all pairs, the slowest 0.0006 % slower.
_REFINE_APART = 2
_RUSH = 4.0  # times the rail's way at top speed in a short line's time that its ends may be apart.

_SAME = 1e-9  # m between rail positions that are one

_Span = tuple[int, int, Array, Array]  # waypoints a and b, and axes (m, n) at both


def refine_rail(
    axes: Axes, problem: Problem, route: Route, known: Times | None = None, around: CollisionScene | None = None,
    last: float = 0.0, most: float = np.inf,
) -> Route:  # fmt: skip
    """The route with the rail positions that the least time is found at, beside those it has; of several rails one
    after the other while the others stand, then, where nothing is around, all at once. known: as in leg_times. around:
    what is not touched at them, nor by straight joint moves between them. last: the least step [m], where that of the
    settings is too fine. most: what it takes [s] at most after a few rounds; what takes longer is left."""
    known = Times() if known is None else known
    refine = partial(_refine_rail, known=known, around=around, last=last, most=most)
    found = by_rails(axes, problem, route, refine, most)
    return _refine_together(axes, problem, found, known) if np.isinf(most) and around is None else found


def _refine_rail(
    axes: Axes, problem: Problem, route: Route, known: Times, around: CollisionScene | None, last: float, most: float
) -> Route:
    """The same of the sought rail."""
    settings = axes.settings
    free = [k for k, point in enumerate(problem.waypoints) if point.q is None and point.rail[0] < point.rail[1]]
    still = replace(route, w=np.zeros_like(route.w))
    if not free or not axes.layout.has_rail:
        legs = [Pairs(k, route.q[[k]], route.q[[k + 1]], _branch(route, k)) for k in range(len(problem.legs))]
        times = np.concatenate(leg_times(axes, problem, legs, known))
        return replace(still, times=times, cost=float(times.sum()))
    places = _Places.of(axes, problem, still)
    marks, best = _with_carried_points(problem, still, places)
    index = {k: i for i, k in enumerate(marks.tolist())}
    ties = tuple(tuple(index[k] for k in group) for group in problem.ties)
    points = [problem.waypoints[k] for k in marks]
    reached, cost = np.inf, np.inf
    changed = np.ones(len(marks), dtype=bool)
    step = np.where(np.isin(np.arange(len(problem.waypoints)), free), settings.refine_step, 0.0)
    near, edges = list[Array](), list[Array]()
    for turn in range(_REFINE_ROUNDS):
        before = near
        found = iter(_candidates(axes, problem, best, marks[changed], step, around))
        near = [next(found) if new else before[i] for i, new in enumerate(changed)]
        edges = _edge_times(axes, problem, marks, near, best, places, before, edges, step, known, around)
        common = shared(axes, points, near, ties)
        cost, path = best_route(near, edges, ties, common, settings.tie_candidates)
        if not np.isfinite(cost):
            break
        q = np.array([near[k][i] for k, i in enumerate(path)])
        times = np.array([edges[k][path[k], path[k + 1]] for k in range(len(edges))])
        stays = np.abs(q - best.q[marks]).max(axis=1) < _SAME
        there = stays | (cost > reached * (1 - settings.refine_gain))
        best, reached = _route_through(best, places, marks, q, times), cost
        least = np.maximum(np.where(_carrying(marks), settings.carry_last, settings.refine_last), last)
        if np.all(there & (step[marks] <= least)) or (turn >= _REFINE_LOOK and cost > most):
            break
        shorter = np.where(there & (step[marks] > least), np.maximum(step[marks] / 2, least), step[marks])
        changed, step[marks] = ~stays | (shorter != step[marks]), shorter
    return _on_spline(best, places, marks)


def _refine_together(axes: Axes, problem: Problem, route: Route, known: Times) -> Route:
    """The route with all of several rails shifted at once, to neighbours on a lattice that gets finer; as it is where
    points are tied or carried along."""
    r, points = axes.layout.r, problem.waypoints
    if r < 2 or problem.ties or any(short(problem, k) for k in range(len(problem.legs))):
        return route
    shifts, step, left = np.array([*product((0.0, 1.0, -1.0), repeat=r)]), _TOGETHER_FIRST, _REFINE_ROUNDS
    while step > _TOGETHER_LAST and (left := left - 1):
        near = list[Array]()
        for k, point in enumerate(points):
            low, high = point.ranges(problem.layout)
            some = shifts if point.q is None and np.any(low < high) else shifts[:1]
            d = np.clip(route.q[k][axes.layout.rail] + step * some, low, high)
            arm = axes.branch(np.repeat(point.X_WF[None], len(d), axis=0), d, max(route.labels[k].cfx, 0))
            arm += 2 * np.pi * np.round((route.q[k][axes.layout.arm] - arm) / (2 * np.pi))
            q = axes.layout.merge(d, arm)
            ok = axes.within(q)
            ok[0], q[0] = True, route.q[k]
            near.append(q[ok])
        asked, rows = list[Pairs](), list[tuple[IndexArray, ...]]()
        for k, (a, b) in enumerate(pairwise(near)):
            leg, way = problem.legs[k], (b[None, :] - a[:, None])[..., axes.layout.rail]
            ok = np.abs(way - (route.q[k + 1] - route.q[k])[axes.layout.rail]).max(axis=2) <= step + _SAME
            if not leg.rail_moves or (problem.freedom.rail is RailFreedom.STATION and leg.kind is not LegKind.JOINT):
                ok = np.abs(way).max(axis=2) <= _SAME
            if (led := problem.leads(k, a, b)) is not None:
                ok = ok & led
            rows.append(np.nonzero(ok))
            asked.append(Pairs(k, a[rows[-1][0]], b[rows[-1][1]], _branch(route, k)))
        edges = [np.full((len(a), len(b)), np.inf) for a, b in pairwise(near)]
        for edge, at, times in zip(edges, rows, leg_times(axes, problem, asked, known), strict=True):
            edge[at] = times
        cost, path = best_route(near, edges, (), near, axes.settings.tie_candidates)
        if cost > route.cost * (1 - axes.settings.refine_gain):
            step /= 2
        if cost < route.cost:
            q = np.array([near[k][i] for k, i in enumerate(path)])
            spent = np.array([edge[i, j] for edge, (i, j) in zip(edges, pairwise(path), strict=True)])
            route = replace(route, q=q, times=spent, cost=float(spent.sum()))
    return route


def _on_spline(route: Route, places: _Places, marks: IndexArray) -> Route:
    """The route with the rail on a cubic spline through the marks where points are carried along: between short lines
    there is no room for the rail to change its speed. As it is where the arm cannot follow."""
    q, place = route.q.copy(), places.axes.layout.place
    for far, group in groupby(pairwise(marks.tolist()), key=lambda pair: pair[1] > pair[0] + 1):
        ends = [*group]
        if not far or len(ends) < 2:
            continue
        first, last = ends[0][0], ends[-1][1]
        knots = np.array([first, *(b for _, b in ends)])
        if np.ptp(place(q[knots])) < _SAME:  # the rail stands
            continue
        way = np.concatenate([[0.0], np.cumsum(places.chords[first:last])])
        inner = np.arange(first + 1, last)
        found = places.near(inner, natural_spline(way[knots - first], place(q[knots]), way)[1:-1], route.q[inner])
        if np.isfinite(found).all():
            q[inner] = found
    return replace(route, q=q)


def _carrying(marks: IndexArray) -> BoolArray:
    """Which of the marks have points beside them that are carried along."""
    far = np.diff(marks) > 1
    return np.r_[False, far] | np.r_[far, False]


def _with_carried_points(problem: Problem, route: Route, places: _Places) -> tuple[IndexArray, Route]:
    """The waypoints between which the rail is in proportion to the tool's way, and a route in which it is: those that
    lie between short lines are carried along, but for one every carry_length of the way."""
    settings = problem.plant.settings
    tied = {k for group in problem.ties for k in group}
    marks, way = [0], 0.0
    for k in range(1, len(problem.waypoints) - 1):
        point, (before, after) = problem.waypoints[k], problem.legs[k - 1 : k + 1]
        way += before.chord
        free = point.q is None and point.rail[0] < point.rail[1] and k not in tied
        alike = before.rail_moves == after.rail_moves and route.labels[k - 1].cfx == route.labels[k + 1].cfx
        if not (free and alike and short(problem, k - 1) and short(problem, k)) or way >= settings.carry_length:
            marks.append(k)
            way = 0.0
    marks.append(len(problem.waypoints) - 1)
    q = route.q.copy()
    left = list(pairwise(marks))
    while left:  # where the arm cannot follow a straight rail, the route's own places
        spans, left = [(a, b, route.q[a][None], route.q[b][None]) for a, b in left], []
        for (a, b, *_), (inner,) in zip(spans, places.between(route, spans), strict=True):
            if np.isfinite(inner).all():
                q[a : b + 1] = inner
            else:
                middle = (a + b) // 2
                marks.append(middle)
                left += [(a, middle), (middle, b)]
    return np.array(sorted(marks)), replace(route, q=q)


@dataclass(frozen=True, eq=False)
class _Places:
    """What the waypoints (M,) of a route are reached by: poses X_WF (M, 4, 4) as the sought rail sees them, rails (M,
    2) from and to where that may stand, held (M, r - 1) where the others do, branches cfx (M,). chords (M - 1,):
    lengths of the legs between them."""

    axes: Axes
    X_WF: Array
    held: Array
    rails: Array
    cfx: IndexArray
    chords: Array

    @classmethod
    def of(cls, axes: Axes, problem: Problem, route: Route) -> _Places:
        """Those of a problem's route, and of every other one on its branches."""
        points, legs = problem.waypoints, range(len(problem.legs))
        cfx = np.array([_branch(route, k) for k in legs] + [route.labels[-1].cfx])
        chords = np.array([leg.chord for leg in problem.legs])
        X_WF, held = np.array([problem.seen(k) for k in range(len(points))]), np.array([one.held for one in points])
        return cls(axes, X_WF, held, np.array([one.rail for one in points]), cfx, chords)

    def near(self, k: IndexArray, d: Array, q: Array) -> Array:
        """Axes (p, n) at waypoints k (p,) with the rail at d (p,), in the turns of axes q (p, n); NaN where they are
        not to be had."""
        layout, out = self.axes.layout, np.empty((len(k), self.axes.n))
        for some in (slice(i, i + self.axes.settings.batch) for i in range(0, len(k), self.axes.settings.batch)):
            checkpoint()
            at, place = k[some], d[some]
            arm = self.axes.branch(self.X_WF[at], place, self.cfx[at])
            arm += 2 * np.pi * np.round((q[some, layout.arm] - arm) / (2 * np.pi))
            found = layout.join(place, arm)
            found[:, layout.others] = self.held[at]
            inside = self.axes.within(found) & (place >= self.rails[at, 0]) & (place <= self.rails[at, 1])
            out[some] = np.where(inside[:, None], found, np.nan)
        return out

    def between(self, route: Route, spans: Sequence[_Span]) -> list[Array]:
        """Axes (m, b - a + 1, n) at the waypoints a to b of each span, near those of a route, with the rail in
        proportion to the tool's way; NaN where the arm does not reach."""
        place, k, d = self.axes.layout.place, [np.zeros(0, dtype=np.intp)], [np.zeros(0)]
        for a, b, q_0, q_1 in spans:
            way, d_0 = np.cumsum(self.chords[a:b]), place(q_0)[:, None]
            d.append((d_0 + (way[:-1] / way[-1]) * (place(q_1)[:, None] - d_0) if b > a + 1 else d_0[:, :0]).ravel())
            k.append(np.tile(np.arange(a + 1, b), len(q_0)))
        at = np.concatenate(k)
        inner = np.split(self.near(at, np.concatenate(d), route.q[at]), np.cumsum([len(one) for one in k[1:]]))
        return [
            np.concatenate([q_0[:, None], one.reshape(len(q_0), b - a - 1, self.axes.n), q_1[:, None]], axis=1)
            for (a, b, q_0, q_1), one in zip(spans, inner[:-1], strict=True)
        ]


def _route_through(route: Route, places: _Places, marks: IndexArray, q: Array, times: Array) -> Route:
    """The route through axes (m, n) at the marks, with the times (m - 1,) between them."""
    every, spent = route.q.copy(), route.times.copy()
    stays = np.abs(q - route.q[marks]).max(axis=1) < _SAME
    ends = [*pairwise(marks.tolist())]
    moved = [(a, b, q[i : i + 1], q[i + 1 : i + 2]) for i, (a, b) in enumerate(ends) if not stays[i : i + 2].all()]
    for (a, b, *_), (found,) in zip(moved, places.between(route, moved), strict=True):
        every[a : b + 1] = found
    for (a, b), T in zip(ends, times, strict=True):
        spent[a:b] = T if b == a + 1 else T * places.chords[a:b] / places.chords[a:b].sum()
    return replace(route, q=every, times=spent, cost=float(times.sum()))


def refine_corner_rail(axes: Axes, problem: Problem, route: Route) -> Route:
    """The route with the rail shifted at points of runs with corners, where a leg alone does not say how fast they are
    passed: a pattern search over neighbouring points that move together, in steps that shrink until nothing is gained.
    Points that are carried along are not shifted, nor any of a run that has more of these."""
    if not axes.layout.has_rail or problem.freedom.rail is RailFreedom.STATION:
        return route
    return by_rails(axes, problem, route, _refine_corner_rail)


def _refine_corner_rail(axes: Axes, problem: Problem, route: Route) -> Route:
    """The same of the sought rail."""
    left, groups = axes.settings.polished_legs, _shifted_together(problem)
    costs = [2 * _TOGETHER * sum(last - first for first, last in _runs_at(problem, [group])) for group in groups]
    while costs and costs[0] <= left:
        size = max(1, int(np.searchsorted(np.cumsum(costs), left / 2)))
        shifts = _RailShifts(axes, problem, route, groups[:size], left)
        route, left, groups, costs = shifts.refined(), shifts.left, groups[size:], costs[size:]
    return route


def _runs_at(problem: Problem, groups: Sequence[range]) -> list[tuple[int, int]]:
    """The runs that begin, end or pass at points of groups."""
    return [(a, b) for a, b in problem.runs if any(a <= group[-1] and group[0] <= b for group in groups)]


def _shifted_together(problem: Problem) -> list[range]:
    """Points of runs with corners in groups, in order, that must have one rail position."""
    small = [short(problem, k) for k in range(len(problem.legs))]
    carried = {k + 1 for k, both in enumerate(pairwise(small)) if all(both)}
    out = carried.union(*problem.ties)
    free = {k for k, one in enumerate(problem.waypoints) if one.q is None and one.rail[0] < one.rail[1]} - out
    begins = [0, *(k + 1 for k, leg in enumerate(problem.legs) if leg.rail_moves), len(problem.waypoints)]
    groups = [range(*ends) for ends in pairwise(begins) if free.issuperset(range(*ends))]
    runs = [range(first, last + 1) for first, last in problem.runs if last > first + 1]
    open_ = {k for group in groups for k in group}
    shifted = {k for run in runs if len(open_.intersection(run)) > len(carried.intersection(run)) for k in run}
    return [group for group in groups if not shifted.isdisjoint(group)]


class _RailShifts:
    """A pattern search for the rail's positions at groups of points. left: legs that are timed at most, about."""

    def __init__(self, axes: Axes, problem: Problem, route: Route, groups: Sequence[range], left: int):
        self._axes, self._problem, self._route, self._groups, self.left = axes, problem, route, groups, left
        self._runs, self._places = _runs_at(problem, groups), _Places.of(axes, problem, route)
        self._d = np.array([float(axes.layout.place(route.q[group[0]])) for group in groups])
        self._known: dict[tuple[tuple[int, int], bytes], float] = {}

    def refined(self) -> Route:
        """The route with the positions at which the runs take least time together."""
        settings, d, before = self._axes.settings, self._d, 0 * self._d
        i, j, at = np.ogrid[: len(d), 1 : _TOGETHER + 1, : len(d)]
        directions = np.unique(((i <= at) & (at < i + j)).reshape(-1, len(d)).astype(float), axis=0)
        (known,), step = self._times(d[None]), settings.polish_step
        while step >= settings.polish_last and self.left > 0:
            ways = step * np.concatenate([directions, -directions])
            times = self._times(d + ways)
            order = [n for n in np.argsort(times, kind="stable") if times[n] < known - _LEAST_POLISH]
            if not order:
                step, before = step / 3, 0 * d
                continue
            together = 0 * d  # all shifts that gain, of groups of their own
            for way in ways[order]:
                together += way * (not np.any(together[way != 0]))
            moves = [ways[order[0]], *(together + k * before for k in (0.0, 0.5, 1.0))]
            times = self._times(d + moves)
            known, before = min(times), moves[np.argmin(times)]
            d = d + before
        return replace(self._route, q=self._axes_at(d[None])[0])

    def _times(self, d: Array) -> Array:
        """How long the runs take together (m,) with the rail at d (m, groups); infinite where that cannot be."""
        every = self._axes_at(d)
        names = [[(run, q[run[0] : run[1] + 1].tobytes()) for run in self._runs] for q in every]
        can: BoolArray = np.asarray(np.isfinite(every).all(axis=(1, 2)))
        asked = {name: q for i, q in enumerate(every) if can[i] for name in names[i] if name not in self._known}
        runs, cfx = [run for run, _ in asked], tuple(label.cfx for label in self._route.labels)
        times = about(self._axes, self._problem, runs, [*asked.values()], cfx) if runs else ()
        self._known |= zip(asked, map(float, times), strict=True)
        self.left -= sum(last - first for first, last in runs)
        return np.array([sum(map(self._known.__getitem__, own)) if can[i] else np.inf for i, own in enumerate(names)])

    def _axes_at(self, d: Array) -> Array:
        """Axes (m, M, n) at all waypoints with the rail at d (m, groups), on their branches, else NaN."""
        q = np.tile(self._route.q, (len(d), 1, 1))
        group = np.repeat(np.arange(len(self._groups)), [len(one) for one in self._groups])
        number = np.concatenate([np.asarray(one) for one in self._groups])
        row, at = np.nonzero(d[:, group] != self._d[group])
        places, of = np.unique([number[at], d[row, group[at]]], axis=1, return_inverse=True)
        k = places[0].astype(np.intp)
        q[row, number[at]] = self._places.near(k, places[1], self._route.q[k])[of.ravel()]
        asked = [k for k in range(self._runs[0][0], self._runs[-1][1]) if self._problem.waypoints[k + 1].nearest]
        for one in q if asked else ():
            led = [self._problem.leads(k, one[k : k + 1], one[k + 1 : k + 2]) for k in asked if np.isfinite(one).all()]
            one[:] = one if all(x is None or x.all() for x in led) else np.nan
        return q


def _branch(route: Route, k: int) -> int:
    return route.labels[k].cfx if route.labels[k].cfx >= 0 else route.labels[k + 1].cfx


def _candidates(
    axes: Axes, problem: Problem, route: Route, at: IndexArray, step: Array, around: CollisionScene | None
) -> list[Array]:
    """Axes (m, n) to try at each of some waypoints, those of the route among them; step [m] at every waypoint."""
    points = [problem.waypoints[k] for k in at]
    free = [i for i, point in enumerate(points) if point.q is None and point.rail[0] < point.rail[1]]
    out = [route.q[k][None] for k in at]
    if not free:
        return out
    k, low, high = at[free], *np.array([points[i].rail for i in free]).T
    d = axes.layout.place(route.q[k])[:, None] + step[k][:, None] * np.array(_REFINE_OFFSETS)
    d = np.sort(np.clip(d, low[:, None], high[:, None]), axis=1)
    tries = d.shape[1]
    X_WF = np.repeat([problem.seen(i) for i in k], tries, axis=0)
    cfx = np.repeat([route.labels[i].cfx for i in k], tries)
    arm = axes.branch(X_WF, d.ravel(), cfx)
    turned = arm + 2 * np.pi * np.round((np.repeat(route.q[k][:, axes.layout.arm], tries, axis=0) - arm) / (2 * np.pi))
    q = axes.layout.join(d.ravel(), turned)
    q[:, axes.layout.others] = np.repeat([points[i].held for i in free], tries, axis=0)
    ok = axes.within(q).reshape(d.shape)
    ok[:, 1:] &= np.diff(d, axis=1) > 0
    if around is not None:
        for side in (-1, 0):  # with what is carried before a waypoint and behind it
            motions = [problem.legs[min(max(i + side, 0), len(problem.legs) - 1)].motion for i in k]
            ok &= around.free(q, np.repeat(motions, tries)).reshape(d.shape)
    for i, every, these in zip(free, q.reshape(*d.shape, -1), ok, strict=True):
        if these.any():
            out[i] = every[these]
    return out


def _edge_times(
    axes: Axes, problem: Problem, marks: IndexArray, near: Sequence[Array], route: Route, places: _Places,
    before: Sequence[Array], edges: Sequence[Array], step: Array, known: Times, around: CollisionScene | None,
) -> list[Array]:  # fmt: skip
    """(m_a, m_b) least time from each mark to the next between the axes near them, infinite where it cannot be. A
    fly-by is passed as fast as may be: its corner is not looked at. edges: the same between the axes that were near
    before. known: as in leg_times."""
    asked, timed, opens, out = [], [], [], list[Array]()
    same = [  # which rows of the axes now are rows of those before, and which
        None if a is b else np.nonzero(np.abs(a[:, None] - b[None]).max(axis=2) < _SAME)
        for a, b in zip(near, before, strict=bool(before))
    ]
    for i, (first, last) in enumerate(pairwise(marks.tolist())):
        a, b = near[i], near[i + 1]
        if before and a is before[i] and b is before[i + 1]:
            out.append(edges[i])
            continue
        edge = np.full((len(a), len(b)), np.nan)
        if before:
            (at, at_before), (to, to_before) = (
                (np.arange(len(x)), np.arange(len(x))) if rows is None else rows
                for x, rows in zip((a, b), same[i : i + 2], strict=True)
            )
            found = edges[i][np.ix_(at_before, to_before)]
            edge[np.ix_(at, to)] = np.where(np.isfinite(found), found, np.nan)
        ia, ib = np.nonzero(np.isnan(edge))
        worth = _pairs_to_time(axes, problem, first, last, a[ia], b[ib], route, max(step[first], step[last]))
        edge[ia, ib] = np.inf
        ia, ib = ia[worth], ib[worth]
        if around is not None and problem.legs[first].kind is LegKind.JOINT:
            clear = around.free_between(a[ia], b[ib], problem.legs[first].motion)
            ia, ib = ia[clear], ib[clear]
        if (led := problem.leads(first, a, b)) is not None:
            ia, ib = ia[led[ia, ib]], ib[led[ia, ib]]
        asked.append((edge, ia, ib, (first, last, a[ia], b[ib])))
        out.append(edge)
    between = places.between(route, [span for *_, span in asked])
    for (edge, ia, ib, (first, last, q_0, q_1)), q in zip(asked, between, strict=True):
        can = np.isfinite(q).all(axis=(1, 2))
        q, ia, ib = q[can], ia[can], ib[can]
        looked_at = _legs_to_time(problem, first, last)
        opens.append((edge, ia, ib, [*looked_at.values()]))
        timed += [Pairs(k, q[:, k - first], q[:, k - first + 1], _branch(route, first)) for k in looked_at]
        way = axes.layout.place(q_1[can] - q_0[can]) if last > first + 1 else 0.0
        edge[ia, ib] = _CALM * way**2 / max(places.chords[first:last].sum(), 1e-9)  # of equal times the calmest
    times = iter(leg_times(axes, problem, timed, known))
    for edge, ia, ib, shares in opens:
        edge[ia, ib] += sum(share * next(times) for share in shares)
    return out


def _legs_to_time(problem: Problem, first: int, last: int) -> dict[int, float]:
    """The legs between two marks that are timed, and how many times as long the ones around each take as itself."""
    groups = np.array_split(np.arange(first, last), min(last - first, _CARRY_LOOKS))
    legs = {int(group[len(group) // 2]): group for group in groups}
    chords = {k: [problem.legs[i].chord for i in group] for k, group in legs.items()}
    return {
        k: sum(ways) / problem.legs[k].chord if problem.legs[k].chord > _SAME else float(len(ways))
        for k, ways in chords.items()
    }


def _pairs_to_time(
    axes: Axes, problem: Problem, first: int, last: int, q_0: Array, q_1: Array, route: Route, step: float
) -> BoolArray:
    """Which pairs (m,) of axes at two marks are timed: the rail stays where it must, else both are shifted alike but
    for a step or two [m]; where the tool passes both the rail goes at most as far as it can in a few times what the way
    takes, or as it goes now."""
    leg, place = problem.legs[first], axes.layout.place
    way = np.abs(place(q_1) - place(q_0))
    if not leg.rail_moves or (problem.freedom.rail is RailFreedom.STATION and leg.kind is not LegKind.JOINT):
        return np.asarray(way <= _SAME)
    now = float(place(route.q[last]) - place(route.q[first]))
    near = np.abs(place(q_1) - place(q_0) - now) <= _REFINE_APART * step + _SAME
    if not short(problem, first):
        return np.asarray(near)
    farthest = _RUSH * float(place(axes.velocity_on(leg)) * route.times[first:last].sum())
    return np.asarray(way <= max(abs(now), farthest) + _SAME)
