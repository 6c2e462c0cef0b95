"""One path timed by the library toppra, against which the batch is held."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.timing.topp import TimeLaw


def fastest_law(
    s: Array,
    top: Array,
    begins: tuple[Array, ...],
    ends: tuple[Array, ...],
    rate_0: float,
    rate_1: float,
) -> TimeLaw | None:
    """The same of one path by the library toppra; None where it finds none."""
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
            xbound = np.column_stack([np.zeros(n), np.minimum(top, 1e6) ** 2])
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
