"""Rotations, quaternions and poses as NumPy arrays; everything is vectorised over leading axes.

A pose X_AB is a (..., 4, 4) homogeneous matrix: frame B seen from frame A, X_AC = X_AB @ X_BC. A quaternion never
travels without its order in the name of the function that takes it.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
IndexArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]


def readonly(values: ArrayLike) -> Array:
    """A float64 copy that cannot be written to."""
    out = np.array(values, dtype=np.float64)
    out.setflags(write=False)
    return out


def rotation_from_wxyz(quaternion: ArrayLike) -> Array:
    """Rotation matrix (..., 3, 3) of a unit quaternion (..., 4), scalar first. Normalises rounding only."""
    q = np.asarray(quaternion, dtype=np.float64)
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    w, x, y, z = np.moveaxis(q, -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def wxyz_from_rotation(R: ArrayLike) -> Array:
    """Unit quaternion (..., 4), scalar first and not negative, of a rotation matrix (..., 3, 3)."""
    R = np.asarray(R, dtype=np.float64)
    trace = R[..., 0, 0] + R[..., 1, 1] + R[..., 2, 2]
    # Bar-Itzhack's symmetric matrix would need an eigenproblem; the largest of four squares is as stable and cheaper.
    squares = np.stack([1 + trace, *(1 - trace + 2 * R[..., i, i] for i in range(3))], axis=-1)
    pick = np.argmax(squares, axis=-1)
    a = R[..., 2, 1], R[..., 0, 2], R[..., 1, 0]
    b = R[..., 1, 2], R[..., 2, 0], R[..., 0, 1]
    dif = [p - q for p, q in zip(a, b, strict=True)]
    tot = [p + q for p, q in zip(a, b, strict=True)]
    table = np.stack(
        [
            np.stack([squares[..., 0], dif[0], dif[1], dif[2]], axis=-1),
            np.stack([dif[0], squares[..., 1], tot[2], tot[1]], axis=-1),
            np.stack([dif[1], tot[2], squares[..., 2], tot[0]], axis=-1),
            np.stack([dif[2], tot[1], tot[0], squares[..., 3]], axis=-1),
        ],
        axis=-2,
    )
    q = np.take_along_axis(table, pick[..., None, None], axis=-2)[..., 0, :]
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    return np.where(q[..., :1] < 0, -q, q)


def wxyz_in_turn(R: Array) -> Array:
    """The same of rotations (n, 3, 3) that follow each other: none of another sign than the one before it."""
    wxyz = wxyz_from_rotation(R)
    flips = np.sum(wxyz[1:] * wxyz[:-1], axis=1) < 0
    return np.asarray(wxyz * np.r_[1.0, 1.0 - 2.0 * (np.cumsum(flips) % 2)][:, None])


def rotation_about(axis: ArrayLike, angle: ArrayLike) -> Array:
    """Rotation matrix (..., 3, 3) about a unit axis (3,) by angle (...) in rad (Rodrigues)."""
    x, y, z = np.asarray(axis, dtype=np.float64)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.asarray(angle, dtype=np.float64)[..., None, None]
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * (K @ K)


def rotations_by(turns: Array) -> Array:
    """Rotation matrices (m, 3, 3) by rotation vectors (m, 3) in rad."""
    out = np.tile(np.eye(3), (len(turns), 1, 1))
    angle = np.linalg.norm(turns, axis=1)
    at = np.flatnonzero(angle)
    x, y, z = (turns[at] / angle[at, None]).T
    K = np.zeros((len(at), 3, 3))
    K[:, 0, 1], K[:, 0, 2], K[:, 1, 0], K[:, 1, 2], K[:, 2, 0], K[:, 2, 1] = -z, y, z, -x, -y, x
    out[at] += np.sin(angle[at])[:, None, None] * K + (1 - np.cos(angle[at]))[:, None, None] * (K @ K)
    return out


def rotation_vector(R: ArrayLike) -> Array:
    """Turn vectors (..., 3) [rad] of R (..., 3, 3): the axis times the angle in [0, pi] (the matrix logarithm)."""
    q = wxyz_from_rotation(R)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2.0 * np.arctan2(sine, q[..., :1])
    # 2 is the limit of angle / sine for small turns, where the quotient is 0 / 0
    return np.asarray(q[..., 1:] * np.divide(angle, sine, out=np.full_like(sine, 2.0), where=sine > 1e-150))


def axis_angle(R: ArrayLike) -> tuple[Array, float]:
    """Unit axis (3,) and angle in [0, pi] of one rotation matrix (3, 3); x for the identity."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = np.asarray(R, dtype=np.float64).tolist()
    trace = xx + yy + zz  # wxyz_from_rotation, number by number: a long program has a hundred thousand
    squares = [1 + trace, *(1 - trace + 2 * own for own in (xx, yy, zz))]
    q = (
        (squares[0], zy - yz, xz - zx, yx - xy),
        (zy - yz, squares[1], yx + xy, xz + zx),
        (xz - zx, yx + xy, squares[2], zy + yz),
        (yx - xy, xz + zx, zy + yz, squares[3]),
    )[squares.index(max(squares))]
    norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) * (-1 if q[0] < 0 else 1)
    w, *v = (part / norm for part in q)
    sine = float(np.linalg.norm(v))
    if sine < 1e-15:
        return np.array([1.0, 0.0, 0.0]), 0.0
    return np.asarray(v) / sine, 2.0 * float(np.arctan2(sine, w))


def pose(R: ArrayLike, p: ArrayLike) -> Array:
    """Pose (..., 4, 4) from rotation (..., 3, 3) and position (..., 3) in m."""
    R, p = np.asarray(R, dtype=np.float64), np.asarray(p, dtype=np.float64)
    X = np.zeros((*np.broadcast_shapes(R.shape[:-2], p.shape[:-1]), 4, 4))
    X[..., :3, :3], X[..., :3, 3], X[..., 3, 3] = R, p, 1.0
    return X


def moved_by(X: Array, p: Array) -> Array:
    """Poses (..., 4, 4) shifted by p (..., 3) [m], broadcast."""
    out = np.array(np.broadcast_to(X, (*np.broadcast_shapes(X.shape[:-2], p.shape[:-1]), 4, 4)))
    out[..., :3, 3] += p
    return out


def inverse_pose(X: ArrayLike) -> Array:
    """X_BA of X_AB, (..., 4, 4)."""
    X = np.asarray(X, dtype=np.float64)
    R_t = np.swapaxes(X[..., :3, :3], -1, -2)
    return pose(R_t, -(R_t @ X[..., :3, 3:])[..., 0])


def xyz_from_rotation(R: ArrayLike) -> Array:
    """Intrinsic x-y'-z'' angles (..., 3) in rad, beta in [-90, 90] deg; at |beta| = 90 deg gamma = 0."""
    R = np.asarray(R, dtype=np.float64)
    beta = np.arctan2(R[..., 0, 2], np.hypot(R[..., 0, 0], R[..., 0, 1]))
    locked = np.hypot(R[..., 0, 0], R[..., 0, 1]) < 1e-12
    alpha = np.where(locked, np.arctan2(R[..., 2, 1], R[..., 1, 1]), np.arctan2(-R[..., 1, 2], R[..., 2, 2]))
    gamma = np.where(locked, 0.0, np.arctan2(-R[..., 0, 1], R[..., 0, 0]))
    return np.stack([alpha, beta, gamma], axis=-1)
