"""Rotations of a single sample in plain floats, for the loop's period: nine floats, row by row.

NumPy's call costs more than the arithmetic of a 3 x 3 matrix; whole sequences of rotations are in geometry.py.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import atan2, cos, hypot, pi, remainder, sin, sqrt

from trajopt_cli.robot.srs_step import Floats3, Floats9

Three = Floats3
Nine = Floats9


def nine(row: Iterable[float]) -> Nine:
    """Nine numbers as what the functions here take."""
    a, b, c, d, e, f, g, h, i = row
    return (a, b, c, d, e, f, g, h, i)


def transpose(A: Nine) -> Nine:
    """The inverse of a rotation."""
    a, b, c, d, e, f, g, h, i = A
    return (a, d, g, b, e, h, c, f, i)


def rotation(alpha: float, beta: float, gamma: float) -> Nine:
    """Rz(gamma) Ry(beta) Rx(alpha): extrinsic Tait-Bryan angles [rad] (eq. 4.18)."""
    ca, sa, cb, sb, cg, sg = cos(alpha), sin(alpha), cos(beta), sin(beta), cos(gamma), sin(gamma)
    return (
        cg * cb,
        cg * sb * sa - sg * ca,
        cg * sb * ca + sg * sa,
        sg * cb,
        sg * sb * sa + cg * ca,
        sg * sb * ca - cg * sa,
        -sb,
        cb * sa,
        cb * ca,
    )


def angles(R: Nine, near: Three = (0.0, 0.0, 0.0)) -> Three:
    """Angles of rotation(), whole turns chosen so that alpha and gamma are nearest to near; |beta| <= 90 deg.

    At |beta| = 90 deg only a sum of alpha and gamma is defined: alpha is then the one of near.
    """
    cosine = hypot(R[7], R[8])
    alpha = near[0] if cosine < 1e-12 else atan2(R[7], R[8])
    beta = atan2(-R[6], cosine)
    # gamma from R Rx(-alpha) = Rz Ry: near the lock both angles are noise, the orientation is not
    ca, sa = cos(alpha), sin(alpha)
    gamma = atan2(R[2] * sa - R[1] * ca, R[4] * ca - R[5] * sa)
    return (
        near[0] + remainder(alpha - near[0], 2 * pi),
        beta,
        near[2] + remainder(gamma - near[2], 2 * pi),
    )


def spin(at: Three, rates: Three) -> Three:
    """Angular velocity [rad/s] in the fixed frame, of angle rates [rad/s] at angles `at` [rad]."""
    (_, beta, gamma), (da, db, dg) = at, rates
    cb, sb, cg, sg = cos(beta), sin(beta), cos(gamma), sin(gamma)
    return (cg * cb * da - sg * db, sg * cb * da + cg * db, dg - sb * da)


def angle_rates(at: Three, omega: Three) -> Three:
    """Angle rates [rad/s] of an angular velocity: the inverse of spin. Not at |beta| = 90 deg, where none exist."""
    (_, beta, gamma), (x, y, z) = at, omega
    cb, sb, cg, sg = cos(beta), sin(beta), cos(gamma), sin(gamma)
    da = (cg * x + sg * y) / cb
    return (da, cg * y - sg * x, z + sb * da)


def exponential(phi: Three) -> Nine:
    """The rotation about phi by its length [rad] (Rodrigues)."""
    x, y, z = phi
    angle = sqrt(x * x + y * y + z * z)
    if angle < 1e-8:  # the next terms are angle^2/6 and angle^2/12: under rounding
        a, b = 1.0, 0.5
    else:
        half = sin(angle / 2) / angle
        a, b = sin(angle) / angle, 2 * half * half
    bx, by, bz = b * x, b * y, b * z
    return (
        1 - by * y - bz * z,
        bx * y - a * z,
        bx * z + a * y,
        bx * y + a * z,
        1 - bx * x - bz * z,
        by * z - a * x,
        bx * z - a * y,
        by * z + a * x,
        1 - bx * x - by * y,
    )


def logarithm(R: Nine) -> Three:
    """The rotation vector [rad] of R, its length in [0, pi]: the inverse of exponential."""
    a, b, c, d, e, f, g, h, i = R
    trace = a + e + i
    # the quaternion from its largest component: no cancellation near 0 nor near pi
    if trace >= a and trace >= e and trace >= i:
        w = 1 + trace
        x, y, z = h - f, c - g, d - b
    elif a >= e and a >= i:
        w = h - f
        x, y, z = 1 + a - e - i, b + d, c + g
    elif e >= i:
        w = c - g
        x, y, z = b + d, 1 + e - a - i, f + h
    else:
        w = d - b
        x, y, z = c + g, f + h, 1 + i - a - e
    if w < 0:
        w, x, y, z = -w, -x, -y, -z
    sine = sqrt(x * x + y * y + z * z)
    factor = 2 * atan2(sine, w) / sine if sine > 0 else 0.0
    return (factor * x, factor * y, factor * z)
