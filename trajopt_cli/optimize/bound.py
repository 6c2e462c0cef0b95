"""A lower bound on the cycle time: shortest path through cells that together contain every legal motion.

A cell at a stop is a range of rail position, a range of rail velocity and a pair of shoulder and elbow signs; it
encloses the first three arm joints and their velocities. Between cells of one stop and the next no motion is faster
than the least time in which rail and these joints can cover the gap within their limits (ends free inside the cells),
nor than the tool on its way (tool_time). Points that are passed have no cells, so any configuration may pass them; but
where a line ends beside a joint move, every motion goes through one pose at any velocity, and that has cells. Lines and
arcs keep the signs, as a problem's stations do.
Everything else (wrist, ranges on the way, the tool's caps on joint moves beyond the chord) is left out, so the bound
holds for every legal motion of the target; it is not called certified because its arithmetic is not outward rounded.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.double_integrator import reach, trapezoid_time
from trajopt_cli.optimize.tool_time import Gate, Part, course, parts_time, straight, tool_time
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
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.robot.enclosure import Enclosure, Range


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
class _Chain:
    """All places in order, what is asked between each and the next (one less), and between the stops of runs that have
    gates (numbers of two places)."""

    places: list[_Place]
    hops: list[_Run]
    direct: dict[tuple[int, int], _Run]


def lower_bound(axes: Axes, problem: Problem, incumbent: float) -> float:
    """No legal motion of this problem and target is faster [s].

    incumbent: a legal cycle time. Cells through which no chain is faster than the value aimed at are dropped; when none
    are left, that value is the bound, whatever the incumbent's quality.
    """
    cache: dict[bytes, Enclosure] = {}
    chain = _chain(axes, problem)
    grids = [_grid(problem, place) for place in chain.places]
    keep: list[IndexArray | None] = [None] * len(grids)
    ahead: list[Array | None] = [None] * len(grids)
    best, aim = 0.0, incumbent
    for level in range(BOUND_LEVELS if axes.layout.has_rail else 1):  # only rails have anything to halve
        cells = [_cells(axes, problem, place, grids[i], level, keep[i], cache) for i, place in enumerate(chain.places)]
        if any(not len(c.key) for c in cells):
            return aim
        pairs = max(len(a.key) * len(b.key) for a, b in pairwise(cells))
        if level and pairs > MOST_PAIRS:
            break
        parents = [
            np.zeros(len(c.key)) if known is None or keys is None else _parent_values(c, keys, known)
            for c, keys, known in zip(cells, keep, ahead, strict=True)
        ]
        forward, backward = _costs(axes, problem, chain, cells, parents, aim)
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


def _costs(
    axes: Axes, problem: Problem, chain: _Chain, cells: list[_Cells], parents: list[Array], aim: float
) -> tuple[list[Array], list[Array]]:
    """Least time from the start to every cell of every place, and from there to the end."""
    starts = {j: i for i, j in chain.direct}
    forward = [np.zeros(len(cells[0].key))]
    edges, direct = [], {}
    for k, run in enumerate(chain.hops):
        T = _edge(axes, problem, run, cells[k], cells[k + 1], forward[-1], parents[k + 1], aim)
        edges.append(T)
        forward.append(np.min(forward[-1][:, None] + T, axis=0))
        if (i := starts.get(k + 1)) is not None:
            run = chain.direct[i, k + 1]
            T = _edge(axes, problem, run, cells[i], cells[k + 1], forward[i], parents[k + 1], aim)
            direct[i] = k + 1, T
            forward[-1] = np.maximum(forward[-1], np.min(forward[i][:, None] + T, axis=0))
    backward = [np.zeros(len(cells[-1].key))]
    for k in reversed(range(len(edges))):
        backward.append(np.min(edges[k] + backward[-1][None], axis=1))
        if k in direct:
            j, T = direct[k]
            backward[-1] = np.maximum(backward[-1], np.min(T + backward[len(edges) - j][None], axis=1))
    return forward, backward[::-1]


def _chain(axes: Axes, problem: Problem) -> _Chain:
    """The problem as places and what is asked between them."""
    places, hops, direct = [_Place(0, None, problem.waypoints[0].rail)], [], {}
    for first, last in problem.runs:
        begin, parts = len(places) - 1, list[Part]()
        for part in course(problem, first, last):
            if isinstance(part, Part):
                parts.append(part)
                continue
            places.append(_Place(part.k, part, _rail_at(axes, problem, part.k)))
            hops.append(_between(axes, problem, parts, *places[-2:]))
            parts = []
        places.append(_Place(last, None, problem.waypoints[last].rail))
        run = _run(axes, problem, first, last)
        if len(places) - 2 == begin:
            hops.append(run)
        else:
            hops.append(_between(axes, problem, parts, *places[-2:]))
            direct[begin, len(places) - 1] = run
    return _Chain(places, hops, direct)


def _run(axes: Axes, problem: Problem, first: int, last: int) -> _Run:
    """From stop to stop."""
    legs = problem.legs[first:last]
    run = _asked(axes, problem, legs, tool_time(problem, first, last))
    straight = problem.coordinated and len(legs) == 1 and legs[0].kind is LegKind.JOINT
    fixed = legs[0].kind is LegKind.DWELL and legs[0].duration is not None
    given = any(problem.waypoints[k].q is not None for k in (first, last))  # cells of given joints have no signs
    return replace(run, fixed=fixed, still=problem.coordinated, straight=straight, branch=run.branch and not given)


def _between(axes: Axes, problem: Problem, parts: list[Part], a: _Place, b: _Place) -> _Run:
    """Between a gate and the next one or a stop."""
    first, last = a.gate.leg if a.gate else a.k, b.gate.leg if b.gate else b.k - 1
    legs = problem.legs[first : last + 1]
    stops = (a.gate is None) + (b.gate is None)
    X_a, X_b = (place.gate.X_WF if place.gate else problem.waypoints[place.k].X_WF for place in (a, b))
    acceleration = max(leg.a_tcp for leg in legs)
    ways = parts, [straight(problem, legs, X_a, X_b)]
    run = _asked(axes, problem, legs, max(parts_time(way, acceleration, stops) for way in ways))
    given = any(place.gate is None and problem.waypoints[place.k].q is not None for place in (a, b))
    return replace(run, branch=run.branch and not given)


def _asked(axes: Axes, problem: Problem, legs: Sequence[Leg], floor: float) -> _Run:
    """Of legs, whatever the axes do at their ends. A programmed time replaces the rail's programmed speed."""
    columns = _columns(axes)
    V = [axes.velocity_on(leg) if leg.duration is None else axes.velocity for leg in legs]
    A = [axes.acceleration_on(leg) for leg in legs]
    lines = all(leg.kind is not LegKind.JOINT for leg in legs)
    return _Run(np.max(V, axis=0)[columns], np.max(A, axis=0)[columns], floor, False, False, False, lines)


