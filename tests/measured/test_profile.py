"""Ramps behind a lag: against scipy stepping the same servo, and against differences."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lsim

from trajopt_cli.measured.profile import boxes, progress, slopes

PHASES = np.array([0.04, 0.1, 0.3])


@pytest.mark.parametrize("beta", [0.0, 0.1, 0.25, 0.45])
def test_the_lagged_ramp_is_what_a_simulated_servo_gives(beta: float) -> None:
    b1, step = 0.03, 2e-4
    t = np.arange(0, 1.5, step)
    ends = np.cumsum([0.04, 0.1, 0.04, 0.3, 0.04, 0.1, 0.04])
    jerk = np.select([t < end - 1e-9 for end in ends], [1.0, 0, -1, 0, -1, 0, 1], 0.0) / np.prod(boxes(PHASES))
    # behind a servo: position, speed, acceleration, then the servo's own states
    servo = ([1.0], [beta * b1**2, b1, 1.0, 0, 0, 0]) if beta else ([1.0], [b1, 1.0, 0, 0, 0])
    stepped = lsim(servo, jerk, t, interp=False)[1]
    assert np.abs(progress(t, PHASES, b1, beta) - stepped).max() < 1e-6
    assert stepped[-1] == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("beta", [0.0, 0.2, 0.4])
def test_the_slopes_are_those_of_differences(beta: float) -> None:
    t = np.linspace(-0.1, 1.2, 400)
    s, rate, by_phase = slopes(t, PHASES, 0.02, beta)
    h = 1e-6
    assert rate == pytest.approx((progress(t + h, PHASES, 0.02, beta) - s) / h, abs=1e-4)
    for k in range(3):
        moved = PHASES + h * (np.arange(3) == k)
        assert by_phase[:, k] == pytest.approx((progress(t, moved, 0.02, beta) - s) / h, abs=1e-3)


def test_boxes_are_the_way_over_each_limit() -> None:
    v, a, j = 2.0, 10.0, 200.0  # a way of 3: 0.05 s of jerk, 0.15 s at 10, 1.3 s at 2
    assert boxes(np.array([a / j, v / a - a / j, 3 / v - v / a - a / j])) == pytest.approx([3 / v, v / a, a / j])
