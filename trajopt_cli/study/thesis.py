"""Row `thesis`: the rail heuristic of Krotký 2014, 5.2, with legal timing under every limit.

The thesis chooses the rail first and the arm's motion after it. Its generator knows no joint limits; here each leg is
timed under all of them, so that the row can stand beside legal ones. What the text leaves open is read as follows.

- A functional area is the longest run of stations (points joined by lines and arcs) that one rail position serves.
- Where an area begins the rail stands nearest to where it comes from. Inside it goes on towards the next point that is
  out of reach from where it stands, or when all are in reach towards the next area, while the arm moves and as far as
  the arm's own time for the move allows; it goes back only where a point is out of reach otherwise.
- That time is the generator's: each carriage-relative axis from rest to rest under the tool's caps, an arc as one axis
  along it.

The thesis has no corners. The program's own are driven here as in every other row: its fly-by points are passed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Motion, Move, MoveJ, MoveL, PathMove, PoseMove, Program, motion_name
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.editable import droppable
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.workspace import rail_ranges
from trajopt_cli.study.case import Answer, Attempt, Case, NotApplicable, RailRule
from trajopt_cli.study.practice import with_rail
from trajopt_cli.timing.double_integrator import trapezoid_time
from trajopt_cli.units import DEG

_SAME = 1e-9  # m


@dataclass(frozen=True, eq=False)
class WorkPoint:
    """One point of the program. motion: its index. ranges (m, 2): rail positions that serve it [m]. time [s]: the arm's
    own for the move that leads here. station: number of its station; its points are joined by lines and arcs."""

    motion: int
    ranges: Array
    time: float
    station: int


def thesis(case: Case) -> Answer:
    """The program with the heuristic's rail positions and rail speeds, as the RAPID controller drives it.

    Infeasible where a work point has no rail position, and where the trajectory between them leaves the workspace (the
    thesis' last step).
    """
    if not case.plant.robot.has_rail:
        return NotApplicable("the robot rides no rail")
    if case.plant.layout.r > 1:
        return NotApplicable("the robot rides several rails")
    if any(isinstance(motion, Move) and motion.hold for motion in case.program.motions):
        return NotApplicable("the heuristic drives the rail in moves in which it must stand still")
    rule = case.rule
    points = work_points(case.program, case.plant, rule)
    if isinstance(points, Infeasible):
        return points
    areas = functional_areas(points)
    chosen = rail_positions(points, areas, case.plant, rule)
    program = _driven(case.program, case.plant, points, areas, chosen, rule)
    plan = case.solve(program, Target.RAPID, replace(AS_WRITTEN, configuration=True, drop=True))
    if isinstance(plan, Infeasible):
        return plan
    least = float(np.arcsin(np.abs(np.cos(plan.trajectory.q[:, 3])).min()))
    work = sum(any(isinstance(case.program.motions[points[k].motion], PoseMove) for k in area) for area in areas)
    notes = (
        f"{work} functional area{'s' * (work != 1)}; joint 3 stays {least / DEG:.1f} deg from the stretched elbow "
        f"(phi_min {rule.phi_min / DEG:g} deg at the points)",
    )
    return Attempt(case.program, plan.trajectory, plan, notes)


def work_points(program: Program, plant: Plant, rule: RailRule) -> list[WorkPoint] | Infeasible:
    """Every point but those that may be dropped (the thesis leaves the detours out), with its rail ranges.

    A joint target stands on the one rail position the program gives it.
    """
    out: list[WorkPoint] = []
    rail, station = float(plant.layout.place(plant.start)), 0
    X_WT = plant.robot.forward(plant.start)
    detours = droppable(program, plant)
    for i, motion in enumerate(program.motions):
        if not isinstance(motion, Move) or i in detours:
            continue
        given = plant.rail_value(motion.extax)
        rail = rail if given is None else float(given[0])
        if not isinstance(motion, PathMove):
            station += 1
        if isinstance(motion, PoseMove):
            ranges = _ranges(motion, plant, rule)
            if not len(ranges):
                why = f"no rail position keeps joint 3 {rule.phi_min / DEG:g} deg from the stretched elbow there"
                return Infeasible(i, motion.source, f"{motion_name(motion)}: {why}")
            X_before, X_WT = X_WT, motion.X_WT
            out.append(WorkPoint(i, ranges, _arm_time(motion, X_before, plant), station))
        else:
            out.append(WorkPoint(i, np.array([[rail, rail]]), 0.0, station))
    return out


def functional_areas(points: Sequence[WorkPoint]) -> list[range]:
    """Runs of points that one rail position serves, never parting a station, each as long as it can be."""
    areas: list[range] = []
    common = np.zeros((0, 2))
    for first, last in _stations(points):
        own = points[first].ranges
        for point in points[first + 1 : last]:
            own = _overlap(own, point.ranges)
        joined = _overlap(common, own)
        if areas and len(joined):
            areas[-1], common = range(areas[-1].start, last), joined
        else:
            areas.append(range(first, last))
            common = own
    return areas


def rail_positions(points: Sequence[WorkPoint], areas: Sequence[range], plant: Plant, rule: RailRule) -> list[float]:
    """The rail at every point [m]."""
    speed, acceleration = _area_speed(plant, rule), float(plant.layout.place(plant.limits.acceleration))
    rail = float(plant.layout.place(plant.start))
    out: list[float] = []
    for number, area in enumerate(areas):
        following = points[areas[number + 1].start] if number + 1 < len(areas) else None
        direction = 0.0
        for k in area:
            if k == area.start:
                rail = _nearest(points[k].ranges, rail)
            else:
                goal = _next_position(points, area, k, rail, following)
                way = 0.0 if (goal - rail) * direction < 0 else goal - rail
                most = _way(points[k].time, speed, acceleration)
                now = _nearest(points[k].ranges, rail + float(np.clip(way, -most, most)))
                direction = direction or float(np.sign(now - rail))
                rail = now
            out.append(rail)
    return out


def _next_position(points: Sequence[WorkPoint], area: range, k: int, rail: float, following: WorkPoint | None) -> float:
    """Where the rail goes next: to the first point of the area, from k on, that is out of reach from where it stands;
    with none left, to where the area's last point is served from nearest to the next area."""
    for point in points[k : area.stop]:
        needed = _nearest(point.ranges, rail)
        if abs(needed - rail) > _SAME:
            return needed
    if following is None:
        return rail
    return _nearest(points[area[-1]].ranges, _nearest(following.ranges, rail))


def _driven(
    program: Program, plant: Plant, points: Sequence[WorkPoint], areas: Sequence[range], rail: list[float],
    rule: RailRule,
) -> Program:  # fmt: skip
    """The program with the chosen rail positions, the rail's speed capped as the rule says."""
    where = {point.motion: position for point, position in zip(points, rail, strict=True)}
    inside = {points[k].motion for area in areas for k in area[1:]}
    positions, now = [], float(plant.layout.place(plant.start))
    motions: list[Motion] = []
    for i, motion in enumerate(program.motions):
        now = where.get(i, now)
        positions.append(now)
        if isinstance(motion, Move):
            cap = _area_speed(plant, rule) if i in inside else rule.v_transfer
            if cap is not None:
                motion = replace(motion, speed=replace(motion.speed, v_leax=min(motion.speed.v_leax, cap)))
        motions.append(motion)
    return with_rail(replace(program, motions=tuple(motions)), plant, positions)


def _ranges(motion: PoseMove, plant: Plant, rule: RailRule) -> Array:
    """Rail ranges of a point on the branch its confdata names; on any branch where that one has none."""
    X_WF = motion.X_WT @ inverse_pose(motion.tool.X_FT)
    named = None if plant.robot.linkage else motion.conf.cfx  # of a linkage cfx names no branch
    kept = rail_ranges(plant, X_WF, rule.phi_min, named)
    return kept if len(kept) else rail_ranges(plant, X_WF, rule.phi_min)


def _arm_time(motion: PoseMove, X_before: Array, plant: Plant) -> float:
    """Seconds the thesis' generator takes from the point before, every Cartesian axis from rest to rest; on an arc the
    one axis along it."""
    speed = plant.tcp.speed if isinstance(motion, MoveJ) else min(plant.tcp.speed, motion.speed.v_tcp)
    if isinstance(motion, PathMove) and not isinstance(motion, MoveL):
        ways: Array | float = segment_of(motion, X_before).length
    else:
        ways = np.abs(motion.X_WT[:3, 3] - X_before[:3, 3])
    return float(np.max(trapezoid_time(ways, speed, plant.tcp.acceleration)))


def _way(time: float, speed: float, acceleration: float) -> float:
    """How far a rail gets in time from rest to rest [m]."""
    ramp = min(speed / acceleration, time / 2)
    return acceleration * ramp * (time - ramp)


def _area_speed(plant: Plant, rule: RailRule) -> float:
    own = float(plant.layout.place(plant.limits.velocity))
    return own if rule.v_area is None else min(own, rule.v_area)


def _stations(points: Sequence[WorkPoint]) -> list[tuple[int, int]]:
    """First and last + 1 of the points of every station."""
    starts = [k for k in range(len(points)) if k == 0 or points[k].station != points[k - 1].station]
    return list(zip(starts, [*starts[1:], len(points)], strict=True))


def _overlap(a: Array, b: Array) -> Array:
    """Where ranges a (m, 2) and b (n, 2) overlap: (p, 2)."""
    pairs = [(max(x[0], y[0]), min(x[1], y[1])) for x in a for y in b]
    return np.array([pair for pair in pairs if pair[0] <= pair[1] + _SAME]).reshape(-1, 2)


def _nearest(ranges: Array, position: float) -> float:
    """The position inside ranges (m, 2) nearest to position."""
    inside = np.clip(position, ranges[:, 0], ranges[:, 1])
    return float(inside[np.argmin(np.abs(inside - position))])
