"""A duration no dosed sequence can go below: how far the arm itself has to travel, and how fast the bound lets it.

When the equilibrium is at waypoint X_i the arm is within b of it, at p_i = X_i + b xi_i with ||xi_i|| <= 1 (the first
exactly at it, at rest). Along the chord n of a leg the arm gains at most c(n) a second, because its speed is a
weighted sum of past deviations: c(n) = b/h sum_j ||W_j n||, W_j the law's weights on the deviation j periods ago. So a
leg takes at least n (p_i+1 - p_i) / c(n). Summed over the legs by parts, a corner with mu = n/c before and mu' after
gives back at most b ||mu - mu'||. It holds for every sequence with a row at each waypoint, corners cut or not.

The same holds of the three angles with their own bound, and of a sum in which each leg is counted by one of the two.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.compliance.controller.dose_path import DosePath
from trajopt_cli.compliance.controller.dose_walk import SLIVER, moving_axes
from trajopt_cli.compliance.controller.regulator import Coefficients
from trajopt_cli.geometry import Array

_TAIL = 1e-15  # weights are summed until what is left is below this share of the sum
_MANY = 1_000_000  # weights at most; fewer than needed would make the bound too high


@dataclass(frozen=True, eq=False)
class _Measure:
    """Three of the six coordinates (part) whose lag is bounded, and the weights (rows, 3) of their laws."""

    part: slice
    bound: float
    weights: Array


def least_duration(
    path: DosePath, h: float, axes: Sequence[Coefficients], bound: float, turn_bound: float | None = None
) -> float:
    """Lower bound [s] of the duration of any sequence along path with ||p_e - p|| <= bound [m] at every row.

    h [s] the period, axes the coefficients of the controller's law for the six coordinates. Dwells and the caps on
    ds/dt are counted; so is turn_bound [rad] on the angles where one is given.
    """
    moves = moving_axes(path)
    measures = []
    for part, allowed in ((slice(0, 3), bound), (slice(3, 6), turn_bound)):
        if allowed is not None and any(moves[part]):
            weights = _weights(axes[part], moves[part])
            if weights is not None:
                measures.append(_Measure(part, allowed, weights))
    own = _own(path)
    choices = [[measure] for measure in measures] + ([measures] if len(measures) > 1 else [])
    bounds = [_total(path, h, own, choice) for choice in choices]
    # a walk may be faster than its caps by so much
    return max([float(np.sum(own)), *bounds]) * (1 - SLIVER)


def _own(path: DosePath) -> Array:
    """Time [s] of every leg at its caps, or of its dwell."""
    times = np.diff(path.s) / path.cap
    return np.array([leg.dwell + float(np.sum(times[leg.first : leg.last])) for leg in path.legs])


def _total(path: DosePath, h: float, own: Array, measures: Sequence[_Measure]) -> float:
    """The bound in which every leg is counted by the measure that asks most of it, or by its own time."""
    push = [np.zeros(3) for _ in measures]  # mu of the leg before
    total = 0.0
    for i, leg in enumerate(path.legs):
        # Any of a leg's bounds may stand in the sum; a lag's only where it beats the caps with both ends.
        most, chosen, asked = float(own[i]), float(own[i]), (-1, np.zeros(3))
        for which, measure in enumerate(measures):
            chord = path.pose[leg.last, measure.part] - path.pose[leg.first, measure.part]
            length = float(np.linalg.norm(chord))
            if length == 0:
                continue
            n = chord / length
            pace = measure.bound / h * float(np.sum(np.linalg.norm(measure.weights * n, axis=1)))
            if (length - 2 * measure.bound) / pace > most:
                most = (length - 2 * measure.bound) / pace
                chosen, asked = length / pace, (which, n / pace)
        total += chosen
        for which, measure in enumerate(measures):
            mu = asked[1] if which == asked[0] else np.zeros(3)
            if i > 0:  # the arm starts exactly at the first waypoint
                total -= measure.bound * float(np.linalg.norm(push[which] - mu))
            push[which] = mu
    return total - sum(measure.bound * float(np.linalg.norm(mu)) for measure, mu in zip(measures, push, strict=True))


def _weights(axes: Sequence[Coefficients], moves: Sequence[bool]) -> Array | None:
    """Step of the position by the deviation x_e - x of j periods ago, (rows, 3); None where the sum has no end.

    v' = a v - b u and x' - x = p v - q u for u = x_e - x. Zero for an axis along which nothing moves.
    """
    used = {i: (a, b, p, q) for i, ((a, b, _, p, q, _), there) in enumerate(zip(axes, moves, strict=True)) if there}
    slowest = max(abs(a) for a, _, _, _ in used.values())
    if slowest >= 1:  # no damping: the speed under a held deviation grows without end
        return None
    rows = 2 if slowest == 0 else 2 + int(np.ceil(np.log(_TAIL) / np.log(slowest)))
    if rows > _MANY:
        return None
    powers = np.arange(rows - 1)
    weights = np.zeros((rows, 3))
    for i, (a, b, p, q) in used.items():
        weights[0, i] = -q
        weights[1:, i] = p * -b * np.power(a, powers)
    # What the cut-off tail could add at most, so that the bound stays one.
    weights[-1] += np.abs(weights[-1]) * slowest / (1 - slowest)
    return weights
