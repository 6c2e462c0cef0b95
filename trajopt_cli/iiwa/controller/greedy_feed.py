"""One period after another along a path, the arm's answer beside it: as far ahead as the lag allows, or as little.

With the equilibrium at P(s) and the arm at p, the bound |P(s) - p| <= b leaves an interval of s on every straight
segment, the roots of a quadratic; where the equilibrium's speed is fed too, so does a bound on the push K (P - p) + D
P'. Eager takes its far end, lazy its near end, never back. A state is safe when lazy steps from it keep the bounds for
ever; lazy steps from a safe state lead to safe states, so a walk that only enters safe states can always go on.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, inf, sqrt
from typing import NamedTuple

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_path import DosePath
from trajopt_cli.iiwa.controller.regulator import Coefficients

Three = tuple[float, float, float]

SLIVER = 1e-10
"""Fraction of a period's way by which one may go too far to end a segment: rounding of s must not cost a row there."""

_INSIDE = 1e-9  # fraction of the bound kept free for rounding
_ROUNDING = 2e-10  # fraction of the squared bound that a standing equilibrium may seem over it by rounding
_WINDOW = 3.0  # slowest time constants until which a free response is lookahead at sample by sample
_LONGEST = 20_000  # rows of that window
_PATIENCE = 400_000  # lazy periods after which a state counts as unsafe
_LOOK = 32  # lazy periods between two looks whether standing still will do, at first
_SPARSE = 16  # of that many rows of the window one is lookahead at first


class State(NamedTuple):
    """Where the equilibrium is (sigma past the start of segment, standing for hold more periods), and the arm."""

    segment: int
    sigma: float
    hold: int
    p: Three
    v: Three
    turn: Three
    w: Three


_state = tuple.__new__  # State(...) sorts its arguments first, which takes as long as a third of a step

_Line = tuple[float, float, float, float, float, float, float, float]
"""Origin and slope of a line, the slope's square, and the square of how far from it the walk may be."""


@dataclass(frozen=True, slots=True)
class _Segment:
    """A straight piece of the path: X(sigma) = origin + slope sigma, 0 <= sigma <= length, d sigma / dt <= cap."""

    length: float
    cap: float
    parts: tuple[tuple[Three, Three], tuple[Three, Three]]  # origin and slope, of the position and of the angles
    full: float  # who would come beyond goes to the end: length less the sliver
    lines: tuple[_Line, ...]  # of what is bounded, in the order of the walk's bounds
    mark: bool  # a waypoint ends it, which must become a row
    hold: int  # periods of standing there


class SpeedFed(NamedTuple):
    """Stiffness K and damping D (6,) of a law that is fed the equilibrium's speed, too, each times its axis' weight.

    most, turn_most: greatest norms of the weighted push K (x_e - x) + D v_e, its first three components and its last;
    None where there is no bound.
    """

    K: Array
    D: Array
    most: float | None
    turn_most: float | None


