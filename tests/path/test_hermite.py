"""The natural spline and the quintic against scipy's."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BPoly, CubicSpline

from trajopt_cli.path.hermite import natural_spline, quintic


@pytest.mark.parametrize("n", [2, 3, 4, 30])
def test_the_natural_spline_is_that_of_scipy(n: int) -> None:
    rng = np.random.default_rng(n)
    x, y = np.cumsum(rng.uniform(0.01, 0.2, n)), rng.normal(size=n)
    at = np.sort(np.r_[x, rng.uniform(x[0], x[-1], 50)])
    wanted = CubicSpline(x, y, bc_type="natural")(at)
    np.testing.assert_allclose(natural_spline(x, y, at), wanted, rtol=0, atol=1e-12)


def test_the_quintic_is_that_of_scipy() -> None:
    ends, u = np.random.default_rng(1).normal(size=(2, 3, 4)), np.linspace(0, 1, 21)
    wanted = BPoly.from_derivatives([0, 1], ends)
    for order, found in enumerate(quintic(*ends[0], *ends[1], u[:, None])):
        np.testing.assert_allclose(found, wanted(u, nu=order), atol=1e-11)
