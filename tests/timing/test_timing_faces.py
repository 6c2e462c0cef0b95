"""toppra and ruckig against closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from ruckig import InputParameter, Ruckig, Synchronization, Trajectory

from trajopt_cli.judge.libraries import rest_to_rest, shortest_time, straight_rest_to_rest
from trajopt_cli.timing.point_to_point import point_to_point


def trapezoid_time(way: float, v: float, a: float) -> float:
    return way / v + v / a if way > v * v / a else 2 * np.sqrt(way / a)


@pytest.mark.parametrize(("way", "v", "a"), [(1.0, 0.5, 2.0), (0.1, 0.5, 2.0), (-2.0, 1.0, 3.0)])
def test_ruckig_is_the_trapezoid(way: float, v: float, a: float) -> None:
    time = rest_to_rest(np.zeros(1), np.array([way]), np.array([v]), np.array([a]))
    assert time == pytest.approx(trapezoid_time(abs(way), v, a), rel=1e-12)


def test_the_slowest_axis_decides_and_a_straight_line_takes_longer() -> None:
    q_0, q_1 = np.zeros(2), np.array([1.0, 0.2])
    v, a = np.array([1.0, 1.0]), np.array([8.0, 1.0])
    alone = [trapezoid_time(w, s, b) for w, s, b in zip(q_1, v, a, strict=True)]
    assert rest_to_rest(q_0, q_1, v, a) == pytest.approx(max(alone), rel=1e-12)
    # on the line the share is held by axis 0's speed and by axis 1's acceleration
    assert straight_rest_to_rest(q_0, q_1, v, a) == pytest.approx(trapezoid_time(1.0, 1.0, 5.0), rel=1e-12)
    assert straight_rest_to_rest(q_0, q_0, v, a) == 0.0


def test_limits_that_are_none_are_refused() -> None:
    with pytest.raises(ValueError, match="limits must be positive and finite"):
        rest_to_rest(np.zeros(1), np.ones(1), np.array([np.inf]), np.array([1.0]))


@pytest.mark.parametrize(("rate_0", "rate_1"), [(0.0, 0.0), (0.3, 0.0), (0.3, 0.4)])
def test_toppra_on_a_straight_path_is_the_trapezoid(rate_0: float, rate_1: float) -> None:
    """A line in two axes: the share's limits, speeds at the ends given. T = v/a ramps and the rest at v."""
    s = np.linspace(0, 1, 301)
    slope = np.array([1.0, -0.5])
    time = shortest_time(
        s, s[:, None] * slope, np.tile(slope, (301, 1)), np.array([0.8, 0.25]), np.array([2.0, 5.0]), rate_0, rate_1
    )
    v, a = 0.5, 2.0
    ramps = [(v * v - r * r) / (2 * a) for r in (rate_0, rate_1)]
    wanted = sum((v - r) / a for r in (rate_0, rate_1)) + (1 - sum(ramps)) / v
    assert time == pytest.approx(wanted, rel=2e-4)


def test_toppra_on_a_curved_path_is_the_closed_form() -> None:
    """y = x^2 / 2 from x = 1 to 2, only |y''| <= 2, y' = 1 at both ends: up to y' = 2 and down again, in 1 s."""
    s = np.linspace(1, 2, 301)
    q, dq = np.column_stack([s, s * s / 2]), np.column_stack([np.ones_like(s), s])
    time = shortest_time(s, q, dq, np.array([np.inf, np.inf]), np.array([np.inf, 2.0]), 1.0, 0.5)
    assert time == pytest.approx(1.0, rel=1e-3)


def test_no_timing_is_none() -> None:
    """Ending at a speed above the limit cannot be."""
    s = np.linspace(0, 1, 50)
    one = np.ones((50, 1))
    assert shortest_time(s, s[:, None], one, np.array([1.0]), np.array([1.0]), 0.0, 5.0) is None


@pytest.mark.parametrize("straight", [False, True])
@pytest.mark.parametrize("jerky", [False, True])
@pytest.mark.parametrize("least", [0.0, 6.0])
def test_the_phases_are_ruckigs_own_motion(straight: bool, jerky: bool, least: float) -> None:
    """Sampled by ruckig itself at times between switches; one axis does not move at all."""
    rng = np.random.default_rng(5)
    k = 5
    for _ in range(20):
        q_0, q_1 = rng.normal(size=(2, k))
        q_1[2] = q_0[2]
        v, a = rng.uniform(0.5, 4, k), rng.uniform(3, 40, k)
        j = a * 12 if jerky else None
        move = point_to_point(q_0, q_1, v, a, j, least, straight)
        wish, out = InputParameter(k), Trajectory(k)
        wish.current_position, wish.target_position = q_0.tolist(), q_1.tolist()
        wish.max_velocity, wish.max_acceleration = v.tolist(), a.tolist()
        wish.max_jerk = [float("inf")] * k if j is None else j.tolist()
        wish.synchronization = Synchronization.Phase if straight else Synchronization.Time
        wish.minimum_duration = least or None
        Ruckig(k).calculate(wish, out)
        times = rng.uniform(0, out.duration, 50)
        wanted = [np.array(x) for x in zip(*(out.at_time(t) for t in times), strict=True)]
        assert move.duration == pytest.approx(out.duration, abs=1e-12)
        assert move.duration >= least
        for ours, ruckigs in zip(move.at(times), wanted, strict=False):
            np.testing.assert_allclose(ours, ruckigs, rtol=0, atol=1e-9)
        if j is not None:
            assert (np.abs(move.jerks(times)) <= j * (1 + 1e-9)).all()
        q, qd, _ = move.at(np.array([move.duration]))
        np.testing.assert_allclose(q[0], q_1, rtol=0, atol=1e-14)
        assert np.abs(qd).max() < 1e-12


def test_slowing_a_move_down_scales_its_derivatives() -> None:
    move = point_to_point(np.zeros(2), np.array([1.0, -0.3]), np.ones(2), np.full(2, 4.0), np.full(2, 50.0))
    slow, t = move.slowed(1.5), np.linspace(0, move.duration, 40)
    assert slow.duration == pytest.approx(1.5 * move.duration)
    for power, (fast_x, slow_x) in enumerate(zip(move.at(t), slow.at(1.5 * t), strict=True)):
        np.testing.assert_allclose(slow_x, fast_x / 1.5**power, atol=1e-12)
    assert slow.switches == pytest.approx(move.switches * 1.5)
