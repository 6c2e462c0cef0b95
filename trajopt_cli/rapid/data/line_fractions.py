"""Shares of a line between two frames as RAPID holds them: mm, and quaternions that keep their sign."""

from __future__ import annotations

from math import atan2, sin, sqrt

from trajopt_cli.rapid.data.frames import Frame, Quaternion, conjugate, length, product


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
