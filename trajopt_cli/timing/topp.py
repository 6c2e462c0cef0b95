"""TOPP-RA: time-optimal timing of many given paths at once, in closed form, for limits that hold at rest.

Pham and Pham, "A new approach to time-optimal path parameterization based on reachability analysis", T-RO 2018. With
x = (ds/dt)^2 at the points and u = d2s/dt2 on the intervals, x_{i+1} = x_i + 2 h u, every limit is a row
|p x_{i+1} + r x_i| <= 1. Limits from -1 to 1 hold a pair (x_i, x_{i+1}) as well as its negative; so the rows leave
x_i <= f(x_{i+1}) and x_i >= -f(-x_{i+1}), f(y) = min over rows of (1 - sign(r) p y) / |r|, which is concave. One linear
program per interval, where f is greatest, does not depend on the recursion; the rest is a minimum over rows at a point.
Rows |p y + r x + g| <= 1 with |g| < 1, as gravity makes of torque limits, leave more room on one side: intercepts
1 - g and 1 + g for 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, readonly

_UNBOUND = 1e12  # (ds/dt)^2 that stands for none
_FAINT = 1e-9  # share of its limit below which a row's part of one point is a constant: dividing by it is rounding
_CANCELLED = 1e-14  # of a row's other part, below which a part is what rounding leaves of a difference
_ROUNDING = 1e-9  # relative: rates at the ends may pass what is feasible by this and are then taken as its bound
_LANES = 128  # pieces of paths that are passed side by side
_SHORTEST_LANE = 32  # intervals of one at least
_Lines = tuple[Array, Array]  # intercepts and slopes
_ELEMENTS = 800_000  # of the greatest work arrays; about ten live at once


@dataclass(frozen=True, eq=False)
class TimeLaw:
    """How a path is run: s (n,) and ds/dt there, rates (n,); d2s/dt2 is constant between the points."""

    s: Array
    rates: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "s", readonly(self.s))
        object.__setattr__(self, "rates", readonly(self.rates))

    @cached_property
    def times(self) -> Array:
        """When each point is passed (n,) [s], the first at 0."""
        return readonly(np.r_[0.0, np.cumsum(2 * np.diff(self.s) / (self.rates[1:] + self.rates[:-1]))])

    @property
    def duration(self) -> float:
        """Time from the first point to the last [s]."""
        return float(self.times[-1])

    def slowed(self, factor: float) -> TimeLaw:
        """The same path run in `factor` times the time."""
        return TimeLaw(self.s, self.rates / factor)

    def at(self, times: Array) -> tuple[Array, Array, Array]:
        """s, ds/dt and d2s/dt2 (m,) at times (m,); at a point the last is that of the interval which begins there."""
        t = np.clip(times, 0.0, self.duration)
        i = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, len(self.s) - 2)
        dt, bend = t - self.times[i], np.diff(self.rates**2) / (2 * np.diff(self.s))
        s = self.s[i] + dt * (self.rates[i] + bend[i] * dt / 2)
        return np.minimum(s, self.s[i + 1]), self.rates[i] + bend[i] * dt, bend[i]


@dataclass(frozen=True, eq=False)
class TimeLaws:
    """How B paths are run: s (B, n) and ds/dt there, rates (B, n), NaN for a path that has no timing.

    d2s/dt2 is constant between the points. durations (B,) [s]: inf where there is none or the path is at rest.
    """

    s: Array
    rates: Array
    durations: Array

    def __post_init__(self) -> None:
        for name in ("s", "rates", "durations"):
            object.__setattr__(self, name, readonly(getattr(self, name)))

    def law(self, k: int) -> TimeLaw | None:
        """The time law of path k; None where it has none."""
        return TimeLaw(self.s[k], self.rates[k]) if np.isfinite(self.durations[k]) else None


def fastest_laws(
    s: Array,
    top: Array,
    begins: tuple[Array, ...],
    ends: tuple[Array, ...],
    rate_0: Array | float,
    rate_1: Array | float,
) -> TimeLaws:
    """The time-optimal laws of B paths given by numbers alone, all at once.

    s (B, n) or (n,): each path's parameter at its points, increasing. top (B, n): the greatest ds/dt there, inf for
    none. begins, ends: slopes and bends, both (B, n-1, m), where each interval begins and where it ends: for every
    column |slope d2s/dt2 + bend (ds/dt)^2| <= 1; a column of zeros is none. A third array in both, rests of the same
    shape, says |slope d2s/dt2 + bend (ds/dt)^2 + rest| <= 1; where a rest is 1 or more the path is at rest, and rates
    at the ends must be 0 or inf. rate_0, rate_1: ds/dt at both ends, (B,)
    or one for all; inf for whatever is fastest. Paths do not influence each other: one alone has the same answer.
    Raises ValueError for shapes that differ, s that does not increase, rates below zero, and slopes or bends that are
    not finite.
    """
    top = np.asarray(top, dtype=np.float64)
    s = np.broadcast_to(np.asarray(s, dtype=np.float64), top.shape)
    rows = [np.asarray(x, dtype=np.float64) for x in (*begins[:2], *ends[:2])]
    B, n = top.shape
    for name, x in zip(("begin slopes", "begin bends", "end slopes", "end bends"), rows, strict=True):
        if x.shape != (B, n - 1, rows[0].shape[-1]):
            raise ValueError(f"fastest laws: {name} {x.shape}, wanted ({B}, {n - 1}, {rows[0].shape[-1]})")
        if not np.isfinite(x).all():
            raise ValueError(f"fastest laws: {name} must be finite")
    if n < 2 or not (np.diff(s) > 0).all():
        raise ValueError("fastest laws: wanted two points or more and s that increases")
    rest: Array | None = None
    if len(begins) > 2:
        rest = np.concatenate([np.asarray(begins[2]), np.asarray(ends[2])], axis=-1)
    rates_at_ends = [np.broadcast_to(np.asarray(rate, dtype=np.float64), (B,)) for rate in (rate_0, rate_1)]
    if not all((x >= 0).all() for x in (top, *rates_at_ends)):
        raise ValueError("fastest laws: wanted top, rate_0 and rate_1 of zero or more")
    x_0, x_1 = (rate**2 for rate in rates_at_ends)
    if rest is not None and not all(np.all((x == 0) | np.isinf(x)) for x in (x_0, x_1)):
        raise ValueError("fastest laws: with rests, wanted rate_0 and rate_1 of zero or inf")
    rates, durations = np.empty((B, n)), np.empty(B)
    for part in _parts(B, (n - 1) * 2 * rows[0].shape[-1]):
        step = np.diff(s[part])
        own = None if rest is None else rest[part]
        x = _recursion(step, top[part], [row[part] for row in rows], x_0[part], x_1[part], own)
        rates[part] = np.sqrt(x)
        with np.errstate(divide="ignore"):
            taken = (2 * step / (rates[part, 1:] + rates[part, :-1])).sum(axis=1)
        durations[part] = np.where(np.isnan(taken), np.inf, taken)
    return TimeLaws(s, rates, durations)


def _parts(B: int, elements: int) -> Iterator[slice]:
    """Slices of the B paths that keep a work array of so many elements each in bounds."""
    size = max(1, _ELEMENTS // max(elements, 1))
    return (slice(k, k + size) for k in range(0, B, size))


def _recursion(step: Array, top: Array, rows: list[Array], x_0: Array, x_1: Array, rest: Array | None = None) -> Array:
    """(ds/dt)^2 (B, n) of each path, NaN where there is none; rows: slopes and bends of begins, then of ends; rest:
    those of both."""
    B, n = top.shape
    h = 2 * step[..., None]
    p = np.concatenate([rows[0] / h, rows[2] / h + rows[3]], axis=-1).reshape(B * (n - 1), -1)
    r = np.concatenate([rows[1] - rows[0] / h, -rows[2] / h], axis=-1).reshape(p.shape)
    g: Array | float = 0.0 if rest is None else rest.reshape(p.shape)
    cap = np.minimum(top, np.sqrt(_UNBOUND)) ** 2
    # what the rows of an interval alone leave at its points tells which parts of rows are too faint to divide by
    back = _lines(r, p, g)
    far = _reach(back, back if rest is None else _lines(r, p, -g), cap[:, 1:].ravel())
    at, peak = _peaks(back, far)
    here, there = np.minimum(peak, cap[:, :-1].ravel()), far
    drop, here, there = _faint(p, r, here, there, g)
    cap[:, :-1] = np.minimum(cap[:, :-1], here.reshape(B, -1))
    cap[:, 1:] = np.minimum(cap[:, 1:], there.reshape(B, -1))
    at = at.reshape(B, -1)
    on = _lines(p, r, g)
    for c, m in (back, on):
        np.copyto(c, np.inf, where=drop)
        np.copyto(m, 0.0, where=drop)
    if (lanes := _lanes(B, n - 1)) > 1 and not np.any((x_1 > 0) & np.isfinite(x_1)):
        before, after = ([x.reshape(B, n - 1, -1) for x in lines] for lines in (back, on))
        high = _swept([x[:, ::-1] for x in before], at[:, ::-1], cap[:, ::-1], x_1, lanes)[:, ::-1]
        x = _swept(after, np.full_like(at, np.inf), high, x_0, lanes)
        over = [(ends > of * (1 + _ROUNDING)) & ~np.isinf(ends) for ends, of in ((x_0, high[:, 0]), (x_1, cap[:, -1]))]
        x[np.any(over, axis=0)] = np.nan
        return x
    # points first, paths last: every step of the passes reads one contiguous block
    by_points, by_steps = (
        [np.ascontiguousarray(x.reshape(B, n - 1, -1).transpose(1, 2, 0)) for x in lines] for lines in (back, on)
    )
    at, cap = np.ascontiguousarray(at.T), np.ascontiguousarray(cap.T)
    low, high, fails = _controllable(by_points, at, cap, x_1)
    return _forward(by_steps, low, high, fails, x_0).T


def _lanes(B: int, N: int) -> int:
    """Into how many pieces B paths of N intervals are cut that are passed side by side."""
    return max(1, min(N // _SHORTEST_LANE, _LANES // B))


def _swept(lines: Sequence[Array], at: Array, limit: Array, start: Array, lanes: int) -> Array:
    """v (B, N+1) with v_0 = start and v_{i+1} the least of c + m min(v_i, at_i) over all rows, all within limit.

    lines: c and m, (B, N, rows); at (B, N). Each path is cut into so many lanes. They all begin at their limit, and
    again with what the one before ended with, until that is what they began with: then it is as if they were one.
    """
    B, N, rows = lines[0].shape
    L = -(-N // lanes)
    front = lanes * L - N  # intervals that lead nowhere, before the first
    c, m, top = np.full((B, front + N, rows), np.inf), np.zeros((B, front + N, rows)), np.zeros((B, front + N + 1))
    y = np.zeros((B, front + N))
    c[:, front:], m[:, front:] = lines
    y[:, front:], top[:, front:] = np.maximum(at, 0.0), limit
    top[:, front] = np.minimum(start, limit[:, 0])
    c, m = (np.ascontiguousarray(x.reshape(B * lanes, L, rows).transpose(1, 2, 0)) for x in (c, m))
    y = np.ascontiguousarray(y.reshape(B * lanes, L).T)
    caps = np.ascontiguousarray(top[:, 1:].reshape(B * lanes, L).T)
    v, begins = np.empty((L + 1, B * lanes)), top[:, :-1:L].copy()
    stale: slice | IndexArray = slice(None)
    known = False
    while True:
        v[0, stale] = begins.ravel()[stale]
        for i in range(L):
            now = np.minimum.reduce(c[i][:, stale] + m[i][:, stale] * np.minimum(v[i, stale], y[i, stale]), axis=0)
            now = np.maximum(np.minimum(now, caps[i, stale]), 0.0)
            if known and np.array_equal(now, v[i + 1, stale]):
                break
            v[i + 1, stale] = now
        follows = begins.copy()
        follows[:, 1:] = v[-1].reshape(B, lanes)[:, :-1]
        stale, known, begins = np.flatnonzero(follows != begins), True, follows
        if not len(stale):
            break
    every = np.concatenate([begins[:, :1], v[1:].T.reshape(B, -1)], axis=1)
    return np.ascontiguousarray(every[:, front:])


def _lines(of: Array, other: Array, g: Array | float = 0.0) -> _Lines:
    """What rows |other y + of x + g| <= 1 leave for x: x <= intercept + slope y; inf and 0 where x is not in the row.
    With -g for g it is what they leave for -x at -y."""
    held = np.abs(of) > _CANCELLED * np.abs(other)
    intercept, slope = np.full_like(of, np.inf), np.zeros_like(of)
    np.divide(_room(of, g), np.abs(of), out=intercept, where=held)
    np.divide(np.negative(other), of, out=slope, where=held)
    return intercept, slope


def _room(of: Array, g: Array | float) -> Array | float:
    """What rest g leaves of 1 to a growing x, with its factor in a row; none where g leaves nothing."""
    return 1.0 if isinstance(g, float) else np.maximum(1 - np.sign(of) * g, 0.0)


def _reach(above: _Lines, below: _Lines, far: Array) -> Array:
    """The greatest y, at most far, for which the lines of rows |p y + r x + g| <= 1 leave some x. below: those with -g.

    The room for x, between the least line from above and the greatest from below, is concave; Newton's method from
    beyond its zero ends there.
    """
    (c, m), (d, _) = above, below
    y = far.copy()
    at = np.arange(len(y))
    for _ in range(2 * c.shape[1]):
        slope = m * y[at, None]
        over, under = c + slope, np.subtract(d, slope, out=slope)
        k, up, down = np.arange(len(at)), np.argmin(over, axis=1), np.argmin(under, axis=1)
        on = np.flatnonzero(over[k, up] + under[k, down] < 0)
        if not len(on):
            break
        c, d, m, at, up, down = c[on], d[on], m[on], at[on], up[on], down[on]
        k = np.arange(len(at))
        y[at] = (c[k, up] + d[k, down]) / (m[k, down] - m[k, up])
    return y


def _peaks(lines: _Lines, far: Array) -> tuple[Array, Array]:
    """Where, for y from -far to far, x is greatest under rows |p y + r x + g| <= 1; and this x. far is within _reach.

    The two lines that hold x on either side of the peak meet above it; the line that is lowest there replaces one of
    them, until none is lower: a linear program in as many steps as it has rows at most.
    """
    c, m = lines
    k = np.arange(len(c))
    slope = m * far[:, None]
    left, right = np.argmin(c - slope, axis=1), np.argmin(np.add(c, slope, out=slope), axis=1)
    y = np.where(m[k, left] > 0, far, -far)
    side = np.where(m[k, left] > 0, right, left)
    x = c[k, side] + m[k, side] * y
    at = np.flatnonzero((m[k, left] > 0) & (m[k, right] < 0))
    c, m, left, right = c[at], m[at], left[at], right[at]
    for _ in range(c.shape[1]):
        if not len(at):
            break
        k = np.arange(len(c))
        y[at] = (c[k, right] - c[k, left]) / (m[k, left] - m[k, right])
        values = m * y[at, None]
        values += c
        lowest = np.argmin(values, axis=1)
        x[at], slope = values[k, lowest], m[k, lowest]
        on = (lowest != left) & (lowest != right) & (slope != 0)
        left, right = np.where(slope > 0, lowest, left)[on], np.where(slope < 0, lowest, right)[on]
        c, m, at = c[on], m[on], at[on]
    return y, x


def _faint(p: Array, r: Array, x: Array, y: Array, g: Array | float) -> tuple[BoolArray, Array, Array]:
    """Which rows |p y + r x + g| <= 1 do not need both points, and the greatest x and y with those rows in them.

    A part that stays below _FAINT is taken at its greatest: the row loses that much and is never passed.
    """
    part_x, part_y = np.abs(r) * x[:, None], np.abs(p) * y[:, None]
    faint_x, faint_y = part_x < _FAINT, part_y < _FAINT
    x, y = (_bounded(*one, g) for one in ((x, r, part_y, faint_y & ~faint_x), (y, p, part_x, faint_x & ~faint_y)))
    return faint_x | faint_y, x, y


def _bounded(x: Array, of: Array, part: Array, rows: BoolArray, g: Array | float) -> Array:
    """The greatest x, with factors of, that some rows leave of which the other part is known."""
    if not rows.any():
        return x
    most = np.full_like(of, np.inf)
    np.divide(np.maximum(_room(of, g) - part, 0.0), np.abs(of), out=most, where=rows)
    return np.asarray(np.minimum(x, most.min(axis=1)))


def _controllable(lines: Sequence[Array], at: Array, cap: Array, x_1: Array) -> tuple[Array, Array, Array]:
    """Least and greatest x (n, B) at every point from which the end can be reached with x_1; and which paths fail."""
    c, m = lines
    low, high = np.zeros_like(cap), np.empty_like(cap)
    work = np.empty(c.shape[1:])
    free = np.isinf(x_1)
    fails = (x_1 > cap[-1] * (1 + _ROUNDING)) & ~free
    high[-1] = np.minimum(x_1, cap[-1])
    low[-1] = np.where(free, 0.0, high[-1])
    lifted = bool(low[-1].any())
    for i in range(len(c) - 1, -1, -1):
        np.multiply(m[i], np.minimum(np.maximum(at[i], low[i + 1]), high[i + 1]), out=work)
        work += c[i]
        np.minimum(np.minimum.reduce(work, axis=0), cap[i], out=high[i])
        if lifted:
            # rest can be reached from rest: once the set holds 0 it holds it at all points before
            np.multiply(m[i], np.minimum(np.maximum(at[i], -high[i + 1]), -low[i + 1]), out=work)
            work += c[i]
            np.maximum(-np.minimum.reduce(work, axis=0), 0.0, out=low[i])
            fails |= low[i] > high[i] * (1 + _ROUNDING)
            np.maximum(high[i], 0.0, out=high[i])
            np.minimum(low[i], high[i], out=low[i])
            lifted = bool(low[i].any())
    return low, high, fails


def _forward(lines: Sequence[Array], low: Array, high: Array, fails: Array, x_0: Array) -> Array:
    """The greatest x (n, B) that starts with x_0 and stays controllable; NaN for paths that fail."""
    c, m = lines
    fails = fails | ((x_0 > high[0] * (1 + _ROUNDING)) & ~np.isinf(x_0)) | (x_0 < low[0] * (1 - _ROUNDING))
    work = np.empty(c.shape[1:])
    x = np.empty_like(high)
    x[0] = np.clip(x_0, low[0], high[0])
    for i in range(len(c)):
        np.multiply(m[i], x[i], out=work)
        work += c[i]
        np.minimum(np.minimum.reduce(work, axis=0), high[i + 1], out=x[i + 1])
        np.maximum(x[i + 1], low[i + 1], out=x[i + 1])
    x[:, fails] = np.nan
    return x
