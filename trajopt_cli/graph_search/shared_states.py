"""The best route where some waypoints must be in one state: targets that a loop or a routine reaches several times.

Waypoints that are tied are one node; the legs between nodes are tables of times. A node with one or two neighbours is
taken out exactly, its best state kept for each of theirs; loops and calls in a row leave nothing else. What remains of
programs that visit their targets in changing orders is searched by coordinate descent, best candidates first.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.problem.problem import Waypoint
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.trajectories.axes import Axes

# times the untied cost beyond which states of tied waypoints are left out, tried in turn.
_WIDER = (1.05, 1.25, 2.0, float("inf"))
_SAME_PLACE = 1e-9  # m and entries of rotations between flange poses that are one
_SAME_STATE = 1e-06  # rad or m between two tables' joints for one and the same state of tied waypoints.

Ties = tuple[tuple[int, ...], ...]


def best_tied(
    states: Sequence[Array], edges: Sequence[Array], through: Sequence[Array], ties: Ties, candidates: int
) -> tuple[float, list[int]]:
    """Cost and state per waypoint of the best route that keeps the ties; infinite and [] where there is none.

    states (n_k, m): of every state of waypoint k what tied ones must have in common (shared). edges (n_k, n_k+1):
    times. through (n_k,): the least cost of an untied route through each state, which is a lower bound on that of a
    tied one: states far beyond the best are looked at only when nothing better is found. candidates: states of a
    waypoint that coordinate descent tries.
    """
    node, index = _merged(states, ties)
    least = min(float(np.min(values, initial=np.inf)) for values in through)
    for factor in _WIDER:
        limit = factor * least
        kept: dict[int, BoolArray] = {}
        for k, number in enumerate(node):
            near = through[k][index[k]] <= limit
            kept[number] = kept[number] & near if number in kept else near
        rows = [index[k][kept[number]] for k, number in enumerate(node)]
        cost, chosen = _Graph.of(node, rows, edges, through).solve(candidates)
        if cost <= limit:
            break
    if not np.isfinite(cost):
        return np.inf, []
    return cost, [int(rows[k][chosen[number]]) for k, number in enumerate(node)]


def shared(axes: Axes, waypoints: Sequence[Waypoint], q: Sequence[Array], ties: Ties) -> list[Array]:
    """Of the axes q (n_k, axes) of every waypoint what tied ones must have in common: all of them where the tool is at
    one place, the rail position and what confdata says of the arm where it is at several."""
    out = list(q)
    known: dict[int, Array] = {}
    for group in ties:
        first = waypoints[group[0]].X_WF
        if all(np.abs(waypoints[k].X_WF - first).max() <= _SAME_PLACE for k in group[1:]):
            continue
        for k in group:
            if id(q[k]) not in known:
                confdata = axes.robot.confdata_rows(q[k][:, axes.layout.arm])
                known[id(q[k])] = np.hstack([q[k][:, axes.layout.rail], confdata])
            out[k] = known[id(q[k])]
    return out


def _merged(states: Sequence[Array], ties: Ties) -> tuple[list[int], list[IndexArray]]:
    """The node of every waypoint, and its states in the node's order; of tied ones those that all of them have."""
    node = list(range(len(states)))
    index = [np.arange(len(q)) for q in states]
    for first, *others in ties:
        for k in others:
            node[k] = first
            if states[k] is states[first]:
                index[k] = index[first]
                continue
            apart = np.abs(states[first][index[first]][:, None] - states[k][None]).max(axis=2)
            there = apart.min(axis=1, initial=np.inf) <= _SAME_STATE
            for known in (first, *others[: others.index(k)]):
                index[known] = index[known][there]
            index[k] = apart[there].argmin(axis=1) if there.any() else np.zeros(0, dtype=np.intp)
    return node, index


