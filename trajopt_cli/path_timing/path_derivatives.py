"""Axes along the parts of a path, with their derivatives by its parameter."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.path.segment import JointSegment, Segment, along_all, over_work
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import unwound

_INSIDE = 1e-9  # fraction of a part by which a sample keeps from its ends, where derivatives jump
_NUMB = 1e-6  # sine of joint 5 below which the inverse kinematics has no derivative
_ASIDE = 1e-3  # fraction of a part beside such a place, where derivatives are taken instead
_FIELDS = ("q", "dq", "ddq", "v", "w", "bend", "positioner_use")
_RAIL = ("d", "slope", "bend", "third", "fourth")


@dataclass(frozen=True, eq=False)
class Rail:
    """The rail on a part, over its fraction u: d + u (slope + u (bend + u (third + u fourth))); each (r,), or (m, r) on
    one part at each of m fractions."""

    d: Array
    slope: Array
    bend: Array
    third: Array
    fourth: Array

    @classmethod
    def straight(cls, d: Array, slope: Array) -> Rail:
        """In proportion to u."""
        return cls(d, slope, *(np.zeros((3, *np.shape(d)))))

    @property
    def bends(self) -> bool:
        """Whether it is not in proportion to u."""
        return bool(np.any([self.bend, self.third, self.fourth]))

    def at(self, u: Array) -> tuple[Array, Array, Array]:
        """Position and both derivatives by u, each (m, r), at fractions u (m,)."""
        u = u[:, None]
        rate = self.slope + u * (2 * self.bend + u * (3 * self.third + 4 * u * self.fourth))
        change = 2 * np.broadcast_to(self.bend, rate.shape) + u * (6 * self.third + 12 * u * self.fourth)
        return self.d + u * (self.slope + u * (self.bend + u * (self.third + u * self.fourth))), rate, change


@dataclass(frozen=True, eq=False)
class PathPart:
    """From s_0 to s_1 of a segment, of one leg (its number in the problem). size: how much sigma it is. u (N+1,): its
    nodes, as fractions of it.

    rail, cfx: rail and branch on a segment of the tool; None and -1 on one of the axes.
    """

    leg: int
    segment: Segment | JointSegment
    s_0: float
    s_1: float
    size: float
    u: Array
    rail: Rail | None
    cfx: int

    @property
    def N(self) -> int:
        """Intervals."""
        return len(self.u) - 1

    def own(self, u: Array) -> Array:
        """The segment's parameter (m,) at fractions u (m,) of the part."""
        return self.s_0 + u * (self.s_1 - self.s_0)


@dataclass(frozen=True, eq=False)
class PathDerivatives:
    """At m places: axes q with their derivatives dq, ddq (m, n), and the tool's position's v, bend and turning's first
    one w (m, 3), all by sigma; against the work object where that turns. positioner_use (m, 2): what positioners take
    for one sigma, see Leg.positioner_use."""

    q: Array
    dq: Array
    ddq: Array
    v: Array
    w: Array
    bend: Array
    positioner_use: Array

    def at(self, rows: slice | IndexArray) -> PathDerivatives:
        """Some of the places."""
        return PathDerivatives(*(getattr(self, name)[rows] for name in _FIELDS))

    def put(self, rows: BoolArray, other: PathDerivatives) -> None:
        """Others at some of the places, in place."""
        for name in _FIELDS:
            getattr(self, name)[rows] = getattr(other, name)

    def by(self, size: Array) -> PathDerivatives:
        """The derivatives by a parameter that grows size (m,) times as fast."""
        k = 1 / size[:, None]
        return PathDerivatives(
            self.q, self.dq * k, self.ddq * k**2, self.v * k, self.w * k, self.bend * k**2, self.positioner_use * k
        )


def _empty(n: int, m: int) -> PathDerivatives:
    """To be filled in, of n axes at m places."""
    return PathDerivatives(*(np.empty((m, k)) for k in (n, n, n, 3, 3, 3, 2)))


def joined(pieces: Sequence[PathDerivatives]) -> PathDerivatives:
    """One after the other."""
    return PathDerivatives(*(np.concatenate([getattr(piece, name) for piece in pieces]) for name in _FIELDS))


def axes_along(axes: Axes, problem: Problem, runs: Sequence[tuple[Sequence[PathPart], Array]]) -> PathDerivatives:
    """What is along the parts of runs at their nodes; NaN where the arm does not reach."""
    parts = [part for own, _ in runs for part in own]
    counts = np.array([part.N + 1 for part in parts])
    edges = np.concatenate([[0], np.cumsum(counts)])
    on_path = np.array([part.rail is not None for part in parts])
    names = [_name(part) for part in parts]
    distinct = {name: part for name, part in zip(names, parts, strict=True)}  # many runs may have it alike
    out = _along_distinct(axes, problem, [*distinct.values()])
    if len(distinct) < len(parts):
        behind = np.cumsum([part.N + 1 for part in distinct.values()])
        begins = dict(zip(distinct, behind - [part.N + 1 for part in distinct.values()], strict=True))
        shift = np.repeat([begins[name] for name in names] - edges[:-1], counts)
        out = out.at(np.arange(edges[-1]) + shift)
    starts, near, first = (
        [],
        [],
        0,
    )  # of the parts on segments of the tool: joints there are near those of the waypoint before
    for own, q in runs:
        for i, part in enumerate(own):
            if part.rail is not None and (i == 0 or own[i - 1].rail is None):
                starts.append(edges[first + i])
                near.append(q[part.leg])
        first += len(own)
    if starts:
        at = np.repeat(on_path, counts)
        kept = np.cumsum(at)[starts] - 1
        arm = axes.layout.arm
        out.q[at, arm] = unwound(out.q[at, arm], kept, np.array(near)[:, arm])
    return out.by(np.repeat([part.size for part in parts], counts))


