"""One leg's motion as numbers: what the nonlinear program found, to be sampled, split and checked.

Every motion is piecewise polynomial in scaled time tau = t / T with exact integration, so a leg may be sampled at any
time without loss, and splitting an interval changes nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby
from typing import Literal

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose, rotation_about
from trajopt_cli.native.loops import loops
from trajopt_cli.path.segment import Segment, along_all, over_work
from trajopt_cli.trajectories.axes import Axes

_NUMB = 1e-6  # sine of joint 5 below which the inverse kinematics tells joints 4 and 6 apart by convention only
_BESIDE = 1e-6  # share of a way by which one goes beside such a place


def integrate(grid: Array, x: Array, v: Array, tau: Array, right: bool = True) -> tuple[Array, Array, Array]:
    """Position, velocity, acceleration (scaled time) at tau (n,) of node values x, v (N+1, ...) on a grid over 0..1.

    At a node the acceleration is the one of the interval on its right or left. The cubic Hermite
    between nodes is the exact integral up to the solver's residual, without its jumps.
    """
    aside = 1e-12 if right else -1e-12  # a time that is a node up to rounding belongs to the side asked for
    nodes, out = len(grid), np.empty((3, len(tau), *x.shape[1:]))
    fill = loops("trajopt_cli.trajectories.hermite_loops")["fill"]
    fill(grid, x.reshape(nodes, -1), v.reshape(nodes, -1), tau, aside, out.reshape(3, len(tau), -1))
    return out[0], out[1], out[2]


def halved(grid: Array) -> Array:
    """The grid with a node in the middle of every interval."""
    out = np.empty(2 * len(grid) - 1)
    out[::2], out[1::2] = grid, (grid[:-1] + grid[1:]) / 2
    return out


def split(grid: Array, x: Array, v: Array, a: Array) -> tuple[Array, Array, Array]:
    """The same motion on the halved grid."""
    finer = halved(grid)
    xs, vs, _ = integrate(grid, x, v, finer)
    xs[::2], vs[::2] = x, v
    return xs, vs, np.repeat(a, 2, axis=0)


def _resting(v: Array) -> BoolArray:
    """Between which nodes (N,) rates v (N+1, k) that change evenly are none."""
    still = np.all(v == 0.0, axis=1)
    return np.asarray(still[:-1] & still[1:])


def parabola(grid: Array) -> tuple[Array, Array, Array]:
    """Rest to rest over unit length with one switch in the middle, which must be a node: s, v, a."""
    s = np.where(grid <= 0.5, 2 * grid**2, 1 - 2 * (1 - grid) ** 2)
    v = np.where(grid <= 0.5, 4 * grid, 4 * (1 - grid))
    return s, v, np.where(grid[:-1] < 0.5 - 1e-12, 4.0, -4.0)


@dataclass(frozen=True, eq=False)
class Sample:
    """All axes (m, n) at times t (m,) of a leg: positions, velocities, accelerations. tool (m, 2, 6): the tool's twist
    and its rate where they decide the axes, NaN where it is the other way round; None where it is so everywhere. Over
    a work object that turns they are against it, for that is what its caps hold for."""

    t: Array
    q: Array
    qd: Array
    qdd: Array
    tool: Array | None = None


@dataclass(frozen=True, eq=False)
class PathLeg:
    """A line or dwell with its rail motion. s, v: (N+1,), a: (N,); d, w: (N+1, r), b: (N, r); scaled time.

    axis (3,): of the tool's own, about which it is turned beyond its segment meanwhile: the turn [rad] is one more
    column of d, w and b, behind the rails'. None where the segment says it all.
    """

    T: float
    segment: Segment  # of the tool, in the world; a line of no length for a dwell
    X_FT: Array
    cfx: int
    reference: Array  # joints near the start, on the branch and turn meant
    grid: Array
    s: Array
    v: Array
    a: Array
    d: Array
    w: Array
    b: Array
    axis: Array | None = None

    @property
    def N(self) -> int:
        """Intervals."""
        return len(self.a)

    @property
    def rail(self) -> Array:
        """The rails (N+1, r)."""
        return self.d if self.axis is None else self.d[:, :-1]

    def turning(self, axis: Array) -> PathLeg:
        """The same motion as one of a tool that may be turned about its axis (3,) meanwhile."""
        if self.axis is not None:
            return self
        d, w, b = (np.column_stack([x, np.zeros(len(x))]) for x in (self.d, self.w, self.b))
        return replace(self, d=d, w=w, b=b, axis=axis)

    def refined(self) -> PathLeg:
        """The same motion on twice as many intervals."""
        s, v, a = split(self.grid, self.s, self.v, self.a)
        d, w, b = split(self.grid, self.d, self.w, self.b)
        return replace(self, grid=halved(self.grid), s=s, v=v, a=a, d=d, w=w, b=b)

    def slowed(self, times: float) -> PathLeg:
        """The same way in so many times the time."""
        return replace(self, T=self.T * times)

    def breaks(self) -> Array:
        """Times (N+1,) where an acceleration may jump."""
        return self.T * self.grid

    def resting(self) -> BoolArray:
        """The intervals (N,) between breaks in which nothing moves."""
        return _resting(np.column_stack([self.v, self.w]))

    def node_arm(self, axes: Axes) -> Array:
        """Arm joints (N+1, joints) at the nodes."""
        X_WT = self.segment.pose(self.s)
        if self.axis is not None:
            X_WT[:, :3, :3] = X_WT[:, :3, :3] @ rotation_about(self.axis, self.d[:, -1])
        arm = axes.branch(X_WT @ inverse_pose(self.X_FT), axes.layout.value(self.rail), self.cfx)
        return unwind(arm, self.reference)

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        """Positions by inverse kinematics, velocities, accelerations through the Jacobian. At a break: right side."""
        return _on_ways(axes, [self], [t], right)

    def progress(self, t: Array, right: bool) -> Array:
        """At times t (m,): share of the way, rail and turn, if any, their rates and second derivatives (3, m, 1 + r) or
        (3, m, 2 + r)."""
        x, v = np.column_stack([self.s, self.d]), np.column_stack([self.v, self.w])
        found = integrate(self.grid, x, v, np.clip(t / self.T, 0.0, 1.0), right)
        return np.stack(found) / np.array([1.0, self.T, self.T**2])[:, None, None]


def _on_ways(axes: Axes, legs: Sequence[PathLeg], times: Sequence[Array], right: bool) -> Sample:
    """Many such motions with one tool and axis, each at times (m,) of its own, one after the other."""
    counts = [len(t) for t in times]
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    references = np.array([leg.reference for leg in legs])
    progress = np.concatenate([leg.progress(t, right) for leg, t in zip(legs, times, strict=True)], axis=1)
    cfx = np.repeat([leg.cfx for leg in legs], counts)
    segments = [leg.segment for leg in legs]
    return on_ways(
        axes, legs[0].X_FT, segments, counts, cfx, np.concatenate(times), progress,
        lambda arm: unwound(arm, starts, references), legs[0].axis,
    )  # fmt: skip


def on_ways(
    axes: Axes, X_FT: Array, segments: Sequence[Segment], counts: Sequence[int], cfx: IndexArray, t: Array,
    progress: Array, turned: Callable[[Array], Array], axis: Array | None = None,
) -> Sample:  # fmt: skip
    """Along segments of a tool at counts of places each, one after the other, on branches cfx (m,). progress (3, m,
    1 + r): share of the segment and rail, their rates and second derivatives by time. turned: puts joints (m, joints)
    in whatever turn into the one meant. axis (3,): of the tool, about which it is turned by a last column of progress
    beyond the segments."""
    edges, X_TF = np.cumsum(counts)[:-1], inverse_pose(X_FT)
    at, rates, changes = progress
    s, d, sv, dv, sa, da = at[:, 0], at[:, 1:], rates[:, 0], rates[:, 1:], changes[:, 0], changes[:, 1:]
    r = axes.layout.r

    def placed(s: Array, d: Array) -> tuple[Array, Array, Array, Array | None]:
        """Arm joints (m, joints) in whatever turn, twist and its rate by s (m, 6), the tool's axis in the world."""
        X, twist, bend = along_all(segments, np.split(s, edges))
        if axis is not None:
            X[:, :3, :3] = X[:, :3, :3] @ rotation_about(axis, d[:, r])
        u = None if axis is None else X[:, :3, :3] @ axis
        return axes.branch(X @ X_TF, axes.layout.value(d[:, :r]), cfx), twist, bend, u

    arm, twist, bend, u = placed(s, d)
    numb = axes.robot.singularity_margins(arm)[1] < _NUMB
    back, along = np.where(numb, s - np.clip(s, _BESIDE, 1 - _BESIDE), 0.0)[:, None], np.zeros_like(d)
    if numb.any():  # a wrist that the line leaves: joints and rates are those beside it, followed back
        along = _ratio(dv, da, sv, sa)
        s, d = s - back[:, 0], d - back * along
        arm, twist, bend, u = placed(s, d)
    q = axes.layout.merge(d[:, :r], turned(arm))
    moves = axes.differential(q, X_FT)

    def by_time(twist: Array, bend: Array) -> Array:
        out = np.stack([sv[:, None] * twist, sa[:, None] * twist + sv[:, None] ** 2 * bend], axis=1)
        if u is not None:
            out[:, 1, 3:] += da[:, r:] * u + dv[:, r:] * np.cross(out[:, 0, 3:], u)
            out[:, 0, 3:] += dv[:, r:] * u
        return out

    tool = by_time(twist, bend)
    qd, qdd = moves.follow(tool[:, 0], tool[:, 1], dv[:, :r], da[:, :r])
    if numb.any():
        way = twist if u is None else twist + np.hstack([np.zeros_like(u), along[:, r:] * u])
        along = along[:, :r]
        q = q + np.where(numb[:, None], back * moves.follow(way, bend, along, np.zeros_like(along))[0], 0.0)
    return Sample(t, q, qd, qdd, by_time(*over_work(segments, np.split(s, edges), twist, bend)))


