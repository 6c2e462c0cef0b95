"""A path without corners near one that has them, and the fastest way along it under bounds on the push.

The parameter is the length travelled, a turn counted by the radius at which it has the inertia of the way. At every
corner the path turns from one slope to the next over 2 tau of its parameter, a parabola: at the corner itself it is tau
|change of slope| / 4 away. tau ends at the middle of the shorter neighbour, and where that distance is the tolerance.

With M x'' + D x' = push, what the push allows at a place and rate of the parameter is an interval of its second
derivative. From every stop backwards, then forwards, the rate is as high as both, the caps and the path's bends allow.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil, inf, sqrt

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.iiwa.controller.feed_path import DosePath

_FEWEST = 16  # pieces of the grid at each side of a corner
_NEAREST = 1e-3  # of a piece of the grid: the place next to a corner, where the rate may be near zero
_SHARP = 1.7  # change of a direction of length one beyond which a corner is stopped at: there is no way round it
_FASTEST, _HALVINGS = 1e3, 60  # rates that are looked at
_RAMP = 4.0  # a rate that grows more than that from one row to the next is a jump and no ramp
_NEAR = 1e-6  # of a squared rate that is found by trying
_TRIES = 12
_SLOWEST = 1e-12  # rate at which a path that has to stand is left
_STRAIGHT = 1e-9  # change of direction below which a row of the path is no corner


@dataclass(frozen=True, eq=False)
class Rounded:
    """Six coordinates along a path whose corners are rounded.

    length (m,): the parameter at the corners, x (m, 6) the coordinates there, row (m,) their rows in path; tau (m,):
    how far before and after each the rounding reaches. along (n,): the parameter at all rows of path; cap (n - 1,): its
    greatest rate [1/s] between them.
    """

    path: DosePath
    length: Array
    x: Array
    row: IndexArray
    tau: Array
    along: Array
    cap: Array

    def corner(self, s: Array) -> IndexArray:
        """The corner (k,) nearest to each parameter s (k,): the one whose rounding may reach there."""
        before = np.clip(np.searchsorted(self.length, s, side="right") - 1, 0, len(self.length) - 2)
        return np.asarray(before + (s - self.length[before] > self.length[before + 1] - s), dtype=np.intp)

    def at(self, s: Array) -> tuple[Array, Array, Array]:
        """Coordinates and their first and second derivative by the parameter, (k, 6) each, at s (k,)."""
        i, slope = self.corner(s), _slopes(self.length, self.x)
        change, tau = np.diff(slope, axis=0, prepend=slope[:1], append=slope[-1:])[i], self.tau[i]
        away = s - self.length[i]
        inside = (np.abs(away) < tau)[:, None]
        over = np.where(inside, tau[:, None], 1.0)
        deep = over - np.abs(away)[:, None]
        bend = np.where(inside, change / (4 * over), 0.0)
        side = slope[np.clip(i - (away < 0), 0, len(slope) - 1)]
        x = self.x[i] + away[:, None] * side + bend * deep**2
        return x, side - 2 * np.sign(away)[:, None] * bend * deep, 2 * bend

    def caps(self, s: Array) -> Array:
        """Greatest rate (k,) [1/s] at s (k,); at a row of the path the mean of a ramp's rates before and after."""
        after = np.clip(np.searchsorted(self.along, s, side="right") - 1, 0, len(self.cap) - 1)
        before = np.clip(np.searchsorted(self.along, s, side="left") - 1, 0, len(self.cap) - 1)
        less, more = np.sort([self.cap[before], self.cap[after]], axis=0)
        return np.asarray(np.where(more > _RAMP * less, less, (less + more) / 2))

    def plain(self, s: Array) -> Array:
        """The coordinates (k, 6) of the path itself at s (k,), corners and all."""
        return np.stack([np.interp(s, self.length, column) for column in self.x.T], axis=1)


