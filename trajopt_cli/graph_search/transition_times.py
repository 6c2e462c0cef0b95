"""States at the waypoints of a search, and the least times between those of one and those of the next."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.graph_search.edges import Band, Checked, Dense, Edge, Lazy
from trajopt_cli.graph_search.ik_tables import IkTable, reversed_leg
from trajopt_cli.graph_search.rail_in_waits import farthest
from trajopt_cli.problem.decision_scope import RailFreedom
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.timing.double_integrator import alone, mean_ramp, reach, shortest_time, trapezoid_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import EdgeChecks
from trajopt_cli.trajectories.limits import limits_of

_CURVED = 0.6  # share of a line's top velocity at which its curvature is charged against acceleration.
_LEAST_ROOM = 0.15  # share of each acceleration limit that is always left for that.
_PATH_SAMPLES = 6  # places on a joint move whose distances add up to the tool's way. Not measured.
_SHIFT = 0.45  # m that the rail may move on a line beyond what it can at top velocity in the tool's time.
_WIDEST = 1.0  # m from an arm's axis to its flange at most; farther ones only miss that a slow joint move is long.
_LEAST = 1e-12  # s, s2: of a leg that goes nowhere


@dataclass(frozen=True, eq=False)
class Layer:
    """States at one waypoint: axes and their velocities (m, n), label number and rail index (m,)."""

    q: Array
    qd: Array
    label: IndexArray
    rail: IndexArray

    @property
    def place(self) -> IndexArray:
        """Label and rail number (2, m)."""
        return np.stack([self.label, self.rail])


def layer_of(axes: Axes, problem: Problem, table: IkTable, i: int, k: int, speeds: Array) -> Layer:
    """The states at waypoint k, number i of a station's table, at rail speeds (m, r) where the rail may pass."""
    arm = table.waypoints[i]
    labels, rails = np.nonzero(~np.isnan(arm[..., 0]))
    stop = problem.waypoints[k]
    q = problem.axes_at(k, table.d[rails], arm[labels, rails])
    beside = [problem.legs[i] for i in (k - 1, k) if 0 <= i < len(problem.legs)]
    held = np.all([limit.holds(leg, q) for limit in limits_of(axes) for leg in beside], axis=0)
    if held.any():
        q, labels, rails = q[held], labels[held], rails[held]
    if stop.rest or stop.q is not None or stop.rail[0] == stop.rail[1] or len(speeds) == 1:
        return Layer(q, np.zeros_like(q), labels, rails)
    m = len(speeds)
    rate = axes.layout.join(np.ones(len(q)), axes.self_motion(q)[..., axes.layout.sought])
    q, labels, rails = np.repeat(q, m, axis=0), np.repeat(labels, m), np.repeat(rails, m)
    qd = np.repeat(rate, m, axis=0) * np.tile(speeds, len(rate))[:, None]
    ok = np.all(np.abs(qd) <= axes.velocity + 1e-12, axis=1)
    return Layer(q[ok], qd[ok], labels[ok], rails[ok])


def joint_edge(axes: Axes, problem: Problem, k: int, a: Layer, b: Layer) -> Edge:
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


def _slowest_axes(a: Layer, b: Layer, V: Array, A: Array, states: int) -> list[int]:
    """The axes that take longest between some of the states where each goes by itself."""
    some_a, some_b = (slice(None, None, max(1, len(x.q) // states)) for x in (a, b))
    times = [_axis_time(a, b, V, A, some_a, some_b, j) for j in range(len(V))]
    return [int(j) for j in np.unique(np.argmax(times, axis=0))]


def _axis_time(a: Layer, b: Layer, V: Array, A: Array, i: slice, k: slice, j: int) -> Array:
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


def most_rail_travel(axes: Axes, problem: Problem, k: int, far: bool) -> float:
    """How far the rail is asked to go [m] along line k, which it hardly holds back then; far: however long it takes."""
    leg = problem.legs[k]
    if not leg.rail_moves or problem.freedom.rail is RailFreedom.STATION:
        return 0.0
    cruise = max(leg.chord / leg.v_tcp + leg.angle / leg.v_ori, leg.duration or leg.least, leg.positioner_use[0])
    beyond = 0.0 if problem.passes(k) and problem.passes(k + 1) else _SHIFT
    return np.inf if far else beyond + float(axes.layout.place(axes.velocity_on(leg))) * cruise


def _line_times(
    axes: Axes, problem: Problem, table: IkTable, i: int, k: int, a: Layer, b: Layer, far: bool = False
) -> Band:
    """Estimated times of a line, leg k and number i of its station, with the rail linear in the path, whatever the
    rates of the states. far: as in _search."""
    leg = problem.legs[k]
    raw = table.raw[i]
    assert raw is not None
    d, n, nodes = table.d, len(table.d), raw.shape[1]
    V, A = axes.velocity_on(leg), axes.usual_acceleration
    spacing = (d[-1] - d[0]) / max(n - 1, 1)
    widest = int(np.ceil(min(most_rail_travel(axes, problem, k, far) / max(spacing, 1e-9), n - 1)))
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


def _line_edge(axes: Axes, leg: Leg, band: Band, a: Layer, b: Layer) -> Edge:
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


def _dwell_time(axes: Axes, problem: Problem, leg: Leg, d: Array, arm: Array, a: Layer, b: Layer) -> Array:
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


def edges_of(
    axes: Axes, problem: Problem, tables: list[IkTable], where: list[int], layers: list[Layer],
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
            edges.append(joint_edge(axes, problem, k, a, b))
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
