"""Rows of a period at another rate: a subset where that can be, else within every limit that the rows keep."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.recorded import at_rate
from trajopt_cli.iiwa.judge.joints import check_limits
from trajopt_cli.iiwa.judge.task_order import read_arm
from trajopt_cli.trajectory import Trajectory

H = 1e-3
NAMES = tuple(f"joint_{i}" for i in range(1, 8))


def from_rest_to_rest(accelerations: np.ndarray) -> Trajectory:
    """Rows of seven joints with these second differences and then the same backward, so that all rest at the end."""
    turned = np.concatenate([accelerations, -accelerations])
    step = np.concatenate([np.zeros((1, 7)), np.cumsum(turned, axis=0)]) * H * H
    q = np.concatenate([np.zeros((1, 7)), np.cumsum(step, axis=0)])
    q += np.array([0, 0.5, 0, -1.5, 0, 0.9, 0])
    qd = np.zeros_like(q)
    qd[1:-1] = (q[2:] - q[:-2]) / (2 * H)
    return Trajectory(NAMES, np.arange(len(q)) * H, q, qd)


@settings(max_examples=40, deadline=None)
@given(st.integers(1, 2**30), st.sampled_from([4000.0, 1500.0, 937.5, 10_000.0, 300.0]))
def test_between_rows_every_limit_is_kept_however_hard_the_rows_are_driven(seed: int, rate: float) -> None:
    arm, rng = read_arm("iiwa7", "default"), np.random.default_rng(seed)
    rows = from_rest_to_rest(rng.choice([-1, 0, 1], size=(40, 7)) * arm.acceleration)
    assert [found.message for found in check_limits(arm, rows, None) if not found.passed] == []
    found, note = at_rate(rows, rate)
    assert "within their limits" in note
    wrong = [one.message for one in check_limits(arm, found, None) if not one.passed and one.check != "speed column"]
    assert wrong == []
    assert found.duration == pytest.approx(rows.duration + H)
    np.testing.assert_array_equal(found.q[[0, -1]], rows.q[[0, -1]])


def test_the_curve_is_scipys_quadratic_spline() -> None:
    rng = np.random.default_rng(3)
    rows = from_rest_to_rest(rng.uniform(-5, 5, size=(20, 7)))
    found, _ = at_rate(rows, 3217.0)
    control = np.concatenate([rows.q[:1], rows.q, rows.q[-1:]])
    knots = (np.arange(len(control) + 3) - 2.0) * H  # half a period before the first row stands t = 0
    wanted = BSpline(knots, control, 2)
    np.testing.assert_allclose(found.q, wanted(found.t), rtol=0, atol=1e-14)
    assert found.qd is not None
    np.testing.assert_allclose(found.qd, wanted(found.t, 1), rtol=0, atol=1e-11)


def test_a_whole_fraction_of_the_rate_is_a_subset_and_the_end() -> None:
    rows = from_rest_to_rest(np.full((25, 7), 3.0))
    assert len(rows.t) == 52
    for rate, every in ((1000.0, 1), (500.0, 2), (250.0, 4)):
        found, note = at_rate(rows, rate)
        assert note == ""
        wanted = sorted({*range(0, 52, every), 51})
        np.testing.assert_array_equal(found.q, rows.q[wanted])
        np.testing.assert_array_equal(found.t, rows.t[wanted])
        assert found.qd is not None
        assert rows.qd is not None
        np.testing.assert_array_equal(found.qd, rows.qd[wanted])


@pytest.mark.parametrize("rate", [0.0, -1.0, 2e5, float("nan")])
def test_a_rate_that_cannot_be_is_refused(rate: float) -> None:
    with pytest.raises(InputError, match="lies outside"):
        at_rate(from_rest_to_rest(np.ones((3, 7))), rate)


def test_rows_on_no_grid_are_refused() -> None:
    rows = from_rest_to_rest(np.ones((3, 7)))
    t = np.array(rows.t)
    t[2] += 1e-4
    with pytest.raises(InputError, match="no grid of one period"):
        at_rate(Trajectory(NAMES, t, rows.q, rows.qd), 4000)
