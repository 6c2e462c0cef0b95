"""Where the rows of a sequence reach the stops of a task, and how they came there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.chain import Followed, follow
from trajopt_cli.iiwa.judge.path import StraightPiece, rotation_of
from trajopt_cli.iiwa.judge.samples import Poses
from trajopt_cli.iiwa.judge.task_order import Order, Stop, periods
from trajopt_cli.iiwa.judge.tolerances import EXACT, PATH

_WINDOW = 2048  # rows that are looked at first


@dataclass(frozen=True, eq=False)
class Visit:
    """When a stop is reached: rows arrived..left, distance [m, rad] at the row arrived, what of it is allowed, periods
    it should stand. legs: the way there, without repeated poses; passed: how the rows followed it where it passes poses
    without a stop."""

    stop: Stop
    arrived: int
    left: int
    off: float
    allowed: float
    dwell: int
    legs: list[StraightPiece]
    passed: Followed | None = None

    @property
    def reached(self) -> bool:
        """Whether the rows come there at all."""
        return self.off <= self.allowed and (self.passed is None or self.passed.lost is None)


def visits(order: Order, way: list[StraightPiece], rows: Poses) -> Iterator[Visit]:
    """The stops in order, as far as the rows reach them; of repeated poses the last one, with the dwells of all.

    Ends with the first one that is not reached.
    """
    assert order.stops is not None
    row, dwell, before, last = 0, 0, 0, len(order.stops) - 1
    for i, stop in enumerate(order.stops):
        dwell += periods(stop.dwell, order.h)
        if order.passing is None and i < last and way[i].L_p == way[i].L_q == 0:
            continue
        if order.passing is not None and 0 < i < last and not (stop.rests or stop.dwell > 0):
            continue
        legs = [leg for leg in way[before:i] if leg.L_p > 0 or leg.L_q > 0]
        q = rotation_of(order, stop)
        passed = None
        if order.passing is not None and legs:
            off, allowed = _off(stop, q, rows, row, len(rows.t))
            passed = follow(legs, rows, row, *order.passing, off - allowed)
            found = passed.last - row
        else:
            off, allowed, found = _first_there(stop, q, rows, row, wait=bool(legs))
        left = row + found
        while left + 1 < len(rows.t) and _off(stop, q, rows, left + 1, left + 2)[0][0] <= off[found] + EXACT:
            left += 1
        one = Visit(stop, row + found, left, float(off[found]), float(allowed[found]), dwell, legs, passed)
        yield one
        if not one.reached:
            return
        row, dwell, before = left, 0, i


def _off(stop: Stop, q: Array, rows: Poses, first: int, end: int) -> tuple[Array, Array]:
    """How far rows first to end - 1 are from a stop with orientation q, m plus rad, and what is allowed."""
    part = slice(first, end)
    off = np.linalg.norm(rows.p[part] - stop.pose[:3], axis=1) + turns.angle_between(rows.q[part], q)
    return off, PATH + (rows.off_p + rows.off_q + rows.open)[part]


def _first_there(stop: Stop, q: Array, rows: Poses, row: int, wait: bool) -> tuple[Array, Array, int]:
    """As _off from a row on, and which of these rows is the first that is there, nearest of its neighbours; row itself
    without wait. Windows grow until there is one: a sequence may have thousands of stops."""
    size = _WINDOW
    while True:
        end = min(row + size, len(rows.t))
        off, allowed = _off(stop, q, rows, row, end)
        near = np.flatnonzero(off <= allowed)
        found = 0 if not wait else int(near[0]) if near.size else int(np.argmin(off - allowed))
        while wait and near.size and found + 1 < len(off) and off[found + 1] < off[found]:
            found += 1
        if end == len(rows.t) or not wait or (near.size and found + 1 < len(off)):
            return off, allowed, found
        size *= 4
