"""A lower bound on the cycle time: shortest path through cells that together contain every legal motion.

A cell at a stop is a range of rail position, a range of rail velocity and a pair of shoulder and elbow signs; it
encloses the first three arm joints and their velocities. Between cells of one stop and the next no motion is faster
than the least time in which rail and these joints can cover the gap within their limits (ends free inside the cells),
nor than the tool on its way (tool_time) and through corners (corner_time). Points that are passed have no cells, so any
configuration may pass them; but where on a rail a line ends beside a joint move, every motion goes through one pose at
any velocity, and that has cells. Lines and arcs keep the signs, as a problem's stations do.
With several rails there are no cells: each run has the bound of the tool, its corners and the places that are given.
Everything else (wrist, ranges on the way, the tool's caps on joint moves beyond the chord) is left out, so the bound
holds for every legal motion of the target; it is not called certified because its arithmetic is not outward rounded.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from trajopt_cli.bound.corner_time import corner_time
from trajopt_cli.bound.tcp_time_bound import Gate, TcpPart, parts_time, ramps_of, tool_parts, tool_time
from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.native.loops import loops
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import Stopped, checkpoint
from trajopt_cli.robot.enclosure import Enclosure, Range
from trajopt_cli.timing.double_integrator import trapezoid_time
from trajopt_cli.trajectories.axes import Axes

_BOUND_SPEEDS = 4  # velocity ranges from -V to V at the first level, doubled per level.
_MOST_PAIRS = 1_500_000  # of cells per leg; a finer level is not begun beyond. Not measured.
_FEW_PAIRS = 300_000  # of them; below, the next level aims at the incumbent itself. Not measured.
_BOUND_ORDER = (0, 2, 1)  # of the first three joints, after the rail: settles most pairs soonest.


@dataclass(frozen=True, eq=False)
class _Cells:
    """Cells at one waypoint: position and velocity (r+3, m) of rail, q1, q2, q3; key (m, 3): signs, rail, velocity."""

    q: Range
    v: Range
    key: IndexArray


@dataclass(frozen=True, eq=False)
class _Place:
    """Where every motion comes by: waypoint k, a stop, or the gate beside it. rail: where the rail may be [m]."""

    k: int
    gate: Gate | None
    rail: tuple[float, float]


@dataclass(frozen=True, eq=False)
class _Run:
    """What is asked on the way between two places. V, A (r+3,): greatest limits in force. floor [s]: no motion is
    faster.

    fixed: it takes exactly that. still: all axes rest at both ends, as far as the target asks for it; straight: and
    share one progress along a straight way. branch: the signs of shoulder and elbow stay.
    """

    V: Array
    A: Array
    floor: float
    fixed: bool
    still: bool
    straight: bool
    branch: bool


@dataclass(frozen=True, eq=False)
class _RelaxedRoute:
    """All places in order, what is asked between each and the next (one less), and between the stops of runs that have
    gates (numbers of two places)."""

    places: list[_Place]
    hops: list[_Run]
    direct: dict[tuple[int, int], _Run]


def lower_bound(axes: Axes, problem: Problem, incumbent: float, cut: Callable[[], None] = lambda: None) -> float:
    """No legal motion of this problem and target is faster [s].

    incumbent: a legal cycle time. Cells through which no route is faster than the value aimed at are dropped; when none
    are left, that value is the bound, whatever the incumbent's quality. cut: called where the time for it was over
    before; the bound is what was proved by then.
    """
    least = [tool_time(problem, *ends) for ends in problem.runs]
    if axes.layout.r > 1:  # cells of several rails would be too many: each run by itself
        runs = zip(problem.runs, least, strict=True)
        return min(sum(_run_alone(axes, problem, *ends, floor) for ends, floor in runs), incumbent)
    proved = [min(sum(least), incumbent)]
    try:
        return _refined(axes, problem, incumbent, _route(axes, problem, least), proved)
    except Stopped:
        cut()
        return max(proved)


def _run_alone(axes: Axes, problem: Problem, first: int, last: int, floor: float) -> float:
    """The least time from stop to stop [s]: of the tool, and of every axis whose place is given at both."""
    run, ends = _run(axes, problem, first, last, floor), (first, last)
    if run.fixed:
        return floor
    rest = all(problem.rests(k) for k in ends)
    given = [problem.waypoints[k].q for k in ends]
    if given[0] is not None and given[1] is not None:
        way, columns = np.abs(given[1] - given[0])[_columns(axes)], slice(None)
    else:
        (low, high), (other_low, other_high) = (problem.waypoints[k].ranges(problem.layout) for k in ends)
        way, columns = np.maximum(np.maximum(other_low - high, low - other_high), 0.0), slice(axes.layout.r)
    V, A = run.V[columns], run.A[columns]
    times = trapezoid_time(way, V, A) if rest else way / V
    return float(max(floor, corner_time(axes, problem, first, last), np.max(times)))


def _refined(axes: Axes, problem: Problem, incumbent: float, route: _RelaxedRoute, proved: list[float]) -> float:
    """The bound of all cells; what is proved on the way to it is added."""
    settings = axes.settings
    refinement = _Refinement(axes, problem, [_grid(axes, problem, place) for place in route.places], {}, proved)
    zeros = [np.zeros(0)] * len(route.places)
    if len(route.hops) <= settings.bound_legs:
        return refinement.of(route, 0, None, zeros, incumbent, settings.bound_aim * incumbent)[0]
    # long programs in windows: what is ahead of each window is known from the first level
    cells, ahead = refinement.ahead(route)
    least = [float(np.min(x, initial=np.inf)) for x in ahead]
    if not np.isfinite(least[0]):
        return incumbent
    proved.append(min(least[0], incumbent))
    begin, spent, best = 0, ahead[0] * 0.0, least[0]
    while begin < len(route.hops):
        end = _cut(route, begin, settings.bound_window)
        share = (least[begin] - least[end]) / least[0]
        aims = (best + max(share * (aim - least[0]), 0.0) for aim in (incumbent, settings.bound_aim * incumbent))
        keys = cells[begin].key, cells[end].key
        _, reached = refinement.of(_part(route, begin, end), begin, (keys, spent), ahead[begin : end + 1], *aims)
        assert reached is not None
        begin, spent = end, reached
        best = max(best, float(np.min(spent + ahead[end])))
        proved.append(min(best, incumbent))
    return min(best, incumbent)


def _cut(route: _RelaxedRoute, begin: int, window: int) -> int:
    """Where a window of the route ends: at a stop, at least so many legs on."""
    for end in range(begin + window, len(route.hops)):
        if route.places[end].gate is None and not any(i < end < j for i, j in route.direct):
            return end
    return len(route.hops)


def _part(route: _RelaxedRoute, begin: int, end: int) -> _RelaxedRoute:
    direct = {(i - begin, j - begin): run for (i, j), run in route.direct.items() if begin <= i and j <= end}
    return _RelaxedRoute(route.places[begin : end + 1], route.hops[begin:end], direct)


@dataclass(frozen=True, eq=False)
class _Refinement:
    """Cells that are halved level by level. grids: of all places; cache: enclosures by pose; proved: bounds on the
    whole program, each valid."""

    axes: Axes
    problem: Problem
    grids: list[Array]
    cache: dict[bytes, Enclosure]
    proved: list[float]

    def _cells(self, route: _RelaxedRoute, first: int, level: int, keep: Sequence[IndexArray | None]) -> list[_Cells]:
        return [
            _cells(self.axes, self.problem, place, self.grids[first + i], level, keep[i], self.cache)
            for i, place in enumerate(route.places)
        ]

    def ahead(self, route: _RelaxedRoute) -> tuple[list[_Cells], list[Array]]:
        """The cells of the first level, and the least time from each to the end."""
        cells = self._cells(route, 0, 0, [None] * len(route.places))
        ahead, ends = [np.zeros(len(cells[-1].key))], {i: j for i, j in route.direct}
        for k in reversed(range(len(route.hops))):
            ahead.append(_least(self.axes, self.problem, route.hops[k], cells[k], cells[k + 1], ahead[-1]))
            if (j := ends.get(k)) is not None:
                beyond, run = ahead[len(route.hops) - j], route.direct[k, j]
                straight = _least(self.axes, self.problem, run, cells[k], cells[j], beyond)
                ahead[-1] = np.maximum(ahead[-1], straight)
        return cells, ahead[::-1]

    def of(
        self, route: _RelaxedRoute, first: int, ends: tuple[tuple[IndexArray, IndexArray], Array] | None,
        known: Sequence[Array], aim: float, lower_aim: float,
    ) -> tuple[float, Array | None]:  # fmt: skip
        """A bound, at most the aim, on the time of all motions through some places, the first of which has a number.

        ends: keys of the first level at the first place and the last, and the time spent before each of the first.
        known: of the first level, the least time from there to the end. Also the least time spent at each cell of the
        first level at the last place. Without ends nothing is spent, and nothing comes behind.
        """
        axes, problem, settings = self.axes, self.problem, self.axes.settings
        keep: list[IndexArray | None] = [None] * len(route.places)
        ahead: list[Array | None] = [None] * len(route.places)
        dead = np.isinf(known[-1]) if ends is not None else np.zeros(0, dtype=bool)

        def left(aim: float) -> Array:
            """What is spent at least at each last cell by motions that are not looked at."""
            return np.where(dead, np.inf, aim - np.where(dead, 0.0, known[-1]))

        reached = None if ends is None else left(aim)
        start = aim if ends is None else float(np.min(ends[1] + known[0]))
        best = 0.0 if ends is None else start
        for level in range(settings.bound_levels if axes.layout.has_rail else 1):  # only rails have anything to halve
            cells = self._cells(route, first, level, keep)
            if any(not len(c.key) for c in cells):
                return aim, reached
            pairs = max(len(a.key) * len(b.key) for a, b in pairwise(cells))
            if level and pairs > _MOST_PAIRS:
                break
            parents = [
                (np.zeros(len(c.key)) if ends is None else at_first)
                if found is None or keys is None
                else _coarse_values(c, 1, keys, found)
                for c, keys, found, at_first in zip(cells, keep, ahead, known, strict=True)
            ]
            if ends is None:
                spent, beyond = np.zeros(len(cells[0].key)), np.zeros(len(cells[-1].key))
            else:
                spent = _coarse_values(cells[0], level, ends[0][0], ends[1])
                beyond = _coarse_values(cells[-1], level, ends[0][1], known[-1])
            forward, backward = _costs(axes, problem, route, cells, parents, aim, spent, beyond)
            best = max(best, min(float(np.min(forward[-1] + beyond)), aim))
            if ends is None:
                self.proved.append(best)
            else:
                reached = _at_first_level(cells[-1], level, ends[0][1], forward[-1], left(aim))
            for k, c in enumerate(cells):
                live = forward[k] + backward[k] <= aim
                keep[k], ahead[k] = c.key[live], backward[k][live]
            if any(not len(x) for x in keep if x is not None):
                return aim, None if ends is None else left(aim)
            next_pairs = (2 if problem.coordinated else 4) ** 2 * max(
                a * b for a, b in pairwise([len(x) for x in keep if x is not None])
            )
            if ends is not None and next_pairs > settings.bound_pairs:
                break
            if best < lower_aim < aim and next_pairs > _FEW_PAIRS:
                aim = lower_aim
        return best, reached


def _coarse_values(cells: _Cells, level: int, keys: IndexArray, values: Array) -> Array:
    """Of each cell the value of the one that it is in, so many levels above."""
    table = {tuple(key): value for key, value in zip(keys.tolist(), values.tolist(), strict=True)}
    return np.array([table[s, d >> level, v >> level] for s, d, v in cells.key.tolist()])


def _at_first_level(cells: _Cells, level: int, keys: IndexArray, values: Array, most: Array) -> Array:
    """Of each cell of the first level the least value of those in it, which are for all motions that spend no more."""
    place = {tuple(key): i for i, key in enumerate(keys.tolist())}
    out = most.copy()
    at = [place[s, d >> level, v >> level] for s, d, v in cells.key.tolist()]
    np.minimum.at(out, at, values)
    return out


def _least(axes: Axes, problem: Problem, run: _Run, a: _Cells, b: _Cells, ahead: Array) -> Array:
    """The least time (n_a,) through any cell b, ahead (n_b,) being what comes behind it."""
    T = _edge(axes, run, a, b, np.zeros(len(a.key)), ahead, None)
    return _least_sums("fill_left", T, ahead, len(T))


def _costs(
    axes: Axes, problem: Problem, route: _RelaxedRoute, cells: list[_Cells], parents: list[Array], aim: float,
    spent: Array, beyond: Array,
) -> tuple[list[Array], list[Array]]:  # fmt: skip
    """Least time to every cell of every place, spent at those of the first, and from there on, beyond the last."""
    starts = {j: i for i, j in route.direct}
    forward = [spent]
    edges, direct = [], {}
    for k, run in enumerate(route.hops):
        T = _edge(axes, run, cells[k], cells[k + 1], forward[-1], parents[k + 1], aim)
        edges.append(T)
        forward.append(_least_sums("fill_reached", T, forward[-1], len(T.T)))
        if (i := starts.get(k + 1)) is not None:
            run = route.direct[i, k + 1]
            T = _edge(axes, run, cells[i], cells[k + 1], forward[i], parents[k + 1], aim)
            direct[i] = k + 1, T
            forward[-1] = np.maximum(forward[-1], _least_sums("fill_reached", T, forward[i], len(T.T)))
    backward = [beyond]
    for k in reversed(range(len(edges))):
        backward.append(_least_sums("fill_left", edges[k], backward[-1], len(edges[k])))
        if k in direct:
            j, T = direct[k]
            beyond = _least_sums("fill_left", T, backward[len(edges) - j], len(T))
            backward[-1] = np.maximum(backward[-1], beyond)
    return forward, backward[::-1]


def _least_sums(name: str, T: Array, other: Array, n: int) -> Array:
    """Of times (n_a, n_b) and what is spent before each row, or comes behind each column: see bound_loops."""
    out = np.empty(n)
    loops("trajopt_cli.bound.bound_loops")[name](T, other, out)
    return out


def _route(axes: Axes, problem: Problem, least: Sequence[float]) -> _RelaxedRoute:
    """The problem as places and what is asked between them. least: of each run, what the tool takes [s]."""
    places, hops, direct = [_Place(0, None, problem.waypoints[0].rail)], [], {}
    for (first, last), floor in zip(problem.runs, least, strict=True):
        begin, parts = len(places) - 1, list[TcpPart]()
        for part in tool_parts(problem, first, last) if axes.layout.has_rail else ():  # else corner_time knows all
            if isinstance(part, TcpPart):
                parts.append(part)
                continue
            if all(leg.kind is not LegKind.JOINT for leg in problem.legs[part.k - 1 : part.k + 1]):
                continue
            places.append(_Place(part.k, part, _rail_at(axes, problem, part.k)))
            hops.append(_between(axes, problem, parts, *places[-2:]))
            parts = []
        places.append(_Place(last, None, problem.waypoints[last].rail))
        run = _run(axes, problem, first, last, max(floor, corner_time(axes, problem, first, last)))
        if len(places) - 2 == begin:
            hops.append(run)
        else:
            hops.append(_between(axes, problem, parts, *places[-2:]))
            direct[begin, len(places) - 1] = run
    return _RelaxedRoute(places, hops, direct)


def _run(axes: Axes, problem: Problem, first: int, last: int, floor: float) -> _Run:
    """From stop to stop."""
    legs = problem.legs[first:last]
    run = _asked(axes, problem, legs, floor)
    straight = problem.coordinated and len(legs) == 1 and legs[0].kind is LegKind.JOINT
    fixed = legs[0].kind is LegKind.DWELL and legs[0].duration is not None
    given = any(problem.waypoints[k].q is not None for k in (first, last))  # cells of given joints have no signs
    return replace(run, fixed=fixed, still=problem.coordinated, straight=straight, branch=run.branch and not given)


def _between(axes: Axes, problem: Problem, parts: list[TcpPart], a: _Place, b: _Place) -> _Run:
    """Between a gate and the next one or a stop."""
    first, last = a.gate.leg if a.gate else a.k, b.gate.leg if b.gate else b.k - 1
    legs = problem.legs[first : last + 1]
    stops = (a.gate is None) + (b.gate is None)
    run = _asked(axes, problem, legs, parts_time(parts, *ramps_of(legs), stops))
    given = any(place.gate is None and problem.waypoints[place.k].q is not None for place in (a, b))
    return replace(run, branch=run.branch and not given)


def _asked(axes: Axes, problem: Problem, legs: Sequence[Leg], floor: float) -> _Run:
    """Of legs, whatever the axes do at their ends. A programmed time replaces the rail's programmed speed."""
    columns = _columns(axes)
    V = [axes.velocity_on(leg) if leg.duration is None else axes.velocity for leg in legs]
    A = [problem.plant.limits.most_acceleration * leg.acceleration for leg in legs]
    lines = all(leg.kind is not LegKind.JOINT for leg in legs)
    return _Run(np.max(V, axis=0)[columns], np.max(A, axis=0)[columns], floor, False, False, False, lines)