@dataclass
class _Graph:
    """own: cost of each state of a node (n,). pair: cost of two nodes' states together (n_a, n_b), a < b. near: the
    nodes that share such a cost with a node. bound: a lower bound through each state. constant: cost of nodes that were
    taken out."""

    own: dict[int, Array]
    pair: dict[tuple[int, int], Array]
    near: dict[int, set[int]]
    bound: dict[int, Array] = field(default_factory=dict)
    constant: float = 0.0

    @classmethod
    def of(
        cls, node: Sequence[int], rows: Sequence[IndexArray], edges: Sequence[Array], through: Sequence[Array]
    ) -> _Graph:
        """The legs between nodes added up."""
        graph = cls({number: np.zeros(len(rows[number])) for number in node}, {}, {number: set() for number in node})
        for k, number in enumerate(node):
            bound = through[k][rows[k]]
            graph.bound[number] = np.maximum(graph.bound[number], bound) if number in graph.bound else bound
        often = Counter(
            (node[k], node[k + 1], id(T), rows[k].tobytes(), rows[k + 1].tobytes()) for k, T in enumerate(edges)
        )
        for k, T in enumerate(edges):
            a, b = node[k], node[k + 1]
            times = often.pop((a, b, id(T), rows[k].tobytes(), rows[k + 1].tobytes()), 0)
            if not times:  # counted with an equal leg before
                continue
            part = times * T[np.ix_(rows[k], rows[k + 1])]
            if a == b:
                graph.own[a] = graph.own[a] + np.diagonal(part)
            else:
                graph.add(a, b, part)
        return graph

    def add(self, a: int, b: int, table: Array) -> None:
        """More cost (n_a, n_b) between two nodes."""
        key, table = ((a, b), table) if a < b else ((b, a), table.T)
        self.pair[key] = self.pair[key] + table if key in self.pair else table
        self.near[a].add(b)
        self.near[b].add(a)

    def table(self, x: int, y: int) -> Array:
        """The cost of x (rows) and y together."""
        return self.pair[x, y] if x < y else self.pair[y, x].T

    def solve(self, candidates: int) -> tuple[float, dict[int, int]]:
        """Least cost and the state of every node; infinite where there is none."""
        if any(not len(values) for values in self.own.values()):
            return np.inf, {}
        hard = self._hard()
        if not hard:
            return self._given({})
        chosen = {x: int(np.argmin(self.bound[x])) for x in hard}
        best, answer = self._given(chosen)
        improved = True
        while improved:
            improved = False
            for x in hard:
                for state in np.argsort(self.bound[x], kind="stable")[:candidates].tolist():
                    if self.bound[x][state] >= best:
                        break
                    cost, found = self._given(chosen | {x: state})
                    if cost < best:
                        best, answer, improved = cost, found, True
                        chosen = chosen | {x: state}
        return best, answer

    def _hard(self) -> list[int]:
        """Nodes without which all others can be taken out exactly."""
        near = {x: set(others) for x, others in self.near.items()}
        hard = []
        while near:
            x = min(near, key=lambda x: (len(near[x]), x))
            if len(near[x]) > 2:
                x = max(near, key=lambda x: (len(near[x]), -x))
                hard.append(x)
                beside: set[int] = set()
            else:
                beside = near[x]
            for y in near.pop(x):
                near[y] = (near[y] | beside) - {x, y}
        return sorted(hard)

    def _given(self, fixed: Mapping[int, int]) -> tuple[float, dict[int, int]]:
        """As solve, with the states of some nodes given, so that all others can be taken out one by one."""
        graph = _Graph(dict(self.own), dict(self.pair), {x: set(others) for x, others in self.near.items()})
        total = 0.0
        for x, state in fixed.items():
            total += float(graph.own[x][state])
            for y in graph.near[x]:
                graph.own[y] = graph.own[y] + graph.table(x, y)[state]
            graph._remove(x)
        taken: list[tuple[int, list[int], IndexArray]] = []
        while graph.own:
            x = min(graph.own, key=lambda x: (len(graph.near[x]), x))
            beside = sorted(graph.near[x])
            taken.append((x, beside, graph._take_out(x, beside)))
        cost = total + graph.constant
        chosen = dict(fixed)
        for x, beside, best in reversed(taken):
            chosen[x] = int(best[tuple(chosen[y] for y in beside)])
        return cost, chosen

    def _take_out(self, x: int, beside: list[int]) -> IndexArray:
        """x leaves; its best state for every state of its neighbours, at most two, whose costs take it in."""
        own = self.own[x]
        best: IndexArray
        if not beside:
            self.constant += float(own.min())
            best = np.asarray(own.argmin())
        elif len(beside) == 1:
            (y,) = beside
            cost = own[:, None] + self.table(x, y)
            best = np.argmin(cost, axis=0)
            self.own[y] = self.own[y] + cost.min(axis=0)
        else:
            y, z = beside
            first, second = self.table(y, x) + own, self.table(x, z)
            least = np.empty((len(first), second.shape[1]))
            best = np.empty(least.shape, dtype=np.intp)
            for i, row in enumerate(first):
                checkpoint()
                cost = row[:, None] + second
                best[i] = cost.argmin(axis=0)
                least[i] = cost[best[i], np.arange(cost.shape[1])]
            self.add(y, z, least)
        self._remove(x)
        return best

    def _remove(self, x: int) -> None:
        del self.own[x]
        for y in self.near.pop(x):
            self.near[y].discard(x)
            del self.pair[min(x, y), max(x, y)]
