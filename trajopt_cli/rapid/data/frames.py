"""Positions, quaternions and frames of RAPID as plain tuples: p (x, y, z), q (w, x, y, z), a frame (p, q).

Plain tuples because a program computes with one frame at a time, where an array costs twenty times the arithmetic.
The motions leave this room as the arrays of trajopt_cli.geometry.
"""

from __future__ import annotations

from math import atan2, cos, hypot, sin, sqrt

from trajopt_cli.path.circle import cross

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


def matrix(q: Quaternion) -> tuple[Vector, Vector, Vector]:
    """Rotation matrix rows of a unit quaternion."""
    w, x, y, z = q
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


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
