"""One axis with |v| <= V and |a| <= A: what it reaches in exactly T, how soon, and a profile that does it.

For T >= |v1 - v0| / A the displacements reachable from velocity v0 to velocity v1 in exactly T fill an interval
[-reach(T, -v0, -v1), reach(T, v0, v1)]. All functions broadcast; units are those of the axis.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array


def reach(T: ArrayLike, v0: ArrayLike, v1: ArrayLike, V: ArrayLike, A: ArrayLike) -> Array:
    """Largest displacement in exactly T from v0 to v1; meaningful for T >= |v1 - v0| / A."""
    T, v0, v1, V, A = (np.asarray(x, dtype=float) for x in (T, v0, v1, V, A))
    peak = (v0 + v1 + A * T) / 2
    return (2 * peak**2 - v0**2 - v1**2) / (2 * A) - np.maximum(peak - V, 0.0) ** 2 / A


def _leave_block(T: Array, D: Array, v0: Array, v1: Array, V: Array, A: Array) -> None:
    """Move T (n,), in place, to the right end of the open interval of times in which D is out of reach, where it is."""
    short = np.flatnonzero(reach(T, v0, v1, V, A) < D - 1e-12)
    if not len(short):
        return
    D, v0, v1, V, A = (x[short] for x in (D, v0, v1, V, A))
    energy = A * D + (v0**2 + v1**2) / 2
    peak = np.sqrt(np.maximum(energy, 0.0))
    slow = (2 * peak - v0 - v1) / A
    fast = (2 * V - v0 - v1) / A + (D - (V**2 - (v0**2 + v1**2) / 2) / A) / V
    T[short] = np.maximum(T[short], np.where(peak <= V, slow, fast))


def shortest_time(D: ArrayLike, v0: ArrayLike, v1: ArrayLike, V: ArrayLike, A: ArrayLike, rounds: int = 100) -> Array:
    """Least T in which all axes (last array axis) travel D from v0 to v1 together, blocked times included.

    Each round moves past the blocked interval of every axis in turn; it stops early when nothing changes.
    """
    D, v0, v1, V, A = np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in (D, v0, v1, V, A)))
    shape, k = D.shape[:-1], D.shape[-1]
    columns = [tuple(x[..., j].ravel() for x in (D, v0, v1, V, A)) for j in range(k)]
    T = np.max(np.abs(v1 - v0) / A, axis=-1).ravel()
    for _ in range(rounds):
        before = T.copy()
        for d, a, b, v, acc in columns:
            _leave_block(T, d, a, b, v, acc)
            _leave_block(T, -d, -a, -b, v, acc)
        if np.array_equal(T, before):
            break
    return T.reshape(shape)


def alone(D: Array, v0: Array, v1: Array, V: float, A: float) -> Array:
    """Least T in which one axis travels D from v0 to v1."""
    ahead = np.where(D < 0, -1.0, 1.0)
    D, both = np.abs(D), ahead * (v0 + v1)
    T = np.abs(v1 - v0) / A
    squares = (v0 * v0 + v1 * v1) / 2
    peak = np.sqrt(A * D + squares)
    late = np.where(peak <= V, (2 * peak - both) / A, (2 * V - both) / A + (D - (V * V - squares) / A) / V)
    return np.where(both * T / 2 < D - 1e-12, np.maximum(T, late), T)


def trapezoid_time(D: ArrayLike, V: ArrayLike, A: ArrayLike) -> Array:
    """Least time from rest to rest over D >= 0; V may be infinite."""
    D, V, A = np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in (D, V, A)))
    with np.errstate(invalid="ignore"):
        return np.where(D * A > V * V, D / V + V / A, 2 * np.sqrt(D / A))


def cruise_profile(D: float, v0: float, v1: float, T: float, A: float) -> tuple[Array, Array]:
    """Break times (4,) from 0 to T and accelerations (3,) of the profile that ramps at +-A to one cruise speed.

    Among all profiles of duration T it has the smallest peak speed. Raises ValueError when T is out of reach.
    """

    def travelled(c: float) -> float:
        t0, t1 = abs(c - v0) / A, abs(c - v1) / A
        return (v0 + c) / 2 * t0 + c * (T - t0 - t1) + (c + v1) / 2 * t1

    low, high = (v0 + v1 - A * T) / 2, (v0 + v1 + A * T) / 2
    slack = 1e-13 * (abs(D) + A * T * T)
    if low > high or travelled(low) > D + slack or travelled(high) < D - slack:
        raise ValueError(f"cruise_profile: displacement {D:.9g} from {v0:.9g} to {v1:.9g} does not fit into {T:.9g} s")
    c = _cruise_speed(D, v0, v1, T, A, low, high)
    t0, t1 = abs(c - v0) / A, abs(c - v1) / A
    t0, t1 = min(t0, T), min(t1, T)
    if t0 + t1 > T:
        t0, t1 = t0 * T / (t0 + t1), t1 * T / (t0 + t1)
    breaks = np.array([0.0, t0, T - t1, T])
    return breaks, np.array([np.sign(c - v0) * A, 0.0, np.sign(v1 - c) * A])


def gentlest_profile(D: float, v0: float, v1: float, T: float) -> tuple[Array, Array]:
    """The profile of duration T with the least acceleration: two ramps, no cruise. Breaks (4,), accelerations (3,)."""
    if T == 0.0:
        return np.zeros(4), np.zeros(3)
    excess = 2 * D - T * (v0 + v1)
    A = (abs(excess) + np.hypot(excess, T * (v0 - v1))) / T**2
    if A == 0.0:
        return np.array([0.0, 0.0, T, T]), np.zeros(3)
    sign = 1.0 if excess >= 0 else -1.0
    t0 = min(max((T + sign * (v1 - v0) / A) / 2, 0.0), T)
    return np.array([0.0, t0, t0, T]), np.array([sign * A, 0.0, -sign * A])


def _cruise_speed(D: float, v0: float, v1: float, T: float, A: float, low: float, high: float) -> float:
    """Cruise velocity c in [low, high] whose profile travels D; travelled(c) increases, piecewise quadratic."""
    ends = [low, min(v0, v1), max(v0, v1), high]
    for k in range(3):
        a, b = ends[k], ends[k + 1]
        if b <= a and k != 2:
            continue
        # signs of c - v0 and c - v1 on this piece
        s0 = -1.0 if k == 0 or (k == 1 and v0 > v1) else 1.0
        s1 = -1.0 if k == 0 or (k == 1 and v1 > v0) else 1.0
        # travelled = (c^2 - v0^2) s0 / 2A + c (T - s0 (c - v0)/A - s1 (c - v1)/A) + (c^2 - v1^2) s1 / 2A
        q2 = -(s0 + s1) / (2 * A)
        q1 = T + (s0 * v0 + s1 * v1) / A
        q0 = -(s0 * v0**2 + s1 * v1**2) / (2 * A) - D
        if abs(q2) < 1e-300:
            roots = [-q0 / q1] if q1 != 0 else [a]
        else:
            root = np.sqrt(max(q1 * q1 - 4 * q2 * q0, 0.0))
            roots = [(-q1 + root) / (2 * q2), (-q1 - root) / (2 * q2)]
        for c in roots:
            if a - 1e-9 * (1 + abs(a)) <= c <= b + 1e-9 * (1 + abs(b)):
                return float(min(max(c, a), b))
    raise ValueError("cruise_profile: no cruise speed found")
