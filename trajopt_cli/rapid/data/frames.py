"""Positions, quaternions and frames of RAPID as plain tuples: p (x, y, z), q (w, x, y, z), a frame (p, q).

Plain tuples because a program computes with one frame at a time, where an array costs twenty times the arithmetic.
The motions leave this room as the arrays of trajopt_cli.geometry: frames are in mm, poses in m.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from math import atan2, cos, hypot, sin, sqrt
from struct import Struct

import numpy as np

from trajopt_cli.geometry import Array, readonly, wxyz_from_rotation
from trajopt_cli.path.circle import cross
from trajopt_cli.units import MM

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Frame = tuple[Vector, Quaternion]

IDENTITY: Frame = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))


def norm(q: Quaternion) -> float:
    """Length of a quaternion, free of overflow."""
    return hypot(*q)


def normalised(q: Quaternion) -> Quaternion:
    """q at length 1; q must not be zero."""
    n = norm(q)
    return (q[0] / n, q[1] / n, q[2] / n, q[3] / n)


def product(a: Quaternion, b: Quaternion) -> Quaternion:
    """The rotation b followed by a."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """The reverse rotation of a unit quaternion."""
    return (q[0], -q[1], -q[2], -q[3])


def rotate(q: Quaternion, p: Vector) -> Vector:
    """p turned by a unit quaternion."""
    v: Vector = (q[1], q[2], q[3])
    t = cross(v, p)
    u = cross(v, t)
    return (p[0] + 2 * (q[0] * t[0] + u[0]), p[1] + 2 * (q[0] * t[1] + u[1]), p[2] + 2 * (q[0] * t[2] + u[2]))


def compose(a: Frame, b: Frame) -> Frame:
    """X_AC = X_AB X_BC; both orientations of unit length."""
    p = rotate(a[1], b[0])
    return (a[0][0] + p[0], a[0][1] + p[1], a[0][2] + p[2]), product(a[1], b[1])


def inverse(a: Frame) -> Frame:
    """X_BA of X_AB."""
    q = conjugate(a[1])
    p = rotate(q, a[0])
    return (-p[0], -p[1], -p[2]), q


def about(axis: int, angle: float) -> Quaternion:
    """Rotation by angle [rad] about x (0), y (1) or z (2)."""
    q = [cos(angle / 2), 0.0, 0.0, 0.0]
    q[1 + axis] = sin(angle / 2)
    return (q[0], q[1], q[2], q[3])


def length(p: Vector) -> float:
    """Length of a vector."""
    return sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2])


def _turned(a: Quaternion, b: Quaternion, share: float) -> Quaternion:
    """The orientation at a share 0..1 of the shorter turn from a to b; both of unit length."""
    w, x, y, z = product(conjugate(a), b)
    if w < 0:
        w, x, y, z = -w, -x, -y, -z
    size = length((x, y, z))
    if size < 1e-15:
        return a
    angle = 2 * atan2(size, w) * share
    half = sin(angle / 2) / size
    return product(a, (sqrt(max(0.0, 1 - sin(angle / 2) ** 2)), x * half, y * half, z * half))


def between(a: Frame, b: Frame, share: float) -> Frame:
    """The frame at a share 0..1 of the line from a to b: chord and the shorter turn."""
    (ax, ay, az), (bx, by, bz) = a[0], b[0]
    p = (ax + share * (bx - ax), ay + share * (by - ay), az + share * (bz - az))
    return p, _turned(a[1], b[1], share)


X_IDENTITY = readonly(np.eye(4))


def matrix(frame: Frame) -> Array:
    """A frame [mm] as a pose [m], read-only."""
    (x, y, z), (w, i, j, k) = frame
    # One packing of sixteen numbers: half the time of an array from rows, and nobody can write to it.
    return np.frombuffer(
        _pack(
            *(1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j), x * MM),
            *(2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i), y * MM),
            *(2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j), z * MM),
            *(0.0, 0.0, 0.0, 1.0),
        )
    ).reshape(4, 4)


_pack = Struct("16d").pack


def matrices(given: Iterable[Frame], count: int) -> Array:
    """So many frames [mm] as poses [m] (count, 4, 4), read-only: as matrix, in a tenth of its time."""
    numbers = chain.from_iterable(chain.from_iterable(given))
    x, y, z, w, i, j, k = np.fromiter(numbers, float, 7 * count).reshape(count, 7).T
    X = np.zeros((count, 4, 4))
    X[:, 0] = np.stack((1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j), x * MM), axis=1)
    X[:, 1] = np.stack((2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i), y * MM), axis=1)
    X[:, 2] = np.stack((2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j), z * MM), axis=1)
    X[:, 3, 3] = 1.0
    X.flags.writeable = False
    return X


def frame(X: Array) -> Frame:
    """A pose [m] as a frame [mm]."""
    x, y, z = (float(value) / MM for value in X[:3, 3])
    w, i, j, k = (float(value) for value in wxyz_from_rotation(X[:3, :3]))
    return (x, y, z), (w, i, j, k)
