"""Velocities and accelerations between axes and TCP, both ways.

POKÚ (forward) and IOKÚ (inverse, with the rail's motion given) of Krotký 2014, 1.1 and 3.8. A TCP motion is (..., 6):
linear [m/s, m/s2], then angular [rad/s, rad/s2], of the TCP, in world axes. k axes, the rail first.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot.inverse import branch_margins
from trajopt_cli.robot.model import RobotModel

_SINGULAR = 1e-9  # of the three measures below: axis speeds would be a billion times the TCP's


def forward_velocity(robot: RobotModel, q: Array, qd: Array, X_FT: Array | None = None) -> Array:
    """TCP velocity (..., 6) = J qd at axis positions and speeds (..., k). X_FT (4, 4): TCP in the flange frame."""
    return robot.differential(q, X_FT).velocity(np.asarray(qd))


def forward_acceleration(robot: RobotModel, q: Array, qd: Array, qdd: Array, X_FT: Array | None = None) -> Array:
    """TCP acceleration (..., 6) = J qdd + J' qd at axis positions, speeds and accelerations (..., k)."""
    return np.asarray(robot.differential(q, X_FT).motion(np.asarray(qd), np.asarray(qdd))[..., 1, :])


def singularity(robot: RobotModel, q: Array) -> Array:
    """How far arm joints are from singular (..., 3): |sin| of axis 5 from where axis 6 runs on along axis 4; |cos| of
    the elbow, 0 where it is stretched or folded; m of the wrist centre before or behind axis 1 in the arm's plane.

    Their product times the lengths of lower and upper arm is |det| of the arm's Jacobian. q (..., k); a rail does not
    matter. For ABB's arms without an elbow offset they are |sin q5|, |cos q3| and a distance from axis 1.
    """
    before, elbow, axis_5 = branch_margins(robot.arm, np.asarray(q, dtype=np.float64)[..., -6:])
    measures: Array = np.abs(np.stack([np.sin(axis_5), elbow, before], axis=-1))
    return measures


def inverse_velocity(
    robot: RobotModel, q: Array, V: Array, rail_rate: Array | float | None = None, X_FT: Array | None = None
) -> Array:
    """Axis speeds (..., k) that move the TCP by V (..., 6) at q (..., k) while the rail runs at rail_rate (...) [m/s].

    qd_arm = J_A^-1 (V - J_d rail_rate), the rail's own speed put before it. rail_rate is needed with a rail.
    Raises ValueError at a singular configuration (any measure of singularity under 1e-9), naming it.
    """
    J = robot.jacobian(q, X_FT)
    return _solve(robot, np.asarray(q, dtype=np.float64), J, np.asarray(V, dtype=np.float64), rail_rate)


def inverse_acceleration(
    robot: RobotModel,
    q: Array,
    qd: Array,
    A: Array,
    rail_acceleration: Array | float | None = None,
    X_FT: Array | None = None,
) -> Array:
    """Axis accelerations (..., k) for TCP acceleration A (..., 6) at q, qd (..., k), rail_acceleration (...) [m/s2].

    qdd_arm = J_A^-1 (A - J' qd - J_d rail_acceleration). Needs and raises as inverse_velocity.
    """
    at = robot.differential(q, X_FT)
    rest = np.asarray(A, dtype=np.float64) - at.bias(np.asarray(qd, dtype=np.float64))
    return _solve(robot, np.asarray(q, dtype=np.float64), at.jacobian(), rest, rail_acceleration)


def _divide(A: Array, B: Array) -> Array:
    return np.asarray(np.linalg.solve(A, B), dtype=np.float64)


def _solve(robot: RobotModel, q: Array, J: Array, wanted: Array, rail: Array | float | None) -> Array:
    measures = singularity(robot, q)
    if np.any(measures < _SINGULAR):
        *row, which = (int(i) for i in np.argwhere(measures < _SINGULAR)[0])
        name = (
            "wrist singularity: |sin| of axis 5",
            "elbow singularity: |cos| of the elbow",
            "shoulder singularity: wrist centre off axis 1 by [m]",
        )[which]
        place = f" at row {', '.join(map(str, row))}" if row else ""
        raise ValueError(f"{name} = {measures[(*row, which)]:.3g}{place}, at least {_SINGULAR:g} to be inverted")
    if not robot.has_rail:
        return _divide(J, wanted[..., None])[..., 0]
    if rail is None:
        raise ValueError(f"robot {robot.name} rides a rail: give the rail's own motion")
    rate = np.broadcast_to(np.asarray(rail, dtype=np.float64), q.shape[:-1])[..., None]
    arm = _divide(J[..., 1:], (wanted - J[..., 0] * rate)[..., None])[..., 0]
    return np.concatenate([rate, arm], axis=-1)
