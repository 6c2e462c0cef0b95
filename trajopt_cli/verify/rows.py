"""What rows of a file say about the motion they were taken from, and what they leave open.

Every value here is the least one that a motion through the printed rows can have, so that a legal motion never fails:
a mean speed between rows is not above the speed limit, a second divided difference not above the acceleration limit
(it is a mean of the acceleration with a positive kernel), for any spacing of the rows and any lag.

Printing rounds. A position is off by r/2 at most (r the printed step), so a difference of two by r, a mean speed over
h by r/h, a second divided difference over h1, h2 by (r/h1 + r/h2) * 2/(h1 + h2), that is 4r/(2h^2) on a grid. A time
off by r_t/2 lengthens h by r_t at most and changes a mean speed c by c r_t/h. A TCP position is off by what r/2 in
every axis does through the Jacobian's columns. These shares are subtracted before anything is called a breach; larger
lags bring the sensitivity back.

Between the rows. Our own files carry speeds and have a row at every boundary and switch: there the cubic Hermite *is*
the motion, and it is judged everywhere. A file on a bare grid has its switches somewhere between the rows; a Hermite
across a switch overshoots although the motion is legal, so only mean values are judged there. Rows tell which: a grid
with extra rows in it is marked, an even grid (or anything else) is not.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.verify.machine import Machine
from trajopt_cli.verify.mechanism import Mechanism, mechanism_of
from trajopt_cli.verify.tolerances import COMPUTED, JOINT_TARGET, REST_JOINT

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


@dataclass(frozen=True, eq=False)
class Rows:
    """A file's rows with the doubt about them, and the flange at each.

    doubt_t [s], doubt_q, doubt_v (k,): printed step, never under COMPUTED. marked: a row stands at every boundary and
    switch. gaps (n-1,) [s]: times between rows, those of a standstill no longer than the others: where the speeds of
    both rows are zero and the positions the same, nothing is open however long it lasts. open_time (n,) [s]: how far
    the nearest boundary may be from a row that shows it, half the gap beside it; 0 where marked.
    """

    plant: Machine
    trajectory: Trajectory
    doubt_t: float
    doubt_q: Array
    doubt_v: Array
    marked: bool
    gaps: Array
    open_time: Array

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
    def _flange(self) -> tuple[Array, Array]:
        return self.mechanism.flange(self.q)

    @property
    def X_WF(self) -> Array:
        """Flange poses (n, 4, 4)."""
        return self._flange[0]

    @property
    def J(self) -> Array:
        """Flange Jacobians (n, 6, k)."""
        return self._flange[1]

    @cached_property
    def turning(self) -> Array:
        """Flange accelerations J' qd (n, 6) of the rows' speeds alone, no axis accelerating."""
        assert self.qd is not None
        return self.mechanism.flange_motion(self.q, self.qd, np.zeros_like(self.qd))[2]

    @cached_property
    def least_axis_speed(self) -> Array:
        """Least |speed| (n, k) the axes can have at the rows.

        The printed one, or without speed columns: |mean speed to a neighbour| - A h/2, the larger of both sides.
        """
        if self.qd is not None:
            return np.asarray(np.maximum(np.abs(self.qd) - self.doubt_v, 0.0))
        h = np.diff(self.t)[:, None]
        c = np.maximum(np.abs(np.diff(self.q, axis=0)) - self.doubt_q, 0.0) / (h + self.doubt_t)
        return both_sides(np.maximum(c - self.plant.limits.acceleration * h / 2, 0.0))

    @cached_property
    def axes_rest(self) -> NDArray[np.bool_]:
        """Rows (n,) where every axis stands, as far as rows show it: one half a gap away may still have A tau."""
        granted = REST_JOINT + self.plant.limits.acceleration * self.open_time[:, None]
        return np.asarray((self.least_axis_speed <= granted).all(axis=1))

    @cached_property
    def mismatch(self) -> tuple[Array, Array]:
        """Mean speed between rows minus mean of the speeds at its rows, (n-1, k), and the doubt about it."""
        assert self.qd is not None
        h = np.diff(self.t)[:, None]
        c = np.diff(self.q, axis=0) / h
        e = c - (self.qd[1:] + self.qd[:-1]) / 2
        least = shortest(h, self.doubt_t)
        return e, (self.doubt_q + np.abs(c) * self.doubt_t) / least + self.doubt_v / 2

    @cached_property
    def hermite_rounding(self) -> Array:
        """What printing leaves open about the Hermite's acceleration anywhere between rows, (n-1, k): 6/h of the
        mismatch's doubt and that of (v1 - v0)/h."""
        assert self.qd is not None
        h = np.diff(self.t)[:, None]
        least = shortest(h, self.doubt_t)
        speed_change = np.abs(np.diff(self.qd, axis=0)) / h
        return np.asarray(6 * self.mismatch[1] / least + (self.doubt_v + speed_change * self.doubt_t) / least)

    @cached_property
    def truncation(self) -> Array:
        """How far the Hermite's acceleration may be from a smooth motion's between rows, (n-1, k).

        It is off by h^2/12 of the motion's fourth derivative at most, which shows as a change of the Hermite's jerk
        (-12 e/h^2) from one interval to the next; the smaller of both sides, because a switch changes it on one side
        only, doubled. It is never more than a motion has whose acceleration takes TIME_SCALE to change: a lone bad row
        is no truncation.
        """
        e, h = self.mismatch[0], np.diff(self.t)[:, None]
        jerk = -12 * e / (h * h)
        snap = np.abs(np.diff(jerk, axis=0)) / ((h[1:] + h[:-1]) / 2)
        if not len(snap):
            return np.zeros_like(e)
        left, right = np.vstack([snap[:1], snap]), np.vstack([snap, snap[-1:]])
        most = self.plant.limits.acceleration / TIME_SCALE**2
        return np.asarray(h * h / 12 * np.minimum(2 * np.minimum(left, right), most))

    @cached_property
    def hermite_places(self) -> tuple[Array, Array, Array, Array]:
        """Times (m,) at the INNER places of every interval and the Hermite's q, qd, qdd (m, k) there, in order."""
        assert self.qd is not None
        h, u = np.diff(self.t)[:, None, None], np.array(INNER)[:, None]
        q_0, way = self.q[:-1, None], np.diff(self.q, axis=0)[:, None]
        v_0, v_1 = self.qd[:-1, None], self.qd[1:, None]
        q = q_0 + u * u * (3 - 2 * u) * way + h * u * (1 - u) * ((1 - u) * v_0 - u * v_1)
        qd = 6 * u * (1 - u) * way / h + (1 - u) * (1 - 3 * u) * v_0 + u * (3 * u - 2) * v_1
        qdd = ((6 - 12 * u) * way / h + (6 * u - 4) * v_0 + (6 * u - 2) * v_1) / h
        times, k = self.t[:-1, None] + np.array(INNER) * h[:, 0], len(self.trajectory.names)
        return times.ravel(), q.reshape(-1, k), qd.reshape(-1, k), qdd.reshape(-1, k)

    @cached_property
    def inner_doubt(self) -> Array:
        """Doubt about axis positions between rows (n-1, k): that of a row, and what doubts about speeds (4/27 h each)
        and about the interval's length add to a Hermite."""
        assert self.qd is not None
        h, v = np.diff(self.t)[:, None], np.abs(self.qd)
        out = self.doubt_q / 2 + 8 / 27 * (h * self.doubt_v / 2 + np.maximum(v[1:], v[:-1]) * self.doubt_t)
        return np.asarray(out)

    @cached_property
    def blocks(self) -> Blocks:
        """The rows in blocks."""
        return Blocks(len(self.t))

    @cached_property
    def arm_boxes(self) -> Boxes:
        """Around the arm's joints in each block, with what is granted at a stop."""
        tau = self.blocks.most(self.open_time)
        granted = JOINT_TARGET + (self.doubt_q / 2 + self.plant.limits.acceleration * tau[:, None] ** 2 / 2)[:, -6:]
        tight = self.blocks.boxes(self.q[:, -6:], np.zeros(len(tau)))
        return Boxes(tight.low - (granted + ROUNDING), tight.high + (granted + ROUNDING), tight.room)

    @cached_property
    def hermite_motion(self) -> tuple[Array, Array, Array]:
        """Flange poses (m, 4, 4), velocities and accelerations (m, 6) at hermite_places."""
        return self.mechanism.flange_motion(*self.hermite_places[1:])


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
        return np.asarray(np.linalg.norm(beside, axis=1))

    def near(self, P: Array, size: float = 0.0) -> NDArray[np.intp]:
        """The boxes that a point P (d,) is within size and their room of, in order."""
        found = np.arange(len(self.low))
        if len(found) > BLOCK:
            found = Blocks(len(found)).rows(self._around.near(P, size))
        return found[self.off(P, found) <= size + self.room[found]]


