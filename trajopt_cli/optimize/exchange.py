"""The dense check of a draft, finer than its grid, and the back-off that answers it.

Converged is not feasible: between the nodes of a grid a limit may be passed by tenths of a percent. Each leg is sampled
densely; where a ratio to a limit exceeds one, the nodes around get that limit tightened by the excess.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.draft import Margins
from trajopt_cli.optimize.legs import LegMotion, PathLeg
from trajopt_cli.optimize.tuning import AMPLE, BEYOND, DENSE, LEAST_PUSH, PUSHED, UNREACHED
from trajopt_cli.problem.problem import Leg


@dataclass(frozen=True, eq=False)
class Ratios:
    """Worst ratio to each limit per interval (N,) of a leg: velocity, acceleration, position (N, n), tool (N, 3)."""

    velocity: Array
    acceleration: Array
    position: Array
    tool: Array

    @property
    def worst(self) -> float:
        """The largest of all."""
        return float(max(np.max(x) for x in (self.velocity, self.acceleration, self.position, self.tool)))


def check_leg(axes: Axes, leg: Leg, motion: LegMotion) -> Ratios:
    """Sample every interval of a leg, both ends included from inside, and compare with the true limits."""
    breaks = motion.breaks()
    N = len(breaks) - 1
    u = np.r_[1e-9, (np.arange(DENSE) + 0.5) / DENSE, 1 - 1e-9]
    t = (breaks[:-1, None] + np.diff(breaks)[:, None] * u).ravel()
    sample = motion.sample(axes, t)
    velocity = np.abs(sample.qd) / axes.velocity_on(leg)
    acceleration = np.abs(sample.qdd) / axes.acceleration
    middle, half = (axes.upper + axes.lower) / 2, np.maximum((axes.upper - axes.lower) / 2, 1e-9)
    position = np.abs(sample.q - middle) / half
    tool = tool_ratios(axes, leg, sample.q, sample.qd, sample.qdd)

    def fold(x: Array) -> Array:
        return np.asarray(np.where(np.isnan(x), UNREACHED, x).reshape(N, len(u), -1).max(axis=1))

    return Ratios(fold(velocity), fold(acceleration), fold(position), fold(tool))


def tool_ratios(axes: Axes, leg: Leg, q: Array, qd: Array, qdd: Array) -> Array:
    """TCP speed, acceleration and reorientation (n, 3) as shares of a leg's caps."""
    J = axes.jacobian(q, leg.X_FT)
    Jd = axes.jacobian_rate(q, qd, leg.X_FT)
    V = (J @ qd[..., None])[..., 0]
    A = (J @ qdd[..., None])[..., 0] + (Jd @ qd[..., None])[..., 0]
    return np.stack(
        [
            np.linalg.norm(V[:, :3], axis=1) / leg.v_tcp,
            np.linalg.norm(A[:, :3], axis=1) / leg.a_tcp,
            np.linalg.norm(V[:, 3:], axis=1) / leg.v_ori,
        ],
        axis=1,
    )


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
        margins.push[over] = np.minimum(margins.push, pushed * share)[over]
        changed = bool(over.any())
        ratios = replace(ratios, acceleration=np.where(over[:, None], 0.0, ratios.acceleration))
    pairs = [(margins.tool, ratios.tool)]
    touching = np.where(ratios.position > 1.0, ratios.position, 0.0)  # a range may be used to its very end
    pairs += [(margins.position, touching * target)]
    if isinstance(motion, PathLeg):  # joints on a grid of their own keep their limits between nodes by construction
        pairs += [(margins.velocity, ratios.velocity), (margins.acceleration, ratios.acceleration)]
    for share, ratio in pairs:
        over = np.where(ratio > target, (target - BEYOND) / np.maximum(ratio, 1e-12), 1.0)
        if np.all(over == 1.0):
            continue
        changed = True
        share[:-1] *= over
        share[1:] *= over
    return changed
