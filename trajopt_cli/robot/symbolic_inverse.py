"""The closed-form inverse kinematics on one fixed branch as a CasADi expression, and its motion along a path.

The same algebra as robot.inverse, written once more because there a branch is an array axis with NaN where nothing
exists, and here it is a pair of signs in a smooth expression. Tests hold the two against each other.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot.model import Arm, RobotModel
from trajopt_cli.robot.symbolic import Reached, forward


@dataclass(frozen=True)
class BranchSigns:
    """ABB cfx as three signs: +1 wrist centre before axis 1, before the lower arm (cos q3 > 0), q5 >= 0; else -1."""

    shoulder: float
    elbow: float
    wrist: float

    @classmethod
    def from_cfx(cls, cfx: int) -> BranchSigns:
        """The signs of branch number cfx in 0..7."""
        return cls(*(-1.0 if cfx & bit else 1.0 for bit in (4, 2, 1)))

    def vector(self) -> Array:
        """(3,): shoulder, elbow, wrist."""
        return np.array([self.shoulder, self.elbow, self.wrist])


@dataclass(frozen=True)
class ArmExpressions:
    """Expressions of a six-axis arm, on a rail or not."""

    robot: RobotModel

    def flange(self, q: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Flange position (3,) and rotation (3, 3) in the world."""
        return forward(self.robot, q)

    def branch(self, number: int) -> Array:
        """The signs (3,) of a cfx."""
        return BranchSigns.from_cfx(number).vector()

    def inverse(self, position: ca.SX, rotation: ca.SX, branch: ca.SX, near: ca.SX) -> Reached:
        """See inverse_arm."""
        q, s3 = inverse_arm(self.robot.arm, position, rotation, branch, near)
        return Reached(q, s3, branch[2] * ca.sin(q[4]))


def _angle(y: ca.SX, x: ca.SX, reference: ca.SX) -> ca.SX:
    """atan2(y, x) continued within half a turn of a reference angle, so that no branch cut lies near it."""
    c, s = ca.cos(reference), ca.sin(reference)
    return reference + ca.atan2(y * c - x * s, x * c + y * s)


def inverse_arm(arm: Arm, p_BF: ca.SX, R_BF: ca.SX, signs: ca.SX, reference: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Joints q (6,) [rad] of flange pose p_BF (3,) [m], R_BF (3, 3) in the arm's base frame, and sin q3 (1,).

    signs (3,): see BranchSigns. reference (6,): angles within half a turn of the answer; they choose the turns.
    sin q3 is given back unclamped: |sin q3| <= 1 is the condition that the wrist centre is in reach.
    """
    shoulder, elbow, wrist = signs[0], signs[1], signs[2]
    w = p_BF - arm.L6 * R_BF[:, 2]
    radius = shoulder * ca.sqrt(w[0] ** 2 + w[1] ** 2)
    q1 = _angle(shoulder * w[1], shoulder * w[0], reference[0])
    u, z = radius - arm.a1, w[2] - arm.d1
    s3 = (arm.L2**2 + arm.L4**2 - u**2 - z**2) / (2 * arm.L2 * arm.L4)
    c3 = elbow * ca.sqrt(ca.fmax(1 - s3**2, 1e-12))
    q3 = _angle(s3, c3, reference[2])
    a, b = arm.L2 - arm.L4 * s3, arm.L4 * c3
    q2 = _angle(a * u - b * z, a * z + b * u, reference[1])
    c1, s1 = shoulder * w[0], shoulder * w[1]
    norm1 = ca.sqrt(w[0] ** 2 + w[1] ** 2)
    c1, s1 = c1 / norm1, s1 / norm1
    c23, s23 = ca.cos(q2 + q3), ca.sin(q2 + q3)
    # R_36 = (Rz(q1) Ry(q2+q3))^T R_06, where the flange adds Ry(90 deg): R_06 has columns (z_F, y_F, -x_F).
    R_06 = ca.horzcat(R_BF[:, 2], R_BF[:, 1], -R_BF[:, 0])
    row = ca.vertcat(
        ca.horzcat(c1 * c23, s1 * c23, -s23),
        ca.horzcat(-s1, c1, 0),
        ca.horzcat(c1 * s23, s1 * s23, c23),
    )
    R = row @ R_06
    s5 = wrist * ca.sqrt(R[1, 0] ** 2 + R[2, 0] ** 2)
    q5 = _angle(s5, R[0, 0], reference[4])
    q4 = _angle(wrist * R[1, 0], -wrist * R[2, 0], reference[3])
    q6 = _angle(wrist * R[0, 1], wrist * R[0, 2], reference[5])
    return ca.vertcat(q1, q2, q3, q4, q5, q6), s3
