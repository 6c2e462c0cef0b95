"""How near moving bodies come to each other, proven between the samples.

Between two times no point of a body is farther from where it is in the middle than the motion bound: let the axes go
from the middle to any other time one after the other, base first. While one turns, all beyond it still stand as in the
middle, so no point moves farther than its distance from that axis there times the angle. Distances of bodies change no
faster than their points move. An interval whose middle is farther off than the bound reaches is done, any other is
halved.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.judge.geometry import inverse_pose, lengths
from trajopt_cli.judge.mechanism import FLANGE, Mechanism
from trajopt_cli.judge.turntables import Turntables
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.shapes import Capsule, Polytope, Shape, outline
from trajopt_cli.trajectory import Trajectory

OVERLOOKED = 1e-4
"""No overlap deeper than this slips through, m: nothing thicker can be jumped over."""

BLOCK = 16
"""Intervals between rows whose bounds are kept together."""

_AT_ONCE = 1024  # blocks or nodes

LOOKS = 300_000
"""Intervals that are looked at for one group of pairs at most, some ten seconds. Motions of cells take 1,000; only what
goes to and fro by many turns from row to row takes all."""

COARSE = 0.01
"""Share of what a distance is above the wanted one that it may be off by: a body that slides past far away would take
thousands of looks to say to OVERLOOKED how far."""


@dataclass(frozen=True, eq=False)
class Body:
    """A shape that a frame carries: a link of the mechanism by its index, or FLANGE; behind that those of tables."""

    name: str
    shape: Shape
    frame: int

    @property
    def joints(self) -> int:
        """How many of the arm's joints move it."""
        return min(self.frame, 6) if self.frame <= FLANGE else 0


@dataclass(frozen=True, eq=False)
class Near:
    """Two bodies that are held against each other; other None: `obstacle` stands in the world.

    spans: from which row to which; None: always.
    """

    body: Body
    obstacle: Shape | None
    other: Body | None = None
    spans: tuple[tuple[int, int], ...] | None = None

    @property
    def against(self) -> str:
        """The name of what the body is held against."""
        found = self.obstacle if self.other is None else self.other
        assert found is not None
        return found.name


@dataclass(frozen=True, eq=False)
class Closest:
    """Where a group of pairs comes nearest: the pair, its signed distance [m] and the time [s].

    proven: no pair comes nearer; False where LOOKS ended the search, and nobody knows.
    """

    near: Near
    distance: float
    time: float
    proven: bool = True


