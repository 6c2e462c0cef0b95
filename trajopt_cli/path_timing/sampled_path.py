"""Where a run leads all axes: its parts in order, with derivatives along them, for given axes at its waypoints.

The axes fraction one progress. A leg is cut where its formula changes: half of the corner before it, its own path, half
of the corner behind it, and where the rail has left its own corner. The parameter sigma goes on through the whole run
with continuous first derivatives: it counts the metres of a line or an arc, and a joint move in the measure that the
corner beside it asks for. Second derivatives jump between parts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.joint_corner import JointCorner
from trajopt_cli.path.joint_move import JointMove
from trajopt_cli.path.segment import JointSegment, Segment
from trajopt_cli.path_timing.path_derivatives import PathDerivatives, PathPart, Rail, axes_along, joined, on_paths
from trajopt_cli.problem.problem import LegKind, Problem
from trajopt_cli.rapid.zones import NO_WAY
from trajopt_cli.trajectories.axes import Axes

_SHRINKS = 40  # times at most. What a corner strays goes with its square: of 0.9 um beside 0.1 rad it took 20.
_SPHERE = 1 + 1e-06  # times the zone's radius that they may be away.
_SHRINK = 0.8  # a corner of all axes that leaves its zone is made smaller by this.

_RAMP_HALVINGS = 6  # of the step beside a stop. At v50 on 140 mm a stop cost 30 ms without, 3 ms with them.
_SHORT = 1e-9  # of a path, or of its parameter: no part of it
_SLIVER = 1e-6  # fraction of a path between two corners: no part of it; a corner goes on along its own segments
_APART = 1e-4  # rad, m: axes of two parts that are not one place


@dataclass(frozen=True, eq=False)
class SampledPath:
    """A run's parts, and what is along them at their nodes, part by part: a place between two parts is there twice.

    q (M, n): axes at all waypoints of the problem. rests: nodes at rest besides both ends.
    """

    parts: tuple[PathPart, ...]
    along: PathDerivatives
    q: Array
    rests: tuple[int, ...] = ()

    @cached_property
    def counts(self) -> IndexArray:
        """Intervals of each part (P,)."""
        return np.array([part.N for part in self.parts])

    @cached_property
    def part(self) -> IndexArray:
        """Number of the part of each interval (N,)."""
        return np.repeat(np.arange(len(self.parts)), self.counts)

    @cached_property
    def leg(self) -> IndexArray:
        """Number of the leg of each interval (N,)."""
        return np.array([part.leg for part in self.parts])[self.part]

    @cached_property
    def first(self) -> IndexArray:
        """Row of `along` where each interval begins (N,); it ends in the next one."""
        return np.arange(len(self.part)) + self.part

    @cached_property
    def begins(self) -> list[int]:
        """Row of `along` where each part begins."""
        return [0, *np.cumsum(self.counts + 1).tolist()]

    @cached_property
    def sigma(self) -> Array:
        """The parameter where intervals meet (N+1,), 0 at the run's start."""
        steps = [part.size * np.diff(part.u) for part in self.parts]
        return np.concatenate([[0.0], np.cumsum(np.concatenate(steps))])


def sample_path(
    axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int], nodes: int, ramps: bool = True
) -> SampledPath | None:
    """The path of a run, given as its first and last waypoint. q (M, n), cfx: axes and branches at all waypoints of
    the problem, those of a fly-by at its point. nodes: intervals of a leg, about. ramps: with more of them beside stops
    of a run with corners. None where the arm cannot follow.
    """
    return sample_paths(axes, problem, [run], [q], cfx, [nodes], ramps)[0]


