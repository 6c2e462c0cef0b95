"""Poses that are passed without a stop: whether rows follow a chain of them, in its order, within two tolerances."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.path import StraightPiece
from trajopt_cli.iiwa.judge.samples import Poses, worst
from trajopt_cli.iiwa.judge.tolerances import CAP
from trajopt_cli.judge.findings import finding
from trajopt_cli.motion import Source

_LARGE = 0.1  # rad: a leg that turns less has turn vectors that add up like angles, to a thousandth
_BLOCK = 64  # rows whose turns since the start of a leg are worked out at once


@dataclass(frozen=True, eq=False)
class Followed:
    """Rows first..last along a chain: the first and the last leg (n,) that each may be on, how far it is off [m], [rad]
    (n,). lost: the first row for which the chain has no place, in order and within the tolerances; None where the rows
    reach its end."""

    first: int
    last: int
    leg: NDArray[np.intp]
    ahead: NDArray[np.intp]
    off_p: Array
    off_q: Array
    lost: int | None


def follow(
    chain: list[StraightPiece], rows: Poses, first: int, tolerance: float, turn_tolerance: float, end: Array
) -> Followed:
    """Follow a chain from a row on until its end pose is reached. end (n,): how far each row from first on is from it,
    m plus rad, less what is allowed.

    A row takes the earliest place on the chain, not before that of the row before, from which it is within both
    tolerances: where this fails no other assignment in order does better. How far it is off is reported for the nearest
    place that lies a little ahead of it.
    """
    parts = [_Part.of(leg, turn_tolerance) for leg in chain]
    ways = [one.L_p for one in parts], [one.L_q for one in parts]
    left_p, left_q = ([*np.cumsum(way[::-1])[::-1].tolist(), 0.0] for way in ways)
    turned = _turned(chain, rows, first)
    steps_p, steps_q = ([0.0, *steps[first:].tolist()] for steps in (rows.step_p, rows.step_q))
    near_end, places = (end <= 0).tolist(), rows.p[first:].tolist()
    at, share = 0, 0.0
    found: list[tuple[float, ...]] = []  # of each row: the first and the last leg it may be on, how far off it is

    def followed(lost: int | None, more: int = 0) -> Followed:
        """What was found; more: rows behind, at the end of the last leg."""
        table = np.array([*found, *found[-1:] * more], dtype=np.float64).reshape(-1, 4).T
        (leg, ahead), (off_p, off_q) = table[:2].astype(np.intp), table[2:]
        return Followed(first, first + len(leg) - 1, leg, ahead, off_p, off_q, lost)

    for k, p in enumerate(places):
        i, low = at, share
        while True:
            part = parts[i]
            a, b = part.interval(p, turned(i, k), tolerance)
            a, b = max(low, a), min(1.0, b)
            if a <= b:
                at, share = i, a
                break
            i, low = i + 1, 0.0
            beyond_p = left_p[at] - left_p[i] > parts[at].L_p + 2 * steps_p[k] + 4 * tolerance
            beyond_q = left_q[at] - left_q[i] > parts[at].L_q + 2 * steps_q[k] + 4 * turn_tolerance
            if i == len(parts) or (beyond_p and (beyond_q or not left_q[0])) or (beyond_q and not left_p[0]):
                return followed(first + k)
        best, way, turn = (math.inf, math.inf), 0.0, 0.0
        while i < len(parts) and way <= 3 * tolerance and turn <= 3 * turn_tolerance:
            gone = share if i == at else 0.0
            best = min(best, parts[i].off(p, turned(i, k), gone, tolerance))
            way, turn = way + (1 - gone) * parts[i].L_p, turn + (1 - gone) * parts[i].L_q
            i += 1
        found.append((at, i - 1, *best))
        rest_p, rest_q = left_p[at] - share * parts[at].L_p, left_q[at] - share * parts[at].L_q
        if near_end[k] and rest_p <= 4 * tolerance and rest_q <= 4 * turn_tolerance:
            last = k
            while last + 1 < len(end) and end[last + 1] < end[last]:
                last += 1
            return followed(None, last - k)
    return followed(len(rows.t) - 1)


_Vector = list[float]


@dataclass(frozen=True)
class _Part:
    """A leg in plain numbers: thousands of rows are held against it one by one."""

    p: _Vector
    way: _Vector
    turn: _Vector
    L_p: float
    L_q: float
    turn_tolerance: float

    @classmethod
    def of(cls, leg: StraightPiece, turn_tolerance: float) -> _Part:
        """Turn vectors of a large turn are farther apart than the rotations, by up to the sine's share."""
        if leg.slerp and leg.L_q > _LARGE:
            turn_tolerance *= (leg.L_q / 2) / math.sin(min(leg.L_q, math.pi) / 2)
        return cls(leg.p.tolist(), leg.way.tolist(), leg.turn.tolist(), leg.L_p, leg.L_q, turn_tolerance)

    def interval(self, p: _Vector, turned: _Vector, tolerance: float) -> tuple[float, float]:
        """Shares, from and to, at which the leg is within both tolerances; from > to: none."""
        a, b, _ = _within(self.p, p, self.way, tolerance)
        if a > b:
            return a, b
        a_q, b_q, _ = _within([0.0, 0.0, 0.0], turned, self.turn, self.turn_tolerance)
        return max(a, a_q), min(b, b_q)

    def off(self, p: _Vector, turned: _Vector, low: float, tolerance: float) -> tuple[float, float]:
        """Distance [m] and turn [rad] from the nearest place within both tolerances, not before a share."""
        a, b = self.interval(p, turned, tolerance)
        a, b = max(low, a), min(1.0, b)
        if a > b:
            return math.inf, math.inf
        nearest = _within(self.p, p, self.way, 0.0)[2] if self.L_p else _within([0.0] * 3, turned, self.turn, 0.0)[2]
        s = min(max(nearest, a), b)
        off_p = math.dist([x + s * y for x, y in zip(self.p, self.way, strict=True)], p)
        return off_p, math.dist([s * x for x in self.turn], turned)


