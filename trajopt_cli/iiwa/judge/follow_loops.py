"""Rows followed along a chain of straight legs, one by one. See chain.follow, which says what is looked for.

A leg (m, 16): begin p (3), way (3) [m], turn (3) [rad], their lengths, the turn's tolerance [rad], and what its turns
count from: a rotation (4) with slerp, else three angles. A row: p (3), and a rotation (4) or three angles.
"""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import atan2, inf, sqrt

from numba import njit

_PART = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


@njit(**_PART)
def _within(ax, ay, az, x, y, z, radius):
    """For which shares u of a way x, y, z a place a before it is within radius, from and to (from > to: none), and the
    nearest."""
    bb, ab, aa = x * x + y * y + z * z, ax * x + ay * y + az * z, ax * ax + ay * ay + az * az
    if bb == 0:
        return (-inf, inf, 0.0) if aa <= radius * radius else (inf, -inf, 0.0)
    nearest = -ab / bb
    room = radius * radius - max(0.0, aa - ab * ab / bb)
    if room < 0:
        return inf, -inf, nearest
    half = sqrt(room / bb)
    return nearest - half, nearest + half, nearest


@njit(**_PART)
def _turned(slerp, leg, row):
    """How far a row has turned since a leg's beginning, in the coordinates of its turn."""
    if slerp == 0:
        return row[3] - leg[12], row[4] - leg[13], row[5] - leg[14]
    w, x, y, z = leg[12], -leg[13], -leg[14], -leg[15]
    t, i, j, k = row[3], row[4], row[5], row[6]
    a, b, c, d = (
        w * t - x * i - y * j - z * k,
        w * i + t * x + y * k - z * j,
        w * j + t * y + z * i - x * k,
        w * k + t * z + x * j - y * i,
    )
    sign = -1.0 if a < 0 else 1.0
    sine = sqrt(b * b + c * c + d * d)
    factor = sign * 2 * atan2(sine, sign * a) / sine if sine > 1e-200 else 2.0 * sign
    return factor * b, factor * c, factor * d


@njit(**_PART)
def _interval(leg, row, turn, tolerance):
    """Shares, from and to, at which a leg is within both tolerances of a row; from > to: none. The nearest place."""
    a, b, near = _within(leg[0] - row[0], leg[1] - row[1], leg[2] - row[2], leg[3], leg[4], leg[5], tolerance)
    c, d, near_turn = _within(-turn[0], -turn[1], -turn[2], leg[6], leg[7], leg[8], leg[11])
    if a <= b:
        a, b = max(a, c), min(b, d)
    return a, b, near if leg[9] else near_turn


@njit(
    [
        "void(int64, float64[:,:], float64[:,:], float64[:,:], float64[:], float64[:], float64, float64, float64[:,:],"
        " int64[:])"
    ],
    error_model="numpy",
)
def follow(slerp, legs, rows, steps, near_end, left, tolerance, turn_tolerance, found, state):
    """found (n, 4) of each row: the first and the last leg it may be on, how far off it is [m], [rad]. state (2): how
    many rows that is, and 0 where the chain's end is reached, 1 where a row has no place, 2 where there are no more.

    steps (n, 2): to the row before; near_end (n,): 0 or less where a row is at the end. left (2 m + 2): way and turn
    left behind each leg's beginning.
    """
    m, at, share = len(legs), 0, 0.0
    state[0], state[1] = len(rows), 2
    for k in range(len(rows)):
        i, low = at, share
        while True:
            a, b, _ = _interval(legs[i], rows[k], _turned(slerp, legs[i], rows[k]), tolerance)
            a, b = max(low, a), min(1.0, b)
            if a <= b:
                at, share = i, a
                break
            i, low = i + 1, 0.0
            beyond_p = left[at] - left[i] > legs[at, 9] + 2 * steps[k, 0] + 4 * tolerance
            beyond_q = left[m + 1 + at] - left[m + 1 + i] > legs[at, 10] + 2 * steps[k, 1] + 4 * turn_tolerance
            gone = (beyond_p and (beyond_q or left[m + 1] == 0)) or (beyond_q and left[0] == 0)
            if i == m or gone:
                state[0], state[1] = k, 1
                return
        found[k, 0], found[k, 2], found[k, 3] = at, inf, inf
        i, way, turn = at, 0.0, 0.0
        while i < m and way <= 3 * tolerance and turn <= 3 * turn_tolerance:
            x, y, z = _turned(slerp, legs[i], rows[k])
            a, b, near = _interval(legs[i], rows[k], (x, y, z), tolerance)
            from_share = share if i == at else 0.0
            a, b = max(from_share, a), min(1.0, b)
            if a <= b:
                s, leg, row = min(max(near, a), b), legs[i], rows[k]
                u, v, w = (
                    leg[0] + s * leg[3] - row[0],
                    leg[1] + s * leg[4] - row[1],
                    leg[2] + s * leg[5] - row[2],
                )
                off = sqrt(u * u + v * v + w * w)
                x, y, z = s * leg[6] - x, s * leg[7] - y, s * leg[8] - z
                turned = sqrt(x * x + y * y + z * z)
                if off < found[k, 2] or (off == found[k, 2] and turned < found[k, 3]):
                    found[k, 2], found[k, 3] = off, turned
            way, turn = way + (1 - from_share) * legs[i, 9], turn + (1 - from_share) * legs[i, 10]
            i += 1
        found[k, 1] = i - 1
        rest_p, rest_q = left[at] - share * legs[at, 9], left[m + 1 + at] - share * legs[at, 10]
        if near_end[k] <= 0 and rest_p <= 4 * tolerance and rest_q <= 4 * turn_tolerance:
            state[0], state[1] = k + 1, 0
            return
