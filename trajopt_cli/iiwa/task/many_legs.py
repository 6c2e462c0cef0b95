"""The legs of a route whose poses are passed, all at once: how far, which way round, under which caps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import rotation, rotation_vector
from trajopt_cli.iiwa.task.legs import CAPS, MOST_ROWS, SAME, check_waypoint, unusable_cap
from trajopt_cli.iiwa.task.model import COORDINATES, Profile, RotationLaw, Route, SegmentSpeeds

_ORDERS = {Profile.TRAPEZOID: 2, Profile.S_CURVE: 3}


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
        given = np.array([_number(speeds, cap) for speeds in kinds])[kind]
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


def _number(speeds: SegmentSpeeds, cap: str) -> float:
    value = getattr(speeds, cap)
    return np.nan if value is None else float(value)