def _rail_at(axes: Axes, problem: Problem, k: int) -> tuple[float, float]:
    """Where the rail may be near waypoint k [m]: coordinated, between the waypoints beside it; free, anywhere."""
    if not problem.coordinated:
        return float(axes.layout.place(axes.lower)), float(axes.layout.place(axes.upper))
    near = [point.rail for point in problem.waypoints[k - 1 : k + 2]]
    return min(low for low, _ in near), max(high for _, high in near)


def _grid(problem: Problem, place: _Place) -> Array:
    low, high = place.rail
    if low == high or (place.gate is None and problem.waypoints[place.k].q is not None):
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
    place: _Place,
    grid: Array,
    level: int,
    kept: IndexArray | None,
    cache: dict[bytes, Enclosure],
) -> _Cells:
    stop, gate = problem.waypoints[place.k], place.gate
    if gate is None and stop.q is not None:
        q = stop.q[_columns(axes), None]
        zero = np.zeros_like(q)
        return _Cells(Range(q, q), Range(zero, zero), np.zeros((1, 3), dtype=int))
    X_WF = stop.X_WF if gate is None else gate.X_WF
    twist = None if gate is None else gate.twist
    name = X_WF.tobytes() + grid.tobytes() + (b"" if twist is None else twist.tobytes())
    if name not in cache:
        cache[name] = axes.robot.enclose(X_WF, grid, problem.plant.limits, twist)
    e = cache[name]
    single = len(grid) == 2
    width = 1 if single else max(1, BOUND_COARSE >> level)
    n_d = (len(grid) - 1) // width
    top = float(axes.layout.place(axes.velocity))
    rest = top == 0.0 or (gate is None and problem.rests(place.k))
    n_v = BOUND_SPEEDS << level
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


def _edge(
    axes: Axes, problem: Problem, run: _Run, a: _Cells, b: _Cells, so_far: Array, ahead: Array, incumbent: float
) -> Array:
    """(n_a, n_b) least time of a run between cells; infinite where no motion fits or none can matter."""
    out = np.full((len(a.key), len(b.key)), np.inf)
    rows = max(1, BOUND_CHUNK // len(b.key))
    for start in range(0, len(a.key), rows):
        part = np.arange(start, min(start + rows, len(a.key)))
        ia, ib = (x.ravel() for x in np.meshgrid(part, np.arange(len(b.key)), indexing="ij"))
        T, ia, ib = _pairs(axes, problem, run, a, b, ia, ib, so_far, ahead, incumbent)
        out[ia, ib] = T
    return out


def _pairs(
    axes: Axes, problem: Problem, run: _Run, a: _Cells, b: _Cells, ia: IndexArray, ib: IndexArray, so_far: Array,
    ahead: Array, incumbent: float,
) -> tuple[Array, IndexArray, IndexArray]:  # fmt: skip
    columns, r = _columns(axes), axes.layout.r
    V, A = run.V, run.A
    if run.branch:
        same = a.key[ia, 0] == b.key[ib, 0]
        ia, ib = ia[same], ib[same]
    T = np.full(len(ia), run.floor)
    turns = np.ptp([axes.lower[columns[r]], axes.upper[columns[r]]]) > 2 * np.pi + 1e-6  # joint_1 may come round
    order = [*range(r), *(r + j for j in BOUND_ORDER if not (j == 0 and turns))]
    top_v = np.full(len(ia), np.inf)
    top_a = np.full(len(ia), np.inf)
    for j in order:
        low, high = b.q.lo[j, ib] - a.q.hi[j, ia], b.q.hi[j, ib] - a.q.lo[j, ia]
        if run.still:
            least = np.maximum(np.maximum(low, -high), 0.0)
            if run.straight:
                least = np.maximum(least, 1e-12)
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
        if run.fixed:
            live = time <= run.floor + 1e-9
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
