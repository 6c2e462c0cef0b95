"""The cubic between two ends with given slopes; where the slopes meet half way, it is a parabola (quadratic Bézier).
And cubics through many places, one after the other."""

from __future__ import annotations

from typing import Any

import numpy as np

from trajopt_cli.geometry import Array


def hermite(x_0: Any, m_0: Any, x_1: Any, m_1: Any, u: Any) -> tuple[Any, Any, Any]:
    """Value, first and second derivative at u in [0, 1] of the cubic from x_0 with slope m_0 to x_1 with slope m_1.

    Arrays or CasADi expressions alike: ends (k,) and u (n, 1), or ends (k,) and one u.
    """
    way = x_1 - x_0
    c2, c3 = 3 * way - 2 * m_0 - m_1, m_0 + m_1 - 2 * way
    return x_0 + u * (m_0 + u * (c2 + u * c3)), m_0 + u * (2 * c2 + 3 * u * c3), 2 * c2 + 6 * u * c3


def quintic(x_0: Array, m_0: Array, b_0: Array, x_1: Array, m_1: Array, b_1: Array, u: Array) -> tuple[Array, ...]:
    """The same of the quintic (k,) that has second derivatives b_0 and b_1 at its ends, too, at u (n, 1)."""
    way, turn = x_1 - x_0 - m_0 - b_0 / 2, m_1 - m_0 - b_0
    c3, c4, c5 = np.array([[10, -4, 0.5], [-15, 7, -1], [6, -3, 0.5]]) @ np.stack([way, turn, b_1 - b_0])
    return (
        x_0 + u * (m_0 + u * (b_0 / 2 + u * (c3 + u * (c4 + u * c5)))),
        m_0 + u * (b_0 + u * (3 * c3 + u * (4 * c4 + 5 * u * c5))),
        b_0 + u * (6 * c3 + u * (12 * c4 + 20 * u * c5)),
    )


def natural_spline(x: Array, y: Array, at: Array) -> Array:
    """Values (m,), at places within the knots, of the natural cubic spline through y (n,) at two knots x (n,) or more,
    ascending. Of numpy alone: scipy's takes longer to load than most programs to search."""
    h = np.diff(x)
    slopes = np.diff(y) / h
    # rows of three for the slopes at the knots, eliminated downward
    below, middle, above = np.r_[h[1:], 1.0], np.r_[2.0, 2 * (h[:-1] + h[1:]), 2.0], np.r_[1.0, h[:-1]]
    m = 3 * np.r_[slopes[0], h[1:] * slopes[:-1] + h[:-1] * slopes[1:], slopes[-1]]
    for i in range(len(h)):
        share = below[i] / middle[i]
        middle[i + 1] -= share * above[i]
        m[i + 1] -= share * m[i]
    m[-1] /= middle[-1]
    for i in reversed(range(len(h))):
        m[i] = (m[i] - above[i] * m[i + 1]) / middle[i]
    k = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(h) - 1)
    return np.asarray(hermite(y[k], m[k] * h[k], y[k + 1], m[k + 1] * h[k], (at - x[k]) / h[k])[0])
