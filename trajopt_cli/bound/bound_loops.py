"""Least times between all cells of two places, pair by pair. See lower_bound.py."""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from math import sqrt

import numpy as np
from numba import njit

_COPY = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


@njit(**_COPY)
def _leave(T, D, a, c, V, A):
    """The least time >= T in which some motion with end velocities below a and c, which may be chosen, travels at least
    D: what it travels at most is convex and smooth in T."""
    peak = (a + c + A * T) / 2
    most = (2 * peak * peak - a * a - c * c) / (2 * A) - max(peak - V, 0.0) ** 2 / A
    m, M = min(a, c), max(a, c)
    if M - m > T * A:
        most = m * T + A * T * T / 2
    if most >= D - 1e-9:
        return T
    if M >= 0 and (M * M - m * m) / (2 * A) > D:
        end = (sqrt(max(m * m + 2 * A * D, 0.0)) - m) / A
    else:
        squares = A * D + (a * a + c * c) / 2
        top = min(sqrt(max(squares, 0.0)), V)
        end = (squares / max(top, 1e-300) + top - (a + c)) / A
    return max(T, end - 1e-9)


@njit(**_COPY)
def _between(T, low, high, a_slow, a_fast, b_slow, b_fast, V, A):
    """The least time >= T in which an axis can travel between low and high, from the first range of velocity to the
    second. Where it gets as far as low at last it is not beyond high, and reversely."""
    T = _leave(max(T, (b_slow - a_fast) / A, (a_slow - b_fast) / A), low, a_fast, b_fast, V, A)
    return _leave(T, -high, -a_slow, -b_slow, V, A)


@njit([f"void({'float64[:], ' * 7} float64, float64)"], error_model="numpy")
def raise_times(T, low, high, a_slow, a_fast, b_slow, b_fast, V, A):
    """Put T (k,) to what an axis takes at least between low and high, see _between."""
    for i in range(len(T)):
        T[i] = _between(T[i], low[i], high[i], a_slow[i], a_fast[i], b_slow[i], b_fast[i], V, A)


@njit(**_COPY)
def _trapezoid(D, V, A):
    """As double_integrator's."""
    return D / V + V / A if D * A > V * V else 2 * sqrt(D / A)


@njit(
    [
        f"void({'float64[:,:], ' * 9} int64[:], int64[:], float64[:], float64[:], int64[:], float64[:], float64[:], "
        "int64, float64, int64, int64, int64, int64, int64, float64)"
    ],
    error_model="numpy",
)
def fill_times(
    out, a_low, a_high, a_slow, a_fast, b_low, b_high, b_slow, b_fast, a_signs, b_signs, so_far, ahead, order, V, A, r,
    floor, fixed, still, straight, branch, least, incumbent,
):  # fmt: skip
    """out (n_a, n_b): least times between cells, infinite where so_far, they and what is ahead exceed the incumbent,
    or, with least, what came out of the row before. Cells (axes, n): where they begin and end, and their velocities.
    order: axes, those that settle most pairs first; r: of the rail."""
    for i in range(len(so_far)):
        for j in range(len(ahead)):
            out[i, j], T = np.inf, floor
            for k in range(r):  # the way at its top speed all along
                T = max(T, (b_low[k, j] - a_high[k, i]) / V[k], (a_low[k, i] - b_high[k, j]) / V[k])
            if so_far[i] + T + ahead[j] > incumbent or (branch and a_signs[i] != b_signs[j]):
                continue
            T, top_v, top_a = floor, np.inf, np.inf
            for k in order:
                low, high = b_low[k, j] - a_high[k, i], b_high[k, j] - a_low[k, i]
                distance = max(low, -high, 0.0)
                if not still:
                    rates = a_slow[k, i], a_fast[k, i], b_slow[k, j], b_fast[k, j]
                    time = _between(T, low, high, *rates, V[k], A[k])
                elif straight:
                    distance = max(distance, 1e-12)
                    top_v, top_a = min(top_v, V[k] / distance), min(top_a, A[k] / distance)
                    time = _trapezoid(1.0, top_v, top_a)
                else:
                    time = _trapezoid(distance, V[k], A[k])
                if fixed and time > floor + 1e-9:
                    break
                if not fixed:
                    T = max(T, time)
                    if so_far[i] + T + ahead[j] > incumbent:
                        break
            else:
                out[i, j] = T
                if least:
                    incumbent = min(incumbent, T + ahead[j])
        if least:
            incumbent = np.inf


@njit(["void(float64[:,:], float64[:], float64[:])"], error_model="numpy")
def fill_reached(T, so_far, out):
    """out (n_b,): the least of so_far (n_a,) and T (n_a, n_b) together."""
    out[:] = np.inf
    for i in range(len(so_far)):
        for j in range(len(out)):
            out[j] = min(out[j], so_far[i] + T[i, j])


@njit(["void(float64[:,:], float64[:], float64[:])"], error_model="numpy")
def fill_left(T, ahead, out):
    """out (n_a,): the least of T (n_a, n_b) and ahead (n_b,) together."""
    out[:] = np.inf
    for i in range(len(out)):
        for j in range(len(ahead)):
            out[i] = min(out[i], T[i, j] + ahead[j])