def _ratio(dv: Array, da: Array, sv: Array, sa: Array) -> Array:
    """How far the rail goes (m, r) per share of the way: of the rates, or from rest of the accelerations."""
    rests = sv == 0
    over, under = np.where(rests[:, None], da, dv), np.where(rests, sa, sv)[:, None]
    return np.asarray(np.divide(over, under, out=np.zeros_like(over), where=under != 0))


def unwind(arm: Array, reference: Array) -> Array:
    """Joints (m, joints) moved by whole turns: the first near the reference, each next near the one before."""
    return unwound(arm, np.zeros(1, dtype=np.intp), reference[None])


def unwound(arm: Array, starts: IndexArray, references: Array) -> Array:
    """The same for many, one after the other, which begin at rows starts (k,) near references (k, joints)."""
    before = np.concatenate([references[:1], arm[:-1]])
    before[starts] = references
    turns = np.cumsum(np.nan_to_num(np.round((arm - before) / (2 * np.pi))), axis=0)
    spent = np.concatenate([np.zeros_like(references[:1]), turns])[starts]  # by those before
    counts = np.diff(starts, append=len(arm))
    return np.asarray(arm - 2 * np.pi * (turns - np.repeat(spent, counts, axis=0)))


@dataclass(frozen=True, eq=False)
class JointNodes:
    """A joint move on a grid: q, v (N+1, n), a (N, n), scaled time. Also axes that share one progress."""

    T: float
    grid: Array
    q: Array
    v: Array
    a: Array

    @property
    def N(self) -> int:
        """Intervals."""
        return len(self.a)

    def refined(self) -> JointNodes:
        """The same motion on twice as many intervals."""
        return JointNodes(self.T, halved(self.grid), *split(self.grid, self.q, self.v, self.a))

    def slowed(self, times: float) -> JointNodes:
        """The same way in so many times the time."""
        return replace(self, T=self.T * times)

    def breaks(self) -> Array:
        """Times (N+1,) where an acceleration may jump."""
        return self.T * self.grid

    def resting(self) -> BoolArray:
        """The intervals (N,) between breaks in which nothing moves."""
        return _resting(self.v)

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        """Exact polynomial values."""
        q, v, a = integrate(self.grid, self.q, self.v, np.clip(t / self.T, 0.0, 1.0), right)
        return Sample(t, q, v / self.T, a / self.T**2)


