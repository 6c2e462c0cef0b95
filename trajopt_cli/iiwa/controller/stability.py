"""Whether the controller's law settles, axis by axis, from its discrete poles.

Forward Euler (eq. 4.13) has the characteristic polynomial z^2 - (2 - h d/m) z + 1 - h d/m + h^2 k/m. Both poles are
inside the unit circle iff k > 0, h k < d and h d/m < 2 + h^2 k/(2 m) (Jury). "Stable for k, d, m > 0", as the thesis
says, is the continuous law's; the exact discretisation keeps it.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass
from enum import IntEnum
from math import inf, log, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import COORDINATES, Compliance, Integration


class StabilityVerdict(IntEnum):
    """Poles inside the unit circle; simple poles on it (stays where it is put, or oscillates forever); beyond it."""

    UNSTABLE = 0
    MARGINAL = 1
    STABLE = 2


@dataclass(frozen=True)
class AxisStability:
    """One axis. h_max [s]: the verdict is lost from this period on, inf for the exact law.

    damping_ratio: of the continuous law, below 1 it overshoots, inf at k = 0. slowest [s]: the longest time constant,
    after which e^-1 of a deviation is left (at k = 0: of a speed); inf where nothing dies out. sentence: what to know.
    since [s]: when the law begins to hold.
    """

    axis: str
    k: float
    d: float
    m: float
    verdict: StabilityVerdict
    h_max: float
    damping_ratio: float
    slowest: float
    sentence: str
    since: float = 0.0


def stability(
    compliance: Compliance, h: float, integration: Integration = Integration.EULER
) -> tuple[AxisStability, ...]:
    """The six axes of a controller with period h [s]."""
    return tuple(
        _axis(axis, float(k), float(d), float(m), h, integration)
        for axis, k, d, m in zip(COORDINATES, compliance.K, compliance.D, compliance.M, strict=True)
    )


def stability_map(
    k: ArrayLike, d: ArrayLike, m: float, h: float, integration: Integration = Integration.EULER
) -> NDArray[np.int8]:
    """Verdicts (a, b) as their numbers, for stiffnesses k (a,) and dampings d (b,) of an inertia m and a period h [s].

    Units as in Compliance; k = d = 0 is unstable: nothing would stop a motion.
    """
    stiffness = np.asarray(k, dtype=np.float64)[:, None]
    damping = np.asarray(d, dtype=np.float64)[None, :]
    return _verdicts(stiffness, damping, m, h, integration)


def poles(k: float, d: float, m: float, h: float, integration: Integration) -> tuple[complex, complex]:
    """The two poles of one period; those of a pair are each other's conjugates, or both real, the larger first."""
    root = cmath.sqrt(d * d - 4 * k * m)
    # the smaller root by the product of both: their difference would lose it where k m is small beside d^2
    fast = -(d + root) / (2 * m)
    slow = -2 * k / (d + root) if d + root != 0 else fast
    if integration is Integration.EULER:
        return 1 + h * slow, 1 + h * fast
    return cmath.exp(h * slow), cmath.exp(h * fast)


def largest_period(k: float, d: float, m: float, integration: Integration = Integration.EULER) -> float:
    """The period [s] from which on the law no longer settles (at k = 0: keeps no place); 0 for d = 0, inf if none."""
    if integration is Integration.EXACT:
        return inf
    if d * d < 4 * k * m:
        return d / k
    return 4 * m / (d + sqrt(d * d - 4 * k * m))


def _verdicts(k: Array, d: Array, m: float, h: float, integration: Integration) -> NDArray[np.int8]:
    settles, swings = (k > 0) & (d > 0), (k > 0) | (d > 0)
    if integration is Integration.EULER:
        pull = d - h * k
        brake = 2 + h * h * k / (2 * m) - h * d / m
        settles = (k > 0) & (pull > 0) & (brake > 0)
        # on the circle: both bounds reached at once is a double pole, as is pull = 0 at k = 0
        swings = (pull >= 0) & (brake >= 0) & ~((pull == 0) & ((brake == 0) | (k == 0)))
    verdicts = np.where(
        settles, StabilityVerdict.STABLE, np.where(swings, StabilityVerdict.MARGINAL, StabilityVerdict.UNSTABLE)
    )
    return verdicts.astype(np.int8)


def _axis(axis: str, k: float, d: float, m: float, h: float, integration: Integration) -> AxisStability:
    verdict = StabilityVerdict(int(_verdicts(np.array(k), np.array(d), m, h, integration)))
    both = poles(k, d, m, h, integration)
    size = max(abs(z) for z in (both[1:] if k == 0 else both))
    slowest = inf
    if (verdict is StabilityVerdict.STABLE or k == 0) and size < 1:
        slowest = -h / log(size) if size > 0 else 0.0
    longest, ratio = largest_period(k, d, m, integration), d / (2 * sqrt(k * m)) if k > 0 else inf
    sentence = _sentence(axis, k, d, m, h, integration, verdict)
    return AxisStability(axis, k, d, m, verdict, longest, ratio, slowest, sentence)


def _sentence(
    axis: str, k: float, d: float, m: float, h: float, integration: Integration, verdict: StabilityVerdict
) -> str:
    turn = axis in COORDINATES[3:]
    stiffness, damping = ("Nm/rad", "N m s/rad") if turn else ("N/m", "N s/m")
    inertia = "kg m2" if turn else "kg"
    if verdict is StabilityVerdict.STABLE:
        return f"{axis} settles"
    if k == 0 and verdict is StabilityVerdict.MARGINAL:
        return f"{axis} has k = 0: it stays where it is put (hand guiding)"
    if integration is Integration.EXACT:
        return f"{axis} has d = 0 with k = {k:g} {stiffness}: it oscillates forever; give it some damping"
    word = "oscillates forever" if verdict is StabilityVerdict.MARGINAL else "is unstable"
    period = f"h = {1e3 * h:g} ms"
    if d <= h * k:
        return (
            f"{axis} {word}: d = {d:g} {damping} must be above h k = {h * k:g} {damping} "
            f"(k = {k:g} {stiffness}, {period}); raise d, lower k or h, or use the exact discretisation"
        )
    bound = 2 * m / h + h * k / 2
    return (
        f"{axis} {word}: d = {d:g} {damping} must be below 2 m/h + h k/2 = {bound:g} {damping} "
        f"(m = {m:g} {inertia}, {period}); lower d, raise m, lower h, or use the exact discretisation"
    )
