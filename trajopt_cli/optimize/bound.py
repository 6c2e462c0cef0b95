"""A lower bound on the cycle time: shortest path through cells that together contain every legal motion.

A cell at a waypoint is a range of rail position, a range of rail velocity and a pair of shoulder and elbow signs; it
encloses the first three arm joints and their velocities. Between cells no motion is faster than the least time in which
rail and these joints can cover the gap within their limits (ends free inside the cells), nor than the tool over its
chord.
Everything else (wrist, ranges on the way, the tool's caps on joint moves beyond the chord) is left out, so the bound
holds for every legal motion of the target; it is not called certified because its arithmetic is not outward rounded.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.double_integrator import reach, trapezoid_time
from trajopt_cli.optimize.tuning import (
    BOUND_AIM,
    BOUND_CHUNK,
    BOUND_COARSE,
    BOUND_LEVELS,
    BOUND_ORDER,
    BOUND_RAIL,
    BOUND_SPEEDS,
    FEW_PAIRS,
    MOST_PAIRS,
)
from trajopt_cli.problem.problem import Leg, LegKind, Problem, Waypoint
from trajopt_cli.robot.enclosure import Enclosure, Range


@dataclass(frozen=True, eq=False)
class _Cells:
    """Cells at one waypoint: position and velocity (r+3, m) of rail, q1, q2, q3; key (m, 3): signs, rail, velocity."""

    q: Range
    v: Range
    key: IndexArray


def lower_bound(axes: Axes, problem: Problem, incumbent: float) -> float:
    """No legal motion of this problem and target is faster [s].

    incumbent: a legal cycle time. Cells through which no chain is faster than the value aimed at are dropped; when none
    are left, that value is the bound, whatever the incumbent's quality.
    """
    cache: dict[bytes, Enclosure] = {}
    grids = [_grid(stop) for stop in problem.waypoints]
    keep: list[IndexArray | None] = [None] * len(problem.waypoints)
    ahead: list[Array | None] = [None] * len(problem.waypoints)
    best, aim = 0.0, incumbent
    for level in range(BOUND_LEVELS):
        cells = [_cells(axes, problem, k, grids[k], level, keep[k], cache) for k in range(len(problem.waypoints))]
        if any(not len(c.key) for c in cells):
            return aim
        pairs = max(len(a.key) * len(b.key) for a, b in pairwise(cells))
        if level and pairs > MOST_PAIRS:
            break
        parents = [
            np.zeros(len(c.key)) if known is None or keys is None else _parent_values(c, keys, known)
            for c, keys, known in zip(cells, keep, ahead, strict=True)
        ]
        forward = [np.zeros(len(cells[0].key))]
        edges = []
        for k, leg in enumerate(problem.legs):
            T = _edge(axes, problem, leg, cells[k], cells[k + 1], forward[-1], parents[k + 1], aim)
            edges.append(T)
            forward.append(np.min(forward[-1][:, None] + T, axis=0))
        backward = [np.zeros(len(cells[-1].key))]
        for T in reversed(edges):
            backward.append(np.min(T + backward[-1][None], axis=1))
        backward.reverse()
        best = max(best, min(float(np.min(forward[-1])), aim))
        for k, c in enumerate(cells):
            live = forward[k] + backward[k] <= aim
            keep[k], ahead[k] = c.key[live], backward[k][live]
        if any(not len(x) for x in keep if x is not None):
            return aim
        next_pairs = (2 if problem.coordinated else 4) ** 2 * max(
            a * b for a, b in pairwise([len(x) for x in keep if x is not None])
        )
        if best < BOUND_AIM * incumbent and next_pairs > FEW_PAIRS:
            aim = BOUND_AIM * incumbent
    return best


def _grid(stop: Waypoint) -> Array:
    low, high = stop.rail
    if stop.q is not None or low == high:
        return np.array([low, high])
    n = max(1, int(np.ceil((high - low) / BOUND_RAIL)))
    n = -(-n // BOUND_COARSE) * BOUND_COARSE
    return np.linspace(low, high, n + 1)


def _parent_values(cells: _Cells, parent_keys: IndexArray, values: Array) -> Array:
    """What the level above knew to be still ahead of each cell."""
    table = {tuple(key): value for key, value in zip(parent_keys.tolist(), values.tolist(), strict=True)}
    return np.array([table[s, d // 2, v // 2] for s, d, v in cells.key.tolist()])


def _children(keys: IndexArray) -> IndexArray:
    """The four halves of each kept cell."""
    s, d, v = keys.T
    return np.concatenate([np.stack([s, 2 * d + i, 2 * v + j], axis=1) for i in (0, 1) for j in (0, 1)])


def _cells(
    axes: Axes,
    problem: Problem,
    k: int,
    grid: Array,
    level: int,
    kept: IndexArray | None,
    cache: dict[bytes, Enclosure],
) -> _Cells:
    stop = problem.waypoints[k]
    if stop.q is not None:
        q = stop.q[_columns(axes), None]
        zero = np.zeros_like(q)
        return _Cells(Range(q, q), Range(zero, zero), np.zeros((1, 3), dtype=int))
    name = stop.X_WF.tobytes() + grid.tobytes()
    if name not in cache:
        cache[name] = axes.robot.enclose(stop.X_WF, grid, problem.plant.limits)
    e = cache[name]
    single = len(grid) == 2
    width = 1 if single else max(1, BOUND_COARSE >> level)
    n_d = (len(grid) - 1) // width
    rest = problem.rests(k)
    n_v = BOUND_SPEEDS << level
    if kept is None:
        key = np.array([(s, d, v) for s in range(4) for d in range(n_d) for v in ((0,) if rest else range(n_v))])
    else:
        key = _children(kept)
        key = key[(key[:, 1] < n_d) & ((key[:, 2] == 0) if rest else True)]
    s, d, v = key.T
    V = axes.velocity[axes.layout.arm]
    top = float(axes.layout.place(axes.velocity))
    edges = np.linspace(-top, top, n_v + 1)
    rail_v = Range(np.zeros(len(key)), np.zeros(len(key))) if rest else Range(edges[v], edges[v + 1])
    inside = d[:, None] * width + np.arange(width)  # (n, width) base intervals
    joints = Range(e.q.lo[:, s[:, None], inside], e.q.hi[:, s[:, None], inside])
    rate = Range(e.rate.lo[:, s[:, None], inside], e.rate.hi[:, s[:, None], inside])
    speed = rate * Range(
        np.broadcast_to(rail_v.lo[:, None], inside.shape), np.broadcast_to(rail_v.hi[:, None], inside.shape)
    )
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


def _edge(
    axes: Axes, problem: Problem, leg: Leg, a: _Cells, b: _Cells, so_far: Array, ahead: Array, incumbent: float
) -> Array:
    """(n_a, n_b) least time of a leg between cells; infinite where no motion fits or none can matter."""
    out = np.full((len(a.key), len(b.key)), np.inf)
    rows = max(1, BOUND_CHUNK // len(b.key))
    for start in range(0, len(a.key), rows):
        part = np.arange(start, min(start + rows, len(a.key)))
        ia, ib = (x.ravel() for x in np.meshgrid(part, np.arange(len(b.key)), indexing="ij"))
        T, ia, ib = _pairs(axes, problem, leg, a, b, ia, ib, so_far, ahead, incumbent)
        out[ia, ib] = T
    return out


def _pairs(
    axes: Axes, problem: Problem, leg: Leg, a: _Cells, b: _Cells, ia: IndexArray, ib: IndexArray, so_far: Array,
    ahead: Array, incumbent: float,
) -> tuple[Array, IndexArray, IndexArray]:  # fmt: skip
    columns, r = _columns(axes), axes.layout.r
    V = (axes.velocity if leg.kind is LegKind.DWELL else axes.velocity_on(leg))[columns]
    A = axes.acceleration[columns]
    fixed = leg.kind is LegKind.DWELL and leg.duration is not None
    floor = leg.duration if leg.duration is not None else 0.0
    if leg.kind is not LegKind.DWELL:
        floor = max(floor, float(trapezoid_time(leg.chord, leg.v_tcp, leg.a_tcp)))
    T = np.full(len(ia), floor)
    turns = np.ptp([axes.lower[columns[r]], axes.upper[columns[r]]]) > 2 * np.pi + 1e-6  # joint_1 may come round
    order = [*range(r), *(r + j for j in BOUND_ORDER if not (j == 0 and turns))]
    top_v = np.full(len(ia), np.inf)
    top_a = np.full(len(ia), np.inf)
    for j in order:
        low, high = b.q.lo[j, ib] - a.q.hi[j, ia], b.q.hi[j, ib] - a.q.lo[j, ia]
        if problem.coordinated:
            least = np.maximum(np.maximum(low, -high), 1e-12)
            if leg.kind is LegKind.JOINT:
                top_v, top_a = np.minimum(top_v, V[j] / least), np.minimum(top_a, A[j] / least)
                time = trapezoid_time(1.0, top_v, top_a)
            else:
                time = trapezoid_time(least, V[j], A[j])
        else:
            a_lo, a_hi, c_lo, c_hi = a.v.lo[j, ia], a.v.hi[j, ia], b.v.lo[j, ib], b.v.hi[j, ib]
            time = T.copy()
            for _ in range(2):
                time = _leave(time, low, a_lo, a_hi, c_lo, c_hi, V[j], A[j])
                time = _leave(time, -high, -a_hi, -a_lo, -c_hi, -c_lo, V[j], A[j])
        if fixed:
            live = time <= floor + 1e-9
        else:
            T = np.maximum(T, time)
            live = so_far[ia] + T + ahead[ib] <= incumbent
        ia, ib, T, top_v, top_a = ia[live], ib[live], T[live], top_v[live], top_a[live]
    return T, ia, ib


def _leave(T: Array, D: Array, a_lo: Array, a_hi: Array, c_lo: Array, c_hi: Array, V: float, A: float) -> Array:
    """The least time >= T in which some motion between the velocity boxes travels at least D; see _most."""
    T = np.maximum(T, np.maximum(c_lo - a_hi, a_lo - c_hi) / A)
    short = _most(T, a_hi, c_hi, V, A) < D - 1e-9
    m, M = np.minimum(a_hi, c_hi), np.maximum(a_hi, c_hi)
    with np.errstate(invalid="ignore", divide="ignore"):
        early = (np.sqrt(np.maximum(m * m + 2 * A * D, 0)) - m) / A
        energy = A * D + (a_hi**2 + c_hi**2) / 2
        peak = np.sqrt(np.maximum(energy, 0))
        slow = (2 * peak - a_hi - c_hi) / A
        fast = (2 * V - a_hi - c_hi) / A + (D - (V * V - (a_hi**2 + c_hi**2) / 2) / A) / V
    late = np.where(peak <= V, slow, fast)
    end = np.where((M >= 0) & ((M * M - m * m) / (2 * A) > D), early, late)
    return np.where(short, np.maximum(T, end - 1e-9), T)


def _most(T: Array, a: Array, c: Array, V: float, A: float) -> Array:
    """Most displacement in T when the end velocities may be chosen below a and c: convex and smooth in T."""
    m, M = np.minimum(a, c), np.maximum(a, c)
    return np.where(M - m > T * A, m * T + A * T * T / 2, reach(T, a, c, V, A))
