"""Global search: dynamic programming over rail position, rail velocity, IK branch and turns at every waypoint.

It picks the basin the nonlinear program then descends in. Coarse first, with all branches and the rail at rest at the
waypoints; then finer around the best, on the labels that came near it, with rail velocity. Edge times of joint moves
are exact without the tool caps; those of lines are estimates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.graph_search.edges import Checked, Dense, Edge
from trajopt_cli.graph_search.ik_tables import IkTable, grid_in_reach, rail_grid, station_table
from trajopt_cli.graph_search.near_paths import near_paths
from trajopt_cli.graph_search.shared_states import Ties, best_tied, shared
from trajopt_cli.graph_search.transition_times import Layer, edges_of, layer_of, most_rail_travel
from trajopt_cli.problem.problem import LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import EdgeChecks, States
from trajopt_cli.trajectories.route import IkBranch, OtherPart, Route

_ELSEWHERE = 1.5  # times the coarse grid's spacing from which on a rail position is another one.
_SEARCH_WINDOW = 0.1  # m beside the best route at least that the fine search looks at.
_AVOID_ROUNDS = 60  # times that the best route is looked at and, where it is not clear, searched again.
_AVOID_WORSE = 1.3  # times the best route's cost beyond which pairs are not looked at beforehand.
_PASSING = (-0.5, 0.0, 0.5)  # shares of the rail's top velocity tried at a waypoint.
# per window of the search that are told of. Measured on 35 programs (benchmarks/bench_routes.py --worth 0.015 --parts
# 20): of 408 parts 14 were kept, 10 of them among the first ten, most often the fourth.
_OTHER_PARTS = 10


def _best(
    layers: list[Layer], edges: Sequence[Edge], ties: Ties, states: Sequence[Array], candidates: int
) -> tuple[float, list[int], list[Array]]:
    """Cost and states of the best route, and the least cost from the start to every state where no tie is kept.
    states: as best_tied has them."""
    forward, back = _forward(layers, edges)
    if ties:
        through = [a + b for a, b in zip(forward, _backward(layers, edges, forward, np.inf), strict=True)]
        return *best_tied(states, [edge.dense() for edge in edges], through, ties, candidates), forward
    end = int(np.argmin(forward[-1]))
    path = [end]
    for b in reversed(back):
        path.append(int(b[path[-1]]))
    return float(forward[-1][end]), path[::-1], forward


def _best_clear(
    axes: Axes, problem: Problem, tables: list[IkTable], where: list[int], layers: list[Layer],
    edges: Sequence[Edge], avoid: EdgeChecks | None,
) -> tuple[float, list[int], list[Array]]:  # fmt: skip
    """The same of routes that touch nothing: what is not known of the best one is looked at, until nothing is left.
    Infinite and [] where that has no end."""
    common = shared(axes, problem.waypoints, [layer.q for layer in layers], problem.ties)
    tied = problem.ties, common, problem.plant.settings.tie_candidates
    if avoid is None:
        return _best(layers, edges, *tied)
    forward: list[Array] = []
    states = [
        States(layer.q, np.array([label.cfx for label in tables[at].labels], dtype=np.intp)[layer.label])
        for layer, at in zip(layers, where, strict=True)
    ]
    for _ in range(_AVOID_ROUNDS):
        cost, path, forward = _best(layers, edges, *tied)
        if not np.isfinite(cost):
            return np.inf, [], forward
        new = [k for k, edge in enumerate(edges) if isinstance(edge, Checked) and not edge.known[path[k], path[k + 1]]]
        if not new:
            return cost, path, forward
        backward = _backward(layers, edges, forward, cost * _AVOID_WORSE)
        for k in new:
            edge, pair = edges[k], (path[k], path[k + 1])
            if isinstance(edge, Checked) and not edge.known[pair]:  # equal legs share one
                through = forward[k][:, None] + edge.least + backward[k + 1]
                avoid.settle(problem, k, edge, states[k], states[k + 1], through, pair)
    return np.inf, [], forward


def _forward(layers: list[Layer], edges: Sequence[Edge]) -> tuple[list[Array], list[IndexArray]]:
    """The least cost from the start to every state, and the states before them, where no tie is kept."""
    forward, back = [np.zeros(len(layers[0].q))], list[IndexArray]()
    for edge in edges:
        checkpoint()
        source, cost = edge.into(forward[-1])
        back.append(source)
        forward.append(cost)
    return forward, back


def _backward(layers: list[Layer], edges: Sequence[Edge], forward: Sequence[Array], limit: float) -> list[Array]:
    """The least cost from every state to the end; infinite where the best route through it costs more than limit, that
    from the start being forward."""
    backward = [np.zeros(len(layers[-1].q))]
    for edge, spent in zip(reversed(edges), reversed(forward[:-1]), strict=True):
        checkpoint()
        most, reached = np.full(len(spent), -np.inf), np.isfinite(spent)
        most[reached] = limit - spent[reached]
        cost = edge.out(backward[-1], most)
        backward.append(np.where(cost <= most, cost, np.inf))
    return backward[::-1]


def best_route(
    q: list[Array], edges: list[Array], ties: Ties, common: Sequence[Array], candidates: int
) -> tuple[float, list[int]]:
    """The least cost, and which of the axes q (m, n) of every waypoint the best route takes. common: as shared gives it
    of them."""
    none = np.zeros(0, dtype=np.intp)
    layers = [Layer(x, np.zeros_like(x), none, none) for x in q]
    return _best(layers, [Dense(T) for T in edges], ties, common, candidates)[:2]


def search(axes: Axes, problem: Problem, avoid: EdgeChecks | None = None) -> Route | None:
    """The best route found, or None when no route of waypoints is connected on the grid. avoid: what must not be
    touched; then joint moves of the route lead around it by the points that avoid knows.

    Long programs are searched in windows, each from where the one before it is certain enough; a long cycle begins and
    ends where the best route around that passes it.
    """
    settings, final = axes.settings, len(problem.legs)
    if problem.ties == ((0, final),) and final > settings.searched_legs:
        if (found := _seam(axes, problem, avoid)) is None:
            return None
        q, label = found
        seam = [replace(problem.waypoints[k].standing(problem.layout, q), q=q) for k in (0, final)]
        held = replace(problem, waypoints=(seam[0], *problem.waypoints[1:-1], seam[1]), ties=())
        route = search(axes, held, avoid)
        return route and replace(route, labels=(label, *route.labels[1:-1], label))
    ties = np.zeros(len(problem.waypoints) + 1, dtype=np.intp)  # how many of them begin or end
    for group in problem.ties:
        ties[group[0] + 1] += 1
        ties[group[-1]] -= 1
    within = np.cumsum(ties)
    ends = [last for _, last in problem.stations if not within[last]]
    parts: list[Route] = []
    begin = 0
    while True:
        end = next((k for k in ends if k - begin >= settings.searched_legs), final)
        sure = (
            max((k for k in ends if begin < k <= end - settings.overlapping_legs), default=end)
            if end < final
            else final
        )
        route = _search(axes, window(problem, begin, end, parts[-1].q[-1] if parts else None), avoid)
        if route is None:
            return None
        parts.append(_head(route, sure - begin))
        if sure == final:
            return _joined(parts)
        begin = sure


def _seam(axes: Axes, problem: Problem, avoid: EdgeChecks | None) -> tuple[Array, IkBranch] | None:
    """Where a cycle begins and ends on the best route from some legs before that to as many behind it."""
    n, some = len(problem.legs), 2 * axes.settings.overlapping_legs
    last = next(k for _, k in problem.stations if k >= some)
    first = max((k for _, k in problem.stations if k <= n - some), default=last)
    route = _search(axes, problem.around_end(first, last), avoid)
    return None if route is None else (route.q[n - first], route.labels[n - first])


def window(problem: Problem, first: int, last: int, q: Array | None, q_end: Array | None = None) -> Problem:
    """The problem from one waypoint to another, where stations end or the last one begins; it begins at axes q (n,) and
    ends at q_end, where these are given."""
    if first == 0 and last == len(problem.waypoints) - 1:
        return problem
    waypoints = list(problem.waypoints[first : last + 1])
    for at, held in ((0, q), (-1, q_end)):
        if held is not None:
            waypoints[at] = replace(waypoints[at].standing(problem.layout, held), q=held, rest=True)
    stations = [(max(a, first) - first, min(b, last) - first) for a, b in problem.stations if first <= b and a <= last]
    legs = tuple(replace(leg, start=leg.start - first) for leg in problem.legs[first:last])
    ties = tuple(tuple(k - first for k in group) for group in problem.ties if first <= group[0] and group[-1] <= last)
    return replace(problem, waypoints=tuple(waypoints), legs=legs, stations=tuple(stations), ties=ties)


def _head(route: Route, n: int) -> Route:
    """The first n legs of a route."""
    times = route.times[:n]
    others = tuple(one for one in route.others if one.last <= n)
    return Route(route.q[: n + 1], route.w[: n + 1], route.labels[: n + 1], times, float(np.sum(times)), others)


def _joined(routes: Sequence[Route]) -> Route:
    """Routes each of which begins where the one before it ends."""
    first, *others = routes
    if not others:
        return first
    q, w = (np.concatenate([getattr(first, x), *(getattr(one, x)[1:] for one in others)]) for x in ("q", "w"))
    times = np.concatenate([one.times for one in routes])
    labels = first.labels + tuple(label for one in others for label in one.labels[1:])
    begins = np.cumsum([0, *(len(one.times) for one in routes)]).tolist()
    parts = [replace(part, first=part.first + k) for k, one in zip(begins, routes, strict=False) for part in one.others]
    return Route(q, w, labels, times, float(np.sum(times)), tuple(sorted(parts, key=lambda part: part.more)))


def _tables(axes: Axes, problem: Problem, grids: Sequence[Array], avoid: EdgeChecks | None = None) -> list[IkTable]:
    """Of all stations on their grids; equal ones once."""
    known: dict[bytes, IkTable] = {}
    out = []
    for (first, last), d in zip(problem.stations, grids, strict=True):
        name = problem.key(first, last) + d.tobytes()
        if avoid is not None:
            name += avoid.scenes(problem, first, last)
        if name not in known:
            known[name] = station_table(axes, problem, first, last, d, None if avoid is None else avoid.around)
        out.append(known[name])
    return out


def _layers(axes: Axes, problem: Problem, tables: list[IkTable], speeds: Array) -> list[Layer]:
    """The states at all waypoints; at equal ones of equal stations one and the same."""
    known: dict[tuple[object, ...], Layer] = {}
    out = []
    for (first, last), table in zip(problem.stations, tables, strict=True):
        for k in range(first, last + 1):
            name = id(table), k - first, *_loads_at(problem, k)
            if name not in known:
                known[name] = layer_of(axes, problem, table, k - first, k, speeds)
            out.append(known[name])
    return out


def _loads_at(problem: Problem, k: int) -> tuple[tuple[float, ...], ...]:
    """What is carried before and behind a waypoint, where that matters."""
    beside = [problem.legs[i].load for i in (k - 1, k) if 0 <= i < len(problem.legs)]
    return tuple(() if load is None else load.numbers for load in beside)


def _search(
    axes: Axes, problem: Problem, avoid: EdgeChecks | None = None, every: bool = False, far: bool = False
) -> Route | None:
    """The same, all at once. every: in every whole turn. far: along a line the rail may go as far as it has to, however
    long its speed makes the line: what it takes time for is no want of reach."""
    settings = axes.settings
    where = _station_of(problem)
    grids = [
        grid_in_reach(axes, problem, first, last, settings.coarse_grid, settings.coarse_spacing)
        for first, last in problem.stations
    ]
    whole = _tables(axes, problem, grids, avoid)
    if not all(t.labels for t in whole):
        return None
    tables = whole if every else _in_few_turns(axes, problem, whole)
    fewer = any(one is not other for one, other in zip(tables, whole, strict=True))
    still = np.zeros(1)
    layers = _layers(axes, problem, tables, still)
    edges = edges_of(axes, problem, tables, where, layers, avoid, far)
    cost, path, forward = _best_clear(axes, problem, tables, where, layers, edges, avoid)
    if not np.isfinite(cost):
        if fewer:
            return _search(axes, problem, avoid, every=True, far=far)
        lines = [k for k, leg in enumerate(problem.legs) if leg.kind is LegKind.LINE]
        if any(0 < most_rail_travel(axes, problem, k, far) < np.ptp(tables[where[k]].d) for k in lines):
            return _search(axes, problem, avoid, every, far=True)
        if avoid is not None:
            ends = (k for k, least in enumerate(forward) if not np.isfinite(least).any())
            avoid.ended = next((problem.legs[k - 1].motion for k in ends), None)
        return None
    coarse = _route(problem, tables, where, layers, edges, path, cost)
    limit, worth = (cost + share * min(cost, settings.near_span) for share in (settings.near_best - 1, settings.worth))
    through = [a + b for a, b in zip(forward, _backward(layers, edges, forward, limit), strict=True)]
    others = list[Route]()
    if avoid is None and not problem.ties:
        near = near_paths([layer.place for layer in layers], edges, forward, through, path, worth)
        others = [coarse, *(_route(problem, tables, where, layers, edges, states, T) for T, states in near)]
    if all(s.rail[0] == s.rail[1] for s in problem.waypoints):
        return replace(coarse, others=_other_parts(axes, problem, coarse, others))
    del edges
    # the fine search: labels near the best, rail near the best
    top = float(axes.layout.place(axes.velocity))
    speeds = still if problem.coordinated or not problem.freedom.through_stops else top * np.array(_PASSING)
    windows = _windows(axes, problem, tables, where, coarse)
    grids = [
        rail_grid(problem, first, last, settings.fine_grid, window)
        for (first, last), window in zip(problem.stations, windows, strict=True)
    ]
    fine_tables, known = [], dict[tuple[object, ...], IkTable]()
    finer = _tables(axes, problem, grids, avoid)
    for (first, last), table, fine in zip(problem.stations, tables, finer, strict=True):
        keep: set[int] = set()
        for k in range(first, last + 1):
            keep |= set(layers[k].label[through[k] <= limit].tolist())
        name = id(table), id(fine), frozenset(keep)
        if name not in known:
            labels = [i for i in range(len(fine.labels)) if _matches_kept(fine, i, table, keep)]
            known[name] = _restrict(fine, labels) if labels else fine
        fine_tables.append(known[name])
    if not all(t.labels for t in fine_tables):
        return coarse
    layers = _layers(axes, problem, fine_tables, speeds)
    if not all(len(layer.q) for layer in layers):
        return coarse
    edges = edges_of(axes, problem, fine_tables, where, layers, avoid, far)
    cost, path, _ = _best_clear(axes, problem, fine_tables, where, layers, edges, avoid)
    if not np.isfinite(cost):
        return coarse
    found = _route(problem, fine_tables, where, layers, edges, path, cost)
    return replace(found, others=_other_parts(axes, problem, found, others))


def _other_parts(axes: Axes, problem: Problem, best: Route, others: Sequence[Route]) -> tuple[OtherPart, ...]:
    """The stations side by side in which other routes, the best of them first, are on another branch than the best
    route, in another turn, or at another place of the rail."""
    layout, found = axes.layout, dict[bytes, OtherPart]()
    apart = _ELSEWHERE * axes.settings.coarse_spacing
    for other in others:
        away = np.array([a.cfx != b.cfx for a, b in zip(best.labels, other.labels, strict=True)])
        away |= np.abs(best.q - other.q)[:, layout.arm].max(axis=1) > np.pi
        if layout.has_rail:
            away |= np.abs(layout.place(best.q) - layout.place(other.q)) > apart
        groups = list[list[int]]()
        for i in (i for i, (first, last) in enumerate(problem.stations) if away[first : last + 1].any()):
            groups = [*groups[:-1], [*groups[-1], i]] if groups and groups[-1][-1] == i - 1 else [*groups, [i]]
        for group in groups:
            first, last = problem.stations[group[0]][0], problem.stations[group[-1]][1]
            at = slice(first, last + 1)
            name = first.to_bytes(8, "big") + np.round(other.q[at], 9).tobytes()
            found.setdefault(name, OtherPart(first, other.q[at], other.labels[at], other.cost - others[0].cost))
    return tuple(found.values())[:_OTHER_PARTS]


def _windows(
    axes: Axes, problem: Problem, tables: list[IkTable], where: list[int], coarse: Route
) -> list[tuple[float, float]]:
    """The rail's range [m] of every station's fine search: near the coarse route; one range for stations that share a
    tie or a rail that is held, so that their grids have positions in common."""
    windows = []
    for (first, last), table in zip(problem.stations, tables, strict=True):
        rail = axes.layout.place(coarse.q[first : last + 1])
        spacing = (table.d[-1] - table.d[0]) / max(len(table.d) - 1, 1)
        margin = max(2 * spacing, _SEARCH_WINDOW)
        windows.append((float(rail.min()) - margin, float(rail.max()) + margin))
    held = [(leg.start, leg.start + 1) for leg in problem.legs if leg.kind is LegKind.JOINT and not leg.rail_moves]
    together = [sorted({where[k] for k in group}) for group in (*problem.ties, *held)]
    before: list[tuple[float, float]] = []
    while before != windows:  # a group may join what others have joined
        before = list(windows)
        for stations in together:
            low, high = min(windows[i][0] for i in stations), max(windows[i][1] for i in stations)
            for i in stations:
                windows[i] = low, high
    return windows


def _station_of(problem: Problem) -> list[int]:
    where = []
    for i, (first, last) in enumerate(problem.stations):
        where += [i] * (last - first + 1)
    return where


def _matches_kept(fine: IkTable, i: int, coarse: IkTable, keep: set[int]) -> bool:
    """Label i of the fine table is one of the kept coarse ones: same branch, joints that agree where both stand."""
    for j in keep:
        if fine.labels[i].cfx != coarse.labels[j].cfx:
            continue
        a, b = fine.waypoints[0][i], coarse.waypoints[0][j]
        ok_a, ok_b = np.flatnonzero(~np.isnan(a[:, 0])), np.flatnonzero(~np.isnan(b[:, 0]))
        near = ok_b[np.argmin(np.abs(coarse.d[ok_b][None] - fine.d[ok_a][:, None]), axis=1)]
        at = int(np.argmin(np.abs(coarse.d[near] - fine.d[ok_a])))
        if np.max(np.abs(a[ok_a[at]] - b[near[at]])) < np.pi:
            return True
    return False


def _in_few_turns(axes: Axes, problem: Problem, tables: Sequence[IkTable]) -> list[IkTable]:
    """The tables with, of every branch in more than most_turns whole turns, the searched_turns nearest to joints
    that are given: where the cycle begins, and joint targets. All where none are given."""
    settings = axes.settings
    given = [point.q[axes.layout.arm] for point in problem.waypoints if point.q is not None]
    known: dict[int, IkTable] = {}
    for table in tables if given else ():
        branches: dict[int, list[int]] = {}
        for i, label in enumerate(table.labels):
            branches.setdefault(label.cfx, []).append(i)
        keep: list[int] = []
        for some in branches.values():
            if len(some) > settings.most_turns:
                q = np.stack([at[some] for at in table.waypoints], axis=1)  # (turns, waypoints, rails, joints)
                away = [np.nanmin(np.abs(q - one).max(axis=-1), axis=(1, 2)) for one in given]
                some = [some[i] for i in np.argsort(np.min(away, axis=0), kind="stable")[: settings.searched_turns]]
            keep += some
        known[id(table)] = table if len(keep) == len(table.labels) else _restrict(table, sorted(keep))
    return [known.get(id(table), table) for table in tables]


def _restrict(table: IkTable, labels: list[int]) -> IkTable:
    leaves = None if table.leaves is None else table.leaves[labels]
    kept, waypoints = tuple(table.labels[i] for i in labels), tuple(s[labels] for s in table.waypoints)
    return replace(table, labels=kept, waypoints=waypoints, leaves=leaves)


def _route(
    problem: Problem, tables: list[IkTable], where: list[int], layers: list[Layer], edges: list[Edge],
    path: list[int], cost: float,
) -> Route:  # fmt: skip
    q = np.array([layers[k].q[i] for k, i in enumerate(path)])
    w = np.array([layers[k].qd[i] for k, i in enumerate(path)])
    labels = tuple(tables[where[k]].labels[layers[k].label[i]] for k, i in enumerate(path))
    times = np.array([edges[k].at(path[k], path[k + 1]) for k in range(len(problem.legs))])
    return Route(q, w, labels, times, cost)
