"""The least time of one axis between cells, against the exact one between points of them."""

import numpy as np

from trajopt_cli.timing.double_integrator import least_time, shortest_time

V, A, N = 1.5, 4.0, 4000
RNG = np.random.default_rng(3)


def test_between_points_it_is_the_least_time_of_the_axis():
    D, (v, w) = RNG.uniform(-1, 1, N), RNG.uniform(-V, V, (2, N))
    found = least_time(np.zeros(N), D, D, (v, v, w, w), V, A)
    exact = shortest_time(D[:, None], v[:, None], w[:, None], V, A)
    np.testing.assert_allclose(found, exact, atol=1e-8)


def test_no_motion_between_points_of_cells_is_faster():
    low, v, w = RNG.uniform(-1, 1, N), RNG.uniform(-V, 0.8 * V, N), RNG.uniform(-V, 0.8 * V, N)
    T = RNG.uniform(0, 0.6, N)
    found = least_time(T, low, low + 0.1, (v, v + 0.3, w, w + 0.3), V, A)
    for _ in range(20):
        D, a, c = low + RNG.uniform(0, 0.1, N), v + RNG.uniform(0, 0.3, N), w + RNG.uniform(0, 0.3, N)
        exact = shortest_time(D[:, None], a[:, None], c[:, None], V, A)
        assert np.all((exact >= found - 1e-8) | (exact < T))
    assert np.mean(found > T) > 0.2
