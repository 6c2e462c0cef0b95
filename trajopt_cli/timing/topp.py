"""TOPP-RA: time-optimal timing of given paths for limits that hold at rest, compiled.

Pham and Pham, "A new approach to time-optimal path parameterization based on reachability analysis", T-RO 2018. With
x = (ds/dt)^2 at the points and u = d2s/dt2 on the intervals, x_{i+1} = x_i + 2 h u, every limit is a row
|p x_{i+1} + r x_i| <= 1. Limits from -1 to 1 hold a pair (x_i, x_{i+1}) as well as its negative; so the rows leave
x_i <= f(x_{i+1}) and x_i >= -f(-x_{i+1}), f(y) = min over rows of (1 - sign(r) p y) / |r|, which is concave. One linear
program per interval, where f is greatest, does not depend on the recursion; the rest is a minimum over rows at a point.
Rows |p y + r x + g| <= 1 with |g| < 1, as gravity makes of torque limits, leave more room on one side: intercepts
1 - g and 1 + g for 1. The loops are in topp_loops.py.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.native.loops import loops


@dataclass(frozen=True, eq=False)
class TimeLaw:
    """How a path is run: s (n,) and ds/dt there, rates (n,); d2s/dt2 is constant between the points."""

    s: Array
    rates: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "s", readonly(self.s))
        object.__setattr__(self, "rates", readonly(self.rates))

    @cached_property
    def times(self) -> Array:
        """When each point is passed (n,) [s], the first at 0."""
        return readonly(np.r_[0.0, np.cumsum(2 * np.diff(self.s) / (self.rates[1:] + self.rates[:-1]))])

    @property
    def duration(self) -> float:
        """Time from the first point to the last [s]."""
        return float(self.times[-1])

    def slowed(self, factor: float) -> TimeLaw:
        """The same path run in `factor` times the time."""
        return TimeLaw(self.s, self.rates / factor)

    def at(self, times: Array) -> tuple[Array, Array, Array]:
        """s, ds/dt and d2s/dt2 (m,) at times (m,); at a point the last is that of the interval which begins there."""
        t = np.clip(times, 0.0, self.duration)
        i = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, len(self.s) - 2)
        dt, bend = t - self.times[i], np.diff(self.rates**2) / (2 * np.diff(self.s))
        s = self.s[i] + dt * (self.rates[i] + bend[i] * dt / 2)
        return np.minimum(s, self.s[i + 1]), self.rates[i] + bend[i] * dt, bend[i]


@dataclass(frozen=True, eq=False)
class TimeLaws:
    """How B paths are run: s (B, n) and ds/dt there, rates (B, n), NaN for a path that has no timing.

    d2s/dt2 is constant between the points. durations (B,) [s]: inf where there is none or the path is at rest.
    """

    s: Array
    rates: Array
    durations: Array

    def __post_init__(self) -> None:
        for name in ("s", "rates", "durations"):
            object.__setattr__(self, name, readonly(getattr(self, name)))

    def law(self, k: int) -> TimeLaw | None:
        """The time law of path k; None where it has none."""
        return TimeLaw(self.s[k], self.rates[k]) if np.isfinite(self.durations[k]) else None


def fastest_laws(
    s: Array,
    top: Array,
    begins: tuple[Array, ...],
    ends: tuple[Array, ...],
    rate_0: Array | float,
    rate_1: Array | float,
) -> TimeLaws:
    """The time-optimal laws of B paths given by numbers alone.

    s (B, n) or (n,): each path's parameter at its points, increasing. top (B, n): the greatest ds/dt there, inf for
    none. begins, ends: slopes and bends, both (B, n-1, m), where each interval begins and where it ends: for every
    column |slope d2s/dt2 + bend (ds/dt)^2| <= 1; a column of zeros is none. A third array in both, rests of the same
    shape, says |slope d2s/dt2 + bend (ds/dt)^2 + rest| <= 1; where a rest is 1 or more the path is at rest, and rates
    at the ends must be 0 or inf. rate_0, rate_1: ds/dt at both ends, (B,)
    or one for all; inf for whatever is fastest. Paths do not influence each other: one alone has the same answer.
    Raises ValueError for shapes that differ, s that does not increase, rates below zero, and slopes or bends that are
    not finite.
    """
    top = np.asarray(top, dtype=np.float64)
    s = np.broadcast_to(np.asarray(s, dtype=np.float64), top.shape)
    rows = [np.asarray(x, dtype=np.float64) for x in (*begins[:2], *ends[:2])]
    B, n = top.shape
    for name, x in zip(("begin slopes", "begin bends", "end slopes", "end bends"), rows, strict=True):
        if x.shape != (B, n - 1, rows[0].shape[-1]) or x.shape[-1] == 0:
            raise ValueError(f"fastest laws: {name} {x.shape}, wanted ({B}, {n - 1}, {rows[0].shape[-1]})")
        if not np.isfinite(x).all():
            raise ValueError(f"fastest laws: {name} must be finite")
    if n < 2 or not (np.diff(s) > 0).all():
        raise ValueError("fastest laws: wanted two points or more and s that increases")
    none = np.broadcast_to(0.0, rows[0].shape)
    rests = [np.asarray(x[2], dtype=np.float64) if len(x) > 2 else none for x in (begins, ends)]
    rates_at_ends = [np.broadcast_to(np.asarray(rate, dtype=np.float64), (B,)) for rate in (rate_0, rate_1)]
    if not all((x >= 0).all() for x in (top, *rates_at_ends)):
        raise ValueError("fastest laws: wanted top, rate_0 and rate_1 of zero or more")
    x_0, x_1 = (rate**2 for rate in rates_at_ends)
    if len(begins) > 2 and not all(np.all((x == 0) | np.isinf(x)) for x in (x_0, x_1)):
        raise ValueError("fastest laws: with rests, wanted rate_0 and rate_1 of zero or inf")
    rates, of_rows, of_points = np.empty((B, n)), np.empty((6, 2 * rows[0].shape[-1])), np.empty((5, n))
    fill = loops("trajopt_cli.timing.topp_loops")["fill_rates"]
    fill(s, top, *rows[:2], rests[0], *rows[2:], rests[1], x_0, x_1, of_rows, of_points, rates)
    with np.errstate(divide="ignore"):
        durations = (2 * np.diff(s) / (rates[:, 1:] + rates[:, :-1])).sum(axis=1)
    durations[np.isnan(durations)] = np.inf
    return TimeLaws(s, rates, durations)
