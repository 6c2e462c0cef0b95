"""From one pose to the next: how far, which way round, under which caps; and what cannot be travelled."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, floor, isfinite

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import rotation, rotation_vector
from trajopt_cli.iiwa.task.laws import UNCAPPED, Rate
from trajopt_cli.iiwa.task.model import BETA_LIMIT, COORDINATES, Profile, RotationLaw, Route, SegmentSpeeds, Waypoint

SAME = 1e-12
"""Distances [m, rad] up to this are the rounding of the numbers given, and no way to go."""

CAPS = (
    (("v_max", "m/s"), ("omega_max", "rad/s")),
    (("a_max", "m/s2"), ("epsilon_max", "rad/s2")),
    (("jerk", "m/s3"), ("angular_jerk", "rad/s3")),
)
"""Caps of the translation and of the rotation with their units, by the derivative that they bound."""

MOST_ROWS = 5_000_000
"""More rows than this (83 minutes at 1 ms) are taken for a slip in a speed or in the period."""

_ORDERS = {Profile.THESIS: 1, Profile.TRAPEZOID: 2, Profile.S_CURVE: 3}


@dataclass(frozen=True, eq=False)
class StraightSegment:
    """One segment: from start (6,) to end (6,), position [m] and angles [rad] that count on from the legs before.

    L_p [m], L_theta [rad]: the ways of both parts; both 0 where the pose is repeated. turn (3,) [rad]: the rotation
    vector from start to end in start's frame where rotation is slerp, else None. rates: the caps of speed,
    acceleration and jerk that hold the common share, per way; UNCAPPED where the profile does not ask.
    """

    origin: Waypoint
    goal: Waypoint
    start: Array
    end: Array
    L_p: float
    L_theta: float
    turn: Array | None
    speeds: SegmentSpeeds
    rates: tuple[Rate, Rate, Rate]
    notes: tuple[str, ...]

    @property
    def name(self) -> str:
        """What messages call it."""
        return f"segment {self.origin.name} -> {self.goal.name}"

    @property
    def stands(self) -> bool:
        """Whether the pose is only repeated."""
        return self.L_p == self.L_theta == 0


def legs(route: Route) -> tuple[StraightSegment, ...]:
    """The route's segments, checked.

    Raises InputError for fewer than two poses, a period that is not above zero, a beta at the lock, a dwell that is no
    time, a repeated pose without dwell, and a cap that is missing or not above zero with a distance to go.
    """
    if len(route.waypoints) < 2:
        place = route.waypoints[0].place if route.waypoints else None
        raise InputError(f"{len(route.waypoints)} pose; a path needs at least 2", file=place)
    if not (isfinite(route.h) and route.h > 0):
        raise InputError(f"h is {route.h:g} s; give a period above zero, for example 0.001 s")
    for waypoint in route.waypoints:
        check_waypoint(waypoint, route.rotation)
    out: list[StraightSegment] = []
    turns = np.zeros(3)
    for origin, goal, speeds in zip(route.waypoints, route.waypoints[1:], route.speeds, strict=False):
        start = out[-1].end if out else origin.pose
        leg, turns = _leg(origin, goal, speeds, start, turns, route)
        out.append(leg)
    caps = _caps(route, (np.array([leg.L_p for leg in out]), np.array([leg.L_theta for leg in out])))
    return tuple(_rates(leg, row) for leg, row in zip(out, caps, strict=True))


def check_waypoint(waypoint: Waypoint, law: RotationLaw) -> None:
    """Raise InputError for a dwell that is no time, and for angles at their lock."""
    if not (isfinite(waypoint.dwell) and waypoint.dwell >= 0):
        message = f"pose {waypoint.name}: the dwell is {waypoint.dwell:g} s; give a time of 0 s or more"
        raise InputError(message, file=waypoint.place)
    beta = float(waypoint.pose[4])
    if law is RotationLaw.TAIT_BRYAN and abs(beta) > BETA_LIMIT + SAME:
        message = (
            f"pose {waypoint.name}: beta is {np.degrees(beta):.10g}°, at most {np.degrees(BETA_LIMIT):.6g}° in size: "
            "nearer to 90° the angles lock; turn the pose, or take rotation: slerp, which has no such limit"
        )
        raise InputError(message, file=waypoint.place)


def _leg(
    origin: Waypoint, goal: Waypoint, speeds: SegmentSpeeds, start: Array, turns: Array, route: Route
) -> tuple[StraightSegment, Array]:
    """The segment, and the whole turns by which its end's angles differ from the pose's."""
    notes: list[str] = []
    name = f"segment {origin.name} -> {goal.name}"
    L_p = _length(goal.pose[:3] - origin.pose[:3])
    turn = None
    if route.rotation is RotationLaw.SLERP:
        turn = rotation_vector(rotation(origin.pose[3:]).T @ rotation(goal.pose[3:]))
        if np.pi - np.linalg.norm(turn) < 1e-9:
            turn = _one_of_two(turn)
            axis = ", ".join(f"{x:.3g}" for x in rotation(origin.pose[3:]) @ turn / np.linalg.norm(turn))
            notes.append(f"{name}: the tool turns half a revolution, about ({axis}); the other way is as short")
        end, L_theta = goal.pose, _length(turn)
    else:
        plain = goal.pose[3:] - origin.pose[3:]
        more = -np.sign(plain) * np.array([max(0, ceil((abs(d) - np.pi) / (2 * np.pi) - SAME)) for d in plain])
        turns = turns + more
        end = np.r_[goal.pose[:3], goal.pose[3:] + 2 * np.pi * turns]
        L_theta = _length(end[3:] - start[3:])
        angles = zip(("alpha", "beta", "gamma"), plain, more, start[3:], end[3:], strict=True)
        notes += [f"{name}: {_way(*angle)}" for angle in angles if angle[2]]
    if not (L_p or L_theta or goal.dwell):
        message = f"pose {goal.name} repeats pose {origin.name}: give it a dwell, or remove it"
        raise InputError(message, file=goal.place)
    return StraightSegment(origin, goal, start, end, L_p, L_theta, turn, speeds, (UNCAPPED,) * 3, tuple(notes)), turns


def _length(way: Array) -> float:
    length = float(np.linalg.norm(way))
    return length if length > SAME else 0.0


def _one_of_two(turn: Array) -> Array:
    """Of the two ways of a turn by half a revolution the one whose axis' first component is positive.

    The way taken still ends at the goal: where the turn is shorter than half a revolution by its rounding, the other
    way is longer by as much.
    """
    angle = float(np.linalg.norm(turn))
    axis = turn / angle
    first = axis[int(np.argmax(np.abs(axis) > 1e-6))]
    return turn if first > 0 else np.asarray(-axis * (2 * np.pi - angle), dtype=np.float64)


def _way(name: str, plain: float, turns: float, start: float, end: float) -> str:
    """Which way an angle goes where the shorter one is not the plain difference."""
    if abs(end - start) <= SAME:
        return f"{name} stays, {np.degrees(plain):+.6g}° is a whole turn; the sequence counts {np.degrees(end):.6g}°"
    low, high = sorted((start, end))
    # the first odd multiple of 180 deg at or above the lower end
    line = (2 * ceil((low / np.pi - 1) / 2 - SAME) + 1) * np.pi
    through = f" through {np.degrees(line):.6g}°" if low < line <= high else ""
    shorter = plain + 2 * np.pi * turns
    return (
        f"{name} turns {np.degrees(shorter):+.6g}°{through}, not {np.degrees(plain):+.6g}°; "
        f"the sequence goes on counting to {np.degrees(end):.6g}°"
    )


def _rates(leg: StraightSegment, caps: Array) -> StraightSegment:
    """The leg with the caps (6,) of its common share: of both parts the one that allows less, per derivative."""
    if leg.stands:
        return leg
    pairs = zip(CAPS, caps.reshape(3, 2).tolist(), strict=True)
    ways = leg.L_p, leg.L_theta
    parts = ([*zip(names, values, ways, strict=True)] for names, values in pairs)
    rates = ([Rate(name, cap / way) for (name, _), cap, way in part if way] for part in parts)
    speed, acceleration, jerk = (min(some, key=lambda rate: rate.value) for some in rates)
    return replace(leg, rates=(speed, acceleration, jerk))


def unusable_cap(
    name: str, place: str, cap: str, unit: str, value: float | None, to_go: str, profile: Profile
) -> InputError:
    """The error about a cap that is missing, or not above zero, where a segment has a distance to go."""
    if value is None:
        return InputError(
            f"{name}: {cap} [{unit}] is missing; profile {profile.value} needs it with {to_go}", file=place
        )
    return InputError(f"{name}: {cap} is {value:g} {unit} with {to_go}; give a finite cap above zero", file=place)


def whole_periods(dwell: float, h: float) -> tuple[int, bool]:
    """Periods of a dwell above 0 [s], at least one, and whether it had to be rounded up to them."""
    nearest = floor(dwell / h + 0.5)
    if nearest and abs(dwell / h - nearest) <= 1e-9 * nearest:
        return nearest, False
    return ceil(dwell / h), True


@dataclass(frozen=True, eq=False)
class Path:
    """Poses (n, 6) whose angles count on from leg to leg, and n - 1 legs: lengths [m] and turns [rad] (n-1,), caps
    (n-1, 6) in the order of passing.CAPS. at (n,) [s]: when each pose is met at the caps of speed."""

    pose: Array
    lengths: Array
    turns: Array
    caps: Array
    at: Array
    notes: tuple[str, ...]


def path_of(route: Route) -> Path:
    """The route's legs, checked.

    Raises InputError for fewer than two poses, profile thesis, a beta at the lock, a repeated pose, a cap that is
    missing or not above zero with a distance to go, and for more than MOST_ROWS rows.
    """
    way, pose = route.waypoints, route.poses
    if len(way) < 2:
        raise InputError(f"{len(way)} pose; a path needs at least 2", file=way[0].place if way else None)
    if route.profile is Profile.THESIS:
        message = "profile thesis knows no acceleration, and poses are passed under one; give trapezoid or s-curve"
        raise InputError(f"passing: {message}, or 'passing: stop'", file=way[0].place)
    notes: list[str] = []
    if route.rotation is RotationLaw.TAIT_BRYAN:
        check_waypoint(way[int(np.argmax(np.abs(pose[:, 4])))], route.rotation)
        pose, notes = _counted_on(pose, route)
        turns = np.linalg.norm(np.diff(pose[:, 3:], axis=0), axis=1)
    else:
        R = rotation(pose[:, 3:])
        turns = np.linalg.norm(rotation_vector(np.swapaxes(R[:-1], -1, -2) @ R[1:]), axis=1)
    lengths = np.linalg.norm(np.diff(pose[:, :3], axis=0), axis=1)
    still = np.flatnonzero((lengths <= SAME) & (turns <= SAME))
    if still.size:
        here, there = way[int(still[0])], way[int(still[0]) + 1]
        more = f", as {still.size - 1} more do theirs" if still.size > 1 else ""
        raise InputError(f"pose {there.name} repeats pose {here.name}{more}: remove it", file=there.place)
    caps = _caps(route, (lengths, turns))
    at = np.concatenate([[0.0], np.cumsum(np.fmax(lengths / caps[:, 0], turns / caps[:, 1]))])
    rows = (at[-1] + sum(way[i].dwell for i in route.stops)) / route.h
    if rows > MOST_ROWS:
        message = f"the sequence takes {rows:.3g} periods of {route.h:g} s, at most {MOST_ROWS:.3g}"
        raise InputError(f"{message}; give a higher speed, shorter dwells or a longer period", file=way[0].place)
    return Path(pose, lengths, turns, caps, at, tuple(notes))


def _counted_on(pose: Array, route: Route) -> tuple[Array, list[str]]:
    """Poses whose angles go the shorter way from leg to leg, and what to say of it."""
    steps = np.diff(pose[:, 3:], axis=0)
    # half a turn exactly is as short either way and stays as given
    turns = np.sign(steps) * np.ceil((np.abs(steps) - np.pi) / (2 * np.pi) - SAME)
    turns[np.abs(steps) <= np.pi + SAME] = 0.0
    if not turns.any():
        return pose, []
    out = pose.copy()
    out[1:, 3:] -= 2 * np.pi * np.cumsum(turns, axis=0)
    notes = []
    for name, column in zip(COORDINATES[3:], turns.T, strict=True):
        legs = np.flatnonzero(column)
        if legs.size:
            goal = route.waypoints[int(legs[0]) + 1]
            more = f" and {legs.size - 1} more" if legs.size > 1 else ""
            notes.append(f"{name} goes the shorter way round to pose {goal.name}{more}; the sequence goes on counting")
    return out, notes


def _caps(route: Route, ways: tuple[Array, Array]) -> Array:
    """Caps (n-1, 6); of a part that stands on a leg those of the legs on which it moves, if it has none there."""
    kinds = list({id(speeds): speeds for speeds in route.speeds}.values())  # mostly one for all
    number = {id(speeds): i for i, speeds in enumerate(kinds)}
    kind = np.array([number[id(speeds)] for speeds in route.speeds], dtype=np.intp)
    table = np.full((len(kind), 6), np.inf)
    asked = ((order, part, *cap) for order, pair in enumerate(CAPS) for part, cap in enumerate(pair))
    for k, (order, part, cap, unit) in enumerate(asked):
        if order >= _ORDERS[route.profile]:
            break
        given = np.array([getattr(speeds, cap) for speeds in kinds], dtype=np.float64)[kind]  # None becomes NaN
        moves = ways[part] > SAME
        wrong = np.flatnonzero((moves & ~(np.isfinite(given) & (given > 0))) | (given < 0))
        if wrong.size:
            leg = int(wrong[0])
            here, there = route.waypoints[leg], route.waypoints[leg + 1]
            name = f"segment {here.name} -> {there.name}"
            to_go = f"{ways[part][leg]:.6g} {('m', 'rad')[part]} to go"
            raise unusable_cap(name, there.place, cap, unit, getattr(route.speeds[leg], cap), to_go, route.profile)
        usable = np.isfinite(given) & (given > 0)
        if moves.any():
            table[:, k] = np.where(usable, given, given[moves].min())
    return table
