"""Lag: the deviation of eq. 6.8, the steady one in closed form, and when the arm arrives."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.iiwa.controller.lag import deviation, held, settling, turn_deviation, worst_lag
from trajopt_cli.iiwa.controller.regulator import response
from trajopt_cli.iiwa.task.equilibrium import Piece
from trajopt_cli.iiwa.task.model import Compliance

THESIS = Compliance(np.r_[[1000.0] * 3, [30.0] * 3], np.r_[[500.0] * 3, [20.0] * 3], np.r_[[25.0] * 3, [3.0] * 3])


def test_deviation_is_of_the_positions_alone_and_turn_deviation_of_the_orientations() -> None:
    x = np.array([[3.0, 0.0, 4.0, 9.0, 9.0, 9.0], [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]])
    x_e = np.array([[0.0, 0.0, 0.0, 9.0, 5.0, 6.0], [0.0, 0.0, 0.0, 0.0, 0.0, 2.0]])
    assert deviation(x, x_e) == pytest.approx([5.0, 1.0])
    turned = [Rotation.from_euler("xyz", rows[:, 3:]) for rows in (x, x_e)]
    assert turn_deviation(x, x_e) == pytest.approx((turned[0] * turned[1].inv()).magnitude())


@pytest.mark.parametrize("velocity", [[0.1, 0.0, 0.0], [0.05, -0.1, 0.02]])
def test_on_a_long_line_the_simulated_lag_is_the_steady_one(velocity: list[float]) -> None:
    stiff = Compliance(np.r_[2000.0, 1000.0, 500.0, [30.0] * 3], THESIS.D, THESIS.M)
    t = np.arange(12_000) * 1e-3
    x_e = np.zeros((len(t), 6))
    x_e[:, :3] = t[:, None] * np.array(velocity)
    d = deviation(response(x_e, 1e-3, stiff).x, x_e)
    assert d[-1] == pytest.approx(np.linalg.norm(stiff.D[:3] * velocity / stiff.K[:3]), rel=0.01)


def test_lag_says_where_the_worst_is() -> None:
    pose = np.zeros((14, 6))  # the last 3 held
    pieces = (Piece(0, 4, "a", "b"), Piece(4, 10, "b", "c"))
    x = np.zeros((14, 6))
    x[7, 1], x[3, 5] = 0.3, 0.2
    lag = worst_lag(x, pose, 0.01, pieces)
    assert (lag.maximum, lag.piece) == (pytest.approx(0.3), pieces[1])
    assert (lag.time, lag.mean) == (pytest.approx(0.07), pytest.approx(0.3 / 14))
    assert (lag.turn_maximum, lag.turn_time) == (pytest.approx(0.2), pytest.approx(0.03))
    x[4, 1] = 0.4
    assert worst_lag(x, pose, 1e-3, pieces).piece == pieces[0]
    x[13, 1] = 0.5  # after the end, where the last pose is held
    late = worst_lag(x, pose, 1e-3, pieces)
    assert (late.time, late.piece) == (pytest.approx(0.013), pieces[1])


def test_held_and_settling() -> None:
    x_e = np.arange(12.0).reshape(2, 6)
    longer = held(x_e, 0.0031, 1e-3)
    assert len(longer) == 2 + 4
    assert np.array_equal(longer[2:], np.tile(x_e[1], (4, 1)))
    assert len(held(x_e, 0.003, 1e-3)) == 2 + 3
    x = np.zeros((6, 6))
    x[:, 0] = [0.5, 0.05, 0.2, 0.05, 0.01, 0.0]
    assert settling(x, np.zeros(6), 0.1, 1.0, 0.01) == pytest.approx(0.03)
    assert settling(x[:3], np.zeros(6), 0.1, 1.0, 0.01) is None
    assert settling(x[4:], np.zeros(6), 0.1, 1.0, 0.01) == 0.0
    x[4, 3:] = [0.6, 0.0, 0.8]  # a turn of norm 1
    assert settling(x, np.zeros(6), 0.1, 1.0, 0.01) == pytest.approx(0.03)
    assert settling(x, np.zeros(6), 0.1, 0.99, 0.01) == pytest.approx(0.05)
