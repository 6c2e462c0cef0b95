"""CasADi expressions of a robot's kinematics, generated from its pin.Model: placements and motion subspaces.

PyPI's pin has no pinocchio.casadi; this walk is what the optimiser differentiates, and pin tests it. World axes, rail
first, as in RobotModel. Casadi drops products with exact zeros and ones, so placements are rounded to them first.
"""

from __future__ import annotations

from typing import NamedTuple

import casadi as ca
import numpy as np
import pinocchio as pin

from trajopt_cli.geometry import Array
from trajopt_cli.robot.urdf import FLANGE


class Reached(NamedTuple):
    """Joints q (m,) of a pose on one branch, and the singularity margins beside them: elbow, in (-1, 1) while the pose
    is in reach, all of them where there are several, and wrist, positive on the branch's side of the singular wrist."""

    q: ca.SX
    elbow: ca.SX
    wrist: ca.SX


def forward(model: pin.Model, q: ca.SX, X_FT: Array | None = None) -> tuple[ca.SX, ca.SX]:
    """TCP position p (3,) [m] and rotation R (3, 3) in the world as expressions of axis positions q (k,).

    Parallel turns in a row (axes 2 and 3) are kept as one turn by the sum of their angles: fewer products.
    """
    flange = model.frames[model.getFrameId(FLANGE)]
    p, R = ca.SX.zeros(3), ca.SX.eye(3)  # R: before the turn that is still open
    open_axis, open_angle = np.zeros(3), ca.SX(0)
    for i in range(1, model.njoints):
        X = model.jointPlacements[i]
        if model.parents[i] != i - 1 or model.nqs[i] != 1:
            raise ValueError(f"joint {model.names[i]}: only a chain of one-axis joints has expressions")
        subspace = np.asarray(model.joints[i].createData().S).reshape(6)
        slide, turn = subspace[:3], subspace[3:]
        R_here = R @ rotation(open_axis, open_angle)
        p = p + R_here @ exact(X.translation)
        if np.any(slide):
            R, open_axis, open_angle = R_here @ exact(X.rotation), np.zeros(3), ca.SX(0)
            p = p + R @ exact(slide) * q[i - 1]
        elif np.array_equal(turn, open_axis) and np.array_equal(X.rotation, np.eye(3)):
            open_angle = open_angle + q[i - 1]
        else:
            R, open_axis, open_angle = R_here @ exact(X.rotation), turn, q[i - 1]
    tail = flange.placement.homogeneous @ (np.eye(4) if X_FT is None else np.asarray(X_FT, dtype=np.float64))
    R = R @ rotation(open_axis, open_angle)
    return p + R @ exact(tail[:3, 3]), R @ exact(tail[:3, :3])


def rotation(axis: Array, angle: ca.SX) -> ca.SX:
    """Rotation (3, 3) about a unit axis (3,), the identity for the zero axis (Rodrigues, so that no 1 - (1 - cos))."""
    if not np.any(axis):
        return ca.SX.eye(3)
    x, y, z = axis
    along, K = np.outer(axis, axis), np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return exact(along) + exact(np.eye(3) - along) * ca.cos(angle) + exact(K) * ca.sin(angle)


def exact(values: Array) -> ca.SX:
    """Numbers as a constant expression, with rounding next to 0 and +-1 removed so that products vanish."""
    values = np.asarray(values, dtype=np.float64)
    near = np.round(values)
    return ca.sparsify(ca.SX(np.where(np.abs(values - near) < 1e-15, near, values)))
