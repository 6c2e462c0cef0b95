"""Joints along a sequence of flange poses: without jumps by whole turns, and how fast they have to turn."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_inverse import ArmAngle, inverse_branch

RELATIVE = 1e-9
"""Share of a limit by which a motion exactly on it may exceed it."""
ROUNDING = 1e-13
"""rad: what rounding in the closed-form inverse leaves in a joint's value; over h and h^2 it is no motion."""


def continuous(q: Array, near: Array) -> Array:
    """Joints (n, 7) without jumps by whole turns, the first row's turns chosen closest to near (7,)."""
    q = np.unwrap(q, axis=0)
    return np.asarray(q + 2 * np.pi * np.round((near - q[0]) / (2 * np.pi)))


def joints_along(
    robot: SrsRobot, X_WF: Array, arm_angle: Array | float, definition: ArmAngle, configuration: int, near: Array
) -> Array:
    """Joints (n, 7) of flange poses X_WF (n, 4, 4) in one configuration, continuous, from near (7,) on.

    arm_angle: one for all or (n,) [rad]. Rows out of reach are NaN, and then nothing is made continuous.
    """
    q = inverse_branch(robot, X_WF, arm_angle, definition, configuration)
    return q if np.isnan(q).any() else continuous(q, near)


def speeds(q: Array, h: float) -> Array:
    """Speeds (n - 1, k) [1/s] from each row of q (n, k) to the next, h [s] apart."""
    return np.asarray(np.abs(np.diff(q, axis=0)) / h)


def accelerations(q: Array, h: float, stops: bool = True) -> Array:
    """Accelerations (n, k) [1/s2] at the rows of q (n, k): second differences; from rest and to rest at the ends.

    Who stands at the first row and is at the second h later needs 2 |step| / h^2 at least, and so at the end. stops:
    whether the last row is an end at all; else the motion goes on and nothing is known of that row, which counts as 0.
    """
    step = np.diff(q, axis=0)
    inside = np.diff(step, axis=0)
    end = 2 * step[-1:] if stops else np.zeros_like(step[-1:])
    return np.asarray(np.abs(np.concatenate([2 * step[:1], inside, end])) / (h * h))


def central_speeds(q: Array, h: float) -> Array:
    """Signed speeds (n, k) [1/s] of q (n, k): central differences, 0 in the first and last row, where the arm rests."""
    qd = np.zeros_like(q)
    qd[1:-1] = (q[2:] - q[:-2]) / (2 * h)
    return qd


def position_excess(q: Array, limits: JointLimits) -> Array:
    """How far q (..., k) lies outside the limits, negative inside."""
    return np.asarray(np.maximum(q - limits.upper, limits.lower - q))


def passes(q: Array, h: float, limits: JointLimits) -> bool:
    """Whether rows q (n, k), h [s] apart, keep every position and speed limit: what the controller's loop stops at."""
    in_range = position_excess(q, limits) <= RELATIVE * (limits.upper - limits.lower)
    slow = speeds(q, h) <= limits.velocity * (1 + RELATIVE) + 2 * ROUNDING / h
    return bool(in_range.all() and slow.all())
