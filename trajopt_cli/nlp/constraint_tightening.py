"""The back-off that answers the dense check: where a ratio to a limit exceeds one, the nodes around get that limit
tightened by the excess.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.settings import Settings
from trajopt_cli.trajectories.dense_check import Ratios
from trajopt_cli.trajectories.iterate import Margins
from trajopt_cli.trajectories.leg_trajectories import LegMotion, PathLeg

_PUSHED = (
    0.001  # share of its acceleration from which the rail drives the arm. Measured as _DAMPING_DWELL of transcription.
)
_AMPLE = 1.5  # times the excess taken off a dwell's push.
_LEAST_PUSH = 0.1  # share that one round leaves of a push at least.


def back_off(
    margins: Margins, ratios: Ratios, motion: LegMotion, settings: Settings, rail: Array | None = None
) -> bool:
    """Tighten the margins of the nodes beside every excess over what is safe, in place.

    Args:
        margins, ratios: of the same N intervals.
        motion: a leg on a grid.
        rail: the rail's acceleration limit (r,) [m/s2] where the tool rests for a given time. An axis that turns round
            between two nodes has its greatest acceleration there, in proportion to the rail's: then the interval's own
            push is scaled.

    Returns:
        Whether anything changed.
    """
    changed = False
    once = np.zeros((ratios.N, 1), dtype=bool)
    if rail is not None and isinstance(motion, PathLeg):
        ratio = ratios.acceleration.max(axis=1)
        pushed = np.max(np.abs(motion.b) / (rail * motion.T**2), axis=1)
        over = (ratio > settings.safe) & (pushed > _PUSHED)
        scale = np.maximum(1 - _AMPLE * (1 - (settings.safe - settings.beyond) / np.maximum(ratio, 1.0)), _LEAST_PUSH)
        once[:, 0] = over & (margins.push == 1.0)  # what is over again is so by more than the push
        margins.push[over] = np.minimum(margins.push, pushed * scale)[over]
        changed = bool(over.any())
    for limit in ratios.limits:
        margin, ratio = margins.by_name[limit.name], ratios.by_name[limit.name]
        on_grid = not isinstance(motion, PathLeg) and limit.safe_on_grid is not None
        safe = limit.safe_on_grid if on_grid and limit.safe_on_grid is not None else limit.safe
        excess = (ratio > safe) & ~(once & (limit.name == "acceleration"))
        if not excess.any():
            continue
        scale = np.where(
            excess, np.maximum((safe - settings.beyond) / np.maximum(ratio, 1e-12), settings.least_left), 1.0
        )
        changed = True
        margin[:-1] *= scale
        margin[1:] *= scale
    return changed
