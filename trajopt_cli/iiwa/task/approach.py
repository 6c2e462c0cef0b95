"""The way from where the controller is switched on to a path's first pose: a line, a joint move before, or a jump."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, axis_angle, pose
from trajopt_cli.iiwa.task.angles import angles_of, rotation
from trajopt_cli.iiwa.task.joint_checks import Arm
from trajopt_cli.iiwa.task.model import AngleMeaning, PathPoints, Route, Waypoint
from trajopt_cli.robot.srs_inverse import inverse_branch
from trajopt_cli.units import MM

_SAME = 1e-6  # m, rad: nearer counts as the same pose


def by_line(route: Route, X_start: Array, place: str) -> tuple[Route, tuple[str, ...]]:
    """The route behind a leg from the tool at the start X_start (4, 4) to its first pose at the first segment's caps,
    where they differ, and what to say of it. place: of the start, for messages.
    """
    first, caps = route.waypoints[0], np.vstack([route.caps[:1], route.caps])
    told = _apart(X_start, first, route.meaning)
    if told is None:
        return route, ()
    angles = np.zeros(3) if route.meaning is AngleMeaning.RELATIVE else angles_of(X_start[:3, :3])
    begin = Waypoint("start", np.concatenate([X_start[:3, 3], angles]), place)
    note = f"approach: a line from the tool at the start joints to pose {first.name}, {told}, goes before the path"
    return replace(route, waypoints=_after(begin, route.waypoints), caps=caps), (note,)


def by_joints(route: Route, arm: Arm) -> tuple[Route, Array, tuple[str, ...]]:
    """The route, the joints (7,) [rad] that stand at its first pose when the controller is switched on, in the
    configuration of the arm's start, at the arm angle that it keeps, and what to say of it. Relative angles are written
    anew, so that orientations stay.

    Raises InputError for a first pose that is out of reach so.
    """
    first, meaning, R_start = route.waypoints[0], route.meaning, arm.X_start[:3, :3]
    told = _apart(arm.X_start, first, meaning)
    if told is None:
        return route, arm.start, ()
    X_WT = _pose_of(first, R_start, meaning)
    q = inverse_branch(arm.robot, arm.flange(X_WT[None, :3, :3], X_WT[None, :3, 3]), *arm.how)[0]
    if not np.isfinite(q).all():
        degrees = round(np.degrees(arm.angle), 2) + 0.0  # which takes the sign off a zero
        message = f"approach: pose {first.name} is out of the arm's reach at an arm angle of {degrees:g}°"
        raise InputError(f"{message}; move it, or the base", file=first.place)
    if meaning is AngleMeaning.RELATIVE:
        route = replace(route, waypoints=_turned(route.waypoints, R_start @ X_WT[:3, :3].T))
    joints = ", ".join(f"{value:.2f}" for value in np.degrees(q))
    note = (
        f"approach: a joint move to pose {first.name}, {told} from the tool at the start joints, comes before the"
        f" controller is switched on, at [{joints}]°"
    )
    return route, q, (note,)


def _pose_of(waypoint: Waypoint, R_start: Array, meaning: AngleMeaning) -> Array:
    R = rotation(waypoint.pose[3:])
    return pose(R @ R_start if meaning is AngleMeaning.RELATIVE else R, waypoint.pose[:3])


def _apart(X_start: Array, first: Waypoint, meaning: AngleMeaning) -> str | None:
    """How far the first pose is from the tool at the start, in words; None where it is there."""
    X = _pose_of(first, X_start[:3, :3], meaning)
    away = float(np.linalg.norm(X[:3, 3] - X_start[:3, 3]))
    turned = axis_angle(X_start[:3, :3].T @ X[:3, :3])[1]
    return None if away < _SAME and turned < _SAME else f"{away / MM:.4g} mm and {np.degrees(turned):.4g}°"


def _after(begin: Waypoint, waypoints: Sequence[Waypoint]) -> Sequence[Waypoint]:
    """The waypoints behind another one; the first of them is a stop then."""
    if not isinstance(waypoints, PathPoints):
        return (begin, replace(waypoints[0], rests=True), *waypoints[1:])
    return replace(
        waypoints,
        poses=np.vstack([begin.pose, waypoints.poses]),
        rows=np.insert(waypoints.rows, 0, waypoints.rows[0]),
        number=waypoints.number - 1,
        names={0: begin.name, **{i + 1: name for i, name in waypoints.names.items()}},
        dwells={i + 1: dwell for i, dwell in waypoints.dwells.items()},
        stops=frozenset({1, *(i + 1 for i in waypoints.stops)}),
    )


def _turned(waypoints: Sequence[Waypoint], R: Array) -> Sequence[Waypoint]:
    """The waypoints with their angles' matrices times R; those of the first are 0 then."""
    if isinstance(waypoints, PathPoints):
        poses = np.hstack([waypoints.poses[:, :3], angles_of(rotation(waypoints.poses[:, 3:]) @ R)])
        poses[0, 3:] = 0.0
        return replace(waypoints, poses=poses)
    turned = [np.concatenate([one.pose[:3], angles_of(rotation(one.pose[3:]) @ R)]) for one in waypoints]
    turned[0][3:] = 0.0
    return tuple(replace(one, pose=pose) for one, pose in zip(waypoints, turned, strict=True))