def _along_distinct(axes: Axes, problem: Problem, parts: Sequence[PathPart]) -> PathDerivatives:
    """The same of parts, one after the other, by their own fractions and with joints in whatever turn."""
    counts = [part.N + 1 for part in parts]
    out = _empty(axes.n, sum(counts))
    on_path = np.array([part.rail is not None for part in parts])
    for which, of in ((on_path, on_paths), (~on_path, _on_axes)):
        some = [part for part, wanted in zip(parts, which, strict=True) if wanted]
        if some:
            out.put(np.repeat(which, counts), of(axes, problem, some, [_fractions(part) for part in some]))
    return out


def _name(part: PathPart) -> tuple[object, ...]:
    """Equal for parts of one problem along which is the same by their fractions."""
    rail = () if part.rail is None else (x for name in _RAIL for x in getattr(part.rail, name))
    return part.leg, id(part.segment), part.s_0, part.s_1, part.cfx, part.u.tobytes(), *rail


def _fractions(part: PathPart) -> Array:
    return part.u if part.rail is None else np.clip(part.u, _INSIDE, 1 - _INSIDE)


def _on_axes(axes: Axes, problem: Problem, parts: Sequence[PathPart], fractions: Sequence[Array]) -> PathDerivatives:
    """Along parts that axes decide, by their fractions, one after the other."""
    found = []
    for part, u in zip(parts, fractions, strict=True):
        segment = part.segment
        assert isinstance(segment, JointSegment)
        s, k = part.own(u), part.s_1 - part.s_0
        found.append((segment.axes(s), segment.rate(s) * k, segment.rate_change(s) * k**2))
    q, dq, ddq = (np.concatenate(x) for x in zip(*found, strict=True))
    v, w, bend = (np.empty((len(q), 3)) for _ in range(3))
    out = PathDerivatives(q, dq, ddq, v, w, bend, np.zeros((len(q), 2)))
    for at, numbers in _by_tool(problem, parts, fractions):
        X_FT = problem.legs[parts[numbers[0]].leg].X_FT
        motion = axes.differential(q[at], X_FT).motion(dq[at], ddq[at])
        out.v[at], out.w[at], out.bend[at] = motion[:, 0, :3], motion[:, 0, 3:], motion[:, 1, :3]
    return out


def _by_tool(
    problem: Problem, parts: Sequence[PathPart], fractions: Sequence[Array]
) -> Iterator[tuple[BoolArray, list[int]]]:
    """Which rows are of a tool among parts with fractions (m,) each, and the numbers of these parts; tool by tool."""
    names = [problem.legs[part.leg].X_FT.tobytes() for part in parts]
    for name in dict.fromkeys(names):
        alike = np.array([one == name for one in names])
        yield np.repeat(alike, [len(u) for u in fractions]), np.flatnonzero(alike).tolist()


def on_paths(axes: Axes, problem: Problem, parts: Sequence[PathPart], fractions: Sequence[Array]) -> PathDerivatives:
    """Along parts that the tool decides, by their fractions (m,) of each, one part after the other; joints in whatever
    turn, NaN out of reach."""
    out = _empty(axes.n, sum(map(len, fractions)))
    for at, numbers in _by_tool(problem, parts, fractions):
        own = [parts[i] for i in numbers]
        positioner_use = np.array([problem.legs[one.leg].positioner_use for one in own])
        X_FT = problem.legs[own[0].leg].X_FT
        out.put(at, _with_tool(axes, X_FT, own, [fractions[i] for i in numbers], positioner_use))
    return out


def _with_tool(
    axes: Axes, X_FT: Array, parts: Sequence[PathPart], fractions: Sequence[Array], positioner_use: Array
) -> PathDerivatives:
    """The same with one tool on all parts. positioner_use (p, 2): what positioners take for the whole of each."""
    counts = [len(u) for u in fractions]
    edges, of = np.cumsum(counts)[:-1], np.repeat(np.arange(len(parts)), counts)
    cfx, s_0, s_1 = (np.array([getattr(part, name) for part in parts])[of] for name in ("cfx", "s_0", "s_1"))
    rail = Rail(*(np.array([getattr(part.rail, name) for part in parts])[of] for name in _RAIL))
    size = (s_1 - s_0)[:, None]
    segments: list[Any] = [part.segment for part in parts]

    def at(u: Array) -> tuple[Array, Array, Array, Array, Array, Array]:
        X, twist, bend = along_all(segments, np.split(s_0 + u * (s_1 - s_0), edges))
        d, dd, ddd = rail.at(u)
        arm = axes.branch(X @ inverse_pose(X_FT), axes.layout.value(d), cfx)
        return axes.layout.merge(d, arm), arm, twist * size, bend * size**2, dd, ddd

    u = np.concatenate(fractions)
    q, arm, twist, bend, dd, ddd = at(u)
    numb = axes.robot.singularity_margins(arm)[1] < _NUMB
    place = q
    if numb.any():  # there a derivative is what it is a little farther on
        place, _, twist, bend, dd, ddd = at(np.where(numb, np.clip(u, _ASIDE, 1 - _ASIDE), u))
    dq, ddq = axes.differential(place, X_FT).follow(twist, bend, dd, ddd)
    if positioner_use.any():  # such a path is one part: its parameter is the segment's own
        twist, bend = over_work(segments, np.split(u, edges), twist, bend)
    return PathDerivatives(q, dq, ddq, twist[:, :3], twist[:, 3:], bend[:, :3], positioner_use[of])
