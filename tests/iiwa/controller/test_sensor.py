"""The torque sensors' errors: their size, their frequencies, and the same numbers every time."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.iiwa.controller.forces import TorqueErrors
from trajopt_cli.iiwa.task.model import Sensor

H = 1e-3
RANGES = np.array([176.0, 176, 110, 110, 110, 40, 40])


def test_the_bias_is_drawn_within_its_share_of_every_range() -> None:
    draws = np.array([TorqueErrors(Sensor(0.02, (), seed=seed), RANGES, H).at(0) for seed in range(400)])
    assert np.all(np.abs(draws) <= 0.02 * RANGES)
    # evenly: both signs, the mean square a third of the bound's
    assert np.mean(draws**2, axis=0) == pytest.approx((0.02 * RANGES) ** 2 / 3, rel=0.2)
    assert np.abs(draws.mean(axis=0) / (0.02 * RANGES)).max() < 0.12


def test_the_ripple_is_two_lines_of_the_spectrum() -> None:
    """One second at 1 kHz puts 8 and 17 Hz on bins of their own: amplitudes 0.3 and 0.2 Nm, nothing else."""
    errors = TorqueErrors(Sensor(), RANGES, H).at(np.arange(1000))
    lines = np.abs(np.fft.rfft(errors, axis=0)) / 500
    assert lines[8] == pytest.approx(np.full(7, 0.3), abs=1e-9)
    assert lines[17] == pytest.approx(np.full(7, 0.2), abs=1e-9)
    assert np.abs(np.delete(lines[1:], [7, 16], axis=0)).max() < 1e-9
    assert lines[0] / 2 == pytest.approx(np.abs(TorqueErrors(Sensor(ripple=()), RANGES, H).at(3)), abs=1e-9)
    phases = np.angle(np.fft.rfft(errors, axis=0)[8])
    assert len(np.unique(phases.round(6))) == 7


def test_rows_are_the_single_periods_and_the_seed_decides() -> None:
    sensor = Sensor(seed=5)
    errors = TorqueErrors(sensor, RANGES, H)
    assert errors.at(np.arange(40)) == pytest.approx(
        np.array([TorqueErrors(sensor, RANGES, H).at(k) for k in range(40)])
    )
    assert np.all(errors.at(0) != TorqueErrors(Sensor(seed=6), RANGES, H).at(0))


def test_wrong_ranges_are_refused() -> None:
    with pytest.raises(ValueError, match=r"ranges has shape \(6,\), wanted \(7,\)"):
        TorqueErrors(Sensor(), np.ones(6), H)
