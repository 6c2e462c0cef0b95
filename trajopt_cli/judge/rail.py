"""Where the rail is at a stop, how far it moves in a stretch of time, at least, and where in a rest it stands still for
long enough."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.judge.program_points import ProgramPoint
from trajopt_cli.judge.samples import INNER, Rows, unseen
from trajopt_cli.judge.tolerances import DWELL, HELD, JOINT_TARGET
from trajopt_cli.motion import MoveExtJ

Indices = NDArray[np.intp]


def rail_beside(rows: Rows, at: Indices, point: ProgramPoint) -> tuple[Array, Array]:
    """The rails' positions (m, r) [m] nearest to a point in the half gaps beside rows at (m,), and their grants;
    NaN for one that the point leaves open.

    A rail may run on while the tool stops between two rows. Between them it is off their chord by A h^2/8 at most.
    Where joints or the rail itself are the target every axis stands, and a row shows where.
    """
    r = rows.mechanism.rails
    d, step, most = rows.q[:, :r], rows.doubt_q[:, :r], rows.accelerations.most[:r]
    here, free = d[at], most * rows.open_time[at][:, None] ** 2 / 2
    stands = point.arm is not None or isinstance(point.move, MoveExtJ)
    if rows.marked or stands or point.rail is None:
        return here, JOINT_TARGET + step[at] / 2 + free
    before, after = np.maximum(at - 1, 0), np.minimum(at + 1, len(rows.t) - 1)
    edges = np.stack([here, (here + d[before]) / 2, (here + d[after]) / 2])
    doubt = np.maximum(np.maximum(step[before], step[at]), step[after])
    granted = JOINT_TARGET + doubt / 2 + free
    return np.clip(np.array(point.rail), edges.min(axis=0), edges.max(axis=0)), granted


def rail_positions(rows: Rows, first: int, last: int) -> tuple[Array, Array, Array]:
    """Times (m,), the rails' positions (m, r) and the doubt about them from row first to row last: the rows, and what
    lies between them where that is known."""
    part, r = slice(first, last + 1), rows.mechanism.rails
    t, d = rows.t[part], rows.q[part, :r]
    doubt = rows.doubt_q[part, :r] / 2
    if not rows.exact or last <= first:
        return t, d, doubt
    inner = len(INNER)
    between = slice(first * inner, last * inner)
    t = np.r_[t, rows.hermite_places[0][between]]
    order = np.argsort(t, kind="stable")
    d = np.r_[d, rows.hermite_places[1][between, :r]]
    return t[order], d[order], np.r_[doubt, np.repeat(rows.inner_doubt[first:last, :r], inner, axis=0)][order]


def still_from(rows: Rows, time: float, duration: float, depart: int) -> float:
    """The earliest time [s] in a rest, not before `time`, from which the rail stands still for a duration [s].

    The rest ends with row `depart`. Where the rail never stands for so long, the time from which it moves least; `time`
    itself where the rest is too short.
    """
    slack = DWELL + rows.doubt_t + unseen(rows, depart)
    first = int(np.searchsorted(rows.t, time - slack))
    begins = np.arange(first, depart + 1)
    begins = begins[rows.t[begins] + duration <= rows.t[depart] + slack]
    if not len(begins):
        return time
    t, d, doubt = rail_positions(rows, first, depart)
    # what was begun at a row may have begun up to a gap before it, and ended so much earlier
    ends = rows.t[begins] + duration - 2 * rows.open_time[begins]
    a = np.searchsorted(t, rows.t[begins])
    b = np.maximum(np.searchsorted(t, ends + DWELL + rows.doubt_t, side="right") - 1, a)
    low, high = (-d - doubt).T, (d - doubt).T
    path = np.max([_highest(x, a, b) + _highest(y, a, b) for x, y in zip(high, low, strict=True)], axis=0)
    still = np.flatnonzero(path <= HELD)
    return float(rows.t[begins[still[0] if len(still) else np.argmin(path)]])


def _highest(x: Array, a: Indices, b: Indices) -> Array:
    """The greatest of x[a..b] for every pair (k,): the greater of two stretches of 2^n that cover it."""
    level = np.floor(np.log2(b - a + 1)).astype(int)
    out, longest = np.empty(len(a)), x
    for n in range(int(level.max()) + 1):
        if n:
            longest = np.maximum(longest[: -(1 << n - 1)], longest[1 << n - 1 :])
        here = level == n
        out[here] = np.maximum(longest[a[here]], longest[b[here] + 1 - (1 << n)])
    return out
