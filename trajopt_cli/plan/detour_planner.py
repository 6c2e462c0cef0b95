"""Legal motions that touch nothing: routes that the search finds clear, with points before joint moves where the
straight way is not.

The points become motions of the program. Their zones are the largest that stay clear, of those that a controller has.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.collision.collision_scene import CollisionScene, collision_scene_of
from trajopt_cli.collision.edge_collision import EdgeCollision
from trajopt_cli.collision.motion_collision import names_on, touching
from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.by_rails import search
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, Runs, about, timed
from trajopt_cli.problem.detours import Detour, Via
from trajopt_cli.problem.problem import Coupling, LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.route import IkBranch, Route

_TUNE_STEPS = (0.8, 0.5, 0.5, 0.3, 0.3, 0.15, 0.15)  # rad, m by which added points are moved, in turn.
_TUNE_TRIES = 16  # places each is tried at.
_TUNE_FIRST = 80  # the same in the first turn.

Detoured = Callable[[frozenset[int], Sequence[Detour]], Problem]
"""The problem of the program with points, without the motions that are left out."""
Shifted = Callable[[Problem, Route], list[Route]]
"""Routes near a route that may be faster."""


@dataclass(frozen=True, eq=False)
class ClearPlan:
    """A motion that touches nothing, its problem and route, and the points of the program that it has."""

    problem: Problem
    route: Route
    iterate: Iterate
    detours: tuple[Detour, ...]


class NoClearPath(Exception):
    """Every motion that was found touches something; legs: numbers of those of the best one that do, with the route it
    was timed from. Without either, no route was found that touches nothing, and legs are where it ends."""

    def __init__(
        self, problem: Problem, legs: tuple[int, ...], iterate: Iterate | None = None, route: Route | None = None
    ):
        super().__init__(legs)
        self.problem, self.legs, self.iterate, self.route = problem, legs, iterate, route


def clear_motions(
    axes: Axes, bound: Problem, problem: Problem, straight: Mapping[int, str], groups: Sequence[Sequence[int]],
    detoured: Detoured, shifted: Shifted, runs: Runs | None,
) -> Iterator[ClearPlan]:  # fmt: skip
    """Motions that touch nothing, in no order; none where no route does and nobody knows where that ends. bound: the
    problem with one progress for all axes. straight: why joint moves can have no points; groups: those that must have
    the same. Raises NotDriven and NoClearPath."""
    settings = axes.settings
    around = collision_scene_of(problem)
    assert around is not None
    avoid = EdgeCollision(axes, around, straight)
    route = search(axes, bound, avoid)
    if route is None:
        if avoid.stuck is not None:
            raise NoClearPath(problem, tuple(k for k, leg in enumerate(problem.legs) if leg.motion == avoid.stuck))
        return
    points: dict[int, Array] = {}
    for k, leg in enumerate(bound.legs):
        if leg.kind is LegKind.JOINT:
            way = avoid.way(leg, route.q[k], route.q[k + 1])
            assert way is not None  # the search settles what its route uses
            if len(way):
                points[leg.motion] = way
    names = {
        leg.motion: names_on(around, route.q[k : k + 2], leg.motion)
        for k, leg in enumerate(bound.legs)
        if leg.motion in points
    }
    ends = {leg.motion: route.q[k : k + 2] for k, leg in enumerate(bound.legs) if leg.kind is LegKind.JOINT}
    for group in groups:
        ways = [(points[motion], names[motion]) for motion in group if motion in points]
        if ways:
            members = [(motion, ends[motion]) for motion in group if motion in ends]
            way, name = next((one for one in ways if _serves_all(around, one[0], members)), ways[0])
            for motion, _ in members:
                points[motion], names[motion] = way, name
    shared = {motion for group in groups if len(group) > 1 for motion in group}
    radii = dict.fromkeys(((motion, i) for motion, way in points.items() for i in range(len(way))), 0)
    failure: NotDriven | NoClearPath | None = None
    found = False

    def made() -> tuple[Problem, Route, tuple[Detour, ...]]:
        settings = axes.settings
        detours = tuple(
            Detour(
                motion, tuple(Via(q, settings.detour_zones[radii[motion, i]]) for i, q in enumerate(way)), names[motion]
            )
            for motion, way in sorted(points.items())
        )
        with_points = detoured(problem.dropped, detours) if detours else problem
        return with_points, _route_with_points(axes, with_points, bound, route, points), detours

    tuned = not points.keys() - shared
    for _ in range(len(settings.detour_zones) * max(len(radii), 1) + 1):
        with_points, through, detours = made()
        smaller, clear = set[tuple[int, int]](), False
        for one in [through, *shifted(with_points, through)]:
            try:
                driven = timed_clear(axes, with_points, one, runs)
            except NotDriven as said:
                failure = failure or said
                continue
            if isinstance(driven, Iterate):
                found = clear = True
                yield ClearPlan(with_points, one, driven, detours)
            else:
                failure = driven
                if one is through:
                    smaller = _points_beside(with_points, driven.legs, points)
        if clear and not tuned:
            tuned = True
            if _tune(axes, avoid, with_points, through, points, shared):
                continue
        if clear or not smaller or all(radii[one] == len(settings.detour_zones) - 1 for one in smaller):
            break
        for point in smaller:
            radii[point] = min(radii[point] + 1, len(settings.detour_zones) - 1)
    if not found and failure is not None:
        raise failure


def _tune(
    axes: Axes, avoid: EdgeCollision, problem: Problem, route: Route, points: dict[int, Array], shared: Collection[int]
) -> bool:  # fmt: skip
    """Moves points to where their runs with their corners are quicker, as long as the straight ways beside stay clear;
    whether any moved."""
    random, q = np.random.default_rng(36), route.q.copy()
    cfx = tuple(label.cfx for label in route.labels)
    gained = False
    places = [
        (k + 1, motion, number) for motion, number, k in _numbered_points(problem, points) if motion not in shared
    ]
    for turn, step in enumerate(_TUNE_STEPS):
        for k, motion, number in places:
            checkpoint()
            near = [run for run in problem.runs if run[0] <= k <= run[1]]
            spread = step * np.minimum(axes.velocity, 1.0)
            tries = q[k] + random.normal(size=(_TUNE_TRIES if turn else _TUNE_FIRST, axes.n)) * spread
            others = avoid.points(motion) if turn == 0 else tries[:0]
            tries = np.concatenate(
                [tries, others, q[k] + 0.5 * step * np.eye(axes.n) * (q[k - 1] + q[k + 1] - 2 * q[k])]
            )
            tries = np.clip(tries, axes.lower, axes.upper)
            if not problem.legs[k - 1].rail_moves:
                tries[:, axes.layout.rail] = q[k, axes.layout.rail]
            tries = tries[avoid.may_be(tries, motion)]
            ends = [np.tile(q[i], (len(tries), 1)) for i in (k - 1, k + 1)]
            clear = avoid.around.free_between(ends[0], tries, motion)
            clear &= avoid.around.free_between(tries, ends[1], motion)
            moved = [q]
            for point in tries[clear]:
                moved.append(q.copy())
                moved[-1][k] = point
            times = about(axes, coordinated(problem), near * len(moved), [one for one in moved for _ in near], cfx)
            times = times.reshape(len(moved), -1).sum(axis=1)
            best = int(np.argmin(times))
            if times[best] < times[0] * (1 - 1e-4):
                q, gained = moved[best], True
                points[motion] = points[motion].copy()
                points[motion][number] = q[k]
    return gained


def _serves_all(around: CollisionScene, way: Array, members: Sequence[tuple[int, Array]]) -> bool:
    """Whether all of some joint moves, each with its ends (2, n), are clear by the same points."""
    return all(around.way_free(np.concatenate([ends[:1], way, ends[1:]]), motion) for motion, ends in members)


def timed_clear(axes: Axes, problem: Problem, route: Route, runs: Runs | None) -> Iterate | NoClearPath:
    """A route as timed; runs in which free axes would touch something with one progress for all axes. Raises
    NotDriven."""
    iterate = timed(axes, problem, route, runs)
    legs = touching(axes, problem, iterate)
    if not legs:
        return iterate
    if not problem.coordinated:
        together = timed(axes, coordinated(problem), route, runs)
        mixed = list(iterate.legs)
        for first, last in problem.runs:
            if any(first <= k < last for k in legs):
                mixed[first:last] = together.legs[first:last]
        iterate = replace(iterate, legs=tuple(mixed))
        legs = touching(axes, problem, iterate)
    return NoClearPath(problem, legs, iterate, route) if legs else iterate


def coordinated(problem: Problem) -> Problem:
    """The problem with one progress for all axes of a leg."""
    return problem if problem.coordinated else replace(problem, coupling=Coupling.COORDINATED)


def _route_with_points(
    axes: Axes, with_points: Problem, problem: Problem, route: Route, points: Mapping[int, Array]
) -> Route:
    """A route of the problem as one of that with points before motions."""
    if with_points is problem or not points:
        return route
    q, w, labels, times = [route.q[:1]], [route.w[:1]], [route.labels[0]], []
    for k, leg in enumerate(problem.legs):
        way = points.get(leg.motion, np.empty((0, axes.n))) if leg.kind is LegKind.JOINT else np.empty((0, axes.n))
        q += [way, route.q[k + 1 : k + 2]]
        w += [np.zeros_like(way), route.w[k + 1 : k + 2]]
        labels += [*(_branch_at(axes, point) for point in way), route.labels[k + 1]]
        times += [route.times[k] / (len(way) + 1)] * (len(way) + 1)
    return Route(np.concatenate(q), np.concatenate(w), tuple(labels), np.array(times), route.cost)


def _branch_at(axes: Axes, q: Array) -> IkBranch:
    """The configuration of axes q (n,)."""
    arm = q[axes.layout.arm]
    branches = axes.inverse(axes.forward(q)[None], q[None, axes.layout.rail])[0]
    turns = 2 * np.pi * np.round((arm - branches) / (2 * np.pi))
    off = np.abs(branches + turns - arm).max(axis=1)
    cfx = int(np.nanargmin(off))
    return IkBranch(cfx, turns[cfx])


def _points_beside(problem: Problem, legs: Sequence[int], points: Mapping[int, Array]) -> set[tuple[int, int]]:
    """The points beside legs, as motion of the program and number."""
    out = set()
    for motion, number, k in _numbered_points(problem, points):
        if k in legs or k + 1 in legs:
            out.add((motion, number))
    return out


def _numbered_points(problem: Problem, points: Mapping[int, Array]) -> Iterator[tuple[int, int, int]]:
    """Of every point its motion in the program without points, its number there, and the leg that ends at it."""
    before, at = 0, {}
    for motion, way in sorted(points.items()):
        for number in range(len(way)):
            at[motion + before + number] = motion, number
        before += len(way)
    for k, leg in enumerate(problem.legs):
        if leg.motion in at:
            yield *at[leg.motion], k
