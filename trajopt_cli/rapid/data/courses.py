"""Ways between frames: a share of a line, and the arc through three points. Lengths in the unit of the points."""

from __future__ import annotations

from math import atan2, pi, sin, sqrt
from typing import NamedTuple

from trajopt_cli.rapid.data.frames import Frame, Quaternion, Vector, conjugate, cross, length, product, rotate

_STRAIGHT = 1e-9  # sine of the angle between two chords below which three points lie on one line


class Arc(NamedTuple):
    """centre, unit axis, and the angle [rad] in (0, 2 pi) from start to end about the axis."""

    centre: Vector
    axis: Vector
    angle: float


def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def arc(start: Vector, via: Vector, end: Vector) -> Arc | None:
    """The arc from start through via to end; None for points on one line."""
    u, v = minus(via, start), minus(end, start)
    n = cross(u, v)
    size = length(n)
    if size <= _STRAIGHT * length(u) * length(v):
        return None
    axis = (n[0] / size, n[1] / size, n[2] / size)
    uu, vv = _dot(u, u), _dot(v, v)
    a, b = cross(n, u), cross(v, n)
    scale = 2 * size * size
    out = ((vv * a[0] + uu * b[0]) / scale, (vv * a[1] + uu * b[1]) / scale, (vv * a[2] + uu * b[2]) / scale)
    centre = (start[0] + out[0], start[1] + out[1], start[2] + out[2])
    first, last = minus(start, centre), minus(end, centre)
    return Arc(centre, axis, atan2(_dot(axis, cross(first, last)), _dot(first, last)) % (2 * pi))


def radius(course: Arc, start: Vector) -> float:
    """Distance of the arc's points from its centre."""
    return length(minus(start, course.centre))


def along(course: Arc, start: Vector, share: float) -> Vector:
    """The point at a share 0..1 of an arc that begins at start."""
    angle = course.angle * share
    half = sin(angle / 2)
    w = sqrt(max(0.0, 1 - half * half)) * (-1 if angle > pi else 1)
    x, y, z = course.axis
    p = rotate((w, x * half, y * half, z * half), minus(start, course.centre))
    return (course.centre[0] + p[0], course.centre[1] + p[1], course.centre[2] + p[2])


def turned(a: Quaternion, b: Quaternion, share: float) -> Quaternion:
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
    return p, turned(a[1], b[1], share)