@dataclass(frozen=True, eq=False)
class JointProfiles:
    """A joint move where each axis has three phases of its own. times (n, 4), accelerations (n, 3); real time."""

    T: float
    q_0: Array
    qd_0: Array
    times: Array
    accelerations: Array

    @property
    def N(self) -> int:
        """Phases of an axis."""
        return 3

    def slowed(self, times: float) -> JointProfiles:
        """The same way in so many times the time."""
        return JointProfiles(
            self.T * times, self.q_0, self.qd_0 / times, self.times * times, self.accelerations / times**2
        )

    def breaks(self) -> Array:
        """Times where some axis switches, ascending; twice the start where no axis moves."""
        times = np.unique(self.times.ravel())
        return times if len(times) > 1 else np.repeat(times, 2)

    def resting(self) -> BoolArray:
        """The intervals between breaks, all or none, in which nothing moves."""
        return np.full(len(self.breaks()) - 1, not (self.qd_0.any() or self.accelerations.any()))

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        """Exact polynomial values."""
        q, qd, qdd = (np.empty((len(t), len(self.q_0))) for _ in range(3))
        side: Literal["left", "right"] = "right" if right else "left"
        for j in range(len(self.q_0)):
            h, acc = np.diff(self.times[j]), self.accelerations[j]
            v = self.qd_0[j] + np.concatenate([[0], np.cumsum(acc * h)])
            x = self.q_0[j] + np.concatenate([[0], np.cumsum(v[:-1] * h + acc * h * h / 2)])
            i = np.clip(np.searchsorted(self.times[j], t, side=side) - 1, 0, 2)
            dt = t - self.times[j][i]
            q[:, j] = x[i] + v[i] * dt + acc[i] * dt * dt / 2
            qd[:, j] = v[i] + acc[i] * dt
            qdd[:, j] = acc[i]
        return Sample(t, q, qd, qdd)


