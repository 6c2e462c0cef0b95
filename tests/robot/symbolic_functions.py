"""The expressions of robot/symbolic.py as CasADi functions, to be held against pin."""

from __future__ import annotations

import casadi as ca

from trajopt_cli.geometry import Array
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.symbolic import forward


def geometric_jacobian(robot: RobotModel, q: ca.SX, X_FT: Array | None = None) -> ca.SX:
    """Geometric Jacobian (6, k) at the TCP in world axes, linear rows first: what differentiating forward gives."""
    p, R = forward(robot.pin_model, q, X_FT)
    columns = []
    for i in range(q.numel()):
        W = ca.reshape(ca.jacobian(ca.vec(R), q)[:, i], 3, 3) @ R.T  # of the angular velocity
        columns.append(ca.vertcat(ca.jacobian(p, q)[:, i], W[2, 1], W[0, 2], W[1, 0]))
    return ca.horzcat(*columns)


def forward_function(robot: RobotModel, X_FT: Array | None = None) -> ca.Function:
    """(q) -> (p, R): see forward."""
    q = _axes_symbol(robot, "q")
    p, R = forward(robot.pin_model, q, X_FT)
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
    p, _ = forward(robot.pin_model, q, X_FT)
    J = geometric_jacobian(robot, q, X_FT)
    velocity = J @ qd
    acceleration = ca.jtimes(velocity, q, qd) + J @ qdd
    outputs = [p, velocity[:3], acceleration[:3], velocity[3:], acceleration[3:]]
    names = ["p", "v", "a", "omega", "alpha"]
    return ca.Function("tcp_motion", [q, qd, qdd], [ca.densify(o) for o in outputs], ["q", "qd", "qdd"], names)


def _axes_symbol(robot: RobotModel, name: str) -> ca.SX:
    return ca.SX.sym(name, len(robot.axis_names))
