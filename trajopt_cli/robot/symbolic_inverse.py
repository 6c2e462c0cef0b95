"""The closed-form inverse kinematics on one fixed branch as a CasADi expression, and its motion along a path.

The same algebra as robot.inverse, in canonical angles, written once more because there a branch is an array axis with
NaN where nothing exists, and here it is a pair of signs in a smooth expression. Tests hold the two against each other.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
import numpy as np
import pinocchio as pin

from trajopt_cli.geometry import Array
from trajopt_cli.robot.arm import Arm
from trajopt_cli.robot.parallel_arm import ParallelArm
from trajopt_cli.robot.symbolic import Reached, exact, forward


def branch_signs(cfx: int) -> Array:
    """ABB cfx in 0..7 as signs (3,): +1 wrist centre before axis 1, before the lower arm, axis 5 >= 0; else -1."""
    return np.array([-1.0 if cfx & bit else 1.0 for bit in (4, 2, 1)])


@dataclass(frozen=True, eq=False)
class ArmExpressions:
    """Expressions of a six-axis arm, on a rail or not. chain_axes: the chain's joints of the controller's axes."""

    arm: Arm
    chain: pin.Model
    chain_axes: Callable[[ca.SX], ca.SX]

    def flange(self, q: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Flange position (3,) [m] and rotation (3, 3) in the world at axes q (n,)."""
        return forward(self.chain, self.chain_axes(q))

    def branch(self, number: int) -> Array:
        """The signs (3,) of a cfx, which stand for a branch in inverse."""
        return branch_signs(number)

    def inverse(self, position: ca.SX, rotation: ca.SX, branch: ca.SX, near: ca.SX) -> Reached:
        """Joints of a flange pose in the arm's base frame, on a branch, within half a turn of joints near (6,)."""
        arm = self.arm
        if not arm.closed_form:
            raise ValueError("a wrist with an offset has no closed form")
        q, reach = inverse_arm(arm, position, rotation, branch, near)
        return Reached(q, reach, branch[2] * ca.sin(q[4] + float(arm.signs[4] * arm.offsets[4])))


def _angle(y: ca.SX, x: ca.SX, reference: ca.SX) -> ca.SX:
    """atan2(y, x) continued within half a turn of a reference angle, so that no branch cut lies near it."""
    c, s = ca.cos(reference), ca.sin(reference)
    return reference + ca.atan2(y * c - x * s, x * c + y * s)


