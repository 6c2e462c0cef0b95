"""The circle through three points, in plain floats and in the unit of the points: reading a program asks for one arc at
a time, where arrays cost twenty times the arithmetic."""

from __future__ import annotations

from math import atan2, pi, sqrt
from typing import NamedTuple

Point = tuple[float, float, float]

_STRAIGHT = 1e-9  # sine of the angle between two chords below which three points lie on one line


class Circle(NamedTuple):
    """centre, unit axis, and the angle [rad] in (0, 2 pi) from start to end about the axis."""

    centre: Point
    axis: Point
    angle: float


def circle_through(start: Point, via: Point, end: Point) -> Circle | None:
    """The arc from start through via to end; None for points on one line or in one place."""
    u, v = minus(via, start), minus(end, start)
    n = cross(u, v)
    size = sqrt(_dot(n, n))
    uu, vv = _dot(u, u), _dot(v, v)
    if size <= _STRAIGHT * sqrt(uu) * sqrt(vv):
        return None
    axis = (n[0] / size, n[1] / size, n[2] / size)
    a, b = cross(n, u), cross(v, n)
    scale = 2 * size * size
    out = ((vv * a[0] + uu * b[0]) / scale, (vv * a[1] + uu * b[1]) / scale, (vv * a[2] + uu * b[2]) / scale)
    centre = (start[0] + out[0], start[1] + out[1], start[2] + out[2])
    first, last = minus(start, centre), minus(end, centre)
    return Circle(centre, axis, atan2(_dot(axis, cross(first, last)), _dot(first, last)) % (2 * pi))


def minus(a: Point, b: Point) -> Point:
    """a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _dot(a: Point, b: Point) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Point, b: Point) -> Point:
    """Vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
