"""The motions of a log: what lies between two rests."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array, BoolArray

_SLOW = 0.01  # of an axis' highest speed: slower is at rest
_WINDOW = 0.04  # s over which a speed is taken
_REST = 0.1  # s: the shortest rest
_BESIDE = 0.4  # s of rest looked at on either side of a motion


@dataclass(frozen=True, eq=False)
class Recorded:
    """One motion: rows [first, last) of the log with some of the rests around it; t [s], q (n, k). way (k,): from rest
    to rest. moving: rows of the motion itself, [begin, end)."""

    t: Array
    q: Array
    way: Array
    begin: int
    end: int

    def thinned(self, rows: int) -> Recorded:
        """The same in at most about so many rows."""
        k = max(len(self.t) // rows, 1)
        return Recorded(self.t[::k], self.q[::k], self.way, -(-self.begin // k), -(-self.end // k))


def noise_of(q: Array, resting: BoolArray) -> Array:
    """Standard deviation (k,) of the positions at rest, rounding included; at least that of the rounding."""
    out = []
    inside = resting[2:] & resting[1:-1] & resting[:-2]
    for column in q.T:
        steps = np.abs(np.diff(column))
        seen = steps[steps > 1e-12]
        quantum = float(np.min(seen)) if seen.size else 0.0
        bend = (column[2:] - 2 * column[1:-1] + column[:-2])[inside]
        spread = float(np.sqrt(np.mean(bend**2) / 6)) if bend.size else 0.0
        out.append(max(spread, quantum / np.sqrt(12), 1e-9))
    return np.array(out)


def at_rest(t: Array, q: Array) -> BoolArray:
    """Whether no axis moves, by row."""
    half = max(_WINDOW, float(np.median(np.diff(t)))) / 2
    speed = np.empty_like(q)
    for i, column in enumerate(q.T):
        speed[:, i] = np.abs(np.interp(t + half, t, column) - np.interp(t - half, t, column)) / (2 * half)
    top = speed.max(axis=0)
    quiet = np.median(speed, axis=0)  # of a log that mostly rests it is noise
    top = np.where(np.ptp(q, axis=0) > 1e-9, top, np.inf)
    floor = np.minimum(3 * quiet, 0.05 * top)
    return np.asarray(np.all(speed <= np.maximum(_SLOW * top, np.where(floor < 0.03 * top, floor, 0)), axis=1))


def motions_of(t: Array, q: Array) -> tuple[list[Recorded], Array, float]:
    """The motions of a log (n,), (n, k) between rests, in order; the noise (k,), and the share of rows at rest."""
    resting = at_rest(t, q)
    edges = np.flatnonzero(np.diff(np.r_[0, resting.astype(int), 0]))
    rests = [(a, b - 1) for a, b in zip(edges[::2], edges[1::2], strict=True) if t[b - 1] - t[a] >= _REST]
    noise = noise_of(q, resting)
    out = []
    for (a, b), (c, d) in pairwise(rests):
        before = max(a, int(np.searchsorted(t, max(t[b] - _BESIDE, (t[a] + t[b]) / 2))))
        behind = min(d, int(np.searchsorted(t, min(t[c] + _BESIDE, (t[c] + t[d]) / 2), side="right")))
        rows = slice(before, behind + 1)
        # the later half of a rest is nearest to where it settles
        settled = (np.median(q[(first + last) // 2 : last + 1], axis=0) for first, last in ((a, b), (c, d)))
        from_there, to_there = settled
        way = to_there - from_there
        out.append(Recorded(t[rows], q[rows], way, b - before, c - before))
    return out, noise, float(np.mean(resting))
