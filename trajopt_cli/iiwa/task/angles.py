"""Orientations as the compliant controller writes them: extrinsic Tait-Bryan angles xyz, and turn vectors.

angles (..., 3) are alpha, beta, gamma [rad], R = Rz(gamma) Ry(beta) Rx(alpha): about the fixed x, then y, then z. At
|beta| = 90 deg they lock: only gamma - alpha (at +90) or gamma + alpha (at -90) means anything.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.geometry import rotation_vector as rotation_vector

LOCKED = 1e-10
"""Where cos(beta) is below this the angles count as locked: alpha would be rounding noise of 1e-6 rad or worse."""


def rotation(angles: ArrayLike) -> Array:
    """Rotation matrices (..., 3, 3) of angles (..., 3)."""
    angles = np.asarray(angles, dtype=np.float64)
    sines, cosines = np.moveaxis(np.sin(angles), -1, 0), np.moveaxis(np.cos(angles), -1, 0)
    (sa, sb, sg), (ca, cb, cg) = sines, cosines
    R = np.empty((*angles.shape[:-1], 3, 3))
    R[..., 0, 0], R[..., 0, 1], R[..., 0, 2] = cg * cb, cg * sb * sa - sg * ca, cg * sb * ca + sg * sa
    R[..., 1, 0], R[..., 1, 1], R[..., 1, 2] = sg * cb, sg * sb * sa + cg * ca, sg * sb * ca - cg * sa
    R[..., 2, 0], R[..., 2, 1], R[..., 2, 2] = -sb, cb * sa, cb * ca
    return R


def angles_of(R: ArrayLike) -> Array:
    """Angles (..., 3) of R (..., 3, 3): alpha and gamma in [-180, 180] deg, beta in [-90, 90] deg.

    Where they lock (cos(beta) < LOCKED) alpha is 0 and gamma carries the turn.
    """
    R = np.asarray(R, dtype=np.float64)
    cosine = np.hypot(R[..., 2, 1], R[..., 2, 2])
    alpha = np.where(cosine < LOCKED, 0.0, np.arctan2(R[..., 2, 1], R[..., 2, 2]))
    beta = np.arctan2(-R[..., 2, 0], cosine)
    # gamma from R Rx(-alpha) = Rz Ry, so that it fits the alpha just found: near the lock each is noise, their sum not
    sa, ca = np.sin(alpha), np.cos(alpha)
    gamma = np.arctan2(R[..., 0, 2] * sa - R[..., 0, 1] * ca, R[..., 1, 1] * ca - R[..., 1, 2] * sa)
    return np.stack([alpha, beta, gamma], axis=-1)


def continuous(angles: ArrayLike) -> Array:
    """The same orientations as angles (n, 3) whose neighbouring rows are as close as they can be.

    Every angle counts on through 180 deg, and beta through 90 deg: of the two ways to write an orientation,
    (alpha, beta, gamma) and (alpha + pi, pi - beta, gamma + pi), the one nearer to the row before is taken. A locked
    row takes its alpha from the row before (the row after, at the beginning). Rows that need none of this, the first
    one unless it is locked among them, come back bit for bit.
    """
    given = np.asarray(angles, dtype=np.float64)
    locked = np.abs(np.cos(given[:, 1])) < LOCKED
    free = np.flatnonzero(~locked)
    out = given.copy()
    out[free] = _nearer_way(given[free])
    if free.size and locked.any():
        _fill_locked(out, locked, free)
    return _counted_on(out)


def angles_near(R: ArrayLike, near: ArrayLike) -> Array:
    """Angles (n, 3) of R (n, 3, 3), each row written the way nearest to the row of near (n, 3): whole turns, and which
    of the two ways to write an orientation; at the lock alpha is near's."""
    R, near = np.asarray(R, dtype=np.float64), np.asarray(near, dtype=np.float64)
    one = angles_of(R)
    locked = np.abs(np.cos(one[:, 1])) < LOCKED
    one[locked, 2] += np.sign(np.sin(one[locked, 1])) * near[locked, 0]
    one[locked, 0] = near[locked, 0]
    one, other = (near + _wrapped(rows - near) for rows in (one, _other_way(one)))
    farther = np.linalg.norm(other - near, axis=1) < np.linalg.norm(one - near, axis=1) - 1e-9
    return np.where(farther[:, None], other, one)


def _nearer_way(angles: Array) -> Array:
    """Each row as it is or written the other way, whichever is nearer to the row before; whole turns left alone."""
    if len(angles) < 2:
        return angles
    other = _other_way(angles)
    stay, change = (np.linalg.norm(_wrapped(rows[1:] - angles[:-1]), axis=1) for rows in (angles, other))
    # writing both rows the other way leaves their distance as it is, so every row's choice is relative to its neighbour
    changes = np.r_[False, change < stay - 1e-9]
    if not changes.any():
        return angles
    return np.where((np.cumsum(changes) % 2 == 1)[:, None], other, angles)


def _other_way(angles: Array) -> Array:
    return np.column_stack([angles[:, 0] + np.pi, np.pi - angles[:, 1], angles[:, 2] + np.pi])


def _fill_locked(out: Array, locked: BoolArray, free: IndexArray) -> None:
    """Give locked rows the alpha of the free row before (or after); gamma keeps the orientation."""
    rows = np.flatnonzero(locked)
    before = np.searchsorted(free, rows) - 1
    alpha = out[free[np.maximum(before, 0)], 0]
    out[rows, 2] += np.sign(np.sin(out[rows, 1])) * (alpha - out[rows, 0])
    out[rows, 0] = alpha


def _counted_on(angles: Array) -> Array:
    """Whole turns added so that no step exceeds half a turn; added at once, so that zero turns change no bit."""
    turns = np.cumsum(np.rint(np.diff(angles, axis=0, prepend=angles[:1]) / (2 * np.pi)), axis=0)
    return np.asarray(angles - 2 * np.pi * turns, dtype=np.float64)


def _wrapped(angles: Array) -> Array:
    return np.asarray(angles - 2 * np.pi * np.rint(angles / (2 * np.pi)), dtype=np.float64)
