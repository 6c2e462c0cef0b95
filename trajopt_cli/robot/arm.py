"""Six-axis arm with a spherical wrist and ABB's axis directions: closed-form products in the arm's base frame.

q = 0 stands the lower arm up and stretches the upper arm forward; the flange frame is tool0 (z out of the flange):
X_BF = Rz(q1) T(a1, 0, d1) Ry(q2) T(0, 0, L2) Ry(q3) T(L4, 0, 0) Rx(q4) Ry(q5) Rx(q6) T(L6, 0, 0) Ry(90 deg).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.robot.urdf import UrdfJoint

_EXACT = 1e-12  # m or a matrix entry: how far a URDF number may lie from the structure the closed form needs


@dataclass(frozen=True)
class Arm:
    """Lengths [m]: a1, d1 from the base to axis 2 (forward, up); L2 to axis 3; L4 to the wrist centre; L6 to tool0."""

    a1: float
    d1: float
    L2: float
    L4: float
    L6: float


def arm_from_chain(chain: list[UrdfJoint], file: str) -> Arm:
    """The arm's lengths from its six revolute joints and the fixed flange joint, in that order.

    Raises InputError where an axis or an offset is not the one the closed form stands on.
    """
    wanted_axes = ((0, 0, 1), (0, 1, 0), (0, 1, 0), (1, 0, 0), (0, 1, 0), (1, 0, 0))
    # Which coordinates of each origin may be non-zero; the last row is the flange.
    allowed = ((0, 0, 1), (1, 0, 1), (0, 0, 1), (1, 0, 0), (1, 0, 0), (1, 0, 0), (1, 0, 0))
    turns = [np.eye(3)] * 6 + [np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])]
    for i, joint in enumerate(chain):
        where = f"joint '{joint.name}'"
        need = "the closed-form inverse needs axes z, y, y, x, y, x and a spherical wrist at q = 0"
        if i < 6 and not np.allclose(joint.axis, wanted_axes[i], rtol=0, atol=_EXACT):
            raise InputError(f"{where} has axis {_row(joint.axis)}, wanted {_row(wanted_axes[i])}: {need}", file=file)
        if not np.allclose(joint.X[:3, :3], turns[i], rtol=0, atol=_EXACT):
            wish = "rpy 0 0 0" if i < 6 else "rpy 0 pi/2 0"
            raise InputError(f"{where} has a turned origin, wanted {wish}: {need}", file=file)
        stray = joint.X[:3, 3] * (1 - np.array(allowed[i]))
        if np.any(np.abs(stray) > _EXACT):
            raise InputError(f"{where} has origin {_row(joint.X[:3, 3])} m: {need}", file=file)
    p = [joint.X[:3, 3] for joint in chain]
    arm = Arm(
        a1=float(p[1][0]),
        d1=float(p[0][2] + p[1][2]),
        L2=float(p[2][2]),
        L4=float(p[3][0] + p[4][0]),
        L6=float(p[5][0] + p[6][0]),
    )
    if min(arm.L2, arm.L4) <= 0:
        raise InputError(f"arm lengths L2 = {arm.L2} m and L4 = {arm.L4} m must be positive", file=file)
    return arm


def _row(values: object) -> str:
    return " ".join(f"{v:g}" for v in np.asarray(values, dtype=np.float64))


def _sines(q: Array) -> tuple[list[Array], list[Array]]:
    """Cosines and sines of q1, q2, q2 + q3, q4, q5, q6, each (...)."""
    angles = np.stack([q[..., 0], q[..., 1], q[..., 1] + q[..., 2], q[..., 3], q[..., 4], q[..., 5]])
    return list(np.cos(angles)), list(np.sin(angles))


def forward(arm: Arm, q: Array) -> Array:
    """Flange poses X_BF (..., 4, 4) of joints q (..., 6) in rad."""
    (c1, c2, c23, c4, c5, c6), (s1, s2, s23, s4, s5, s6) = _sines(q)
    X = np.zeros((*q.shape[:-1], 4, 4))
    X[..., 3, 3] = 1.0
    # Columns of Rx(q4) Ry(q5) Rx(q6) Ry(90 deg), then turned by Ry(q2 + q3) and Rz(q1).
    xx, xy, xz = s5 * c6, -(c4 * s6 + s4 * c5 * c6), c4 * c5 * c6 - s4 * s6
    yx, yy, yz = s5 * s6, c4 * c6 - s4 * c5 * s6, s4 * c6 + c4 * c5 * s6
    zx, zy, zz = c5, s4 * s5, -c4 * s5
    for column, (x, y, z) in enumerate(((-xx, -xy, -xz), (yx, yy, yz), (zx, zy, zz))):
        ahead = c23 * x + s23 * z
        X[..., 0, column] = c1 * ahead - s1 * y
        X[..., 1, column] = s1 * ahead + c1 * y
        X[..., 2, column] = c23 * z - s23 * x
    radius = arm.a1 + arm.L2 * s2 + arm.L4 * c23
    X[..., 0, 3] = c1 * radius + arm.L6 * X[..., 0, 2]
    X[..., 1, 3] = s1 * radius + arm.L6 * X[..., 1, 2]
    X[..., 2, 3] = arm.d1 + arm.L2 * c2 - arm.L4 * s23 + arm.L6 * X[..., 2, 2]
    return X


def axes_and_points(arm: Arm, q: Array) -> tuple[Array, Array]:
    """Unit axes (3, 6, ...) of the joints and a point (3, 6, ...) on each [m], base frame, of q (..., 6).

    Components lead, so that each is one contiguous block: four times faster than (..., 3) on long batches.
    """
    (c1, c2, c23, c4, c5, _), (s1, s2, s23, s4, s5, _) = _sines(q)
    zero, one = np.zeros_like(c1), np.ones_like(c1)
    radius = arm.a1 + arm.L2 * s2
    a, o = np.zeros((3, 6, *q.shape[:-1])), np.zeros((3, 6, *q.shape[:-1]))
    a[:, 0] = zero, zero, one
    a[:, 1] = a[:, 2] = -s1, c1, zero
    a[:, 3] = c1 * c23, s1 * c23, -s23
    ahead = s23 * s4  # of Ry(q2 + q3) Rx(q4) e_y
    a[:, 4] = c1 * ahead - s1 * c4, s1 * ahead + c1 * c4, c23 * s4
    y, z = s4 * s5, -c4 * s5
    ahead = c23 * c5 + s23 * z  # of Ry(q2 + q3) Rx(q4) Ry(q5) e_x
    a[:, 5] = c1 * ahead - s1 * y, s1 * ahead + c1 * y, c23 * z - s23 * c5
    o[:, 1] = arm.a1 * c1, arm.a1 * s1, arm.d1 * one
    o[:, 2] = radius * c1, radius * s1, arm.d1 + arm.L2 * c2
    o[:, 3:] = (o[:, 2] + arm.L4 * a[:, 3])[:, None]
    return a, o
