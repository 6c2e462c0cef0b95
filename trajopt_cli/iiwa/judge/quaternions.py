"""The judge's own rotations: unit quaternions (..., 4), scalar first, and the three angles of a compliant controller.

Angles (..., 3) are alpha, beta, gamma [rad]: about the fixed x, then the fixed y, then the fixed z axis.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array


def product(a: Array, b: Array) -> Array:
    """First b, then a, seen from fixed axes; either may be one rotation."""
    (w, x, y, z), (t, i, j, k) = (np.moveaxis(one, -1, 0) for one in (a, b))
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    out[..., 0] = w * t - (x * i + y * j + z * k)
    out[..., 1] = w * i + t * x + (y * k - z * j)
    out[..., 2] = w * j + t * y + (z * i - x * k)
    out[..., 3] = w * k + t * z + (x * j - y * i)
    return out


def conjugate(q: Array) -> Array:
    """The turn back."""
    return np.asarray(q * np.array([1.0, -1.0, -1.0, -1.0]))


def exponential(turn: Array) -> Array:
    """The rotation by a turn vector (..., 3) [rad]: axis times angle."""
    half = np.linalg.norm(turn, axis=-1, keepdims=True) / 2
    return np.concatenate([np.cos(half), np.sinc(half / np.pi) * turn / 2], axis=-1)


def logarithm(q: Array) -> Array:
    """The turn vector (..., 3) [rad], of at most half a revolution."""
    q = np.where(q[..., :1] < 0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    small = sine < 1e-200
    factor = np.where(small, 2.0, 2 * np.arctan2(sine, q[..., :1]) / np.where(small, 1.0, sine))
    return np.asarray(factor * q[..., 1:])


def angle_between(a: Array, b: Array) -> Array:
    """Angle (...) [rad] between two rotations, exact to rounding near zero."""
    return np.asarray(np.linalg.norm(logarithm(product(conjugate(a), b)), axis=-1))


def from_angles(angles: Array) -> Array:
    """The rotation that turns by alpha about x, then by beta about y, then by gamma about z."""
    half = np.asarray(angles, dtype=np.float64) / 2
    about = np.zeros((3, *half.shape[:-1], 4))
    for i in range(3):
        about[i, ..., 0], about[i, ..., 1 + i] = np.cos(half[..., i]), np.sin(half[..., i])
    return product(about[2], product(about[1], about[0]))


def to_angles(q: Array) -> Array:
    """The three angles (..., 3), alpha and gamma within half a turn of 0, beta within a quarter."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    along_x = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)])  # where the x axis goes
    beta = np.arctan2(-along_x[2], np.hypot(along_x[0], along_x[1]))
    alpha = np.arctan2(2 * (y * z + w * x), 1 - 2 * (x * x + y * y))
    return np.stack([alpha, beta, np.arctan2(along_x[1], along_x[0])], axis=-1)


def turned(q: Array, points: Array) -> Array:
    """Points (..., 3) turned by q."""
    u, cross = q[..., 1:], 2 * np.cross(q[..., 1:], points)
    return np.asarray(points + q[..., :1] * cross + np.cross(u, cross))


def to_matrix(q: Array) -> Array:
    """Rotation matrix (3, 3) of one rotation (4,)."""
    return np.stack([turned(q, axis) for axis in np.eye(3)], axis=1)


def from_matrix(R: Array) -> Array:
    """The rotation of matrices (..., 3, 3): of the four columns of 4 q q^T the longest."""
    S = np.empty((*R.shape[:-2], 4, 4))
    trace = np.trace(R, axis1=-2, axis2=-1)
    S[..., 0, 0] = 1 + trace
    for i, (j, k) in enumerate(((1, 2), (2, 0), (0, 1)), start=1):
        S[..., i, i] = 1 - trace + 2 * R[..., i - 1, i - 1]
        S[..., 0, i] = S[..., i, 0] = R[..., k, j] - R[..., j, k]
        S[..., j + 1, k + 1] = S[..., k + 1, j + 1] = R[..., j, k] + R[..., k, j]
    longest = np.argmax(np.diagonal(S, axis1=-2, axis2=-1), axis=-1)
    q = np.take_along_axis(S, longest[..., None, None], axis=-1)[..., 0]
    return np.asarray(q / np.linalg.norm(q, axis=-1, keepdims=True))
