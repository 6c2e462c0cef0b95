"""Cubic Hermite splines at many times. See integrate in leg_trajectories.py."""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from numba import njit


@njit(["void(float64[:], float64[:,:], float64[:,:], float64[:], float64, float64[:,:,::1])"], error_model="numpy")
def fill(grid, x, v, tau, aside, out):
    """out (3, m, k): positions, velocities and accelerations at tau (m,); node values x, v (N+1, k) on a grid (N+1,). A
    time belongs to the interval that holds what lies so far aside of it."""
    for n in range(len(tau)):
        i, end = 0, len(grid) - 1  # tau lies behind grid[i] and not behind grid[end], or outside
        while end - i > 1:
            middle = (i + end) // 2
            if grid[middle] <= tau[n] + aside:
                i = middle
            else:
                end = middle
        h = grid[i + 1] - grid[i]
        u = (tau[n] - grid[i]) / h
        for k in range(x.shape[1]):
            v0, v1, way = v[i, k] * h, v[i + 1, k] * h, x[i + 1, k] - x[i, k]
            c2, c3 = 3 * way - 2 * v0 - v1, v0 + v1 - 2 * way
            out[0, n, k] = x[i, k] + u * (v0 + u * (c2 + u * c3))
            out[1, n, k] = (v0 + u * (2 * c2 + 3 * u * c3)) / h
            out[2, n, k] = (2 * c2 + 6 * u * c3) / (h * h)
