"""TOPP-RA on one path after the other, in loops over the rows of an interval. See topp.py."""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import sqrt

import numpy as np
from numba import njit

_UNBOUND = 1e12  # (ds/dt)^2 that stands for none
_FAINT = 1e-9  # share of its limit below which a row's part of one point is a constant: dividing by it is rounding
_CANCELLED = 1e-14  # of a row's other part, below which a part is what rounding leaves of a difference
_ROUNDING = 1e-9  # relative: rates at the ends may pass what is feasible by this and are then taken as its bound
_PART = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


@njit(**_PART)
def _rows(p, r, g, s, begins, ends, b, i):
    """|p x_{i+1} + r x_i + g| <= 1 on interval i: those where it begins, then those where it ends."""
    h, half = 2 * (s[b, i + 1] - s[b, i]), len(p) // 2
    for k in range(half):
        p[k] = begins[0][b, i, k] / h
        r[k] = begins[1][b, i, k] - p[k]
        g[k] = begins[2][b, i, k]
        r[half + k] = -ends[0][b, i, k] / h
        p[half + k] = ends[1][b, i, k] - r[half + k]
        g[half + k] = ends[2][b, i, k]


@njit(**_PART)
def _room(of, g):
    """What rest g leaves of 1 to a growing x, with its factor in a row that is not 0; none where g leaves nothing."""
    return max(1 - g if of > 0 else 1 + g, 0.0)


@njit(**_PART)
def _lines(c, d, m, of, other, g):
    """What rows |other y + of x + g| <= 1 leave for x: x <= c + m y and -x <= d - m y; inf and 0 where x is not in the
    row."""
    for k in range(len(of)):
        c[k], d[k], m[k] = np.inf, np.inf, 0.0
        if abs(of[k]) > _CANCELLED * abs(other[k]):
            part = 1 / abs(of[k])
            c[k], d[k], m[k] = _room(of[k], g[k]) * part, _room(of[k], -g[k]) * part, -other[k] / of[k]


@njit(**_PART)
def _lowest(c, m, y):
    """The line that is least at y."""
    least, at = np.inf, 0
    for k in range(len(c)):
        value = c[k] + m[k] * y
        if value < least:
            least, at = value, k
    return at


@njit(**_PART)
def _reach(c, d, m, far):
    """The greatest y, at most far, for which rows leave some x. c: intercepts from above; d: of -x at -y.

    The room for x, between the least line from above and the greatest from below, is concave; Newton's method from
    beyond its zero ends there.
    """
    y = far
    for _ in range(2 * len(c)):
        up, down = _lowest(c, m, y), _lowest(d, m, -y)
        if not c[up] + m[up] * y + d[down] - m[down] * y < 0:
            break
        y = (c[up] + d[down]) / (m[down] - m[up])
    return y


@njit(**_PART)
def _peak(c, m, far):
    """Where, for y from -far to far, x is greatest; and this x. far is within _reach.

    The two lines that hold x on either side of the peak meet above it; the line that is lowest there replaces one of
    them, until none is lower: a linear program in as many steps as it has rows at most.
    """
    left, right = _lowest(c, m, -far), _lowest(c, m, far)
    if not m[left] > 0:
        return -far, c[left] - m[left] * far
    y = far
    x = c[right] + m[right] * y
    if m[right] < 0:
        for _ in range(len(c)):
            y = (c[right] - c[left]) / (m[left] - m[right])
            k = _lowest(c, m, y)
            x = c[k] + m[k] * y
            if m[k] > 0 and k != left:
                left = k
            elif m[k] < 0 and k != right:
                right = k
            else:
                break
    return y, x


@njit(
    [f"void(float64[:,:], float64[:,:], {'float64[:,:,:], ' * 6} float64[:], float64[:], {'float64[:,::1], ' * 3})"],
    error_model="numpy",
    no_cpython_wrapper=True,
    no_cfunc_wrapper=True,
)
def fill_rates(s, top, slopes_0, bends_0, rests_0, slopes_1, bends_1, rests_1, x_0, x_1, of_rows, of_points, rates):
    """Rates (B, n) of paths as fastest_laws has them, NaN for those that have none. x_0, x_1: squares of the rates at
    the ends. of_rows (6, 2 m), of_points (5, n): room for what is between."""
    p, r, g, c, d, m = of_rows[0], of_rows[1], of_rows[2], of_rows[3], of_rows[4], of_rows[5]
    bound, here, there, low, high = of_points[0], of_points[1], of_points[2], of_points[3], of_points[4]
    begins, ends = (slopes_0, bends_0, rests_0), (slopes_1, bends_1, rests_1)
    n = len(bound)
    for b in range(len(top)):
        for i in range(n):
            bound[i] = min(top[b, i] * top[b, i], _UNBOUND)
        failed = x_1[b] > bound[-1] * (1 + _ROUNDING) and x_1[b] < np.inf
        high[-1] = min(x_1[b], bound[-1])
        low[-1] = high[-1] if x_1[b] < np.inf else 0.0
        for i in range(n - 2, -1, -1):
            _rows(p, r, g, s, begins, ends, b, i)
            _lines(c, d, m, r, p, g)
            y = there[i] = _reach(c, d, m, bound[i + 1])
            at, x = _peak(c, m, y)
            x = here[i] = min(x, bound[i])
            for k in range(len(p)):
                part_x, part_y = abs(r[k]) * x, abs(p[k]) * y
                if part_x < _FAINT or part_y < _FAINT:
                    c[k], m[k] = np.inf, 0.0  # a row that does not need both points
                    if part_x >= _FAINT:
                        bound[i] = min(bound[i], max(_room(r[k], g[k]) - part_y, 0.0) / abs(r[k]))
                    elif part_y >= _FAINT:
                        high[i + 1] = min(high[i + 1], max(_room(p[k], g[k]) - part_x, 0.0) / abs(p[k]))
            high[i + 1] = min(high[i + 1], y)
            failed |= low[i + 1] > high[i + 1] * (1 + _ROUNDING)
            low[i + 1] = min(low[i + 1], high[i + 1])
            y = min(max(at, low[i + 1]), high[i + 1])
            k = _lowest(c, m, y)
            high[i], low[i] = min(min(x, bound[i]), c[k] + m[k] * y), 0.0
            if low[i + 1] > 0:  # rest can be reached from rest: once the set holds 0 it holds it at all points before
                y = min(max(at, -high[i + 1]), -low[i + 1])
                k = _lowest(c, m, y)
                low[i] = max(-c[k] - m[k] * y, 0.0)
                failed |= low[i] > high[i] * (1 + _ROUNDING)
            high[i] = max(high[i], 0.0)
        failed |= low[0] > high[0] * (1 + _ROUNDING)
        failed |= (x_0[b] > high[0] * (1 + _ROUNDING) and x_0[b] < np.inf) or x_0[b] < low[0] * (1 - _ROUNDING)
        x = min(max(x_0[b], low[0]), high[0])
        rates[b, 0] = np.nan if failed else sqrt(x)
        for i in range(n - 1):
            _rows(p, r, g, s, begins, ends, b, i)
            y = high[i + 1]
            for k in range(len(p)):
                of, held = abs(p[k]), abs(p[k]) > _CANCELLED * abs(r[k])
                if held and of * there[i] >= _FAINT and abs(r[k]) * here[i] >= _FAINT:
                    y = min(y, (_room(p[k], g[k]) - (r[k] if p[k] > 0 else -r[k]) * x) / of)
            x = max(y, low[i + 1])
            rates[b, i + 1] = np.nan if failed else sqrt(x)
