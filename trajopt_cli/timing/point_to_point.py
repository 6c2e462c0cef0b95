"""ruckig: the shortest time from rest to rest between two points, every axis on its own."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array


def rest_to_rest(q_0: Array, q_1: Array, speed: Array, acceleration: Array) -> float:
    """Least time [s] of k axes from q_0 (k,) to q_1, at rest at both, under |q'| <= speed and |q''| <= acceleration.

    Jerk is free; the axes end together. Raises ValueError for limits that are not positive and finite.
    """
    from ruckig import InputParameter, Result, Ruckig, Trajectory

    if not (np.all(np.isfinite([speed, acceleration])) and np.min([speed, acceleration]) > 0):
        raise ValueError(f"rest_to_rest: limits must be positive and finite, got {speed} and {acceleration}")
    k = len(q_0)
    wish = InputParameter(k)
    wish.current_position, wish.target_position = list(map(float, q_0)), list(map(float, q_1))
    wish.current_velocity = wish.target_velocity = [0.0] * k
    wish.current_acceleration = wish.target_acceleration = [0.0] * k
    wish.max_velocity, wish.max_acceleration = list(map(float, speed)), list(map(float, acceleration))
    wish.max_jerk = [float("inf")] * k
    out = Trajectory(k)
    result = Ruckig(k).calculate(wish, out)
    if result not in (Result.Working, Result.Finished):
        raise ValueError(f"rest_to_rest: ruckig answers {result} for {q_0} to {q_1}")
    return float(out.duration)


def straight_rest_to_rest(q_0: Array, q_1: Array, speed: Array, acceleration: Array) -> float:
    """As rest_to_rest, but all axes keep to the straight line between the points: one common profile."""
    way = np.abs(np.asarray(q_1) - np.asarray(q_0))
    moves = way > 0
    if not moves.any():
        return 0.0
    v, a = float(np.min(speed[moves] / way[moves])), float(np.min(acceleration[moves] / way[moves]))
    return rest_to_rest(np.zeros(1), np.ones(1), np.array([v]), np.array([a]))
