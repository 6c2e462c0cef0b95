"""CasADi expressions of a robot's kinematics, generated from its pin.Model: placements and motion subspaces.

PyPI's pin has no pinocchio.casadi; this walk is what the optimiser differentiates, and pin tests it. World axes, rail
first, as in RobotModel. Casadi drops products with exact zeros and ones, so placements are rounded to them first.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.urdf import FLANGE


class Reached(NamedTuple):
    """Joints q (m,) of a pose on one branch, and the walls beside them: elbow, in (-1, 1) while the pose is in reach,
    and wrist, positive on the branch's side of the singular wrist."""

    q: ca.SX
    elbow: ca.SX
    wrist: ca.SX


class Expressions(Protocol):
    """A robot's kinematics as CasADi expressions of its n axes."""

    def flange(self, q: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Flange position (3,) [m] and rotation (3, 3) in the world at axes q (n,)."""

    def branch(self, number: int) -> Array:
        """The parameters (3,) that stand for a branch in inverse."""

    def inverse(self, position: ca.SX, rotation: ca.SX, branch: ca.SX, near: ca.SX) -> Reached:
        """Joints of a flange pose in the arm's base frame, on a branch, within half a turn of joints near (m,)."""


@dataclass(frozen=True)
class _Axis:
    """One axis in the world: unit direction a (3,), a point o (3,) on it, and whether it turns or slides."""

    a: ca.SX
    o: ca.SX
    turns: bool


def forward(robot: RobotModel, q: ca.SX, X_FT: Array | None = None) -> tuple[ca.SX, ca.SX]:
    """TCP position p (3,) [m] and rotation R (3, 3) in the world as expressions of axis positions q (k,)."""
    p, R, _ = _walk(robot, q, X_FT)
    return p, R


def geometric_jacobian(robot: RobotModel, q: ca.SX, X_FT: Array | None = None) -> ca.SX:
    """Geometric Jacobian (6, k) at the TCP in world axes, linear rows first, as an expression of q (k,)."""
    p, _, axes = _walk(robot, q, X_FT)
    columns = [
        ca.vertcat(ca.cross(axis.a, p - axis.o), axis.a) if axis.turns else ca.vertcat(axis.a, ca.SX.zeros(3))
        for axis in axes
    ]
    return ca.horzcat(*columns)


def forward_function(robot: RobotModel, X_FT: Array | None = None) -> ca.Function:
    """(q) -> (p, R): see forward."""
    q = _axes_symbol(robot, "q")
    p, R = forward(robot, q, X_FT)
    return ca.Function("forward", [q], [p, R], ["q"], ["p", "R"])


def jacobian_function(robot: RobotModel, X_FT: Array | None = None) -> ca.Function:
    """(q) -> (J): see geometric_jacobian."""
    q = _axes_symbol(robot, "q")
    return ca.Function("jacobian", [q], [ca.densify(geometric_jacobian(robot, q, X_FT))], ["q"], ["J"])


def jacobian_rate_function(robot: RobotModel, X_FT: Array | None = None) -> ca.Function:
    """(q, qd) -> (J_rate): time derivative (6, k) of the geometric Jacobian along axis speeds qd (k,)."""
    q, qd = _axes_symbol(robot, "q"), _axes_symbol(robot, "qd")
    rate = ca.jtimes(geometric_jacobian(robot, q, X_FT), q, qd)
    return ca.Function("jacobian_rate", [q, qd], [ca.densify(rate)], ["q", "qd"], ["J_rate"])


def tcp_motion_function(robot: RobotModel, X_FT: Array | None = None) -> ca.Function:
    """(q, qd, qdd) -> (p, v, a, omega, alpha): TCP position, velocity, acceleration and angular ones (3,), world."""
    q, qd, qdd = (_axes_symbol(robot, name) for name in ("q", "qd", "qdd"))
    p, _ = forward(robot, q, X_FT)
    J = geometric_jacobian(robot, q, X_FT)
    velocity = J @ qd
    acceleration = ca.jtimes(velocity, q, qd) + J @ qdd
    outputs = [p, velocity[:3], acceleration[:3], velocity[3:], acceleration[3:]]
    names = ["p", "v", "a", "omega", "alpha"]
    return ca.Function("tcp_motion", [q, qd, qdd], [ca.densify(o) for o in outputs], ["q", "qd", "qdd"], names)


def _axes_symbol(robot: RobotModel, name: str) -> ca.SX:
    return ca.SX.sym(name, len(robot.axis_names))


def _walk(robot: RobotModel, q: ca.SX, X_FT: Array | None) -> tuple[ca.SX, ca.SX, list[_Axis]]:
    """TCP position, rotation and the axes, from the world to the TCP along the model's one chain.

    Parallel turns in a row (axes 2 and 3) are kept as one turn by the sum of their angles: fewer products.
    """
    model = robot.pin_model
    flange = model.frames[model.getFrameId(FLANGE)]
    p, R = ca.SX.zeros(3), ca.SX.eye(3)  # R: before the turn that is still open
    open_axis, open_angle = np.zeros(3), ca.SX(0)
    axes: list[_Axis] = []
    for i in range(1, model.njoints):
        X = model.jointPlacements[i]
        if model.parents[i] != i - 1 or model.nqs[i] != 1:
            raise ValueError(f"joint {model.names[i]}: only a chain of one-axis joints has expressions")
        subspace = np.asarray(model.joints[i].createData().S).reshape(6)
        slide, turn = subspace[:3], subspace[3:]
        R_here = R @ _turn(open_axis, open_angle)
        p = p + R_here @ _exact(X.translation)
        if np.any(slide):
            R, open_axis, open_angle = R_here @ _exact(X.rotation), np.zeros(3), ca.SX(0)
            axes.append(_Axis(R @ _exact(slide), p, turns=False))
            p = p + axes[-1].a * q[i - 1]
        elif np.array_equal(turn, open_axis) and np.array_equal(X.rotation, np.eye(3)):
            open_angle = open_angle + q[i - 1]
            axes.append(_Axis(axes[-1].a, p, turns=True))
        else:
            R, open_axis, open_angle = R_here @ _exact(X.rotation), turn, q[i - 1]
            axes.append(_Axis(R @ _exact(turn), p, turns=True))
    tail = flange.placement.homogeneous @ (np.eye(4) if X_FT is None else np.asarray(X_FT, dtype=np.float64))
    R = R @ _turn(open_axis, open_angle)
    return p + R @ _exact(tail[:3, 3]), R @ _exact(tail[:3, :3]), axes


def _turn(axis: Array, angle: ca.SX) -> ca.SX:
    """Rotation (3, 3) about a unit axis (3,), the identity for the zero axis (Rodrigues, so that no 1 - (1 - cos))."""
    if not np.any(axis):
        return ca.SX.eye(3)
    x, y, z = axis
    along, K = np.outer(axis, axis), np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return _exact(along) + _exact(np.eye(3) - along) * ca.cos(angle) + _exact(K) * ca.sin(angle)


def _exact(values: Array) -> ca.SX:
    """Numbers as a constant expression, with rounding next to 0 and +-1 removed so that products vanish."""
    values = np.asarray(values, dtype=np.float64)
    near = np.round(values)
    return ca.sparsify(ca.SX(np.where(np.abs(values - near) < 1e-15, near, values)))
