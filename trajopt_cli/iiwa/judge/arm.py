"""The arm as pin sees it: where shoulder, elbow and wrist are, and the arm angle they make."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.judge.mechanism import Mechanism

SIGNED = (1, 3, 5)
"""Joints 2, 4 and 6: their signs are the configuration."""
_COLLINEAR = 1e-9  # m: an elbow or a vertical this near the line from shoulder to wrist has no direction from it


def elbow_circle(mechanism: Mechanism, q: Array) -> tuple[Array, Array]:
    """Swivel angles (n,) [rad] at joints q (n, 7), and how far (n,) [m] the elbow stands off the line from shoulder S
    to wrist centre W (0 where there is no angle).

    S, E and W are where axes 1 and 2, 3 and 4, 5 and 6 meet. The angle goes right-handed about S -> W, from the half
    plane that holds the base's z direction to the one that holds the elbow.
    """
    X, J = mechanism.flange(q)
    axes = J[:, 3:]  # (n, 3, 7): unit, in the world
    # the flange turns about axis i with speed J_i = a_i x (p - o_i): a point of the axis is p + a_i x J_i
    points = X[:, :3, 3, None] + np.cross(axes, J[:, :3], axis=1)
    S, E, W = (_meeting(axes, points, i) for i in (0, 2, 4))
    along = W - S
    reach = np.linalg.norm(along, axis=1, keepdims=True)
    n = along / np.where(reach > 0, reach, 1.0)
    up, out = axes[:, :, 0], E - S  # axis 1 is the base's z
    up, out = (v - np.sum(v * n, axis=1, keepdims=True) * n for v in (up, out))
    angle = np.arctan2(np.sum(n * np.cross(up, out), axis=1), np.sum(up * out, axis=1))
    off = np.minimum(np.linalg.norm(out, axis=1), np.linalg.norm(up, axis=1) * reach[:, 0])
    return np.asarray(angle), np.where(off > _COLLINEAR, off, 0.0)


def arm_angles(mechanism: Mechanism, q: Array, swivel: bool) -> tuple[Array, Array]:
    """As elbow_circle, counted as the task does. Faria's angle is that from the elbow of an arm with q3 = 0 and the
    same sign of q4: upright above S -> W where q4 is negative, and below it else."""
    angle, off = elbow_circle(mechanism, q)
    return angle if swivel else angle - np.where(q[:, 3] < 0, 0.0, np.pi), off


def wrapped(angle: Array | float) -> Array:
    """Within half a turn of 0."""
    return np.asarray(angle - 2 * np.pi * np.rint(np.asarray(angle) / (2 * np.pi)))


def configuration(q: Array) -> int:
    """(q2 < 0) + 2 (q4 < 0) + 4 (q6 < 0) at joints q (7,)."""
    return sum(int(q[joint] < 0) << bit for bit, joint in enumerate(SIGNED))


def _meeting(axes: Array, points: Array, i: int) -> Array:
    """Where axes i and i + 1 meet (n, 3): the point of the first that is nearest to the second."""
    a, b = axes[:, :, i], axes[:, :, i + 1]
    between = points[:, :, i + 1] - points[:, :, i]
    cosine = np.sum(a * b, axis=1, keepdims=True)
    along = np.sum(between * (a - cosine * b), axis=1, keepdims=True) / (1 - cosine * cosine)
    return np.asarray(points[:, :, i] + along * a)