def look(plant: Machine, trajectory: Trajectory, resolution: Resolution | None, marks: int = 1) -> Rows:
    """Rows as the judge uses them; resolution None: every digit is there. marks: how many a marked file has at least,
    one for every move."""
    eps = float(np.finfo(np.float64).eps)
    t = trajectory.t
    k = len(trajectory.names)
    r = resolution or Resolution(0.0, np.zeros(k), np.zeros(k))
    gaps = np.diff(t)
    still = _standstill(trajectory)
    gaps[still] = np.minimum(gaps, np.median(gaps[~still]) if not still.all() else 0.0)[still]
    marked = _marked(gaps, r.t, marks)
    return Rows(
        plant=plant,
        trajectory=trajectory,
        doubt_t=max(r.t, 4 * eps * float(np.abs(t).max())),
        doubt_q=np.maximum(r.q, COMPUTED),
        doubt_v=np.maximum(r.qd, COMPUTED),
        marked=marked,
        gaps=gaps,
        open_time=np.zeros(len(t)) if marked else both_sides(gaps[:, None])[:, 0] / 2,
    )


def _standstill(trajectory: Trajectory) -> NDArray[np.bool_]:
    """Between which rows (n-1,) nothing moves, as both say: without speeds none of them says so."""
    if trajectory.qd is None:
        return np.zeros(len(trajectory.t) - 1, dtype=bool)
    speed = np.abs(trajectory.qd).max(axis=1)
    way = np.maximum(speed[1:], speed[:-1]) * np.diff(trajectory.t)
    return np.asarray((way <= COMPUTED) & (np.abs(np.diff(trajectory.q, axis=0)).max(axis=1) <= COMPUTED))