class InterpolatedMotion:
    """The motion between a trajectory's rows, by the row parameter s: s = 2.5 is half way in time from row 2 to row 3.

    Cubic Hermite where the rows have speeds, straight where not. A cubic stays within its control points; their bounds
    are kept for blocks of BLOCK intervals alone, for a long file's rows would take twenty times the file.
    """

    def __init__(self, trajectory: Trajectory):
        self._trajectory = trajectory
        self.last = len(trajectory.t) - 1
        starts = np.arange(0, self.last, BLOCK)
        bounds = [self._bounds(part, np.minimum(part + BLOCK, self.last)) for part in _batches(starts)]
        # level L: over 2^L blocks from each one on
        self._low, self._high = ([np.concatenate(side)] for side in zip(*bounds, strict=True))
        while len(self._low[-1]) > (step := 2 ** (len(self._low) - 1)):
            self._low.append(np.minimum(self._low[-1][:-step], self._low[-1][step:]))
            self._high.append(np.maximum(self._high[-1][:-step], self._high[-1][step:]))

    def time(self, s: float) -> float:
        """The time [s] at s."""
        t, i = self._trajectory.t, min(int(s), self.last - 1)
        return float(t[i] + (s - i) * (t[i + 1] - t[i]))

    def at(self, s: Array) -> Array:
        """Axis positions (m, k) at s (m,)."""
        i = np.minimum(s.astype(np.intp), self.last - 1)
        return self._cubic(i, s - i)[0]

    def swing(self, s_0: Array, s_1: Array, q: Array) -> Array:
        """How far (m, k) the axes are from q (m, k) at most between s_0 and s_1 (m,): whole rows, or a part of one."""
        low, high = np.empty_like(q), np.empty_like(q)
        part = s_1 - s_0 < 1
        if part.any():
            i = s_0[part].astype(np.intp)
            (q_0, v_0), (q_1, v_1) = self._cubic(i, s_0[part] - i), self._cubic(i, s_1[part] - i)
            third = (s_1 - s_0)[part, None] / 3
            control = np.stack([q_0, q_0 + third * v_0, q_1 - third * v_1, q_1])
            low[part], high[part] = control.min(axis=0), control.max(axis=0)
        for nodes in _batches(np.flatnonzero(~part)):
            low[nodes], high[nodes] = self._over(s_0[nodes].astype(np.intp), s_1[nodes].astype(np.intp))
        return np.asarray(np.maximum(high - q, q - low))

    def _over(self, a: IndexArray, b: IndexArray) -> tuple[Array, Array]:
        """Least and greatest control points (m, k) from row a to row b > a (m,): whole blocks, and what is beside."""
        first, last = -(-a // BLOCK), b // BLOCK
        apart = first <= last
        begins = np.concatenate([a, np.where(apart, np.minimum(last * BLOCK, b - 1), a)])
        lows, highs = self._bounds(begins, np.concatenate([np.where(apart, first * BLOCK, b), b]))
        low, high = np.minimum(*np.split(lows, 2)), np.maximum(*np.split(highs, 2))
        level = np.frexp(np.maximum(last - first, 0))[1] - 1
        for L in np.unique(level[first < last]):
            nodes = np.flatnonzero((level == L) & (first < last))
            for begin in (first[nodes], last[nodes] - 2**L):
                low[nodes] = np.minimum(low[nodes], self._low[L][begin])
                high[nodes] = np.maximum(high[nodes], self._high[L][begin])
        return low, high

    def _bounds(self, a: IndexArray, b: IndexArray) -> tuple[Array, Array]:
        """Least and greatest control points (m, k) from row a to b (m,), at most BLOCK rows and at least one."""
        i = np.minimum(a[:, None] + np.arange((b - a).max(initial=1)), np.maximum(b - 1, a)[:, None])
        q_0, _, v_0, v_1 = self._interval(i)
        q_1 = self._trajectory.q[i + 1]
        after, before = q_0 + v_0 / 3, q_1 - v_1 / 3
        low, high = (beyond(beyond(q_0, after), beyond(before, q_1)) for beyond in (np.minimum, np.maximum))
        return low.min(axis=1), high.max(axis=1)

    def _cubic(self, i: IndexArray, u: Array) -> tuple[Array, Array]:
        """Positions and slopes per row (m, k) at the shares u (m,) of the intervals i (m,)."""
        u, (q_0, delta, v_0, v_1) = u[:, None], self._interval(i)
        c2, c3 = 3 * delta - 2 * v_0 - v_1, v_0 + v_1 - 2 * delta
        return q_0 + u * (v_0 + u * (c2 + u * c3)), v_0 + u * (2 * c2 + 3 * u * c3)

    def _interval(self, i: IndexArray) -> tuple[Array, Array, Array, Array]:
        """Axis positions (..., k) at the rows i (...), and from there to the next: way, slope at once and then."""
        t, q, qd = self._trajectory.t, self._trajectory.q, self._trajectory.qd
        q_0, delta = q[i], q[i + 1] - q[i]
        if qd is None:
            return q_0, delta, delta, delta
        h = (t[i + 1] - t[i])[..., None]
        return q_0, delta, qd[i] * h, qd[i + 1] * h


def _batches(x: IndexArray) -> Iterator[IndexArray]:
    """x (m,) in parts, so that no more than a few MB are looked at at once."""
    yield from (x[i : i + _AT_ONCE] for i in range(0, len(x), _AT_ONCE))


class _Sample:
    """The robot in the middle of intervals (m, 2) of s, and how far its axes go from there within them."""

    def __init__(
        self, mechanism: Mechanism, motion: InterpolatedMotion, nodes: Array, tables: Turntables | None = None
    ):
        s_0, s_1 = nodes.T
        middle = (s_0 + s_1) / 2
        self.middle = np.where(s_1 - s_0 > 1, np.floor(middle), middle)
        q = motion.at(self.middle)
        swing = motion.swing(s_0, s_1, q)
        k = len(mechanism.names)
        self._tables, self._theta, self._swing = tables, q[:, k:], swing[:, k:]
        q, swing = q[:, :k], swing[:, :k]
        self.X_WL, self._axes = mechanism.links(q)
        if tables is not None:
            self.X_WL = np.concatenate([self.X_WL, tables.poses(self._theta)], axis=1)
        self._arm = swing[:, -6:]
        self._arm[:, 2] += abs(mechanism.linkage) * self._arm[:, 1]  # joint 3 of the URDF turns with axes 2 and 3
        self._rail = swing[:, : mechanism.rails].sum(axis=1)
        self._origins = self.X_WL[:, 1:FLANGE, :3, 3]
        self._bodies: dict[Body, tuple[Array, Array]] = {}

    @cached_property
    def X_LW(self) -> Array:
        """The world (m, 8, 4, 4) from each of the links and the flange."""
        return inverse_pose(self.X_WL)

    def points(self, body: Body) -> Array:
        """Outline (m, n, 3) of a body in the world, its radius apart."""
        return self._body(body)[0]

    def moved(self, body: Body, since: int) -> Array:
        """How far (m,) a body's points move at most, seen from the link number since; from the world for -1."""
        if body.frame > FLANGE:
            assert self._tables is not None
            return self._tables.moved(body.shape, body.frame - FLANGE - 1, self._theta, self._swing)
        parts = self._body(body)[1]
        arm: Array = parts[:, max(since, 0) :].sum(axis=1)
        return arm + self._rail if since < 0 else arm

    def _body(self, body: Body) -> tuple[Array, Array]:
        """Outline in the world, and how far each joint that moves the body moves its points: radius times angle."""
        if body not in self._bodies:
            local, radius = outline(body.shape)
            X, n = self.X_WL[:, body.frame], body.joints
            points = local @ np.swapaxes(X[:, :3, :3], 1, 2) + X[:, None, :3, 3]
            arm = points[:, :, None] - self._origins[:, None, :n]
            along = np.einsum("mpji,mji->mpj", arm, self._axes[:, :n])
            across = np.sqrt(np.maximum(np.einsum("mpji,mpji->mpj", arm, arm) - along**2, 0.0)).max(axis=1) + radius
            self._bodies[body] = points, across * self._arm[:, :n]
        return self._bodies[body]


class _Placed:
    """A pair with what it takes to place it."""

    def __init__(self, near: Near):
        self._body, self._other = near.body, near.other
        shape = near.obstacle if near.other is None else near.other.shape
        assert shape is not None
        self._pair, self._radius = _pair(near.body.shape, shape), outline(near.body.shape)[1]
        self._X_SO, self._low, self._high = _box(shape)

    def moved(self, sample: _Sample) -> Array:
        """How far (m,) the bodies' points move against each other at most."""
        if self._other is not None and self._other.frame > FLANGE:
            return sample.moved(self._body, -1) + sample.moved(self._other, -1)
        return sample.moved(self._body, -1 if self._other is None else self._other.frame)

    def bound(self, sample: _Sample, rows: IndexArray) -> Array:
        """No more than the distance in the middle of the intervals rows: that of boxes in the other's axes, and where
        the boxes overlap, which says nothing of a depth, minus infinity."""
        X_SW = self._X_SO[None] if self._other is None else self._X_SO @ sample.X_LW[rows, self._other.frame]
        points = sample.points(self._body)[rows] @ np.swapaxes(X_SW[:, :3, :3], 1, 2) + X_SW[:, None, :3, 3]
        over = points.min(axis=1) - self._radius - self._high
        under = self._low - points.max(axis=1) - self._radius
        apart = lengths(np.maximum(np.maximum(over, under), 0.0))
        return np.where(apart > 0, apart, -np.inf)

    def distances(self, sample: _Sample, rows: IndexArray, solid: bool = False) -> Array:
        """Signed distances in the middle of the intervals rows; solid: meshes filled."""
        X_WA = sample.X_WL[rows, self._body.frame]
        X_OA = X_WA if self._other is None else sample.X_LW[rows, self._other.frame] @ X_WA
        return self._pair.distances(X_OA, solid)


@lru_cache(maxsize=64)
def _pair(a: Shape, b: Shape) -> Pair:
    return Pair(a, b)


@lru_cache(maxsize=64)
def _box(shape: Shape) -> tuple[Array, Array, Array]:
    """X_SO (4, 4) of a shape's own axes, in which a box around it is small, and the box' ends (3,) there."""
    X_OS = np.eye(4) if isinstance(shape, Capsule) else np.asarray(shape.X)
    local, radius = outline(shape)
    own = (local - X_OS[:3, 3]) @ X_OS[:3, :3]
    if isinstance(shape, Polytope):
        own, radius = shape.vertices, 0.0
    return inverse_pose(X_OS), own.min(axis=0) - radius, own.max(axis=0) + radius


class Sweep:
    """A robot's bodies along a motion: the least distance of a group of pairs, and when it is first too small."""

    def __init__(self, mechanism: Mechanism, trajectory: Trajectory, tables: Turntables | None = None):
        self._mechanism, self._tables = mechanism, tables
        self._trajectory = trajectory if tables is None else trajectory.whole

    @cached_property
    def _motion(self) -> InterpolatedMotion:
        return InterpolatedMotion(self._trajectory)

    def _sample(self, nodes: Array) -> _Sample:
        return _Sample(self._mechanism, self._motion, nodes, self._tables)

    def least(self, group: Sequence[Near], wanted: float = 0.0) -> Closest:
        """Where the group comes nearest; its distance is more than the least there is by OVERLOOKED at most, or by
        COARSE of what it is above wanted [m], whichever is more. Where that is not proven, Closest says so."""
        pairs = [_Placed(near) for near in group]
        best = min(self._at_starts(group, pairs), key=lambda one: one[1].distance)[1]
        nodes, alive = self._whole(group)
        left = LOOKS
        while len(nodes):
            if (left := left - len(nodes)) < 0:
                return replace(best, proven=False)
            middle = np.empty(len(nodes))
            for part in _batches(np.arange(len(nodes))):
                sample = self._sample(nodes[part])
                middle[part] = sample.middle
                bounds = []
                for column, pair in enumerate(pairs):
                    rows = np.flatnonzero(alive[part, column])
                    if len(rows):
                        bounds.append((column, rows, pair.bound(sample, rows), pair.moved(sample)[rows]))
                for column, rows, bound, moved in sorted(bounds, key=lambda entry: float(entry[2].min())):
                    near = bound - moved < _enough(best, wanted)
                    alive[part[rows[~near]], column] = False
                    distance = pairs[column].distances(sample, rows[near])
                    if len(distance) and distance.min() < best.distance:
                        i = int(np.argmin(distance))
                        best = Closest(
                            group[column], float(distance[i]), self._motion.time(sample.middle[rows[near][i]])
                        )
                    alive[part[rows[near]], column] = distance - moved[near] < _enough(best, wanted)
            nodes, alive = _halved(nodes, middle, alive)
        return best

    def first_below(self, group: Sequence[Near], limit: float) -> Closest | None:
        """When a distance of the group is first below limit; None where it never is by more than OVERLOOKED, and where
        LOOKS ended the search before any was found."""
        pairs = [_Placed(near) for near in group]
        hits = [one for one in self._at_starts(group, pairs) if one[1].distance < limit]
        before, first = min(hits, key=lambda one: (one[0], one[1].distance), default=(np.inf, None))  # s of the first
        nodes, alive = self._whole(group)
        left = LOOKS
        while len(nodes):
            if (left := left - len(nodes)) < 0:
                return None if first is None else replace(first, proven=False)
            middle = np.empty(len(nodes))
            for part in _batches(np.arange(len(nodes))):
                sample = self._sample(nodes[part])
                middle[part] = sample.middle
                for column, pair in enumerate(pairs):
                    rows = np.flatnonzero(alive[part, column] & (nodes[part, 0] < before))
                    alive[part, column] = False
                    moved = pair.moved(sample)[rows]
                    near = pair.bound(sample, rows) - moved < limit
                    rows, moved = rows[near], moved[near]
                    distance = pair.distances(sample, rows)
                    # An interval that moves less than OVERLOOKED is one moment: its beginning.
                    moment = moved <= OVERLOOKED
                    s = np.where(moment, nodes[part[rows], 0], sample.middle[rows])
                    below = np.flatnonzero(distance < limit)
                    if len(below) and s[below].min() < before:
                        i = below[np.argmin(s[below])]
                        before = float(s[i])
                        first = Closest(group[column], float(distance[i]), self._motion.time(before))
                    alive[part[rows], column] = (distance - moved < limit) & ~moment
            alive &= nodes[:, :1] < before
            nodes, alive = _halved(nodes, middle, alive)
        return first

    def _at_starts(self, group: Sequence[Near], pairs: Sequence[_Placed]) -> list[tuple[float, Closest]]:
        """Every pair in the first row of each of its spans, meshes filled: later a body comes inside through the
        surface only."""
        out = []
        starts = [[first for first, _ in near.spans or ((0, 0),)] for near in group]
        for row in sorted({first for own in starts for first in own}):
            sample = self._sample(np.full((1, 2), float(row)))
            for near, pair, own in zip(group, pairs, starts, strict=True):
                if row in own:
                    distance = float(pair.distances(sample, np.zeros(1, dtype=np.intp), solid=True)[0])
                    out.append((float(row), Closest(near, distance, self._motion.time(float(row)))))
        return out

    def _whole(self, group: Sequence[Near]) -> tuple[Array, BoolArray]:
        """The motion cut where a span begins or ends; alive are the pieces in the spans of each pair."""
        last = self._motion.last
        spans = [near.spans or ((0, last),) for near in group]
        cuts = np.array(sorted({0, last, *(row for own in spans for span in own for row in span)}), dtype=np.float64)
        nodes = np.column_stack([cuts[:-1], cuts[1:]])
        alive = np.zeros((len(nodes), len(group)), dtype=bool)
        for column, own in enumerate(spans):
            for first, end in own:
                alive[(nodes[:, 0] >= first) & (nodes[:, 1] <= end), column] = True
        some = alive.any(axis=1)
        return nodes[some], alive[some]


def _enough(best: Closest, wanted: float) -> float:
    """An interval that comes no nearer than this need not be looked at."""
    return best.distance - max(OVERLOOKED, COARSE * (best.distance - wanted))


def _halved(nodes: Array, middle: Array, alive: BoolArray) -> tuple[Array, BoolArray]:
    """The halves (2m, 2) of the intervals that are alive for any pair."""
    rows = alive.any(axis=1)
    nodes, middle, alive = nodes[rows], middle[rows], alive[rows]
    halves = np.concatenate([np.column_stack([nodes[:, 0], middle]), np.column_stack([middle, nodes[:, 1]])])
    return halves, np.concatenate([alive, alive])
