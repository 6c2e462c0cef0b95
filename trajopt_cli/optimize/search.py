"""Global search: dynamic programming over rail position, rail velocity, IK branch and turns at every waypoint.

It picks the basin the nonlinear program then descends in. Coarse first, with all branches and the rail at rest at the
waypoints; then finer around the best, on the labels that came near it, with rail velocity. Edge times of joint moves
are exact without the tool caps; those of lines are estimates.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.double_integrator import reach, shortest_time, trapezoid_time
from trajopt_cli.optimize.edges import Band, Dense, Edge, Lazy
from trajopt_cli.optimize.reach import Label, StationTable, rail_grid, station_table
from trajopt_cli.optimize.tied import Ties, best_tied
from trajopt_cli.optimize.tuning import (
    CURVED,
    LEAST_ROOM,
    LINE_CHUNK,
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

_LEAST = 1e-12  # s, s2: of a leg that goes nowhere


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


def _joint_edge(axes: Axes, problem: Problem, leg: Leg, a: _Layer, b: _Layer) -> Edge:
    """Least times of joint moves between all states; the tool caps enter by a trapezoid over the tool's way, which is
    its chord where every axis may go its own way."""
    V, A = axes.velocity_on(leg), axes.acceleration
    p_a, p_b = ((axes.forward(x.q) @ leg.X_FT)[:, :3, 3] for x in (a, b))
    slow, hard, most, chord = (np.zeros((len(a.q), len(b.q))) for _ in range(4))
    lever = np.where(np.arange(axes.n) >= axes.layout.arm.start, np.linalg.norm(leg.X_FT[:3, 3]) + WIDEST, 1.0)
    T = np.zeros_like(slow)
    for j in range(axes.n):
        way = np.abs(b.q[None, :, j] - a.q[:, None, j])
        most += way * lever[j]
        np.maximum(slow, way / V[j], out=slow)
        if problem.coordinated:
            np.maximum(hard, way / A[j], out=hard)
        else:
            np.maximum(T, trapezoid_time(way, V[j], A[j]), out=T)
    if problem.coordinated:  # one profile for all: over a share of 1, at 1 / slow and 1 / hard at most
        slow, hard = np.maximum(slow, _LEAST), np.maximum(hard, _LEAST)
        T = np.where(slow * slow > hard, slow + hard / slow, 2 * np.sqrt(hard))
    elif np.any(a.qd) or np.any(b.qd):
        T = shortest_time(b.q[None] - a.q[:, None], a.qd[:, None], b.qd[None], V, A, rounds=3)
    for j in range(3):
        chord += (p_b[None, :, j] - p_a[:, None, j]) ** 2
    T = np.maximum(T, trapezoid_time(np.sqrt(chord), leg.v_tcp, leg.a_tcp))
    doubt = most > leg.v_tcp * T if problem.coordinated else np.zeros(T.shape, dtype=bool)
    stays = axes.layout.place(a.q)[:, None] == axes.layout.place(b.q)
    forbidden = np.zeros(T.shape, dtype=bool) if leg.rail_moves else ~stays

    def within(T: Array) -> Array:
        return T if leg.duration is None else np.where(leg.duration >= T, leg.duration, T)

    def sure(i: IndexArray, k: IndexArray) -> Array:
        return within(np.maximum(bare[i, k], _driven(axes, leg, a.q[i], b.q[k])))

    bare, T = T, within(T)
    return (
        Lazy(np.where(forbidden, np.inf, T), doubt & ~forbidden, sure)
        if doubt.any()
        else Dense(np.where(forbidden, np.inf, T))
    )


def _driven(axes: Axes, leg: Leg, q_0: Array, q_1: Array) -> Array:
    """What the tool's way takes (k,) on straight joint moves between axes (k, n)."""
    out = np.empty(len(q_0))
    for i in range(0, len(out), SEARCH_CHUNK // 64):
        part = slice(i, i + SEARCH_CHUNK // 64)
        s = np.linspace(0, 1, WAY_NODES)[:, None, None]
        tool = (axes.forward(q_0[part] + s * (q_1[part] - q_0[part])) @ leg.X_FT)[..., :3, 3]
        length = np.linalg.norm(np.diff(tool, axis=0), axis=-1).sum(axis=0)
        out[part] = trapezoid_time(length, leg.v_tcp, leg.a_tcp)
    return out


def _line_times(axes: Axes, problem: Problem, table: StationTable, k: int, a: _Layer, b: _Layer) -> Band:
    """Estimated times of a line, leg k, with the rail linear in the path, whatever the rates of the states."""
    leg, i = problem.legs[k], k - table.first
    raw = table.raw[i]
    assert raw is not None
    d, n, nodes = table.d, len(table.d), raw.shape[1]
    V, A = axes.velocity_on(leg), axes.acceleration
    spacing = (d[-1] - d[0]) / max(n - 1, 1)
    cruise = leg.chord / leg.v_tcp + leg.angle / leg.v_ori
    beyond = 0.0 if problem.passes(k) and problem.passes(k + 1) else SHIFT
    farthest = (beyond + axes.layout.place(V) * cruise) if leg.rail_moves else 0.0
    if problem.freedom.rail is RailFreedom.STATION:
        farthest = 0.0
    widest = min(int(np.ceil(farthest / max(spacing, 1e-9))), n - 1)
    shifts = np.arange(widest, -widest - 1, -1)
    cfx = np.array([label.cfx for label in table.labels])
    used, of = np.unique(cfx, return_inverse=True)
    arm = np.moveaxis(raw[used], -1, 0).reshape(-1, nodes * n)  # (m * branches, places)
    open_ = np.array([table.open_on(i, label) for label in range(len(cfx))]).reshape(len(cfx), -1)
    times = np.empty((len(shifts), len(cfx), n))
    rows = max(1, LINE_CHUNK // arm.size)
    leaves = table.leaves if problem.coordinated and all(before is None for before in table.raw[:i]) else None
    for start in range(0, len(shifts), rows):
        some = shifts[start : start + rows]
        behind = np.arange(n) + some[:, None]  # (s, n) rail number at the line's end
        at = some[:, None] * np.linspace(0, 1, nodes)
        whole = np.floor(at + 1e-9)
        f = np.where(at - whole > 1e-9, at - whole, 0.0)[..., None]
        low = np.clip(
            np.arange(n) + whole.astype(int)[..., None], 0, n - 1
        )  # (s, nodes, n); fractional between low, high
        high = np.where(f > 0, np.minimum(low + 1, n - 1), low)
        low, high = (np.arange(nodes)[:, None] * n + x for x in (low, high))
        q = (arm[:, low] * (1 - f) + arm[:, high] * f).reshape(axes.layout.joints, len(used), *low.shape)
        T = _along_line(axes, leg, q, (d[np.clip(behind, 0, n - 1)] - d), V, A)
        ok = np.all(open_[:, low] & open_[:, high], axis=2) & ((behind >= 0) & (behind < n))
        if leaves is not None:
            ok &= leaves[:, np.clip(behind, 0, n - 1)]
        T = T[of]
        times[start : start + rows] = np.where(ok & ~np.isnan(T), np.maximum(T, leg.duration or 0.0), np.inf).swapaxes(
            0, 1
        )
    return Band(shifts, times, a.place, b.place)


def _along_line(axes: Axes, leg: Leg, arm: Array, way: Array, V: Array, A: Array) -> Array:
    """Estimated times (B, s, n) of joints (m, B, s, nodes, n) along a line, the rail going its way (s, n) meanwhile."""
    h = 1 / (arm.shape[3] - 1)

    def slope(x: Array) -> Array:
        out = np.empty_like(x)
        out[..., 1:-1, :] = (x[..., 2:, :] - x[..., :-2, :]) / (2 * h)
        out[..., 0, :], out[..., -1, :] = (x[..., 1, :] - x[..., 0, :]) / h, (x[..., -1, :] - x[..., -2, :]) / h
        return out

    def most(shares: Iterable[Array]) -> Array:
        """The greatest (B, s, n) of axes and nodes."""
        out = np.zeros(arm.shape[1:])
        for share in shares:
            np.maximum(out, share, out=out)
        return np.asarray(np.max(out, axis=2))

    dq = slope(arm)
    ddq = np.abs(slope(dq))
    np.abs(dq, out=dq)
    rail, layout = np.abs(way), axes.layout
    slow = most(x / limit for x, limit in zip(dq, V[layout.arm], strict=True))
    for limit in V[layout.rail]:
        slow = np.maximum(slow, rail / limit)
    slow = np.maximum(slow, max(leg.chord / leg.v_tcp, leg.angle / leg.v_ori, _LEAST))
    charged = ((CURVED / slow) ** 2)[:, :, None]
    hard = most(
        x / np.maximum(limit - bend * charged, LEAST_ROOM * limit)
        for x, bend, limit in zip(dq, ddq, A[layout.arm], strict=True)
    )
    for limit in A[layout.rail]:
        hard = np.maximum(hard, rail / limit)
    hard = np.maximum(hard, max(leg.chord / leg.a_tcp, _LEAST))
    return np.where(slow * slow > hard, slow + hard / slow, 2 * np.sqrt(hard))


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
            edges.append(_joint_edge(axes, problem, leg, a, b))
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
