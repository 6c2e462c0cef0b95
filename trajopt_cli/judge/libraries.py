"""The least times that two libraries tell: TOPP-RA along a path (toppra), from point to point (ruckig)."""

from __future__ import annotations

import logging

import numpy as np

from trajopt_cli.geometry import Array

# toppra logs every retry of its own as a warning; what came of it is in its answer
logging.getLogger("toppra").setLevel(logging.ERROR)


def shortest_time(
    s: Array, q: Array, dq: Array, speed: Array, acceleration: Array, rate_0: float, rate_1: float
) -> float | None:
    """Least time [s] along a path by TOPP-RA on the path's own points, None where it finds no timing.

    The path runs through q (n, k) at increasing path lengths s (n,) with slopes dq = dq/ds (n, k), cubic between.
    speed, acceleration (k,): limits of every column's |dq/dt| and |d2q/dt2|, infinite for none; columns may be axes or
    anything else that runs along (a length on the line). rate_0, rate_1: ds/dt at both ends.
    """
    # Pham and Pham, "A new approach to time-optimal path parameterization based on reachability analysis", T-RO 2018
    from scipy.interpolate import CubicHermiteSpline
    from toppra import algorithm, constraint
    from toppra.interpolator import AbstractGeometricPath

    class Path(AbstractGeometricPath):  # type: ignore[misc]
        """The cubic between the points; toppra's own SimplePath takes ten times as long to build."""

        spline = CubicHermiteSpline(s, q, dq)
        dof = q.shape[1]
        path_interval = np.array([s[0], s[-1]])
        waypoints = None

        def __call__(self, positions: Array, order: int = 0) -> Array:
            return np.asarray(self.spline(positions, nu=order))

    path = Path()
    wide = np.column_stack([-np.minimum(speed, 1e6), np.minimum(speed, 1e6)])
    hard = np.column_stack([-np.minimum(acceleration, 1e8), np.minimum(acceleration, 1e8)])
    limits = [
        constraint.JointVelocityConstraint(wide),
        constraint.JointAccelerationConstraint(hard, constraint.DiscretizationType.Interpolation),
    ]
    instance = algorithm.TOPPRA(limits, path, gridpoints=s, solver_wrapper="seidel")
    _, rates, _ = instance.compute_parameterization(rate_0, rate_1)
    if rates is None or not np.isfinite(rates).all() or not (rates[1:] + rates[:-1] > 0).all():
        return None
    return float(np.sum(2 * np.diff(s) / (rates[1:] + rates[:-1])))


def rest_to_rest(q_0: Array, q_1: Array, speed: Array, acceleration: Array) -> float:
    """Least time [s] of k axes from q_0 (k,) to q_1, at rest at both, under |q'| <= speed and |q''| <= acceleration.

    Jerk is free; the axes end together. Raises ValueError for limits that are not positive and finite.
    """
    from ruckig import InputParameter, Result, Ruckig, Trajectory

    if not (np.isfinite([speed, acceleration]).all() and np.min([speed, acceleration]) > 0):
        raise ValueError(f"rest to rest: limits must be positive and finite, got {speed} and {acceleration}")
    k = len(q_0)
    wish, out = InputParameter(k), Trajectory(k)
    wish.current_position, wish.target_position = list(map(float, q_0)), list(map(float, q_1))
    wish.max_velocity, wish.max_acceleration = list(map(float, speed)), list(map(float, acceleration))
    wish.max_jerk = [float("inf")] * k
    result = Ruckig(k).calculate(wish, out)
    if result not in (Result.Working, Result.Finished):
        raise ValueError(f"rest to rest: ruckig answers {result} for {q_0} to {q_1}")
    return float(out.duration)


def straight_rest_to_rest(q_0: Array, q_1: Array, speed: Array, acceleration: Array) -> float:
    """As rest_to_rest, but all axes keep to the straight line between the points: one common profile."""
    path = np.abs(np.asarray(q_1) - np.asarray(q_0))
    moves = path > 0
    if not moves.any():
        return 0.0
    v, a = float(np.min(speed[moves] / path[moves])), float(np.min(acceleration[moves] / path[moves]))
    return rest_to_rest(np.zeros(1), np.ones(1), np.array([v]), np.array([a]))
