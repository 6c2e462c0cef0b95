"""The back-off that answers the dense check: where a ratio to a limit exceeds one, the nodes around get that limit
tightened by the excess.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.settings import AMPLE, BEYOND, LEAST_LEFT, LEAST_PUSH, PUSHED, RANGE_ROUNDING, SAFE_JERK
from trajopt_cli.trajectories.dense_check import Ratios
from trajopt_cli.trajectories.iterate import Margins
from trajopt_cli.trajectories.leg_trajectories import LegMotion, PathLeg


def back_off(margins: Margins, ratios: Ratios, motion: LegMotion, target: float, rail: Array | None = None) -> bool:
    """Scale the shares of the nodes next to an excess over target; True when anything changed.

    rail (r,): the rail's acceleration limit [m/s2] where the tool rests for a given time. An axis that turns round
    between two nodes has its greatest acceleration there, in proportion to the rail's: then the interval's own push is
    scaled.
    """
    changed = False
    if rail is not None and isinstance(motion, PathLeg):
        ratio = ratios.acceleration.max(axis=1)
        pushed = np.max(np.abs(motion.b) / (rail * motion.T**2), axis=1)
        over = (ratio > target) & (pushed > PUSHED)
        share = np.maximum(1 - AMPLE * (1 - (target - BEYOND) / np.maximum(ratio, 1.0)), LEAST_PUSH)
        once = over & (margins.push == 1.0)  # what is over again is so by more than the push
        margins.push[over] = np.minimum(margins.push, pushed * share)[over]
        changed = bool(over.any())
        ratios = replace(ratios, acceleration=np.where(once[:, None], 0.0, ratios.acceleration))
    pairs = [(margins.tool, ratios.tool), (margins.torque, ratios.torque)]
    touching = np.where(
        ratios.position > 1.0 + RANGE_ROUNDING, ratios.position, 0.0
    )  # a range may be used to its very end
    pairs += [(margins.position, touching * target)]
    if isinstance(motion, PathLeg):  # joints on a grid of their own keep their limits between nodes by construction
        pairs += [(margins.velocity, ratios.velocity), (margins.acceleration, ratios.acceleration)]
        jerks = np.where(ratios.jerk > SAFE_JERK, ratios.jerk / SAFE_JERK, 0.0)
        pairs += [(margins.jerk, jerks * target)]
    else:  # but for the velocity where the acceleration is not constant between them
        pairs.append((margins.velocity, np.where(ratios.velocity > 1.0, ratios.velocity, 0.0) * target))
    for share, ratio in pairs:
        over = np.where(ratio > target, np.maximum((target - BEYOND) / np.maximum(ratio, 1e-12), LEAST_LEFT), 1.0)
        if np.all(over == 1.0):
            continue
        changed = True
        share[:-1] *= over
        share[1:] *= over
    return changed