def sample_paths(
    axes: Axes, problem: Problem, runs: Sequence[tuple[int, int]], q: Sequence[Array], cfx: Sequence[int],
    nodes: Sequence[int], ramps: bool = True,
) -> list[SampledPath | None]:  # fmt: skip
    """The same of many runs, each between axes of its own; the same run may be there more than once."""
    known: Known = {}
    cuts = [
        _RunParts(axes, problem, run, own, cfx, N, known, ramps).parts()
        for run, own, N in zip(runs, q, nodes, strict=True)
    ]
    found = iter(_sampled(axes, problem, [(parts, own) for parts, own in zip(cuts, q, strict=True) if parts]))
    return [next(found) if parts else None for parts in cuts]


def finer(axes: Axes, problem: Problem, path: SampledPath, wanted: BoolArray) -> SampledPath | None:
    """The same path with a node in the middle of every interval that is wanted (N,)."""
    parts = []
    for i, part in enumerate(path.parts):
        middles = (part.u[:-1] + part.u[1:]) / 2
        parts.append(replace(part, u=np.sort(np.r_[part.u, middles[wanted[path.part == i]]])))
    return _sampled(axes, problem, [(parts, path.q)])[0]


def _sampled(
    axes: Axes, problem: Problem, runs: Sequence[tuple[Sequence[PathPart], Array]]
) -> list[SampledPath | None]:
    """The paths of runs cut into parts, each with axes at all waypoints of its own."""
    if not runs:
        return []
    along = axes_along(axes, problem, runs)
    nodes = [sum(part.N + 1 for part in parts) for parts, _ in runs]
    edges = np.concatenate([[0], np.cumsum(nodes)])
    every = [along.at(slice(a, b)) for a, b in pairwise(edges.tolist())]
    return [
        SampledPath(tuple(parts), own, q) if _can_follow(parts, own, q) else None
        for (parts, q), own in zip(runs, every, strict=True)
    ]


def _can_follow(parts: Sequence[PathPart], along: PathDerivatives, q: Array) -> bool:
    """Whether the arm reaches all places, and need not jump from part to part."""
    if not all(np.isfinite(x).all() for x in (along.q, along.dq, along.ddq)):
        return False
    behind = np.cumsum([part.N + 1 for part in parts])
    begins = np.vstack([along.q[np.r_[0, behind[:-1]]], q[parts[-1].leg + 1]])
    ends = np.vstack([q[parts[0].leg], along.q[behind - 1]])
    return bool(np.abs(begins - ends).max() < _APART)


def together(paths: Sequence[SampledPath]) -> SampledPath:
    """Paths one after the other as one, at rest where one ends and the next begins; it has no axes at waypoints."""
    if len(paths) == 1:
        return paths[0]
    parts = tuple(part for path in paths for part in path.parts)
    ends = np.cumsum([len(path.part) for path in paths])
    return SampledPath(parts, joined([path.along for path in paths]), paths[0].q[:0], tuple(ends[:-1].tolist()))


@dataclass(frozen=True, eq=False)
class _CornerAt:
    """The corner at a waypoint: the fractions of the legs before and behind it that it replaces, and those in which
    the rail is bent by itself (0 where the corner is one of all axes)."""

    corner: Corner | JointCorner
    before: float
    after: float
    rail_before: float = 0.0
    rail_after: float = 0.0


Known = dict[tuple[int, bytes], Any]  # corners and joint moves by their number and the axes beside them