Piece = PathLeg | JointNodes | JointProfiles


@dataclass(frozen=True, eq=False)
class Pieces:
    """A leg's motions one after the other: of the half corner before it, its way, the half corner behind it; or its way
    and a rest."""

    pieces: tuple[Piece, ...]

    def slowed(self, times: float) -> Pieces:
        """The same ways in so many times the time."""
        return Pieces(tuple(piece.slowed(times) for piece in self.pieces))

    @cached_property
    def _starts(self) -> Array:
        return np.concatenate([[0.0], np.cumsum([piece.T for piece in self.pieces])])

    @property
    def T(self) -> float:
        """Time [s] of all."""
        return float(self._starts[-1])

    @property
    def N(self) -> int:
        """Intervals of all."""
        return sum(piece.N for piece in self.pieces)

    def breaks(self) -> Array:
        """Times (N+1,) where an acceleration may jump."""
        inner = [start + piece.breaks()[1:] for start, piece in zip(self._starts[:-1], self.pieces, strict=True)]
        return np.concatenate([[0.0], *inner])

    def resting(self) -> BoolArray:
        """The intervals (N,) between breaks in which nothing moves."""
        return np.concatenate([piece.resting() for piece in self.pieces])

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        """As of the piece at each time."""
        return sampled(axes, [self], [t], right)

    def split(self, t: Array, right: bool) -> Iterator[tuple[Piece, IndexArray, Array]]:
        """The pieces that hold any of the times t (m,), with the numbers of theirs, and these as times of the piece."""
        side: Literal["left", "right"] = "right" if right else "left"
        number = np.clip(np.searchsorted(self._starts, t, side=side) - 1, 0, len(self.pieces) - 1)
        for i in np.unique(number).tolist():
            at = np.flatnonzero(number == i)
            yield self.pieces[i], at, np.clip(t[at] - self._starts[i], 0.0, self.pieces[i].T)


