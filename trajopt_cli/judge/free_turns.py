"""A tool that may be turned about an axis of its own (free): how far its axis is from where it was taught to point, how
far it is turned, and by how much that leaves the sector it may be turned in.

A rotation R, seen from the taught one, is a swing S times a turn T about the tool's axis u: R = S T, the axis of S
square to u. Its turn is atan2(u w, tr R - u R u), w = (R32 - R23, R13 - R31, R21 - R12), and S alone moves the axis.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.judge.geometry import angle_between, lengths
from trajopt_cli.motion import FreeTurn


def turn_of(R: Array, free: FreeTurn) -> Array:
    """By how much (m,) rotations (m, 3, 3), seen from the taught ones, turn the tool about its axis, -pi..pi [rad]."""
    u = np.array(free.axis)
    w = np.stack([R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]], axis=-1)
    return np.asarray(np.arctan2(w @ u, np.trace(R, axis1=-2, axis2=-1) - (R @ u) @ u))


def turned_by(R: Array, free: FreeTurn, angle: Array) -> Array:
    """Rotations (m, 3, 3) turned about the tool's axis by angles (m,) [rad]."""
    K = np.cross(np.eye(3), free.axis)
    sine, cosine = np.sin(angle)[..., None, None], np.cos(angle)[..., None, None]
    return np.asarray(R @ (np.eye(3) + sine * K + (1 - cosine) * (K @ K)))


def swing_of(R: Array, free: FreeTurn) -> Array:
    """What is left (m, 3, 3) of rotations, seen from the taught ones, without their turn about the tool's axis."""
    return turned_by(R, free, -turn_of(R, free))


def beyond_sector(angle: Array, free: FreeTurn) -> Array:
    """How far (m,) angles [rad] are outside the sector, whichever way around; 0 inside."""
    around = np.asarray(angle)[..., None] + 2 * np.pi * np.array([-1.0, 0.0, 1.0])
    return np.asarray(np.maximum(np.maximum(free.low - around, around - free.high), 0.0).min(axis=-1))


def off_taught(R: Array, R_taught: Array, free: FreeTurn | None) -> Array:
    """How far (m,) [rad] rotations (m, 3, 3) are from what is asked: the taught ones; of a tool that may be turned the
    way its axis points, and the sector."""
    if free is None:
        return angle_between(R, R_taught)
    u = np.array(free.axis)
    tilted = 2 * np.arcsin(np.minimum(lengths(R @ u - R_taught @ u) / 2, 1.0))
    seen = np.swapaxes(np.broadcast_to(R_taught, R.shape), -1, -2) @ R
    return np.asarray(np.maximum(tilted, beyond_sector(turn_of(seen, free), free)))