def _rail_at(axes: Axes, problem: Problem, k: int) -> tuple[float, float]:
    """Where the rail may be near waypoint k [m]: coordinated, between the waypoints beside it; free, anywhere."""
    if not problem.coordinated:
        return float(axes.layout.place(axes.lower)), float(axes.layout.place(axes.upper))
    near = [point.rail for point in problem.waypoints[k - 1 : k + 2]]
    return min(low for low, _ in near), max(high for _, high in near)


def _grid(axes: Axes, problem: Problem, place: _Place) -> Array:
    """Ends of the rail intervals at a place: those within the arm's reach, whole cells of the first level."""
    settings = axes.settings
    low, high = place.rail
    if low == high or (place.gate is None and problem.waypoints[place.k].q is not None):
        return np.array([low, high])
    n = max(1, int(np.ceil((high - low) / settings.bound_rail)))
    n = -(-n // settings.bound_coarse) * settings.bound_coarse
    d = np.linspace(low, high, n + 1)
    X_WF = problem.waypoints[place.k].X_WF if place.gate is None else place.gate.X_WF
    near = np.clip(axes.robot.rail_within(X_WF[None])[0], low, high)
    first, last = (int(np.searchsorted(d, at)) for at in near)
    first = max(first - 1, 0) // settings.bound_coarse * settings.bound_coarse
    last = min(-(-(last + 1) // settings.bound_coarse) * settings.bound_coarse, n)
    return d[first : max(last, first + settings.bound_coarse) + 1]


def _children(keys: IndexArray) -> IndexArray:
    """The four halves of each kept cell."""
    s, d, v = keys.T
    return np.concatenate([np.stack([s, 2 * d + i, 2 * v + j], axis=1) for i in (0, 1) for j in (0, 1)])


def _cells(
    axes: Axes, problem: Problem, place: _Place, grid: Array, level: int, kept: IndexArray | None,
    cache: dict[bytes, Enclosure],
) -> _Cells:  # fmt: skip
    stop, gate = problem.waypoints[place.k], place.gate
    if gate is None and stop.q is not None:
        q = stop.q[_columns(axes), None]
        zero = np.zeros_like(q)
        return _Cells(Range(q, q), Range(zero, zero), np.zeros((1, 3), dtype=int))
    X_WF = stop.X_WF if gate is None else gate.X_WF
    twist = None if gate is None else gate.twist
    name = X_WF.tobytes() + grid.tobytes() + (b"" if twist is None else twist.tobytes())
    if name not in cache:
        checkpoint()
        cache[name] = axes.robot.enclose(X_WF, grid, problem.plant.limits, twist)
    e = cache[name]
    single = len(grid) == 2
    width = 1 if single else max(1, axes.settings.bound_coarse >> level)
    n_d = (len(grid) - 1) // width
    top = float(axes.layout.place(axes.velocity))
    rest = top == 0.0 or (gate is None and problem.rests(place.k))
    n_v = _BOUND_SPEEDS << level
    if kept is None:
        key = np.array([(s, d, v) for s in range(4) for d in range(n_d) for v in ((0,) if rest else range(n_v))])
    else:
        key = _children(kept)
        key = key[(key[:, 1] < n_d) & ((key[:, 2] == 0) if rest else True)]
    s, d, v = key.T
    V = axes.velocity[axes.layout.arm]
    edges = np.linspace(-top, top, n_v + 1)
    rail_v = Range(np.zeros(len(key)), np.zeros(len(key))) if rest else Range(edges[v], edges[v + 1])
    inside = d[:, None] * width + np.arange(width)  # (n, width) base intervals
    joints = Range(e.q.lo[:, s[:, None], inside], e.q.hi[:, s[:, None], inside])
    rate = Range(e.rate.lo[:, s[:, None], inside], e.rate.hi[:, s[:, None], inside])
    speed = rate * Range(
        np.broadcast_to(rail_v.lo[:, None], inside.shape), np.broadcast_to(rail_v.hi[:, None], inside.shape)
    )
    if e.way is not None:  # at any speed from rest to the greatest
        way = Range(e.way.lo[:, s[:, None], inside], e.way.hi[:, s[:, None], inside])
        speed = speed + Range(np.minimum(way.lo, 0.0), np.maximum(way.hi, 0.0))
    limit = V[:3, None, None]
    alive = e.alive[s[:, None], inside] & np.all((speed.lo <= limit) & (speed.hi >= -limit), axis=0)
    clipped = Range(np.maximum(speed.lo, -limit), np.minimum(speed.hi, limit))
    live = alive.any(axis=1)
    stood = _over_alive(Range(grid[inside], grid[inside + 1]), alive)
    hull, speeds = _over_alive(joints, alive), _over_alive(clipped, alive)

    def joined(rail: Range, arm: Range) -> Range:
        r = axes.layout.r
        return Range(np.array([*[rail.lo] * r, *arm.lo])[:, live], np.array([*[rail.hi] * r, *arm.hi])[:, live])

    return _Cells(joined(stood, hull), joined(rail_v, speeds), key[live])


def _columns(axes: Axes) -> IndexArray:
    """The axes (r+3,) that cells enclose: the rail and the first three joints."""
    every = np.arange(axes.n)
    return np.r_[every[axes.layout.rail], every[axes.layout.arm][:3]]


def _over_alive(ranges: Range, alive: BoolArray) -> Range:
    """The hull over the last axis of the ranges that are alive."""
    low = np.where(alive, ranges.lo, np.inf).min(axis=-1)
    return Range(low, np.where(alive, ranges.hi, -np.inf).max(axis=-1))


def _edge(axes: Axes, run: _Run, a: _Cells, b: _Cells, so_far: Array, ahead: Array, incumbent: float | None) -> Array:
    """(n_a, n_b) least time of a run between cells; infinite where no motion fits or none can matter: where it exceeds
    the incumbent or, without one, what another cell b takes with what is ahead."""
    out, columns, r = np.empty((len(a.key), len(b.key))), _columns(axes), axes.layout.r
    turns = np.ptp([axes.lower[columns[r]], axes.upper[columns[r]]]) > 2 * np.pi + 1e-6  # joint_1 may come round
    order = np.array([*range(r), *(r + j for j in _BOUND_ORDER if not (j == 0 and turns))])
    kind = int(run.fixed), int(run.still), int(run.straight), int(run.branch), int(incumbent is None)
    fill = loops("trajopt_cli.bound.bound_loops")["fill_times"]
    rows = max(1, (6 * axes.settings.batch) // max(1, len(b.key)))
    for start in range(0, len(a.key), rows):
        checkpoint()
        part = slice(start, start + rows)
        ends = a.q.lo[:, part], a.q.hi[:, part], a.v.lo[:, part], a.v.hi[:, part], b.q.lo, b.q.hi, b.v.lo, b.v.hi
        signs, most = (a.key[part, 0], b.key[:, 0]), np.inf if incumbent is None else incumbent
        fill(out[part], *ends, *signs, so_far[part], ahead, order, run.V, run.A, r, run.floor, *kind, most)
    return out
