"""What rows of a file say about the motion they were taken from, and what they leave open.

Every value here is the least one that a motion through the printed rows can have, so that a legal motion never fails:
a mean speed between rows is not above the speed limit, a second divided difference not above the acceleration limit
(it is a mean of the acceleration with a positive kernel), for any spacing of the rows and any lag.

Printing rounds. A position is off by r/2 at most (r the printed step, which may differ from row to row), so a
difference of two by r, a mean speed over h by r/h, a second divided difference over h1, h2 by
(r/h1 + r/h2) * 2/(h1 + h2), that is 4r/(2h^2) on a grid. A time off by r_t/2 lengthens h by r_t at most and changes a
mean speed c by c r_t/h. A TCP position is off by what r/2 in
every axis does through the Jacobian's columns. These shares are subtracted before anything is called a breach; larger
lags bring the sensitivity back.

Between the rows. Our own files carry speeds and have a row at every boundary and switch: there the cubic Hermite *is*
the motion, and it is judged everywhere. A file on a bare grid has its switches somewhere between the rows; a Hermite
across a switch overshoots although the motion is legal, so only mean values are judged there. Rows tell which: a grid
with extra rows in it is marked, an even grid (or anything else) is not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.accelerations import Accelerations
from trajopt_cli.judge.geometry import lengths
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import Mechanism, mechanism_of
from trajopt_cli.judge.tolerances import COMPUTED, JOINT_TARGET, REST_JOINT
from trajopt_cli.trajectory import Trajectory

LAGS = (1, 2, 4, 8, 16, 32)
INNER = (0.2, 0.4, 0.6, 0.8)
"""Where the Hermite between two rows is looked at, besides its ends."""

TIME_SCALE = 0.03
"""s: joint accelerations on a line change from one limit to the other in no less, between their switches; at 1 kHz it
makes a truncation of 1e-4 of the limit at most (seen on the hinge cell: 9e-5)."""


BLOCK = 64
"""Rows that are left out together where none of them can be at a point; and so many blocks again."""

ROUNDING = 1e-9
"""Of distances [m] and angles [rad] that decide which rows are looked at."""


PIECE = 4096
"""Rows that are worked out together."""

_KEPT = 5  # pieces of one thing that stay at hand
_ROOM = 30_000_000  # bytes of what is dear to work out that stay at hand besides. With 100 MB judging takes as long.
_MOST_WHOLE = 0.4  # share of gaps of a grid that are whole where few rows are beside it
_FEW_WHOLE = 20  # gaps that are whole, of which fewer tell no grid under other rows
_ALL_THERE = 0.98  # of a grid's rows that are there, where many are: a few may be missing
OVERLAP = 2 * LAGS[-1]
"""Rows that windows share, so that every lag is seen from each of their rows."""


class Pieces:
    """Arrays along n rows that are worked out a piece at a time as they are looked at: all of them as a whole would
    take some kB a row. make: of the entries a to b - 1. per: entries for a row. dear: the first ones are kept, as many
    as there is room for: each check goes over all rows, and would find its first piece gone."""

    def __init__(self, n: int, make: Callable[[int, int], tuple[Array, ...]], per: int = 1, dear: bool = False):
        self._n, self._make, self._size = n, make, per * PIECE
        self._kept: dict[int, tuple[Array, ...]] = {}
        self._stay: dict[int, tuple[Array, ...]] = {}
        self._room = _ROOM if dear else 0

    def _piece(self, i: int) -> tuple[Array, ...]:
        if i in self._stay:
            return self._stay[i]
        found = self._kept.pop(i, None)
        if found is None:
            found = self._make(i * self._size, min((i + 1) * self._size, self._n))
            if (size := sum(part.nbytes for part in found)) <= self._room:
                self._stay[i], self._room = found, self._room - size
                return found
        self._kept[i] = found  # the last one looked at is the last to go
        if len(self._kept) > _KEPT:
            del self._kept[next(iter(self._kept))]
        return found

    def part(self, which: int, begin: int, end: int) -> Array:
        """Rows begin to end - 1 of one of the arrays."""
        begin, end = min(begin, self._n), min(end, self._n)
        first = begin // self._size * self._size
        if begin < end <= first + self._size:
            return self._piece(begin // self._size)[which][begin - first : end - first]
        pieces = range(begin // self._size, max(-(-end // self._size), begin // self._size + 1))
        parts = []
        for i in pieces if end > begin else range(1):
            first = i * self._size
            parts.append(self._piece(i)[which][max(begin - first, 0) : max(end - first, 0)])
        return parts[0] if len(parts) == 1 else np.concatenate(parts)

    def whole(self) -> tuple[Array, ...]:
        """All of every array: for those that are small."""
        parts = [self._make(a, min(a + self._size, self._n)) for a in range(0, self._n, self._size)]
        return tuple(np.concatenate(arrays) for arrays in zip(*parts, strict=True))


@dataclass(frozen=True, eq=False)
class Along:
    """One array of pieces, indexed as an array is: by rows first, then by what stands in a row."""

    pieces: Pieces
    which: int = 0

    def __getitem__(self, key: Any) -> Any:
        rows, rest = (key[0], key[1:]) if isinstance(key, tuple) else (key, ())
        if isinstance(rows, slice):
            assert rows.step is None
            found = self.pieces.part(self.which, rows.start or 0, self.pieces._n if rows.stop is None else rows.stop)
        else:
            return self.pieces.part(self.which, int(rows), int(rows) + 1)[(0, *rest)]
        return found[(slice(None), *rest)] if rest else found


def windows(first: int, last: int) -> Iterator[tuple[int, int]]:
    """First and last rows of windows over the rows first to last, OVERLAP of them shared with the next."""
    begins = [*range(first, max(last - OVERLAP, first + 1), PIECE)]
    for a, b in zip(begins, [*begins[1:], last], strict=True):
        yield a, min(b + OVERLAP, last)


@dataclass(frozen=True, eq=False)
class Rows:
    """A file's rows with the doubt about them, and the flange at each.

    step_t (n,) [s], doubt_q, doubt_v (n, k): printed step, never under COMPUTED. marked: a row stands at every boundary
    and switch. gaps (n-1,) [s]: times between rows, those of a standstill no longer than the others: where the speeds
    of both rows are zero and the positions the same, nothing is open however long it lasts.
    doubt_tables: how finely positioners' axes are printed, None where every digit is there.
    """

    plant: Machine
    trajectory: Trajectory
    step_t: Array
    doubt_q: Array
    doubt_v: Array
    marked: bool
    gaps: Array
    doubt_tables: Resolution | None = None

    @cached_property
    def accelerations(self) -> Accelerations:
        """What the axes may have."""
        return Accelerations(self.plant.limits)

    @cached_property
    def doubt_t(self) -> float:
        """The greatest printed step of a time, s."""
        return float(self.step_t.max())

    def unsure(self, a: slice | NDArray[np.intp], b: slice | NDArray[np.intp]) -> Array:
        """How far printing may put the times (m,) between rows a and rows b off, s."""
        return np.asarray((self.step_t[a] + self.step_t[b]) / 2)

    @cached_property
    def longest(self) -> Array:
        """The gaps (n-1,) as long as the digits of their times allow, s."""
        return self.gaps + self.unsure(slice(None, -1), slice(1, None))

    @cached_property
    def open_time(self) -> Array:
        """How far the nearest boundary may be from a row (n,) that shows it, s: half the longest gap beside it; 0 where
        marked."""
        return np.zeros(len(self.t)) if self.marked else both_sides(self.longest[:, None])[:, 0] / 2

    @property
    def tables_step(self) -> tuple[float, float]:
        """The printed step of positioners' angles [rad] and speeds [rad/s], the coarsest of all."""
        if self.doubt_tables is None:
            return COMPUTED, COMPUTED
        return max(float(self.doubt_tables.q.max()), COMPUTED), max(float(self.doubt_tables.qd.max()), COMPUTED)

    @property
    def t(self) -> Array:
        """Times (n,) in s."""
        return self.trajectory.t

    @property
    def q(self) -> Array:
        """Positions (n, k)."""
        return self.trajectory.q

    @property
    def qd(self) -> Array | None:
        """Speeds (n, k) where the file has them."""
        return self.trajectory.qd

    @property
    def exact(self) -> bool:
        """Whether the Hermite between rows is the motion itself."""
        return self.marked and self.qd is not None

    @cached_property
    def mechanism(self) -> Mechanism:
        """What the axes move."""
        return mechanism_of(self.plant)

    @cached_property
    def _flange(self) -> Pieces:
        return Pieces(len(self.t), lambda a, b: self.mechanism.flange(self.q[a:b]), dear=True)

    @property
    def X_WF(self) -> Along:
        """Flange poses (n, 4, 4)."""
        return Along(self._flange)

    @property
    def J(self) -> Along:
        """Flange Jacobians (n, 6, k)."""
        return Along(self._flange, 1)

    @cached_property
    def turning(self) -> Along:
        """Flange accelerations J' qd (n, 6) of the rows' speeds alone, no axis accelerating."""
        assert self.qd is not None
        q, qd = self.q, self.qd

        def make(a: int, b: int) -> tuple[Array]:
            return (self.mechanism.flange_motion(q[a:b], qd[a:b], np.zeros_like(qd[a:b]))[2],)

        return Along(Pieces(len(self.t), make))

    @cached_property
    def _rest(self) -> Pieces:
        """Least speeds of the axes, and whether they are at rest."""

        def make(a: int, b: int) -> tuple[Any, ...]:
            if self.qd is not None:
                least = np.maximum(np.abs(self.qd[a:b]) - self.doubt_v[a:b], 0.0)
            else:
                first = max(a - 1, 0)
                h = np.diff(self.t[first : b + 1])[:, None]
                after = slice(first + 1, min(b + 1, len(self.t)))
                here = slice(first, after.stop - 1)
                c = np.maximum(np.abs(self.q[after] - self.q[here]) - mean_of(self.doubt_q, here, after), 0.0)
                h = h + self.unsure(here, after)[:, None]
                c = np.maximum(c / h - self.accelerations.most * h / 2, 0.0)
                least = both_sides(c)[a - first :][: b - a]
            granted = REST_JOINT + self.accelerations.most * self.open_time[a:b, None]
            return least, np.asarray(least <= granted).all(axis=1)

        return Pieces(len(self.t), make)

    @property
    def least_axis_speed(self) -> Along:
        """Least |speed| (n, k) the axes can have at the rows.

        The printed one, or without speed columns: |mean speed to a neighbour| - A h/2, the larger of both sides.
        """
        return Along(self._rest)

    @cached_property
    def axes_rest(self) -> NDArray[np.bool_]:
        """Rows (n,) where every axis stands, as far as rows show it: one half a gap away may still have A tau."""
        return np.asarray(self._rest.whole()[1])

    @cached_property
    def _between(self) -> Pieces:
        """Of every interval: the mismatch and the doubt about it, the Hermite's rounding, doubt about positions."""
        assert self.qd is not None
        t, q, v = self.t, self.q, self.qd

        def make(a: int, b: int) -> tuple[Array, ...]:
            part = slice(a, b + 1)
            h = np.diff(t[part])[:, None]
            c = np.diff(q[part], axis=0) / h
            e = c - (v[part][1:] + v[part][:-1]) / 2
            before, after = slice(a, b), slice(a + 1, b + 1)
            off_t = self.unsure(before, after)[:, None]
            off_q, off_v = (mean_of(one, before, after) for one in (self.doubt_q, self.doubt_v))
            least = shortest(h, off_t)
            doubt = (off_q + np.abs(c) * off_t) / least + off_v / 2
            speed_change = np.abs(np.diff(v[part], axis=0)) / h
            rounding = 6 * doubt / least + (off_v + speed_change * off_t) / least
            most = np.maximum(np.abs(v[part][1:]), np.abs(v[part][:-1]))
            off_q, off_v = (np.maximum(one[before], one[after]) for one in (self.doubt_q, self.doubt_v))
            inner = off_q / 2 + 8 / 27 * (h * off_v / 2 + most * off_t)
            return e, doubt, rounding, inner

        return Pieces(len(t) - 1, make)

    @property
    def mismatch(self) -> tuple[Along, Along]:
        """Mean speed between rows minus mean of the speeds at its rows, (n-1, k), and the doubt about it."""
        return Along(self._between), Along(self._between, 1)

    @property
    def hermite_rounding(self) -> Along:
        """What printing leaves open about the Hermite's acceleration anywhere between rows, (n-1, k): 6/h of the
        mismatch's doubt and that of (v1 - v0)/h."""
        return Along(self._between, 2)

    @property
    def inner_doubt(self) -> Along:
        """Doubt about axis positions between rows (n-1, k): that of a row, and what doubts about speeds (4/27 h each)
        and about the interval's length add to a Hermite."""
        return Along(self._between, 3)

    @cached_property
    def truncation(self) -> Along:
        """How far the Hermite's acceleration may be from a smooth motion's between rows, (n-1, k).

        It is off by h^2/12 of the motion's fourth derivative at most, which shows as a change of the Hermite's jerk
        (-12 e/h^2) from one interval to the next; the smaller of both sides, because a switch changes it on one side
        only, doubled. It is never more than a motion has whose acceleration takes TIME_SCALE to change: a lone bad row
        is no truncation.
        """
        most = self.accelerations.most / TIME_SCALE**2

        def make(a: int, b: int) -> tuple[Array]:
            first = max(a - 1, 0)
            e, h = self.mismatch[0][first : b + 1], np.diff(self.t[first : b + 2])[:, None]
            jerk = -12 * e / (h * h)
            snap = np.abs(np.diff(jerk, axis=0)) / ((h[1:] + h[:-1]) / 2)
            if not len(snap):
                return (np.zeros_like(e),)
            left, right = np.vstack([snap[:1], snap]), np.vstack([snap, snap[-1:]])
            return ((h * h / 12 * np.minimum(2 * np.minimum(left, right), most))[a - first :][: b - a],)

        return Along(Pieces(len(self.t) - 1, make))

    @cached_property
    def _places(self) -> Pieces:
        assert self.qd is not None
        n, v = len(INNER), self.qd

        def make(a: int, b: int) -> tuple[Array, ...]:
            part = slice(a // n, b // n + 1)
            t, q_rows = self.t[part], self.q[part]
            h, u = np.diff(t)[:, None, None], np.array(INNER)[:, None]
            q_0, path = q_rows[:-1, None], np.diff(q_rows, axis=0)[:, None]
            v_0, v_1 = v[part][:-1, None], v[part][1:, None]
            q = q_0 + u * u * (3 - 2 * u) * path + h * u * (1 - u) * ((1 - u) * v_0 - u * v_1)
            qd = 6 * u * (1 - u) * path / h + (1 - u) * (1 - 3 * u) * v_0 + u * (3 * u - 2) * v_1
            qdd = ((6 - 12 * u) * path / h + (6 * u - 4) * v_0 + (6 * u - 2) * v_1) / h
            times, k = t[:-1, None] + np.array(INNER) * h[:, 0], len(self.trajectory.names)
            return times.ravel(), q.reshape(-1, k), qd.reshape(-1, k), qdd.reshape(-1, k)

        return Pieces(n * (len(self.t) - 1), make, n)

    @property
    def hermite_places(self) -> tuple[Along, Along, Along, Along]:
        """Times (m,) at the INNER places of every interval and the Hermite's q, qd, qdd (m, k) there, in order."""
        return Along(self._places), Along(self._places, 1), Along(self._places, 2), Along(self._places, 3)

    @cached_property
    def blocks(self) -> Blocks:
        """The rows in blocks."""
        return Blocks(len(self.t))

    @cached_property
    def arm_boxes(self) -> Boxes:
        """Around the arm's joints in each block, with what is granted at a stop."""
        tau = self.blocks.most(self.open_time)
        granted = JOINT_TARGET + self.blocks.most(self.doubt_q)[:, -6:] / 2
        granted = granted + (self.accelerations.most * tau[:, None] ** 2 / 2)[:, -6:]
        tight = self.blocks.boxes(self.q[:, -6:], np.zeros(len(tau)))
        return Boxes(tight.low - (granted + ROUNDING), tight.high + (granted + ROUNDING), tight.room)

    @cached_property
    def _motion(self) -> Pieces:
        n = len(INNER)

        def make(a: int, b: int) -> tuple[Array, ...]:
            return self.mechanism.flange_motion(*(places[a:b] for places in self.hermite_places[1:]))

        return Pieces(n * (len(self.t) - 1), make, n, dear=True)

    @property
    def hermite_motion(self) -> tuple[Along, Along, Along]:
        """Flange poses (m, 4, 4), velocities and accelerations (m, 6) at hermite_places."""
        return Along(self._motion), Along(self._motion, 1), Along(self._motion, 2)


@dataclass(frozen=True)
class Blocks:
    """n rows in blocks of BLOCK that follow each other."""

    n: int

    def most(self, x: Array) -> Array:
        """The greatest of x (n, ...) in each block."""
        return np.asarray(np.maximum.reduceat(x, np.arange(0, self.n, BLOCK)))

    def boxes(self, x: Array, room: Array) -> Boxes:
        """Around x (n, d) in each block, with room (b,) about each."""
        return Boxes(-self.most(-x), self.most(x), room)

    def rows(self, wanted: NDArray[np.intp]) -> NDArray[np.intp]:
        """The rows of the blocks wanted (m,)."""
        found = (wanted[:, None] * BLOCK + np.arange(BLOCK)).ravel()
        return found[found < self.n]

    def inside(self, before: int, after: int) -> slice:
        """The blocks wholly between two rows."""
        return slice(before // BLOCK + 1, after // BLOCK)


@dataclass(frozen=True, eq=False)
class Boxes:
    """Boxes from low (b, d) to high, and how far (b,) beyond one still counts as near it."""

    low: Array
    high: Array
    room: Array

    @cached_property
    def _around(self) -> Boxes:
        """Boxes around BLOCK of these each."""
        blocks = Blocks(len(self.low))
        return Boxes(-blocks.most(-self.low), blocks.most(self.high), blocks.most(self.room))

    def off(self, P: Array, these: slice | NDArray[np.intp] = slice(None)) -> Array:
        """Distances of a point P (d,) from these boxes."""
        beside = np.maximum(np.maximum(self.low[these] - P, P - self.high[these]), 0.0)
        return lengths(beside)

    def near(self, P: Array, size: float = 0.0) -> NDArray[np.intp]:
        """The boxes that a point P (d,) is within size and their room of, in order."""
        found = np.arange(len(self.low))
        if len(found) > BLOCK:
            found = Blocks(len(found)).rows(self._around.near(P, size))
        return found[self.off(P, found) <= size + self.room[found]]


def judged_rows(plant: Machine, trajectory: Trajectory, resolution: Resolution | None, marks: int = 1) -> Rows:
    """Rows as the judge uses them; resolution None: every digit is there. marks: how many a marked file has at least,
    one for every move."""
    eps = float(np.finfo(np.float64).eps)
    t = trajectory.t
    k = len(trajectory.names)
    r = resolution or Resolution(0.0, np.zeros(k), np.zeros(k))
    step_t = np.maximum(np.broadcast_to(r.t, t.shape), 4 * eps * float(np.abs(t).max()))
    gaps = np.diff(t)
    still = _standstill(trajectory)
    gaps[still] = np.minimum(gaps, np.median(gaps[~still]) if not still.all() else 0.0)[still]
    doubt = float(np.broadcast_to(r.t, t.shape)[1:-1].max(initial=0.0))
    return Rows(
        plant=plant,
        trajectory=trajectory,
        step_t=step_t,
        doubt_q=np.broadcast_to(np.maximum(r.q, COMPUTED), (len(t), k)),
        doubt_v=np.broadcast_to(np.maximum(r.qd, COMPUTED), (len(t), k)),
        marked=_marked(t, gaps, ~still, doubt, marks),
        gaps=gaps,
        doubt_tables=r.tables,
    )


def _standstill(trajectory: Trajectory) -> NDArray[np.bool_]:
    """Between which rows (n-1,) nothing moves, as both say: without speeds none of them says so."""
    if trajectory.qd is None:
        return np.zeros(len(trajectory.t) - 1, dtype=bool)
    speed = np.abs(trajectory.qd).max(axis=1)
    path = np.maximum(speed[1:], speed[:-1]) * np.diff(trajectory.t)
    return np.asarray((path <= COMPUTED) & (np.abs(np.diff(trajectory.q, axis=0)).max(axis=1) <= COMPUTED))


def unseen(rows: Rows, row: int) -> float:
    """How much longer than its rows a rest may be, s: nearly a gap at both ends. 0 where boundaries have rows."""
    return 4 * float(rows.open_time[row])


def mean_of(steps: Array, a: slice | NDArray[np.intp], b: slice | NDArray[np.intp]) -> Array:
    """How far printing may put differences between rows a and rows b off, where values are printed in these steps."""
    return np.asarray((steps[a] + steps[b]) / 2)


def shortest(h: Array, doubt_t: Array | float) -> Array:
    """The least that intervals printed as h can last, s."""
    return np.asarray(np.maximum(h - doubt_t, COMPUTED))


def both_sides(between: Array) -> Array:
    """Per row the larger of the two values between rows beside it: (n-1, ...) -> (n, ...)."""
    return np.asarray(np.maximum(np.concatenate([between[:1], between]), np.concatenate([between, between[-1:]])))


def second_differences(
    t: Array, x: Array, half: Array, step_t: Array | float, vectors: bool = False
) -> Iterator[tuple[int, Array, Array]]:
    """Per lag m: twice the second divided difference of rows i, i + m, i + 2m and the doubt about it, (n-2m, k).

    x (n, k); half: how far x may be off at each row, broadcast to (n, k). step_t: printed steps of the times (n,).
    vectors: x is one in each row, half (n, 1) and the doubts (n-2m, 1) are lengths.
    """
    half, off = half if vectors else np.broadcast_to(half, x.shape), np.broadcast_to(step_t, t.shape)[:, None] / 2

    def size(values: Array) -> Array:
        return lengths(values)[:, None] if vectors else np.abs(values)

    for m in LAGS:
        if 2 * m < len(t):
            h, off_h = (t[m:] - t[:-m])[:, None], off[m:] + off[:-m]
            rate = (x[m:] - x[:-m]) / h
            open_rate = (half[:-m] + half[m:] + size(rate) * off_h) / shortest(h, off_h)
            both, off_both = h[:-m] + h[m:], off[: -2 * m] + off[2 * m :]
            value, doubt = 2 * (rate[m:] - rate[:-m]) / both, open_rate[:-m] + open_rate[m:]
            yield m, value, (2 * doubt + size(value) * off_both) / shortest(both, off_both)


def _marked(t: Array, gaps: Array, moving: NDArray[np.bool_], doubt_t: float, marks: int) -> bool:
    """A grid with extra rows in it: most gaps are of one length, others shorter, none longer. With so many extra rows
    that few gaps are whole, as our plans have, its own rows are all there.

    gaps (n-1,): where nothing moves no longer than elsewhere; moving (n-1,): where something does. The first and the
    last one do not count: a grid may begin and end anywhere. Rows may be shifted by 1e-5 s, the shortest interval
    of our files.
    """
    inner = gaps[1:-1]
    if not len(inner):
        return False
    grid, off = float(inner.max()), 2e-5 + 2 * doubt_t  # not the median: between near boundaries most gaps are short
    whole, short = inner > grid - off, inner < grid - off - 1e-9 * grid
    if np.sum(short) < max(marks, 1):
        return False
    if np.mean(whole) >= _MOST_WHOLE:
        return True
    if np.sum(whole) < _FEW_WHOLE:
        return False
    step, begins = float(np.median(inner[whole])), t[1:-2]
    ticks = (begins - begins[whole][0]) / step
    own = np.abs(ticks - np.round(ticks)) * step <= off
    wanted = float(np.sum(np.diff(t)[1:-1][moving[1:-1]])) / step
    if len(np.unique(np.round(ticks[own & moving[1:-1]]))) < _ALL_THERE * np.floor(wanted):
        return False
    k = max(2, round(step / float(np.median(inner[short]))))  # other rows of one grid are no boundaries
    on_finer = np.abs(ticks * k - np.round(ticks * k)) * step / k <= off
    return bool(np.mean(on_finer[~own]) < 0.5)
