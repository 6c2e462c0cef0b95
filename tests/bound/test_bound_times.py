"""The least time of one axis between cells, against the exact one between points of them."""

import numpy as np

from trajopt_cli.native.loops import loops
from trajopt_cli.timing.double_integrator import shortest_time

V, A, N = 1.5, 4.0, 4000
RNG = np.random.default_rng(3)


def least_time(T, low, high, rates):
    out = T.copy()
    loops("trajopt_cli.bound.bound_loops")["raise_times"](out, low, high, *rates, V, A)
    return out


def test_between_points_it_is_the_least_time_of_the_axis():
    D, (v, w) = RNG.uniform(-1, 1, N), RNG.uniform(-V, V, (2, N))
    found = least_time(np.zeros(N), D, D, (v, v, w, w))
    exact = shortest_time(D[:, None], v[:, None], w[:, None], V, A)
    np.testing.assert_allclose(found, exact, atol=1e-8)


def test_no_motion_between_points_of_cells_is_faster():
    low, v, w = RNG.uniform(-1, 1, N), RNG.uniform(-V, 0.8 * V, N), RNG.uniform(-V, 0.8 * V, N)
    T = RNG.uniform(0, 0.6, N)
    found = least_time(T, low, low + 0.1, (v, v + 0.3, w, w + 0.3))
    for _ in range(20):
        D, a, c = low + RNG.uniform(0, 0.1, N), v + RNG.uniform(0, 0.3, N), w + RNG.uniform(0, 0.3, N)
        exact = shortest_time(D[:, None], a[:, None], c[:, None], V, A)
        assert np.all((exact >= found - 1e-8) | (exact < T))
    assert np.mean(found > T) > 0.2


def test_between_all_cells_of_points_it_is_what_all_axes_take():
    """With signs that stay, an incumbent, and the least of each row alone."""
    n, m, order, limits = 40, 30, np.array([0, 2, 1]), np.full((2, 3), [[V], [A]])
    (q, v), (p, w) = (RNG.uniform(-1, 1, (2, 3, size)) for size in (n, m))
    (signs_a, before), (signs_b, ahead) = ((RNG.integers(0, 4, k), RNG.uniform(0, 1, k)) for k in (n, m))
    alike = signs_a[:, None] == signs_b
    fill, out = loops("trajopt_cli.bound.bound_loops")["fill_times"], np.empty((n, m))
    for still in (0, 1):
        v, w = v * (1 - still), w * (1 - still)
        cells = q, q, v, v, p, p, w, w, signs_a, signs_b
        way, *rates = (
            np.moveaxis(x, 0, -1) for x in (p[:, None] - q[:, :, None], *np.broadcast_arrays(v[:, :, None], w[:, None]))
        )
        exact = shortest_time(way, *rates, V, A)
        fill(out, *cells, before, ahead, order, *limits, 1, 0.0, 0, still, 0, 0, 0, np.inf)
        every = out.copy()
        assert np.all(every < exact + 1e-8)  # what holds one axis back is not asked of others again
        assert np.mean(np.abs(every - exact) < 1e-8) > 0.95
        spent, incumbent = before[:, None] + every + ahead, 1.8
        fill(out, *cells, before, ahead, order, *limits, 1, 0.0, 0, still, 0, 1, 0, incumbent)
        np.testing.assert_array_equal(out, np.where(alike & (spent <= incumbent), every, np.inf))
        assert 0.1 < np.isfinite(out).sum() / alike.sum() < 0.9
        fill(out, *cells, 0 * before, ahead, order, *limits, 1, 0.0, 0, still, 0, 1, 1, np.inf)
        least = np.min(np.where(alike, every + ahead, np.inf), axis=1)
        np.testing.assert_array_equal((out + ahead).min(axis=1), least)
        assert np.isinf(out[alike]).any()


def test_least_sums_are_those_of_columns_and_rows():
    T = np.where(RNG.random((7, 5)) < 0.3, np.inf, RNG.random((7, 5)))
    T[:, 3] = np.inf
    before, ahead, reached, left = RNG.random(7), RNG.random(5), np.zeros(5), np.zeros(7)
    compiled = loops("trajopt_cli.bound.bound_loops")
    compiled["fill_reached"](T, before, reached)
    compiled["fill_left"](T, ahead, left)
    np.testing.assert_array_equal(reached, np.min(before[:, None] + T, axis=0))
    np.testing.assert_array_equal(left, np.min(T + ahead, axis=1))