class _RunParts:
    """A run cut into parts. known: of other runs; what is made here is added."""

    def __init__(
        self, axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int], nodes: int,
        known: Known, ramps: bool,
    ):  # fmt: skip
        self._axes, self._problem, self._q, self._cfx, self._nodes, self._known = axes, problem, q, cfx, nodes, known
        self._ramps, self._smooth = ramps, axes.jerk is not None
        self._first, self._last = run
        self._paths = {k: self._path(k) for k in range(*run)}

    def parts(self) -> list[PathPart] | None:
        """The parts in order; None where a corner's joints are not to be had."""
        corners: dict[int, _CornerAt] = {}
        for k in range(self._first + 1, self._last):
            corner = self._corner(k)
            if corner is None:
                return None
            corners[k] = corner
        out: list[PathPart] = []
        measure, half = self._measure(self._first), 0.0
        for k in range(self._first, self._last):
            if k in corners:  # both halves of a corner are equally much sigma
                measure = half / corners[k].after
            out += self._leg(k, corners.get(k), corners.get(k + 1), measure)
            half = measure * corners[k + 1].before if k + 1 in corners else 0.0
        return out

    def _path(self, k: int) -> Segment | JointSegment:
        """Where leg k leads."""
        if self._problem.legs[k].kind is LegKind.JOINT:
            return self._once(k, self._q[k : k + 2], lambda: JointMove(self._q[k], self._q[k + 1]))
        return self._problem.segment(k)

    def _once(self, k: int, q: Array, make: Callable[[], Any]) -> Any:
        """What is made of a leg or a waypoint and axes q beside it, the same for all runs that have them alike."""
        name = k, q.tobytes()
        if name not in self._known:
            self._known[name] = make()
        return self._known[name]

    def _measure(self, k: int) -> float:
        """What a leg's zones count, and how much sigma the run's first leg is: metres of the tool's path, radians of a
        turn in place, 1 for what is neither."""
        leg = self._problem.legs[k]
        return leg.chord if leg.chord >= NO_WAY else leg.angle if leg.angle > NO_WAY else 1.0

    # ---- a leg's parts
    def _leg(self, k: int, start: _CornerAt | None, end: _CornerAt | None, measure: float) -> Iterator[PathPart]:
        """The parts of leg k between the middles of its corners."""
        settings = self._axes.settings
        t_0, t_1 = (start.after if start else 0.0), 1 - (end.before if end else 0.0)
        nodes = self._nodes * (self._part_of_long(k) if start and end else 1.0)
        cuts = {0.0, t_0, t_1, 1.0}
        if start:
            cuts |= {start.rail_after, *(start.after * (2 * s - 1) for s in start.corner.breaks if s > 0.5)}
        if end:
            cuts |= {1 - end.rail_before, *(1 - end.before * (1 - 2 * s) for s in end.corner.breaks if s < 0.5)}
        for a, b in pairwise(_distinct(cuts)):
            middle = (a + b) / 2
            segment: Segment | JointSegment = self._paths[k]
            own = a, b
            if start and middle < t_0:
                segment, own = start.corner, (0.5 + a / t_0 / 2, 0.5 + b / t_0 / 2)
            elif end and middle > t_1:
                segment, own = end.corner, ((a - t_1) / (1 - t_1) / 2, (b - t_1) / (1 - t_1) / 2)
            corner = segment is not self._paths[k]
            N = settings.corner_nodes if corner else max(settings.corner_nodes, round(nodes * (b - a)))
            joints = isinstance(segment, JointSegment)
            rail = None if joints else self._rail(k, start, end, a, b)
            if b - a == 1.0:
                u = spaced(N, settings.end_spacing)
            else:
                u = np.linspace(0.0, 1.0, N + 1)
                u = _with_ramps(u, a == 0.0 and not start, b == 1.0 and not end) if self._ramps else u
            yield PathPart(k, segment, *own, measure * (b - a), u, rail, -1 if joints else self._branch(k))

    def _part_of_long(self, k: int) -> float:
        """What part of a line or an arc that has all its nodes a shorter one is; 1 of other legs."""
        settings = self._axes.settings
        leg = self._problem.legs[k]
        return (
            min(1.0, max(leg.chord / settings.long_line, leg.angle / settings.long_turn))
            if leg.kind is LegKind.LINE
            else 1.0
        )

    def _branch(self, k: int) -> int:
        return self._cfx[k] if self._cfx[k] >= 0 else self._cfx[k + 1]

    def _rail(self, k: int, start: _CornerAt | None, end: _CornerAt | None, a: float, b: float) -> Rail:
        """The rail from fraction a to b of leg k: in proportion to the path, between its corners."""
        d_0, span, h = self._d(k), self._d(k + 1) - self._d(k), b - a
        middle = (a + b) / 2
        if start and middle < start.rail_after:
            zone, before, after, place = start.rail_after, self._slope_in(k, k - 1), span, a
            d_P = d_0
        elif end and middle > 1 - end.rail_before:
            zone, before, after, place = end.rail_before, span, self._slope_in(k, k + 1), a - 1
            d_P = d_0 + span
        else:
            return Rail.straight(d_0 + span * a, span * h)
        # over both edges of the zone the one travel comes to rest at the point as the other gathers speed
        x = 0.5 + place / (2 * zone), h / (2 * zone)
        left, right = (_gathered(*ends, self._smooth) for ends in ((1 - x[0], -x[1]), x))
        c = [zone * (after * gained - before * left_over) for left_over, gained in zip(left, right, strict=True)]
        return Rail(d_P + c[0], *c[1:])

    def _d(self, k: int) -> Array:
        return np.asarray(self._q[k, self._axes.layout.rail])

    def _slope_in(self, k: int, other: int) -> Array:
        """The rail's travel per metre on another leg, in the measure of leg k."""
        return np.asarray((self._d(other + 1) - self._d(other)) * self._measure(k) / self._measure(other))

    # ---- corners
    def _corner(self, k: int) -> _CornerAt | None:
        """The corner at waypoint k, between legs k - 1 and k."""
        zone = self._problem.waypoints[k].fly_by
        assert zone is not None
        before, after = self._paths[k - 1], self._paths[k]
        if zone.joint or isinstance(before, JointSegment) or isinstance(after, JointSegment):
            found: _CornerAt | None = self._once(k, self._q[k - 1 : k + 2], lambda: self._joint_corner(k, zone.radius))
            return found
        sides = self._measure(k - 1), self._measure(k)

        def make() -> Corner:
            if zone.in_place:
                return Corner(before, after, zone.turning / sides[0], zone.turning / sides[1], smooth=self._smooth)
            return Corner.of_zone(before, after, zone.radius, zone.turning, self._smooth)

        corner: Corner = self._once(k, self._q[:0], make)
        rail_before, rail_after = (zone.external / side for side in sides)
        return _CornerAt(corner, corner.fraction_before, corner.fraction_after, rail_before, rail_after)

    def _joint_corner(self, k: int, radius: float) -> _CornerAt | None:
        """A corner of all axes, small enough that the tool stays within its zone. Where another one takes over, the
        first stays within it in its half, and the other comes no farther from its point than where the corner begins.
        """
        settings = self._axes.settings
        sides = ((k - 1, True), (k, False))
        tools = [self._problem.legs[leg].X_FT for leg, _ in sides]
        points = [(self._problem.waypoints[k].X_WF @ X_FT)[:3, 3] for X_FT in tools]
        fractions = []
        for (leg, end), X_FT, point in zip(sides, tools, points, strict=True):
            path = self._paths[leg]
            if isinstance(path, JointSegment):
                fractions.append(_reaching(self._axes, path, X_FT, point, radius, end))
            else:
                fractions.append(radius / self._measure(leg))
        for _ in range(_SHRINKS):
            states = [self._state(k - 1, 1 - fractions[0]), self._state(k, fractions[1])]
            if any(np.isnan(q).any() for q, _, _ in states):
                return None
            (q_0, rate_0, bend_0), (q_1, rate_1, bend_1) = states
            f_0, f_1 = (2 * fraction for fraction in fractions)
            bends = np.stack([f_0**2 * bend_0, f_1**2 * bend_1]) if self._smooth else None
            corner = JointCorner(q_0, f_0 * rate_0, q_1, f_1 * rate_1, bends)
            halves = np.array_split(self._axes.forward(corner.axes(np.linspace(0, 1, settings.sphere_samples))), 2)
            first, last = (
                float(np.linalg.norm((X_WF @ X_FT)[:, :3, 3] - point, axis=1).max())
                for X_WF, X_FT, point in zip(halves, tools, points, strict=True)
            )
            begins = 0.0
            if not np.array_equal(tools[0], tools[1]):
                begins = float(np.linalg.norm((halves[0][0] @ tools[1])[:3, 3] - points[1]))
            if first <= radius * _SPHERE and last <= max(radius, begins) * _SPHERE:
                return _CornerAt(corner, *fractions)
            fractions = [fraction * _SHRINK for fraction in fractions]
        return None

    def _state(self, k: int, fraction: float) -> tuple[Array, Array, Array]:
        """Axes (n,) at a fraction of leg k, and their derivatives by it."""
        path, t = self._paths[k], np.array([fraction])
        if isinstance(path, JointSegment):
            return path.axes(t)[0], path.rate(t)[0], path.rate_change(t)[0]
        rail = Rail.straight(self._d(k), self._d(k + 1) - self._d(k))
        part = PathPart(k, path, 0.0, 1.0, 1.0, t, rail, self._branch(k))
        near = self._q[k] + fraction * (self._q[k + 1] - self._q[k])
        along = on_paths(self._axes, self._problem, [part], [t])
        turns = 2 * np.pi * np.round((near - along.q[0]) / (2 * np.pi))
        turns[self._axes.layout.rail] = 0.0
        return along.q[0] + turns, along.dq[0], along.ddq[0]