def rounded(path: DosePath, tolerance: float, turn_tolerance: float, radius: float, stops: bool = False) -> Rounded:
    """The path with corners that stay within tolerance [m] and turn_tolerance [rad] of it; none where it dwells.

    radius [m]: what a turn by one rad counts as. stops: none at waypoints either, where it is to stand then.
    """
    steps = np.diff(path.pose, axis=0)
    lengths = np.hypot(np.linalg.norm(steps[:, :3], axis=1), radius * np.linalg.norm(steps[:, 3:], axis=1))
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    pace = path.cap * lengths / np.diff(path.s)
    direction = steps / lengths[:, None]
    bends = np.any(np.abs(np.diff(direction, axis=0)) > _STRAIGHT * (1 + np.abs(direction[1:])), axis=1)
    kept = np.concatenate([[True], bends, [True]])
    kept[[leg.last for leg in path.legs]] = True
    row = np.flatnonzero(kept)
    length, x = along[row], path.pose[row]
    change = np.diff(_slopes(length, x), axis=0)
    ways = np.diff(length)
    tau = np.minimum(ways[:-1], ways[1:]) / 2
    for part, most in ((slice(0, 3), tolerance), (slice(3, 6), turn_tolerance)):
        size = np.linalg.norm(change[:, part], axis=1)
        tau = np.minimum(tau, np.divide(4 * most, size, out=np.full(len(size), inf), where=size > 0))
    sharp = np.hypot(np.linalg.norm(change[:, :3], axis=1), radius * np.linalg.norm(change[:, 3:], axis=1)) > _SHARP
    tau = np.concatenate([[0.0], np.where(sharp, 0.0, tau), [0.0]])
    tau[np.searchsorted(row, [leg.last for leg in path.legs if leg.dwell])] = 0.0
    if stops:
        bent = np.concatenate([[False], np.any(np.abs(change) > _STRAIGHT, axis=1), [False]])
        tau[np.isin(row, [leg.last for leg in path.legs]) & bent] = 0.0
    return Rounded(path, length, x, row, tau, along, pace)


def _slopes(length: Array, x: Array) -> Array:
    return np.asarray(np.diff(x, axis=0) / np.diff(length)[:, None])


@dataclass(frozen=True, eq=False)
class Push:
    """||inertia x'' + damping x'|| <= most of the coordinates in part; inertia and damping (3,), or by place (n, 3)."""

    part: slice
    inertia: Array
    damping: Array
    most: float


@dataclass(frozen=True, eq=False)
class Pace:
    """Parameter s (n,) and its rate (n,) [1/s] at times t (n,) [s]; in between the rate is linear in time."""

    s: Array
    rate: Array
    t: Array

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        """Parameter, rate and its derivative (m,) at times t (m,), the ends held."""
        j = np.clip(np.searchsorted(self.t, t, side="right") - 1, 0, len(self.t) - 2)
        rate = self.rate
        over = np.clip(t, 0.0, self.t[-1]) - self.t[j]
        pull = (rate[j + 1] - rate[j]) / (self.t[j + 1] - self.t[j])
        inside = (t >= 0) & (t < self.t[-1])
        s = np.minimum(self.s[j] + rate[j] * over + pull * over**2 / 2, self.s[j + 1])
        return s, np.where(inside, rate[j] + pull * over, 0.0), np.where(inside, pull, 0.0)


def fastest(way: Rounded, pushed: Callable[[Array], Sequence[Push]], pieces: int, h: float) -> Pace:
    """The fastest way along with rest at both ends and where the path dwells, on a grid of so many pieces and more.

    pushed: the bounds at places s (n,).

    A dwell begins a whole number of periods h [s] after the start; the path waits for that, at most h.
    Between two places of the grid the rate's square is linear in s; the push is held for the rates at both.
    """
    s = _grid(way, pieces)
    width = np.diff(s)
    middle = (s[1:] + s[:-1]) / 2
    _, dx, ddx = way.at(middle)
    terms = np.array([_term(push, dx, ddx) for push in pushed(middle)]).reshape(-1, len(width), 7)
    top = _top(terms)
    # by piece, those pushes that a change of the rate changes
    changed = [[tuple(row) for row in rows if row[0]] for rows in terms.swapaxes(0, 1).tolist()]
    most = np.minimum(np.append(top, inf), np.insert(top, 0, inf))
    most = np.minimum(most, way.caps(s) ** 2)
    dwells = [(int(np.searchsorted(s, way.along[leg.last])), leg.dwell) for leg in way.path.legs if leg.dwell]
    most[[node for node, _ in dwells]] = 0.0
    most[np.searchsorted(s, way.length[way.tau == 0])] = 0.0
    rate = np.sqrt(_sweep(most.tolist(), width.tolist(), changed))
    t = np.concatenate([[0.0], np.cumsum(2 * width / np.maximum(rate[1:] + rate[:-1], _SLOWEST))])
    for node, dwell in dwells:
        t[node:] += ceil(t[node] / h - 1e-9) * h - t[node]
        t[node + 1 :] += dwell
    nodes = [node for node, _ in dwells]
    after = [t[node] + dwell for node, dwell in dwells]
    behind = [node + 1 for node in nodes]
    return Pace(np.insert(s, behind, s[nodes]), np.insert(rate, behind, 0.0), np.insert(t, behind, after))


