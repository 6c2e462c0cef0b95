"""Runs with corners or arcs, timed by one profile of the path's parameter from stop to stop.

Every part of a run's path (between two corners or a piece of that, half a corner) has one top speed and one
acceleration (and jerk) that keep all limits everywhere on it. Where two parts meet, the speed is one that both allow
and both can reach. A generator makes the motion in each part from speed to speed. Where a corner begins or ends the
path's curvature jumps, and with it the axes' accelerations: a jerk limit can hold only between these places.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.path_timing.sampled_path import SampledPath
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.study.fixed_rail import StopToStop, use_of
from trajopt_cli.study.rows import SAFE, Piece, apart
from trajopt_cli.trajectories.axes import Axes, AxisLimits

_SHARES = (0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.35, 0.2)  # of the speed that a bend alone would allow: tried for the run
_LONGEST = (1000, 12, 6)  # intervals of the path in a part, tried for the whole run
_SLIVER = 1e-6  # of sigma, which is m of the tool's way in all runs with touching corners
_DENSE = 5  # samples of an interval of the path
_INSIDE = 1e-9  # share of an interval by which a sample keeps from its ends
_REACHED = 0.96  # of a part's way in which a speed must be reached: phases shorter than the rest shrink to nothing
_STEP = 2e-3  # share by which two speeds differ at least, if they do
_SOFTER = 1.7e-3  # less acceleration at a time, until the switches of a part stand apart
_ATTEMPTS = 10
_HALVINGS = 50

# From speed v_0 to v_1 over a way, at most at a speed, an acceleration and, unless None, a jerk: the piece's axes are
# the way alone.
Limit = tuple[float, float, float | None]  # speed, acceleration and jerk of sigma
Drive = Callable[[float, float, float, float, float, float | None], Piece]


@dataclass(frozen=True, eq=False)
class SmoothPath:
    """A sampled path at any place: quintic between its nodes, which keeps position and both derivatives there; and the
    axes q_0, q_1 (k,) at its ends, which its own come near but for rounding."""

    path: SampledPath
    q_0: Array
    q_1: Array

    @classmethod
    def of(cls, run: StopToStop) -> SmoothPath:
        """The path of a run that has one."""
        assert run.path is not None
        return cls(run.path, run.legs[0].q_0, run.legs[-1].q_1)

    @cached_property
    def kept(self) -> IndexArray:
        """The intervals that count: where corners touch, rounding leaves slivers of lines between them, of
        which no derivative is to be had."""
        return np.flatnonzero(np.diff(self.path.sigma) > _SLIVER)

    @cached_property
    def sigma(self) -> Array:
        """The parameter where these intervals meet; slivers belong to the one behind them."""
        return np.concatenate([[0.0], self.path.sigma[self.kept[:-1] + 1], self.path.sigma[-1:]])

    @cached_property
    def _coefficients(self) -> Array:
        """(6, N, k) by the share of each interval."""
        along, first, h = self.path.along, self.path.first[self.kept], np.diff(self.sigma)[:, None]
        share = (self.sigma / self.sigma[-1])[:, None]
        q = np.vstack([along.q[first[:1]], along.q[first + 1]])
        q = q + (self.q_0 - q[0]) * (1 - share) + (self.q_1 - q[-1]) * share
        q_0, q_1 = q[:-1], q[1:]
        c_1, c_2 = h * along.dq[first], h**2 * along.ddq[first] / 2
        a = q_1 - q_0 - c_1 - c_2
        b = h * along.dq[first + 1] - c_1 - 2 * c_2
        c = h**2 * along.ddq[first + 1] - 2 * c_2
        return np.array([q_0, c_1, c_2, 10 * a - 4 * b + c / 2, 7 * b - 15 * a - c, 6 * a - 3 * b + c / 2])

    def at(self, i: IndexArray, u: Array, order: int = 0) -> Array:
        """Axes (m, k), or a derivative of them by sigma, at shares u (m,) of intervals i (m,)."""
        out = np.zeros((len(u), self.path.along.q.shape[1]))
        for power in range(5, order - 1, -1):
            factor = np.prod(np.arange(power, power - order, -1))
            out = out * u[:, None] + factor * self._coefficients[power, i]
        return np.asarray(out / np.diff(self.sigma)[i, None] ** order)

    def places(self, sigma: Array) -> tuple[IndexArray, Array]:
        """Interval and share in it (m,) of places sigma (m,)."""
        grid = self.sigma
        i = np.clip(np.searchsorted(grid, sigma, side="right") - 1, 0, len(grid) - 2)
        return i, np.clip((sigma - grid[i]) / (grid[i + 1] - grid[i]), 0.0, 1.0)

    def axes_at(self, sigma: Array, rate: Array) -> tuple[Array, Array]:
        """Axes and their speeds (m, k) where sigma (m,) grows at a rate (m,)."""
        i, u = self.places(sigma)
        return self.at(i, u), self.at(i, u, 1) * rate[:, None]


@dataclass(frozen=True, eq=False)
class _Part:
    """What limits a part of length `size`: at samples the shares of limits that derivatives by sigma are.

    rate: of speeds. slope, bend: of accelerations; jerk, if limits are given: of the axes' jerks by all three.
    """

    size: float
    rate: float
    slope: Array
    bend: Array
    jerk: tuple[float, float, float] | None

    def limits(self, share: float) -> Limit:
        """Speed, acceleration and jerk of sigma that are allowed at once, the bends using share^2 of accelerations."""
        v = min(1 / self.rate, share / np.sqrt(max(float(self.bend.max()), 1e-300)))
        j = None
        if self.jerk is not None:
            first, _, third = self.jerk
            v = min(v, float(np.cbrt(share**2 / 2 / max(third, 1e-300))))
            j = (1 - share**2) / max(first, 1e-300)
        a = float(np.min((1 - self.bend * v**2) / np.maximum(self.slope, 1e-300)))
        if self.jerk is not None:
            a = min(a, share**2 / 2 / max(3 * self.jerk[1] * v, 1e-300))
        return _stepped(v), a, j


def timed_by_parts(
    axes: Axes, run: StopToStop, caps: AxisLimits, jerk: Array | None, drive: Drive, generator: str
) -> Piece | Infeasible:
    """A run along its path in the time that the program gives it, or why not; the rest as in on_path.

    generator: its name in the refusal.
    """
    piece = on_path(axes, run, caps, jerk, drive)
    leg = run.legs[0]
    if len(run.legs) > 1 or leg.duration is None:
        return piece
    return leg.too_short(generator, piece.duration) or piece.slowed(leg.duration / piece.duration)


def on_path(axes: Axes, run: StopToStop, caps: AxisLimits, jerk: Array | None, drive: Drive) -> Piece:
    """The fastest of the profiles that the shares and lengths in question give. caps: in force on each leg, a row for
    each; infinite for none. jerk (k,): the axes', None where it is free."""
    path = SmoothPath.of(run)
    used = _used(axes, run, path, caps, jerk)
    divided = [_parts(path, used, most) for most in _LONGEST]
    found = [_fastest(path, parts, drive) for parts in ([_whole(divided[0])], *divided)]
    return min([piece for piece in found if apart(piece.switches)] or found, key=lambda piece: piece.duration)


