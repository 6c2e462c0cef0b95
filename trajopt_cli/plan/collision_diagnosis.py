"""Where a program makes the robot touch something: what it is, how deep at least, what was tried, what would help."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.collision.collision_scene import CollisionScene, Hit, collision_scene_of
from trajopt_cli.collision.motion_collision import hit_on
from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.by_rails import one_sought
from trajopt_cli.graph_search.ik_tables import IkTable, grid_in_reach, station_table
from trajopt_cli.motion import Move, motion_name
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, Runs
from trajopt_cli.plan.detour_planner import NoClearPath, coordinated, timed_clear
from trajopt_cli.problem.corners import corners_of
from trajopt_cli.problem.detours import radii, zone_of
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.plant import shown_rail
from trajopt_cli.problem.problem import Coupling, LegKind, Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate

_NOWHERE = "cannot be driven clear: no configuration and rail position serves all points and lines around it"


def blocked_place(axes: Axes, problem: Problem) -> Infeasible | None:
    """The first waypoint or line that touches something from every rail position in every configuration; None where
    there is no such one."""
    around = collision_scene_of(problem)
    if around is None:
        return None
    for first, last in problem.stations:
        out = _blocked_station(axes, problem, around, first, last)
        if out is not None:
            return out
    return None


def _blocked_station(axes: Axes, problem: Problem, around: CollisionScene, first: int, last: int) -> Infeasible | None:
    """Of several rails each is sought with the others held in places all over their strokes; the first such schedule
    from which the arm is long enough says what is touched."""
    settings = axes.settings
    if first == last and problem.waypoints[first].q is not None:
        return _blocked_joints(problem, around, first)
    touched: list[tuple[Axes, Problem, Array, IkTable]] = []
    for one, own in one_sought(axes, problem):
        d = grid_in_reach(one, own, first, last, settings.coarse_grid, settings.coarse_spacing)
        if _serves_all(station_table(one, own, first, last, d, around)):
            return None
        free = station_table(one, own, first, last, d)
        if _serves_all(free):  # else for another reason
            touched.append((one, own, d, free))
    if not touched:
        return None
    found = _what_blocks(*touched[0], around, first, last)
    if axes.layout.r < 2:
        return found
    held = f"the same in {len(touched)} such rows, one axis tried and the others held"
    return replace(found, message=f"{found.message}; {held}")


def _what_blocks(
    axes: Axes, problem: Problem, d: Array, free: IkTable, around: CollisionScene, first: int, last: int
) -> Infeasible:
    for k in range(first, last + 1):
        if not station_table(axes, problem, k, k, d, around).labels if problem.waypoints[k].q is None else False:
            q = _all_axes(axes, problem, k, d, free.waypoints[k - first][:, None])
            return _deepest_of_least(
                axes, problem, around, max(problem.waypoints[k].motion, 0), _beside(problem, k), q, d
            )
        leg = problem.legs[k] if k < last else None
        line = free.line(k - first) if leg is not None else None
        if leg is None or line is None:
            continue
        q = _all_axes(axes, problem, k, d, line)
        clear = around.free(q, leg.motion).reshape(line.shape[:3]) | np.isnan(line[..., 0])
        had = ~np.isnan(line[..., 0]).any(axis=1)
        if not (clear.all(axis=1) & had).any():
            # from each rail position the worst of the line counts
            return _deepest_of_least(axes, problem, around, leg.motion, [leg.motion], q, d, line.shape[1])
    index = problem.waypoints[last].motion
    motion = problem.motion(index)
    return Infeasible(index, motion.source, f"{motion_name(motion)} {_NOWHERE}")


def _serves_all(table: IkTable) -> bool:
    return bool(table.labels) and table.serves_lines


def _all_axes(axes: Axes, problem: Problem, k: int, d: Array, arm: Array) -> Array:
    """All axes (i, n) of joints (..., nodes, rail positions, m) on the way from waypoint k, other rails as held."""
    q = axes.layout.join(np.broadcast_to(d, arm.shape[:-1]), arm)
    before, behind = (np.array(one.held) for one in (problem.waypoints[k : k + 2] * 2)[:2])
    q[..., axes.layout.others] = before + np.linspace(0, 1, arm.shape[-3])[:, None, None] * (behind - before)
    return q.reshape(-1, axes.n)


def _blocked_joints(problem: Problem, around: CollisionScene, k: int) -> Infeasible | None:
    q = problem.waypoints[k].q
    assert q is not None
    for index in _beside(problem, k):
        hit = next(iter(around.hits(q[None], index)), None)
        if hit is not None:
            place = max(problem.waypoints[k].motion, 0)
            motion = problem.motion(place)
            name = motion_name(motion) if problem.waypoints[k].motion >= 0 else "the start"
            return Infeasible(place, motion.source, f"{name} cannot be clear: {hit.said}", -hit.missing)
    return None


def _beside(problem: Problem, k: int) -> list[int]:
    """The motions that lead to a waypoint and away from it."""
    return sorted({problem.legs[i].motion for i in (k - 1, k) if 0 <= i < len(problem.legs)})


def _deepest_of_least(
    axes: Axes, problem: Problem, around: CollisionScene, index: int, during: Sequence[int], q: Array, d: Array,
    nodes: int = 1,
) -> Infeasible:  # fmt: skip
    """What is least deep of all that axes q (labels x nodes x rail positions, n) touch, of the worst node of each."""
    ways = np.swapaxes(q.reshape(-1, nodes, len(d), axes.n), 1, 2).reshape(-1, nodes, axes.n)
    ways = ways[~np.isnan(ways).any(axis=(1, 2))]
    apart = [around.distances(ways.reshape(-1, axes.n), motion) for motion in during] if len(ways) else []
    least = np.min(apart, axis=0).reshape(-1, nodes).min(axis=1) if apart else np.zeros(0)
    hits = [hit for motion in during if len(ways) for hit in around.hits(ways[np.argmax(least)], motion)]
    best: Hit | None = max(hits, key=lambda one: one.missing, default=None)
    if best is None:
        return Infeasible(index, problem.motion(index).source, f"{motion_name(problem.motion(index))} {_NOWHERE}")
    tried = ""
    if axes.layout.has_rail and len(d) > 1:
        name = problem.plant.limits.names[axes.layout.sought]
        tried = f"; tried {_rail_positions(d, name)}, least so at {shown_rail(best.q[axes.layout.rail], '.0f')}"
    motion = problem.motion(index)
    said = f"{motion_name(motion)} cannot be driven clear: {best.said}{tried}"
    return Infeasible(index, motion.source, said, -best.missing)


def collision_answer(axes: Axes, failure: NoClearPath, runs: Runs | None = None) -> Infeasible:
    """The answer no where every motion that was found touches something: what the best one does, where its end was
    tried, and which zones would do where it is in a corner."""
    settings = axes.settings
    assert failure.iterate is not None
    problem, k = failure.problem, failure.legs[0]
    leg = problem.legs[k]
    motion, hit = problem.motion(leg.motion), hit_on(axes, problem, failure.iterate, k)
    said = "touches something" if hit is None else f"cannot be driven clear: {hit.said}"
    first, last = next(one for one in problem.stations if one[0] <= k + 1 <= one[1])
    d = grid_in_reach(axes, problem, first, last, settings.coarse_grid, settings.coarse_spacing)
    if zones := _zones_that_do(axes, failure, runs):
        said += f"; {zones}"
    elif axes.layout.has_rail and len(d) > 1:
        no = "no way around was found" if leg.kind is LegKind.JOINT else "nothing clear was found"
        one = _rail_positions(d, "rail") if axes.layout.r < 2 else "each axis under the base with the others held"
        said += f"; {no}, tried {one}"
    return Infeasible(leg.motion, motion.source, f"{motion_name(motion)} {said}", 0.0 if hit is None else -hit.missing)


def _rail_positions(d: Array, name: str) -> str:
    """Positions [m] of a rail that were tried."""
    return f"from {name} {d[0] * 1e3:.0f} to {d[-1] * 1e3:.0f} mm, {len(d)} positions in all configurations"


def _zones_that_do(axes: Axes, failure: NoClearPath, runs: Runs | None) -> str:
    """The largest standard zones, in words, with which the motion that touches something would not; none where its
    corners are not why."""
    problem, route = failure.problem, failure.route
    beside = [problem.waypoints[leg + i] for leg in failure.legs for i in (0, 1)]
    corners: dict[int, tuple[Move, float]] = {}
    for point in beside:
        move = problem.motion(point.motion)
        if point.fly_by is not None and not point.fly_by.in_place and isinstance(move, Move) and not move.detour:
            corners[point.motion] = move, point.fly_by.radius
    if route is None or not corners:
        return ""

    def smaller(size: float | None) -> dict[int, float | None]:
        return {index: size for index, (_, radius) in corners.items() if size is None or size < radius}

    def would_do(size: float | None) -> bool:
        other = _with_zones(problem, smaller(size))
        try:
            both = {other.coupling: other, Coupling.COORDINATED: coordinated(other)}
            ways = [timed_clear(axes, one, route, runs) for one in both.values()]
        except NotDriven:
            return False
        return all(isinstance(way, Iterate) for way in ways)

    sizes = [None, *(size for size in radii() if smaller(size))]
    if not would_do(None):
        return ""
    good, bad = 0, len(sizes)
    while bad - good > 1:
        middle = (good + bad) // 2
        good, bad = (middle, bad) if would_do(sizes[middle]) else (good, middle)
    name, moves = zone_of(sizes[good]).name, [corners[index][0] for index in smaller(sizes[good])]
    said = dict.fromkeys(f"{name} instead of {move.zone.name} at {move.target}" for move in moves)
    return f"it would be clear with {' and '.join(said)}"


def _with_zones(problem: Problem, sizes: dict[int, float | None]) -> Problem:
    """The problem with other zones [m] at the end of some motions, None for stops."""
    motions = list(problem.program.motions)
    for index, size in sizes.items():
        move = motions[index]
        assert isinstance(move, Move)
        motions[index] = replace(move, zone=zone_of(size))
    passed = corners_of(replace(problem.program, motions=tuple(motions)), problem.plant, problem.dropped).passed
    points = (replace(one, fly_by=passed.get(one.motion)) if one.motion in sizes else one for one in problem.waypoints)
    return replace(problem, waypoints=tuple(points))