class Walk:
    """A path walked greedily with period h [s]. axes: coefficients of the controller's law for the six coordinates.

    bound [m] and turn_bound [rad], or None: greatest norms of the lag of position and angles. fed: None where the
    controller is fed positions alone.
    """

    def __init__(
        self,
        path: DosePath,
        h: float,
        axes: Sequence[Coefficients],
        bound: float,
        turn_bound: float | None,
        fed: SpeedFed | None = None,
    ) -> None:
        self.path, self.h = path, h
        self.lookahead = 0  # lazy periods that unsafe_after has walked so far
        self._square = (bound * (1 - _INSIDE)) ** 2
        self._turn_square = None if turn_bound is None else (turn_bound * (1 - _INSIDE)) ** 2
        self._axes = tuple((a, b, p, q) for a, b, _, p, q, _ in axes)
        self._fed = None if fed is None else _Fed(fed, self._axes, h)
        self._bounds = _bounds(self._square, self._turn_square, self._fed)
        self._turns = any(bound.turn for bound in self._bounds)
        self._segments = _segments(path, h, self._bounds)
        self._length = len(self._segments)
        self._moved, self._turned = self._axes[:3], self._axes[3:6]
        last = path.pose[-1].tolist()
        self._end: tuple[Three, Three] = (_three(last[:3]), _three(last[3:]))
        moves = moving_axes(path)
        self._rest = _Rest(self._axes[:3], moves[:3])
        self._turn_rest = None if turn_bound is None else _Rest(self._axes[3:], moves[3:])

    def start(self) -> State:
        """Arm and equilibrium at rest in the first pose."""
        first = self.path.pose[0].tolist()
        still = (0.0, 0.0, 0.0)
        hold = sum(_periods(leg.dwell, self.h) for leg in self.path.legs if leg.last == 0)
        return State(0, 0.0, hold, _three(first[:3]), still, _three(first[3:]), still)

    def done(self, state: State) -> bool:
        """Whether the equilibrium is in the last pose and has stood there for as long as it should."""
        return state.segment == self._length and state.hold == 0

    def s(self, state: State) -> float:
        """The path parameter."""
        return float(self.path.s[state.segment]) + state.sigma

    def step(self, state: State, eagerness: float) -> State | None:
        """The next period's state; eagerness 0 goes on as little as the bounds demand, 1 as far as they allow.

        None where no equilibrium ahead within reach keeps the bounds.
        """
        i, sigma, hold, x, v, turn, w = state
        p_e = self._place(i, sigma, 0)
        p, v = _answer(self._moved, x, v, p_e)
        before = turn_e = turn
        if self._turns:
            turn_e = self._place(i, sigma, 1)
            turn, w = _answer(self._turned, turn, w, turn_e)
        if hold or i == self._length:
            if not self._near(p, p_e, turn, turn_e):
                return None
            return _state(State, (i, sigma, max(0, hold - 1), p, v, turn, w))
        if eagerness == 0.0 and self._near(p, p_e, turn, turn_e, 1.0):
            return _state(State, (i, sigma, 0, p, v, turn, w))  # what _reach would find, in a fraction of its time
        fed = self._fed
        centres = [p] if self._turn_square is None else [p, turn]
        if fed is not None:
            centres = fed.centres(self._bounds, (p, turn), (x, before), (p_e, turn_e))
        low, high = self._reach(i, sigma, centres, eagerness == 0.0)
        if low is None or high is None:
            # an arm that passes the path at the bound itself may miss it by rounding
            return State(i, sigma, 0, p, v, turn, w) if self._near(p, p_e, turn, turn_e) else None
        i, sigma = high if eagerness == 1.0 else low if eagerness == 0.0 else self._between(low, high, eagerness)
        if fed is not None:
            p, v = _carried(fed.way[0], fed.rate[0], p, v, p_e, self._place(i, sigma, 0))
            if self._turns:
                turn, w = _carried(fed.way[1], fed.rate[1], turn, w, turn_e, self._place(i, sigma, 1))
        segment = self._segments[i]
        if sigma >= segment.length:
            return _state(State, (i + 1, 0.0, segment.hold, p, v, turn, w))
        return _state(State, (i, sigma, 0, p, v, turn, w))

    def run(self, state: State, periods: int, eagerness: float) -> list[State]:
        """The states after each of so many periods; fewer where the path ends, or where the bound would break."""
        out: list[State] = []
        for _ in range(periods):
            if self.done(state):
                break
            following = self.step(state, eagerness)
            if following is None:
                break
            out.append(following)
            state = following
        return out

    def unsafe_after(self, state: State) -> float:
        """inf for a safe state; else how many lazy periods it takes until the bound breaks."""
        look = 0
        for k in range(_PATIENCE):
            if k == look:
                if self._may_stand(state):
                    self.lookahead += k
                    return inf
                look += max(_LOOK, k // 4)
            following = self.step(state, 0.0)
            if following is None:
                self.lookahead += k
                return k
            state = following
        self.lookahead += _PATIENCE
        return _PATIENCE

    def _place(self, i: int, sigma: float, part: int) -> Three:
        """Of the equilibrium: part 0 its position, part 1 its angles."""
        if i == self._length:
            return self._end[part]
        (x, y, z), (dx, dy, dz) = self._segments[i].parts[part]
        return x + sigma * dx, y + sigma * dy, z + sigma * dz

    def _near(self, p: Three, p_e: Three, turn: Three, turn_e: Three, ease: float = 1 + _ROUNDING) -> bool:
        far = (p[0] - p_e[0]) ** 2 + (p[1] - p_e[1]) ** 2 + (p[2] - p_e[2]) ** 2
        if far > self._square * ease:
            return False
        if self._turn_square is None:
            return True
        far = (turn[0] - turn_e[0]) ** 2 + (turn[1] - turn_e[1]) ** 2 + (turn[2] - turn_e[2]) ** 2
        return far <= self._turn_square * ease

    def _reach(
        self, i: int, sigma: float, centres: Sequence[Three], nearest: bool
    ) -> tuple[tuple[int, float] | None, tuple[int, float] | None]:
        """Nearest and farthest places of the first run of places within reach that keep all bounds about centres.

        nearest: the first alone will do, and the second may be anywhere in that run.
        """
        low = high = None
        time = self.h
        while True:
            segment = self._segments[i]
            reach = sigma + segment.cap * time
            if reach > segment.full:
                reach = segment.length
            near, far = sigma, reach
            for line, centre in zip(segment.lines, centres, strict=True):
                near, far = _within(line, centre, near, far)
                if near > far:
                    break
            if near <= far:
                if low is None:
                    low = (i, near)
                high = (i, far)
            if (low is not None and (nearest or far < reach)) or reach < segment.length or segment.mark:
                return low, high
            time = max(0.0, time - (segment.length - sigma) / segment.cap)
            i, sigma = i + 1, 0.0

    def _between(self, low: tuple[int, float], high: tuple[int, float], fraction: float) -> tuple[int, float]:
        """The place a fraction of the distance from low to high."""
        lengths = [self._segments[i].length for i in range(low[0], high[0])]
        sigma = low[1] + fraction * (sum(lengths) + high[1] - low[1])
        for i, length in enumerate(lengths, low[0]):
            if sigma < length:
                return i, sigma
            sigma -= length
        return high[0], min(sigma, high[1])

    def _may_stand(self, state: State) -> bool:
        """Whether the bound holds for ever if the equilibrium stays where it is."""
        p_e = self._place(state.segment, state.sigma, 0)
        if not self._rest.keeps(state.p, p_e, state.v, self._square * (1 + _ROUNDING / 2)):
            return False
        if self._turn_rest is None or self._turn_square is None:
            return True
        turn_e = self._place(state.segment, state.sigma, 1)
        return self._turn_rest.keeps(state.turn, turn_e, state.w, self._turn_square * (1 + _ROUNDING / 2))


class _Bound(NamedTuple):
    """||scale place - centre||^2 <= square for the place (3,) of the equilibrium, or of its turn; push or lag."""

    turn: bool
    push: bool
    scale: Three
    square: float


class _Fed:
    """What feeding the speed (u' - u) / h adds in one period: way (u' - u) to the arm, rate (u' - u) to its speed."""

    def __init__(self, fed: SpeedFed, axes: Sequence[tuple[float, float, float, float]], h: float) -> None:
        ways, rates = [(h - p) / h for _, _, p, _ in axes], [(1 - a) / h for a, _, _, _ in axes]
        self.way = (_three(ways[:3]), _three(ways[3:]))
        self.rate = (_three(rates[:3]), _three(rates[3:]))
        self.K = (_three(fed.K[:3].tolist()), _three(fed.K[3:].tolist()))
        self.D = (_three((fed.D[:3] / h).tolist()), _three((fed.D[3:] / h).tolist()))
        self.most = (fed.most, fed.turn_most)

    def centres(
        self,
        bounds: Sequence[_Bound],
        arm: tuple[Three, Three],
        before: tuple[Three, Three],
        place: tuple[Three, Three],
    ) -> list[Three]:
        """Of every bound; arm: one period on without the speed, before: now, place: of the equilibrium now."""
        out = []
        for bound in bounds:
            u, x = place[bound.turn], arm[bound.turn]
            if bound.push:
                k, x = self.K[bound.turn], before[bound.turn]
                d = bound.scale
                out.append(
                    (
                        d[0] * u[0] - k[0] * (u[0] - x[0]),
                        d[1] * u[1] - k[1] * (u[1] - x[1]),
                        d[2] * u[2] - k[2] * (u[2] - x[2]),
                    )
                )
            else:
                g = self.way[bound.turn]
                out.append((x[0] - g[0] * u[0], x[1] - g[1] * u[1], x[2] - g[2] * u[2]))
        return out


def _bounds(square: float, turn_square: float | None, fed: _Fed | None) -> tuple[_Bound, ...]:
    """The lag of position and turn, then the push of both, as far as they are bounded."""
    out = []
    for turn, most in ((False, square), (True, turn_square)):
        if most is not None:
            g = (0.0, 0.0, 0.0) if fed is None else fed.way[turn]
            out.append(_Bound(turn, False, (1 - g[0], 1 - g[1], 1 - g[2]), most))
    for turn in (False, True):
        greatest = None if fed is None else fed.most[turn]
        if fed is not None and greatest is not None:
            out.append(_Bound(turn, True, fed.D[turn], (greatest * (1 - _INSIDE)) ** 2))
    return tuple(out)


def _carried(way: Three, rate: Three, x: Three, v: Three, here: Three, there: Three) -> tuple[Three, Three]:
    """The arm with the speed from here to there fed."""
    u0, u1, u2 = there[0] - here[0], there[1] - here[1], there[2] - here[2]
    return (
        (x[0] + way[0] * u0, x[1] + way[1] * u1, x[2] + way[2] * u2),
        (v[0] + rate[0] * u0, v[1] + rate[1] * u1, v[2] + rate[2] * u2),
    )


class _Rest:
    """Free responses of three axes: e_n = phi_n e + psi_n v for n = 0, 1, ..., and what holds after the window.

    An axis along which the path never moves (moves is False) has no deviation at any time.
    """

    def __init__(self, axes: Sequence[tuple[float, float, float, float]], moves: Sequence[bool]) -> None:
        single = [
            np.array([[1 + q, p], [b, a]]) if there else np.zeros((2, 2))
            for (a, b, p, q), there in zip(axes, moves, strict=True)
        ]
        rows = min(_LONGEST, ceil(_WINDOW * max(_memory(A) for A in single)) + 2)
        window = np.stack([_powers(A, rows) for A in single])
        self._e = np.ascontiguousarray(window[:, 0::2])
        self._sparse = np.ascontiguousarray(self._e[:, ::_SPARSE])
        self._last = window[:, -2:].copy()
        self._after = [_peaks(A) for A in single]

    def keeps(self, x: Three, x_e: Three, v: Three, square: float) -> bool:
        """Whether ||e_n||^2 <= square for every n, from deviation x - x_e and speed v."""
        e = (x[0] - x_e[0], x[1] - x_e[1], x[2] - x_e[2])
        if self._bounded(e, v) <= square:
            return True
        start = np.array([[[e[0]], [v[0]]], [[e[1]], [v[1]]], [[e[2]], [v[2]]]])
        for rows in (self._sparse, self._e):
            e_n = (rows @ start)[:, :, 0]
            if float(np.max(np.einsum("in,in->n", e_n, e_n))) > square:
                return False
        last = (self._last @ start)[:, :, 0].tolist()
        e, v = (last[0][0], last[1][0], last[2][0]), (last[0][1], last[1][1], last[2][1])
        return self._bounded(e, v) <= square

    def _bounded(self, e: Three, v: Three) -> float:
        """A bound of ||e_n||^2 over all n."""
        return sum((G * abs(a) + H * abs(b)) ** 2 for (G, H), a, b in zip(self._after, e, v, strict=True))


def moving_axes(path: DosePath) -> tuple[bool, ...]:
    """Along which of the six coordinates the path moves at all."""
    return tuple(bool(np.any(column != column[0])) for column in path.pose.T)


def _answer(axes: Sequence[tuple[float, float, float, float]], x: Three, v: Three, x_e: Three) -> tuple[Three, Three]:
    """The arm one period later, of three axes without force."""
    (a0, b0, p0, q0), (a1, b1, p1, q1), (a2, b2, p2, q2) = axes
    x0, x1, x2 = x
    v0, v1, v2 = v
    e0, e1, e2 = x0 - x_e[0], x1 - x_e[1], x2 - x_e[2]
    return (
        (x0 + p0 * v0 + q0 * e0, x1 + p1 * v1 + q1 * e1, x2 + p2 * v2 + q2 * e2),
        (a0 * v0 + b0 * e0, a1 * v1 + b1 * e1, a2 * v2 + b2 * e2),
    )


def _within(line: _Line, x: Three, low: float, high: float) -> tuple[float, float]:
    """The part of [low, high] where ||origin + slope sigma - x||^2 <= square; empty as (inf, -inf)."""
    o0, o1, o2, d0, d1, d2, A, square = line
    r0, r1, r2 = x[0] - o0, x[1] - o1, x[2] - o2
    C = r0 * r0 + r1 * r1 + r2 * r2 - square
    if A == 0.0:
        return (low, high) if square * _ROUNDING >= C else (inf, -inf)
    B = d0 * r0 + d1 * r1 + d2 * r2
    under = B * B - A * C
    if under < 0.0:
        return inf, -inf
    root = sqrt(under)
    first, last = (B - root) / A, (B + root) / A
    if first > low:
        low = first
    if last < high:
        high = last
    return (low, high) if low <= high else (inf, -inf)


def _segments(path: DosePath, h: float, bounds: Sequence[_Bound]) -> list[_Segment]:
    marks = {leg.last for leg in path.legs}
    holds: dict[int, int] = {}
    for leg in path.legs:
        if leg.dwell:
            holds[leg.last] = holds.get(leg.last, 0) + _periods(leg.dwell, h)
    ds = np.diff(path.s)
    slopes = (np.diff(path.pose, axis=0) / ds[:, None]).tolist()
    out = []
    rows = zip(ds.tolist(), path.cap.tolist(), path.pose[:-1].tolist(), slopes, strict=True)
    for row, (length, cap, pose, slope) in enumerate(rows, 1):
        parts = ((_three(pose[:3]), _three(slope[:3])), (_three(pose[3:]), _three(slope[3:])))
        lines = tuple(_line(one, *parts[one.turn]) for one in bounds)
        full = length - SLIVER * cap * h
        out.append(_Segment(length, cap, parts, full, lines, row in marks, holds.get(row, 0)))
    return out


def _line(bound: _Bound, origin: Three, slope: Three) -> _Line:
    d = _times(bound.scale, slope)
    return (*_times(bound.scale, origin), *d, d[0] * d[0] + d[1] * d[1] + d[2] * d[2], bound.square)


def _periods(seconds: float, h: float) -> int:
    """A dwell in whole periods, as the equilibrium had it."""
    return round(seconds / h)


def _memory(A: Array) -> float:
    """Time constant of A^n in periods."""
    radius = float(np.max(np.abs(np.linalg.eigvals(A))))
    return 0.0 if radius >= 1 or radius == 0 else -1 / float(np.log(radius))


def _powers(A: Array, rows: int) -> Array:
    """The matrices A^0 .. A^(rows - 1) under one another, (2 rows, 2)."""
    out = np.empty((rows, 2, 2))
    out[0] = np.eye(2)
    filled = 1
    while filled < rows:  # doubling: A^(filled + j) = A^filled A^j
        more = min(filled, rows - filled)
        out[filled : filled + more] = (A @ out[filled - 1]) @ out[:more]
        filled += more
    return out.reshape(2 * rows, 2)


def _peaks(A: Array) -> tuple[float, float]:
    """G, H with |e_n| <= G |e_0| + H |v_0| for all n, of an axis that comes to rest; H in s."""
    rows = 64
    while True:
        powers = _powers(A, rows).reshape(rows, 2, 2)
        G, H = float(np.max(np.abs(powers[:, 0, 0]))), float(np.max(np.abs(powers[:, 0, 1])))
        if H == 0.0:
            return G, H
        # e in units of G and v of G / H: once a block of rows is a contraction there that makes up for the largest
        # power before it, no later power is beyond G and H.
        scaled = np.abs(powers) * np.array([[1.0, G / H], [H / G, 1.0]])
        sums = np.sum(scaled, axis=2)
        if float(np.max(sums[-1])) * float(np.max(sums)) <= 1.0:
            return G, H
        rows *= 2


def _times(scale: Three, x: Three) -> Three:
    return (scale[0] * x[0], scale[1] * x[1], scale[2] * x[2])


def _three(values: Sequence[float]) -> Three:
    x, y, z = values
    return (x, y, z)
