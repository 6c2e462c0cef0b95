"""Room between bodies in the nonlinear program: distances at a motion's nodes, linear about the motion at hand.

A distance is a smooth function of the axes but where nearest points jump. The program holds tangents of it, and is
solved anew about each answer. Convex bodies apart stay on their sides of the plane between their nearest points, which
asks for more than it must; what turns between two answers may come nearer than its tangents say. So an answer counts by
a look at its distances, never by these rows.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Leg, Problem
from trajopt_cli.settings import Settings
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import ClearanceQueries
from trajopt_cli.trajectories.iterate import Iterate, Margins
from trajopt_cli.trajectories.leg_trajectories import JointNodes, LegMotion, PathLeg, sample_times
from trajopt_cli.trajectories.unit_shares import unit_shares

# m that an answer may be inside a body and still find the way out. Measured on eight windows beside a box, with first
# answers 44 to 125 mm deep: without it two had no clean answer; five with answers 5 to 24 mm deep ended the same with
# 0.01, in 1.2 to 1.6 times the time.
_SHALLOW = 0.03
_MORE_ROOM = 1.2  # times what bodies come nearer between two nodes that the nodes keep from then on.
_FAR = 0.3  # m within which pairs have rows, in place of `near`, on a leg whose first answer went deep into something.
_SAMPLE_STEP = 0.01  # s between two looks at the distances at most. Not measured.
_CLEAR_LOOKS = 3  # at the distances within an interval at least.


@dataclass(frozen=True, eq=False)
class Tangents:
    """At the nodes of one leg: gradient (N+1, PAIRS, n) times the axes is least (N+1, PAIRS) [m] or more. What no pair
    of bodies needs has zeros, and -1 m."""

    gradient: Array
    least: Array

    @classmethod
    def about(
        cls, scene: ClearanceQueries, leg: Leg, q: Array, room: Array, settings: Settings,
        fixed: Collection[int] = (), within: float | None = None, own: bool = False, turns: Array | None = None,
    ) -> Tangents | None:  # fmt: skip
        """Of the pairs that are nearest at axes q (N+1, n), where these are numbers; None where none is within [m].
        own: of the robot with itself, too.

        room (N+1,): what is asked for beyond the distance wanted [m]; a hair at least where there is one. A node that
        is fixed stays as it is. turns (N+1, U): how far units have turned at the nodes.
        """
        there = np.flatnonzero(np.isfinite(q).all(axis=1))
        turned = None if turns is None else turns[there]
        found = scene.contacts(q[there], leg.motion, settings.near if within is None else within, turned)
        order = np.argsort(found.distance, kind="stable")
        order = order if own else order[~found.own[order]]
        if not len(order):
            return None
        out = cls.none(len(q), q.shape[1], settings.body_pairs)
        filled = np.zeros(len(q), dtype=np.intp)
        for i in order.tolist():
            node, distance, gradient = int(there[found.row[i]]), float(found.distance[i]), found.gradient[i]
            if filled[node] < settings.body_pairs:
                asked = max(room[node], min(settings.clearance_margin_nlp, distance))
                asked = min(asked, distance) if node in fixed else asked
                out.gradient[node, filled[node]] = gradient
                out.least[node, filled[node]] = gradient @ q[node] - distance + asked
                filled[node] += 1
        return out

    @classmethod
    def none(cls, nodes: int, n: int, pairs: int) -> Tangents:
        """Of so many nodes, axes and rows with nothing near."""
        return cls(np.zeros((nodes, pairs, n)), np.full((nodes, pairs), -1.0))


class Clearances:
    """What the motions of one window keep clear of, as its solves ask for it one after the other."""

    def __init__(self, axes: Axes, problem: Problem, scene: ClearanceQueries | None):
        self._axes, self._problem = axes, problem
        self._scene = scene
        self._beside = set[int]()  # legs that had tangents once: they keep their rows
        self._touched = set[int]()  # legs that came too near to something once
        self._through = set[int]()  # legs that went deep into something: they look farther
        self._known: dict[tuple[int, LegMotion], tuple[Array, Array]] = {}  # every round asks about each motion twice

    def tangents(self, iterate: Iterate, margins: Sequence[Margins | None]) -> dict[int, Tangents]:
        """About an iterate by leg: of those on grids beside something that stands, or that came too near to anything.
        The robot's links are always near each other, so they have none before that."""
        settings = self._axes.settings
        out: dict[int, Tangents] = {}
        if self._scene is None:
            return out
        for k, (leg, motion, m) in enumerate(zip(self._problem.legs, iterate.legs, margins, strict=True)):
            if m is None or not isinstance(motion, PathLeg | JointNodes):
                continue
            q = (
                self._axes.layout.merge(motion.rail, motion.node_arm(self._axes))
                if isinstance(motion, PathLeg)
                else motion.q
            )
            fixed = [node for node, i in ((0, k), (motion.N, k + 1)) if self._given(i)]
            within = _FAR if k in self._through else settings.near
            turns = self._turns(k, motion, motion.breaks())
            found = Tangents.about(self._scene, leg, q, m.room, settings, fixed, within, k in self._touched, turns)
            if found is not None or k in self._beside:
                self._beside.add(k)
                out[k] = found or Tangents.none(q.shape[0], q.shape[1], settings.body_pairs)
        return out

    def _given(self, k: int) -> bool:
        """Whether nothing is left to choose at waypoint k but velocities."""
        point = self._problem.waypoints[k]
        return not point.free and point.turn is None

    def touches(self, k: int, motion: LegMotion) -> bool:
        """Whether leg k comes nearer to anything than wanted, if it moves so."""
        if self._scene is None:
            return False
        near = self._least(k, motion) < 0.0
        if near:
            self._touched.add(k)
        return near

    def through(self, start: Iterate, found: Iterate) -> set[int]:
        """Legs that go deep into something, for the first time and from a start that does not: where the way out leads
        is told by the start. They have rows from now on."""
        out = set[int]()
        for k, (before, motion) in enumerate(zip(start.legs, found.legs, strict=True)):
            if self._scene is None or motion is None or before is None or k in self._through:
                continue
            if self._least(k, motion) < -_SHALLOW < self._least(k, before):
                out.add(k)
        self._touched |= out
        self._through |= out
        return out

    def make_room(self, iterate: Iterate, margins: Sequence[Margins | None]) -> bool:
        """Whether any leg on a grid comes nearer to anything than wanted; where it does so between two nodes, they keep
        farther off from now on."""
        near = [k for k, motion in enumerate(iterate.legs) if margins[k] and motion and self.touches(k, motion)]
        for k in near:
            m, motion = margins[k], iterate.legs[k]
            assert m is not None
            assert motion is not None
            at, between = self._distances(k, motion)
            touching = between < 0.0
            dip = _MORE_ROOM * np.maximum(np.minimum(at[:-1], at[1:]) - between, 0.0)
            for nodes in (slice(0, -1), slice(1, None)):
                room = m.room[nodes]
                room[touching] = np.maximum(room, dip)[touching] + self._axes.settings.clearance_margin_nlp
        return bool(near)

    def _least(self, k: int, motion: LegMotion) -> float:
        """The least distance of leg k beyond that wanted [m]."""
        return float(min(x.min() for x in self._distances(k, motion)))

    def _turns(self, k: int, motion: LegMotion, t: Array) -> Array | None:
        """How far units have turned (m, U) at times t (m,) of leg k; None where they turn no bodies."""
        if self._scene is None or not self._scene.turning(self._problem.legs[k].motion):
            return None
        return unit_shares(self._problem, k, motion, t)[0]

    def _distances(self, k: int, motion: LegMotion) -> tuple[Array, Array]:
        """The least distance beyond that wanted [m] at every break of leg k's motion (N+1,), and between them (N,)."""
        if (known := self._known.get((k, motion))) is not None:
            return known
        assert self._scene is not None
        settings = self._axes.settings
        t, first = sample_times(motion, _SAMPLE_STEP, _CLEAR_LOOKS + 1, settings.most_samples)
        q = motion.sample(self._axes, t).q
        there = np.isfinite(q).all(axis=1)
        found = np.full(len(t), -np.inf)
        turns = self._turns(k, motion, t[there])
        found[there] = self._scene.distances(q[there], self._problem.legs[k].motion, turns)
        inner = found[:-1].copy()
        inner[first] = np.inf
        self._known[k, motion] = found[np.append(first, -1)], np.minimum.reduceat(inner, first)
        return self._known[k, motion]
