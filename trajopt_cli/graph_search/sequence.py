"""The order of stations: the search's own times between them, and the shortest way through all of them.

Each station keeps what it does; between them the rail and the configuration are free. With the states of the search at
the stations' ends this is a travelling salesman's problem whose cities have states: dynamic programming over subsets
(Held and Karp, 1962, A dynamic programming approach to sequencing problems) finds the best of few (exact_stations).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.ik_tables import IkTable, grid_in_reach, station_table
from trajopt_cli.graph_search.search import _backward, _forward, _layers, _station_of
from trajopt_cli.graph_search.transition_times import edges_of, joint_edge
from trajopt_cli.problem.problem import LegKind, Problem
from trajopt_cli.trajectories.axes import Axes

_WIDER, _WIDEST = 1.5, 0.6  # times, m: rail positions
_SEGMENT = 3  # stations that are moved together at most
_LEAST = 1e-9  # s that an order has to be better


@dataclass(frozen=True, eq=False)
class Steps:
    """Times [s] of n stations by the states at their ends. enter[j] (m_j,): from the program's start to the end of
    station j, as the first one. between[i][j] (m_i, m_j): from the end of station i to that of j; its own is not used.
    leave[i] (m_i,): from there to the program's end."""

    enter: tuple[Array, ...]
    between: tuple[tuple[Array, ...], ...]
    leave: tuple[Array, ...]

    @property
    def n(self) -> int:
        """How many stations."""
        return len(self.enter)

    @cached_property
    def arcs(self) -> Array:
        """The least time (n + 1, n + 1) from what is before, the start last, to each station and, last, to the end."""
        n = self.n
        out = np.full((n + 1, n + 1), np.inf)
        for i in range(n):
            out[n, i], out[i, n] = self.enter[i].min(initial=np.inf), self.leave[i].min(initial=np.inf)
            for j in range(n):
                if i != j:
                    out[i, j] = self.between[i][j].min(initial=np.inf)
        return out

    def cost(self, order: Sequence[int]) -> float:
        """The least time of the whole program in this order [s]."""
        cost = self.enter[order[0]]
        for i, j in pairwise(order):
            cost = np.min(cost[:, None] + self.between[i][j], axis=0)
        return float((cost + self.leave[order[-1]]).min(initial=np.inf))


class NotApart(Exception):
    """A station that does not begin with a joint move, by number; or what comes behind all of them, number None."""

    def __init__(self, station: int | None):
        super().__init__(station)
        self.station = station


def steps_of(
    axes: Axes, problem: Problem, stations: Sequence[tuple[int, int]], states: int | None = None
) -> Steps | None:
    """The times of stations, each given by its first motion and the one behind its last, one behind the other in the
    problem's program. states: of a station at most, about. None where some waypoint has no states.

    Ties of passes are left out, and corners are taken as points. Raises NotApart.
    """
    ways = [_waypoints(problem, i, *motions) for i, motions in enumerate(stations)]
    begin, end = ways[0][0], ways[-1][1]
    if end < len(problem.legs) and problem.legs[end].kind is not LegKind.JOINT:
        raise NotApart(None)
    tables = [
        _table(axes, problem, first, last, states or axes.settings.station_states) for first, last in problem.stations
    ]
    if not all(table.labels for table in tables):
        return None
    layers = _layers(axes, problem, tables, np.zeros(1))
    edges = edges_of(axes, problem, tables, _station_of(problem), layers)
    before = _forward(layers[:begin], edges[: begin - 1])[0][-1]
    after = None
    if end < len(problem.legs):
        rest = layers[end + 1 :]
        after = _backward(rest, edges[end + 1 :], [np.zeros(len(one.q)) for one in rest], np.inf)[0]
    stays = [np.where(np.eye(len(layers[a].q), dtype=bool), 0.0, np.inf) for a, _ in ways]  # in a state: no time
    inside = [
        reduce(_product, [edge.dense() for edge in edges[a:b]], stay) for (a, b), stay in zip(ways, stays, strict=True)
    ]

    def to(layer: int, j: int) -> Array:
        """From the states of a layer through the joint move into station j and through it."""
        first = ways[j][0]
        into = joint_edge(axes, problem, first - 1, layers[layer], layers[first]).dense()
        return _product(into, inside[j])

    n = len(ways)
    enter = [np.min(before[:, None] + to(begin - 1, j), axis=0) for j in range(n)]
    none = np.zeros((0, 0))
    between = [tuple(to(ways[i][1], j) if i != j else none for j in range(n)) for i in range(n)]
    leave = []
    for _, last in ways:
        if after is None:
            leave.append(np.zeros(len(layers[last].q)))
        else:
            out = joint_edge(axes, problem, end, layers[last], layers[end + 1]).dense()
            leave.append(np.min(out + after[None], axis=1))
    return Steps(tuple(enter), tuple(between), tuple(leave))


