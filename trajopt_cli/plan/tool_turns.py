"""How far tools are turned that may be turned about their axis: what the least time is found at, at the rail positions
of a route at hand.

First a ladder: at every waypoint sampled turns, with all configurations of each, and the fastest route through them by
dynamic programming, a station in one turn. Cheap times of the legs leave a few states of each waypoint, and these are
timed along their ways. Then a pattern search: the turns of one group, or of neighbours together, in steps that shrink
until nothing is gained, with the runs beside them timed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from trajopt_cli.collision.collision_scene import CollisionScene, collision_scene_of
from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.graph_search.search import best_route
from trajopt_cli.path_timing.edge_times import Pairs, Times, leg_times
from trajopt_cli.path_timing.path_parameterized_plan import about
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.problem import Leg, LegKind, Problem, Waypoint
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.problem.tool_turns import STEP, TurnGroups, keeps_axis
from trajopt_cli.timing.double_integrator import mean_ramp, trapezoid_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import IkBranch, Route

_SAMPLE = np.radians(15.0)  # rad between sampled turns, as Descartes has them by default.
_LOOKS = 8  # times as many of which are held against what they may touch.
_FEW = 24  # states of a waypoint that are timed along their ways.
_STEPS = np.radians([8.0, 3.0, 1.0, 0.3])  # rad by which turns are shifted.
_ROUNDS = 30  # of shifts at most.
_TOGETHER = 3  # neighbouring groups at most that are shifted together.
_WORTH = 1e-5  # s that a shift must save.
_CALM = 2e-4  # s per radian of each waypoint's turn that is charged: of equally fast ones the nearest to as taught.
_MOST_LEGS = 6_000  # that are timed in the pattern search at most, about.


@dataclass(frozen=True, eq=False)
class _States:
    """What a waypoint may be passed in: axes q (m, n), turns angle (m,) [rad], branches cfx (m,), -1 for none."""

    q: Array
    angle: Array
    cfx: IndexArray

    def only(self, these: IndexArray | BoolArray) -> _States:
        return _States(self.q[these], self.angle[these], self.cfx[these])


def sampled(groups: TurnGroups, step: float = _SAMPLE) -> list[Array]:
    """Sampled turns [rad] of each group: whole multiples of a step within what it allows."""
    ends = [(int(np.ceil(one.free.low / step - 1e-6)), int(one.free.high / step + 1e-6)) for one in groups.groups]
    turns = [np.asarray(np.arange(low, high + 1) * step, dtype=np.float64) for low, high in ends]
    return [one[:-1] if len(one) * step > 2 * np.pi + step / 2 else one for one in turns]  # half a turn either way


def reachable(groups: TurnGroups, why_not: Callable[[dict[int, float]], Infeasible | None]) -> dict[int, float] | None:
    """Turns [rad], by motion, with which all that cannot be reached as taught can be, each group as little as possible;
    None where there are none. why_not: the first motion that cannot be reached with turns, None for none."""
    angles, left = np.zeros(len(groups.groups)), [[*sorted(one, key=abs)] for one in sampled(groups)]
    number = {groups.problem.waypoints[k].motion: i for k, i in enumerate(groups.of) if i >= 0}
    while (out := why_not(groups.turns(angles))) is not None:
        i = number.get(out.index, -1)
        if i < 0 or len(left[i]) < 2:
            return None
        left[i].pop(0)
        angles[i] = left[i][0]
    return groups.turns(angles)


def best_sampled_turns(
    axes: Axes, groups: TurnGroups, route: Route, by_way: bool = False
) -> tuple[Array, Route | None]:
    """Turns (groups,) [rad] of the fastest route through sampled ones that touches nothing, the rail as in a route, and
    that route; None where there is none. by_way: of the route in which the joints go least far instead (Descartes'
    ladder graph), whatever time that takes and whatever it touches."""
    problem, turns = groups.problem, sampled(groups)
    states = [_states(axes, groups, k, route, turns) for k in range(len(problem.waypoints))]
    edges = [_cheap(axes, groups, k, states[k], states[k + 1], by_way) for k in range(len(problem.legs))]
    if not by_way:
        around, through = collision_scene_of(problem), _through(edges)
        few = [_few(problem, k, one, through[k], around) for k, one in enumerate(states)]
        edges = [edge[np.ix_(a, b)] for edge, a, b in zip(edges, few, few[1:], strict=False)]
        states = [one.only(kept) for one, kept in zip(states, few, strict=True)]
        edges = _timed(axes, groups, states, edges, around)
    out = np.zeros(len(groups.groups))
    often = sorted(range(len(out)), key=lambda i: -len(groups.groups[i].waypoints))
    for i in often:  # the group's waypoints need not follow each other: the turn that costs least in all of them
        through, at = _through(edges), groups.groups[i].waypoints
        tried = np.unique(np.concatenate([states[k].angle for k in at]))
        if not len(tried):
            return out, None
        costs = [
            sum(float(np.min(through[k][states[k].angle == angle], initial=np.inf)) for k in at) for angle in tried
        ]
        out[i] = tried[int(np.argmin(costs))]
        for k in at:
            keeps = states[k].angle == out[i]
            if k < len(edges):
                edges[k] = np.where(keeps[:, None], edges[k], np.inf)
            if k > 0:
                edges[k - 1] = np.where(keeps[None], edges[k - 1], np.inf)
    cost, path = best_route([one.q for one in states], edges, (), [one.q for one in states], 0)
    if not np.isfinite(cost):
        return out, None
    q = np.array([one.q[i] for one, i in zip(states, path, strict=True)])
    labels = tuple(IkBranch(int(one.cfx[i]), np.zeros(6)) for one, i in zip(states, path, strict=True))
    times = np.array([edge[i, j] for edge, i, j in zip(edges, path, path[1:], strict=False)])
    return out, Route(q, np.zeros_like(q), labels, times, cost)


def _states(axes: Axes, groups: TurnGroups, k: int, route: Route, turns: Sequence[Array]) -> _States:
    """All configurations of a waypoint in all its turns, with whole turns of the joints."""
    point, number = groups.problem.waypoints[k], groups.of[k]
    if point.q is not None:
        return _States(point.q[None], np.zeros(1), np.array([-1]))
    checkpoint()
    angles = turns[number] if number >= 0 else np.zeros(1)
    X_WF = np.array([groups.waypoint(k, float(angle)).X_WF for angle in angles])
    rail = route.q[k, axes.layout.rail]
    arm = axes.inverse(X_WF, np.tile(rail, (len(angles), 1)))  # (t, b, 6)
    span = (axes.upper - axes.lower)[axes.layout.arm]
    more = np.array([*product(*((-1, 0, 1) if wide > 2 * np.pi else (0,) for wide in span))]) * 2 * np.pi
    every = arm[:, :, None] + more
    angle = np.broadcast_to(angles[:, None, None], every.shape[:3]).ravel()
    cfx = np.broadcast_to(np.arange(arm.shape[1])[None, :, None], every.shape[:3]).ravel()
    q = axes.layout.merge(np.broadcast_to(rail, (every[..., 0].size, len(rail))), every.reshape(-1, every.shape[-1]))
    kept = axes.within(q)
    own = np.abs(q - route.q[k]).max(axis=1) < 1e-6
    return _States(q, angle, cfx).only(kept | own)


def _cheap(axes: Axes, groups: TurnGroups, k: int, a: _States, b: _States, by_way: bool) -> Array:
    """(m_a, m_b) about what leg k takes [s], infinite where it cannot be; by_way: how far the joints go [rad]."""
    checkpoint()
    problem, leg = groups.problem, groups.problem.legs[k]
    V, A = axes.velocity_on(leg), axes.usual_acceleration * leg.acceleration
    way, slow, hard, far = (np.zeros((len(a.q), len(b.q))) for _ in range(4))
    for j in range(axes.n):
        span = np.abs(b.q[None, :, j] - a.q[:, None, j])
        np.maximum(far, span, out=far)
        np.maximum(slow, span / V[j], out=slow)
        np.maximum(hard, span / A[j], out=hard)
        way += span * (j >= axes.layout.arm.start)
    points = [(problem.waypoints[i].X_WF @ leg.X_FT)[:3, 3] for i in (k, k + 1)]
    chord = leg.chord or float(np.linalg.norm(points[1] - points[0]))
    if leg.kind is LegKind.JOINT:
        T = np.where(slow * slow > hard, slow + hard / np.maximum(slow, 1e-12), 2 * np.sqrt(hard))
        T = np.maximum(T, trapezoid_time(chord, leg.v_tcp, mean_ramp(*leg.ramps)))
        if (led := problem.leads(k, a.q, b.q)) is not None:
            T = np.where(led, T, np.inf)
    else:
        alike = np.abs(a.angle[:, None] - b.angle[None]) < STEP / 2
        if k in groups.apart and -1 in groups.of[k : k + 2]:  # from where it stays as taught to any turn
            alike[:] = True
        branch = (a.cfx[:, None] == b.cfx[None]) | (a.cfx < 0)[:, None] | (b.cfx < 0)[None]
        can = alike & branch & (far < np.pi)
        T = np.where(can, np.maximum(slow, chord / leg.v_tcp), np.inf)
    if by_way:
        return np.where(np.isfinite(T), way, np.inf)
    return np.maximum(T, leg.duration or leg.least) + _CALM * np.abs(b.angle)


def _through(edges: Sequence[Array]) -> list[Array]:
    """The least cost (m,) of a route through every state."""
    forward, backward = [np.zeros(len(edges[0]))], [np.zeros(edges[-1].shape[1])]
    for edge in edges:
        forward.append((forward[-1][:, None] + edge).min(axis=0, initial=np.inf))
    for edge in reversed(edges):
        backward.append((backward[-1][None] + edge).min(axis=1, initial=np.inf))
    return [a + b for a, b in zip(forward, reversed(backward), strict=True)]


def _few(problem: Problem, k: int, states: _States, cost: Array, around: CollisionScene | None) -> IndexArray:
    """The states that are looked at more closely: the best ones of those that touch nothing."""
    order = np.argsort(cost, kind="stable")
    order = order[np.isfinite(cost[order])][: _FEW * (1 if around is None else _LOOKS)]
    if around is not None:
        order = order[around.free(states.q[order], problem.legs[max(k - 1, 0)].motion)]
    return np.asarray(np.sort(order[:_FEW]))


def _timed(
    axes: Axes, groups: TurnGroups, states: Sequence[_States], cheap: Sequence[Array], around: CollisionScene | None
) -> list[Array]:
    """(m_a, m_b) least times of all legs between few states, along their ways; infinite on a joint move that touches
    something."""
    parts: list[tuple[int, float, float]] = []
    asked: list[tuple[int, IndexArray, IndexArray, int]] = []
    for k, (a, b, edge) in enumerate(zip(states, states[1:], cheap, strict=False)):
        i, j = np.nonzero(np.isfinite(edge))
        leg = groups.problem.legs[k]
        if leg.kind is LegKind.JOINT:
            if around is not None:
                clear = around.free_between(a.q[i], b.q[j], leg.motion)
                i, j = i[clear], j[clear]
            parts.append((k, 0.0, 0.0))
            asked.append((k, i, j, -1))
            continue
        cfx = np.maximum(a.cfx[i], b.cfx[j])  # -1 where joints are given
        for first, last, branch in {*zip(a.angle[i].tolist(), b.angle[j].tolist(), cfx.tolist(), strict=True)}:
            own = (a.angle[i] == first) & (b.angle[j] == last) & (cfx == branch)
            parts.append((k, first, last))
            asked.append((k, i[own], j[own], max(branch, 0)))
    problem, firsts, good = _laid_out(groups, [((k, k + 1), {k: a, k + 1: b}) for k, a, b in parts])
    pairs = [Pairs(n, states[k].q[i], states[k + 1].q[j], cfx)
             for n, (k, i, j, cfx) in zip(firsts, asked, strict=True)]  # fmt: skip
    out = [np.full_like(edge, np.inf) for edge in cheap]
    for (k, i, j, _), T, can in zip(asked, leg_times(axes, problem, pairs, Times()), good, strict=True):
        out[k][i, j] = T + _CALM * np.abs(states[k + 1].angle[j]) if can else np.inf
    return out


def _laid_out(
    groups: TurnGroups, parts: Iterable[tuple[tuple[int, int], dict[int, float]]]
) -> tuple[Problem, list[int], list[bool]]:
    """Stretches of the problem, each from a first waypoint to a last one with turns [rad] of its own, one behind the
    other as one problem; the number of each one's first waypoint in it; and whether the tool's axis stays in each."""
    waypoints, legs, firsts, good = list[Waypoint](), list[Leg](), list[int](), list[bool]()
    for (first, last), angles in parts:
        firsts.append(len(waypoints))
        can = True
        for k in range(first, last + 1):
            point = groups.waypoint(k, angles.get(k, 0.0))
            if k > first:
                leg = groups.leg(k - 1, waypoints[-1], angles.get(k, 0.0))
                free = getattr(groups.problem.motion(leg.motion), "free", None)
                can &= free is None or keeps_axis(groups.problem.legs[k - 1], leg, free)
                legs.append(replace(leg, start=len(waypoints) - 1))
            waypoints.append(point)
        legs.append(replace(groups.problem.legs[first], start=len(waypoints) - 1))  # to the next stretch; never asked
        good.append(can)
    whole = replace(groups.problem, waypoints=tuple(waypoints), legs=tuple(legs[:-1]), stations=(), ties=())
    return whole, firsts, good


class _Shifts:
    """A pattern search for the turns of groups, the rail and configurations as in a route."""

    def __init__(self, axes: Axes, groups: TurnGroups, route: Route, angles: Array):
        self._axes, self._groups, self._route, self._start, self.left = axes, groups, route, angles, _MOST_LEGS
        self._cfx = np.array([label.cfx for label in route.labels])
        self._around = collision_scene_of(groups.problem)
        runs = groups.problem.runs
        self._runs = [run for run in runs if any(groups.of[k] >= 0 for k in range(run[0], run[1] + 1))]
        self._known: dict[tuple[tuple[int, int], tuple[float, ...]], float] = {}

    def refined(self) -> Array:
        """Turns (groups,) [rad] at which the runs take least time together."""
        count = len(self._groups.groups)
        i, j, at = np.ogrid[:count, 1 : _TOGETHER + 1, :count]
        ways = np.unique(((i <= at) & (at < i + j)).reshape(-1, count).astype(float), axis=0)
        ways = np.concatenate([ways, -ways])
        low, high = np.array([(one.free.low, one.free.high) for one in self._groups.groups]).T
        angles = self._start
        best = float(self._times(angles[None])[0])
        step = 0
        for _ in range(_ROUNDS):
            if self.left <= 0 or step == len(_STEPS) or not np.isfinite(best):
                break
            tried = np.clip(angles + ways * _STEPS[step], low, high)
            times = self._times(tried)
            gains = np.flatnonzero(times < best - _WORTH)
            if not len(gains):
                step += 1
                continue
            order = gains[np.argsort(times[gains], kind="stable")]
            together = 0 * angles  # all shifts that gain, of groups of their own
            for shift in tried[order] - angles:
                together += shift * (not np.any(together[shift != 0]))
            moves = np.array([tried[order[0]], np.clip(angles + together, low, high)])
            times = self._times(moves)
            angles, best = moves[int(np.argmin(times))], float(times.min())
        return angles

    def route_at(self, angles: Array) -> Route:
        """The route with turns (groups,) [rad]."""
        of, every = self._groups.of, np.arange(len(self._route.q))
        points = [self._groups.waypoint(k, float(angles[of[k]]) if of[k] >= 0 else 0.0) for k in every.tolist()]
        return replace(self._route, q=self._axes_at(points, every))

    def _times(self, angles: Array) -> Array:
        """How long the runs take together (m,) with turns (m, groups); infinite where that cannot be."""
        of = self._groups.of
        own = {run: [of[k] for k in range(run[0], run[1] + 1)] for run in self._runs}
        names = [
            [(run, tuple(0.0 if i < 0 else float(one[i]) for i in own[run])) for run in self._runs] for one in angles
        ]
        asked = [*dict.fromkeys(name for one in names for name in one if name not in self._known)]
        if asked:
            parts = [(run, dict(zip(range(run[0], run[1] + 1), turns, strict=True))) for run, turns in asked]
            problem, firsts, good = _laid_out(self._groups, parts)
            every = np.concatenate([np.arange(run[0], run[1] + 1) for run, _ in asked])
            q = self._axes_at(problem.waypoints, every)
            whole = [(first, first + run[1] - run[0]) for first, (run, _) in zip(firsts, asked, strict=True)]
            can = [ok and bool(np.isfinite(q[a : b + 1]).all()) for ok, (a, b) in zip(good, whole, strict=True)]
            can = [ok and self._clear(problem, q, run) for ok, run in zip(can, whole, strict=True)]
            driven = [run for run, ok in zip(whole, can, strict=True) if ok]
            cfx = tuple(self._cfx[every].tolist())
            times = iter(about(self._axes, problem, driven, [q] * len(driven), cfx) if driven else ())
            self._known |= {name: float(next(times)) if ok else np.inf for name, ok in zip(asked, can, strict=True)}
            self.left -= sum(b - a for a, b in driven)
        calm = _CALM * np.abs(angles) @ [len(one.waypoints) for one in self._groups.groups]
        return np.asarray(calm + [sum(self._known[name] for name in one) for one in names])

    def _clear(self, problem: Problem, q: Array, run: tuple[int, int]) -> bool:
        """Whether a run touches nothing at its waypoints and on its straight joint moves."""
        legs = problem.legs[run[0] : run[1]]
        if self._around is None:
            return True
        if not self._around.free(q[run[0] + 1 : run[1] + 1], np.array([leg.motion for leg in legs])).all():
            return False
        joint = [leg for leg in legs if leg.kind is LegKind.JOINT]
        first = np.array([leg.start for leg in joint], dtype=np.intp)
        motions = np.array([leg.motion for leg in joint], dtype=np.intp)
        return not joint or bool(self._around.free_between(q[first], q[first + 1], motions).all())

    def _axes_at(self, points: Sequence[Waypoint], every: IndexArray) -> Array:
        """Axes (m, n) at waypoints that stand for those numbered every (m,), on their branches; NaN for none."""
        checkpoint()
        axes, near = self._axes, self._route.q[every]
        rail = near[:, axes.layout.rail]
        arm = axes.branch(np.array([point.X_WF for point in points]), rail, np.maximum(self._cfx[every], 0))
        arm += 2 * np.pi * np.round((near[:, axes.layout.arm] - arm) / (2 * np.pi))
        q = axes.layout.merge(rail, arm)
        q = np.where(axes.within(q)[:, None], q, np.nan)
        fixed = [i for i, point in enumerate(points) if point.q is not None]
        q[fixed] = near[fixed]
        return q


def refined_turns(axes: Axes, groups: TurnGroups, route: Route, angles: Array) -> tuple[Array, Route]:
    """Turns (groups,) [rad] near those at hand that the least time is found at, in whole steps of what a text says, and
    the route with them. route: through the waypoints as they are turned now."""
    shifts = _Shifts(axes, groups, route, angles)
    found = shifts.refined()
    low, high = np.array([(one.free.low, one.free.high) for one in groups.groups]).T
    steps = np.clip(np.round(found / STEP), np.ceil(low / STEP - 1e-6), np.floor(high / STEP + 1e-6))
    angles = np.clip(steps * STEP, low, high)
    return angles, shifts.route_at(angles)


def route_time(axes: Axes, problem: Problem, route: Route) -> float:
    """What a route takes [s], every run timed on a few nodes; infinite where it cannot be driven."""
    runs, cfx = problem.runs, tuple(label.cfx for label in route.labels)
    return float(about(axes, problem, runs, [route.q] * len(runs), cfx).sum())


def stays_at_wrist(axes: Axes, groups: TurnGroups) -> bool:
    """Whether turns leave the first three joints as they are: the tools' axes lead through the centre of the wrist."""
    known: dict[tuple[bytes, tuple[float, ...]], bool] = {}
    for group in groups.groups:
        for k, X_FT in zip(group.waypoints, group.X_FT, strict=True):
            name = X_FT.tobytes(), group.free.axis
            if name in known:
                continue
            X_WF = np.array([groups.waypoint(k, angle).X_WF for angle in (0.0, 0.5)])
            rail = np.mean(groups.problem.waypoints[k].ranges(axes.layout), axis=0)
            arm = np.nan_to_num(axes.inverse(X_WF, np.tile(rail, (2, 1)))[..., :3])
            known[name] = bool(np.abs(arm[0] - arm[1]).max() < 1e-6)
    return all(known.values())
