"""The cubic between two ends with given slopes; where the slopes meet half way, it is a parabola (quadratic Bézier)."""

from __future__ import annotations

from typing import Any


def hermite(x_0: Any, m_0: Any, x_1: Any, m_1: Any, u: Any) -> tuple[Any, Any, Any]:
    """Value, first and second derivative at u in [0, 1] of the cubic from x_0 with slope m_0 to x_1 with slope m_1.

    Arrays or CasADi expressions alike: ends (k,) and shares (n, 1), or ends (k,) and one share.
    """
    way = x_1 - x_0
    c2, c3 = 3 * way - 2 * m_0 - m_1, m_0 + m_1 - 2 * way
    return x_0 + u * (m_0 + u * (c2 + u * c3)), m_0 + u * (2 * c2 + 3 * u * c3), 2 * c2 + 6 * u * c3
