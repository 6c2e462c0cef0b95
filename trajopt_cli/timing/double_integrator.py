"""One axis with |v| <= V and |a| <= A: what it reaches in exactly T, how soon, and a profile that does it.

For T >= |v1 - v0| / A the displacements reachable from velocity v0 to velocity v1 in exactly T fill an interval
[-reach(T, -v0, -v1), reach(T, v0, v1)]. All functions broadcast; units are those of the axis.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array

_CHUNK = 1024  # columns at once: work arrays stay in cache


def reach(T: ArrayLike, v0: ArrayLike, v1: ArrayLike, V: ArrayLike, A: ArrayLike) -> Array:
    """Largest displacement in exactly T from v0 to v1; meaningful for T >= |v1 - v0| / A."""
    T, v0, v1, V, A = (np.asarray(x, dtype=float) for x in (T, v0, v1, V, A))
    peak = (v0 + v1 + A * T) / 2
    return (2 * peak**2 - v0**2 - v1**2) / (2 * A) - np.maximum(peak - V, 0.0) ** 2 / A


def shortest_time(D: ArrayLike, v0: ArrayLike, v1: ArrayLike, V: ArrayLike, A: ArrayLike) -> Array:
    """Least T in which all axes (last array axis) travel D from v0 to v1 together, blocked times included.

    Each round moves T past the open intervals in which it lies of times when an axis is elsewhere.
    """
    D, v0, v1, V, A = np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in (D, v0, v1, V, A)))
    shape, k = D.shape[:-1], D.shape[-1]
    columns = [x.reshape(-1, k).T for x in (D, v0, v1, V, A)]
    T = np.empty(columns[0].shape[1])
    for i in range(0, len(T), _CHUNK):
        part = slice(i, i + _CHUNK)
        D, v0, v1, V, A = (np.ascontiguousarray(x[:, part]) for x in columns)
        T[part] = _together(D, v0, v1, V, A)
    return T.reshape(shape)


def _together(D: Array, v0: Array, v1: Array, V: Array, A: Array) -> Array:
    """The same (m,) of axes in rows (k, m)."""
    T = np.asarray(alone(D, v0, v1, V, A).max(axis=0))
    left = np.arange(len(T))
    while len(left):
        ahead, behind = reach(T[left], v0, v1, V, A) < D - 1e-12, reach(T[left], -v0, -v1, V, A) < -D - 1e-12
        late = np.zeros_like(D)
        for short, sign in ((ahead, 1.0), (behind, -1.0)):
            way, first, last, top, most = (x[short] for x in (D, v0, v1, V, A))
            late[short] = np.maximum(late[short], _late(sign * way, sign * (first + last), first, last, top, most))
        least = late.max(axis=0)
        some = least > T[left]
        left, D, v0, v1, V, A = left[some], *(x[:, some] for x in (D, v0, v1, V, A))
        T[left] = least[some]
    return T


def _late(D: Array, both: Array, v0: Array, v1: Array, V: Array | float, A: Array | float) -> Array:
    """The right end of the open interval of times when D is out of reach; both: the sum of both velocities towards
    it."""
    squares = A * D + (v0 * v0 + v1 * v1) / 2  # the top speed's, without a limit
    top = np.sqrt(np.maximum(squares, 0.0))
    np.minimum(top, V, out=top)
    squares /= np.maximum(top, np.finfo(float).tiny)
    squares += top
    squares -= both
    squares /= A
    return squares


def alone(D: Array, v0: Array, v1: Array, V: Array | float, A: Array | float) -> Array:
    """Least T in which one axis travels D from v0 to v1."""
    both = v0 + v1
    np.negative(both, out=both, where=D < 0)
    D = np.abs(D)
    late = _late(D, both, v0, v1, V, A)
    T = np.abs(v1 - v0)
    T /= A
    D -= 1e-12
    both /= 2
    both *= T
    return np.maximum(T, late, out=T, where=both < D)


def trapezoid_time(D: ArrayLike, V: ArrayLike, A: ArrayLike) -> Array:
    """Least time from rest to rest over D >= 0; V may be infinite."""
    D, V, A = np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in (D, V, A)))
    with np.errstate(invalid="ignore"):
        return np.where(D * A > V * V, D / V + V / A, 2 * np.sqrt(D / A))


def mean_ramp(up: float, down: float) -> float:
    """The acceleration that takes as long from rest to rest, over any D, as speeding up at one and slowing down at the
    other."""
    return up if up == down else 2 / (1 / up + 1 / down)


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


def fastest_profile(D: float, v0: float, v1: float, V: float, A: float) -> tuple[Array, Array]:
    """Break times (4,) and accelerations (3,) of the fastest profile over D with |v| <= V.

    Full acceleration, if need be top speed, full acceleration the other way (Krotký 2014, eqs. 3.10 to 3.48).
    """
    ramp = (v0 + v1) / 2 * abs(v1 - v0) / A
    squares = (v0 * v0 + v1 * v1) / 2
    border = abs(D - ramp) <= 4 * np.finfo(float).eps * (abs(D) + squares / A)  # one ramp does it
    sign = (1.0 if v0 <= v1 else -1.0) if border else 1.0 if ramp <= D else -1.0
    faster = max(sign * v0, sign * v1)
    top = faster if border else max(float(np.sqrt(max(sign * A * D + squares, 0.0))), faster)
    peak = min(top, V)
    cruise = max(sign * D - (peak * peak - squares) / A, 0.0) / V if top > V else 0.0
    phases = [(peak - sign * v0) / A, cruise, (peak - sign * v1) / A]
    return np.r_[0.0, np.cumsum(phases)], np.array([sign * A, 0.0, -sign * A])


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