LegMotion = Piece | Pieces


def shares(motion: LegMotion, t: Array, right: bool = True) -> Array:
    """The share of a line or an arc that is done at times t (m,), its rate and second derivative (3, m)."""
    if isinstance(motion, PathLeg):
        return motion.progress(t, right)[:, :, 0]
    out = np.zeros((3, len(t)))
    if isinstance(motion, Pieces):
        last = max(i for i, piece in enumerate(motion.pieces) if isinstance(piece, PathLeg))
        for piece, at, when in motion.split(t, right):
            if isinstance(piece, PathLeg):
                out[:, at] = piece.progress(when, right)[:, :, 0]
            else:  # a rest before the way, or behind it
                out[0, at] = float(motion.pieces.index(piece) > last)
    return out


def sampled(axes: Axes, motions: Sequence[LegMotion], times: Sequence[Array], right: bool = True) -> Sample:
    """Many motions, each at times (m,) of its own, one after the other."""
    t = np.concatenate(times)
    q, qd, qdd = (np.empty((len(t), axes.n)) for _ in range(3))
    tool = np.full((len(t), 2, 6), np.nan)
    for at, sample in samples(axes, motions, times, right):
        q[at], qd[at], qdd[at] = sample.q, sample.qd, sample.qdd
        if sample.tool is not None:
            tool[at] = sample.tool
    return Sample(t, q, qd, qdd, tool)


def samples(
    axes: Axes, motions: Sequence[LegMotion], times: Sequence[Array], right: bool = True
) -> Iterator[tuple[IndexArray, Sample]]:
    """The same bit by bit, with the numbers of the times in each."""
    ways: list[tuple[PathLeg, IndexArray, Array]] = []
    first = 0
    for motion, own in zip(motions, times, strict=True):
        pieces = motion.split(own, right) if isinstance(motion, Pieces) else [(motion, np.arange(len(own)), own)]
        for piece, at, when in pieces:
            if isinstance(piece, PathLeg):
                ways += [(piece, first + at, when)] if len(when) else []
            else:
                yield first + at, piece.sample(axes, when, right)
        first += len(own)
    for group in _together(ways, axes.settings.batch // 4):
        numbers = np.concatenate([at for _, at, _ in group])
        yield numbers, _on_ways(axes, [leg for leg, _, _ in group], [when for _, _, when in group], right)


def _together(
    ways: Sequence[tuple[PathLeg, IndexArray, Array]], batch: int
) -> Iterator[list[tuple[PathLeg, IndexArray, Array]]]:
    """Motions to be sampled at once: of one tool and axis, and few enough for the memory."""
    behind = np.cumsum([len(t) for _, _, t in ways])

    def key(i: int) -> tuple[bytes, bytes, int]:
        axis = ways[i][0].axis
        return ways[i][0].X_FT.tobytes(), b"" if axis is None else axis.tobytes(), int(behind[i]) // batch

    for _, group in groupby(range(len(ways)), key=key):
        yield [ways[i] for i in group]


def sample_times(motion: LegMotion, every: float, least: int, most: int) -> tuple[Array, IndexArray]:
    """Times (m,) at which a motion is looked at, its last break at the end, and the number (N,) in them of the break
    that begins each interval.

    Between two breaks they are no more than every [s] apart, but most parts: a motion may last for a day.
    least: parts of any interval, and all there are of one in which nothing moves.
    """
    breaks = motion.breaks()
    steps = np.diff(breaks)
    wanted = np.where(motion.resting(), 0.0, np.minimum(np.ceil(steps / every), most))
    parts = np.maximum(wanted.astype(np.intp), least)
    first = np.cumsum(parts) - parts
    number = np.arange(parts.sum()) - np.repeat(first, parts)
    inner = np.repeat(breaks[:-1], parts) + np.repeat(steps / parts, parts) * number
    return np.append(inner, breaks[-1]), first
