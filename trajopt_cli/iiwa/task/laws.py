"""How a segment is shared out over periods: shares 0..1 of the way, one a period, and the cap that decides."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, inf, sqrt

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.timing.point_to_point import PointToPoint, point_to_point

WHOLE = 5e-10
"""A time this close to a whole number of periods, in periods, is one: 0.2 / 0.1 must not floor to 1."""


@dataclass(frozen=True)
class Rate:
    """A cap by its name, per length of the way: v_max / L_p [1/s], a_max / L_p [1/s2], ..."""

    name: str
    value: float


UNCAPPED = Rate("", inf)


@dataclass(frozen=True)
class FullSpeed:
    """The thesis' law: at once at full speed (eqs 4.26-4.33). periods: t_max / h; binds: the cap that decides it."""

    periods: float
    binds: str

    def shares(self, slower: bool) -> Array:
        """Shares (n,): N = floor(t_max / h) steps at full speed, what is left over halved between both ends.

        With nothing left over, N steps and no more. slower: equal steps, over up to a period more than t_max.
        """
        # twice the tolerance here, so that what counts as whole below is never floored to the number before
        whole = floor(self.periods + 2 * WHOLE)
        if slower:
            # at least a hundredth of a period slower, where t_max is whole but for rounding
            count = ceil(self.periods + 0.01)
            return np.asarray(np.arange(count + 1) / count, dtype=np.float64)
        if whole and self.periods - whole <= WHOLE:
            return np.asarray(np.arange(whole + 1) / whole, dtype=np.float64)
        begin = (1.0 - whole / self.periods) / 2
        return np.asarray(np.r_[0.0, begin + np.arange(whole + 1) / self.periods, 1.0], dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Ramps:
    """From rest to rest with ramps. periods: the least time in periods; motion: 0 to 1 in its own unit of time."""

    periods: float
    binds: str
    motion: PointToPoint

    def shares(self, slower: bool) -> Array:
        """Shares (n,) of the fastest motion, stretched evenly to whole periods; slower: to one period more."""
        # never faster than the caps by more than rounding: 3e-12 in jerk
        count = max(1, ceil(self.periods * (1 - 1e-12))) + slower
        times = np.asarray(np.arange(count + 1) * (self.motion.duration / count), dtype=np.float64)
        s = self.motion.at(times)[0][:, 0]
        s[0], s[-1] = 0.0, 1.0
        return s


def full_speed(speed: Rate, h: float) -> FullSpeed:
    """The thesis' law under a cap of speed, sampled every h [s]."""
    return FullSpeed(1.0 / (speed.value * h), speed.name)


def ramps(speed: Rate, acceleration: Rate, jerk: Rate, h: float) -> Ramps:
    """The fastest motion from rest to rest under the caps: a trapezoid or triangle of speed where jerk is UNCAPPED."""
    # in a unit of time in which the motion takes between 1 and about 10, whatever the way's length and the caps
    unit = max(1 / speed.value, 1 / sqrt(acceleration.value), jerk.value ** (-1 / 3))
    caps = [rate for rate in (speed, acceleration, jerk) if rate.value < inf]
    limits = [np.array([rate.value * unit**order]) for order, rate in enumerate(caps, start=1)]
    motion = point_to_point(np.zeros(1), np.ones(1), limits[0], limits[1], limits[2] if len(limits) > 2 else None)
    tops = (float(np.max(np.abs(x))) for x in (motion.qd, motion.qdd, motion.qddd))
    # the first cap reached decides most: a motion that cruises is as long as its speed makes it
    binds = next(
        rate.name
        for rate, limit, top in zip(caps, limits, tops, strict=False)
        if top >= limit[0] * (1 - 1e-9) or rate is caps[-1]
    )
    return Ramps(motion.duration * unit / h, binds, motion)
