"""One axis in exactly T: held against ruckig with jerk set free, and against the motion laws themselves."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from ruckig import InputParameter, Result, Ruckig, Trajectory

from trajopt_cli.geometry import Array
from trajopt_cli.timing.double_integrator import cruise_profile, gentlest_profile, reach, shortest_time, trapezoid_time


def ruckig_time(D: Array, v0: Array, v1: Array, V: Array, A: Array, least: float | None = None) -> float:
    """Time-synchronised duration of ruckig, all axes over D together."""
    k = len(D)
    wish = InputParameter(k)
    wish.current_position, wish.target_position = [0.0] * k, D.tolist()
    wish.current_velocity, wish.target_velocity = v0.tolist(), v1.tolist()
    wish.current_acceleration = wish.target_acceleration = [0.0] * k
    wish.max_velocity, wish.max_acceleration, wish.max_jerk = V.tolist(), A.tolist(), [float("inf")] * k
    if least is not None:
        wish.minimum_duration = least
    out = Trajectory(k)
    assert Ruckig(k).calculate(wish, out) in (Result.Working, Result.Finished)
    return float(out.duration)


def cases(rng: np.random.Generator, n: int, k: int) -> tuple[Array, Array, Array, Array, Array]:
    V, A = rng.uniform(0.3, 5, (n, k)), rng.uniform(1, 60, (n, k))
    v0, v1 = V * rng.uniform(-0.95, 0.95, (n, k)), V * rng.uniform(-0.95, 0.95, (n, k))
    return rng.uniform(-1, 1, (n, k)) * 10 ** rng.uniform(-3, 0.5, (n, k)), v0, v1, V, A


@pytest.mark.parametrize("k", [1, 2, 3, 7])
def test_shortest_time_equals_ruckig_with_end_speeds(k: int) -> None:
    D, v0, v1, V, A = cases(np.random.default_rng(k), 500, k)
    ours = shortest_time(D, v0, v1, V, A)
    theirs = np.array([ruckig_time(*row) for row in zip(D, v0, v1, V, A, strict=True)])
    np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-9)


def test_shortest_time_equals_ruckig_from_rest_to_rest_and_over_nothing() -> None:
    rng = np.random.default_rng(5)
    D, _, _, V, A = cases(rng, 200, 7)
    D[:, 3] = 0.0
    zero = np.zeros_like(D)
    theirs = np.array([ruckig_time(*row) for row in zip(D, zero, zero, V, A, strict=True)])
    np.testing.assert_allclose(shortest_time(D, zero, zero, V, A), theirs, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(np.max(trapezoid_time(np.abs(D), V, A), axis=-1), theirs, rtol=1e-9, atol=1e-9)


def test_a_blocked_time_of_one_axis_delays_all() -> None:
    """Axis 1 flies on at 1 m/s and needs either 0.1 s or, having braked and turned back, far longer; axis 2 needs
    0.15 s, which falls between."""
    D, v = np.array([0.1, 0.3]), np.array([[1.0, 0.0], [1.0, 0.0]])
    V, A = np.array([1.0, 10.0]), np.array([2.0, 60.0])
    alone = float(shortest_time(D[:1], v[0, :1], v[1, :1], V[:1], A[:1]))
    other = float(shortest_time(D[1:], v[0, 1:], v[1, 1:], V[1:], A[1:]))
    together = float(shortest_time(D, v[0], v[1], V, A))
    assert alone == pytest.approx(0.1, abs=1e-12)
    assert other == pytest.approx(2 * np.sqrt(0.3 / 60), abs=1e-12)
    assert together > 3 * other
    assert together == pytest.approx(ruckig_time(D, v[0], v[1], V, A), abs=1e-9)


@pytest.mark.parametrize("order", [1, -1])
def test_axes_that_block_each_other_in_turn_are_all_waited_for(order: int) -> None:
    """Seven axes fly on at one speed; each is blocked from just before the time at which the one before comes free.

    Between a and b an axis at speed v = A (a + b) / 4 with D = A a b / 4 to go would have to turn back.
    """
    free = np.arange(1, 9) / 10
    a, b = free[:-1] - 0.01, free[1:]
    A = np.full(7, 4.0)
    v, D, V = A * (a + b) / 4, A * a * b / 4, np.full(7, 10.0)
    D, v = D[::order], v[::order]
    assert ruckig_time(D, v, v, V, A) == pytest.approx(0.8, abs=1e-9)
    assert float(shortest_time(D, v, v, V, A)) == pytest.approx(0.8, abs=1e-9)


def test_reach_is_where_ruckig_stops_keeping_the_time() -> None:
    """A hair less displacement fits into T, a hair more does not."""
    rng = np.random.default_rng(2)
    _, v0, v1, V, A = (x[:, 0] for x in cases(rng, 300, 1))
    T = np.abs(v1 - v0) / A + rng.uniform(0.01, 1.5, 300)
    most, least = reach(T, v0, v1, V, A), -reach(T, -v0, -v1, V, A)
    assert np.all(most > least)
    for i in range(300):
        one = [x[i : i + 1] for x in (v0, v1, V, A)]
        for edge, sign in ((most[i], 1.0), (least[i], -1.0)):
            hair = 1e-7 * (1 + abs(edge))
            assert ruckig_time(np.array([edge - sign * hair]), *one, least=T[i]) == pytest.approx(T[i], abs=1e-9)
            assert ruckig_time(np.array([edge + sign * hair]), *one, least=T[i]) > T[i] + 1e-10


def test_reach_grows_with_both_speeds_and_its_slope_in_time_is_the_peak_speed() -> None:
    rng = np.random.default_rng(3)
    _, v0, v1, V, A = (x[:, 0] for x in cases(rng, 2000, 1))
    T = np.abs(v1 - v0) / A + rng.uniform(0.05, 1.0, 2000)
    step = 1e-3 * V
    base = reach(T, v0, v1, V, A)
    assert np.all(reach(T, np.minimum(v0 + step, V), v1, V, A) >= base - 1e-15)
    assert np.all(reach(T, v0, np.minimum(v1 + step, V), V, A) >= base - 1e-15)
    peak = np.minimum((v0 + v1 + A * T) / 2, V)
    slope = (reach(T + 1e-6, v0, v1, V, A) - reach(T - 1e-6, v0, v1, V, A)) / 2e-6
    np.testing.assert_allclose(slope, peak, atol=1e-4)


def integrated(breaks: Array, acc: Array, v0: float) -> tuple[float, float, float]:
    """Displacement, end speed and largest speed of a piecewise constant acceleration."""
    x, v, top = 0.0, v0, abs(v0)
    for (a, b), acceleration in zip(pairwise(breaks), acc, strict=True):
        h = b - a
        x, v = x + v * h + acceleration * h * h / 2, v + acceleration * h
        top = max(top, abs(v))
    return x, v, top


def feasible(rng: np.random.Generator, n: int) -> tuple[Array, ...]:
    _, v0, v1, V, A = (x[:, 0] for x in cases(rng, n, 1))
    T = np.abs(v1 - v0) / A + 10 ** rng.uniform(-3, 0.5, n)
    most, least = reach(T, v0, v1, V, A), -reach(T, -v0, -v1, V, A)
    share = rng.choice([0.0, 1.0, 0.5, -1.0], n)
    share = np.where(share < 0, rng.uniform(0, 1, n), share)
    return least + share * (most - least), v0, v1, T, V, A


def test_cruise_profile_arrives_within_speed_and_acceleration() -> None:
    for D, v0, v1, T, V, A in zip(*feasible(np.random.default_rng(4), 2000), strict=True):
        breaks, acc = cruise_profile(D, v0, v1, T, A)
        x, v, top = integrated(breaks, acc, v0)
        scale = 1 + abs(D) + V * T
        assert abs(x - D) < 1e-12 * scale, (D, v0, v1, T, A)
        assert abs(v - v1) < 1e-12 * (1 + V + A * T)
        assert top <= V * (1 + 1e-9)
        assert np.max(np.abs(acc)) <= A
        assert breaks[0] == 0.0
        assert breaks[-1] == T
        assert np.all(np.diff(breaks) >= -1e-15)


def test_gentlest_profile_arrives_and_nothing_gentler_does() -> None:
    for D, v0, v1, T, V, A in zip(*feasible(np.random.default_rng(6), 2000), strict=True):
        breaks, acc = gentlest_profile(D, v0, v1, T)
        x, v, _ = integrated(breaks, acc, v0)
        assert abs(x - D) < 1e-12 * (1 + abs(D) + V * T)
        assert abs(v - v1) < 1e-12 * (1 + V + A * T)
        a = float(np.max(np.abs(acc)))
        assert a <= A * (1 + 1e-9)
        if a > 1e-6:
            less = 0.999 * a
            fits = less * T >= abs(v1 - v0) and (
                -reach(T, -v0, -v1, np.inf, less) <= D <= reach(T, v0, v1, np.inf, less)
            )
            assert not fits


def test_constant_speed_needs_no_acceleration() -> None:
    breaks, acc = gentlest_profile(0.5, 1.0, 1.0, 0.5)
    assert not np.any(acc)
    assert breaks.tolist() == [0.0, 0.0, 0.5, 0.5]
    breaks, acc = cruise_profile(0.5, 1.0, 1.0, 0.5, 3.0)
    assert integrated(breaks, acc, 1.0) == pytest.approx((0.5, 1.0, 1.0), abs=1e-15)


@pytest.mark.parametrize(
    ("D", "v0", "v1", "T"), [(1.0, 0.0, 0.0, 0.5), (-1.0, 0.0, 0.0, 0.5), (0.0, 1.0, -1.0, 0.5), (0.2, 1.0, 1.0, 0.1)]
)
def test_what_does_not_fit_is_refused_with_its_numbers(D: float, v0: float, v1: float, T: float) -> None:
    with pytest.raises(ValueError, match=f"displacement {D:.9g} from {v0:.9g} to {v1:.9g} does not fit into {T:.9g} s"):
        cruise_profile(D, v0, v1, T, 3.0)


def test_a_trapezoid_without_a_speed_limit_is_a_triangle() -> None:
    assert float(trapezoid_time(0.3, np.inf, 3.0)) == pytest.approx(2 * np.sqrt(0.1), abs=1e-15)
    assert float(trapezoid_time(3.0, 1.0, 3.0)) == pytest.approx(3.0 + 1 / 3, abs=1e-15)
    assert float(trapezoid_time(0.0, 1.0, 3.0)) == 0.0