def _whole(parts: Sequence[_Part]) -> _Part:
    """All parts as one."""
    jerks = [part.jerk for part in parts if part.jerk is not None]
    first, second, third = np.max(jerks, axis=0).tolist() if jerks else (0.0, 0.0, 0.0)
    slope, bend = (np.vstack([getattr(part, name) for part in parts]) for name in ("slope", "bend"))
    rate = max(part.rate for part in parts)
    return _Part(sum(part.size for part in parts), rate, slope, bend, (first, second, third) if jerks else None)


def _fastest(path: SmoothPath, parts: Sequence[_Part], drive: Drive) -> Piece:
    tried = [[part.limits(share) for part in parts] for share in _SHARES]
    each = zip(parts, zip(*tried, strict=True), strict=True)
    tried.append([min(limits, key=partial(_alone, part.size)) for part, limits in each])
    found, shortest = list[Piece](), np.inf
    for limits in reversed(tried):  # the last are mostly the fastest; of equals the first of the list
        pieces, duration = _pieces(parts, limits, drive, shortest)
        if duration <= shortest:
            found, shortest = pieces, duration
    return _joined(path, parts, found)


def _alone(way: float, limit: Limit) -> float:
    """How long a way takes from rest to rest, about."""
    v, a, j = limit
    ramps = 0.0 if j is None else a / j
    return ramps + (way / v + v / a if v * v < a * way else 2 * float(np.sqrt(way / a)))


@dataclass(frozen=True, eq=False)
class _Used:
    """What limits a path at _DENSE samples (m,) of every interval, one after the other, as in _Part: rate (m,), slope
    and bend (m, c), and jerk (m, 3) if limits are given."""

    rate: Array
    slope: Array
    bend: Array
    jerk: Array | None


def _used(axes: Axes, run: StopToStop, path: SmoothPath, caps: AxisLimits, jerk: Array | None) -> _Used:
    n = len(path.kept)
    shares = np.clip(np.linspace(0.0, 1.0, _DENSE), _INSIDE, 1 - _INSIDE)
    i, u = np.repeat(np.arange(n), _DENSE), np.tile(shares, n)
    leg = run.number(path.path.leg[path.kept[i]])
    q, dq, ddq, dddq = (path.at(i, u, order) for order in range(4))
    own, use = caps.at(leg), use_of(axes, run.legs, caps, leg, q, dq, ddq)
    a_tcp = np.minimum(own.a_tcp, own.ramps.min(axis=1))
    return _Used(
        np.maximum(use.speed, use.tcp_speed),
        np.column_stack([np.abs(dq) / own.acceleration, use.moving / a_tcp]),
        np.column_stack([np.abs(ddq) / own.acceleration, use.tcp_acceleration]),
        None if jerk is None else np.column_stack([(np.abs(x) / jerk).max(axis=1) for x in (dq, ddq, dddq)]),
    )