def _gathered(x: float, dx: float, smooth: bool) -> list[float]:
    """As in path/corner.py, what part of a zone's way is done at x + u dx, as coefficients (5,) of powers of u."""
    if not smooth:
        return [x * x, 2 * x * dx, dx * dx, 0.0, 0.0]
    return [
        x**3 * (2 - x), x * x * (6 - 4 * x) * dx, 6 * x * (1 - x) * dx**2, (2 - 4 * x) * dx**3, -(dx**4),
    ]  # fmt: skip


def spaced(N: int, closer: float) -> Array:
    """Path parameters (N+1,) between two stops, closer together where the tool speeds up and slows down."""
    x = np.linspace(0.0, 1.0, N + 1)
    return np.asarray(x - closer * np.sin(2 * np.pi * x) / (2 * np.pi))


def _with_ramps(u: Array, first: bool, last: bool) -> Array:
    """Path parameters with more beside a stop at the first one and at the last: a slow ramp is shorter than a step."""
    closer = 0.5 ** np.arange(1, _RAMP_HALVINGS + 1)
    at_first, at_last = closer * u[1] if first else [], 1 - closer * (1 - u[-2]) if last else []
    return np.sort(np.r_[u, at_first, at_last])


def _distinct(cuts: set[float]) -> list[float]:
    """Cuts in order, those that are one but for rounding once: where zones meet, num's seven digits leave a sliver
    between them."""
    out = [0.0]
    for cut in sorted(cuts):
        if cut > out[-1] + (_SLIVER if out[-1] > 0 and cut < 1 else _SHORT):
            out.append(cut)
    out[-1] = 1.0
    return out


def _reaching(axes: Axes, move: JointSegment, X_FT: Array, point: Array, radius: float, end: bool) -> float:
    """Which part of a joint move, at its end or its start, lies within a radius [m] of a point (3,): half at most."""
    fraction = np.linspace(0, 0.5, axes.settings.zone_samples)
    away = np.linalg.norm(axes.tool_points(move.axes(1 - fraction if end else fraction), X_FT) - point, axis=1)
    outside = np.flatnonzero(away > radius)
    if not len(outside):
        return 0.5
    i = max(int(outside[0]), 1)
    part = (radius - away[i - 1]) / max(away[i] - away[i - 1], 1e-300)
    return float(max(fraction[i - 1] + np.clip(part, 0, 1) * (fraction[i] - fraction[i - 1]), _SHORT * 10))


# ------------------------------------------------------------------------------------------- axes along the parts