def _turned(chain: list[StraightPiece], rows: Poses, first: int) -> Callable[[int, int], _Vector]:
    """How far row first + k has turned since the start of leg i, in the coordinates of the leg's turn."""
    if chain[0].slerp:

        @lru_cache(64)
        def block(i: int, of: int) -> list[_Vector]:
            q = rows.q[first + of * _BLOCK : first + (of + 1) * _BLOCK]
            return list(turns.logarithm(turns.product(turns.conjugate(chain[i].q), q)).tolist())

        return lambda i, k: block(i, k // _BLOCK)[k % _BLOCK]
    angles = (chain[0].angles + chain[0].turned(rows.q[first:])).tolist()
    begins = [leg.angles.tolist() for leg in chain]
    return lambda i, k: [a - b for a, b in zip(angles[k], begins[i], strict=True)]


def _within(begin: _Vector, p: _Vector, way: _Vector, radius: float) -> tuple[float, float, float]:
    """For which shares u begin + u way is within radius of p, from and to (from > to: none), and the nearest."""
    a = [x - y for x, y in zip(begin, p, strict=True)]
    bb = way[0] * way[0] + way[1] * way[1] + way[2] * way[2]
    ab = a[0] * way[0] + a[1] * way[1] + a[2] * way[2]
    aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2]
    if bb == 0:
        return (-math.inf, math.inf, 0.0) if aa <= radius * radius else (math.inf, -math.inf, 0.0)
    nearest = -ab / bb
    room = radius * radius - max(0.0, aa - ab * ab / bb)
    if room < 0:
        return math.inf, -math.inf, nearest
    half = math.sqrt(room / bb)
    return nearest - half, nearest + half, nearest


def check_chain(
    name: str, chain: list[StraightPiece], rows: Poses, found: Followed, passing: tuple[float, float]
) -> Iterator[Finding]:
    """Findings about rows that follow a chain: order, both tolerances, and that it passes every pose within them."""
    source = chain[0].place
    t = rows.t
    lost = 0 if found.lost is None else 1
    yield finding(
        "order of poses", name, lost, 0, "rows", not lost, time=None if found.lost is None else float(t[found.lost]),
        source=source, words="leaves the poses, or their order, by more than the tolerance at",
    )  # fmt: skip
    if not len(found.leg):
        return
    most = max(_Part.of(leg, passing[1]).turn_tolerance for leg in chain)
    offs = (("path", found.off_p, passing[0], "m"), ("orientation", found.off_q, most, "rad"))
    for check, off, limit, unit in offs:
        at, words = t[found.first :], "is off the chain of poses by"
        yield worst(check, name, off, limit, unit, at, limit * CAP, source=source, words=words)
    yield _vertices(name, chain, rows, found, passing[0], source)


def _vertices(
    name: str, chain: list[StraightPiece], rows: Poses, found: Followed, tolerance: float, source: Source
) -> Finding:
    """How far poses are from the straight path between rows, at most. What such a path cuts off a curve is granted: an
    eighth of the greatest change of step."""
    p = rows.p[found.first : found.last + 1]
    steps = np.diff(p, axis=0)
    sag = float(np.linalg.norm(np.diff(steps, axis=0), axis=1).max(initial=0.0)) / 8
    along = np.cumsum([0.0, *(leg.L_p for leg in chain)])
    of_row = along[found.leg]
    farthest, at, legs = 0.0, 0, chain[1 : int(found.leg[-1]) + 1]
    for i, leg in enumerate(legs, start=1):
        # rows on the leg before are counted from its beginning
        begin = max(0, int(np.searchsorted(of_row, along[i - 1] - 4 * tolerance, side="left")) - 1)
        finish = min(len(steps), int(np.searchsorted(of_row, along[i], side="right")) + 2)
        a, b = p[begin:finish], steps[begin:finish]
        w = leg.p - a
        u = np.clip(np.sum(w * b, axis=1) / np.maximum(np.sum(b * b, axis=1), 1e-300), 0.0, 1.0)
        near = np.linalg.norm(w - u[:, None] * b, axis=1)
        if len(near) and near.min() > farthest:
            farthest, at = float(near.min()), begin + int(np.argmin(near))
    limit = tolerance + sag
    passed, time = farthest <= limit, float(rows.t[found.first + at])
    words = "passes a pose at"
    return finding("poses passed", name, farthest, limit, "m", passed, time=time, source=source, words=words)
