"""How a path given by numbers is run, and toppra's fastest way to run it."""

from __future__ import annotations

import logging
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, readonly

# toppra logs every retry of its own as a warning; what came of it is in its answer
logging.getLogger("toppra").setLevel(logging.ERROR)

_UNBOUND = 1e6  # ds/dt that stands for none; toppra wants finite numbers


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


def fastest_law(
    s: Array,
    top: Array,
    begins: tuple[Array, ...],
    ends: tuple[Array, ...],
    rate_0: float,
    rate_1: float,
) -> TimeLaw | None:
    """The fastest way by TOPP-RA to run a path given by numbers alone; None where it finds none.

    s (n,): the path's parameter at its points. top (n,): the greatest ds/dt there. begins, ends: slopes and bends, both
    (n-1, m), where each interval begins and where it ends: for every column |slope d2s/dt2 + bend (ds/dt)^2| <= 1. The
    two sides of a point may differ, for paths whose curvature jumps there. A third array in both, rests, says |slope
    d2s/dt2 + bend (ds/dt)^2 + rest| <= 1. rate_0, rate_1: ds/dt at both ends.
    """
    from toppra import algorithm, constraint
    from toppra.interpolator import AbstractGeometricPath

    n, m = len(s), begins[0].shape[1]

    class Span(AbstractGeometricPath):  # type: ignore[misc]
        """All that TOPP-RA needs to know of the path itself."""

        dof = m
        path_interval = np.array([s[0], s[-1]])
        waypoints = None

    class Given(constraint.LinearConstraint):  # type: ignore[misc]
        """The columns at both ends of every interval, by toppra's Interpolation scheme."""

        identical = True

        def __init__(self) -> None:
            super().__init__()
            self.identical = True

        def compute_constraint_params(self, path: AbstractGeometricPath, gridpoints: Array) -> tuple[Array | None, ...]:
            """a, b, c, F, g, no bound on u, and the bound on x = (ds/dt)^2."""
            step = np.diff(gridpoints)[:, None]
            a = np.hstack([begins[0], ends[0] + 2 * step * ends[1]])
            b = np.hstack([begins[1], ends[1]])
            last = np.hstack([ends[0][-1:], ends[0][-1:]]), np.hstack([ends[1][-1:], ends[1][-1:]])
            a, b = np.vstack([a, last[0]]), np.vstack([b, last[1]])
            F = np.vstack([np.eye(2 * m), -np.eye(2 * m)])
            xbound = np.column_stack([np.zeros(n), np.minimum(top, _UNBOUND) ** 2])
            c = np.zeros_like(a)
            if len(begins) > 2:
                c[:-1] = np.hstack([begins[2], ends[2]])
                c[-1] = np.tile(ends[2][-1], 2)
            return a, b, c, F, np.ones(4 * m), None, xbound

    instance = algorithm.TOPPRA([Given()], Span(), gridpoints=s, solver_wrapper="seidel")
    _, rates, _ = instance.compute_parameterization(rate_0, rate_1)
    if rates is None or not np.isfinite(rates).all() or np.any(rates[1:] + rates[:-1] <= 0):
        return None
    return TimeLaw(s, rates)
