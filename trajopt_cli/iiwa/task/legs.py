"""From one pose to the next: how far, which way round, under which caps; and what cannot be travelled."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, floor, isfinite

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import rotation, rotation_vector
from trajopt_cli.iiwa.task.model import BETA_LIMIT, CAPS, COORDINATES, Profile, RotationLaw, Route

SAME = 1e-12
"""Distances [m, rad] up to this are the rounding of the numbers given, and no way to go."""

_CAP_UNITS = ("m/s", "rad/s", "m/s2", "rad/s2", "m/s3", "rad/s3")

MOST_ROWS = 5_000_000
"""More rows than this (83 minutes at 1 ms) are taken for a slip in a speed or in the period."""

_ORDERS = {Profile.THESIS: 1, Profile.TRAPEZOID: 2, Profile.S_CURVE: 3}


def whole_periods(dwell: float, h: float) -> tuple[int, bool]:
    """Periods of a dwell above 0 [s], at least one, and whether it had to be rounded up to them."""
    nearest = floor(dwell / h + 0.5)
    if nearest and abs(dwell / h - nearest) <= 1e-9 * nearest:
        return nearest, False
    return ceil(dwell / h), True


@dataclass(frozen=True, eq=False)
class Path:
    """Poses (n, 6) whose angles count on from leg to leg, and n - 1 legs: lengths [m] and turns [rad] (n-1,), both 0
    where a pose is repeated; caps (n-1, 6) in the order of CAPS, inf where the profile does not ask. at (n,) [s]: when
    each pose is met at the caps of speed. vectors (n-1, 3) [rad]: the rotation from pose to pose, in the frame of the
    one before, where rotation is slerp, else None.
    """

    pose: Array
    lengths: Array
    turns: Array
    caps: Array
    at: Array
    vectors: Array | None
    notes: tuple[str, ...]


def path_of(route: Route) -> Path:
    """The route's legs, checked.

    Raises InputError for fewer than two poses, a period that is not above zero, poses that are passed with profile
    thesis, a beta at the lock, a dwell that is no time, a repeated pose (without a dwell, where all are stops), and a
    cap that is missing or not above zero with a distance to go.
    """
    way, pose = route.waypoints, route.poses
    if len(way) < 2:
        raise InputError(f"{len(way)} pose; a path needs at least 2", file=way[0].place if way else None)
    if not (isfinite(route.h) and route.h > 0):
        raise InputError(f"h is {route.h:g} s; give a period above zero, for example 0.001 s")
    if route.passing is not None and route.profile is Profile.THESIS:
        message = "profile thesis knows no acceleration, and poses are passed under one; give trapezoid or s-curve"
        raise InputError(f"passing: {message}, or 'passing: stop'", file=way[0].place)
    for one in (way[i] for i in route.stops):
        if not (isfinite(one.dwell) and one.dwell >= 0):
            message = f"pose {one.name}: the dwell is {one.dwell:g} s; give a time of 0 s or more"
            raise InputError(message, file=one.place)
    lengths, vectors, notes = _norms(np.diff(pose[:, :3], axis=0)), None, list[str]()
    if route.rotation is RotationLaw.TAIT_BRYAN:
        _check_lock(route, pose)
        pose, notes = _counted_on(pose, route)
        turns = _norms(np.diff(pose[:, 3:], axis=0))
    else:
        R = rotation(pose[:, 3:])
        vectors = rotation_vector(np.swapaxes(R[:-1], -1, -2) @ R[1:])
        turns = _norms(vectors)
        notes += _half_turns(route, R, vectors)
    still = (lengths == 0) & (turns == 0)
    if route.passing is None and still.any():
        still &= [one.dwell == 0 for one in way[1:]]
    if still.any():
        leg = int(np.argmax(still))
        more = f", as {still.sum() - 1} more do theirs" if still.sum() > 1 else ""
        what = "remove it" if route.passing is not None else "give it a dwell, or remove it"
        message = f"pose {way[leg + 1].name} repeats pose {way[leg].name}{more}: {what}"
        raise InputError(message, file=way[leg + 1].place)
    caps = _caps(route, lengths, turns)
    at = np.concatenate([[0.0], np.cumsum(np.fmax(lengths / caps[:, 0], turns / caps[:, 1]))])
    return Path(pose, lengths, turns, caps, at, vectors, tuple(notes))


def _norms(ways: Array) -> Array:
    """Lengths (n,) of ways (n, 3), 0 where rounding is all there is."""
    lengths = np.linalg.norm(ways, axis=1)
    return np.where(lengths > SAME, lengths, 0.0)


def _check_lock(route: Route, pose: Array) -> None:
    locked = np.abs(pose[:, 4]) > BETA_LIMIT + SAME
    if locked.any():
        one = route.waypoints[int(np.argmax(locked))]
        message = (
            f"pose {one.name}: beta is {np.degrees(one.pose[4]):.10g}°, at most {np.degrees(BETA_LIMIT):.6g}° in size:"
            " nearer to 90° the angles lock; turn the pose, or take rotation: slerp, which has no such limit"
        )
        raise InputError(message, file=one.place)


def _counted_on(pose: Array, route: Route) -> tuple[Array, list[str]]:
    """Poses whose angles go the shorter way from leg to leg, and what to say of it: of every leg that stops, of angles
    on legs that pass."""
    steps = np.diff(pose[:, 3:], axis=0)
    # half a turn exactly is as short either way and stays as given
    turns = -np.sign(steps) * np.maximum(0.0, np.ceil((np.abs(steps) - np.pi) / (2 * np.pi) - SAME))
    if not turns.any():
        return pose, []
    out = pose.copy()
    out[1:, 3:] += 2 * np.pi * np.cumsum(turns, axis=0)
    if route.passing is None:
        return out, [
            f"{name_of(route, leg)}: {_way(COORDINATES[3 + k], steps[leg, k], out[leg, 3 + k], out[leg + 1, 3 + k])}"
            for leg, k in np.argwhere(turns).tolist()
        ]
    notes = []
    for name, column in zip(COORDINATES[3:], turns.T, strict=True):
        legs = np.flatnonzero(column)
        if legs.size:
            goal = route.waypoints[int(legs[0]) + 1]
            more = f" and {legs.size - 1} more" if legs.size > 1 else ""
            notes.append(f"{name} goes the shorter way round to pose {goal.name}{more}; the sequence goes on counting")
    return out, notes


def _way(name: str, plain: float, start: float, end: float) -> str:
    """Which way an angle goes where the shorter one is not the plain difference."""
    if abs(end - start) <= SAME:
        return f"{name} stays, {np.degrees(plain):+.6g}° is a whole turn; the sequence counts {np.degrees(end):.6g}°"
    low, high = sorted((start, end))
    # the first odd multiple of 180 deg at or above the lower end
    line = (2 * ceil((low / np.pi - 1) / 2 - SAME) + 1) * np.pi
    through = f" through {np.degrees(line):.6g}°" if low < line <= high else ""
    return (
        f"{name} turns {np.degrees(end - start):+.6g}°{through}, not {np.degrees(plain):+.6g}°; "
        f"the sequence goes on counting to {np.degrees(end):.6g}°"
    )


def _half_turns(route: Route, R: Array, vectors: Array) -> Iterator[str]:
    """Take of the two ways of a turn by half a revolution the one whose axis' first component is positive, and say so.

    The way taken still ends at the goal: where the turn is shorter than half a revolution by its rounding, the other
    way is longer by as much. Where poses are passed, their curve decides.
    """
    angles = np.linalg.norm(vectors, axis=1)
    for leg in np.flatnonzero(np.pi - angles < 1e-9).tolist() if route.passing is None else ():
        axis = vectors[leg] / angles[leg]
        if axis[int(np.argmax(np.abs(axis) > 1e-6))] < 0:
            vectors[leg] = -axis * (2 * np.pi - angles[leg])
        about = ", ".join(f"{x:.3g}" for x in R[leg] @ vectors[leg] / np.linalg.norm(vectors[leg]))
        yield f"{name_of(route, leg)}: the tool turns half a revolution, about ({about}); the other way is as short"


def name_of(route: Route, leg: int) -> str:
    """What messages call a leg, by its number from 0."""
    return f"segment {route.waypoints[leg].name} -> {route.waypoints[leg + 1].name}"


def _caps(route: Route, lengths: Array, turns: Array) -> Array:
    """Caps (n-1, 6); of a part that stands on a leg those of the legs on which it moves, if it has none there."""
    table = np.full((len(lengths), 6), np.inf)
    for k in range(2 * _ORDERS[route.profile]):
        ways, cap, unit, given = (lengths, turns)[k % 2], CAPS[k], _CAP_UNITS[k], route.caps[:, k]
        moves, usable = ways > 0, np.isfinite(given) & (given > 0)
        wrong = (moves & ~usable) | (given < 0)
        if wrong.any():
            leg = int(np.argmax(wrong))
            name, to_go = name_of(route, leg), f"{ways[leg]:.6g} {('m', 'rad')[k % 2]} to go"
            message = f"{name}: {cap} is {given[leg]:g} {unit} with {to_go}; give a finite cap above zero"
            if np.isnan(given[leg]):
                message = f"{name}: {cap} [{unit}] is missing; profile {route.profile.value} needs it with {to_go}"
            raise InputError(message, file=route.waypoints[leg + 1].place)
        if moves.any():
            table[:, k] = np.where(usable, given, given[moves].min())
    return table