def inverse_arm(arm: Arm, p_BF: ca.SX, R_BF: ca.SX, signs: ca.SX, reference: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Joints q (6,) [rad] of flange pose p_BF (3,) [m], R_BF (3, 3) in the arm's base frame, and what says that it is
    in reach (1,), or (2,) for an arm with an offset b.

    signs (3,): see branch_signs. reference (6,): angles within half a turn of the answer; they choose the turns. The
    wrist centre is in reach where the sine of the elbow, unclamped, is between -1 and 1, and (b / r)^2 below 1 with r
    from axis 1 to the wrist centre.
    """
    shoulder, elbow, wrist = signs[0], signs[1], signs[2]
    near = exact(arm.signs) * reference + exact(arm.offsets)  # in canonical angles, as all that follows
    if arm.coupled:
        near[2] -= float(arm.signs[1]) * reference[1]
    p, R = _canonical(arm, p_BF, R_BF)
    w = p - arm.c4 * R[:, 2]
    square = w[0] ** 2 + w[1] ** 2
    if arm.b:
        radius = shoulder * ca.sqrt(ca.fmax(square - arm.b**2, 1e-12))
        c1, s1 = radius * w[0] + arm.b * w[1], radius * w[1] - arm.b * w[0]
        t1 = _angle(s1, c1, near[0])
        c1, s1 = c1 / square, s1 / square
    else:
        norm = ca.sqrt(square)
        radius = shoulder * norm
        c1, s1 = shoulder * w[0], shoulder * w[1]
        t1 = _angle(s1, c1, near[0])
        c1, s1 = c1 / norm, s1 / norm
    u, z = radius - arm.a1, w[2] - arm.c1
    if isinstance(arm, ParallelArm):
        R_1K = ca.vertcat(c1 * R[0, :] + s1 * R[1, :], c1 * R[1, :] - s1 * R[0, :], R[2, :])
        t5, c, s = _axis_5(R_1K, wrist, near)
        u, z = u - c * arm.wrist[0] - s * arm.wrist[2], z + s * arm.wrist[0] - c * arm.wrist[2]
    s3 = (arm.c2**2 + arm.upper**2 - u**2 - z**2) / (2 * arm.c2 * arm.upper)
    c3 = elbow * ca.sqrt(ca.fmax(1 - s3**2, 1e-12))
    t3 = _angle(s3, c3, near[2] + arm.bend) - arm.bend
    a, b = arm.c2 - arm.upper * s3, arm.upper * c3
    t2 = _angle(a * u - b * z, a * z + b * u, near[1])
    c23, s23 = ca.cos(t2 + t3), ca.sin(t2 + t3)
    apart = ca.vertcat(s3, arm.b**2 / square) if arm.b else s3
    if isinstance(arm, ParallelArm):
        t4 = _angle(s * c23 - c * s23, c * c23 + s * s23, near[3])
        t6 = _angle(-(s * R_1K[0, 0] + c * R_1K[2, 0]), -(s * R_1K[0, 1] + c * R_1K[2, 1]), near[5])
        return _joints(arm, ca.vertcat(t1, t2, t3, t4, t5, t6)), apart
    # R_36 = (Rz(t1) Ry(t2 + t3))^T R_06, where the flange adds Ry(90 deg): R_06 has columns (z_F, y_F, -x_F).
    R_06 = ca.horzcat(R[:, 2], R[:, 1], -R[:, 0])
    row = ca.vertcat(
        ca.horzcat(c1 * c23, s1 * c23, -s23),
        ca.horzcat(-s1, c1, 0),
        ca.horzcat(c1 * s23, s1 * s23, c23),
    )
    R_36 = row @ R_06
    s5 = wrist * ca.sqrt(R_36[1, 0] ** 2 + R_36[2, 0] ** 2)
    t5 = _angle(s5, R_36[0, 0], near[4])
    t4 = _angle(wrist * R_36[1, 0], -wrist * R_36[2, 0], near[3])
    t6 = _angle(wrist * R_36[0, 1], wrist * R_36[0, 2], near[5])
    return _joints(arm, ca.vertcat(t1, t2, t3, t4, t5, t6)), apart


def _joints(arm: Arm, t: ca.SX) -> ca.SX:
    """Joints (6,) of canonical angles (6,)."""
    q = exact(arm.signs) * (t - exact(arm.offsets))
    if arm.coupled:
        q[2] += float(arm.signs[1] * arm.signs[2]) * q[1]
    return q


def _axis_5(R_1K: ca.SX, side: ca.SX, near: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
    """t5 of an arm with three parallel axes, and cosine and sine of their angles' sum: see robot.parallel_arm.bent."""
    bend = ca.sqrt(ca.fmax(R_1K[0, 2] ** 2 + R_1K[2, 2] ** 2, 1e-12))
    return _angle(side * bend, R_1K[1, 2], near[4]), -side * R_1K[0, 2] / bend, side * R_1K[2, 2] / bend


def _canonical(arm: Arm, p_BF: ca.SX, R_BF: ca.SX) -> tuple[ca.SX, ca.SX]:
    """The canonical flange in the canonical base, where the flange is seen from the base link."""
    R_OB = exact(arm.X_BC[:3, :3].T)
    R = R_OB @ R_BF @ exact(arm.X_KF[:3, :3].T)
    return R_OB @ (p_BF - exact(arm.X_BC[:3, 3])) - R @ exact(arm.X_KF[:3, 3]), R