def _grid(way: Rounded, pieces: int) -> Array:
    """Places of s: the path's rows, where corners are rounded, and even ones between."""
    even = np.linspace(0.0, way.length[-1], pieces + 1)
    turns = np.flatnonzero(way.tau > 0)
    wide = turns[way.tau[turns] > even[1]]
    shares = np.linspace(-1, 1, 2 * _FEWEST + 1)
    rounds = (way.length[wide] + shares[:, None] * way.tau[wide]).ravel()
    ends = np.concatenate([way.length[turns] - way.tau[turns], way.length[turns] + way.tau[turns]])
    near = even[1] * np.geomspace(1.0, _NEAREST, 7)
    stops = way.length[way.tau == 0]
    slow = np.clip(np.concatenate([stops + off for off in (*near, *-near)]), 0.0, way.length[-1])
    s = np.unique(np.concatenate([way.along, rounds, ends, even, slow]))
    # what is too near to the place before goes, but for corners
    keep = np.insert(np.diff(s) > 1e-6 * even[1], 0, True)
    keep[np.searchsorted(s, way.length)] = True
    return np.asarray(s[keep])


_Term = tuple[float, float, float, float, float, float, float]
"""Of ||A a + B b + C sqrt(b)||, b the rate's square and a its change, the products AA, AB, AC, BB, 2 BC and CC at one
piece, and the square of the greatest push."""


def _term(push: Push, dx: Array, ddx: Array) -> Array:
    """A _Term (n, 7) by place."""
    A, B, C = push.inertia * dx[:, push.part], push.inertia * ddx[:, push.part], push.damping * dx[:, push.part]
    pairs = ((A, A), (A, B), (A, C), (B, B), (B, 2 * C), (C, C))
    return np.column_stack([*(np.einsum("ij,ij->i", X, Y) for X, Y in pairs), np.full(len(dx), push.most**2)])


def _top(terms: Array) -> Array:
    """Greatest square of the rate at which some change of it keeps all pushes (p, n, 7), by place; inf where nothing is
    bounded."""
    low, high = np.zeros(terms.shape[1]), np.full(terms.shape[1], _FASTEST)
    if not len(terms):
        return np.full(len(low), inf)
    for _ in range(_HALVINGS):
        rate = (low + high) / 2
        least, greatest = np.full(len(rate), -inf), np.full(len(rate), inf)
        for AA, AB, AC, BB, BC_2, CC, limit in np.moveaxis(terms, 2, 1):
            ab = (AB * rate + AC) * rate
            under = ab * ab - AA * (((BB * rate + BC_2) * rate + CC) * rate**2 - limit)
            spread = np.sqrt(np.maximum(under, 0.0))
            ends = [
                np.divide(sense * spread - ab, AA, out=np.full(len(AA), sense * inf), where=AA > 0) for sense in (-1, 1)
            ]
            least, greatest = np.maximum(least, ends[0]), np.minimum(greatest, ends[1])
            greatest = np.where(under < 0, -inf, greatest)
        low, high = np.where(least <= greatest, rate, low), np.where(least <= greatest, high, rate)
    return np.asarray(low**2)


def _sweep(most: list[float], width: list[float], terms: Sequence[Sequence[_Term]]) -> Array:
    """Squares of the rate: backwards what the brakes allow, then forwards what the drive does."""
    square = list(most)
    for j in range(len(width) - 1, -1, -1):
        square[j] = min(square[j], _reached(square[j + 1], width[j], terms[j], -1))
    for j in range(len(width)):
        square[j + 1] = min(square[j + 1], _reached(square[j], width[j], terms[j], 1))
    return np.array(square)


def _reached(b: float, width: float, terms: Sequence[_Term], sense: int) -> float:
    """The greatest square of the rate at the other end of a piece that keeps the pushes; sense: 1 forwards."""
    change = _change(b, terms, sense)
    if change == inf:
        return inf
    high = max(0.0, b + 2 * width * change)
    # the push changes with the rate: held at the other end, too. Between low, which keeps it, and high, which may not.
    beyond = b + 2 * width * _change(high, terms, sense) - high
    if beyond >= -_NEAR * high:
        return high
    low = 0.0
    within = b + 2 * width * _change(low, terms, sense)
    if within <= 0.0:
        return 0.0
    for _ in range(_TRIES):
        middle = low + (high - low) * within / (within - beyond)
        rest = b + 2 * width * _change(middle, terms, sense) - middle
        if rest >= 0.0:
            low, within = middle, rest
            beyond /= 2
        else:
            high, beyond = middle, rest
            within /= 2
        if high - low < _NEAR * high:
            break
    return low


def _change(b: float, terms: Sequence[_Term], sense: int) -> float:
    """The greatest change of the rate at one piece and squared rate b, going forwards or backwards."""
    root = sqrt(b)
    change = inf
    for AA, AB, AC, BB, BC_2, CC, limit in terms:
        ab = AB * b + AC * root
        under = ab * ab - AA * (b * (BB * b + BC_2 * root + CC) - limit)
        here = ((sqrt(under) if under > 0.0 else 0.0) - sense * ab) / AA
        if here < change:
            change = here
    return change
