"""The least time the tool needs from stop to stop: its ways at the programmed speeds, points passed in their zones.

Nothing is asked of a motion but what the program says: outside the zones the tool is on its lines and arcs, inside it
may go any way, a joint move may take it anywhere, and no leg is faster than its caps.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, axis_angle, inverse_pose
from trajopt_cli.path.segment import POINT, Segment
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.timing.double_integrator import mean_ramp, trapezoid_time


@dataclass(frozen=True)
class TcpPart:
    """A part of the tool's way: at least this length [m], at most this speed [m/s]; its turn takes so long [s]. jump:
    another tool takes over in it, whose centre point has a speed of its own."""

    length: float
    speed: float
    turn: float = 0.0
    jump: bool = False


@dataclass(frozen=True, eq=False)
class Gate:
    """A pose X_WF (4, 4) that the flange goes through on every legal motion: on a line or an arc, number leg, where
    the zone of waypoint k begins or ends; nothing is rounded there. twist (6,): of the flange there at the greatest
    speed; velocity (3,): of the tool."""

    k: int
    leg: int
    X_WF: Array
    twist: Array
    velocity: Array


def tool_parts(problem: Problem, first: int, last: int) -> Iterator[TcpPart | Gate]:
    """What the tool does from the stop `first` to the next one, `last`, in order, as far as the program fixes it."""
    for leg in problem.legs[first:last]:
        yield from _leg(problem, leg)
        if leg.start + 1 < last:
            yield _through(problem, leg.start + 1)


def tool_time(problem: Problem, first: int, last: int) -> float:
    """Least time [s] from the stop `first` to the next one, `last`, that the tool needs on any legal motion."""
    legs = problem.legs[first:last]
    parts = [part for part in tool_parts(problem, first, last) if isinstance(part, TcpPart)]
    duration = legs[0].duration if len(legs) == 1 else None
    return max(duration or 0.0, sum(leg.least for leg in legs), parts_time(parts, *ramps_of(legs)))


def ramps_of(legs: Sequence[Leg]) -> tuple[float, float]:
    """What the tool may speed up and slow down at most on any of some legs [m/s2]."""
    return max(leg.ramps[0] for leg in legs), max(leg.ramps[1] for leg in legs)


def parts_time(parts: Sequence[TcpPart], up: float, down: float, rests: int = 2) -> float:
    """Least time [s] over parts, in whatever order, the tool speeding up and slowing down at most so much [m/s2], at
    rest at so many ends.

    Where no part's cap is below `top`, the share of its cap that the tool drives at is never above that of a run-up to
    `top`, so the parts take no less than that run-up over as much way as they would be at that speed. Slower parts are
    taken as if they allowed `top`. Where another tool takes over nothing is known of run-ups.
    """
    rests = 0 if any(part.jump for part in parts) else rests
    least = sum(part.turn for part in parts)
    a = mean_ramp(up, down) if rests > 1 else max(up, down)
    for top in {part.speed for part in parts if part.length > 0}:
        way = sum(p.length * (1.0 if p.speed <= top else top / p.speed) for p in parts)
        # one run-up is half of the trapezoid over twice the way
        time = (
            trapezoid_time(2 * way, top, a) / 2 if rests == 1 else trapezoid_time(way, top, a) if rests else way / top
        )
        least = max(least, float(time))
    return least


def _caps(problem: Problem, leg: Leg) -> tuple[float, float]:
    r"""Speeds of tool [m/s] and turning [rad/s]; a programmed time replaces the programmed ones (RAPID: \T)."""
    return (leg.v_tcp, leg.v_ori) if leg.duration is None else (problem.plant.tcp.speed, np.inf)


def _leg(problem: Problem, leg: Leg) -> Iterable[TcpPart | Gate]:
    """The parts of a leg outside the zones at its ends: where nothing is rounded, and beside it where only the turn is;
    of a joint move the chord."""
    ends = leg.start, leg.start + 1
    zones = [problem.waypoints[k].fly_by for k in ends]
    v, v_ori = _caps(problem, leg)
    near, far = (0.0 if zone is None else zone.radius for zone in zones)
    if leg.kind is LegKind.JOINT:
        a, b = (problem.waypoints[k].X_WF @ leg.X_FT for k in ends)
        way = max(float(np.linalg.norm(b[:3, 3] - a[:3, 3])) - near - far, 0.0)
        passed = any(zone is not None for zone in zones)  # nobody can say what turn is left outside the zones
        return [TcpPart(way, v, 0.0 if passed else _angle(a, b) / v_ori)]
    if leg.segment is None:
        return []
    way, turn = leg.segment.length, leg.segment.angle
    if way <= POINT:  # a turn in place: its zones are angles
        left = turn - sum(zone.turning for zone in zones if zone is not None)
        return [TcpPart(0.0, v, max(left, 0.0) / v_ori)]
    v = min(v, float(np.sqrt(leg.a_tcp * leg.segment.radius)))
    if not leg.segment.evenly_turned:
        turn = 0.0  # where it turns slowly nobody can say what a part of it takes
    near, far = (_within(leg.segment, size) for size in (near, far))
    begins, ends_at = (_within(leg.segment, _reach(problem, k)) for k in ends)
    exact = max(way - begins - ends_at, 0.0)
    steady = min(v, v_ori * way / turn) if turn > 0 else v
    return [
        TcpPart(begins - near, v),
        *_gate(problem, leg, leg.start, begins, steady),
        TcpPart(exact, steady, turn * exact / way / v_ori),
        *_gate(problem, leg, leg.start + 1, way - ends_at, steady),
        TcpPart(ends_at - far, v),
    ]


def _within(segment: Segment, size: float) -> float:
    """The part of a line or an arc that lies so near to its end [m]; of an arc more than its chord."""
    around = 2 * segment.radius
    return size if np.isinf(around) else around * float(np.arcsin(min(size / around, 1.0)))


def _reach(problem: Problem, k: int) -> float:
    """How far from waypoint k the flange may be off its way [m]: where nothing turns, no farther than the tool."""
    zone, beside = problem.waypoints[k].fly_by, problem.legs[max(k - 1, 0) : k + 1]
    if zone is None:
        return 0.0
    steady = all(leg.segment is not None and leg.segment.angle <= POINT for leg in beside) and not zone.joint
    return zone.radius if steady else zone.turning


def _gate(problem: Problem, leg: Leg, k: int, way: float, speed: float) -> list[Gate]:
    """The gate at a length on a leg beside waypoint k, if that is passed; greatest speed."""
    if not problem.passes(k):
        return []
    assert leg.segment is not None
    X_WF = _at(leg.segment, way) @ inverse_pose(leg.X_FT)
    share = np.array([way / leg.segment.length])
    twist = leg.segment.twist(share)[0] * speed / leg.segment.length
    arm = X_WF[:3, :3] @ leg.X_FT[:3, 3]  # from the flange to the tool
    of_flange = np.concatenate([twist[:3] - np.cross(twist[3:], arm), twist[3:]])
    return [Gate(k, leg.start, X_WF, of_flange, twist[:3])]


def _at(segment: Segment, way: float) -> Array:
    return np.asarray(segment.pose(np.array([min(max(way / _whole(segment), 0.0), 1.0)]))[0])


def _whole(segment: Segment) -> float:
    """A line's or an arc's length [m], or the angle [rad] of a turn in place."""
    return segment.length if segment.length > POINT else segment.angle


def _angle(a: Array, b: Array) -> float:
    return axis_angle(a[:3, :3].T @ b[:3, :3])[1]


def _through(problem: Problem, k: int) -> TcpPart:
    """Straight through a zone, from where the way before enters it to where the next one begins; the shortest turn."""
    legs, zone = problem.legs[k - 1 : k + 1], problem.waypoints[k].fly_by
    before, after = (leg.segment for leg in legs)
    caps = np.max([_caps(problem, leg) for leg in legs], axis=0)
    if before is None or after is None or zone is None or zone.joint:
        jump = not np.array_equal(legs[0].X_FT, legs[1].X_FT)
        return TcpPart(0.0, caps[0], jump=jump)  # joint moves may go anywhere
    (a, b), (c, d) = (
        (_at(before, _whole(before) - _within(before, size)), _at(after, _within(after, size)))
        for size in (zone.radius, zone.turning)
    )
    return TcpPart(float(np.linalg.norm(b[:3, 3] - a[:3, 3])), caps[0], _angle(c, d) / caps[1])