def _parts(path: SmoothPath, used: _Used, most: int) -> list[_Part]:
    """The path in parts of so many intervals at most."""
    out = []
    for a, b in pairwise(_cuts(np.unique(path.path.part[path.kept], return_counts=True)[1], most)):
        own, size = slice(a * _DENSE, b * _DENSE), float(path.sigma[b] - path.sigma[a])
        third = None
        if used.jerk is not None:
            first, second, last = (used.jerk[own].max(axis=0) / SAFE).tolist()
            third = first, second, last
        rate = float(used.rate[own].max()) / SAFE
        out.append(_Part(size, rate, used.slope[own] / SAFE, used.bend[own] / SAFE, third))
    return out


def _cuts(counts: IndexArray, most: int) -> list[int]:
    """The intervals at which parts begin, and the end; of so many intervals at most. counts: of the path's parts."""
    out = [0]
    for count in counts:
        pieces = -(-int(count) // most)
        out += [out[-1] + round(int(count) * k / pieces) for k in range(1, pieces + 1)]
    return out


def _pieces(parts: Sequence[_Part], limits: Sequence[Limit], drive: Drive, most: float) -> tuple[list[Piece], float]:
    """The parts' motions and how long they take in all; given up, at infinity, once that is sure to be beyond most."""
    pieces, duration = list[Piece](), 0.0
    least = [part.size / v for part, (v, _, _) in zip(parts, limits, strict=True)]
    left = float(np.sum(least)) * (1 - 1e-9)
    if left > most:
        return [], np.inf
    for part, ends, limit, at_top in zip(parts, pairwise(_speeds(parts, limits)), limits, least, strict=True):
        pieces.append(_apart(drive, part.size, ends, *limit))
        duration, left = duration + pieces[-1].duration, left - at_top
        if duration + left > most:
            return [], np.inf
    return pieces, duration


def _joined(path: SmoothPath, parts: Sequence[_Part], pieces: Sequence[Piece]) -> Piece:
    """The parts' motions one after the other along the path."""
    starts = np.concatenate([[0.0], np.cumsum([piece.duration for piece in pieces])])
    ways = np.concatenate([[0.0], np.cumsum([part.size for part in parts])])
    switches = [start + piece.switches for start, piece in zip(starts, pieces, strict=False)]

    def at(t: Array) -> tuple[Array, Array]:
        sigma, rate = np.empty(len(t)), np.empty(len(t))
        which = np.clip(np.searchsorted(starts, t, side="right") - 1, 0, len(pieces) - 1)
        for k in np.unique(which):
            here = which == k
            s, rate[here] = pieces[k].at(np.clip(t[here] - starts[k], 0.0, pieces[k].duration))
            sigma[here] = ways[k] + s
        return path.axes_at(sigma, rate)

    return Piece(float(starts[-1]), np.unique(np.concatenate(switches)), at)


def _speeds(parts: Sequence[_Part], limits: Sequence[Limit]) -> list[float]:
    """Speeds of sigma where parts meet, at rest at both ends."""
    tops = [v for v, _, _ in limits]
    speeds = [0.0, *map(min, tops, tops[1:]), 0.0]
    for k, (part, limit) in enumerate(zip(parts, limits, strict=True)):
        speeds[k + 1] = min(speeds[k + 1], max(speeds[k], _stepped(_reach(speeds[k], part.size, limit))))
    for k in range(len(parts) - 1, -1, -1):
        speeds[k] = min(speeds[k], max(speeds[k + 1], _stepped(_reach(speeds[k + 1], parts[k].size, limits[k]))))
    return speeds


def _stepped(v: float) -> float:
    """The next lower one of speeds that differ by a share: between two that hardly differ a ramp would be too short for
    rows of its own."""
    return float(np.exp(np.floor(np.log(v) / _STEP + 1e-6) * _STEP)) if v > 0 else 0.0


def _reach(v_0: float, way: float, limit: Limit) -> float:
    """A speed up to the top one that a part reaches from v_0 before its end."""
    top, a, j = limit
    way *= _REACHED
    if j is None:
        return min(max(v_0, top), float(np.sqrt(v_0**2 + 2 * a * way)))

    def ramp(v: float) -> float:
        rise = v - v_0
        time = rise / a + a / j if rise > a * a / j else 2 * np.sqrt(rise / j)
        return float((v_0 + v) / 2 * time)

    low, high = v_0, max(v_0, top)
    if ramp(high) <= way:
        return high
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if ramp(middle) <= way else (low, middle)
    return low


def _apart(drive: Drive, way: float, ends: tuple[float, float], v: float, a: float, j: float | None) -> Piece:
    """A part's motion; a hair softer where two switches would stand too near for rows of their own."""
    first = drive(*ends, way, v, a, j)
    piece = first
    for attempt in range(1, _ATTEMPTS):
        if apart(piece.switches):
            return piece
        softer = 1 - _SOFTER * attempt
        piece = drive(*ends, way, max(v * softer, *ends), a * softer, j)
    return first
