"""Global search: dynamic programming over rail position, rail velocity, IK branch and turns at every waypoint.

It picks the basin the nonlinear program then descends in. Coarse first, with all branches and the rail at rest at the
waypoints; then finer around the best, on the labels that came near it, with rail velocity. Edge times of joint moves
are exact without the tool caps; those of lines are estimates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.double_integrator import reach, shortest_time, trapezoid_time
from trajopt_cli.optimize.edges import Band, Dense, Edge
from trajopt_cli.optimize.reach import Label, StationTable, rail_grid, station_table
from trajopt_cli.optimize.tied import Ties, best_tied
from trajopt_cli.optimize.tuning import (
    CURVED,
    LEAST_ROOM,
    NEAR_BEST,
    PASSING,
    SEARCH_CHUNK,
    SEARCH_COARSE,
    SEARCH_FINE,
    SEARCH_WINDOW,
    SHIFT,
    WAY_NODES,
    WIDEST,
)
from trajopt_cli.problem.freedom import RailFreedom
from trajopt_cli.problem.problem import Leg, LegKind, Problem


@dataclass(frozen=True, eq=False)
class Chain:
    """The best chain: axes q and velocities w (M, n) at the waypoints, labels there, estimated times of the legs."""

    q: Array
    w: Array
    labels: tuple[Label, ...]
    times: Array
    cost: float


@dataclass(frozen=True, eq=False)
class _Layer:
    """States at one waypoint: axes and their velocities (m, n), label number and rail index (m,)."""

    q: Array
    qd: Array
    label: IndexArray
    rail: IndexArray

    @property
    def place(self) -> IndexArray:
        """Label and rail number (2, m)."""
        return np.stack([self.label, self.rail])


def _layer(axes: Axes, problem: Problem, table: StationTable, k: int, speeds: Array) -> _Layer:
    arm = table.waypoints[k - table.first]
    labels, rails = np.nonzero(~np.isnan(arm[..., 0]))
    stop = problem.waypoints[k]
    q = axes.layout.join(table.d[rails], arm[labels, rails])
    if stop.rest or stop.q is not None or stop.rail[0] == stop.rail[1] or len(speeds) == 1:
        return _Layer(q, np.zeros_like(q), labels, rails)
    m = len(speeds)
    rate = axes.layout.join(np.ones(len(q)), axes.self_motion(q)[..., 0])
    q, labels, rails = np.repeat(q, m, axis=0), np.repeat(labels, m), np.repeat(rails, m)
    qd = np.repeat(rate, m, axis=0) * np.tile(speeds, len(rate))[:, None]
    ok = np.all(np.abs(qd) <= axes.velocity + 1e-12, axis=1)
    return _Layer(q[ok], qd[ok], labels[ok], rails[ok])


def _joint_time(axes: Axes, problem: Problem, leg: Leg, a: _Layer, b: _Layer) -> Array:
    """(n_a, n_b) least time of joint moves; the tool caps enter by a trapezoid over the tool's way, which is its chord
    where every axis may go its own way."""
    V, A = axes.velocity_on(leg), axes.acceleration
    out = np.empty((len(a.q), len(b.q)))
    moving = np.any(a.qd) or np.any(b.qd)
    p_a, p_b = (axes.forward(x.q) @ leg.X_FT for x in (a, b))
    rows = max(1, SEARCH_CHUNK // max(1, axes.n * len(b.q)))
    for i in range(0, len(a.q), rows):
        part = slice(i, i + rows)
        D = b.q[None] - a.q[part, None]
        if problem.coordinated:
            way = np.maximum(np.abs(D), 1e-12)
            T = trapezoid_time(1.0, np.min(V / way, axis=-1), np.min(A / way, axis=-1))
        elif moving:
            T = shortest_time(D, a.qd[part, None], b.qd[None], V, A, rounds=3)
        else:
            D = np.abs(D)
            T = np.max(trapezoid_time(D, V, A), axis=-1)
        chord = np.linalg.norm(p_a[part, None, :3, 3] - p_b[None, :, :3, 3], axis=-1)
        out[part] = np.maximum(T, trapezoid_time(chord, leg.v_tcp, leg.a_tcp))
        if problem.coordinated:
            _lengthen(axes, leg, a.q[part], b.q, out[part])
    if leg.duration is not None:
        out = np.where(out <= leg.duration, leg.duration, out)
    stays = axes.layout.place(a.q)[:, None] == axes.layout.place(b.q)
    return np.where(stays | leg.rail_moves, out, np.inf)


def _lengthen(axes: Axes, leg: Leg, q_0: Array, q_1: Array, T: Array) -> None:
    """Times T (n_0, n_1) of straight joint moves raised, in place, to what the tool's way takes, where that matters."""
    reach = np.linalg.norm(leg.X_FT[:3, 3]) + WIDEST
    lever = np.where(np.arange(axes.n) >= axes.layout.arm.start, reach, 1.0)
    most = np.abs(q_1[None] - q_0[:, None]) @ lever
    i, k = np.nonzero(np.isfinite(T) & (most > leg.v_tcp * T))
    for at in range(0, len(i), SEARCH_CHUNK // 64):
        a, b = i[at : at + SEARCH_CHUNK // 64], k[at : at + SEARCH_CHUNK // 64]
        s = np.linspace(0, 1, WAY_NODES)[:, None, None]
        tool = (axes.forward(q_0[a] + s * (q_1[b] - q_0[a])) @ leg.X_FT)[..., :3, 3]
        length = np.linalg.norm(np.diff(tool, axis=0), axis=-1).sum(axis=0)
        T[a, b] = np.maximum(T[a, b], trapezoid_time(length, leg.v_tcp, leg.a_tcp))


def _line_times(axes: Axes, problem: Problem, table: StationTable, k: int, a: _Layer, b: _Layer) -> Band:
    """Estimated times of a line, leg k, with the rail linear in the path, whatever the rates of the states."""
    leg, i = problem.legs[k], k - table.first
    line = table.line(i)
    assert line is not None
    d = table.d
    n = len(d)
    limits_v, limits_a = axes.velocity_on(leg), axes.acceleration
    spacing = (d[-1] - d[0]) / max(n - 1, 1)
    cruise = leg.chord / leg.v_tcp + leg.angle / leg.v_ori
    beyond = 0.0 if problem.passes(k) and problem.passes(k + 1) else SHIFT
    farthest = (beyond + axes.layout.place(limits_v) * cruise) if leg.rail_moves else 0.0
    if problem.freedom.rail is RailFreedom.STATION:
        farthest = 0.0
    widest = int(np.ceil(farthest / max(spacing, 1e-9)))
    leaves = table.leaves if problem.coordinated and all(before is None for before in table.raw[:i]) else None
    best: dict[int, Array] = {}
    S = np.linspace(0, 1, line.shape[1])
    for shift in range(-min(widest, n - 1), min(widest, n - 1) + 1):
        i0 = np.arange(max(0, -shift), min(n, n - shift))
        i1 = i0 + shift
        way = d[i1] - d[i0]
        position = i0[None] + shift * S[:, None]  # fractional rail index along the line; grid is uniform when free
        low = np.clip(np.floor(position + 1e-9).astype(int), 0, n - 1)
        high = np.minimum(low + 1, n - 1)
        f = (position - low)[None, :, :, None]
        node = np.arange(len(S))[:, None]
        arm = line[:, node, low] * (1 - f) + np.where(f > 1e-9, line[:, node, high], 0.0) * f
        q = axes.layout.join(d[i0] + way * S[:, None], arm)
        dq = np.gradient(q, S, axis=1)
        ddq = np.gradient(dq, S, axis=1)
        v = np.min(limits_v / np.maximum(np.abs(dq), 1e-9), axis=(1, 3))
        v = np.minimum(v, min(leg.v_tcp / max(leg.chord, 1e-12), leg.v_ori / max(leg.angle, 1e-12)))
        room = np.maximum(limits_a - np.abs(ddq) * (CURVED * v[:, None, :, None]) ** 2, LEAST_ROOM * limits_a)
        acc = np.min(room / np.maximum(np.abs(dq), 1e-9), axis=(1, 3))
        acc = np.minimum(acc, leg.a_tcp / max(leg.chord, 1e-12))
        T = trapezoid_time(1.0, v, acc)
        lost = np.isnan(T) if leaves is None else np.isnan(T) | ~leaves[:, i1]
        best[shift] = np.where(lost, np.inf, np.maximum(T, leg.duration or 0.0))
    return Band.between(best, len(table.labels), n, a.place, b.place)


def _line_edge(axes: Axes, problem: Problem, table: StationTable, k: int, a: _Layer, b: _Layer) -> Edge:
    """The same, and no less than the rates of the states allow."""
    band, leg = _line_times(axes, problem, table, k, a, b), problem.legs[k]
    if not (np.any(a.qd) or np.any(b.qd)):
        return band
    T = band.dense()
    ia, ib = np.nonzero(np.isfinite(T))
    V, A = axes.velocity_on(leg), axes.acceleration
    T[ia, ib] = np.maximum(T[ia, ib], shortest_time(b.q[ib] - a.q[ia], a.qd[ia], b.qd[ib], V, A, rounds=2))
    return Dense(T)


def _dwell_time(axes: Axes, problem: Problem, leg: Leg, a: _Layer, b: _Layer) -> Array:
    """(n_a, n_b) duration of a dwell; infinite where the rail's move does not fit."""
    V, A = axes.velocity, axes.acceleration
    same = a.label[:, None] == b.label[None]
    if not leg.rail_moves:
        same &= a.rail[:, None] == b.rail[None]
    out = np.full(same.shape, np.inf)
    ia, ib = np.nonzero(same)
    D = b.q[ib] - a.q[ia]
    if leg.duration is None:
        out[ia, ib] = shortest_time(D, a.qd[ia], b.qd[ib], V, A)
        return out
    T = leg.duration
    if problem.coordinated:
        way = np.maximum(np.abs(D), 1e-12)
        fits = trapezoid_time(1.0, np.min(V / way, axis=-1), np.min(A / way, axis=-1)) <= T
    else:
        up = reach(T, a.qd[ia], b.qd[ib], V, A) >= D - 1e-12
        down = reach(T, -a.qd[ia], -b.qd[ib], V, A) >= -D - 1e-12
        fits = np.all(up & down & (np.abs(b.qd[ib] - a.qd[ia]) <= A * T + 1e-12), axis=-1)
    out[ia, ib] = np.where(fits, T, np.inf)
    return out


def _edges(
    axes: Axes, problem: Problem, tables: list[StationTable], where: list[int], layers: list[_Layer]
) -> list[Edge]:
    edges: list[Edge] = []
    for k, leg in enumerate(problem.legs):
        a, b, table = layers[k], layers[k + 1], tables[where[k]]
        if leg.kind is LegKind.JOINT:
            edges.append(Dense(_joint_time(axes, problem, leg, a, b)))
        elif leg.kind is LegKind.LINE:
            edges.append(_line_edge(axes, problem, table, k, a, b))
        else:
            T = _dwell_time(axes, problem, leg, a, b)
            held = problem.freedom.rail is RailFreedom.STATION
            edges.append(Dense(np.where(a.rail[:, None] == b.rail[None], T, np.inf) if held else T))
    return edges


def _best(layers: list[_Layer], edges: Sequence[Edge], ties: Ties) -> tuple[float, list[int], list[Array], list[Array]]:
    """Cost and states of the best chain, and the least cost from the start to, and from there to the end of, a state
    where no tie is kept."""
    forward = [np.zeros(len(layers[0].q))]
    back: list[IndexArray] = []
    for edge in edges:
        source, cost = edge.into(forward[-1])
        back.append(source)
        forward.append(cost)
    backward = [np.zeros(len(layers[-1].q))]
    for edge in reversed(edges):
        backward.append(edge.out(backward[-1]))
    backward.reverse()
    if ties:
        through = [a + b for a, b in zip(forward, backward, strict=True)]
        tables = [edge.dense() for edge in edges]
        return *best_tied([layer.q for layer in layers], tables, through, ties), forward, backward
    end = int(np.argmin(forward[-1]))
    path = [end]
    for b in reversed(back):
        path.append(int(b[path[-1]]))
    return float(forward[-1][end]), path[::-1], forward, backward


def best_chain(q: list[Array], edges: list[Array], ties: Ties) -> tuple[float, list[int]]:
    """The least cost, and which of the axes q (m, n) of every waypoint the best chain takes."""
    none = np.zeros(0, dtype=np.intp)
    layers = [_Layer(x, np.zeros_like(x), none, none) for x in q]
    cost, path, _, _ = _best(layers, [Dense(T) for T in edges], ties)
    return cost, path


def search(axes: Axes, problem: Problem) -> Chain | None:
    """The best chain found, or None when no chain of waypoints is connected on the grid."""
    where = _station_of(problem)
    tables = [
        station_table(axes, problem, first, last, rail_grid(problem, first, last, SEARCH_COARSE))
        for first, last in problem.stations
    ]
    if not all(t.labels for t in tables):
        return None
    still = np.zeros(1)
    layers = [_layer(axes, problem, tables[where[k]], k, still) for k in range(len(problem.waypoints))]
    edges = _edges(axes, problem, tables, where, layers)
    cost, path, forward, backward = _best(layers, edges, problem.ties)
    if not np.isfinite(cost):
        return None
    coarse = _chain(problem, tables, where, layers, edges, path, cost)
    if all(s.rail[0] == s.rail[1] for s in problem.waypoints):
        return coarse
    # the fine search: labels near the best, rail near the best
    top = float(axes.layout.place(axes.velocity))
    speeds = still if problem.coordinated or not problem.freedom.through_stops else top * np.array(PASSING)
    fine_tables = []
    windows = _windows(axes, problem, tables, where, coarse)
    for (first, last), table, window in zip(problem.stations, tables, windows, strict=True):
        keep: set[int] = set()
        for k in range(first, last + 1):
            through = forward[k] + backward[k]
            near = through <= NEAR_BEST * cost
            keep |= set(layers[k].label[near].tolist())
        d = rail_grid(problem, first, last, SEARCH_FINE, window)
        fine = station_table(axes, problem, first, last, d)
        labels = [i for i in range(len(fine.labels)) if _like(fine, i, table, keep)]
        fine_tables.append(_restrict(fine, labels) if labels else fine)
    if not all(t.labels for t in fine_tables):
        return coarse
    layers = [_layer(axes, problem, fine_tables[where[k]], k, speeds) for k in range(len(problem.waypoints))]
    if not all(len(layer.q) for layer in layers):
        return coarse
    edges = _edges(axes, problem, fine_tables, where, layers)
    cost, path, _, _ = _best(layers, edges, problem.ties)
    return _chain(problem, fine_tables, where, layers, edges, path, cost) if np.isfinite(cost) else coarse


def _windows(
    axes: Axes, problem: Problem, tables: list[StationTable], where: list[int], coarse: Chain
) -> list[tuple[float, float]]:
    """The rail's range [m] of every station's fine search: near the coarse chain; one range for stations that share a
    tie or a rail that is held, so that their grids have positions in common."""
    windows = []
    for (first, last), table in zip(problem.stations, tables, strict=True):
        rail = axes.layout.place(coarse.q[first : last + 1])
        spacing = (table.d[-1] - table.d[0]) / max(len(table.d) - 1, 1)
        margin = max(2 * spacing, SEARCH_WINDOW)
        windows.append((float(rail.min()) - margin, float(rail.max()) + margin))
    held = [(leg.start, leg.start + 1) for leg in problem.legs if leg.kind is LegKind.JOINT and not leg.rail_moves]
    together = [sorted({where[k] for k in group}) for group in (*problem.ties, *held)]
    for _ in together:  # a group may join what others have joined
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


def _like(fine: StationTable, i: int, coarse: StationTable, keep: set[int]) -> bool:
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


def _restrict(table: StationTable, labels: list[int]) -> StationTable:
    return StationTable(
        table.first,
        table.d,
        tuple(table.labels[i] for i in labels),
        tuple(s[labels] for s in table.waypoints),
        table.raw,
        table.limits,
        None if table.leaves is None else table.leaves[labels],
    )


def _chain(
    problem: Problem, tables: list[StationTable], where: list[int], layers: list[_Layer], edges: list[Edge],
    path: list[int], cost: float,
) -> Chain:  # fmt: skip
    q = np.array([layers[k].q[i] for k, i in enumerate(path)])
    w = np.array([layers[k].qd[i] for k, i in enumerate(path)])
    labels = tuple(tables[where[k]].labels[layers[k].label[i]] for k, i in enumerate(path))
    times = np.array([edges[k].at(path[k], path[k + 1]) for k in range(len(problem.legs))])
    return Chain(q, w, labels, times, cost)
