"""A duration no dosed sequence can go below: how far the arm itself has to travel, and how fast the bound lets it.

When the equilibrium is at waypoint X_i the arm is within b of it, at p_i = X_i + b xi_i with ||xi_i|| <= 1 (the first
exactly at it, at rest). Along the chord n of a leg the arm gains at most c(n) a second, because its speed is a
weighted sum of past deviations: c(n) = b/h sum_j ||W_j n||, W_j the law's weights on the deviation j periods ago. So a
leg takes at least n (p_i+1 - p_i) / c(n). Summed over the legs by parts, a corner with mu = n/c before and mu' after
gives back at most b ||mu - mu'||. It holds for every sequence with a row at each waypoint, corners cut or not.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajopt_cli.admittance.dose_path import DosePath
from trajopt_cli.admittance.regulator import Coefficients
from trajopt_cli.geometry import Array

_TAIL = 1e-15  # weights are summed until what is left is below this share of the sum
_MANY = 1_000_000  # weights at most; fewer than needed would make the bound too high


def least_duration(path: DosePath, h: float, axes: Sequence[Coefficients], bound: float) -> float:
    """Lower bound [s] of the duration of any sequence along path with ||p_e - p|| <= bound [m] at every row.

    h [s] the period, axes the coefficients of the controller's law. Dwells and the caps on ds/dt are counted.
    """
    weights = _weights(axes[:3])
    times = np.diff(path.s) / path.cap
    total, spent = 0.0, 0.0
    push = np.zeros(3)  # mu of the leg before
    for i, leg in enumerate(path.legs):
        own = leg.dwell + float(np.sum(times[leg.first : leg.last]))
        chord = path.pose[leg.last, :3] - path.pose[leg.first, :3]
        length = float(np.linalg.norm(chord))
        mu = np.zeros(3)
        if weights is not None and length > 0:
            n = chord / length
            pace = bound / h * float(np.sum(np.linalg.norm(weights * n, axis=1)))
            # Either of a leg's two bounds may stand in the sum; the lag's only where it beats the caps with both ends.
            if (length - 2 * bound) / pace > own:
                mu = n / pace
        total += length * float(np.linalg.norm(mu)) if np.any(mu) else own
        if i > 0:  # the arm starts exactly at the first waypoint
            total -= bound * float(np.linalg.norm(push - mu))
        push = mu
        spent += own
    return max(spent, total - bound * float(np.linalg.norm(push)))


def _weights(axes: Sequence[Coefficients]) -> Array | None:
    """Step of the position by the deviation x_e - x of j periods ago, (rows, 3); None where the sum has no end.

    v' = a v - b u and x' - x = p v - q u for u = x_e - x.
    """
    out = []
    for a, b, _, p, q, _ in axes:
        if abs(a) >= 1:  # no damping: the speed under a held deviation grows without end
            return None
        out.append((a, b, p, q))
    slowest = max(abs(a) for a, _, _, _ in out)
    rows = 2 if slowest == 0 else 2 + int(np.ceil(np.log(_TAIL) / np.log(slowest)))
    if rows > _MANY:
        return None
    powers = np.arange(rows - 1)
    weights = np.empty((rows, 3))
    for i, (a, b, p, q) in enumerate(out):
        weights[0, i] = -q
        weights[1:, i] = p * -b * np.power(a, powers)
    # What the cut-off tail could add at most, so that the bound stays one.
    weights[-1] += np.abs(weights[-1]) * max(abs(a) / (1 - abs(a)) for a, _, _, _ in out)
    return weights
