"""Velocities and accelerations between axes and TCP, both ways, and the analytic Jacobian of x-y'-z'' angles.

POKÚ (forward) and IOKÚ (inverse, with the rail's motion given) of Krotký 2014, 1.1 and 3.8. A TCP motion is (..., 6):
linear [m/s, m/s2], then angular [rad/s, rad/s2], of the TCP, in world axes. k axes, the rail first.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, xyz_from_rotation
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


def _apply(J: Array, rates: Array) -> Array:
    product: Array = (J @ np.asarray(rates, dtype=np.float64)[..., None])[..., 0]
    return product


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


def euler_rate_map(angles: Array) -> Array:
    """H (..., 3, 3) with omega = H(phi) phi' for intrinsic x-y'-z'' angles phi (..., 3) in rad, eq. (3.103).

    H is singular at beta = +-90 deg; its columns are the world axes the three angles turn about.
    """
    angles = np.asarray(angles, dtype=np.float64)
    (ca, cb), (sa, sb) = (f(np.moveaxis(angles[..., :2], -1, 0)) for f in (np.cos, np.sin))
    H = np.zeros((*angles.shape[:-1], 3, 3))
    H[..., 0, 0] = 1.0
    H[..., 0, 2] = sb
    H[..., 1, 1], H[..., 1, 2] = ca, -sa * cb
    H[..., 2, 1], H[..., 2, 2] = sa, ca * cb
    return H


def euler_rate_map_rate(angles: Array, rates: Array) -> Array:
    """Time derivative (..., 3, 3) of euler_rate_map at angles and their rates (..., 3)."""
    angles, rates = np.asarray(angles, dtype=np.float64), np.asarray(rates, dtype=np.float64)
    (ca, cb), (sa, sb) = (f(np.moveaxis(angles[..., :2], -1, 0)) for f in (np.cos, np.sin))
    da, db = rates[..., 0], rates[..., 1]
    out = np.zeros((*angles.shape[:-1], 3, 3))
    out[..., 0, 2] = cb * db
    out[..., 1, 1], out[..., 1, 2] = -sa * da, -ca * cb * da + sa * sb * db
    out[..., 2, 1], out[..., 2, 2] = ca * da, -sa * cb * da - ca * sb * db
    return out


def analytic_jacobian(robot: RobotModel, q: Array, X_FT: Array | None = None) -> Array:
    """Analytic Jacobian (..., 6, k): [p'; alpha' beta' gamma'] = J_a qd with X = [x y z alpha beta gamma].

    phi' = H^-1(phi) J_omega qd. Eq. (3.105) of the thesis prints H instead of its inverse: a misprint, corrected here.
    Raises ValueError where |cos beta| < 1e-9: the angles have no rates there.
    """
    J = robot.jacobian(q, X_FT)
    J[..., 3:, :] = _divide(euler_rate_map(_angles(robot, q, X_FT)), J[..., 3:, :])
    return J


def analytic_jacobian_rate(robot: RobotModel, q: Array, qd: Array, X_FT: Array | None = None) -> Array:
    """Exact time derivative (..., 6, k) of analytic_jacobian: its lower rows are H^-1 (J_omega' - H' J_phi)."""
    angles = _angles(robot, q, X_FT)
    H = euler_rate_map(angles)
    J_phi = _divide(H, robot.jacobian(q, X_FT)[..., 3:, :])
    H_rate = euler_rate_map_rate(angles, _apply(J_phi, qd))
    J_rate = robot.jacobian_rate(q, qd, X_FT)
    J_rate[..., 3:, :] = _divide(H, J_rate[..., 3:, :] - H_rate @ J_phi)
    return J_rate


def _angles(robot: RobotModel, q: Array, X_FT: Array | None) -> Array:
    R = robot.forward(q)[..., :3, :3]
    angles = xyz_from_rotation(R if X_FT is None else R @ np.asarray(X_FT, dtype=np.float64)[:3, :3])
    least = float(np.min(np.abs(np.cos(angles[..., 1]))))
    if least < _SINGULAR:
        raise ValueError(f"x-y'-z'' angles are singular: |cos beta| = {least:.3g}, at least {_SINGULAR:g} for rates")
    return angles
