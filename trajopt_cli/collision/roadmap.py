"""Ways around: points between two places of the axes by which straight ways lead clear of everything.

First one point or two anywhere, many at once, the quickest ways first; then trees of random straight ways from both
ends until they meet; then what was found is made quicker. Random numbers are the same in every run.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from trajopt_cli.collision.collision_scene import CollisionScene
from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.timing.double_integrator import trapezoid_time
from trajopt_cli.trajectories.axes import Axes

_WAY_PULLS = 12  # times that each point of a way is moved to where it is quicker.
_WAY_LOOKS = 48  # straight ways that are looked at together.
_WAY_STEP = 0.25  # s at top speed: the short ones of a tree's branches.
_WAY_TURN = 0.3  # rad, m by which a point is moved at first.

Allowed = Callable[[Array], BoolArray]
"""Which of axes (m, n) may be a point at all."""


def about(axes: Axes, ways: Array) -> Array:
    """What ways (m, k, n) through k places each take [s], about: half way between stopping at none of them, every axis
    all of its way, and at each."""
    far = np.abs(np.diff(ways, axis=1))
    through = trapezoid_time(far.sum(axis=1), axes.velocity, axes.acceleration).max(axis=-1)
    stopping = trapezoid_time(far, axes.velocity, axes.acceleration).max(axis=-1).sum(axis=1)
    return np.asarray((through + stopping) / 2)


class Roadmap:
    """The ways that may be gone during a motion."""

    def __init__(self, axes: Axes, around: CollisionScene, index: int, allowed: Allowed):
        self._axes, self._around, self._index, self._allowed = axes, around, index, allowed
        self._random = np.random.default_rng([36, around.scene(index)])
        # of the time that axes take at top speed
        self._weight = 1 / axes.velocity

    def between(self, q_0: Array, q_1: Array) -> Array | None:
        """Points (m, n) of a way from q_0 to q_1 (n,), none where the straight one is clear; None where none was found.
        Neither end may touch anything."""
        if self._clear(q_0[None], q_1[None])[0]:
            return np.empty((0, len(q_0)))
        if not self._around.free(np.stack([q_0, q_1]), self._index).all():
            return None
        found = self._by_points(q_0, q_1)
        if found is None:
            found = self._by_trees(q_0, q_1)
        return None if found is None else self.quicker(q_0, found, q_1)

    def quicker(self, q_0: Array, points: Array, q_1: Array) -> Array:
        """The same with fewer and nearer points."""
        way = self._fewer(np.concatenate([q_0[None], points, q_1[None]]))
        step = 0.5
        for _ in range(_WAY_PULLS):
            if len(way) == 2:
                break
            gained = False
            checkpoint()
            for i in range(1, len(way) - 1):
                gained |= self._pulled(way, i, step)
            step *= 1.0 if gained else 0.5
        return self._fewer(way)[1:-1]

    def _clear(self, q_0: Array, q_1: Array) -> BoolArray:
        return self._around.free_between(q_0, q_1, self._index)

    def _random_free(self, n: int) -> Array:
        """Places anywhere (m, n) that touch nothing."""
        axes = self._axes
        q = self._random.uniform(axes.lower, axes.upper, (n, axes.n))
        q = q[self._around.free(q, self._index)]
        return q[self._allowed(q)]

    def _by_points(self, q_0: Array, q_1: Array) -> Array | None:
        """The quickest of ways by one point, some near the straight way and some anywhere; of those by two else."""
        axes, n = self._axes, self._axes.settings.detour_tries
        span = np.maximum(np.abs(q_1 - q_0), 0.25 * np.minimum(axes.upper - axes.lower, np.pi))
        middle = q_0 + self._random.uniform(0, 1, (n, 1)) * (q_1 - q_0)
        spread = self._random.choice([0.2, 0.5, 1.0], (n, 1)) * span
        near = np.clip(middle + self._random.normal(size=(n, axes.n)) * spread, axes.lower, axes.upper)
        near = near[self._around.free(near, self._index)]
        points = np.concatenate([near[self._allowed(near)], self._random_free(n)])
        if not len(points):
            return None
        ways = np.stack([np.tile(q_0, (len(points), 1)), points, np.tile(q_1, (len(points), 1))], axis=1)
        order = np.argsort(about(axes, ways), kind="stable")
        before, behind = np.zeros(len(points), dtype=bool), np.zeros(len(points), dtype=bool)
        for some in np.array_split(order, max(1, len(order) // _WAY_LOOKS)):
            checkpoint()
            before[some] = self._clear(ways[some, 0], points[some])
            behind[some] = self._clear(points[some], ways[some, 2])
            both = some[before[some] & behind[some]]
            if len(both):
                return points[both[:1]]
        a, b = points[before], points[behind]
        if not (len(a) and len(b)):
            return None
        i, k = (x.ravel() for x in np.meshgrid(np.arange(len(a)), np.arange(len(b)), indexing="ij"))
        pairs = np.stack([np.tile(q_0, (len(i), 1)), a[i], b[k], np.tile(q_1, (len(i), 1))], axis=1)
        order = np.argsort(about(axes, pairs), kind="stable")[: 8 * _WAY_LOOKS]
        for some in np.array_split(order, max(1, len(order) // _WAY_LOOKS)):
            checkpoint()
            good = some[self._clear(pairs[some, 1], pairs[some, 2])]
            if len(good):
                return np.asarray(pairs[good[0], 1:3])
        return None

    def _by_trees(self, q_0: Array, q_1: Array) -> Array | None:
        """Trees from both ends that grow by many places at once, each in turn towards places anywhere and then towards
        the other."""
        growths, trees = self._axes.settings.detour_tree, [_Tree(q_0), _Tree(q_1)]
        pocket = growths // 3  # a tree with fewer places after as many growths is in one
        for number in range(growths):
            checkpoint()
            one, other = trees[number % 2], trees[1 - number % 2]
            if number == pocket and min(len(tree.q) for tree in trees) < pocket:
                return None  # there is hardly a way out of where it begins or ends
            goals = self._random_free(_WAY_LOOKS)
            if not len(goals):
                continue
            grown = self._grow(one, goals)
            if not len(grown):
                continue
            # from what has grown straight to the nearest of the other, and as far towards it as is clear
            near = other.nearest(one.q[grown], self._weight)
            met = self._clear(one.q[grown], other.q[near])
            if met.any():
                i = int(np.flatnonzero(met)[0])
                way = [one.way(int(grown[i])), other.way(int(near[i]))[::-1]]
                whole = np.concatenate(way if number % 2 == 0 else [part[::-1] for part in way[::-1]])
                return np.asarray(whole[1:-1])
        return None

    def _grow(self, tree: _Tree, goals: Array) -> IndexArray:
        """Steps from the nearest places of a tree towards goals; those that are clear grow on it: their numbers."""
        near = tree.nearest(goals, self._weight)
        away = goals - tree.q[near]
        length = np.max(np.abs(away) * self._weight, axis=1)
        steps = np.minimum(1.0, _WAY_STEP / np.maximum(length, 1e-9))[:, None]
        tries = [tree.q[near] + share * away for share in (1.0, steps)]
        ends, origins = np.concatenate(tries), np.concatenate([near, near])
        can = np.flatnonzero(self._around.free(ends, self._index) & self._allowed(ends))
        can = can[self._clear(tree.q[origins[can]], ends[can])]
        return tree.add(ends[can], origins[can])

    def _fewer(self, way: Array) -> Array:
        """A way (m, n) without the points that it can do without."""
        while len(way) > 2:
            i, k = (x.ravel() for x in np.meshgrid(np.arange(len(way)), np.arange(len(way)), indexing="ij"))
            far = k > i + 1
            i, k = i[far], k[far]
            order = np.argsort(-(k - i), kind="stable")
            clear = self._clear(way[i[order]], way[k[order]])
            if not clear.any():
                return way
            first = order[np.flatnonzero(clear)[0]]
            way = np.concatenate([way[: i[first] + 1], way[k[first] :]])
        return way

    def _pulled(self, way: Array, i: int, step: float) -> bool:
        """Moves point i of a way to where the way is quickest: some shares of the way to its neighbours' middle, and a
        random step beside; whether it moved."""
        axes, here = self._axes, way[i]
        share = np.clip(
            (here - way[i - 1]) @ (way[i + 1] - way[i - 1]) / max(((way[i + 1] - way[i - 1]) ** 2).sum(), 1e-12), 0, 1
        )
        straight = way[i - 1] + share * (way[i + 1] - way[i - 1])
        pulls = here + step * np.array([1.9, 1.0, 0.5, 0.2])[:, None] * (straight - here)
        single = here + step * np.eye(axes.n) * (straight - here)
        random = here + self._random.normal(size=(_WAY_LOOKS // 2, axes.n)) * step * _WAY_TURN * np.minimum(
            axes.velocity, 1.0
        )
        tries = np.clip(np.concatenate([pulls, single, random]), axes.lower, axes.upper)
        tries = tries[self._around.free(tries, self._index) & self._allowed(tries)]

        def times(points: Array) -> Array:
            ends = [np.tile(way[k], (len(points), 1)) for k in (i - 1, i + 1)]
            legs = np.stack([ends[0], points, ends[1]], axis=1)
            length = np.linalg.norm(np.diff(legs, axis=1) * self._weight, axis=-1).sum(axis=1)
            return np.asarray(about(axes, legs) + 0.2 * length)

        now, found = float(times(here[None])[0]), times(tries)
        order = [j for j in np.argsort(found, kind="stable") if found[j] < now * (1 - 1e-3)][: _WAY_LOOKS // 4]
        if not order:
            return False
        ends = [np.tile(way[k], (len(order), 1)) for k in (i - 1, i + 1)]
        good = np.flatnonzero(self._clear(ends[0], tries[order]) & self._clear(tries[order], ends[1]))
        if not len(good):
            return False
        way[i] = tries[order[good[0]]]
        return True


class _Tree:
    """Places of the axes that straight clear ways join."""

    def __init__(self, root: Array):
        self.q, self._parent = root[None], np.array([-1])

    def nearest(self, q: Array, weight: Array) -> IndexArray:
        """The numbers (m,) of the places nearest to q (m, n)."""
        return np.asarray(np.argmin(np.max(np.abs(q[:, None] - self.q[None]) * weight, axis=2), axis=1))

    def add(self, q: Array, parents: IndexArray) -> IndexArray:
        """New places, and their numbers."""
        self.q, self._parent = np.concatenate([self.q, q]), np.concatenate([self._parent, parents])
        return np.arange(len(self.q) - len(q), len(self.q))

    def way(self, i: int) -> Array:
        """The places (m, n) from the root to number i."""
        rows = [i]
        while self._parent[rows[-1]] >= 0:
            rows.append(int(self._parent[rows[-1]]))
        return self.q[rows[::-1]]