def _waypoints(problem: Problem, station: int, first: int, behind: int) -> tuple[int, int]:
    """The first and the last waypoint of a station."""
    legs = [k for k, leg in enumerate(problem.legs) if first <= leg.motion < behind]
    if not legs or problem.legs[legs[0]].kind is not LegKind.JOINT:
        raise NotApart(station)
    return legs[0] + 1, legs[-1] + 1


def _table(axes: Axes, problem: Problem, first: int, last: int, states: int) -> IkTable:
    """A station's states, its rail positions as far apart as it takes to have few enough."""
    apart, fewest = axes.settings.coarse_spacing, axes.settings.coarse_grid
    while True:
        d = grid_in_reach(axes, problem, first, last, fewest, apart)
        table = station_table(axes, problem, first, last, d)
        if apart >= _WIDEST or len(table.labels) * len(d) <= states:
            return table
        apart, fewest = apart * _WIDER, 2


def _product(A: Array, B: Array) -> Array:
    """The least times (n_a, n_c) through any state between, of times (n_a, n_b) and (n_b, n_c)."""
    return np.array([np.min(row[:, None] + B, axis=0) for row in A]).reshape(len(A), B.shape[1])


# --------------------------------------------------------------------------------------------------------------- orders


def best_order(steps: Steps) -> tuple[float, tuple[int, ...]]:
    """The least time [s] and its order, exact for these steps. Takes time and memory as n^2 2^n."""
    n = steps.n
    best: dict[tuple[int, int], Array] = {(1 << j, j): steps.enter[j] for j in range(n)}
    for subset in sorted(range(1, 1 << n), key=int.bit_count):
        for j in (j for j in range(n) if subset >> j & 1 and subset != 1 << j):
            rest = subset & ~(1 << j)
            ways = [np.min(best[rest, i][:, None] + steps.between[i][j], axis=0) for i in range(n) if rest >> i & 1]
            best[subset, j] = np.min(ways, axis=0)
    subset = (1 << n) - 1
    ends = [best[subset, j] + steps.leave[j] for j in range(n)]
    last = int(np.argmin([end.min(initial=np.inf) for end in ends]))
    cost = float(ends[last].min(initial=np.inf))
    if not np.isfinite(cost):
        return cost, tuple(range(n))
    state, order = int(np.argmin(ends[last])), [last]
    while subset != 1 << last:
        subset, before = subset & ~(1 << last), last
        into = {i: best[subset, i] + steps.between[i][before][:, state] for i in range(n) if subset >> i & 1}
        last = min(into, key=lambda i: float(into[i].min()))
        state = int(np.argmin(into[last]))
        order.append(last)
    return cost, tuple(order[::-1])


def nearest_order(steps: Steps) -> tuple[int, ...]:
    """From the start always to the station that is reached soonest of those left."""
    at, left, out = steps.n, set(range(steps.n)), list[int]()
    while left:
        at = min(sorted(left), key=lambda j: steps.arcs[at, j])
        left.remove(at)
        out.append(at)
    return tuple(out)


def improved_order(steps: Steps, order: Sequence[int]) -> tuple[int, ...]:
    """An order that no move of up to three stations elsewhere (Or-opt) and no turned part (2-opt) makes better."""
    now, cost = tuple(order), steps.cost(order)
    while True:
        # the arcs' sum is never more than the cost: what it cannot better is not looked at
        hopeful = sorted(
            (least, other) for other in set(_neighbours(now)) if (least := _least_sum(steps, other)) < cost - _LEAST
        )
        better = ((found, other) for _, other in hopeful if (found := steps.cost(other)) < cost - _LEAST)
        step = next(better, None)
        if step is None:
            return now
        cost, now = step


def _least_sum(steps: Steps, order: Sequence[int]) -> float:
    """The least times of an order's ways, each by itself [s]."""
    at = [steps.n, *order, steps.n]
    return float(steps.arcs[at[:-1], at[1:]].sum())


def near_orders(steps: Steps, order: Sequence[int], count: int) -> list[tuple[int, ...]]:
    """The best orders one step away from this one."""
    found = sorted((steps.cost(other), other) for other in set(_neighbours(tuple(order))) - {tuple(order)})
    return [other for cost, other in found[:count] if np.isfinite(cost)]


def _neighbours(order: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    n = len(order)
    for i in range(n):
        for k in range(i + 1, min(i + _SEGMENT, n) + 1):
            rest = order[:i] + order[k:]
            yield from (rest[:at] + order[i:k] + rest[at:] for at in range(len(rest) + 1) if at != i)
        yield from (order[:i] + order[i:k][::-1] + order[k:] for k in range(i + 2, n + 1))


def least_time(steps: Steps) -> float:
    """No order of these steps takes less [s]: every station is entered and left once (the assignment bound)."""
    from scipy.optimize import linear_sum_assignment

    arcs = steps.arcs
    known = arcs[np.isfinite(arcs)]
    if not len(known):
        return float("inf")
    out_of_reach = 1.0 + known.max() * (steps.n + 1)
    cost = np.where(np.isfinite(arcs), arcs, out_of_reach)
    rows, columns = linear_sum_assignment(cost)
    return float(cost[rows, columns].sum())