def unseen(rows: Rows, row: int) -> float:
    """How much longer than its rows a rest may be, s: nearly a gap at both ends. 0 where boundaries have rows."""
    return 4 * float(rows.open_time[row])


def shortest(h: Array, doubt_t: float) -> Array:
    """The least that intervals printed as h can last, s."""
    return np.asarray(np.maximum(h - doubt_t, COMPUTED))


def both_sides(between: Array) -> Array:
    """Per row the larger of the two values between rows beside it: (n-1, ...) -> (n, ...)."""
    return np.asarray(np.maximum(np.concatenate([between[:1], between]), np.concatenate([between, between[-1:]])))


def lagged(n: int) -> Iterator[tuple[int, slice, slice, slice]]:
    """Lags m with the slices of rows i, i + m and i + 2m (for i as far as i + 2m exists)."""
    for m in LAGS:
        if 2 * m < n:
            yield m, slice(0, n - 2 * m), slice(m, n - m), slice(2 * m, n)


def second_differences(t: Array, x: Array, half: Array, doubt_t: float) -> Iterator[tuple[int, Array, Array]]:
    """Per lag m: twice the second divided difference of rows i, i + m, i + 2m and the doubt about it, (n-2m, k).

    x (n, k); half: how far x may be off at each row, broadcast to (n, k).
    """
    half = np.broadcast_to(half, x.shape)
    for m, a, b, c in lagged(len(t)):
        h1, h2 = (t[b] - t[a])[:, None], (t[c] - t[b])[:, None]
        c1, c2 = (x[b] - x[a]) / h1, (x[c] - x[b]) / h2
        doubt = (half[a] + half[b] + np.abs(c1) * doubt_t) / shortest(h1, doubt_t)
        doubt = doubt + (half[b] + half[c] + np.abs(c2) * doubt_t) / shortest(h2, doubt_t)
        yield m, 2 * (c2 - c1) / (h1 + h2), 2 * doubt / shortest(h1 + h2, doubt_t)


def _marked(gaps: Array, doubt_t: float, marks: int) -> bool:
    """A grid with extra rows in it: many gaps of one length, others shorter, none longer.

    The first and the last gap do not count: a grid may begin and end anywhere. Rows may be shifted by 1e-5 s, the
    shortest interval of our files.
    """
    inner = gaps[1:-1]
    if not len(inner):
        return False
    grid = float(np.median(inner))
    short = inner < grid - 2 * doubt_t - 1e-9 * grid
    longer = inner > grid + 2e-5 + 2 * doubt_t
    return bool(np.mean(~short) >= 0.4 and np.sum(short) >= max(marks, 1) and not longer.any())
