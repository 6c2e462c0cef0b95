"""Global search: dynamic programming over rail position, rail velocity, IK branch and turns at every waypoint.

It picks the basin the nonlinear program then descends in. Coarse first, with all branches and the rail at rest at the
waypoints; then finer around the best, on the labels that came near it, with rail velocity. Edge times of joint moves
are exact without the tool caps; those of lines are estimates.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.graph_search.edges import Band, Checked, Dense, Edge, Lazy
from trajopt_cli.graph_search.ik_tables import IkTable, grid_in_reach, rail_grid, reversed_leg, station_table
from trajopt_cli.graph_search.near_paths import near_paths
from trajopt_cli.graph_search.rail_in_waits import farthest
from trajopt_cli.graph_search.shared_states import Ties, best_tied, shared
from trajopt_cli.problem.decision_scope import RailFreedom
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.timing.double_integrator import alone, mean_ramp, reach, shortest_time, trapezoid_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import EdgeChecks, States
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectories.route import IkBranch, OtherPart, Route

_PATH_SAMPLES = 6  # places on a joint move whose distances add up to the tool's way. Not measured.
_WIDEST = 1.0  # m from an arm's axis to its flange at most; farther ones only miss that a slow joint move is long.
_SHIFT = 0.45  # m that the rail may move on a line beyond what it can at top velocity in the tool's time.
_CURVED = 0.6  # share of a line's top velocity at which its curvature is charged against acceleration.
_LEAST_ROOM = 0.15  # share of each acceleration limit that is always left for that.
_AVOID_ROUNDS = 60  # times that the best route is looked at and, where it is not clear, searched again.
_AVOID_WORSE = 1.3  # times the best route's cost beyond which pairs are not looked at beforehand.
_PASSING = (-0.5, 0.0, 0.5)  # shares of the rail's top velocity tried at a waypoint.
# per window of the search that are told of. Measured on 35 programs (benchmarks/bench_routes.py --worth 0.015 --parts
# 20): of 408 parts 14 were kept, 10 of them among the first ten, most often the fourth.
_OTHER_PARTS = 10
_ELSEWHERE = 1.5  # times the coarse grid's spacing from which on a rail position is another one.
_SEARCH_WINDOW = 0.1  # m beside the best route at least that the fine search looks at.

_LEAST = 1e-12  # s, s2: of a leg that goes nowhere


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


def _layer(axes: Axes, problem: Problem, table: IkTable, i: int, k: int, speeds: Array) -> _Layer:
    arm = table.waypoints[i]
    labels, rails = np.nonzero(~np.isnan(arm[..., 0]))
    stop = problem.waypoints[k]
    q = problem.axes_at(k, table.d[rails], arm[labels, rails])
    beside = [problem.legs[i] for i in (k - 1, k) if 0 <= i < len(problem.legs)]
    held = np.all([limit.holds(leg, q) for limit in limits_of(axes) for leg in beside], axis=0)
    if held.any():
        q, labels, rails = q[held], labels[held], rails[held]
    if stop.rest or stop.q is not None or stop.rail[0] == stop.rail[1] or len(speeds) == 1:
        return _Layer(q, np.zeros_like(q), labels, rails)
    m = len(speeds)
    rate = axes.layout.join(np.ones(len(q)), axes.self_motion(q)[..., axes.layout.sought])
    q, labels, rails = np.repeat(q, m, axis=0), np.repeat(labels, m), np.repeat(rails, m)
    qd = np.repeat(rate, m, axis=0) * np.tile(speeds, len(rate))[:, None]
    ok = np.all(np.abs(qd) <= axes.velocity + 1e-12, axis=1)
    return _Layer(q[ok], qd[ok], labels[ok], rails[ok])


def _joint_edge(axes: Axes, problem: Problem, k: int, a: _Layer, b: _Layer) -> Edge:
    """Least times of a joint move, leg k, between all states; the tool caps enter by a trapezoid over the tool's way,
    which is its chord where every axis may go its own way."""
    leg = problem.legs[k]
    V, A = axes.velocity_on(leg), axes.usual_acceleration
    moving = bool(np.any(a.qd) or np.any(b.qd))
    slow = _slowest_axes(a, b, V, A, axes.settings.slowest_states) if moving else list(range(axes.n))
    p_a, p_b = (axes.tool_points(x.q, leg.X_FT) for x in (a, b))
    bare, doubt = np.empty((len(a.q), len(b.q))), np.full((len(a.q), len(b.q)), moving)
    rows = max(1, (3 * axes.settings.batch) // len(b.q))
    for part in (slice(i, i + rows) for i in range(0, len(a.q), rows)):
        checkpoint()
        T = _chord_time(leg, p_a[part], p_b)
        if problem.coordinated:
            together, most = _coordinated_time(axes, leg, a.q[part], b.q, V, A)
            np.maximum(T, together, out=T)
            doubt[part] = most > leg.v_tcp * T
        elif moving:
            for j in slow:
                np.maximum(T, _axis_time(a, b, V, A, part, slice(None), j), out=T)
        else:
            for j in slow:
                np.maximum(T, trapezoid_time(np.abs(b.q[None, :, j] - a.q[part, None, j]), V[j], A[j]), out=T)
        bare[part] = T
    T = _with_leg_time(bare, leg)
    if not leg.rail_moves:
        stays = axes.layout.place(a.q)[:, None] == axes.layout.place(b.q)
        T, doubt = np.where(stays, T, np.inf), doubt & stays
    if (led := problem.leads(k, a.q, b.q)) is not None:
        T, doubt = np.where(led, T, np.inf), doubt & led
    if not doubt.any():
        return Dense(T)

    def sure(i: IndexArray, j: IndexArray) -> Array:
        return _with_leg_time(np.maximum(bare[i, j], shortest_time(b.q[j] - a.q[i], a.qd[i], b.qd[j], V, A)), leg)

    def through(shares: Array) -> Callable[[IndexArray, IndexArray], Array]:
        def least(i: IndexArray, j: IndexArray) -> Array:
            return _with_leg_time(
                np.maximum(bare[i, j], _tool_path_time(axes, leg, a.q[i], b.q[j], p_a[i], p_b[j], shares)), leg
            )

        return least

    if not problem.coordinated:
        return Lazy(T, doubt.astype(np.int8), (sure,))
    shares = np.linspace(0, 1, _PATH_SAMPLES)[1:-1]
    return Lazy(T, 2 * doubt.astype(np.int8), (through(shares[len(shares) // 2 :][:1]), through(shares)))


def _with_leg_time(T: Array, leg: Leg) -> Array:
    """Least times of a leg with its programmed time, where that is enough, or with the time of what turns meanwhile:
    T itself where neither is given."""
    if leg.duration is None and leg.least == 0.0:
        return T
    return np.maximum(T, leg.least) if leg.duration is None else np.where(leg.duration >= T, leg.duration, T)


def _coordinated_time(axes: Axes, leg: Leg, q_a: Array, q_b: Array, V: Array, A: Array) -> tuple[Array, Array]:
    """Least times (n_a, n_b) of all axes with one profile for all, but for the tool's caps; how far the tool goes at
    most [m]."""
    lever = np.where(np.arange(axes.n) >= axes.layout.arm.start, np.linalg.norm(leg.X_FT[:3, 3]) + _WIDEST, 1.0)
    slow, hard, most = (np.full((len(q_a), len(q_b)), least) for least in (_LEAST, _LEAST, 0.0))
    for j in range(axes.n):
        way = np.abs(q_b[None, :, j] - q_a[:, None, j])
        most += way * lever[j]
        np.maximum(slow, way / V[j], out=slow)
        np.maximum(hard, way / A[j], out=hard)
    # over a share of 1, at 1 / slow and 1 / hard at most
    return np.where(slow * slow > hard, slow + hard / slow, 2 * np.sqrt(hard)), most


def _slowest_axes(a: _Layer, b: _Layer, V: Array, A: Array, states: int) -> list[int]:
    """The axes that take longest between some of the states where each goes by itself."""
    some_a, some_b = (slice(None, None, max(1, len(x.q) // states)) for x in (a, b))
    times = [_axis_time(a, b, V, A, some_a, some_b, j) for j in range(len(V))]
    return [int(j) for j in np.unique(np.argmax(times, axis=0))]


def _axis_time(a: _Layer, b: _Layer, V: Array, A: Array, i: slice, k: slice, j: int) -> Array:
    """Least times of one axis between some of the states, by itself."""
    return alone(b.q[None, k, j] - a.q[i, None, j], a.qd[i, None, j], b.qd[None, k, j], V[j], A[j])


def _chord_time(leg: Leg, p_a: Array, p_b: Array) -> Array:
    """What the tool takes straight from places (n_a, 3) to places (n_b, 3)."""
    chord = np.zeros((len(p_a), len(p_b)))
    for j in range(3):
        chord += (p_b[None, :, j] - p_a[:, None, j]) ** 2
    return trapezoid_time(np.sqrt(chord), leg.v_tcp, mean_ramp(*leg.ramps))


def _tool_path_time(axes: Axes, leg: Leg, q_0: Array, q_1: Array, p_0: Array, p_1: Array, shares: Array) -> Array:
    """What the tool's way takes (k,) at least on straight joint moves between axes (k, n), the tool at (k, 3) there,
    through its places at some shares of them."""
    out = np.empty(len(q_0))
    rows = max(1, (3 * axes.settings.batch) // (16 * len(shares)))
    for part in (slice(i, i + rows) for i in range(0, len(out), rows)):
        checkpoint()
        tool = axes.tool_points(q_0[part] + shares[:, None, None] * (q_1[part] - q_0[part]), leg.X_FT)
        steps = np.diff(np.concatenate([p_0[None, part], tool, p_1[None, part]]), axis=0)
        out[part] = np.sqrt((steps * steps).sum(axis=-1)).sum(axis=0)
    return trapezoid_time(out, leg.v_tcp, mean_ramp(*leg.ramps))


def _most_rail_travel(axes: Axes, problem: Problem, k: int, far: bool) -> float:
    """How far the rail is asked to go [m] along line k, which it hardly holds back then; far: however long it takes."""
    leg = problem.legs[k]
    if not leg.rail_moves or problem.freedom.rail is RailFreedom.STATION:
        return 0.0
    cruise = max(leg.chord / leg.v_tcp + leg.angle / leg.v_ori, leg.duration or leg.least, leg.positioner_use[0])
    beyond = 0.0 if problem.passes(k) and problem.passes(k + 1) else _SHIFT
    return np.inf if far else beyond + float(axes.layout.place(axes.velocity_on(leg))) * cruise


def _line_times(
    axes: Axes, problem: Problem, table: IkTable, i: int, k: int, a: _Layer, b: _Layer, far: bool = False
) -> Band:
    """Estimated times of a line, leg k and number i of its station, with the rail linear in the path, whatever the
    rates of the states. far: as in _search."""
    leg = problem.legs[k]
    raw = table.raw[i]
    assert raw is not None
    d, n, nodes = table.d, len(table.d), raw.shape[1]
    V, A = axes.velocity_on(leg), axes.usual_acceleration
    spacing = (d[-1] - d[0]) / max(n - 1, 1)
    widest = int(np.ceil(min(_most_rail_travel(axes, problem, k, far) / max(spacing, 1e-9), n - 1)))
    shifts = np.arange(widest, -widest - 1, -1)
    used, of = np.unique([label.cfx for label in table.labels], return_inverse=True)
    open_ = table.open_on(i).reshape(len(of), -1)
    leaves = table.leaves if problem.coordinated and all(before is None for before in table.raw[:i]) else None
    times = np.full((len(shifts), len(of), n), np.inf)
    arm = np.moveaxis(raw[used], -1, 0).reshape(-1, len(used), nodes * n)
    here, there = np.isfinite(table.waypoints[i][..., 0]), np.isfinite(table.waypoints[i + 1][..., 0])
    near = np.abs(np.arange(n) - np.arange(n)[:, None]) <= widest
    before, behind = np.nonzero(near & np.logical_or.reduce(here)[:, None] & np.logical_or.reduce(there))
    rows = max(1, (12 * axes.settings.batch) // (len(of) * nodes))
    for some in (slice(j, j + rows) for j in range(0, len(before), rows)):
        checkpoint()
        start, end = before[some], behind[some]  # (p,) rail numbers at the line's ends
        at = (end - start) * np.linspace(0, 1, nodes)[:, None]
        whole = np.floor(at + 1e-9)
        f = np.where(at - whole > 1e-9, at - whole, 0.0)
        low = np.arange(nodes)[:, None] * n + start + whole.astype(int)
        high = low + (f > 0)  # (nodes, p); fractional between low, high
        ok = here[:, start] & there[:, end] & np.all(open_[:, low] & open_[:, high], axis=1)
        if leaves is not None:
            ok &= leaves[:, end]
        T = np.full((len(used), len(start)), np.inf)
        branch, pair = np.nonzero([np.any(ok[of == cfx], axis=0) for cfx in range(len(used))])
        most = max(1, (12 * axes.settings.batch) // (len(arm) * nodes))
        for cfx, p in ((branch[j : j + most], pair[j : j + most]) for j in range(0, len(pair), most)):
            checkpoint()
            q = arm[:, cfx, low[:, p]] * (1 - f[:, p]) + arm[:, cfx, high[:, p]] * f[:, p]
            T[cfx, p] = _along_line(axes, leg, q, problem.ways(k, d[end[p]] - d[start[p]]), V, A)
        times[widest + start - end, :, start] = np.where(ok, np.maximum(T, leg.duration or leg.least)[of], np.inf).T
    return Band(shifts, times, a.place, b.place)


def _along_line(axes: Axes, leg: Leg, arm: Array, way: Array, V: Array, A: Array) -> Array:
    """Estimated times (p,) of joints (m, nodes, p) along a line, the rails going their ways (r, p) meanwhile."""
    h = 1 / (arm.shape[1] - 1)

    def slope(x: Array) -> Array:
        out = np.empty_like(x)
        np.subtract(x[:, 2:], x[:, :-2], out=out[:, 1:-1])
        out[:, 1:-1] /= 2 * h
        out[:, 0], out[:, -1] = (x[:, 1] - x[:, 0]) / h, (x[:, -1] - x[:, -2]) / h
        return out

    dq = slope(arm)
    ddq = slope(dq)
    np.abs(ddq, out=ddq)
    np.abs(dq, out=dq)
    layout = axes.layout
    slow = np.max(np.max(dq, axis=1) / V[layout.arm, None], axis=0)
    for limit, rail in zip(V[layout.rail], way, strict=True):
        slow = np.maximum(slow, rail / limit)
    slow = np.maximum(slow, max(leg.chord / leg.v_tcp, leg.angle / leg.v_ori, leg.positioner_use[0], _LEAST))
    limits = A[layout.arm, None, None]
    ddq *= -((_CURVED / slow) ** 2)
    ddq += limits
    np.maximum(ddq, _LEAST_ROOM * limits, out=ddq)
    dq /= ddq
    hard = np.max(dq, axis=(0, 1))
    for limit, rail in zip(A[layout.rail], way, strict=True):
        hard = np.maximum(hard, rail / limit)
    hard = np.maximum(hard, max(leg.chord / mean_ramp(*leg.ramps), leg.positioner_use[1], _LEAST))
    return np.where(slow * slow > hard, slow + hard / slow, 2 * np.sqrt(hard))


def _line_edge(axes: Axes, leg: Leg, band: Band, a: _Layer, b: _Layer) -> Edge:
    """The same, and no less than the rates of the states allow: those of the rail at once."""
    if not (np.any(a.qd) or np.any(b.qd)):
        return band
    T, V, A = band.dense(), axes.velocity_on(leg), axes.usual_acceleration
    for ia, ib in band.blocks:
        for j in range(*axes.layout.rail.indices(axes.n)):
            way = b.q[ib, j] - a.q[ia, j, None]
            np.maximum(T[ia, ib], alone(way, a.qd[ia, j, None], b.qd[None, ib, j], V[j], A[j]), out=T[ia, ib])

    def sure(i: IndexArray, k: IndexArray) -> Array:
        return np.maximum(T[i, k], shortest_time(b.q[k] - a.q[i], a.qd[i], b.qd[k], V, A))

    return Lazy(T, np.isfinite(T).astype(np.int8), (sure,))


def _mirrored_leg(problem: Problem, first: int, k: int) -> int | None:
    """The leg of a station that begins at a waypoint, whose times leg k has the other way round; None for none."""
    j = reversed_leg(problem, first, k)
    if j is None:
        return None
    caps, its = (
        (x.v_tcp, x.a_tcp, x.v_ori, x.v_rail, x.duration, x.rail_moves, x.acceleration, x.least, x.along)
        for x in (problem.legs[k], problem.legs[j])
    )
    passed, its_passed = (problem.passes(i) and problem.passes(i + 1) for i in (k, j))
    (a, b), (c, d) = ([problem.waypoints[i].rail for i in (n, n + 1)] for n in (k, j))
    return j if caps == its and passed == its_passed and (a, b) == (d, c) else None


def _dwell_time(axes: Axes, problem: Problem, leg: Leg, d: Array, arm: Array, a: _Layer, b: _Layer) -> Array:
    """(n_a, n_b) duration of a dwell; infinite where the rail's move does not fit. d, arm: as in farthest."""
    V, A = axes.velocity_on(leg), axes.acceleration
    same = a.label[:, None] == b.label[None]
    if not leg.rail_moves:
        same &= a.rail[:, None] == b.rail[None]
    out = np.full(same.shape, np.inf)
    before, behind = np.nonzero(same)
    far = None
    choice = any(point.rail[0] < point.rail[1] for point in problem.waypoints[leg.start : leg.start + 2])
    if choice and leg.rail_moves and leg.duration is not None and axes.layout.has_rail:  # no estimate refuses a program
        far = farthest(axes, leg, d, arm)
    rows = max(1, (3 * axes.settings.batch) // axes.n)
    for part in (slice(i, i + rows) for i in range(0, len(before), rows)):
        checkpoint()
        ia, ib = before[part], behind[part]
        D, v_a, v_b, T = b.q[ib] - a.q[ia], a.qd[ia], b.qd[ib], leg.duration
        if T is None:
            out[ia, ib] = shortest_time(D, v_a, v_b, V, A)
            continue
        if problem.coordinated:
            way = np.maximum(np.abs(D), 1e-12)
            fits = trapezoid_time(1.0, np.min(V / way, axis=-1), np.min(A / way, axis=-1)) <= T
            fits |= ~D.any(axis=-1)  # however short
        else:
            up, down = reach(T, v_a, v_b, V, A) >= D - 1e-12, reach(T, -v_a, -v_b, V, A) >= -D - 1e-12
            fits = np.all(up & down & (np.abs(v_b - v_a) <= A * T + 1e-12), axis=-1)
        if far is not None:
            ways = np.sort(np.stack([a.rail[ia], b.rail[ib]]), axis=0)
            fits &= (far[a.label[ia], ways[0]] >= ways[1]) | v_a.any(axis=-1) | v_b.any(axis=-1)
        out[ia, ib] = np.where(fits, T, np.inf)
    return out


def _edges(
    axes: Axes, problem: Problem, tables: list[IkTable], where: list[int], layers: list[_Layer],
    avoid: EdgeChecks | None = None, far: bool = False,
) -> list[Edge]:  # fmt: skip
    """Between all states; equal legs between equal states share one. far: as in _search."""
    edges: list[Edge] = []
    known: dict[tuple[object, ...], Edge] = {}
    bands: dict[int | None, Band] = {}
    for k, leg in enumerate(problem.legs):
        checkpoint()
        a, b, table = layers[k], layers[k + 1], tables[where[k]]
        scene = None if avoid is None else avoid.around.scene(leg.motion)
        name = id(a), id(b), leg.key, problem.passes(k), problem.passes(k + 1), scene
        if name in known:
            edges.append(known[name])
            continue
        if leg.kind is LegKind.JOINT:
            edges.append(_joint_edge(axes, problem, k, a, b))
        elif leg.kind is LegKind.LINE:
            first = problem.stations[where[k]][0]
            back = _mirrored_leg(problem, first, k)
            if back in bands:
                bands[k] = bands[back].back(a.place, b.place)
            else:
                bands[k] = _line_times(axes, problem, table, k - first, k, a, b, far)
            edges.append(_line_edge(axes, leg, bands[k], a, b))
        else:
            arm = table.waypoints[k - problem.stations[where[k]][0]]
            T = _dwell_time(axes, problem, leg, table.d, arm, a, b)
            held = problem.freedom.rail is RailFreedom.STATION
            edges.append(Dense(np.where(a.rail[:, None] == b.rail[None], T, np.inf) if held else T))
        made = edges[-1]
        if avoid is not None and not isinstance(made, Checked):
            edges[-1] = Checked.of(made, (len(a.q), len(b.q)))
        known[name] = edges[-1]
    return edges


def _best(
    layers: list[_Layer], edges: Sequence[Edge], ties: Ties, states: Sequence[Array], candidates: int
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
    axes: Axes, problem: Problem, tables: list[IkTable], where: list[int], layers: list[_Layer],
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


def _forward(layers: list[_Layer], edges: Sequence[Edge]) -> tuple[list[Array], list[IndexArray]]:
    """The least cost from the start to every state, and the states before them, where no tie is kept."""
    forward, back = [np.zeros(len(layers[0].q))], list[IndexArray]()
    for edge in edges:
        checkpoint()
        source, cost = edge.into(forward[-1])
        back.append(source)
        forward.append(cost)
    return forward, back


def _backward(layers: list[_Layer], edges: Sequence[Edge], forward: Sequence[Array], limit: float) -> list[Array]:
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
    layers = [_Layer(x, np.zeros_like(x), none, none) for x in q]
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


def _layers(axes: Axes, problem: Problem, tables: list[IkTable], speeds: Array) -> list[_Layer]:
    """The states at all waypoints; at equal ones of equal stations one and the same."""
    known: dict[tuple[object, ...], _Layer] = {}
    out = []
    for (first, last), table in zip(problem.stations, tables, strict=True):
        for k in range(first, last + 1):
            name = id(table), k - first, *_loads_at(problem, k)
            if name not in known:
                known[name] = _layer(axes, problem, table, k - first, k, speeds)
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
    edges = _edges(axes, problem, tables, where, layers, avoid, far)
    cost, path, forward = _best_clear(axes, problem, tables, where, layers, edges, avoid)
    if not np.isfinite(cost):
        if fewer:
            return _search(axes, problem, avoid, every=True, far=far)
        lines = [k for k, leg in enumerate(problem.legs) if leg.kind is LegKind.LINE]
        if any(0 < _most_rail_travel(axes, problem, k, far) < np.ptp(tables[where[k]].d) for k in lines):
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
    edges = _edges(axes, problem, fine_tables, where, layers, avoid, far)
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
    problem: Problem, tables: list[IkTable], where: list[int], layers: list[_Layer], edges: list[Edge],
    path: list[int], cost: float,
) -> Route:  # fmt: skip
    q = np.array([layers[k].q[i] for k, i in enumerate(path)])
    w = np.array([layers[k].qd[i] for k, i in enumerate(path)])
    labels = tuple(tables[where[k]].labels[layers[k].label[i]] for k, i in enumerate(path))
    times = np.array([edges[k].at(path[k], path[k + 1]) for k in range(len(problem.legs))])
    return Route(q, w, labels, times, cost)
