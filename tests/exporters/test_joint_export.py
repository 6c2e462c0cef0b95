"""Resampling: positions are the motion's own, the end is exact, bad rates are named."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicHermiteSpline

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.joint import resample
from trajopt_cli.trajectory import Trajectory

KNOTS = np.array([0.0, 0.3, 0.7, 1.2345678])


def cubic(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """One cubic for all time: a Hermite interpolant of its values and slopes is the cubic itself."""
    q = np.stack([t**3 - t, 2 * t**2 + 0.5], axis=1)
    return q, np.stack([3 * t**2 - 1, 4 * t], axis=1)


def test_rows_lie_on_the_motion_and_the_end_is_exact() -> None:
    trajectory = Trajectory(("rail", "joint_1"), KNOTS, *cubic(KNOTS))
    out = resample(trajectory, 100)
    np.testing.assert_allclose(out.t[:-1], np.arange(124) / 100, rtol=0, atol=1e-15)
    assert out.t[-1] == KNOTS[-1]
    assert out.qd is not None
    q, qd = cubic(out.t)
    np.testing.assert_allclose(out.q, q, rtol=0, atol=1e-14)
    np.testing.assert_allclose(out.qd, qd, rtol=0, atol=1e-13)
    assert (out.q[-1] == trajectory.q[-1]).all()


def test_rows_agree_with_scipys_hermite_spline() -> None:
    rng = np.random.default_rng(7)
    t = np.cumsum(rng.uniform(0.01, 0.2, 30))
    q, qd = rng.normal(size=(2, 30, 3))
    out = resample(Trajectory(("a", "b", "c"), t, q, qd), 1000)
    spline = CubicHermiteSpline(t, q, qd)
    np.testing.assert_allclose(out.q, spline(out.t), rtol=0, atol=1e-12)
    assert out.qd is not None
    np.testing.assert_allclose(out.qd, spline(out.t, 1), rtol=0, atol=1e-10)


@settings(deadline=None)
@given(st.floats(0.011, 20.0), st.floats(1.0, 5000.0), st.floats(-3.0, 3.0))
def test_first_and_last_row_stand_and_no_interval_is_under_the_promised_one(
    duration: float, rate: float, start: float
) -> None:
    t = np.array([start, start + duration])
    trajectory = Trajectory(("a",), t, np.array([[0.0], [1.0]]), np.zeros((2, 1)))
    out = resample(trajectory, rate)
    assert out.t[0] == t[0]
    assert out.t[-1] == t[-1]
    steps = np.diff(out.t)
    assert steps.min() > 0.99e-5
    assert steps.max() < 1 / rate + 1.01e-5


@pytest.mark.parametrize("rate", [0.0, 0.99, -1.0, 1.1e5, float("nan"), float("inf")])
def test_bad_rates_are_named(rate: float) -> None:
    trajectory = Trajectory(("rail", "joint_1"), KNOTS, *cubic(KNOTS))
    with pytest.raises(InputError) as caught:
        resample(trajectory, rate)
    assert str(caught.value) == f"rate {rate:g} Hz lies outside [1, 100000] Hz; 1000 suits most controllers"


def test_more_rows_than_anybody_reads_are_refused_before_they_are_made() -> None:
    day = Trajectory(("a",), np.array([0.0, 86400.0]), np.zeros((2, 1)), np.zeros((2, 1)))
    with pytest.raises(InputError, match=r"^86400 s at 1000 Hz are 86400000 rows, at most 5000000: give .* 57.8 Hz"):
        resample(day, 1000)
    assert len(resample(day, 1).t) == 86401


def test_a_trajectory_without_speeds_is_refused() -> None:
    trajectory = Trajectory(("rail", "joint_1"), KNOTS, cubic(KNOTS)[0])
    with pytest.raises(InputError, match="the trajectory has no speed columns; resampling needs them"):
        resample(trajectory, 100)
