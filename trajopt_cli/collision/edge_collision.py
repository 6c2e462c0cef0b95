"""What the search knows of ways that touch something: which pairs of states it has looked at, and the points by which
joint moves lead around.

The search asks only about what its best route uses, and about pairs that would be about as good; so it is asked again
until nothing in the best route is new.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trajopt_cli.collision.collision_scene import CollisionScene
from trajopt_cli.collision.roadmap import Roadmap, about
from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import CheckedPairs, States
from trajopt_cli.trajectories.leg_trajectories import unwound

_AVOID_LOOKS = 64  # pairs of states of a leg that are looked at together, the best ones first.
_AVOID_APART = 0.05  # s that a straight way that is not clear costs until a way around is known.
_AVOID_ALIKE = 0.5  # s more between states of the same branches as some between which none was found.
_AVOID_FAILURES = 5  # ways that are looked for in vain in a whole program before no more are. Not measured.
_AVOID_WAYS = 8  # ways found that are tried between other states.

_TURN_ROWS = 17  # along a straight way beside something that turns: the time laws bend between them.

_HELD = 1e-9  # m of a rail that stands


class EdgeCollision:
    """straight: why joint moves, by motion, can have no points added. ended: the motion at whose end no route arrives
    that touches nothing, once a search has found none; None where that is not known."""

    def __init__(self, axes: Axes, around: CollisionScene, straight: Mapping[int, str]):
        self._axes, self.around, self._straight = axes, around, straight
        self._ways: dict[tuple[int, object], Roadmap] = {}  # by scene, and by the rails' place where they are held
        self._known: dict[int, list[Array]] = {}  # points of ways that were found, by scene
        self._joined: dict[tuple[int, int], dict[bytes, bool]] = {}  # by way and its end: from where it is clear
        self._plans: dict[int, int] = {}  # how often a way was looked for, by motion
        self._fails = 0
        self._missed, self._led = set[int](), set[int]()  # motions with no way between two states, and with one
        self.ended: int | None = None

    @property
    def stuck(self) -> int | None:
        """The motion that stands in the way of a plan, once no route was found: the first one that no way around is
        known for; None where that is not known."""
        return min(self._missed - self._led, default=self.ended)

    def scenes(self, problem: Problem, first: int, last: int) -> bytes:
        """Equal for stretches of a program with the same bodies around and in them."""
        legs = problem.legs[max(first - 1, 0) : last + 1]
        return repr([self.around.scene(leg.motion) for leg in legs]).encode()

    def way(self, leg: Leg, q_0: Array, q_1: Array) -> Array | None:
        """Points (m, n) between two places by which a joint move touches nothing, none where it needs none; None where
        none are known."""
        if self.around.free_between(q_0[None], q_1[None], leg.motion)[0]:
            return np.empty((0, len(q_0)))
        _, points = self._by_known_paths(leg, q_0[None], q_1[None])[0]
        return None if points is None else self._finder(leg, q_0).quicker(q_0, points, q_1)

    def points(self, motion: int) -> Array:
        """The points (m, n) of all ways that are known where a motion is."""
        known = self._known.get(self.around.scene(motion), [])
        return np.concatenate([np.empty((0, self._axes.n)), *known])

    def may_be(self, q: Array, motion: int) -> BoolArray:
        """Which of axes (m, n) can be an added point on a motion."""
        return self.around.free(q, motion) & self._regular(q)

    def settle(
        self, problem: Problem, k: int, edge: CheckedPairs, a: States, b: States, through: Array, pair: tuple[int, int]
    ) -> None:  # fmt: skip
        """Looks at pairs of states of leg k, first of all at one. through (n_a, n_b): the least cost of a route through
        each pair that is known."""
        checkpoint()
        open_ = np.where(edge.known, np.inf, through)
        count = min(_AVOID_LOOKS, int(np.isfinite(open_).sum()))
        best = np.argpartition(open_, count - 1, axis=None)[:count] if count < open_.size else np.arange(open_.size)
        i, j = np.unravel_index(np.sort(best), open_.shape)
        finite = np.isfinite(open_[i, j]) & ~((i == pair[0]) & (j == pair[1]))
        i, j = np.r_[pair[0], i[finite]], np.r_[pair[1], j[finite]]
        leg = problem.legs[k]
        if leg.kind is not LegKind.JOINT:
            same = (a.cfx[i] == a.cfx[pair[0]]) & (b.cfx[j] == b.cfx[pair[1]])
            i, j = i[same], j[same]
            free = self._lines_free(problem, k, a.q[i], b.q[j], a.cfx[i])
            edge.known[i, j] = True
            edge.add(i[~free], j[~free], np.full((~free).sum(), np.inf))
            return
        free = self._straight_free(leg, a.q[i], b.q[j])
        edge.known[i[free], j[free]] = True
        i, j = i[~free], j[~free]
        if not len(i):
            return
        if leg.motion in self._straight:
            edge.known[i, j] = True
            edge.add(i, j, np.full(len(i), np.inf))
            return
        found = self._by_known_paths(leg, a.q[i], b.q[j])
        if not free[0] and found[0][1] is None and not self._given_up(leg):
            self._plans[leg.motion] = self._plans.get(leg.motion, 0) + 1
            points = self._finder(leg, a.q[i[0]]).between(a.q[i[0]], b.q[j[0]])
            if points is None:
                self._fails += 1
                self._missed.add(leg.motion)
            else:
                self._led.add(leg.motion)
                self._known.setdefault(self.around.scene(leg.motion), []).append(points)
                found = self._by_known_paths(leg, a.q[i], b.q[j])
        times = np.array([T for T, _ in found])
        none = ~np.isfinite(times)
        straight = about(self._axes, np.stack([a.q[i], b.q[j]], axis=1))
        spent = self._given_up(leg)
        extra = np.where(none, np.inf if spent else _AVOID_APART, np.maximum(times - straight, 0.0))
        settled = ~none | spent
        if not free[0] and none[0]:
            extra[none & (a.cfx[i] == a.cfx[i[0]]) & (b.cfx[j] == b.cfx[j[0]])] += _AVOID_ALIKE
            extra[0], settled[0] = np.inf, True
        edge.known[i[settled], j[settled]] = True
        edge.add(i, j, extra)

    def _straight_free(self, leg: Leg, q_0: Array, q_1: Array) -> BoolArray:
        """Whether (m,) straight ways from axes q_0 to q_1 (m, n) are clear, also of what turns meanwhile."""
        if not self.around.turning(leg.motion):
            return self.around.free_between(q_0, q_1, leg.motion)
        shares = np.linspace(0, 1, _TURN_ROWS)[:, None]
        q = (q_0[:, None] + shares * (q_1 - q_0)[:, None]).reshape(-1, q_0.shape[1])
        first = _TURN_ROWS * np.arange(len(q_0))
        return self.around.free_beside(q, first, first + _TURN_ROWS - 1, leg.motion)

    def _given_up(self, leg: Leg) -> bool:
        """Whether no more ways are looked for in a leg's motion."""
        settings = self._axes.settings
        return self._plans.get(leg.motion, 0) >= settings.detours_per_motion or self._fails >= _AVOID_FAILURES

    def _finder(self, leg: Leg, q_0: Array) -> Roadmap:
        """What finds ways from q_0; the rail stays there where the leg holds it."""
        axes, held = self._axes, None
        if not leg.rail_moves:
            rail, held = axes.layout.rail, tuple(q_0[axes.layout.rail].tolist())
            lower, upper = axes.lower.copy(), axes.upper.copy()
            lower[rail] = upper[rail] = held
            axes = replace(axes, lower=lower, upper=upper)
        key = self.around.scene(leg.motion), held
        if key not in self._ways:
            self._ways[key] = Roadmap(axes, self.around, leg.motion, self._regular)
        return self._ways[key]

    def _regular(self, q: Array) -> BoolArray:
        """Which of axes (m, n) a target of a program can say: those that stand clear of singularities."""
        settings = self._axes.settings
        J = self._axes.jacobian(q, np.eye(4))[..., self._axes.layout.arm]
        return np.asarray(np.linalg.svd(J, compute_uv=False)[..., -1] >= settings.least_singular_value)

    def _by_known_paths(self, leg: Leg, q_0: Array, q_1: Array) -> list[tuple[float, Array | None]]:
        """The quickest of the known ways between places (m, n): what it takes [s], about, and its points."""
        out: list[tuple[float, Array | None]] = [(np.inf, None)] * len(q_0)
        for points in self._known.get(self.around.scene(leg.motion), [])[-_AVOID_WAYS:]:
            count = len(points)
            good = np.flatnonzero(self._joins(leg, points, 0, q_0))
            good = good[self._joins(leg, points, -1, q_1[good])]
            inner = np.broadcast_to(points, (len(good), count, q_0.shape[1]))
            ways = np.concatenate([q_0[good, None], inner, q_1[good, None]], axis=1)
            for at, T in zip(good.tolist(), about(self._axes, ways).tolist(), strict=True):
                if out[at][0] > T:
                    out[at] = T, points
        return out

    def _joins(self, leg: Leg, points: Array, end: int, q: Array) -> BoolArray:
        """From which of axes (m, n) a straight way is clear to an end of a known way, 0 or -1. The search asks for the
        same states again and again."""
        known = self._joined.setdefault((id(points), end), {})
        names = [one.tobytes() for one in q]
        new = {name: row for row, name in enumerate(names) if name not in known}
        rows, at = q[list(new.values())], np.tile(points[end], (len(new), 1))
        q_0, q_1 = (rows, at) if end == 0 else (at, rows)
        found = self.around.free_between(q_0, q_1, leg.motion)
        known.update(zip(new, found.tolist(), strict=True))
        free = np.array([known[name] for name in names], dtype=bool)
        if not leg.rail_moves:  # the rail stands on all of the way
            rail = self._axes.layout.rail
            free &= np.all(np.abs(q[:, None, rail] - points[:, rail]) <= _HELD, axis=(1, 2))
        return free

    def _lines_free(self, problem: Problem, k: int, q_0: Array, q_1: Array, cfx: IndexArray) -> BoolArray:
        """Whether (m,) lines, arcs and waits between axes (m, n) are clear, the rail in proportion to the way."""
        leg, axes, m = problem.legs[k], self._axes, len(q_0)
        segment = problem.segment(k)
        rails = np.stack([q_0[:, axes.layout.rail], q_1[:, axes.layout.rail]])
        far = max(segment.length, 0.3 * segment.angle, float(np.abs(np.diff(rails, axis=0)).max(initial=0.0)))
        shares = np.linspace(0, 1, 2 + int(far / 0.01))
        X = segment.pose(shares) @ inverse_pose(leg.X_FT)
        d = (rails[0][:, None] + shares[:, None] * (rails[1] - rails[0])[:, None]).reshape(m * len(shares), -1)
        known = cfx >= 0
        branch = np.where(known, cfx, 0)
        arm = axes.branch(np.tile(X, (m, 1, 1)), axes.layout.value(d), np.repeat(branch, len(shares)))
        starts = len(shares) * np.arange(m)
        arm = unwound(arm, starts, q_0[:, axes.layout.arm])
        q = axes.layout.merge(d, arm)
        reached = np.isfinite(arm).all(axis=1).reshape(m, -1).all(axis=1)
        out = ~known | reached
        some = np.flatnonzero(known & reached)
        if len(some):
            first, last = starts[some], starts[some] + len(shares) - 1
            if leg.units:  # they turn in step with the way
                turns = np.tile(shares, (max(self.around.turning(leg.motion), 1), m)).T
                out[some] = self.around.ways_free(q, first, last, leg.motion, turns)
            else:
                out[some] = self.around.free_beside(q, first, last, leg.motion)
        return np.asarray(out)
